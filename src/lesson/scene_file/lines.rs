//! A scene of the lines lab as files spell it.

use crate::{
    algo::line::BitOrder,
    geom::{Segment, Window},
    input::{BIT_ORDER, CONVEX_CLIP, WINDOW},
    labs::lines::{LAB, MAX_SEGMENTS, Method, Scene, SceneError, random_segments},
};

use super::prelude::*;

const SEGMENTS: Part<Vec<Segment>> = Part::new(
    "segments",
    &Shape::Numbers(&[Dim::ANY, Dim::Exactly(4)]),
    |got| {
        let segments = got.rows().iter().map(|&ends| Segment::try_from(ends));
        Ok(segments.collect::<Result<_, _>>()?)
    },
)
.expecting("expect-segments");

const MISTAKEN: Part<Segment> = Part::new("mistaken", &Shape::Numbers(&[Dim::Exactly(4)]), |got| {
    Ok(Segment::try_from(got.array())?)
})
.expecting("expect-segment");

pub(super) static FORMAT: SceneFormat = SceneFormat {
    lab: LAB,
    fields: &[
        "method",
        "compare",
        "window",
        "clip",
        "bit_order",
        "segments",
        "mistaken",
        "random",
        "focus",
    ],
    own_field: "segments",
    room: MAX_SEGMENTS,
    read: scene,
    write: |scene| scene.get().map(to_toml),
};

fn scene(fields: &TomlFields<'_>, segments_left: &mut usize) -> Option<labs::Scene> {
    let n_errors = fields.sink.n_errors();
    let method = fields.require("method").and_then(line_method);
    let compare = fields.get("compare").and_then(line_method);
    let window = fields.need(&WINDOW);
    let clip = fields.part(&CONVEX_CLIP);
    let bit_order = fields.part(&BIT_ORDER);
    let segments = segments(fields, window.as_ref(), *segments_left);
    let focus = fields.get("focus").and_then(|node| {
        let focus = node.whole(0..MAX_SEGMENTS as u64)? as usize;
        let n_segments = segments.as_ref()?.len();
        if focus >= n_segments {
            node.error(SceneError::NoSuchFocus { focus, n_segments }, []);
        }
        Some(focus)
    });
    let segments = segments?;
    *segments_left -= segments.len();
    let mut scene = Scene::new(method?, window?, segments).ok()?;
    (scene.compare, scene.clip) = (compare, clip);
    scene.bit_order = bit_order.unwrap_or_default();
    scene.mistaken = fields.part(&MISTAKEN);
    scene.set_focus(focus.unwrap_or(0));
    (fields.sink.n_errors() == n_errors).then(|| scene.into())
}

fn line_method(node: Node<'_>) -> Option<Method> {
    Method::by_id(method(LAB, node)?)
}

/// Listed or random: one of the two.
fn segments(fields: &TomlFields<'_>, window: Option<&Window>, most: usize) -> Option<Vec<Segment>> {
    match (fields.get("segments"), fields.get("random")) {
        (Some(_), Some(random)) => {
            random.error(Message::new("problem-two-kinds-of-segments"), []);
            None
        }
        (Some(node), None) => listed(node, most),
        (None, Some(node)) => random(node, window, most),
        (None, None) => {
            if !fields.is_misspelt("segments") && !fields.is_misspelt("random") {
                fields.missing("segments", [Message::new("expect-segments")]);
            }
            None
        }
    }
}

fn listed(node: Node<'_>, most: usize) -> Option<Vec<Segment>> {
    let mut entries = node.list("expect-segments")?;
    let error = match entries.len() {
        0 => Some(SceneError::NoSegments),
        n if n > most => Some(SceneError::TooManySegments(n)),
        _ => None,
    };
    if let Some(error) = error {
        node.error(error, [Message::new("expect-segments")]);
        return None;
    }
    // One segment without its list is a slip worth a word of its own.
    if entries.clone().all(Node::is_number) {
        entries.next()?.wrong_type("expect-segments");
        return None;
    }
    node.made(&SEGMENTS)
}

fn random(node: Node<'_>, window: Option<&Window>, most: usize) -> Option<Vec<Segment>> {
    let (count, seed) = count_and_seed(node, 1..MAX_SEGMENTS as u64 + 1)?;
    if count > most {
        node.error(SceneError::TooManySegments(count), []);
        return None;
    }
    Some(random_segments(window?, count, seed))
}

fn to_toml(scene: &Scene) -> String {
    let compare = scene.compare.map(|method| quoted(method.card().id));
    let clip = scene.clip.as_ref();
    let is_usual = scene.bit_order == BitOrder::default();
    let mistaken = scene.mistaken.map(|segment| array(&segment.to_array()));
    let segments = rows(scene.segments().iter().map(|segment| segment.to_array()));
    lines([
        ("method", Some(quoted(scene.method.card().id))),
        ("compare", compare),
        ("window", Some(array(&scene.window.to_array()))),
        ("clip", clip.map(|clip| points(clip.vertices()))),
        ("bit_order", (!is_usual).then(|| quoted("lrbt"))),
        ("mistaken", mistaken),
        ("focus", counted(scene.focus())),
        ("segments", Some(list(&segments, 1))),
    ])
}
