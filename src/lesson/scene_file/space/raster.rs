//! How surfaces are drawn pixel by pixel, as files spell it.

use crate::{
    algo::surface::{DepthBits, DepthFormat, DepthNumber, DepthSteps},
    labs::space::{RasterPlan, Tones},
    lesson::{
        sink::Sink,
        toml_fields::{Item, TomlFields, list, one_of, whole},
    },
    text::Message,
};

const FIELDS: [&str; 7] = [
    "rows", "steps", "depth", "cull", "shuffle", "pixel", "tones",
];
const STEPS: [(&str, DepthSteps); 3] = [
    ("fragments", DepthSteps::Fragments),
    ("spans", DepthSteps::Spans),
    ("triangles", DepthSteps::Triangles),
];
const TONES: [(&str, Tones); 3] = [
    ("triangles", Tones::Triangles),
    ("depth", Tones::Stored),
    ("distance", Tones::Distance),
];
/// Formats of depths: whole numbers of so many bits, and floating point; reversed, 1 is near.
const DEPTHS: [&str; 16] = [
    "f64",
    "f32",
    "u8",
    "u10",
    "u12",
    "u16",
    "u24",
    "u32",
    "f64-reversed",
    "f32-reversed",
    "u8-reversed",
    "u10-reversed",
    "u12-reversed",
    "u16-reversed",
    "u24-reversed",
    "u32-reversed",
];
const BACK: &str = "back";

/// As [`raster_to_toml`] writes it.
pub(super) fn raster(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<RasterPlan> {
    let n_errors = sink.n_errors();
    let fields = TomlFields::of(item, &FIELDS, sink)?;
    let mut plan = RasterPlan::default();
    if let Some(item) = fields.get("rows") {
        let [least, most] = [RasterPlan::ROWS.start(), RasterPlan::ROWS.end()];
        let range = u64::from(*least)..u64::from(*most) + 1;
        plan = plan.with_rows(whole(item, range, sink)? as u32);
    }
    if let Some(item) = fields.get("steps") {
        plan.steps = named(item, STEPS, sink)?;
    }
    if let Some(item) = fields.get("depth") {
        plan.format = one_of(item, &DEPTHS, "problem-unknown-value", sink, format_of)?;
    }
    if let Some(item) = fields.get("cull") {
        let culls = |name: &str| (name == BACK).then_some(true);
        plan.culls_backs = one_of(item, &[BACK], "problem-unknown-value", sink, culls)?;
    }
    if let Some(item) = fields.get("shuffle") {
        plan.shuffle = Some(whole(item, 1..i64::MAX as u64, sink)?);
    }
    if let Some(item) = fields.get("pixel") {
        plan.pixel = Some(pixel(item, sink)?);
    }
    if let Some(item) = fields.get("tones") {
        plan.tones = named(item, TONES, sink)?;
    }
    (sink.n_errors() == n_errors).then_some(plan)
}

/// What one of these names stands for.
fn named<T: Copy>(item: &Item<'_>, all: [(&str, T); 3], sink: &mut Sink<'_>) -> Option<T> {
    let names = all.map(|(name, _)| name);
    one_of(item, &names, "problem-unknown-value", sink, |name| {
        let known = all.into_iter().find(|(known, _)| *known == name);
        known.map(|(_, value)| value)
    })
}

/// Column and row, from 0 at the top left.
fn pixel(item: &Item<'_>, sink: &mut Sink<'_>) -> Option<[u32; 2]> {
    let items = list(item, "expect-pixel", sink)?;
    let [column, row] = items else {
        let message = Message::new("problem-wrong-length").with("count", items.len());
        sink.error(item.span(), message, [Message::new("expect-pixel")]);
        return None;
    };
    let [column, row] = [column, row].map(|item| whole(item, 0..4096, sink));
    Some([column? as u32, row? as u32])
}

/// The name that stands for this.
fn name_of<T: Copy + PartialEq>(value: T, all: [(&'static str, T); 3]) -> Option<&'static str> {
    let known = all.into_iter().find(|(_, known)| *known == value);
    known.map(|(name, _)| name)
}

fn format_of(name: &str) -> Option<DepthFormat> {
    let known = DEPTHS.contains(&name);
    let number = name.strip_suffix("-reversed").unwrap_or(name);
    let number = match number.strip_prefix('u') {
        Some(bits) => DepthNumber::Fixed(DepthBits::new(bits.parse().ok()?)?),
        None if number == "f32" => DepthNumber::Single,
        None => DepthNumber::Double,
    };
    known.then_some(DepthFormat {
        number,
        is_reversed: name.ends_with("-reversed"),
    })
}

/// Writes what a file would not have by itself.
pub(super) fn raster_to_toml(plan: &RasterPlan) -> Option<String> {
    let usual = RasterPlan::default();
    let mut parts = Vec::new();
    if plan.rows() != usual.rows() {
        parts.push(format!("rows = {}", plan.rows()));
    }
    let steps = name_of(plan.steps, STEPS).filter(|_| plan.steps != usual.steps);
    parts.extend(steps.map(|name| format!("steps = \"{name}\"")));
    let depth = DEPTHS
        .into_iter()
        .find(|name| format_of(name) == Some(plan.format));
    if let Some(name) = depth.filter(|_| plan.format != usual.format) {
        parts.push(format!("depth = \"{name}\""));
    }
    if plan.culls_backs {
        parts.push(format!("cull = \"{BACK}\""));
    }
    parts.extend(plan.shuffle.map(|seed| format!("shuffle = {seed}")));
    parts.extend(
        plan.pixel
            .map(|[column, row]| format!("pixel = [{column}, {row}]")),
    );
    let tones = name_of(plan.tones, TONES).filter(|_| plan.tones != usual.tones);
    parts.extend(tones.map(|name| format!("tones = \"{name}\"")));
    (!parts.is_empty()).then(|| format!("{{ {} }}", parts.join(", ")))
}
