//! A bounding sphere against the planes of the view volume, shown.

use glam::DVec3;
use serde_json::{Value as Json, json};

use crate::{
    algo::cull::{
        Containment, SphereCull, SphereCullEvent as Event, SphereCullInput, SphereCullOutput,
        SphereCullState as State,
    },
    figure::{Body, Caption, Mark3, Role, Shape3, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Camera, Plane, Sphere, VolumeSide},
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Message, Value},
};

use super::{
    super::{
        OnScene, OnSceneInput, Scene,
        demo::SpaceDemo,
        stage::{FaceLook, Fate, Scenery, plane_at_work},
    },
    planes::{
        distance_formula, fate_of, gauges, perpendicular, place, plane_link, plane_name,
        plane_rows, role_of, triple,
    },
};

type Input = OnSceneInput<SphereCullInput>;
type Shown = OnScene<SphereCull>;

const GAUGES_VIEW: &str = "distances";

impl Answer for SphereCullOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl SpaceDemo for Shown {
    fn input(scene: &Scene) -> Input {
        let own = SphereCullInput {
            planes: scene.culler().planes_in_world().to_vec(),
            sphere: scene.focused().in_funnel().sphere,
        };
        OnSceneInput::of(scene, own)
    }
}

impl Demo for Shown {
    const ID: &'static str = "sphere-cull";
    const NAME_KEY: &'static str = "alg-sphere-cull";
    const SOURCE: &'static str = "Clark, 1976";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-plane-each", "words-plane-each"),
        code_line(1, "code-sphere-distance", "words-sphere-distance"),
        code_line(1, "code-sphere-outside", "words-sphere-outside"),
        code_line(1, "code-sphere-straddles", "words-sphere-straddles"),
        code_line(0, "code-sphere-done", "words-sphere-done"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Plane { class, .. } => plane_tick(*class),
            Event::Done { class } => class_tick(*class),
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Plane { class, .. } => match class {
                Containment::Inside => 1,
                Containment::Outside => 2,
                Containment::Straddles => 3,
            },
            Event::Done { .. } => 4,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        match *event {
            Event::Plane {
                plane_idx,
                distance,
                class,
            } => {
                let plane = plane_name(input.scenery.as_deref(), plane_idx);
                let caption = Caption::new(Message::new(plane_key(class)).with("plane", plane));
                let Input { own, .. } = input;
                let Some(plane) = own.planes.get(plane_idx) else {
                    return caption;
                };
                caption.so(sphere_formula(plane, &own.sphere, distance, class))
            }
            Event::Done { class } => {
                let n_cut = before.asked.iter();
                let n_cut = n_cut.filter(|(_, class)| *class == Containment::Straddles);
                let last = before.asked.len().saturating_sub(1);
                let message = Message::new(match class {
                    Containment::Inside => "sphere-done-inside",
                    Containment::Straddles => "sphere-done-straddles",
                    Containment::Outside => "planes-done-outside",
                });
                let message = message
                    .with("planes", before.asked.len())
                    .with("cut", n_cut.count())
                    .with("plane", plane_name(input.scenery.as_deref(), last));
                Caption::new(message).so(Formula::default()
                    .sym("r")
                    .equals(input.own.sphere.radius()))
            }
        }
    }

