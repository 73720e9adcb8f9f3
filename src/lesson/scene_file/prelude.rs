//! What scenes of several labs spell alike, and the names that all of them are told in.

use std::{fmt::Write as _, ops::Range};

use crate::geom::Point;

pub(super) use crate::{
    input::{At, Dim, Field, Got, Part, Shape, Table},
    labs::{self, Lab},
    lesson::toml_fields::{Node, TomlFields},
    text::Message,
};

pub(super) use super::format::SceneFormat;

pub(super) fn method(lab: &Lab, node: Node<'_>) -> Option<&'static str> {
    let known: Vec<&'static str> = (lab.methods)().iter().map(|card| card.id).collect();
    node.one_of(&known, "problem-unknown-method", |name| {
        known.iter().copied().find(|id| *id == name)
    })
}

/// How many and the seed of what is drawn by lot.
pub(super) fn count_and_seed(node: Node<'_>, counts: Range<u64>) -> Option<(usize, u64)> {
    let fields = node.fields(&["count", "seed"])?;
    let whole = |name, range| fields.require(name)?.whole(range);
    let (count, seed) = (whole("count", counts), whole("seed", 0..i64::MAX as u64));
    Some((count? as usize, seed?))
}

/// A field and its value as a file spells it; none where a file would have the same by itself.
pub(super) type Spelt = (&'static str, Option<String>);

/// Fields on a line each.
pub(super) fn lines(fields: impl IntoIterator<Item = Spelt>) -> String {
    let lines = assigned(fields).map(|line| line + "\n");
    lines.collect()
}

/// Fields in braces, on one line.
pub(super) fn table(fields: impl IntoIterator<Item = Spelt>) -> String {
    format!("{{ {} }}", assigned(fields).collect::<Vec<_>>().join(", "))
}

fn assigned(fields: impl IntoIterator<Item = Spelt>) -> impl Iterator<Item = String> {
    let fields = fields.into_iter();
    fields.filter_map(|(name, value)| value.map(|value| format!("{name} = {value}")))
}

/// A list, its entries on a line each where there are more than `most` of them.
pub(super) fn list(entries: &[String], most: usize) -> String {
    if entries.len() <= most {
        return format!("[{}]", entries.join(", "));
    }
    let lines = entries.iter().map(|entry| format!("    {entry},\n"));
    format!("[\n{}]", lines.collect::<String>())
}

pub(super) fn points(points: &[Point]) -> String {
    list(&rows(points.iter().map(|p| p.to_array())), 6)
}

pub(super) fn rows<const N: usize>(rows: impl IntoIterator<Item = [f64; N]>) -> Vec<String> {
    rows.into_iter().map(|row| array(&row)).collect()
}

/// A number that is 0 where a file does not say it.
pub(super) fn counted(n: usize) -> Option<String> {
    (n > 0).then(|| n.to_string())
}

pub(super) fn array(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().copied().map(exact).collect();
    format!("[{}]", numbers.join(", "))
}

/// The shortest decimal that reads back as this number; −0 keeps its sign as a float.
pub fn exact(x: f64) -> String {
    if x.fract() == 0.0 && x.abs() < 1e15 && !(x == 0.0 && x.is_sign_negative()) {
        format!("{x:.0}")
    } else {
        format!("{x:?}")
    }
}

pub fn quoted(text: &str) -> String {
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
