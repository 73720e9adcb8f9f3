//! The objects of a scene as files spell them: a solid by its name, or a mesh with all its numbers.

use std::{fmt::Write as _, sync::Arc};

use base64::{Engine, prelude::BASE64_STANDARD as BASE64};

use crate::{
    geom::{Mesh, MeshError, Solid, SpaceError, Texture, is_part},
    input::Fault,
    labs::space::{Model, NamedMesh, Object, Picture},
    lesson::{FileError, picture_of, prelude::*, read_obj, read_picture, scene_file::prelude::*},
};

use super::spot;

const OBJECT: [&str; 6] = ["solid", "mesh", "at", "turn_deg", "size", OPACITY.name()];

/// How much an object covers of what is behind it.
const OPACITY: Part<f64> = Part::new("opacity", &Shape::Number, |got| {
    let opacity = got.number();
    let problem = || Message::new("problem-out-of-range").with("value", exact(opacity));
    is_part(opacity)
        .then_some(opacity)
        .ok_or_else(|| Fault::new("out-of-range", problem()))
})
.expecting("expect-opacity");
const MESH: [&str; 6] = ["name", "vertices", "uvs", "faces", "obj", "picture"];

/// A mesh of more faces, or vertices, is not spelt number by number, but as the text of an OBJ file: that takes a tenth of
/// the memory to read.
const MAX_INLINE: usize = 10_000;

pub(super) fn object(node: Node<'_>) -> Option<Object> {
    let fields = node.fields(&OBJECT)?;
    let model = model(&fields);
    let place = |name| match fields.get(name) {
        Some(node) => Some(node.got(&Shape::PLACE, "expect-place")?.array()),
        None => Some([0.0; 3]),
    };
    let (at, turn_deg) = (place("at"), place("turn_deg"));
    let size = fields.get("size");
    let size = size.map_or(Some(1.0), |node| node.number("expect-number"));
    let object = Object::new(model?, at?, turn_deg?, size?);
    let refuse = |error| {
        let name = match error {
            SpaceError::Size(_) => "size",
            _ => "at",
        };
        node.at(At::Field(name)).error(error, []);
    };
    let opacity = fields.part(&OPACITY);
    object
        .map_err(refuse)
        .ok()?
        .with_opacity(opacity.unwrap_or(1.0))
}

/// What it looks like: `solid` or `mesh`.
fn model(fields: &TomlFields<'_>) -> Option<Model> {
    match (fields.get("solid"), fields.get("mesh")) {
        (Some(_), Some(mesh)) => {
            mesh.error(Message::new("problem-two-models"), []);
            None
        }
        (None, Some(node)) => {
            let mesh = match node.value_of().as_str() {
                Some(name) => mesh_beside(node, name),
                None => mesh(node).map(Arc::new),
            };
            Some(Model::Mesh(mesh?))
        }
        _ => {
            let mut known: Vec<&str> = Solid::ALL.map(Solid::id).to_vec();
            known.push(spot::ID);
            let node = fields.require("solid")?;
            node.one_of(&known, "problem-unknown-value", |name| {
                let solid = Solid::ALL.into_iter().find(|solid| solid.id() == name);
                let spot = || (name == spot::ID).then(spot::model);
                solid.map(Model::Solid).or_else(spot)
            })
        }
    }
}

/// The pictures of a file's meshes may have so many texels together: as many as the largest one.
const MAX_TEXELS: usize = Texture::MAX_SIDE * Texture::MAX_SIDE;

/// The mesh of an OBJ file in the lesson's folder, which is read once.
fn mesh_beside(node: Node<'_>, name: &str) -> Option<Arc<NamedMesh>> {
    let known = &node.sink.source.beside.meshes;
    if let Some(known) = known.borrow().get(name) {
        return known.clone();
    }
    let read = read_beside(node, name).map(Arc::new);
    known.borrow_mut().insert(name.to_owned(), read.clone());
    read
}

