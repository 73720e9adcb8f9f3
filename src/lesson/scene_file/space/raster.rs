//! How surfaces are drawn pixel by pixel, as files spell it.

use crate::{
    algo::surface::{DepthBits, DepthFormat, DepthNumber, DepthSteps},
    labs::space::{RasterPlan, Tones},
    lesson::scene_file::prelude::*,
};

const STEPS: [(&str, DepthSteps); 3] = [
    ("fragments", DepthSteps::Fragments),
    ("spans", DepthSteps::Spans),
    ("triangles", DepthSteps::Triangles),
];
const TONES: [(&str, Tones); 5] = [
    ("depth", Tones::Depth),
    ("distance", Tones::Distance),
    ("triangles", Tones::Triangles),
    ("counts", Tones::Counts),
    ("brightness", Tones::Brightness),
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

const ROWS: Shape = Shape::Whole(
    *RasterPlan::ROWS.start() as i64,
    *RasterPlan::ROWS.end() as i64,
);
const STEP_NAMES: [&str; 3] = names(STEPS);
const TONE_NAMES: [&str; 5] = names(TONES);

/// What a file may say of a raster; what it does not say is as usual.
pub(super) const RASTER: Part<RasterPlan> = Part::new(
    "raster",
    &Shape::Table(&Table {
        name_key: "object-picture",
        fields: &[
            Field::optional("rows", &ROWS),
            Field::optional("steps", &Shape::Word(&STEP_NAMES)),
            Field::optional("depth", &Shape::Word(&DEPTHS)),
            Field::optional("cull", &Shape::Word(&[BACK])),
            Field::optional("shuffle", &Shape::Whole(1, i64::MAX - 1)),
            Field::optional("pixel", &Shape::Wholes(&[Dim::Exactly(2)], 0, 4095)),
            Field::optional("tones", &Shape::Word(&TONE_NAMES)),
            Field::optional("near_before", &Shape::Number),
        ],
        both_key: "",
    }),
    |got| {
        let usual = RasterPlan::default();
        let whole = |name| got.get(name).map(|got| got.wholes::<1>()[0]);
        let word = |name| got.get(name).map_or("", Got::text);
        let mut plan = whole("rows").map_or(usual, |rows| usual.with_rows(rows as u32));
        plan.steps = named(word("steps"), STEPS).unwrap_or(plan.steps);
        plan.format = format_of(word("depth")).unwrap_or(plan.format);
        plan.culls_backs = got.get("cull").is_some();
        plan.shuffle = whole("shuffle").map(|seed| seed as u64);
        plan.pixel = got.get("pixel").map(|got| got.wholes().map(|x| x as u32));
        plan.tones = named(word("tones"), TONES).unwrap_or(plan.tones);
        plan.near_before = got.get("near_before").map(Got::number);
        Ok(plan)
    },
);

const fn names<T: Copy, const N: usize>(all: [(&'static str, T); N]) -> [&'static str; N] {
    let mut names = [""; N];
    let mut i = 0;
    while i < N {
        names[i] = all[i].0;
        i += 1;
    }
    names
}

fn named<T: Copy, const N: usize>(name: &str, all: [(&'static str, T); N]) -> Option<T> {
    let known = all.into_iter().find(|(known, _)| *known == name);
    known.map(|(_, value)| value)
}

/// The name that stands for `value`, where it is not the usual one.
fn name_of<T: Copy + PartialEq, const N: usize>(
    value: T,
    usual: T,
    all: [(&'static str, T); N],
) -> Option<String> {
    let mut others = all.into_iter().filter(|_| value != usual);
    let known = others.find(|(_, known)| *known == value);
    known.map(|(name, _)| quoted(name))
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

/// None where all is as usual.
pub(super) fn raster_to_toml(plan: &RasterPlan) -> Option<String> {
    let usual = RasterPlan::default();
    let has_rows = plan.rows() != usual.rows();
    let mut depths = DEPTHS.into_iter().filter(|_| plan.format != usual.format);
    let depth = depths.find(|name| format_of(name) == Some(plan.format));
    let fields = [
        ("rows", has_rows.then(|| plan.rows().to_string())),
        ("steps", name_of(plan.steps, usual.steps, STEPS)),
        ("depth", depth.map(quoted)),
        ("cull", plan.culls_backs.then(|| quoted(BACK))),
        ("shuffle", plan.shuffle.map(|seed| seed.to_string())),
        ("pixel", plan.pixel.map(|pixel| format!("{pixel:?}"))),
        ("tones", name_of(plan.tones, usual.tones, TONES)),
        ("near_before", plan.near_before.map(exact)),
    ];
    let is_usual = fields.iter().all(|(_, value)| value.is_none());
    (!is_usual).then(|| table(fields))
}
