//! A point against the planes of the view volume, shown.

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        cull::{
            PointPlanes, PointPlanesEvent as Event, PointPlanesInput, PointPlanesOutput,
            PointPlanesState as State,
        },
        volume::PlaneSide,
    },
    figure::{
        Body, Caption, Cell, Mark3, Role, Shape3, Table, TableNote, TableRow, Tick, View, Watch,
        WatchRow, WatchSection,
    },
    geom::{Plane, VolumeSide, planes_from_matrix},
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Message, Value},
};

use super::{
    super::{
        OnScene, OnSceneInput, Scene, Subject,
        demo::SpaceDemo,
        stage::{FaceLook, Fate, Scenery, plane_at_work},
    },
    planes::{distance_formula, perpendicular, place, plane_link, plane_name, plane_rows, triple},
};

type Input = OnSceneInput<PointPlanesInput>;
type Shown = OnScene<PointPlanes>;

const PLANES_VIEW: &str = "planes";

impl Answer for PointPlanesOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Point;

    fn input(scene: &Scene) -> Input {
        let own = PointPlanesInput {
            planes: scene.culler().planes_in_world().to_vec(),
            point: scene.places.point(),
        };
        OnSceneInput::of(scene, own)
    }
}

impl Demo for Shown {
    const ID: &'static str = "point-planes";
    const NAME_KEY: &'static str = "alg-point-planes";
    const SOURCE: &'static str = "Sutherland & Hodgman, 1974";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-plane-each", "words-plane-each"),
        code_line(1, "code-point-distance", "words-point-distance"),
        code_line(1, "code-point-outside", "words-point-outside"),
        code_line(0, "code-point-inside", "words-point-inside"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Plane {
                side: PlaneSide::Outside,
                ..
            } => Tick::Cut,
            Event::Plane { .. } => Tick::Test,
            Event::Done { inside: true } => Tick::Accept,
            Event::Done { inside: false } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Plane {
                side: PlaneSide::Outside,
                ..
            } => 2,
            Event::Plane { .. } => 1,
            Event::Done { .. } => 3,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        match *event {
            Event::Plane {
                plane_idx,
                distance,
                side,
            } => {
                let (key, relation) = match side {
                    PlaneSide::Inside => ("point-inside", " > 0"),
                    PlaneSide::On => ("point-on", ""),
                    PlaneSide::Outside => ("point-outside", " < 0"),
                };
                let plane = plane_name(input.scenery.as_deref(), plane_idx);
                let caption = Caption::new(Message::new(key).with("plane", plane));
                let own = &input.own;
                let Some(plane) = own.planes.get(plane_idx) else {
                    return caption;
                };
                caption.so(distance_formula(["d", "P"], plane, own.point, distance).sym(relation))
            }
            Event::Done { inside } => {
                let asked = before.asked.iter();
                let n_outside = asked
                    .filter(|(_, side)| *side == PlaneSide::Outside)
                    .count();
                let key = if inside {
                    "point-done-inside"
                } else {
                    "point-done-outside"
                };
                let message = Message::new(key)
                    .with("planes", before.asked.len())
                    .with("outside", n_outside);
                Caption::new(message).so(triple("P", input.own.point))
            }
        }
    }

    fn opening(input: &Input) -> Caption {
        let planes = input.own.planes.len();
        Caption::new(Message::new("point-opening").with("planes", planes))
            .so(triple("P", input.own.point))
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let scenery = step.input.scenery.as_deref();
        let mut views = Vec::new();
        if let Some(scenery) = scenery {
            views.push(scenery.observer(|_| Fate::ToCome, marks(step, scenery)));
            views.push(scenery.camera(|_| Fate::ToCome, |_, _| FaceLook::Whole, vec![dot(step)]));
        }
        views.push(View::new(PLANES_VIEW, Body::Table(plane_table(step))));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let mut rows = vec![WatchRow::new(name("P"), Some(place(step.input.own.point)))];
        let plane = current(step).and_then(|i| step.input.own.planes.get(i));
        rows.extend(plane.into_iter().flat_map(plane_rows));
        let distances = step.state.asked.iter().enumerate().map(|(i, &(d, _))| {
            let name = plane_name(step.input.scenery.as_deref(), i);
            WatchRow::new(name, Some(d.into())).linked(plane_link(i))
        });
        vec![
            WatchSection::list(rows),
            WatchSection::list(distances.collect()).seen_in(PLANES_VIEW),
        ]
    }
}

