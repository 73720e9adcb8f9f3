//! The sections, and the numbers of each.

use std::ops::RangeInclusive;

use crate::{
    geom::SpaceError,
    labs::space::{
        CameraNumbers, Object, Opening, Part, Places, RasterPlan, Scene, SceneError, Subject,
    },
    text::{Diagnostic, Message},
};

use super::control::{Control, Section};

pub(super) static SECTIONS: [Section; 6] = [
    Section {
        id: "camera",
        title: |_| Message::new("camera-title"),
        numbers: &CAMERA,
        choices: &["camera.sight", "camera.freeze"],
        is_there: Scene::shows_camera,
    },
    Section {
        id: "object",
        title: |scene| {
            Message::new("object-focus").with("object", scene.object_name(scene.focus()))
        },
        numbers: &OBJECT,
        choices: &[],
        is_there: Scene::shows_objects,
    },
    Section {
        id: "raster",
        title: |_| Message::new("raster-title"),
        numbers: &RASTER,
        choices: &[
            "raster.steps",
            "raster.tones",
            "raster.depth",
            "raster.reversed",
            "raster.cull",
        ],
        is_there: |scene| scene.asks(Subject::Surfaces),
    },
    Section {
        id: "point",
        title: |_| Message::new("section-point"),
        numbers: &POINT,
        choices: &[],
        is_there: |scene| scene.asks(Subject::Point),
    },
    Section {
        id: "segment",
        title: |_| Message::new("section-segment"),
        numbers: &SEGMENT,
        choices: &[],
        is_there: |scene| scene.asks(Subject::Segment) || scene.asks(Subject::BoxedSegment),
    },
    Section {
        id: "triangle",
        title: |_| Message::new("section-triangle"),
        numbers: &TRIANGLE,
        choices: &[],
        is_there: |scene| scene.asks(Subject::Triangle),
    },
];

/// Dragging takes a place so far from the origin along each axis, and a plane as near and as far.
const REACH: f64 = 1000.0;
const NEAREST: f64 = 0.01;

static CAMERA: [Control; 8] = [
    Control {
        numbers: |scene| scene.camera.places()[0].into(),
        set: |scene, i, x| camera(scene, |it| it.places[0][i] = x),
        ..place("camera.position", "camera", || {
            Message::new("camera-position")
        })
    },
    Control {
        numbers: |scene| scene.camera.places()[1].into(),
        set: |scene, i, x| camera(scene, |it| it.places[1][i] = x),
        ..place("camera.target", "camera", || Message::new("camera-target"))
    },
    Control {
        numbers: |scene| scene.camera.places()[2].into(),
        set: |scene, i, x| camera(scene, |it| it.places[2][i] = x),
        ..place("camera.up", "camera", || Message::new("camera-up"))
    },
    Control {
        unit: "°",
        numbers: |scene| match scene.camera.opening() {
            Opening::FovY(degrees) => vec![degrees],
            Opening::Height(_) => Vec::new(),
        },
        range: |_| 1.0..=170.0,
        set: |scene, _, x| camera(scene, |it| it.opening = Opening::FovY(x)),
        ..place("camera.fov", "volume", || Message::new("camera-fov"))
    },
    Control {
        numbers: |scene| match scene.camera.opening() {
            Opening::FovY(_) => Vec::new(),
            Opening::Height(height) => vec![height],
        },
        range: |_| NEAREST..=REACH,
        set: |scene, _, x| camera(scene, |it| it.opening = Opening::Height(x)),
        ..place("camera.height", "volume", || Message::new("camera-height"))
    },
    Control {
        numbers: |scene| vec![scene.camera.aspect()],
        range: |_| 0.1..=10.0,
        set: |scene, _, x| camera(scene, |it| it.aspect = x),
        ..place("camera.aspect", "volume", || Message::new("camera-aspect"))
    },
    Control {
        numbers: |scene| vec![scene.camera.depths()[0]],
        range: |scene| {
            let [near, far] = scene.camera.depths();
            NEAREST.min(near)..=far - least_gap(scene)
        },
        set: |scene, _, x| camera(scene, |it| it.depths[0] = x),
        ..place("camera.near", "volume", || Message::new("camera-near"))
    },
    Control {
        numbers: |scene| vec![scene.camera.depths()[1]],
        range: |scene| {
            let [near, far] = scene.camera.depths();
            near + least_gap(scene)..=REACH.max(far)
        },
        set: |scene, _, x| camera(scene, |it| it.depths[1] = x),
        ..place("camera.far", "volume", || Message::new("camera-far"))
    },
];

