//! The arithmetic of each step, written out.

use crate::{
    algo::pipeline::{PipelineSpace, ViewingPipelineInput, ViewingPipelineState as State},
    text::Formula,
};

/// As coordinates are called.
pub const AXES: [&str; 4] = ["x", "y", "z", "w"];

/// `x = 0.8 · 3.5 + 0.6 · 2 + (−1) = 3`: what is multiplied by 0 is left out.
pub fn sum(axis: usize, row: [f64; 4], operand: [f64; 3], value: f64) -> Formula {
    let mut formula = Formula::decimals().sym(AXES[axis]).sym(" = ");
    let mut is_first = true;
    for (i, &entry) in row.iter().enumerate() {
        if entry == 0.0 {
            continue;
        }
        formula = if is_first {
            formula.num(entry)
        } else {
            formula.sym(" + ").operand(entry)
        };
        if let Some(&factor) = operand.get(i) {
            formula = formula.sym(" · ").operand(factor);
        }
        is_first = false;
    }
    if is_first {
        formula = formula.num(0.0);
    }
    formula.equals(value)
}

/// The coordinates that a matrix is applied to.
pub fn before(input: &ViewingPipelineInput, state: &State, into: PipelineSpace) -> [f64; 3] {
    match into {
        PipelineSpace::World => input.point,
        PipelineSpace::View => state.at(PipelineSpace::World),
        PipelineSpace::Clip => state.at(PipelineSpace::View),
    }
}

/// `x: −5 ≤ 1.875 ≤ 5`, or what does not hold.
pub fn against_w(clip: &[f64; 4], axis: usize) -> Formula {
    let (x, w) = (clip[axis], clip[3]);
    let formula = Formula::decimals().sym(AXES[axis]);
    if x < -w {
        formula.sym(" = ").num(x).sym(" < −w = ").num(-w)
    } else if x > w {
        formula.sym(" = ").num(x).sym(" > w = ").num(w)
    } else {
        formula
            .sym(": ")
            .num(-w)
            .sym(" ≤ ")
            .num(x)
            .sym(" ≤ ")
            .num(w)
    }
}

/// `x = (0.375 + 1) / 2 · 640 = 440`: rows are counted from the top.
pub fn screen_formula(axis: usize, ndc: f64, size: u32, found: f64) -> Formula {
    let formula = Formula::decimals().sym(AXES[axis]).sym(" = ");
    let formula = if axis == 0 {
        formula.sym("(").num(ndc).sym(" + 1)")
    } else {
        formula.sym("(1 − ").operand(ndc).sym(")")
    };
    let size = f64::from(size);
    formula.sym(" / 2 · ").num(size).equals(found)
}
