//! A scene of the polygons lab as files spell it.

use crate::{
    geom::{Polygon, Window},
    input::{CLIP, POLYGON, WINDOW},
    labs::polygons::{
        LAB, MAX_VERTICES, Method, Panels, Scene, SceneError, Texture, random_polygon,
    },
};

use super::prelude::*;

pub(super) static FORMAT: SceneFormat = SceneFormat {
    lab: LAB,
    fields: &[
        "method", "compare", "window", "clip", "polygon", "holes", "random", "texture", "panels",
    ],
    own_field: "polygon",
    room: 10 * MAX_VERTICES,
    read: scene,
    write: |scene| scene.get().map(to_toml),
};

fn scene(fields: &TomlFields<'_>, vertices_left: &mut usize) -> Option<labs::Scene> {
    let n_errors = fields.sink.n_errors();
    let method = fields.require("method").and_then(polygon_method);
    let compare = fields.get("compare").and_then(polygon_method);
    let window = fields.need(&WINDOW);
    let clip = fields.part(&CLIP);
    let subject = subject(fields, window.as_ref());
    let holes = fields.get("holes");
    let holes = holes.and_then(|node| node.each("expect-holes", |node| node.made(&POLYGON)));
    let texture = fields.get("texture");
    let texture = texture.and_then(|node| node.value(Texture::ALL, Texture::id));
    let panels = fields.get("panels");
    let panels = panels.and_then(|node| node.value(Panels::ALL, Panels::id));
    let mut scene = Scene::new(method?, window?, subject?);
    (scene.compare, scene.clip) = (compare, clip);
    scene.holes = holes.unwrap_or_default();
    scene.texture = texture.unwrap_or_default();
    scene.panels = panels.unwrap_or_default();
    let n_vertices = scene.n_vertices();
    if n_vertices > MAX_VERTICES.min(*vertices_left) {
        let error = SceneError::TooManyVertices(n_vertices);
        fields.sink.error(fields.span.clone(), error, []);
    } else {
        *vertices_left -= n_vertices;
    }
    (fields.sink.n_errors() == n_errors).then(|| scene.into())
}

fn polygon_method(node: Node<'_>) -> Option<Method> {
    Method::by_id(method(LAB, node)?)
}

/// Listed or random: one of the two.
fn subject(fields: &TomlFields<'_>, window: Option<&Window>) -> Option<Polygon> {
    match (fields.get("polygon"), fields.get("random")) {
        (Some(_), Some(random)) => {
            random.error(Message::new("problem-two-kinds-of-polygons"), []);
            None
        }
        (None, Some(node)) => {
            let (count, seed) = count_and_seed(node, 3..MAX_VERTICES as u64 + 1)?;
            random_polygon(window?, count, seed).ok()
        }
        _ => fields.need(&POLYGON),
    }
}

fn to_toml(scene: &Scene) -> String {
    let compare = scene.compare.map(|method| quoted(method.card().id));
    let clip = scene.clip.as_ref();
    let has_texture = scene.texture != Texture::None;
    let has_panels = scene.panels != Panels::None;
    let holes: Vec<String> = scene.holes.iter().map(|h| points(h.vertices())).collect();
    lines([
        ("method", Some(quoted(scene.method.card().id))),
        ("compare", compare),
        ("window", Some(array(&scene.window.to_array()))),
        ("clip", clip.map(|clip| points(clip.vertices()))),
        ("texture", has_texture.then(|| quoted(scene.texture.id()))),
        ("panels", has_panels.then(|| quoted(scene.panels.id()))),
        ("polygon", Some(points(scene.subject.vertices()))),
        (
            "holes",
            (!holes.is_empty()).then(|| list(&holes, usize::MAX)),
        ),
    ])
}
