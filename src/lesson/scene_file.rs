//! A scene of the lines lab as lesson and scene files spell it.

use std::{fmt::Write as _, ops::Range};

use crate::{
    algo::line::BitOrder,
    geom::{Axis, ConvexPolygon, GeomError, Segment, Window},
    labs::lines::{MAX_SEGMENTS, METHODS, Method, Scene},
    text::Message,
};

use super::{
    problem::Problem,
    random::random_segments,
    sink::Sink,
    source::Source,
    toml_errors::with_toml,
    toml_fields::{Fields, Item, list, numbers, one_of, whole, wrong_type},
};

/// The fields of a scene.
pub(super) const FIELDS: [&str; 8] = [
    "method",
    "compare",
    "window",
    "clip",
    "bit_order",
    "segments",
    "random",
    "focus",
];

/// Reads a scene file: one scene's fields at the top level, as [`scene_to_toml`] writes them.
///
/// # Errors
/// Every mistake in it, from the top to the end; `file` is how they name it.
pub fn scene_from_toml(file: &str, bytes: &[u8]) -> Result<Scene, Vec<Problem>> {
    let source = Source::new(file.to_owned(), bytes);
    let mut sink = Sink::new(&source);
    let scene = with_toml(&mut sink, |table, sink| {
        let fields = Fields::of_file(table, &FIELDS, sink);
        scene(&fields, &mut { MAX_SEGMENTS }, sink)
    });
    match scene {
        Some(scene) if sink.n_errors() == 0 => Ok(scene),
        _ => Err(sink.into_problems()),
    }
}

