//! A scene of a lab in three dimensions as files spell it.

mod camera;
mod model;
mod raster;
pub mod spot;

use std::fmt::Write as _;

use crate::{
    geom::Solid,
    input::{CAMERA_IN_FILE, Dim, FROZEN, Shape},
    labs::{
        self, Lab,
        space::{
            MAX_OBJECTS, Method, Model, Object, Places, RasterPlan, Scene, SceneError, SpaceLab,
            TaughtCamera, street,
        },
    },
    lesson::{
        sink::Sink,
        toml_fields::{Item, TomlFields, each, got, list, made, whole},
    },
    text::{Diagnostic, Message},
};

use super::{
    format::SceneFormat,
    parts::{array, count_and_seed, method},
};

use camera::{camera_to_toml, eye, eye_to_toml, watching};
use model::{n_faces_listed, object, object_to_toml};
use raster::{RASTER, raster_to_toml};

/// The fields of a scene.
const FIELDS: [&str; 14] = [
    "method", "compare", "camera", "frozen", "eye", "point", "segment", "triangle", "raster",
    "objects", "street", "focus", "face", "vertex",
];

/// The spelling of a lab's scenes.
pub(in crate::lesson) struct Format(pub &'static SpaceLab<Scene>);

impl SceneFormat for Format {
    fn lab(&self) -> &'static dyn Lab {
        self.0
    }

    fn fields(&self) -> &'static [&'static str] {
        &FIELDS
    }

    fn own_field(&self) -> &'static str {
        "camera"
    }

    /// In objects, and in faces that the file lists.
    fn room(&self) -> usize {
        10 * MAX_OBJECTS
    }

    fn read(
        &self,
        fields: &TomlFields<'_>,
        room: &mut usize,
        sink: &mut Sink<'_>,
    ) -> Option<labs::Scene> {
        scene(self.0, fields, room, sink).map(labs::Scene::from)
    }

    fn write(&self, scene: &labs::Scene) -> Option<String> {
        let is_mine = scene.document().lab() == self.lab();
        scene.get().filter(|_| is_mine).map(to_toml)
    }
}

/// Reads a scene; `room` is how many objects and faces a file may still have.
fn scene(
    lab: &'static SpaceLab<Scene>,
    fields: &TomlFields<'_>,
    room: &mut usize,
    sink: &mut Sink<'_>,
) -> Option<Scene> {
    let n_errors = sink.n_errors();
    let method = fields
        .require("method", sink)
        .and_then(|item| method_of(lab, item, sink));
    let beside = match fields.get("compare") {
        Some(item) => beside(lab, item, sink),
        None => Some(Vec::new()),
    };
    let camera = fields.need(&CAMERA_IN_FILE, sink);
    let eye = match fields.get("eye") {
        Some(item) => eye(item, sink),
        None => camera.as_ref().map(watching),
    };
    let frozen = fields.part(&FROZEN, sink);
    let places = places(fields, sink);
    let raster = match fields.get("raster") {
        Some(item) => made(item, &RASTER, sink),
        None => Some(RasterPlan::default()),
    };
    let objects = objects(fields, camera.as_ref(), room, sink);
    let mut index = |name, most: usize| {
        let item = fields.get(name)?;
        Some((item, whole(item, 0..most as u64, sink)? as usize))
    };
    let focus = index("focus", MAX_OBJECTS);
    let [face, vertex] = ["face", "vertex"].map(|name| index(name, MAX_PARTS));
    let scene = Scene::new(method?, camera?, eye?, objects?);
    let mut scene = refused_at(fields.span(), scene, sink)?;
    (scene.beside, scene.frozen) = (beside?, frozen);
    (scene.places, scene.raster) = (places?, raster?);
    if let Some((item, focus)) = focus {
        refused_at(item.span(), scene.set_focus(focus), sink);
    }
    if let Some((item, face)) = face {
        refused_at(item.span(), scene.set_face(face), sink);
    }
    if let Some((item, vertex)) = vertex {
        refused_at(item.span(), scene.set_vertex(vertex), sink);
    }
    (sink.n_errors() == n_errors).then_some(scene)
}

const SEGMENT: Shape = Shape::Numbers(&[Dim::Exactly(2), Dim::Exactly(3)]);
const TRIANGLE: Shape = Shape::Numbers(&[Dim::Exactly(3), Dim::Exactly(3)]);

/// What is asked about besides objects.
fn places(fields: &TomlFields<'_>, sink: &mut Sink<'_>) -> Option<Places> {
    let mut places = Places::default();
    if let Some(item) = fields.get("point") {
        let point = got(item, &Shape::PLACE, "expect-place", sink)?.array();
        places = refused_at(item.span(), places.with_point(point), sink)?;
    }
    if let Some(item) = fields.get("segment") {
        let segment = got(item, &SEGMENT, "expect-space-segment", sink)?.matrix();
        places = refused_at(item.span(), places.with_segment(segment), sink)?;
    }
    if let Some(item) = fields.get("triangle") {
        let triangle = got(item, &TRIANGLE, "expect-space-triangle", sink)?.matrix();
        places = refused_at(item.span(), places.with_triangle(triangle), sink)?;
    }
    Some(places)
}

