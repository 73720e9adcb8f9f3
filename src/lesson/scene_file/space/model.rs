//! The objects of a scene as files spell them: a solid by its name, or a mesh with all its numbers.

use std::{fmt::Write as _, sync::Arc};

use base64::{Engine, prelude::BASE64_STANDARD as BASE64};

use crate::{
    geom::{Mesh, MeshError, Solid, SpaceError},
    input::{Dim, Got, Shape},
    labs::space::{Model, NamedMesh, Object, Picture},
    lesson::{
        picture_of, read_obj, read_picture,
        scene_file::parts::{array, exact, span_of},
        sink::{Sink, clipped},
        toml_fields::{Item, TomlFields, got, number, one_of, text},
    },
    text::Message,
};

use super::spot;

const OBJECT: [&str; 5] = ["solid", "mesh", "at", "turn_deg", "size"];
const MESH: [&str; 6] = ["name", "vertices", "uvs", "faces", "obj", "picture"];

/// A mesh of more faces, or vertices, is not spelt number by number, but as the text of an OBJ file: that takes a tenth of
/// the memory to read.
const MAX_INLINE: usize = 10_000;

/// An object.
pub(super) fn object(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Object> {
    let fields = TomlFields::of(item, &OBJECT, sink)?;
    let model = model(&fields, sink);
    let mut place = |name| match fields.get(name) {
        Some(item) => Some(got(item, &Shape::PLACE, "expect-place", sink)?.array()),
        None => Some([0.0; 3]),
    };
    let (at, turn_deg) = (place("at"), place("turn_deg"));
    let size = match fields.get("size") {
        Some(item) => number(item, "expect-number", sink),
        None => Some(1.0),
    };
    match Object::new(model?, at?, turn_deg?, size?) {
        Ok(object) => Some(object),
        Err(error) => {
            let name = match error {
                SpaceError::Size(_) => "size",
                _ => "at",
            };
            let span = fields.get(name).map_or_else(|| fields.span(), Item::span);
            sink.refuse(span, error, []);
            None
        }
    }
}

/// What it looks like: `solid` or `mesh`.
fn model(fields: &TomlFields<'_>, sink: &mut Sink<'_>) -> Option<Model> {
    match (fields.get("solid"), fields.get("mesh")) {
        (Some(_), Some(mesh)) => {
            sink.error(mesh.span(), Message::new("problem-two-models"), []);
            None
        }
        (None, Some(item)) => {
            let mesh = match item.get_ref().as_str() {
                Some(name) => mesh_beside(item, name, sink),
                None => mesh(item, sink),
            };
            Some(Model::Mesh(Arc::new(mesh?)))
        }
        _ => {
            let item = fields.require("solid", sink)?;
            let mut known: Vec<&str> = Solid::ALL.map(Solid::id).to_vec();
            known.push(spot::ID);
            one_of(item, &known, "problem-unknown-value", sink, |name| {
                let solid = Solid::ALL.into_iter().find(|solid| solid.id() == name);
                let spot = || (name == spot::ID).then(spot::model);
                solid.map(Model::Solid).or_else(spot)
            })
        }
    }
}

/// The mesh of an OBJ file in the lesson's folder, around the origin and between −1 and 1.
fn mesh_beside(item: &Item<'_>, name: &str, sink: &mut Sink<'_>) -> Option<NamedMesh> {
    let stem = name
        .strip_suffix(".obj")
        .filter(|_| !name.contains(['/', '\\']));
    let found = stem.and_then(|_| sink.source().beside(name));
    let Some((path, bytes)) = found else {
        let message = Message::new("problem-no-such-mesh").with("name", clipped(name));
        sink.error(item.span(), message, [Message::new("expect-mesh-file")]);
        return None;
    };
    let bytes = match bytes {
        Ok(bytes) => bytes,
        Err(error) => {
            sink.refuse(item.span(), error, [Message::new("expect-mesh-file")]);
            return None;
        }
    };
    match read_obj(&path, &bytes) {
        Ok(read) => {
            sink.report(read.warnings);
            let name = stem.unwrap_or_default().to_owned();
            let mesh = read.mesh.fitted();
            let picture = read.material.as_ref().and_then(|material| {
                let bytes = |name: &str| sink.source().beside(name)?.1.ok();
                picture_of(material, &bytes)
            });
            Some(NamedMesh {
                name,
                mesh,
                picture,
            })
        }
        Err(problems) => {
            sink.report(problems);
            None
        }
    }
}

fn mesh(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<NamedMesh> {
    let fields = TomlFields::of(item, &MESH, sink)?;
    let name = fields
        .require("name", sink)
        .and_then(|item| text(item, sink));
    let picture = match fields.get("picture") {
        Some(item) => Some(picture(item, sink)?),
        None => None,
    };
    let mesh = match fields.get("obj") {
        Some(item) => obj(item, &fields, sink),
        None => listed(&fields, sink),
    };
    Some(NamedMesh {
        name: name?.to_owned(),
        mesh: mesh?,
        picture,
    })
}

/// A PNG or a JPEG file, in base64.
fn picture(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Picture> {
    let bytes = BASE64.decode(text(item, sink)?);
    let picture = bytes.ok().and_then(|bytes| read_picture(&bytes));
    if picture.is_none() {
        let expected = [Message::new("expect-picture")];
        sink.error(item.span(), Message::new("problem-no-picture"), expected);
    }
    picture
}

/// The text of an OBJ file, whose vertices stay where they are.
fn obj(item: &Item<'_>, fields: &TomlFields<'_>, sink: &mut Sink<'_>) -> Option<Mesh> {
    for other in ["vertices", "uvs", "faces"] {
        if let Some(other) = fields.get(other) {
            sink.error(other.span(), Message::new("problem-two-meshes"), []);
            return None;
        }
    }
    match read_obj("obj", text(item, sink)?.as_bytes()) {
        Ok(read) => Some(read.mesh),
        Err(problems) => {
            sink.report(problems);
            None
        }
    }
}

/// All of its numbers in lists.
fn listed(fields: &TomlFields<'_>, sink: &mut Sink<'_>) -> Option<Mesh> {
    const VERTICES: Shape = Shape::Numbers(&[Dim::ANY, Dim::Exactly(3)]);
    const FACES: Shape = Shape::Wholes(&[Dim::ANY, Dim::Exactly(3)], 0, MAX_INLINE as i64 - 1);
    let positions = rows(fields, "vertices", &VERTICES, sink);
    let uvs = match fields.get("uvs") {
        None => Some(Got::Numbers(Vec::new())),
        Some(_) => rows(fields, "uvs", &Shape::POINTS, sink),
    };
    let faces = rows(fields, "faces", &FACES, sink);
    let (positions, uvs, faces) = (positions?, uvs?, faces?);
    let positions = positions
        .rows()
        .iter()
        .map(|at: &[f64; 3]| at.map(|x| x as f32));
    let uvs = uvs.rows().iter().map(|uv: &[f64; 2]| uv.map(|x| x as f32));
    let faces = faces
        .whole_rows()
        .iter()
        .map(|face: &[i64; 3]| face.map(|i| i as u32));
    let made = Mesh::new(positions.collect(), uvs.collect(), faces.collect());
    match made {
        Ok(mesh) => Some(mesh),
        Err(error) => {
            let (list, index) = match error {
                MeshError::NotFinite { vertex_idx } => ("vertices", Some(vertex_idx)),
                MeshError::NoSuchVertex { face_idx } => ("faces", Some(face_idx)),
                MeshError::NoFaces => ("faces", None),
                MeshError::UvLength { .. } => ("uvs", None),
            };
            let span = fields.get(list).map_or_else(
                || fields.span(),
                |item| index.map_or_else(|| item.span(), |i| span_of(item, i)),
            );
            sink.refuse(span, error, [Message::new("expect-mesh")]);
            None
        }
    }
}

/// A list of a mesh, as far as a file may hold it.
fn rows(
    fields: &TomlFields<'_>,
    name: &'static str,
    shape: &Shape,
    sink: &mut Sink<'_>,
) -> Option<Got> {
    let item = fields.require(name, sink)?;
    let n_rows = item.get_ref().as_array().map_or(0, |rows| rows.len());
    if n_rows > MAX_INLINE {
        let message = Message::new("problem-mesh-too-large")
            .with("count", n_rows)
            .with("limit", MAX_INLINE);
        sink.error(item.span(), message, []);
        return None;
    }
    got(item, shape, "expect-mesh", sink)
}

/// How a model is spelt.
enum Spelling<'a> {
    /// By its name.
    Named(&'static str),
    /// With all its numbers, in lists.
    Listed(&'a NamedMesh),
    /// As the text of an OBJ file.
    Obj(&'a NamedMesh),
}

fn spelling(model: &Model) -> Spelling<'_> {
    match model {
        Model::Solid(solid) => Spelling::Named(solid.id()),
        Model::Mesh(_) if *model == spot::model() => Spelling::Named(spot::ID),
        Model::Mesh(named) => {
            let mesh = &named.mesh;
            if mesh.faces().len().max(mesh.positions().len()) > MAX_INLINE {
                Spelling::Obj(named)
            } else {
                Spelling::Listed(named)
            }
        }
    }
}

/// How many faces the file lists of it.
pub(super) fn n_faces_listed(object: &Object) -> usize {
    match spelling(object.model()) {
        Spelling::Named(_) | Spelling::Obj(_) => 0,
        Spelling::Listed(named) => named.mesh.faces().len(),
    }
}

/// As [`object`] reads it.
pub(super) fn object_to_toml(object: &Object) -> String {
    let model = match spelling(object.model()) {
        Spelling::Named(id) => format!("solid = \"{id}\""),
        Spelling::Listed(named) => mesh_to_toml(named, &lists(&named.mesh)),
        Spelling::Obj(named) => {
            let obj = format!("obj = '''\n{}'''", obj_text(&named.mesh));
            mesh_to_toml(named, &obj)
        }
    };
    format!(
        "{{ {model}, at = {}, turn_deg = {}, size = {} }}",
        array(&object.at()),
        array(&object.turn_deg()),
        exact(object.size()),
    )
}

/// `numbers` are those of its surface.
fn mesh_to_toml(named: &NamedMesh, numbers: &str) -> String {
    let mut text = format!("mesh = {{ name = {}, {numbers}", quoted(&named.name));
    if let Some(picture) = &named.picture {
        let _ = write!(text, ", picture = \"{}\"", BASE64.encode(&picture.file));
    }
    text + " }"
}

fn lists(mesh: &Mesh) -> String {
    fn list(name: &str, rows: impl Iterator<Item = String>) -> String {
        format!("{name} = [{}]", rows.collect::<Vec<_>>().join(", "))
    }
    let exactly = |row: &[f32]| array(&row.iter().map(|&x| x.into()).collect::<Vec<f64>>());
    let mut parts = vec![list(
        "vertices",
        mesh.positions().iter().map(|p| exactly(p)),
    )];
    if !mesh.uvs().is_empty() {
        parts.push(list("uvs", mesh.uvs().iter().map(|uv| exactly(uv))));
    }
    let faces = mesh.faces().iter().map(|face| format!("{face:?}"));
    parts.push(list("faces", faces));
    parts.join(", ")
}

/// Vertices and texture coordinates have the same numbers, from 1.
fn obj_text(mesh: &Mesh) -> String {
    let mut text = String::new();
    for [x, y, z] in mesh.positions() {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for [u, v] in mesh.uvs() {
        let _ = writeln!(text, "vt {u} {v}");
    }
    for face in mesh.faces() {
        let [a, b, c] = face.map(|i| i + 1);
        let _ = match mesh.uvs() {
            [] => writeln!(text, "f {a} {b} {c}"),
            _ => writeln!(text, "f {a}/{a} {b}/{b} {c}/{c}"),
        };
    }
    text
}

/// A text in quotes.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
