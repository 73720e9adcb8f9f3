//! The camera of a scene, and the eye that watches it, as files spell them.

use std::ops::Range;

use glam::DVec3;

use crate::{
    geom::{Orbit, SpaceError},
    labs::space::{Opening, TaughtCamera},
    lesson::{
        scene_file::parts::{array, exact},
        sink::Sink,
        toml_fields::{Item, TomlFields, number, numbers},
    },
    text::Message,
};

const CAMERA: [&str; 8] = [
    "position",
    "target",
    "up",
    "fov_y_deg",
    "height",
    "aspect",
    "near",
    "far",
];
const EYE: [&str; 5] = ["target", "yaw_deg", "pitch_deg", "distance", "fov_y_deg"];

/// Which way is up where a file does not say.
const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// A camera, with `fov_y_deg` in perspective and `height` where sight lines are parallel.
pub(super) fn camera(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<TaughtCamera> {
    let fields = TomlFields::of(item, &CAMERA, sink)?;
    let (position, target) = (
        place(&fields, "position", sink),
        place(&fields, "target", sink),
    );
    let up = match fields.get("up") {
        Some(item) => numbers(item, "expect-place", sink),
        None => Some(UP),
    };
    let opening = opening(&fields, sink);
    let [aspect, near, far] = ["aspect", "near", "far"].map(|name| required(&fields, name, sink));
    let places = [position?, target?, up?];
    match TaughtCamera::new(places, opening?, aspect?, [near?, far?]) {
        Ok(camera) => Some(camera),
        Err(error) => {
            let span = to_blame(&fields, error);
            sink.refuse(span, error, [Message::new("expect-camera")]);
            None
        }
    }
}

fn place(fields: &TomlFields<'_>, name: &'static str, sink: &mut Sink<'_>) -> Option<[f64; 3]> {
    let item = fields.require(name, sink)?;
    numbers(item, "expect-place", sink)
}

fn required(fields: &TomlFields<'_>, name: &'static str, sink: &mut Sink<'_>) -> Option<f64> {
    let item = fields.require(name, sink)?;
    number(item, "expect-number", sink)
}

/// One of the two that tell how wide a camera is open.
fn opening(fields: &TomlFields<'_>, sink: &mut Sink<'_>) -> Option<Opening> {
    match (fields.get("fov_y_deg"), fields.get("height")) {
        (Some(_), Some(height)) => {
            sink.error(height.span(), Message::new("problem-two-openings"), []);
            None
        }
        (None, Some(height)) => number(height, "expect-number", sink).map(Opening::Height),
        _ => required(fields, "fov_y_deg", sink).map(Opening::FovY),
    }
}

/// Where the number stands that makes no camera.
fn to_blame(fields: &TomlFields<'_>, error: SpaceError) -> Range<usize> {
    let field = error.camera_field().and_then(|name| fields.get(name));
    field.map_or_else(|| fields.span(), Item::span)
}

/// As [`camera`] reads it.
pub(super) fn camera_to_toml(camera: &TaughtCamera) -> String {
    let [position, target, up] = camera.places().map(|place| array(&place));
    let opening = match camera.opening() {
        Opening::FovY(degrees) => format!("fov_y_deg = {}", exact(degrees)),
        Opening::Height(height) => format!("height = {}", exact(height)),
    };
    let [near, far] = camera.depths().map(exact);
    let aspect = exact(camera.aspect());
    format!(
        "{{ position = {position}, target = {target}, up = {up}, {opening}, aspect = {aspect}, near = {near}, far = {far} }}"
    )
}

/// An eye; a number that it cannot have is refused, where [`Orbit::new`] takes the nearest.
pub(super) fn eye(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Orbit> {
    let fields = TomlFields::of(item, &EYE, sink)?;
    let target = place(&fields, "target", sink);
    let [yaw, pitch, distance, fov] =
        ["yaw_deg", "pitch_deg", "distance", "fov_y_deg"].map(|name| required(&fields, name, sink));
    let (pitch, distance, fov) = (pitch?, distance?, fov?);
    let eye = Orbit::new(target?, [yaw?, pitch], distance, fov);
    let taken = [
        ("pitch_deg", pitch, eye.angles_deg()[1]),
        ("distance", distance, eye.distance()),
        ("fov_y_deg", fov, eye.fov_y_deg()),
    ];
    let n_errors = sink.n_errors();
    for (name, given, taken) in taken {
        if given != taken {
            let span = fields.get(name).map_or_else(|| fields.span(), Item::span);
            let message = Message::new("problem-out-of-range").with("value", exact(given));
            sink.error(span, message, [Message::new("expect-eye")]);
        }
    }
    (sink.n_errors() == n_errors).then_some(eye)
}

/// As [`eye`] reads it.
pub(super) fn eye_to_toml(eye: &Orbit) -> String {
    let [yaw, pitch] = eye.angles_deg().map(exact);
    format!(
        "{{ target = {}, yaw_deg = {yaw}, pitch_deg = {pitch}, distance = {}, fov_y_deg = {} }}",
        array(&eye.target()),
        exact(eye.distance()),
        exact(eye.fov_y_deg()),
    )
}

/// An eye from which all of a camera's volume is seen, where a file does not say where it stands.
pub(super) fn watching(camera: &TaughtCamera) -> Orbit {
    /// A long lens; at this many times its radius all of a ball is in its picture.
    const FOV_DEG: f64 = 28.0;
    const RADII: f64 = 4.5;
    let corners = camera.camera().corners_in_world().map(DVec3::from);
    let [position, ..] = camera.places();
    let all = corners.into_iter().chain([DVec3::from(position)]);
    let middle = all.clone().sum::<DVec3>() / 9.0;
    let radius = all.map(|p| p.distance(middle)).fold(0.0, f64::max);
    Orbit::new(middle.into(), [-55.0, 22.0], RADII * radius, FOV_DEG)
}
