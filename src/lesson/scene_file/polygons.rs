//! A scene of the polygons lab as files spell it.

use std::fmt::Write as _;

use crate::{
    geom::{Polygon, Window},
    input::{CLIP, POLYGON, WINDOW},
    labs::{
        self, Lab,
        polygons::{LAB, MAX_VERTICES, Method, Scene, SceneError, Texture, random_polygon},
    },
    lesson::{
        sink::Sink,
        toml_fields::{Item, TomlFields, each, made, one_of},
    },
    text::Message,
};

use super::{
    format::SceneFormat,
    parts::{count_and_seed, head, method, points},
};

/// The fields of a scene.
const FIELDS: [&str; 8] = [
    "method", "compare", "window", "clip", "polygon", "holes", "random", "texture",
];

/// The spelling of this lab's scenes.
pub(super) struct Format;

impl SceneFormat for Format {
    fn lab(&self) -> &'static dyn Lab {
        LAB
    }

    fn fields(&self) -> &'static [&'static str] {
        &FIELDS
    }

    fn own_field(&self) -> &'static str {
        "polygon"
    }

    fn room(&self) -> usize {
        10 * MAX_VERTICES
    }

    fn read(
        &self,
        fields: &TomlFields<'_>,
        room: &mut usize,
        sink: &mut Sink<'_>,
    ) -> Option<labs::Scene> {
        scene(fields, room, sink).map(labs::Scene::from)
    }

    fn write(&self, scene: &labs::Scene) -> Option<String> {
        scene.get().map(to_toml)
    }
}

/// Reads a scene; `vertices_left` is how many a file may still have.
fn scene(fields: &TomlFields<'_>, vertices_left: &mut usize, sink: &mut Sink<'_>) -> Option<Scene> {
    let n_errors = sink.n_errors();
    let method = fields
        .require("method", sink)
        .and_then(|item| polygon_method(item, sink));
    let compare = fields
        .get("compare")
        .and_then(|item| polygon_method(item, sink));
    let window = fields.need(&WINDOW, sink);
    let clip = fields.part(&CLIP, sink);
    let subject = subject(fields, window.as_ref(), sink);
    let holes = fields.get("holes").and_then(|item| {
        each(item, "expect-holes", sink, |item, sink| {
            made(item, &POLYGON, sink)
        })
    });
    let texture = fields.get("texture").and_then(|item| {
        let known = Texture::ALL.map(Texture::id);
        one_of(item, &known, "problem-unknown-value", sink, |name| {
            Texture::ALL.into_iter().find(|t| t.id() == name)
        })
    });
    let mut scene = Scene::new(method?, window?, subject?);
    (scene.compare, scene.clip) = (compare, clip);
    scene.holes = holes.unwrap_or_default();
    scene.texture = texture.unwrap_or_default();
    let n_vertices = scene.n_vertices();
    if n_vertices > MAX_VERTICES.min(*vertices_left) {
        sink.refuse(fields.span(), SceneError::TooManyVertices(n_vertices), []);
    } else {
        *vertices_left -= n_vertices;
    }
    (sink.n_errors() == n_errors).then_some(scene)
}

fn polygon_method(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Method> {
    Method::by_id(method(LAB, item, sink)?)
}

/// The polygon of a scene, listed or random: one of the two.
fn subject(
    fields: &TomlFields<'_>,
    window: Option<&Window>,
    sink: &mut Sink<'_>,
) -> Option<Polygon> {
    match (fields.get("polygon"), fields.get("random")) {
        (Some(_), Some(random)) => {
            let message = Message::new("problem-two-kinds-of-polygons");
            sink.error(random.span(), message, []);
            None
        }
        (None, Some(item)) => random(item, window, sink),
        _ => fields.need(&POLYGON, sink),
    }
}

fn random(item: &Item<'_>, window: Option<&Window>, sink: &mut Sink<'_>) -> Option<Polygon> {
    let (count, seed) = count_and_seed(item, 3..MAX_VERTICES as u64 + 1, sink)?;
    random_polygon(window?, count, seed).ok()
}

/// Writes a scene.
fn to_toml(scene: &Scene) -> String {
    let compare = scene.compare.map(|method| method.card().id);
    let clip = scene.clip.as_ref().map(Polygon::vertices);
    let mut text = head(scene.method.card().id, compare, &scene.window, clip);
    if scene.texture != Texture::None {
        let _ = writeln!(text, "texture = \"{}\"", scene.texture.id());
    }
    let _ = writeln!(text, "polygon = {}", points(scene.subject.vertices()));
    if !scene.holes.is_empty() {
        let holes: Vec<String> = scene.holes.iter().map(|h| points(h.vertices())).collect();
        let _ = writeln!(text, "holes = [{}]", holes.join(", "));
    }
    text
}
