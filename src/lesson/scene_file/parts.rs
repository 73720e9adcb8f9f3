//! What scenes of several labs spell alike.

use std::{fmt::Write as _, ops::Range};

use crate::{
    geom::{Point, Window},
    labs::Lab,
};

use crate::lesson::{
    sink::Sink,
    toml_fields::{Item, TomlFields, one_of, whole},
};

/// The id of a method of this lab.
pub(super) fn method(lab: &dyn Lab, item: &Item<'_>, sink: &mut Sink<'_>) -> Option<&'static str> {
    let known: Vec<&str> = lab.methods().iter().map(|card| card.id).collect();
    one_of(item, &known, "problem-unknown-method", sink, |name| {
        let mut cards = lab.methods().into_iter();
        cards.find(|card| card.id == name).map(|card| card.id)
    })
}

/// `[[x, y], …]`, on a line of its own each where there are many.
pub(super) fn points(points: &[Point]) -> String {
    let vertices: Vec<String> = points.iter().map(|p| array(&p.to_array())).collect();
    if points.len() <= 6 {
        return format!("[{}]", vertices.join(", "));
    }
    let mut text = String::from("[\n");
    for vertex in vertices {
        let _ = writeln!(text, "    {vertex},");
    }
    text + "]"
}

/// How many and the seed of what is drawn by lot.
pub(super) fn count_and_seed(
    item: &Item<'_>,
    counts: Range<u64>,
    sink: &mut Sink<'_>,
) -> Option<(usize, u64)> {
    let fields = TomlFields::of(item, &["count", "seed"], sink)?;
    let count = fields
        .require("count", sink)
        .and_then(|item| whole(item, counts, sink));
    let seed = fields
        .require("seed", sink)
        .and_then(|item| whole(item, 0..i64::MAX as u64, sink));
    Some((count? as usize, seed?))
}

/// Where an element of a list stands; the whole list where there is no such element.
pub(super) fn span_of(item: &Item<'_>, index: usize) -> Range<usize> {
    let element = item.get_ref().as_array().and_then(|list| list.get(index));
    element.map_or_else(|| item.span(), Item::span)
}

/// The fields that a scene of a window begins with.
pub(super) fn head(
    method: &str,
    compare: Option<&str>,
    window: &Window,
    clip: Option<&[Point]>,
) -> String {
    let mut text = format!("method = \"{method}\"\n");
    if let Some(compare) = compare {
        let _ = writeln!(text, "compare = \"{compare}\"");
    }
    let _ = writeln!(text, "window = {}", array(&window.to_array()));
    if let Some(clip) = clip {
        let _ = writeln!(text, "clip = {}", points(clip));
    }
    text
}

pub(super) fn array(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().copied().map(exact).collect();
    format!("[{}]", numbers.join(", "))
}

/// The shortest decimal that reads back as this number; −0 keeps its sign as a float.
pub(super) fn exact(x: f64) -> String {
    if x.fract() == 0.0 && x.abs() < 1e15 && !(x == 0.0 && x.is_sign_negative()) {
        format!("{x:.0}")
    } else {
        format!("{x:?}")
    }
}

pub(super) fn number_like(item: &Item<'_>) -> bool {
    item.get_ref().is_integer() || item.get_ref().is_float()
}