/// Reads a scene; `segments_left` is how many a file may still have.
pub(super) fn scene(
    fields: &Fields<'_>,
    segments_left: &mut usize,
    sink: &mut Sink<'_>,
) -> Option<Scene> {
    let n_errors = sink.n_errors();
    let method = fields
        .require("method", sink)
        .and_then(|item| method(item, sink));
    let compare = fields
        .get("compare")
        .and_then(|item| self::method(item, sink));
    let window = fields
        .require("window", sink)
        .and_then(|item| window(item, sink));
    let clip = fields.get("clip").and_then(|item| clip(item, sink));
    let bit_order = fields.get("bit_order").and_then(|item| {
        one_of(
            item,
            &["tbrl", "lrbt"],
            "problem-unknown-value",
            sink,
            |name| match name {
                "tbrl" => Some(BitOrder::Tbrl),
                "lrbt" => Some(BitOrder::Lrbt),
                _ => None,
            },
        )
    });
    let segments = segments(fields, window.as_ref(), *segments_left, sink);
    let focus = fields.get("focus").and_then(|item| {
        let number = whole(item, 0..MAX_SEGMENTS as u64, sink)? as usize;
        let n_segments = segments.as_ref()?.len();
        if number >= n_segments {
            let message = Message::new("problem-no-such-focus")
                .with("focus", number.to_string())
                .with("count", n_segments);
            sink.error(item.span(), message, []);
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

fn method(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Method> {
    let known: Vec<&str> = METHODS.iter().map(|info| info.id).collect();
    one_of(item, &known, "problem-unknown-method", sink, Method::by_id)
}

fn window(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<Window> {
    let [xmin, ymin, xmax, ymax] = numbers(item, "expect-window", sink)?;
    let error = match Window::new(xmin, ymin, xmax, ymax) {
        Ok(window) => return Some(window),
        Err(error) => error,
    };
    if let GeomError::EmptyWindow { axis, min, max } = error {
        let (key, index) = match axis {
            Axis::X => ("problem-empty-window-x", 0),
            Axis::Y => ("problem-empty-window-y", 1),
        };
        let message = Message::new(key).with("min", min).with("max", max);
        let expected = [Message::new("expect-window")];
        sink.error(span_of(item, index), message, expected);
    } else {
        sink.error(item.span(), Message::new(geometry(error)), []);
    }
    None
}

fn clip(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<ConvexPolygon> {
    let n_errors = sink.n_errors();
    let vertices: Vec<[f64; 2]> = list(item, "expect-clip", sink)?
        .iter()
        .filter_map(|vertex| numbers(vertex, "expect-point", sink))
        .collect();
    if sink.n_errors() > n_errors {
        return None;
    }
    let error = match ConvexPolygon::new(&vertices) {
        Ok(clip) => return Some(clip),
        Err(error) => error,
    };
    let span = match error {
        GeomError::Degenerate { vertex_idx }
        | GeomError::NotConvex { vertex_idx }
        | GeomError::SelfIntersecting { vertex_idx } => span_of(item, vertex_idx),
        _ => item.span(),
    };
    sink.error(
        span,
        Message::new(geometry(error)),
        [Message::new("expect-clip")],
    );
    None
}

/// The catalogue's sentence for a refused primitive.
const fn geometry(error: GeomError) -> &'static str {
    match error {
        GeomError::NotFinite { .. } => "problem-not-finite",
        GeomError::EmptyWindow { .. } => "error-empty-window",
        GeomError::Degenerate { .. } => "problem-degenerate",
        GeomError::NotConvex { .. } => "problem-not-convex",
        GeomError::SelfIntersecting { .. }
        | GeomError::EdgesMeet { .. }
        | GeomError::MisplacedHole { .. } => "error-self-intersecting",
    }
}

/// Where an element of a list stands; the whole list where there is no such element.
fn span_of(item: &Item<'_>, index: usize) -> Range<usize> {
    let element = item.get_ref().as_array().and_then(|list| list.get(index));
    element.map_or_else(|| item.span(), Item::span)
}

/// The segments of a scene, listed or random: one of the two.
fn segments(
    fields: &Fields<'_>,
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
        let message = if items.is_empty() {
            Message::new("problem-no-segments")
        } else {
            too_many(items.len())
        };
        sink.error(item.span(), message, [Message::new("expect-segments")]);
        return None;
    }
    // One segment without its list is a slip worth a word of its own.
    if items.iter().all(number_like) {
        wrong_type(&items[0], "expect-segments", sink);
        return None;
    }
    let segments: Vec<Segment> = items
        .iter()
        .filter_map(|item| Segment::try_from(numbers::<4>(item, "expect-segment", sink)?).ok())
        .collect();
    (segments.len() == items.len()).then_some(segments)
}

fn number_like(item: &Item<'_>) -> bool {
    item.get_ref().is_integer() || item.get_ref().is_float()
}

fn random(
    item: &Item<'_>,
    window: Option<&Window>,
    most: usize,
    sink: &mut Sink<'_>,
) -> Option<Vec<Segment>> {
    let fields = Fields::of(item, &["count", "seed"], sink)?;
    let count = fields
        .require("count", sink)
        .and_then(|item| whole(item, 1..MAX_SEGMENTS as u64 + 1, sink));
    let seed = fields
        .require("seed", sink)
        .and_then(|item| whole(item, 0..i64::MAX as u64, sink));
    let (count, seed) = (count? as usize, seed?);
    if count > most {
        sink.error(item.span(), too_many(count), []);
        return None;
    }
    Some(random_segments(window?, count, seed))
}

fn too_many(count: usize) -> Message {
    Message::new("problem-too-large")
        .with("count", count)
        .with("limit", MAX_SEGMENTS)
}

/// Writes a scene so that [`scene_from_toml`] reads the very same one, bit for bit.
#[must_use]
pub fn scene_to_toml(scene: &Scene) -> String {
    let mut text = format!("method = \"{}\"\n", scene.method);
    if let Some(compare) = scene.compare {
        let _ = writeln!(text, "compare = \"{compare}\"");
    }
    let _ = writeln!(text, "window = {}", array(&scene.window.to_array()));
    if let Some(clip) = &scene.clip {
        let vertices: Vec<String> = clip
            .vertices()
            .iter()
            .map(|p| array(&p.to_array()))
            .collect();
        let _ = writeln!(text, "clip = [{}]", vertices.join(", "));
    }
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

fn array(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().copied().map(exact).collect();
    format!("[{}]", numbers.join(", "))
}

/// The shortest decimal that reads back as this number; −0 keeps its sign as a float.
fn exact(x: f64) -> String {
    if x.fract() == 0.0 && x.abs() < 1e15 && !(x == 0.0 && x.is_sign_negative()) {
        format!("{x:.0}")
    } else {
        format!("{x:?}")
    }
}
