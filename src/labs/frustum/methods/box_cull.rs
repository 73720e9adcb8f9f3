//! A bounding box against the planes of the view volume, and what they cannot tell, shown.

use serde_json::{Value as Json, json};

use crate::{
    algo::cull::{
        BoxCull, BoxCullEvent as Event, BoxCullInput, BoxCullOutput, BoxCullState as State,
        Containment,
    },
    figure::{
        Body, Caption, Cell, Mark3, Role, Shape3, Table, TableRow, Tick, View, Watch, WatchRow,
        WatchSection,
    },
    geom::VolumeSide,
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Message},
};

use super::{
    super::{
        OnScene, OnSceneInput, Scene,
        demo::SpaceDemo,
        stage::{FaceLook, Fate, plane_at_work},
    },
    planes::{fate_of, place, plane_link, plane_name, role_of},
    sphere_cull::{class_row, class_tick, plane_tick},
};

type Input = OnSceneInput<BoxCullInput>;
type Shown = OnScene<BoxCull>;

const CORNERS_VIEW: &str = "corners";

impl Answer for BoxCullOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl SpaceDemo for Shown {
    fn input(scene: &Scene) -> Input {
        let own = BoxCullInput {
            planes: scene.culler().planes_in_world().to_vec(),
            bounds: scene.focused().bounds().expect("its vertices are finite"),
        };
        OnSceneInput::of(scene, own)
    }
}

impl Demo for Shown {
    const ID: &'static str = "box-cull";
    const NAME_KEY: &'static str = "alg-box-cull";
    const SOURCE: &'static str = "Assarsson & Möller, 2000";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-plane-each", "words-plane-each"),
        code_line(1, "code-box-corners", "words-box-corners"),
        code_line(1, "code-box-outside", "words-box-outside"),
        code_line(0, "code-box-meets", "words-box-meets"),
        code_line(0, "code-box-done", "words-box-done"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Plane { class, .. } => plane_tick(*class),
            Event::Meets { .. } => Tick::Phase,
            Event::Done { class } => class_tick(*class),
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Plane {
                class: Containment::Outside,
                ..
            } => 2,
            Event::Plane { .. } => 1,
            Event::Meets { .. } => 3,
            Event::Done { .. } => 4,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        match *event {
            Event::Plane {
                plane_idx,
                sums,
                n_outside,
                class,
            } => {
                let key = match class {
                    Containment::Inside => "box-inside",
                    Containment::Straddles => "box-straddles",
                    Containment::Outside => "box-outside",
                };
                let message = Message::new(key)
                    .with("plane", plane_name(input.scenery.as_deref(), plane_idx))
                    .with("outside", n_outside);
                Caption::new(message).so(range_formula(&sums))
            }
            Event::Meets { meets } => {
                let key = if meets { "box-meets" } else { "box-in-vain" };
                let n_cut = before.asked.iter();
                let n_cut = n_cut.filter(|(_, class)| *class == Containment::Straddles);
                Caption::new(Message::new(key).with("cut", n_cut.count()))
            }
            Event::Done { class } => {
                let last = before.asked.len().saturating_sub(1);
                let key = match (class, before.meets) {
                    (Containment::Inside, _) => "box-done-inside",
                    (Containment::Outside, _) => "planes-done-outside",
                    (Containment::Straddles, Some(false)) => "box-done-in-vain",
                    (Containment::Straddles, _) => "box-done-straddles",
                };
                let message = Message::new(key)
                    .with("planes", before.asked.len())
                    .with("plane", plane_name(input.scenery.as_deref(), last));
                Caption::new(message)
            }
        }
    }

