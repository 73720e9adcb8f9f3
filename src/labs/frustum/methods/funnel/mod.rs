//! The funnel, shown: by the right rules and by those with a mistake.

mod captions;
mod faulty;
mod marks;
mod ribbon;
mod variant;

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        cull::{
            Containment, CullRules, Funnel, FunnelEvent as Event, FunnelInput, FunnelLevels,
            FunnelState as State, TriangleFate, asked_sphere, triangle_fate,
        },
        ring::Right,
    },
    figure::{Body, Caption, Gauges, Run, Tick, View, Watch, WatchRow, WatchSection},
    labs::{Answer, CodeLine, Demo, Step, record_beside},
    text::Value,
};

use super::{
    super::{FaceFate, FaceTest, OnScene, OnSceneInput, Scene, demo::SpaceDemo, stage::side_link},
    sphere_cull::{class_row, class_tick, plane_tick, sphere_gauges, sphere_rows},
};
use variant::Variant;

type Input = OnSceneInput<FunnelInput>;
type Shown<L> = OnScene<Funnel<L>>;

const GAUGES_VIEW: &str = "distances";
const RIBBON_VIEW: &str = "ribbon";

impl Answer for FunnelLevels {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl<L: CullRules + Variant> SpaceDemo for Shown<L> {
    const TELLS_FACES: bool = true;

    fn face_fate(scene: &Scene, face_idx: usize) -> Option<FaceFate> {
        let input = Self::input(scene).own;
        let (step, event) = triangle_fate::<L>(&input, scene.focus(), face_idx)?;
        let test = match event {
            Event::Triangle {
                codes: [a, b, c], ..
            } => match a.and(b).and(c).lowest() {
                Some(side) => FaceTest::Corners(side),
                None => FaceTest::Cut,
            },
            Event::Face { .. } => FaceTest::Facing,
            Event::Object { .. } | Event::Plane { .. } | Event::Sphere { .. } | Event::Done => {
                FaceTest::Sphere
            }
        };
        Some(FaceFate { step, test })
    }

    fn input(scene: &Scene) -> Input {
        let own = FunnelInput {
            camera: *scene.culler(),
            objects: scene
                .objects()
                .iter()
                .map(super::super::Object::in_funnel)
                .collect(),
        };
        OnSceneInput::of(scene, own)
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, Shown<Right>>(Self::input(scene))
    }
}

impl<L: CullRules + Variant> Demo for Shown<L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Clark, 1976";
    const CODE: &'static [CodeLine] = &L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Object { .. } => Tick::Phase,
            Event::Plane { class, .. } => plane_tick(*class),
            Event::Sphere { class, .. } => class_tick(*class),
            Event::Triangle { fate, .. } => match fate {
                TriangleFate::Inside => Tick::Test,
                TriangleFate::Outside | TriangleFate::Cut => Tick::Cut,
            },
            Event::Face { front: true, .. } => Tick::Test,
            Event::Face { front: false, .. } => Tick::Reject,
            Event::Done => Tick::Accept,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Object { .. } => variant::EACH,
            Event::Plane { .. } => variant::PLANE,
            Event::Sphere { class, .. } => match class {
                Containment::Outside => variant::CULL,
                Containment::Inside | Containment::Straddles => variant::STRADDLES,
            },
            Event::Triangle { .. } => variant::TRIANGLE,
            Event::Face { .. } => variant::FACE,
            Event::Done => variant::DRAW,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption::<L>(event, before, &input.own)
    }

    fn opening(input: &Input) -> Caption {
        captions::opening(&input.own)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        let scenery = step.input.scenery.as_deref();
        if let Some(scenery) = scenery {
            views.extend(marks::both(step, scenery));
        }
        if !is_compared(step) {
            views.push(View::new(GAUGES_VIEW, Body::Gauges(distances(step))));
        }
        views.push(View::new(RIBBON_VIEW, Body::Ribbon(ribbon::ribbon(step))));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let objects = &step.input.own.objects;
        let mut rows = vec![WatchRow::new(
            Value::Term("watch-object"),
            step.state.object_idx.map(|i| Value::Count(i + 1)),
        )];
        if let Some(i) = step.state.object_idx
            && let Some(object) = objects.get(i)
        {
            let scenery = step.input.scenery.as_deref();
            let plane = scenery.zip(side_idx(step));
            let plane = plane.and_then(|(scenery, side)| scenery.planes().get(side));
            rows.extend(sphere_rows(&asked_sphere::<L>(object), plane));
        }
        let class = step.state.sphere.class;
        rows.extend(
            class
                .filter(|_| step.state.object_idx.is_some())
                .map(class_row),
        );
        let asked = step
            .state
            .sphere
            .asked
            .iter()
            .zip(crate::geom::VolumeSide::ALL);
        let distances = asked.map(|(&(d, _), side)| {
            WatchRow::new(super::super::stage::side_name(side), Some(d.into()))
                .linked(side_link(side))
        });
        let distances = WatchSection::list(distances.collect());
        vec![
            WatchSection::list(rows),
            if is_compared(step) {
                distances
            } else {
                distances.seen_in(GAUGES_VIEW)
            },
            WatchSection::list(ribbon::level_rows(&step.state.levels)).seen_in(RIBBON_VIEW),
        ]
    }
}

/// Beside another method there is no room for the axes: the distances stand in the watch table.
fn is_compared<L: CullRules>(step: &Step<'_, Shown<L>>) -> bool {
    let scenery = step.input.scenery.as_deref();
    scenery.is_some_and(|scenery| !scenery.scene().beside.is_empty())
}

fn distances<L: CullRules>(step: &Step<'_, Shown<L>>) -> Gauges {
    let objects = &step.input.own.objects;
    let object = step.state.object_idx.and_then(|i| objects.get(i));
    let radius = object.map_or(0.0, |object| object.sphere.radius());
    let scenery = step.input.scenery.as_deref();
    let asked = object.map_or(&[][..], |_| &step.state.sphere.asked);
    sphere_gauges(scenery, 6, radius, asked, side_idx(step))
}

/// The plane that is asked at this step.
fn side_idx<L: CullRules>(step: &Step<'_, Shown<L>>) -> Option<usize> {
    match step.event {
        Some(Event::Plane { side, .. }) => Some(side as usize),
        Some(
            Event::Object { .. }
            | Event::Sphere { .. }
            | Event::Triangle { .. }
            | Event::Face { .. }
            | Event::Done,
        )
        | None => None,
    }
}
