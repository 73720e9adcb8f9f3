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
        Body, Caption, Cell, Mark3, Role, Shape3, Table, TableRow, Tick, View, Watch, WatchRow,
        WatchSection,
    },
    geom::{VolumeSide, planes_from_matrix},
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Message},
};

use super::{
    super::{
        OnScene, OnSceneInput, Scene,
        method_info::FrustumDemo,
        stage::{Fate, Scenery, plane_at_work},
    },
    planes::{distance_formula, gauges, perpendicular, place, plane_link, plane_name, triple},
};

type Input = OnSceneInput<PointPlanesInput>;
type Shown = OnScene<PointPlanes>;

const GAUGES_VIEW: &str = "distances";
const PLANES_VIEW: &str = "planes";

impl Answer for PointPlanesOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl FrustumDemo for Shown {
    const ASKS_POINT: bool = true;

    fn input(scene: &Scene) -> Input {
        let own = PointPlanesInput {
            planes: scene.camera.camera().planes_in_world().to_vec(),
            point: scene.point(),
        };
        OnSceneInput::of(scene, own)
    }
}

impl Demo for Shown {
    const ID: &'static str = "point-planes";
    const NAME_KEY: &'static str = "alg-point-planes";
    const SOURCE: &'static str = "Sutherland & Hodgman, 1974";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-point-each", "words-point-each"),
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
        let known: Vec<(f64, Role)> = step
            .state
            .asked
            .iter()
            .enumerate()
            .map(|(i, &(d, side))| (d, role(side, current(step) == Some(i))))
            .collect();
        let title = Message::new("gauges-point");
        let n_planes = step.input.own.planes.len();
        let distances = gauges(title, scenery, n_planes, None, &known);
        let mut views = Vec::new();
        if let Some(scenery) = scenery {
            views.push(scenery.observer(|_| Fate::ToCome, marks(step, scenery)));
            views.push(scenery.camera(|_| Fate::ToCome, |_, _| None, vec![dot(step)]));
        }
        views.push(View::new(GAUGES_VIEW, Body::Gauges(distances)));
        if let Some(scenery) = scenery {
            let table = plane_table(scenery, current(step));
            views.push(View::new(PLANES_VIEW, Body::Table(table)));
        }
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let mut rows = vec![WatchRow::new(name("P"), Some(place(step.input.own.point)))];
        if let Some(plane) = current(step).and_then(|i| step.input.own.planes.get(i)) {
            rows.push(WatchRow::new(name("n"), Some(place(plane.normal()))));
            rows.push(WatchRow::new(name("D"), Some(plane.d().into())));
        }
        let distances = step.state.asked.iter().enumerate().map(|(i, &(d, _))| {
            let name = plane_name(step.input.scenery.as_deref(), i);
            WatchRow::new(name, Some(d.into())).linked(plane_link(i))
        });
        vec![
            WatchSection::list(rows),
            WatchSection::list(distances.collect()).seen_in(GAUGES_VIEW),
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
        marks.extend(plane_at_work(scenery.scene().camera.camera(), side));
        let plane = &step.input.own.planes[plane_idx];
        let label = Formula::default().sym("d").equals(d);
        marks.extend(perpendicular(plane, step.input.own.point, d, label));
    }
    marks
}

/// The planes as the angles give them, and as the rows of the matrix do: the same.
fn plane_table(scenery: &Scenery, current: Option<usize>) -> Table {
    let camera = scenery.scene().camera.camera();
    let from_matrix = planes_from_matrix(&camera.clip_from_world()).ok();
    let symbols = ["n_x", "n_y", "n_z", "D"].map(|name| Formula::default().sym(name));
    let mut header = vec![Formula::default().term("column-plane")];
    header.extend(symbols);
    let row = |plane_idx: usize| {
        let is_current = current == Some(plane_idx);
        let role = if is_current { Role::Signal } else { Role::Ink };
        let [x, y, z, d] = scenery.planes()[plane_idx].to_array();
        let cells = [x, y, z, d].map(|value| Cell::new(role, Some(value)));
        TableRow {
            name: plane_name(Some(scenery), plane_idx),
            cells: cells.to_vec(),
            is_current,
            link: Some(plane_link(plane_idx)),
        }
    };
    let apart = from_matrix.map(|planes| {
        let apart = planes.iter().zip(scenery.planes()).flat_map(|(a, b)| {
            let unit = a.to_array().map(|x| x / a.length());
            let both = unit.into_iter().zip(b.to_array());
            both.map(|(a, b)| (a - b).abs()).collect::<Vec<f64>>()
        });
        apart.fold(0.0, f64::max)
    });
    Table {
        header,
        rows: (0..6).map(row).collect(),
        notes: apart
            .map(|apart| crate::figure::TableNote {
                text: Message::new("planes-from-matrix").with("apart", apart),
                applies: true,
            })
            .into_iter()
            .collect(),
    }
}