fn current(step: &Step<'_, Shown>) -> Option<usize> {
    match step.event {
        Some(Event::Plane { plane_idx, .. }) => Some(plane_idx),
        Some(Event::Done { .. }) | None => None,
    }
}

const fn role(side: PlaneSide, is_current: bool) -> Role {
    match side {
        _ if is_current => Role::Signal,
        PlaneSide::Inside | PlaneSide::On => Role::Accent,
        PlaneSide::Outside => Role::Discarded,
    }
}

/// The point, as far as it is decided.
fn dot(step: &Step<'_, Shown>) -> Mark3 {
    let role = match step.state.inside {
        None => Role::Ink,
        Some(true) => Role::Accepted,
        Some(false) => Role::Discarded,
    };
    Mark3::new(role, Shape3::Dot(step.input.own.point)).labelled(name("P"))
}

fn marks(step: &Step<'_, Shown>, scenery: &Scenery) -> Vec<Mark3> {
    let mut marks = vec![dot(step)];
    if let Some(plane_idx) = current(step)
        && let Some(&(d, _)) = step.state.asked.get(plane_idx)
    {
        let side = VolumeSide::ALL[plane_idx];
        marks.extend(plane_at_work(scenery.scene().culler(), side));
        let plane = &step.input.own.planes[plane_idx];
        let label = Formula::default().sym("d").equals(d);
        marks.extend(perpendicular(plane, step.input.own.point, d, label));
    }
    marks
}

/// The planes, and how far the point is from each that has been asked.
fn plane_table(step: &Step<'_, Shown>) -> Table {
    let scenery = step.input.scenery.as_deref();
    let symbols = ["n_x", "n_y", "n_z", "D", "d"].map(|name| Formula::default().sym(name));
    let mut header = vec![Formula::default().term("column-plane")];
    header.extend(symbols);
    let current = current(step);
    let row = |(plane_idx, plane): (usize, &Plane)| {
        let is_current = current == Some(plane_idx);
        let known = step.state.asked.get(plane_idx);
        let given = plane
            .to_array()
            .map(|value| Cell::new(Role::Ink, Some(value)));
        let distance = match known {
            Some(&(d, side)) => Cell::new(role(side, is_current), Some(d)).strong(),
            None => Cell::new(Role::Ink, None::<Value>),
        };
        TableRow {
            name: plane_name(scenery, plane_idx),
            cells: given.into_iter().chain([distance]).collect(),
            is_current,
            link: Some(plane_link(plane_idx)),
        }
    };
    let text = scenery.and_then(|scenery| from_matrix(scenery, current));
    let note = text.map(|text| TableNote {
        text,
        applies: true,
    });
    Table {
        header,
        rows: step.input.own.planes.iter().enumerate().map(row).collect(),
        notes: note.into_iter().collect(),
    }
}

/// What the rows of the matrix say of the plane at work, and to how many decimals they agree with what the angles give.
fn from_matrix(scenery: &Scenery, current: Option<usize>) -> Option<Message> {
    let camera = scenery.scene().culler();
    let from_matrix = planes_from_matrix(&camera.clip_from_world()).ok()?;
    let apart = from_matrix.iter().zip(scenery.planes()).map(|(a, b)| {
        let both = a.to_array().into_iter().zip(b.to_array());
        let apart = both.map(|(x, y)| (x / a.length() - y).abs());
        apart.fold(0.0, f64::max)
    });
    let apart = apart.fold(f64::EPSILON, f64::max);
    let decimals = (-libm::log10(apart)).floor().max(0.0) as usize;
    let Some(plane_idx) = current else {
        return Some(Message::new("planes-from-matrix").with("decimals", decimals));
    };
    let (plane, side) = (&from_matrix[plane_idx], VolumeSide::ALL[plane_idx]);
    let sign = if side.is_high() { '−' } else { '+' };
    let row = ["x", "y", "z"][side.axis()];
    let sum = Formula::default().sym(format!("w {sign} {row} = ("));
    let message = Message::new("plane-from-matrix")
        .with("sum", Value::Formula(sum.list(&plane.to_array()).sym(")")))
        .with("length", plane.length())
        .with("plane", plane_name(Some(scenery), plane_idx));
    Some(message.with("decimals", decimals))
}
