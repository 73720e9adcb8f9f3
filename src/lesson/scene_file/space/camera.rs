//! The camera of a scene as files spell it, and the eye that watches it.

use glam::DVec3;

use crate::{
    geom::Orbit,
    labs::space::{Opening, TaughtCamera},
    lesson::scene_file::prelude::*,
};

const EYE: Shape = Shape::Table(&Table {
    name_key: "object-eye",
    fields: &[
        Field::required("target", &Shape::PLACE),
        Field::required("yaw_deg", &Shape::Number),
        Field::required("pitch_deg", &Shape::Number),
        Field::required("distance", &Shape::Number),
        Field::required("fov_y_deg", &Shape::Number),
    ],
    both_key: "",
});

pub(super) fn camera_to_toml(camera: &TaughtCamera) -> String {
    let [position, target, up] = camera.places().map(|place| Some(array(&place)));
    let opening = match camera.opening() {
        Opening::FovY(degrees) => ("fov_y_deg", Some(exact(degrees))),
        Opening::Height(height) => ("height", Some(exact(height))),
    };
    let [near, far] = camera.depths().map(|depth| Some(exact(depth)));
    table([
        ("position", position),
        ("target", target),
        ("up", up),
        opening,
        ("aspect", Some(exact(camera.aspect()))),
        ("near", near),
        ("far", far),
    ])
}

/// An eye; a number that it cannot have is refused, where [`Orbit::new`] takes the nearest.
pub(super) fn eye(node: Node<'_>) -> Option<Orbit> {
    let got = node.got(&EYE, "expect-eye")?;
    let [yaw, pitch, distance, fov] =
        ["yaw_deg", "pitch_deg", "distance", "fov_y_deg"].map(|name| got.number_in(name));
    let eye = Orbit::new(got.get("target")?.array(), [yaw, pitch], distance, fov);
    let taken = [
        ("pitch_deg", pitch, eye.angles_deg()[1]),
        ("distance", distance, eye.distance()),
        ("fov_y_deg", fov, eye.fov_y_deg()),
    ];
    let n_errors = node.sink.n_errors();
    for (name, given, _) in taken.into_iter().filter(|(_, given, taken)| given != taken) {
        let message = Message::new("problem-out-of-range").with("value", exact(given));
        let field = node.at(At::Field(name));
        field.error(message, [Message::new("expect-eye")]);
    }
    (node.sink.n_errors() == n_errors).then_some(eye)
}

pub(super) fn eye_to_toml(eye: &Orbit) -> String {
    let [yaw, pitch] = eye.angles_deg().map(|angle| Some(exact(angle)));
    table([
        ("target", Some(array(&eye.target()))),
        ("yaw_deg", yaw),
        ("pitch_deg", pitch),
        ("distance", Some(exact(eye.distance()))),
        ("fov_y_deg", Some(exact(eye.fov_y_deg()))),
    ])
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