static OBJECT: [Control; 7] = [
    Control {
        numbers: |scene| vec![(scene.focus() + 1) as f64],
        range: |scene| counted(scene, Part::Object),
        set: |scene, _, x| look_at(scene, Part::Object, x),
        ..place("object.number", "", || Message::new("object-number"))
    },
    Control {
        numbers: |scene| scene.focused().at().into(),
        set: |scene, i, x| {
            let at = with(scene.focused().at(), i, x);
            reshape(scene, |old| old.moved(at))
        },
        ..place("object.place", "object", || Message::new("object-place"))
    },
    Control {
        unit: "°",
        numbers: |scene| scene.focused().turn_deg().into(),
        range: |_| -360.0..=360.0,
        set: |scene, i, x| {
            let turn_deg = with(scene.focused().turn_deg(), i, x);
            reshape(scene, |old| old.reshaped(turn_deg, old.size()))
        },
        ..place("object.turn", "object", || Message::new("object-turn"))
    },
    Control {
        numbers: |scene| vec![scene.focused().size()],
        range: |_| 0.01..=100.0,
        set: |scene, _, size| reshape(scene, |old| old.reshaped(old.turn_deg(), size)),
        ..place("object.size", "object", || Message::new("object-size"))
    },
    Control {
        numbers: |scene| {
            let opacity = scene.focused().opacity();
            let is_painted = scene.asks(Subject::Surfaces);
            is_painted.then_some(opacity).into_iter().collect()
        },
        range: |_| 0.0..=1.0,
        set: |scene, _, opacity| {
            if let Some(object) = scene.focused().clone().with_opacity(opacity) {
                scene.set_object(scene.focus(), object);
            }
            Ok(())
        },
        ..place("object.opacity", "", || Message::new("object-opacity"))
    },
    Control {
        numbers: |scene| vec![(scene.face() + 1) as f64],
        range: |scene| counted(scene, Part::Face),
        set: |scene, _, x| look_at(scene, Part::Face, x),
        ..place("object.face", "", || Message::new("object-face"))
    },
    Control {
        numbers: |scene| vec![(scene.vertex() + 1) as f64],
        range: |scene| counted(scene, Part::Vertex),
        set: |scene, _, x| look_at(scene, Part::Vertex, x),
        ..place("object.vertex", "", || Message::new("object-vertex"))
    },
];

static RASTER: [Control; 3] = [
    Control {
        numbers: |scene| vec![scene.raster.rows().into()],
        range: |_| (*RasterPlan::ROWS.start()).into()..=(*RasterPlan::ROWS.end()).into(),
        set: |scene, _, x| {
            scene.raster = scene.raster.with_rows(x.round() as u32);
            Ok(())
        },
        ..place("raster.rows", "", || Message::new("raster-rows"))
    },
    Control {
        numbers: |scene| vec![scene.raster.shuffle.unwrap_or_default() as f64],
        range: |_| 0.0..=9999.0,
        set: |scene, _, x| {
            scene.raster.shuffle = (x.round() >= 1.0).then_some(x.round() as u64);
            Ok(())
        },
        ..place("raster.shuffle", "", || Message::new("raster-shuffle"))
    },
    Control {
        numbers: |scene| shown_pixel(scene).into(),
        range: |_| -1.0..=160.0,
        set: |scene, i, x| {
            let mut pixel = shown_pixel(scene).map(|x| x.max(0.0) as u32);
            pixel[i] = x.max(0.0).round() as u32;
            scene.raster.pixel = (x >= 0.0).then_some(pixel);
            Ok(())
        },
        ..place("raster.pixel", "", || Message::new("raster-pixel"))
    },
];

