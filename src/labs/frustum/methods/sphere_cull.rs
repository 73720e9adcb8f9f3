//! A bounding sphere against the planes of the view volume, shown.

use glam::DVec3;
use serde_json::{Value as Json, json};

use crate::{
    algo::cull::{
        Containment::{self, Inside, Outside, Straddles},
        SphereCull, SphereCullEvent as Event, SphereCullInput, SphereCullOutput,
    },
    figure::{
        Body, Mark3, Role, Shape3,
        Tick::{self, Accept, Cut, Phase, Reject, Test},
        View, WatchRow,
    },
    geom::{Camera, Plane, Sphere, VolumeSide},
    labs::{
        Answer, CodeLine, code_line,
        space::SpaceTelling,
        telling::{At, Named, Row, Telling, Watched, rows},
        words::name,
    },
    text::{Formula, Message, Value},
    trace::told::Step,
};

use super::{
    super::{
        Scene,
        stage::{FaceLook, Fate, Scenery, plane_at_work},
    },
    planes::{
        distance_formula, fate_of, gauges, perpendicular, place, plane_link, plane_name,
        plane_rows, role_of,
    },
};

const GAUGES_VIEW: &str = "distances";

impl Answer for SphereCullOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl SpaceTelling for SphereCull {
    fn input(scene: &Scene) -> SphereCullInput {
        SphereCullInput {
            planes: scene.culler().planes_in_world().to_vec(),
            sphere: scene.focused().in_funnel().sphere,
        }
    }
}

rows! { |event, step: SphereCull|
    inside: Event::Plane { class: Inside, .. } =>
        Row::new(Test, 1, "sphere-inside").so(D).answers("class").keeps("plane");
    outside: Event::Plane { class: Outside, .. } =>
        Row::new(Cut, 2, "sphere-outside").so(D).answers("class").drops("plane");
    straddles: Event::Plane { class: Straddles, .. } =>
        Row::new(Cut, 3, "sphere-straddles").so(D).answers("class").cuts("plane");
    none_out: Event::Done { class: Inside } => Row::new(Accept, 4, "sphere-done-inside").so(R);
    cut: Event::Done { class: Straddles } => Row::new(Accept, 4, "sphere-done-straddles").so(R);
    culled: Event::Done { class: Outside } =>
        Row::new(Reject, 4, "planes-done-outside").so(R).picks("plane", "planes");
}

const D: &[&str] = &["{d = n·c + D}"];
const R: &[&str] = &["r{=r}"];

impl Telling for SphereCull {
    type Scenery = Scenery;

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
    const ROWS: &'static [Row] = ROWS;
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["c", "r", "n", "D", "class"]),
        Watched::ListSeen("distances", GAUGES_VIEW),
    ];

    fn row(step: &Step<'_, Self>) -> &'static Row {
        row(step)
    }

    fn opening(_: &At<'_, Self>) -> &'static Row {
        const OPENING: Row = Row::new(Phase, 0, "sphere-opening").so(&["c = {c}", "r{=r}"]);
        &OPENING
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (input, distances) = (at.step.input, &at.step.held.distances);
        let sphere = &input.sphere;
        let plane = || input.planes.get(current(at)?);
        let last = distances.len().checked_sub(1);
        Some(match name {
            "c" => place(sphere.center()).into(),
            "r" => sphere.radius().into(),
            "n" => place(plane()?.normal()).into(),
            "D" => plane()?.d().into(),
            "plane" => Named::from(plane_name(at.scenery, last?)).linked(plane_link(last?)),
            "planes" if last.is_none() => input.planes.len().into(),
            "planes" => distances.len().into(),
            "cut" => asked(at)
                .filter(|(_, class)| *class == Straddles)
                .count()
                .into(),
            "class" => {
                let class = Value::Term(class_key(at.class()?));
                Named::from(class).labelled(Value::Term("watch-class"))
            }
            "d = n·c + D" => {
                let (d, class) = asked(at).last()?;
                sphere_formula(plane()?, sphere, d, class).into()
            }
            _ => return None,
        })
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        if list == "planes" {
            let planes = 0..at.step.input.planes.len();
            return planes.map(|i| plane_name(at.scenery, i).into()).collect();
        }
        let distances = at.step.held.distances.iter().enumerate();
        let named = |(i, &d): (usize, &f64)| {
            let distance = Named::from(d).labelled(plane_name(at.scenery, i));
            distance.linked(plane_link(i))
        };
        distances.map(named).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let sphere = &at.step.input.sphere;
        let asked: Vec<(f64, Containment)> = asked(at).collect();
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let (focus, class) = (scenery.scene().focus(), at.class());
            let fate = |i: usize| {
                if i == focus {
                    fate_of(class)
                } else {
                    Fate::ToCome
                }
            };
            let now = current(at).zip(asked.last());
            let now = now.map(|(plane_idx, &(distance, _))| Asked {
                camera: *scenery.scene().culler(),
                plane_idx,
                distance,
            });
            views.push(scenery.observer(fate, sphere_marks(sphere, now.as_ref())));
            views.push(scenery.camera(fate, |_, _| FaceLook::Whole, Vec::new()));
        }
        let (n_planes, radius) = (at.step.input.planes.len(), sphere.radius());
        let distances = sphere_gauges(at.scenery, n_planes, radius, &asked, current(at));
        views.push(View::new(GAUGES_VIEW, Body::Gauges(distances)));
        views
    }
}

impl At<'_, SphereCull> {
    /// What all planes say, once it is told.
    fn class(&self) -> Option<Containment> {
        match self.step.event()? {
            Event::Done { class } => Some(class),
            Event::Plane { .. } => None,
        }
    }
}

/// The plane that is asked at this step.
fn current(at: &At<'_, SphereCull>) -> Option<usize> {
    match at.step.event()? {
        Event::Plane { plane_idx, .. } => Some(plane_idx),
        Event::Done { .. } => None,
    }
}

/// Of each plane that has been asked how far the centre lies from it, and what it says.
fn asked(at: &At<'_, SphereCull>) -> impl Iterator<Item = (f64, Containment)> {
    at.step.past.iter().filter_map(|event| match *event {
        Event::Plane {
            distance, class, ..
        } => Some((distance, class)),
        Event::Done { .. } => None,
    })
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
