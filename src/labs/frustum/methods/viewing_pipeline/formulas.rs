//! The arithmetic of each step, and the values that sentences and formulas take by name.

use crate::{
    algo::pipeline::{
        PipelineSpace, ViewingPipeline, ViewingPipelineEvent as Event, ViewingPipelineInput,
        ViewingPipelineOutput,
    },
    labs::frustum::prelude::*,
};

use super::super::asked::place;

const AXES: [&str; 4] = ["x", "y", "z", "w"];

pub const OPENING: &str = "~ P = {P}";
pub const DIVIDE: [&str; 3] = [
    "~ x / w = {x / w}{=x_ndc}",
    "~ y / w = {y / w}{=y_ndc}",
    "~ z / w = {z / w}{=z_ndc}",
];
pub const DIVIDE_FLAT: [&str; 3] = [
    "~ x / w = {x} / {(w)}{=x_ndc}",
    "~ y / w = {y} / {(w)}{=y_ndc}",
    "~ z / w = {z} / {(w)}{=z_ndc}",
];
/// Rows are counted from the top.
pub const SCREEN: [&str; 2] = [
    "~ x = ({x_ndc} + 1) / 2 · {width}{=x_screen}",
    "~ y = (1 − {(y_ndc)}) / 2 · {height}{=y_screen}",
];
pub const BEHIND: &str = "~ w = {w} ≤ 0";
pub const TO_W: [&str; 3] = ["{x to w}", "{y to w}", "{z to w}"];

pub fn named(at: &At<'_, ViewingPipeline>, name: &str) -> Option<Named> {
    let (input, held, event) = (at.step.input, at.step.held, at.step.event());
    let size = input.viewport.size();
    let [x, y] = [0, 1].map(|i| held.screen.map(|screen| screen[i]));
    Some(match (name, event) {
        ("P", _) => place(input.point).into(),
        ("row", Some(Event::Row { row, .. })) => (row + 1).into(),
        ("value", Some(Event::Row { value, .. })) => value.abs().into(),
        ("sum", Some(Event::Row { space, row, value })) => {
            let entries = input.matrix(space).rows()[row];
            sum(row, entries, before(input, held, space), value).into()
        }
        ("columns", _) => (size[0] as usize).into(),
        ("rows", _) => (size[1] as usize).into(),
        ("width", _) => f64::from(size[0]).into(),
        ("height", _) => f64::from(size[1]).into(),
        ("x_screen", _) => x?.into(),
        ("y_screen", _) => y?.into(),
        ("−w ≤ x, y, z ≤ w", Some(Event::Row { .. }) | None) => return None,
        ("−w ≤ x, y, z ≤ w", Some(_)) if held.inside => Value::Term("class-inside").into(),
        ("−w ≤ x, y, z ≤ w", Some(_)) => Value::Term("class-outside").into(),
        _ => return coordinate(held, name),
    })
}

fn coordinate(held: &ViewingPipelineOutput, name: &str) -> Option<Named> {
    let (axis, way) = name.split_at_checked(1)?;
    let i = AXES.iter().position(|it| *it == axis)?;
    Some(match way {
        "" => held.clip[i].into(),
        "_ndc" => held.ndc?[i].into(),
        " to w" => against_w(&held.clip, i).into(),
        " beyond w" if !is_within(&held.clip, i) => against_w(&held.clip, i).into(),
        _ => return None,
    })
}

pub fn is_within(clip: &[f64; 4], axis: usize) -> bool {
    -clip[3] <= clip[axis] && clip[axis] <= clip[3]
}

/// `x = 0.8 · 3.5 + 0.6 · 2 + (−1) = 3`: what is multiplied by 0 is left out.
pub fn sum(axis: usize, row: [f64; 4], operand: [f64; 3], value: f64) -> Formula {
    let formula = Formula::decimals().sym(AXES[axis]).sym(" = ");
    if row == [0.0; 4] {
        return formula.num(0.0).equals(value);
    }
    let factors = operand.map(Some).into_iter().chain([None]);
    let terms = row.into_iter().zip(factors).filter(|&(n, _)| n != 0.0);
    let product = |formula, factor: Option<f64>| match factor {
        Some(factor) => times(formula, factor),
        None => formula,
    };
    sum_of(formula, terms, product).equals(value)
}

pub const fn before(
    input: &ViewingPipelineInput,
    held: &ViewingPipelineOutput,
    into: PipelineSpace,
) -> [f64; 3] {
    match into {
        PipelineSpace::World => input.point,
        PipelineSpace::View => held.world,
        PipelineSpace::Clip => held.view,
    }
}

/// `x: −5 ≤ 1.875 ≤ 5`, or what does not hold.
fn against_w(clip: &[f64; 4], axis: usize) -> Formula {
    let (x, w) = (clip[axis], clip[3]);
    let formula = Formula::decimals().sym(AXES[axis]);
    if x < -w {
        formula.sym(" = ").num(x).sym(" < −w = ").num(-w)
    } else if x > w {
        formula.sym(" = ").num(x).sym(" > w = ").num(w)
    } else {
        let formula = formula.sym(": ").num(-w).sym(" ≤ ");
        formula.num(x).sym(" ≤ ").num(w)
    }
}