    fn opening(input: &Input) -> Caption {
        let planes = input.own.planes.len();
        Caption::new(Message::new("sphere-opening").with("planes", planes))
            .so(triple("c", input.own.sphere.center()))
            .so(Formula::default()
                .sym("r")
                .equals(input.own.sphere.radius()))
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let scenery = step.input.scenery.as_deref();
        let sphere = &step.input.own.sphere;
        let mut views = Vec::new();
        if let Some(scenery) = scenery {
            let focus = scenery.scene().focus();
            let class = step.state.class;
            let fate = |i: usize| {
                if i == focus {
                    fate_of(class)
                } else {
                    Fate::ToCome
                }
            };
            let asked = current(step).zip(step.state.asked.last());
            let asked = asked.map(|(plane_idx, &(distance, _))| Asked {
                camera: *scenery.scene().culler(),
                plane_idx,
                distance,
            });
            views.push(scenery.observer(fate, sphere_marks(sphere, asked.as_ref())));
            views.push(scenery.camera(fate, |_, _| FaceLook::Whole, Vec::new()));
        }
        let distances = sphere_gauges(
            scenery,
            step.input.own.planes.len(),
            sphere.radius(),
            &step.state.asked,
            current(step),
        );
        views.push(View::new(GAUGES_VIEW, Body::Gauges(distances)));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let Input { own, scenery } = step.input;
        let plane = current(step).and_then(|i| own.planes.get(i));
        let mut rows = sphere_rows(&own.sphere, plane);
        rows.extend(step.state.class.map(class_row));
        let distances = step.state.asked.iter().enumerate().map(|(i, &(d, _))| {
            let name = plane_name(scenery.as_deref(), i);
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

/// What one plane says.
pub const fn plane_key(class: Containment) -> &'static str {
    match class {
        Containment::Inside => "sphere-inside",
        Containment::Straddles => "sphere-straddles",
        Containment::Outside => "sphere-outside",
    }
}

pub const fn plane_tick(class: Containment) -> Tick {
    match class {
        Containment::Inside => Tick::Test,
        Containment::Straddles | Containment::Outside => Tick::Cut,
    }
}

pub const fn class_tick(class: Containment) -> Tick {
    match class {
        Containment::Inside | Containment::Straddles => Tick::Accept,
        Containment::Outside => Tick::Reject,
    }
}

/// Catalogue key of a class.
pub const fn class_key(class: Containment) -> &'static str {
    match class {
        Containment::Inside => "class-inside",
        Containment::Straddles => "class-straddles",
        Containment::Outside => "class-outside",
    }
}

pub fn class_row(class: Containment) -> WatchRow {
    let word = Value::Term(class_key(class));
    WatchRow::new(Value::Term("watch-class"), Some(word))
}

/// `d = n·c + D = … = −3.4 < −r = −1.01`.
pub fn sphere_formula(plane: &Plane, sphere: &Sphere, d: f64, class: Containment) -> Formula {
    let formula = distance_formula(["d", "c"], plane, sphere.center(), d);
    let r = sphere.radius();
    match class {
        Containment::Outside => formula.sym(" < −r").equals(-r),
        Containment::Straddles => formula.sym(",  −r ≤ d < r").equals(r),
        Containment::Inside => formula.sym(" ≥ r").equals(r),
    }
}

/// A plane that is asked at a step.
pub struct Asked {
    /// Whose it is.
    pub camera: Camera,
    /// Which of its six.
    pub plane_idx: usize,
    /// Of the centre from it.
    pub distance: f64,
}

/// The sphere in hand, and the plane that is asked of it: its perpendicular in ink as far as the sphere reaches.
pub fn sphere_marks(sphere: &Sphere, asked: Option<&Asked>) -> Vec<Mark3> {
    let center = sphere.center();
    let mut marks = vec![
        Mark3::new(Role::Ink, Shape3::Ball(center, sphere.radius())),
        Mark3::new(Role::Ink, Shape3::Dot(center)).labelled(name("c")),
    ];
    let Some(asked) = asked else {
        return marks;
    };
    let plane = &asked.camera.planes_in_world()[asked.plane_idx];
    let side = VolumeSide::ALL[asked.plane_idx];
    marks.extend(plane_at_work(&asked.camera, side));
    let d = asked.distance;
    let label = Formula::default().sym("d").equals(d);
    marks.extend(perpendicular(plane, center, d, label));
    let unit = DVec3::from(plane.unit_normal());
    let towards = DVec3::from(center) - unit * sphere.radius() * d.signum();
    let radius = Formula::default().sym("r").equals(sphere.radius());
    marks.push(
        Mark3::new(Role::Ink, Shape3::Segment([center, towards.into()]))
            .labelled(Value::Formula(radius)),
    );
    marks
}

/// Axes for the distances from all planes, with the band that the sphere fills.
pub fn sphere_gauges(
    scenery: Option<&Scenery>,
    n_planes: usize,
    radius: f64,
    asked: &[(f64, Containment)],
    current: Option<usize>,
) -> crate::figure::Gauges {
    let known: Vec<(f64, Role)> = asked
        .iter()
        .enumerate()
        .map(|(i, &(d, class))| (d, role_of(class, current == Some(i))))
        .collect();
    let title = Message::new("gauges-sphere").with("planes", n_planes);
    gauges(title, scenery, n_planes, Some(radius), &known)
}

/// c, r, and of the plane that is asked n and D.
pub fn sphere_rows(sphere: &Sphere, plane: Option<&Plane>) -> Vec<WatchRow> {
    let mut rows = vec![
        WatchRow::new(name("c"), Some(place(sphere.center()))),
        WatchRow::new(name("r"), Some(sphere.radius().into())),
    ];
    rows.extend(plane.into_iter().flat_map(plane_rows));
    rows
}