/// It is put around the origin and between −1 and 1.
fn read_beside(node: Node<'_>, name: &str) -> Option<NamedMesh> {
    let source = node.sink.source;
    let stem = name.strip_suffix(".obj");
    let stem = stem.filter(|_| !name.contains(['/', '\\']));
    let expected = || [Message::new("expect-mesh-file")];
    let found = stem.and_then(|stem| Some((stem, source.beside(name)?)));
    let Some((stem, (path, bytes))) = found else {
        let message = Message::new("problem-no-such-mesh").with("name", clipped(name));
        node.error(message, expected());
        return None;
    };
    let bytes = bytes.map_err(|error| node.error(error, expected())).ok()?;
    let read = read_obj(&path, &bytes).map_err(|problems| node.sink.report(problems));
    let read = read.ok()?;
    node.sink.report(read.warnings);
    let picture = read.material.as_ref().map(|it| picture_beside(node, it));
    Some(NamedMesh {
        name: stem.to_owned(),
        mesh: read.mesh.fitted(),
        picture: picture.flatten(),
    })
}

/// The picture of a mesh's material. Without it the mesh is drawn all the same, and that is said.
fn picture_beside(node: Node<'_>, material: &[String; 2]) -> Option<Picture> {
    let source = node.sink.source;
    let read = |name: &str| {
        let found = source.beside(name);
        found.map_or(Err(FileError::NOT_FOUND), |(_, bytes)| bytes)
    };
    let known = |name: &str| source.beside.pictures.borrow().get(name).cloned();
    let (name, picture) = match picture_of(material, &read, &known) {
        Ok(found) => found?,
        Err(fault) => {
            let plain = Diagnostic::new(Message::new("problem-mesh-plain"));
            let fault = Diagnostic::from(fault).message;
            node.sink.warning(node.span(), plain.noting(fault));
            return None;
        }
    };
    let mut pictures = source.beside.pictures.borrow_mut();
    pictures.insert(name, picture.clone());
    drop(pictures);
    let n_texels = source.beside.n_texels();
    if n_texels > MAX_TEXELS {
        let message = Message::new("problem-too-many-texels").with("count", n_texels);
        node.error(message.with("limit", MAX_TEXELS), []);
        return None;
    }
    Some(picture)
}

fn mesh(node: Node<'_>) -> Option<NamedMesh> {
    let fields = node.fields(&MESH)?;
    let name = fields.require("name").and_then(Node::text);
    let picture = match fields.get("picture") {
        Some(node) => Some(picture(node)?),
        None => None,
    };
    let mesh = match fields.get("obj") {
        Some(node) => obj(node, &fields),
        None => listed(node, &fields),
    };
    Some(NamedMesh {
        name: name?.to_owned(),
        mesh: mesh?,
        picture,
    })
}

/// A PNG or a JPEG file, in base64.
fn picture(node: Node<'_>) -> Option<Picture> {
    let bytes = BASE64.decode(node.text()?);
    let picture = bytes.ok().and_then(|bytes| read_picture(&bytes));
    if picture.is_none() {
        let expected = [Message::new("expect-picture")];
        node.error(Message::new("problem-no-picture"), expected);
    }
    picture
}

/// The text of an OBJ file, whose vertices stay where they are.
fn obj(node: Node<'_>, fields: &TomlFields<'_>) -> Option<Mesh> {
    let mut others = ["vertices", "uvs", "faces"].into_iter();
    if let Some(other) = others.find_map(|name| fields.get(name)) {
        other.error(Message::new("problem-two-meshes"), []);
        return None;
    }
    let read = read_obj("obj", node.text()?.as_bytes());
    let read = read.map_err(|problems| node.sink.report(problems));
    Some(read.ok()?.mesh)
}