    fn opening(input: &Input) -> Caption {
        let planes = input.own.planes.len();
        let corner = |symbol, at| super::planes::triple(symbol, at);
        Caption::new(Message::new("box-opening").with("planes", planes))
            .so(corner("min", input.own.bounds.min()))
            .so(corner("max", input.own.bounds.max()))
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let scenery = step.input.scenery.as_deref();
        let mut views = Vec::new();
        if let Some(scenery) = scenery {
            let focus = scenery.scene().focus();
            let in_vain = step.state.meets == Some(false);
            let class = step.state.class.filter(|_| !in_vain);
            let fate = |i: usize| {
                if i != focus {
                    Fate::ToCome
                } else if in_vain {
                    Fate::Culled
                } else {
                    fate_of(class)
                }
            };
            let camera = scenery.scene().culler();
            let mut marks = box_marks(step);
            if let Some(plane_idx) = current(step) {
                marks.extend(plane_at_work(camera, VolumeSide::ALL[plane_idx]));
            }
            views.push(scenery.observer(fate, marks));
            views.push(scenery.camera(fate, |_, _| FaceLook::Whole, Vec::new()));
        }
        views.push(View::new(CORNERS_VIEW, Body::Table(corner_table(step))));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let bounds = &step.input.own.bounds;
        let mut rows = vec![
            WatchRow::new(name("min"), Some(place(bounds.min()))),
            WatchRow::new(name("max"), Some(place(bounds.max()))),
        ];
        rows.extend(step.state.class.map(class_row));
        let outside = step.state.asked.iter().enumerate().map(|(i, (sums, _))| {
            let n = sums.iter().filter(|&&sum| sum < 0.0).count();
            let name = plane_name(step.input.scenery.as_deref(), i);
            WatchRow::new(name, Some(n.into())).linked(plane_link(i))
        });
        vec![
            WatchSection::list(rows),
            WatchSection::list(outside.collect()).seen_in(CORNERS_VIEW),
        ]
    }
}

fn current(step: &Step<'_, Shown>) -> Option<usize> {
    match step.event {
        Some(Event::Plane { plane_idx, .. }) => Some(plane_idx),
        Some(Event::Meets { .. } | Event::Done { .. }) | None => None,
    }
}

/// Least and greatest of the eight sums.
fn range(sums: &[f64; 8]) -> [f64; 2] {
    let least = sums.iter().copied().fold(f64::INFINITY, f64::min);
    let most = sums.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    [least, most]
}

fn range_formula(sums: &[f64; 8]) -> Formula {
    let [least, most] = range(sums);
    Formula::default().num(least).sym(" ≤ n·p + D ≤ ").num(most)
}

/// The box, and its corners by the side of the plane that they are on.
fn box_marks(step: &Step<'_, Shown>) -> Vec<Mark3> {
    let corners = step.input.own.bounds.corners();
    let mut marks: Vec<Mark3> = step
        .input
        .own
        .bounds
        .edges()
        .map(|ends| Mark3::new(Role::Ink, Shape3::Segment(ends)).fine())
        .collect();
    let sums = current(step).and_then(|i| step.state.asked.get(i));
    if let Some((sums, _)) = sums {
        marks.extend(corners.iter().zip(sums).map(|(&corner, &sum)| {
            let (role, shape) = if sum < 0.0 {
                (Role::Signal, Shape3::Ring(corner))
            } else {
                (Role::Accent, Shape3::Dot(corner))
            };
            Mark3::new(role, shape)
        }));
    }
    marks
}

/// For each plane how many corners are outside, and how far in and out they reach.
fn corner_table(step: &Step<'_, Shown>) -> Table {
    let scenery = step.input.scenery.as_deref();
    let header = [
        "column-plane",
        "column-outside",
        "column-least",
        "column-most",
    ];
    let header = header.map(|key| Formula::default().term(key)).to_vec();
    let current = current(step);
    let row = |plane_idx: usize| {
        let asked = step.state.asked.get(plane_idx);
        let is_current = current == Some(plane_idx);
        let role = asked.map_or(Role::Ink, |(_, class)| role_of(*class, is_current));
        let n_outside = asked.map(|(sums, _)| sums.iter().filter(|&&sum| sum < 0.0).count());
        let range = asked.map(|(sums, _)| range(sums));
        TableRow {
            name: plane_name(scenery, plane_idx),
            cells: vec![
                Cell::new(role, n_outside),
                Cell::new(role, range.map(|[least, _]| least)),
                Cell::new(role, range.map(|[_, most]| most)),
            ],
            is_current,
            link: Some(plane_link(plane_idx)),
        }
    };
    let n_planes = step.input.own.planes.len();
    Table {
        header,
        rows: (0..n_planes).map(row).collect(),
        notes: Vec::new(),
    }
}
