//! A bounding sphere against the planes of the view volume, shown.

use crate::{
    algo::cull::{
        CullRules, SphereCull, SphereCullEvent as Event, SphereCullInput, SphereCullOutput,
        sphere_side,
    },
    geom::Sphere,
    labs::frustum::prelude::*,
};

use super::super::Object;
use super::asked::{Asked, across, beyond, both, distance_formula, fate_of, place, says, within};

const GAUGES_VIEW: &str = "distances";

impl AnswerAsItIs for SphereCullOutput {}

impl SpaceTelling for SphereCull {
    fn input(scene: &Scene) -> SphereCullInput {
        input_of(scene, scene.focused())
    }
}

fn input_of(scene: &Scene, object: &Object) -> SphereCullInput {
    SphereCullInput {
        planes: scene.culler().planes_in_world().to_vec(),
        sphere: object.in_funnel().sphere,
    }
}

const R: &[&str] = &["r{=r}"];

pub const fn sphere_says(class: Containment, line: usize) -> Row {
    let key = match class {
        Inside => "sphere-inside",
        Straddles => "sphere-straddles",
        Outside => "sphere-outside",
    };
    says(class, line, key)
        .so(&["{d = n·c + D}"])
        .answers("class")
}

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
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["c", "r", "n", "D", "watch-class"]),
        Watched::ListSeen("distances", GAUGES_VIEW),
    ];
    const OPENING: Row = Row::new(Phase, 0, "sphere-opening").so(&["c = {c}", "r{=r}"]);

    table! { |event, step|
        inside: Event::Plane { class: Inside, .. } => sphere_says(Inside, 1);
        outside: Event::Plane { class: Outside, .. } => sphere_says(Outside, 2);
        straddles: Event::Plane { class: Straddles, .. } => sphere_says(Straddles, 3);
        none_out: Event::Done { class: Inside } =>
            within(Row::new(Accept, 4, "sphere-done-inside").so(R));
        cut: Event::Done { class: Straddles } =>
            across(Row::new(Accept, 4, "sphere-done-straddles").so(R));
        culled: Event::Done { class: Outside } =>
            beyond(Row::new(Reject, 2, "planes-done-outside").so(R));
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        asked(at).named(name)
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        asked(at).planes.listed(list)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let asked = asked(at);
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let scene = scenery.scene();
            let others =
                |other: &Object| fate_of(Some(silent::<Self>(&input_of(scene, other)).class));
            let (fate, mut marks) = (fate_of(asked.planes.class), asked.marks(scene.culler()));
            if asked.planes.lit().is_none() {
                marks.extend(asked.reach(DVec3::Y));
            }
            views.extend(both(scenery, fate, others, marks));
        }
        views.push(View::new(GAUGES_VIEW, Body::Gauges(asked.gauges())));
        views
    }
}

fn asked<'a>(at: &At<'a, SphereCull>) -> AskedSphere<'a> {
    let SphereCullInput { planes, sphere } = at.step.input;
    let (current, class) = match at.step.event() {
        Some(Event::Plane { plane_idx, .. }) => (planes.get(plane_idx).copied(), None),
        Some(Event::Done { class }) => (None, Some(class)),
        None => (None, None),
    };
    let planes = Asked {
        scenery: at.scenery,
        n_planes: planes.len(),
        current,
        class,
        is_done: class.is_some(),
        ..Asked::default()
    };
    AskedSphere::new::<Right>(*sphere, at.step.held, planes)
}

pub struct AskedSphere<'a> {
    pub planes: Asked<'a>,
    sphere: Sphere,
    distances: &'a [f64],
}

impl<'a> AskedSphere<'a> {
    pub fn new<L: CullRules>(
        sphere: Sphere,
        held: &'a SphereCullOutput,
        mut planes: Asked<'a>,
    ) -> Self {
        let distances = &held.distances[..];
        planes.turns_sign = L::TURNS_SIGN;
        let says = |d: f64| sphere_side::<f64, L>(d, sphere.radius());
        planes.answers = distances.iter().map(|&d| (d.into(), says(d))).collect();
        Self {
            planes,
            sphere,
            distances,
        }
    }

    pub fn named(&self, name: &str) -> Option<Named> {
        Some(match name {
            "c" => place(self.sphere.center()).into(),
            "r" => self.sphere.radius().into(),
            "d = n·c + D" => self.distance()?.into(),
            _ => return self.planes.named(name),
        })
    }

    /// `d = n·c + D = … = −3.4 < −r = −1.01`.
    fn distance(&self) -> Option<Formula> {
        let (d, (_, class)) = self.distances.last().zip(self.planes.answers.last())?;
        let plane = self.planes.current?;
        let (c, r) = (self.sphere.center(), self.sphere.radius());
        let d = distance_formula(["d", "c"], &plane, c, *d);
        Some(match (class, self.planes.turns_sign) {
            (Outside, false) => d.sym(" < −r").equals(-r),
            (Straddles, false) => d.sym(",  −r ≤ d < r").equals(r),
            (Inside, false) => d.sym(" ≥ r").equals(r),
            (Outside, true) => d.sym(" > r").equals(r),
            (Straddles, true) => d.sym(",  −r < d ≤ r").equals(r),
            (Inside, true) => d.sym(" ≤ −r").equals(-r),
        })
    }

    /// The sphere, and the plane that is asked of it: its perpendicular in ink as far as the sphere reaches.
    pub fn marks(&self, camera: &Camera) -> Vec<Mark3> {
        let (center, radius) = (self.sphere.center(), self.sphere.radius());
        let mut marks = vec![
            Mark3::new(Role::Ink, Shape3::Ball(center, radius)),
            Mark3::new(Role::Ink, Shape3::Dot(center)).labelled(name("c")),
        ];
        marks.extend(self.planes.marks(camera, center, self.distances));
        if let Some(side) = self.planes.lit() {
            let unit = DVec3::from(camera.planes_in_world()[side as usize].unit_normal());
            let towards = -unit * self.distances[side as usize].signum();
            let [reach, name] = self.reach(towards);
            marks.push(Mark3 {
                label: name.label,
                ..reach
            });
        }
        marks
    }

    /// Its radius, and beside its end what that is called: it is not what has to be seen in its length.
    fn reach(&self, towards: DVec3) -> [Mark3; 2] {
        let (center, radius) = (self.sphere.center(), self.sphere.radius());
        let end = (DVec3::from(center) + radius * towards).into();
        let shapes = [Shape3::Segment([center, end]), Shape3::Label(end)];
        let [reach, name] = shapes.map(|shape| Mark3::new(Role::Ink, shape));
        [reach, name.labelled(sym("r").equals(radius))]
    }

    pub fn gauges(&self) -> Gauges {
        sphere_gauges(&self.planes, self.sphere.radius(), self.distances)
    }
}

pub fn sphere_gauges(planes: &Asked<'_>, radius: f64, distances: &[f64]) -> Gauges {
    let title = Message::new("gauges-sphere").with("planes", planes.n_planes);
    planes.gauges(title, radius, distances)
}
