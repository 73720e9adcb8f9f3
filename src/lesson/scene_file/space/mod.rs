//! A scene of a lab in three dimensions as files spell it.

mod camera;
mod model;
mod raster;
pub mod spot;

use crate::{
    geom::Solid,
    input::{CAMERA_IN_FILE, FROZEN},
    labs::space::{
        MAX_OBJECTS, Method, Model, Object, Part, Places, RasterPlan, Scene, SceneError, SpaceLab,
        TaughtCamera, street,
    },
};

use super::prelude::*;

use camera::{camera_to_toml, eye, eye_to_toml, watching};
use model::{n_faces_listed, object, object_to_toml};
use raster::{RASTER, raster_to_toml};

pub(super) const fn format(
    lab: &'static SpaceLab,
    read: fn(&TomlFields<'_>, &mut usize) -> Option<labs::Scene>,
) -> SceneFormat {
    SceneFormat {
        lab: &lab.lab,
        fields: &[
            "method", "compare", "camera", "frozen", "eye", "point", "segment", "triangle",
            "raster", "objects", "street", "focus", "face", "vertex",
        ],
        own_field: "camera",
        // In objects, and in faces that the file lists.
        room: 10 * MAX_OBJECTS,
        read,
        write: |scene| scene.get().map(to_toml),
    }
}

pub(super) fn scene(
    lab: &'static SpaceLab,
    fields: &TomlFields<'_>,
    room: &mut usize,
) -> Option<labs::Scene> {
    let n_errors = fields.sink.n_errors();
    let method = fields.require("method");
    let method = method.and_then(|node| method_of(lab, node));
    let beside = fields.get("compare");
    let beside = beside.map_or(Some(Vec::new()), |node| beside_of(lab, node));
    let camera = fields.need(&CAMERA_IN_FILE);
    let eye = match fields.get("eye") {
        Some(node) => eye(node),
        None => camera.as_ref().map(watching),
    };
    let frozen = fields.part(&FROZEN);
    let places = places(fields);
    let raster = fields.get("raster");
    let raster = raster.map_or(Some(RasterPlan::default()), |node| node.made(&RASTER));
    let objects = objects(fields, camera.as_ref(), room);
    let index = |name, most: usize| {
        let node = fields.get(name)?;
        Some((node, node.whole(0..most as u64)? as usize))
    };
    let focus = index("focus", MAX_OBJECTS);
    let [face, vertex] = ["face", "vertex"].map(|name| index(name, MAX_PARTS));
    let scene = Scene::new(method?, camera?, eye?, objects?);
    let refuse = |error| fields.sink.error(fields.span.clone(), error, []);
    let mut scene = scene.map_err(refuse).ok()?;
    (scene.beside, scene.frozen) = (beside?, frozen);
    scene.raster = raster?;
    scene.set_places(places?).ok()?;
    let parts = [
        (Part::Object, focus),
        (Part::Face, face),
        (Part::Vertex, vertex),
    ];
    for (part, index) in parts {
        if let Some((node, index)) = index {
            node.accept(scene.look_at(part, index));
        }
    }
    (fields.sink.n_errors() == n_errors).then(|| scene.into())
}

const SEGMENT: Shape = Shape::Numbers(&[Dim::Exactly(2), Dim::Exactly(3)]);
const TRIANGLE: Shape = Shape::Numbers(&[Dim::Exactly(3), Dim::Exactly(3)]);

/// What is asked about besides objects.
fn places(fields: &TomlFields<'_>) -> Option<Places> {
    let mut places = Places::default();
    if let Some(node) = fields.get("point") {
        let point = node.got(&Shape::PLACE, "expect-place")?.array();
        places = node.accept(Places { point, ..places }.checked())?;
    }
    if let Some(node) = fields.get("segment") {
        let segment = node.got(&SEGMENT, "expect-space-segment")?.matrix();
        places = node.accept(Places { segment, ..places }.checked())?;
    }
    if let Some(node) = fields.get("triangle") {
        let triangle = node.got(&TRIANGLE, "expect-space-triangle")?.matrix();
        places = node.accept(Places { triangle, ..places }.checked())?;
    }
    Some(places)
}

/// More faces and vertices than any mesh has.
const MAX_PARTS: usize = u32::MAX as usize;

fn method_of(lab: &'static SpaceLab, node: Node<'_>) -> Option<Method> {
    lab.method(method(&lab.lab, node)?)
}

/// The method beside the first, or a list of as many as have room there.
fn beside_of(lab: &'static SpaceLab, node: Node<'_>) -> Option<Vec<Method>> {
    let Some(entries) = node.entries() else {
        return Some(vec![method_of(lab, node)?]);
    };
    let count = entries.len();
    if count > lab.most_beside {
        let message = Message::new("problem-too-many-beside").with("count", count);
        node.error(message.with("most", lab.most_beside), []);
        return None;
    }
    node.each("", |node| method_of(lab, node))
}

/// The objects of a scene, listed or a street of boxes: one of the two; where neither is given, a cube that the camera looks at.
fn objects(
    fields: &TomlFields<'_>,
    camera: Option<&TaughtCamera>,
    room: &mut usize,
) -> Option<Vec<Object>> {
    let (node, objects) = match (fields.get("objects"), fields.get("street")) {
        (Some(_), Some(street)) => {
            street.error(Message::new("problem-two-kinds-of-objects"), []);
            return None;
        }
        (None, Some(node)) => {
            let (count, seed) = count_and_seed(node, 1..MAX_OBJECTS as u64 + 1)?;
            (node, street(count, seed))
        }
        (Some(node), None) => (node, listed(node)?),
        (None, None) => {
            let [_, target, _] = camera?.places();
            let cube = Object::new(Model::Solid(Solid::Cube), target, [0.0; 3], 1.0);
            return Some(vec![cube.ok()?]);
        }
    };
    let n_faces: usize = objects.iter().map(n_faces_listed).sum();
    let size = objects.len() + n_faces;
    if size > *room {
        node.error(SceneError::TooManyObjects(size), []);
        return None;
    }
    *room -= size;
    Some(objects)
}

fn listed(node: Node<'_>) -> Option<Vec<Object>> {
    let error = match node.list("expect-objects")?.len() {
        0 => SceneError::NoObjects,
        1..=MAX_OBJECTS => return node.each("expect-objects", object),
        n => SceneError::TooManyObjects(n),
    };
    node.error(error, [Message::new("expect-objects")]);
    None
}

fn to_toml(scene: &Scene) -> String {
    let ids = scene.beside.iter().map(|method| quoted(method.card().id));
    let beside = match &ids.collect::<Vec<_>>()[..] {
        [] => None,
        [one] => Some(one.clone()),
        several => Some(list(several, usize::MAX)),
    };
    let (places, usual) = (scene.places(), Places::default());
    let point = (places.point != usual.point).then(|| array(&places.point));
    let moved = places.segment != usual.segment;
    let segment = moved.then(|| list(&rows(places.segment), 2));
    let moved = places.triangle != usual.triangle;
    let triangle = moved.then(|| list(&rows(places.triangle), 3));
    let objects: Vec<String> = scene.objects().iter().map(object_to_toml).collect();
    lines([
        ("method", Some(quoted(scene.method.card().id))),
        ("compare", beside),
        ("camera", Some(camera_to_toml(&scene.camera))),
        ("eye", Some(eye_to_toml(&scene.eye))),
        ("frozen", scene.frozen.as_ref().map(camera_to_toml)),
        ("point", point),
        ("segment", segment),
        ("triangle", triangle),
        ("raster", raster_to_toml(&scene.raster)),
        ("focus", counted(scene.focus())),
        ("face", counted(scene.face())),
        ("vertex", counted(scene.vertex())),
        ("objects", Some(list(&objects, 0))),
    ])
}