static POINT: [Control; 1] = [Control {
    numbers: |scene| scene.places().point.into(),
    set: |scene, i, x| places(scene, |it| it.point[i] = x),
    ..place("point.p", "point", || Message::new("handle-point"))
}];

static SEGMENT: [Control; 2] = [
    Control {
        numbers: |scene| scene.places().segment[0].into(),
        set: |scene, i, x| places(scene, |it| it.segment[0][i] = x),
        ..place("segment.p1", "segment", || end(1))
    },
    Control {
        numbers: |scene| scene.places().segment[1].into(),
        set: |scene, i, x| places(scene, |it| it.segment[1][i] = x),
        ..place("segment.p2", "segment", || end(2))
    },
];

static TRIANGLE: [Control; 3] = [
    Control {
        numbers: |scene| scene.places().triangle[0].into(),
        set: |scene, i, x| places(scene, |it| it.triangle[0][i] = x),
        ..place("triangle.v0", "triangle", || corner(0))
    },
    Control {
        numbers: |scene| scene.places().triangle[1].into(),
        set: |scene, i, x| places(scene, |it| it.triangle[1][i] = x),
        ..place("triangle.v1", "triangle", || corner(1))
    },
    Control {
        numbers: |scene| scene.places().triangle[2].into(),
        set: |scene, i, x| places(scene, |it| it.triangle[2][i] = x),
        ..place("triangle.v2", "triangle", || corner(2))
    },
];

const fn place(id: &'static str, group: &'static str, name: fn() -> Message) -> Control {
    Control {
        id,
        name,
        unit: "",
        group,
        numbers: |_| Vec::new(),
        range: |_| -REACH..=REACH,
        set: |_, _, _| Ok(()),
    }
}

fn end(number: usize) -> Message {
    Message::new("handle-space-end").with("number", number)
}

fn corner(number: usize) -> Message {
    Message::new("handle-space-corner").with("number", number)
}

fn camera(scene: &mut Scene, change: impl FnOnce(&mut CameraNumbers)) -> Result<(), Diagnostic> {
    scene.camera = scene.camera.with(change)?;
    Ok(())
}

fn least_gap(scene: &Scene) -> f64 {
    let [near, far] = scene.camera.depths();
    0.01 * (far - near).abs().min(1.0)
}

fn places(scene: &mut Scene, change: impl FnOnce(&mut Places)) -> Result<(), Diagnostic> {
    let mut places = scene.places();
    change(&mut places);
    Ok(scene.set_places(places)?)
}

fn reshape(
    scene: &mut Scene,
    change: impl FnOnce(&Object) -> Result<Object, SpaceError>,
) -> Result<(), Diagnostic> {
    let object = change(scene.focused())?;
    scene.set_object(scene.focus(), object);
    Ok(())
}

fn counted(scene: &Scene, part: Part) -> RangeInclusive<f64> {
    1.0..=scene.count(part) as f64
}

fn look_at(scene: &mut Scene, part: Part, number: f64) -> Result<(), Diagnostic> {
    let nth = number.round() as usize;
    // Here one counts from 1, also in what is refused.
    let counted = |error| match error {
        SceneError::NoSuchPart { count, .. } => SceneError::NoSuchPart {
            part,
            idx: nth,
            count,
        },
        error @ (SceneError::NoObjects | SceneError::TooManyObjects(_)) => error,
    };
    Ok(scene.look_at(part, nth.wrapping_sub(1)).map_err(counted)?)
}

fn shown_pixel(scene: &Scene) -> [f64; 2] {
    scene
        .raster
        .pixel
        .map_or([-1.0; 2], |pixel| pixel.map(f64::from))
}

fn with(mut numbers: [f64; 3], i: usize, x: f64) -> [f64; 3] {
    numbers[i] = x;
    numbers
}
