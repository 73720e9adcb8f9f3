//! The funnel, shown: by the right rules and by those with a mistake.

mod faulty;
mod marks;
mod ribbon;
mod variant;

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        cull::{
            Containment::{self, Inside, Outside, Straddles},
            Funnel, FunnelEvent as Event, FunnelInput, FunnelLevels, FunnelObject, TriangleFate,
            asked_camera, asked_sphere,
        },
        ring::Right,
        volume::SideCode,
    },
    figure::{
        Body, Run,
        Tick::{Accept, Cut, Phase, Reject, Test},
        View, Watch,
    },
    geom::VolumeSide,
    labs::{
        Answer, CodeLine,
        recorded::Recorded,
        space::{SpaceTelling, demo::scenery_of},
        telling::{At, Named, Row, Telling, Watched, rows},
        words::name,
    },
    trace::Step,
};

use super::{
    super::{
        Object, Scene,
        stage::{Scenery, face_link, object_link},
    },
    asked::Asked,
    sphere_cull::{AskedSphere, sphere_gauges, sphere_says},
};
use variant::{CULL, DRAW, EACH, FACE, PLANE, STRADDLES, TRIANGLE, Variant};

const GAUGES_VIEW: &str = "distances";
const RIBBON_VIEW: &str = "ribbon";

impl Answer for FunnelLevels {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl<L: Variant> SpaceTelling for Funnel<L> {
    const TELLS_FACES: bool = true;

    fn input(scene: &Scene) -> FunnelInput {
        FunnelInput {
            camera: *scene.culler(),
            objects: scene.objects().iter().map(Object::in_funnel).collect(),
        }
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        let (input, scenery) = (Self::input(scene), Some(scenery_of(scene)));
        Box::new(Recorded::<Self>::beside::<Funnel<Right>>(input, scenery))
    }
}

rows! { [L: Variant] |event, step: Funnel<L>|
    object: Event::Object { .. } =>
        Row::new(Phase, EACH, "funnel-object").so(&["c = {c}", "r{=r}"]);
    plane_inside: Event::Plane { class: Inside, .. } => sphere_says(Inside, PLANE);
    plane_straddles: Event::Plane { class: Straddles, .. } => sphere_says(Straddles, PLANE);
    plane_outside: Event::Plane { class: Outside, .. } => sphere_says(Outside, PLANE);
    inside: Event::Sphere { class: Inside, .. } =>
        Row::new(Accept, STRADDLES, "funnel-sphere-inside").keeps("object").answers("sphere");
    straddles: Event::Sphere { class: Straddles, .. } =>
        Row::new(Accept, STRADDLES, "funnel-sphere-straddles").cuts("object").answers("sphere");
    culled: Event::Sphere { class: Outside, .. } =>
        Row::new(Reject, CULL, "funnel-sphere-outside").drops("object").picks("plane", "planes");
    whole: Event::Triangle { fate: TriangleFate::Inside, .. } =>
        Row::new(Test, TRIANGLE, "funnel-triangle-inside").so(&["{or}"])
            .keeps("triangle").answers_as("codes", "option-triangle-inside");
    beyond: Event::Triangle { fate: TriangleFate::Outside, .. } =>
        Row::new(Cut, TRIANGLE, "funnel-triangle-outside").so(&["{and} ≠ 000000"])
            .drops("triangle").answers_as("codes", "option-triangle-outside");
    nothing: Event::Triangle { fate: TriangleFate::Cut, n_pieces: 0, .. } =>
        clipped("funnel-triangle-nothing").drops("triangle");
    across: Event::Triangle { fate: TriangleFate::Cut, codes, .. } if n_inside(codes) == 0 =>
        clipped("funnel-triangle-across").cuts("triangle");
    cut: Event::Triangle { fate: TriangleFate::Cut, .. } =>
        clipped("funnel-triangle-cut").cuts("triangle");
    front: Event::Face { front: true, .. } =>
        Row::new(Test, FACE, "funnel-face-front").so(&["n·e{=n·e} > 0"])
            .keeps("triangle").answers("facing");
    edge_on: Event::Face { dot, .. } if dot == 0.0 =>
        Row::new(Reject, FACE, "funnel-face-edge-on").so(&["n·e{=n·e}"])
            .drops("triangle").answers("facing");
    back: Event::Face { .. } =>
        Row::new(Reject, FACE, "funnel-face-back").so(&["n·e{=n·e} < 0"])
            .drops("triangle").answers("facing");
    done: Event::Done => Row::new(Accept, DRAW, "funnel-done");
}

/// A triangle that the clipper takes over. What all corners lie beyond would decide; here it is nothing.
const fn clipped(key: &'static str) -> Row {
    let row = Row::new(Cut, TRIANGLE, key).so(&["{and}", "{or}"]);
    row.answers_as("codes", "option-triangle-clipped")
}

impl<L: Variant> Telling for Funnel<L> {
    type Scenery = Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Clark, 1976";
    const CODE: &'static [CodeLine] = &L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const ROWS: &'static [Row] = ROWS;
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["watch-object", "c", "r", "n", "D", "watch-class"]),
        Watched::ListSeen("distances", GAUGES_VIEW),
        Watched::ListSeen("levels", RIBBON_VIEW),
    ];

    fn row(step: &Step<'_, Self>) -> &'static Row {
        row(step)
    }

    fn opening(_: &At<'_, Self>) -> &'static Row {
        const OPENING: Row = Row::new(Phase, EACH, "funnel-opening");
        &OPENING
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (input, levels) = (at.step.input, &at.step.held.levels);
        let n_triangles = |object: &FunnelObject| object.triangles.len();
        let Now {
            object_idx, side, ..
        } = Now::of(at);
        Some(match (name, at.step.event()) {
            ("objects", _) => input.objects.len().into(),
            ("triangles", None) => input.objects.iter().map(n_triangles).sum::<usize>().into(),
            ("triangles", Some(Event::Done)) => levels.scene.triangles.into(),
            ("triangles", Some(_)) => n_triangles(&input.objects[object_idx?]).into(),
            ("facing", _) => levels.facing.triangles.into(),
            ("kept", _) => levels.facing.objects.into(),
            ("object", _) => Named::from(object_idx? + 1).linked(object_link(object_idx?)),
            ("watch-object", _) => Named::maybe(object_idx.map(|i| i + 1)),
            ("n·e", Some(Event::Face { dot, .. })) => dot.into(),
            ("n" | "D", _) => {
                let side = at.scenery.zip(side);
                let current = side.map(|(scenery, side)| scenery.planes()[side as usize]);
                return Asked {
                    current,
                    ..planes(at)
                }
                .named(name);
            }
            _ => return of_triangle(at, name).or_else(|| sphere(at)?.named(name)),
        })
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        if list == "levels" {
            return ribbon::levels(&at.step.held.levels);
        }
        let sphere = asked(at);
        sphere.map_or(Vec::new(), |sphere| sphere.planes.listed(list))
    }

    /// Beside another method there is no room for the axes: the distances stand in the watch table.
    fn watch(at: &At<'_, Self>) -> Watch {
        let sections = Self::WATCH.iter().map(|watched| at.section(watched));
        let mut watch: Watch = sections.collect();
        if is_compared(at) {
            watch[1].seen_in = None;
        }
        watch
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            views.extend(marks::both(at, scenery));
        }
        if !is_compared(at) {
            let gauges = sphere(at).map_or_else(
                || sphere_gauges(&planes(at), 0.0, &[]),
                |sphere| sphere.gauges(),
            );
            views.push(View::new(GAUGES_VIEW, Body::Gauges(gauges)));
        }
        views.push(View::new(RIBBON_VIEW, Body::Ribbon(ribbon::ribbon(at))));
        views
    }
}

