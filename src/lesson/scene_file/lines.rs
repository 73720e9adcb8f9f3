//! A scene of the lines lab as files spell it.

use std::fmt::Write as _;

use crate::{
    algo::line::BitOrder,
    geom::{ConvexPolygon, Segment, Window},
    input::{BIT_ORDER, CONVEX_CLIP, Dim, Part, Shape, WINDOW},
    labs::{
        self, Lab,
        lines::{LAB, MAX_SEGMENTS, Method, Scene, SceneError, random_segments},
    },
    lesson::{
        sink::Sink,
        toml_fields::{Item, TomlFields, list, made, whole, wrong_type},
    },
    text::Message,
};

use super::{
    format::SceneFormat,
    parts::{array, count_and_seed, head, method, number_like},
};

/// The fields of a scene.
const FIELDS: [&str; 8] = [
    "method",
    "compare",
    "window",
    "clip",
    "bit_order",
    "segments",
    "random",
    "focus",
];

/// All segments of a scene.
const SEGMENTS: Part<Vec<Segment>> = Part::new(
    "segments",
    &Shape::Numbers(&[Dim::ANY, Dim::Exactly(4)]),
    |got| {
        let segments = got.rows().iter().map(|&ends| Segment::try_from(ends));
        Ok(segments.collect::<Result<_, _>>()?)
    },
)
.expecting("expect-segments");

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
        "segments"
    }

    fn room(&self) -> usize {
        MAX_SEGMENTS
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

/// Reads a scene; `segments_left` is how many a file may still have.
fn scene(fields: &TomlFields<'_>, segments_left: &mut usize, sink: &mut Sink<'_>) -> Option<Scene> {
    let n_errors = sink.n_errors();
    let method = fields
        .require("method", sink)
        .and_then(|item| line_method(item, sink));
    let compare = fields
        .get("compare")
        .and_then(|item| line_method(item, sink));
    let window = fields.need(&WINDOW, sink);
    let clip = fields.part(&CONVEX_CLIP, sink);
    let bit_order = fields.part(&BIT_ORDER, sink);
    let segments = segments(fields, window.as_ref(), *segments_left, sink);
    let focus = fields.get("focus").and_then(|item| {
        let number = whole(item, 0..MAX_SEGMENTS as u64, sink)? as usize;
        let n_segments = segments.as_ref()?.len();
        if number >= n_segments {
            let focus = number;
            sink.refuse(
                item.span(),
                SceneError::NoSuchFocus { focus, n_segments },
                [],
            );
        }
        Some(number)
    });
    let segments = segments?;
    *segments_left -= segments.len();
    let mut scene = Scene::new(method?, window?, segments).ok()?;
    (scene.compare, scene.clip) = (compare, clip);
    scene.bit_order = bit_order.unwrap_or_default();
    scene.set_focus(focus.unwrap_or(0));
    (sink.n_errors() == n_errors).then_some(scene)
}

fn line_method(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Method> {
    Method::by_id(method(LAB, item, sink)?)
}

/// The segments of a scene, listed or random: one of the two.
fn segments(
    fields: &TomlFields<'_>,
    window: Option<&Window>,
    most: usize,
    sink: &mut Sink<'_>,
) -> Option<Vec<Segment>> {
    match (fields.get("segments"), fields.get("random")) {
        (Some(_), Some(random)) => {
            sink.error(
                random.span(),
                Message::new("problem-two-kinds-of-segments"),
                [],
            );
            None
        }
        (Some(item), None) => listed(item, most, sink),
        (None, Some(item)) => random(item, window, most, sink),
        (None, None) => {
            if !fields.is_misspelt("segments") && !fields.is_misspelt("random") {
                let message =
                    Message::new("problem-missing-field").with("name", "segments".to_owned());
                sink.error(fields.span(), message, [Message::new("expect-segments")]);
            }
            None
        }
    }
}

fn listed(item: &Item<'_>, most: usize, sink: &mut Sink<'_>) -> Option<Vec<Segment>> {
    let items = list(item, "expect-segments", sink)?;
    if items.is_empty() || items.len() > most {
        let error = match items.len() {
            0 => SceneError::NoSegments,
            n => SceneError::TooManySegments(n),
        };
        sink.refuse(item.span(), error, [Message::new("expect-segments")]);
        return None;
    }
    // One segment without its list is a slip worth a word of its own.
    if items.iter().all(number_like) {
        wrong_type(&items[0], "expect-segments", sink);
        return None;
    }
    made(item, &SEGMENTS, sink)
}

fn random(
    item: &Item<'_>,
    window: Option<&Window>,
    most: usize,
    sink: &mut Sink<'_>,
) -> Option<Vec<Segment>> {
    let (count, seed) = count_and_seed(item, 1..MAX_SEGMENTS as u64 + 1, sink)?;
    if count > most {
        sink.refuse(item.span(), SceneError::TooManySegments(count), []);
        return None;
    }
    Some(random_segments(window?, count, seed))
}

/// Writes a scene.
fn to_toml(scene: &Scene) -> String {
    let compare = scene.compare.map(|method| method.card().id);
    let clip = scene.clip.as_ref().map(ConvexPolygon::vertices);
    let mut text = head(scene.method.card().id, compare, &scene.window, clip);
    if scene.bit_order == BitOrder::Lrbt {
        text.push_str("bit_order = \"lrbt\"\n");
    }
    if scene.focus() > 0 {
        let _ = writeln!(text, "focus = {}", scene.focus());
    }
    match scene.segments() {
        [one] => {
            let _ = writeln!(text, "segments = [{}]", array(&one.to_array()));
        }
        many => {
            text.push_str("segments = [\n");
            for segment in many {
                let _ = writeln!(text, "    {},", array(&segment.to_array()));
            }
            text.push_str("]\n");
        }
    }
    text
}