/// More faces and vertices than any mesh has.
const MAX_PARTS: usize = u32::MAX as usize;

/// What the scene refuses is told at this place.
fn refused_at<T>(
    span: std::ops::Range<usize>,
    made: Result<T, impl Into<Diagnostic>>,
    sink: &mut Sink<'_>,
) -> Option<T> {
    made.map_err(|error| sink.refuse(span, error, [])).ok()
}

fn method_of(
    lab: &'static SpaceLab<Scene>,
    item: &Item<'_>,
    sink: &mut Sink<'_>,
) -> Option<Method> {
    lab.method(method(lab, item, sink)?)
}

/// The method beside the first, or a list of as many as have room there.
fn beside(
    lab: &'static SpaceLab<Scene>,
    item: &Item<'_>,
    sink: &mut Sink<'_>,
) -> Option<Vec<Method>> {
    let Some(items) = item.get_ref().as_array() else {
        return Some(vec![method_of(lab, item, sink)?]);
    };
    if items.len() > lab.most_beside {
        let message = Message::new("problem-too-many-beside")
            .with("count", items.len())
            .with("most", lab.most_beside);
        sink.error(item.span(), message, []);
        return None;
    }
    each(item, "", sink, |item, sink| method_of(lab, item, sink))
}

/// The objects of a scene, listed or a street of boxes: one of the two; where neither is given, a cube that the camera looks at.
fn objects(
    fields: &TomlFields<'_>,
    camera: Option<&TaughtCamera>,
    room: &mut usize,
    sink: &mut Sink<'_>,
) -> Option<Vec<Object>> {
    let (span, objects) = match (fields.get("objects"), fields.get("street")) {
        (Some(_), Some(street)) => {
            sink.error(
                street.span(),
                Message::new("problem-two-kinds-of-objects"),
                [],
            );
            return None;
        }
        (None, Some(item)) => {
            let (count, seed) = count_and_seed(item, 1..MAX_OBJECTS as u64 + 1, sink)?;
            (item.span(), street(count, seed))
        }
        (Some(item), None) => (item.span(), listed(item, sink)?),
        (None, None) => {
            let [_, target, _] = camera?.places();
            let cube = Object::new(Model::Solid(Solid::Cube), target, [0.0; 3], 1.0);
            return Some(vec![cube.ok()?]);
        }
    };
    let n_faces: usize = objects.iter().map(n_faces_listed).sum();
    let size = objects.len() + n_faces;
    if size > *room {
        sink.refuse(span, SceneError::TooManyObjects(size), []);
        return None;
    }
    *room -= size;
    Some(objects)
}

fn listed(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Vec<Object>> {
    let items = list(item, "expect-objects", sink)?;
    if items.is_empty() || items.len() > MAX_OBJECTS {
        let error = match items.len() {
            0 => SceneError::NoObjects,
            n => SceneError::TooManyObjects(n),
        };
        sink.refuse(item.span(), error, [Message::new("expect-objects")]);
        return None;
    }
    each(item, "expect-objects", sink, object)
}

/// Writes what a file would not have by itself.
fn places_to_toml(places: &Places, text: &mut String) {
    let (usual, list) = (Places::default(), |rows: &[[f64; 3]]| {
        let rows: Vec<String> = rows.iter().map(|row| array(row)).collect();
        rows.join(", ")
    });
    if places.point() != usual.point() {
        let _ = writeln!(text, "point = {}", array(&places.point()));
    }
    if places.segment() != usual.segment() {
        let _ = writeln!(text, "segment = [{}]", list(&places.segment()));
    }
    if places.triangle() != usual.triangle() {
        let _ = writeln!(text, "triangle = [{}]", list(&places.triangle()));
    }
}

/// Writes a scene.
fn to_toml(scene: &Scene) -> String {
    let mut text = format!("method = \"{}\"\n", scene.method.card().id);
    let beside: Vec<String> = scene
        .beside
        .iter()
        .map(|method| format!("\"{}\"", method.card().id))
        .collect();
    let _ = match &beside[..] {
        [] => Ok(()),
        [one] => writeln!(text, "compare = {one}"),
        several => writeln!(text, "compare = [{}]", several.join(", ")),
    };
    let _ = writeln!(text, "camera = {}", camera_to_toml(&scene.camera));
    let _ = writeln!(text, "eye = {}", eye_to_toml(&scene.eye));
    if let Some(frozen) = &scene.frozen {
        let _ = writeln!(text, "frozen = {}", camera_to_toml(frozen));
    }
    places_to_toml(&scene.places, &mut text);
    if let Some(raster) = raster_to_toml(&scene.raster) {
        let _ = writeln!(text, "raster = {raster}");
    }
    if scene.focus() > 0 {
        let _ = writeln!(text, "focus = {}", scene.focus());
    }
    if scene.face() > 0 {
        let _ = writeln!(text, "face = {}", scene.face());
    }
    if scene.vertex() > 0 {
        let _ = writeln!(text, "vertex = {}", scene.vertex());
    }
    text.push_str("objects = [\n");
    for object in scene.objects() {
        let _ = writeln!(text, "    {},", object_to_toml(object));
    }
    text + "]\n"
}
