//! Surfaces that let light through: what is painted over what at a pixel, and the picture in brightness.

use crate::{
    algo::surface::{Fragment, Tint},
    figure::CellStage,
};

use super::{crosses::differing, prelude::*};

pub const GLASS_VIEW: &str = "glass";

/// `C = α·C_s + (1 − α)·C_d = 0.5 · 0.25 + (1 − 0.5) · 1 = 0.625`
pub fn blended(surfaces: &Surfaces, fragment: &Fragment) -> Option<Formula> {
    let (tint, [before, after]) = (surfaces.tint(fragment.id)?, fragment.blend?);
    let formula = Formula::decimals().sym("C = α·C_s + (1 − α)·C_d = ");
    let formula = formula
        .num(tint.opacity())
        .sym(" · ")
        .num(tint.brightness());
    let formula = formula.sym(" + (1 − ").num(tint.opacity()).sym(") · ");
    Some(formula.num(before).equals(after))
}

/// Every fragment of a pixel in order of arrival: its own opacity and brightness, what it is painted over, what comes of that.
pub fn glass(
    at: &Scenery,
    surfaces: &Surfaces,
    (pixel, told): ([u32; 2], &[Fragment]),
    stage: impl Fn(u32) -> CellStage,
) -> Option<Table> {
    let number = |x: f64| Value::Formula(Formula::decimals().num(x));
    let row = |fragment: &Fragment| {
        let tint = surfaces.tint(fragment.id)?;
        let stage = stage(fragment.id);
        let (role, blend) = match stage {
            CellStage::Current => (Role::Signal, fragment.blend),
            CellStage::Done => (Role::Ink, fragment.blend),
            CellStage::ToCome => (Role::Soft, None),
        };
        let lost = Some(Value::Term("story-lost"));
        let lost = lost.filter(|_| !fragment.kept && stage != CellStage::ToCome);
        let [before, after] = [0, 1].map(|i| blend.map(|blend| number(blend[i])));
        let cells = vec![
            Cell::new(role, Some(number(tint.opacity()))),
            Cell::new(role, Some(number(tint.brightness()))),
            Cell::new(role, before),
            Cell::new(role, after.or(lost)).strong(),
        ];
        Some(TableRow {
            name: name_of(Some(at), fragment.id),
            cells,
            is_current: stage == CellStage::Current,
            link: surface_link(at.scene(), fragment.id),
        })
    };
    let symbols = ["α", "C_s", "C_d", "C"].map(|symbol| Formula::default().sym(symbol));
    Some(Table {
        header: [pixel_formula(pixel)].into_iter().chain(symbols).collect(),
        rows: told.iter().map(row).collect::<Option<_>>()?,
        notes: Vec::new(),
    })
}

/// The picture in brightness, the tone of paper and ink.
pub fn bright(surfaces: &Surfaces, brightness: &[f64], over: Vec<RasterMark>) -> Raster {
    const THOUSAND: f64 = 1000.0;
    let pixel = |&brightness: &f64| Pixel {
        role: Some(Role::Ink).filter(|_| brightness < Tint::PAPER),
        shade: Tint::PAPER - brightness,
        value: Some(Value::Count((THOUSAND * brightness).round() as usize)),
    };
    Raster {
        title: Value::Term("raster-brightness"),
        bare: Some(Value::Term("raster-brightness-bare")),
        ..raster_so_far(surfaces, brightness.iter().map(pixel).collect(), over)
    }
}

/// The pixels that would have another brightness if all were sorted there.
pub fn unsorted(surfaces: &Surfaces, brightness: &[f64]) -> Vec<usize> {
    differing(brightness, &surfaces.sorted_brightness())
}