/// The values of names in sentences about one triangle.
fn of_triangle<L: Variant>(at: &At<'_, Funnel<L>>, of: &str) -> Option<Named> {
    if of == "triangle" {
        let now = Now::of(at);
        let face_idx = now.face_idx?;
        let focus = at.scenery.map(|scenery| scenery.scene().focus());
        let named = Named::from(face_idx + 1);
        return Some(if focus == now.object_idx {
            named.linked(face_link(face_idx))
        } else {
            named
        });
    }
    let Some(Event::Triangle {
        codes, n_pieces, ..
    }) = at.step.event()
    else {
        return None;
    };
    let [a, b, c] = codes;
    Some(match of {
        "inside" => n_inside(codes).into(),
        "pieces" => n_pieces.into(),
        "and" if n_inside(codes) == 0 => {
            name(format!("{a} AND {b} AND {c} = {}", a.and(b).and(c))).into()
        }
        "or" => name(format!("{a} OR {b} OR {c} = {}", a.or(b).or(c))).into(),
        _ => return None,
    })
}

fn n_inside(codes: [SideCode; 3]) -> usize {
    codes.iter().filter(|code| code.is_inside()).count()
}

/// What a step is about.
#[derive(Clone, Copy, Default)]
struct Now {
    /// The object whose turn it is.
    object_idx: Option<usize>,
    /// The plane that is asked.
    side: Option<VolumeSide>,
    /// What all planes have said of its sphere.
    class: Option<Containment>,
    /// The triangle that is asked.
    face_idx: Option<usize>,
}

impl Now {
    fn of<L: Variant>(at: &At<'_, Funnel<L>>) -> Self {
        let object_idx = Some(at.step.held.object_idx);
        let class = Some(at.step.held.sphere.class);
        let (side, class, face_idx) = match at.step.event() {
            None | Some(Event::Done) => return Self::default(),
            Some(Event::Object { .. }) => (None, None, None),
            Some(Event::Plane { side, .. }) => (Some(side), None, None),
            Some(Event::Sphere { .. }) => (None, class, None),
            Some(Event::Triangle { triangle_idx, .. } | Event::Face { triangle_idx, .. }) => {
                (None, class, Some(triangle_idx))
            }
        };
        Self {
            object_idx,
            side,
            class,
            face_idx,
        }
    }
}

/// The volume's planes, of which none has been asked.
fn planes<'a, L: Variant>(at: &At<'a, Funnel<L>>) -> Asked<'a> {
    Asked {
        scenery: at.scenery,
        n_planes: VolumeSide::ALL.len(),
        ..Asked::default()
    }
}

/// The sphere of the object whose turn it is.
fn sphere<'a, L: Variant>(at: &At<'a, Funnel<L>>) -> Option<AskedSphere<'a>> {
    Now::of(at).object_idx.and(asked(at))
}

/// The sphere that has been asked last.
fn asked<'a, L: Variant>(at: &At<'a, Funnel<L>>) -> Option<AskedSphere<'a>> {
    let (input, held) = (at.step.input, at.step.held);
    let object = input
        .objects
        .get(held.object_idx)
        .or(input.objects.last())?;
    let camera = asked_camera::<L>(&input.camera);
    let Now { side, class, .. } = Now::of(at);
    let planes = Asked {
        current: side.map(|side| camera.planes_in_world()[side as usize]),
        class,
        ..planes(at)
    };
    let sphere = asked_sphere::<L>(object);
    Some(AskedSphere::new::<L>(sphere, &held.sphere, planes))
}

/// Does it run beside another method?
fn is_compared<L: Variant>(at: &At<'_, Funnel<L>>) -> bool {
    let scenery = at.scenery;
    scenery.is_some_and(|scenery| !scenery.scene().beside.is_empty())
}
