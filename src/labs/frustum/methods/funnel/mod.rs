//! The funnel, shown: by the right rules and by those with a mistake.

mod codes;
mod marks;
mod ribbon;
mod variant;

use crate::{
    algo::cull::{
        Funnel, FunnelEvent as Event, FunnelInput, FunnelLevels, FunnelObject, TriangleFate,
        asked_camera, asked_sphere,
    },
    labs::frustum::prelude::*,
};

use super::{
    super::Object,
    asked::{Asked, across, beyond, within},
    sphere_cull::{AskedSphere, sphere_gauges, sphere_says},
};
use variant::{CULL, DRAW, EACH, FACE, PLANE, STRADDLES, TRIANGLE, Variant};

const GAUGES_VIEW: &str = "distances";
const RIBBON_VIEW: &str = "ribbon";

impl AnswerAsItIs for FunnelLevels {}

impl<L: Variant> SpaceTelling for Funnel<L> {
    const SUBJECT: Subject = Subject::Objects;
    const TELLS_FACES: bool = true;

    fn input(scene: &Scene) -> FunnelInput {
        FunnelInput {
            camera: *scene.culler(),
            objects: scene.objects().iter().map(Object::in_funnel).collect(),
        }
    }
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
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["watch-object", "c", "r", "n", "D", "watch-class"]),
        Watched::ListSeen("distances", GAUGES_VIEW),
        Watched::ListSeen("levels", RIBBON_VIEW),
    ];
    const OPENING: Row = Row::new(Phase, EACH, "funnel-opening");

    table! { |event, step|
        object: Event::Object { .. } =>
            Row::new(Phase, EACH, "funnel-object").so(&["c = {c}", "r{=r}"]);
        plane_inside: Event::Plane { class: Inside, .. } => sphere_says(Inside, PLANE);
        plane_straddles: Event::Plane { class: Straddles, .. } => sphere_says(Straddles, PLANE);
        plane_outside: Event::Plane { class: Outside, .. } => sphere_says(Outside, PLANE);
        inside: Event::Sphere { class: Inside, .. } =>
            within(Row::new(Accept, STRADDLES, "funnel-sphere-inside").keeps("object"));
        straddles: Event::Sphere { class: Straddles, .. } =>
            across(Row::new(Accept, STRADDLES, "funnel-sphere-straddles").cuts("object"));
        culled: Event::Sphere { class: Outside, .. } =>
            beyond(Row::new(Reject, CULL, "funnel-sphere-outside").drops("object"));
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

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (input, levels) = (at.step.input, &at.step.held.levels);
        let n_triangles = |object: &FunnelObject| object.triangles.len();
        let now = Now::of(at);
        let object_idx = now.object_idx;
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
                let mut planes = planes(at);
                let side = at.scenery.zip(now.side);
                planes.current = side.map(|(scenery, side)| scenery.planes()[side as usize]);
                return planes.named(name);
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

    /// Beside another method there is no room for the axes, nor while triangles are asked: the distances stand in the watch table.
    fn watch(at: &At<'_, Self>) -> Watch {
        let mut watch: Watch = Self::WATCH.iter().map(|it| at.section(it)).collect();
        if is_compared(at) || matches!(at.step.event(), Some(Event::Triangle { .. })) {
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
            let none = || sphere_gauges(&planes(at), 0.0, &[]);
            // In the end the last sphere stays: the title says whose it is.
            let shown = asked(at).filter(|_| at.step.event().is_some());
            let n_objects = at.step.input.objects.len();
            let object = (at.step.held.object_idx + 1).min(n_objects);
            let shown = shown.map(|sphere| Gauges {
                title: Message::new("gauges-sphere-of")
                    .with("object", object)
                    .with("planes", sphere.planes.n_planes),
                ..sphere.gauges()
            });
            // Where the sphere was measured stand the triangle's codes, once it is asked.
            let body = match codes::table(at.step.event()) {
                Some(table) => Body::Table(table),
                None => Body::Gauges(shown.unwrap_or_else(none)),
            };
            views.push(View::new(GAUGES_VIEW, body));
        }
        views.push(View::new(RIBBON_VIEW, Body::Ribbon(ribbon::ribbon(at))));
        views
    }
}

fn of_triangle<L: Variant>(at: &At<'_, Funnel<L>>, of: &str) -> Option<Named> {
    if of == "triangle" {
        let now = Now::of(at);
        let face_idx = now.face_idx?;
        let focus = at.scenery.map(|scenery| scenery.scene().focus());
        let link = (focus == now.object_idx).then(|| face_link(face_idx));
        return Some(Named {
            link,
            ..Named::from(face_idx + 1)
        });
    }
    let Event::Triangle {
        codes, n_pieces, ..
    } = at.step.event()?
    else {
        return None;
    };
    let [a, b, c] = codes;
    Some(match of {
        "inside" => n_inside(codes).into(),
        "pieces" => n_pieces.into(),
        "and" if n_inside(codes) > 0 => return None,
        "and" => name(format!("{a} AND {b} AND {c} = {}", a.and(b).and(c))).into(),
        "or" => name(format!("{a} OR {b} OR {c} = {}", a.or(b).or(c))).into(),
        _ => return None,
    })
}

fn n_inside(codes: [SideCode; 3]) -> usize {
    codes.iter().filter(|code| code.is_inside()).count()
}

#[derive(Clone, Copy, Default)]
struct Now {
    object_idx: Option<usize>,
    side: Option<VolumeSide>,
    class: Option<Containment>,
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
            Some(
                Event::Triangle {
                    triangle_idx: i, ..
                }
                | Event::Face {
                    triangle_idx: i, ..
                },
            ) => (None, class, Some(i)),
        };
        Self {
            object_idx,
            side,
            class,
            face_idx,
        }
    }
}

fn planes<'a, L: Variant>(at: &At<'a, Funnel<L>>) -> Asked<'a> {
    Asked {
        scenery: at.scenery,
        n_planes: VolumeSide::ALL.len(),
        ..Asked::default()
    }
}

fn sphere<'a, L: Variant>(at: &At<'a, Funnel<L>>) -> Option<AskedSphere<'a>> {
    Now::of(at).object_idx.and(asked(at))
}

fn asked<'a, L: Variant>(at: &At<'a, Funnel<L>>) -> Option<AskedSphere<'a>> {
    let (input, held) = (at.step.input, at.step.held);
    let objects = &input.objects;
    let object = objects.get(held.object_idx).or(objects.last())?;
    let camera = asked_camera::<L>(&input.camera);
    let (now, mut planes) = (Now::of(at), planes(at));
    planes.current = now.side.map(|side| camera.planes_in_world()[side as usize]);
    planes.class = now.class;
    let sphere = asked_sphere::<L>(object);
    Some(AskedSphere::new::<L>(sphere, &held.sphere, planes))
}

fn is_compared<L: Variant>(at: &At<'_, Funnel<L>>) -> bool {
    at.scenery.is_some_and(|it| !it.scene().beside.is_empty())
}