fn listed(node: Node<'_>, fields: &TomlFields<'_>) -> Option<Mesh> {
    const VERTICES: Shape = Shape::Numbers(&[Dim::ANY, Dim::Exactly(3)]);
    const FACES: Shape = Shape::Wholes(&[Dim::ANY, Dim::Exactly(3)], 0, MAX_INLINE as i64 - 1);
    let positions = listed_rows(fields, "vertices", &VERTICES);
    let uvs = match fields.get("uvs") {
        None => Some(Got::Numbers(Vec::new())),
        Some(_) => listed_rows(fields, "uvs", &Shape::POINTS),
    };
    let faces = listed_rows(fields, "faces", &FACES);
    let (positions, uvs, faces) = (positions?, uvs?, faces?);
    let positions = positions.rows().iter();
    let positions = positions.map(|at: &[f64; 3]| at.map(|x| x as f32));
    let uvs = uvs.rows().iter().map(|uv: &[f64; 2]| uv.map(|x| x as f32));
    let faces = faces.whole_rows().iter();
    let faces = faces.map(|face: &[i64; 3]| face.map(|i| i as u32));
    let made = Mesh::new(positions.collect(), uvs.collect(), faces.collect());
    let refuse = |error| {
        let (list, at) = match error {
            MeshError::NotFinite { vertex_idx } => ("vertices", At::Entry(vertex_idx)),
            MeshError::NoSuchVertex { face_idx } => ("faces", At::Entry(face_idx)),
            MeshError::NoFaces => ("faces", At::Whole),
            MeshError::UvLength { .. } => ("uvs", At::Whole),
        };
        let place = fields.get(list).map_or(node, |list| list.at(at));
        place.error(error, [Message::new("expect-mesh")]);
    };
    made.map_err(refuse).ok()
}

/// A list of a mesh, as far as a file may hold it.
fn listed_rows(fields: &TomlFields<'_>, name: &'static str, shape: &Shape) -> Option<Got> {
    let node = fields.require(name)?;
    let n_rows = node.entries().map_or(0, |rows| rows.len());
    if n_rows > MAX_INLINE {
        let message = Message::new("problem-mesh-too-large").with("count", n_rows);
        node.error(message.with("limit", MAX_INLINE), []);
        return None;
    }
    node.got(shape, "expect-mesh")
}

enum Spelling<'a> {
    Named(&'static str),
    Listed(&'a NamedMesh),
    Obj(&'a NamedMesh),
}

fn spelling(model: &Model) -> Spelling<'_> {
    match model {
        Model::Solid(solid) => Spelling::Named(solid.id()),
        Model::Mesh(_) if *model == spot::model() || spot::stands_in(model) => {
            Spelling::Named(spot::ID)
        }
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

pub(super) fn object_to_toml(object: &Object) -> String {
    let model = match spelling(object.model()) {
        Spelling::Named(id) => ("solid", Some(quoted(id))),
        Spelling::Listed(named) => ("mesh", Some(mesh_to_toml(named, lists(&named.mesh)))),
        Spelling::Obj(named) => {
            let obj = format!("'''\n{}'''", obj_text(&named.mesh));
            ("mesh", Some(mesh_to_toml(named, [("obj", Some(obj))])))
        }
    };
    table([
        model,
        ("at", Some(array(&object.at()))),
        ("turn_deg", Some(array(&object.turn_deg()))),
        ("size", Some(exact(object.size()))),
        (
            "opacity",
            Some(exact(object.opacity())).filter(|_| object.opacity() != 1.0),
        ),
    ])
}

/// `surface` is spelt in one of two ways.
fn mesh_to_toml(named: &NamedMesh, surface: impl IntoIterator<Item = Spelt>) -> String {
    let picture = named.picture.as_ref();
    let picture = picture.map(|picture| quoted(&BASE64.encode(&picture.file)));
    let name = ("name", Some(quoted(&named.name)));
    let fields = [name].into_iter().chain(surface);
    table(fields.chain([("picture", picture)]))
}

fn lists(mesh: &Mesh) -> [Spelt; 3] {
    let faces = mesh.faces().iter().map(|face| format!("{face:?}"));
    let (vertices, uvs) = (mesh.positions().iter(), mesh.uvs().iter());
    let vertices = rows(vertices.map(|at| at.map(f64::from)));
    let uvs = rows(uvs.map(|uv| uv.map(f64::from)));
    let spelt = |entries: Vec<String>| Some(list(&entries, usize::MAX));
    [
        ("vertices", spelt(vertices)),
        ("uvs", spelt(uvs).filter(|_| !mesh.uvs().is_empty())),
        ("faces", spelt(faces.collect())),
    ]
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
