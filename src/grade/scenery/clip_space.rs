//! Cases of clip space: of the four coordinates w and the one that what differs is about, between the lines where both are
//! as large.

use serde_json::Value as Json;

use crate::{
    figure::{Mark, Role, Shape},
    text::{Formula, Value},
};

use super::{
    super::whole::Whole,
    Scenery, plane,
    told::{Told, outline, place},
};

const AXES: [&str; 3] = ["x", "y", "z"];

pub(super) fn scenery(case: &Json, whole: &Whole) -> Option<Scenery> {
    let subject: Option<Vec<[f64; 4]>> = ["segment", "triangle"]
        .into_iter()
        .find_map(|name| outline(case.get(name)?));
    let mut told = whole
        .each()
        .map(|(json, is_true)| (Told::<4>::of(json), is_true));
    if subject.is_none() {
        for ((told, _), (json, _)) in told.iter_mut().zip(whole.each()) {
            told.at = json.get("clip").and_then(place);
        }
        told.iter()
            .all(|(told, _)| told.at.is_some())
            .then_some(())?;
    }
    let axis = axis(whole, &told);
    let seen = |at: [f64; 4]| [at[axis], at[3]];
    let subject: Vec<[f64; 2]> = subject.into_iter().flatten().map(seen).collect();
    let told = told.map(|(told, is_true)| (told.map(seen), is_true));
    let places = told
        .iter()
        .flat_map(|(told, _)| told.corners().chain(told.at));
    let far = subject.iter().copied().chain(places).flatten();
    let far = far.map(f64::abs).fold(1.0, f64::max);
    let border = |sign: f64| {
        let line = Shape::Segment([[0.0, 0.0], [sign * far, far]]);
        let equals = if sign > 0.0 { " = w" } else { " = −w" };
        let name = Value::Name(AXES[axis].to_owned() + equals);
        Mark::new(Role::Ink, line).labelled(name)
    };
    let mut marks = vec![border(-1.0), border(1.0)];
    if !subject.is_empty() {
        marks.extend(plane::subject_of(&subject));
    }
    for (mut told, is_true) in told {
        let at = told.at.take();
        marks.extend(plane::told(&told, is_true));
        marks.extend(at.map(|at| {
            let formula = Formula::default().sym(AXES[axis]).equals(at[0]);
            let formula = formula.sym(", w").equals(at[1]);
            plane::pointed(at, Value::Formula(formula), is_true)
        }));
    }
    Some(plane::framed(marks))
}

/// The axis of the side that a step names; else along which the two are farthest apart.
fn axis(whole: &Whole, told: &[(Told<4>, bool); 2]) -> usize {
    let mut named = ["side", "plane"].into_iter();
    let named = named.find_map(|name| whole.truth.get(name)?.as_str());
    match named {
        Some("left" | "right") => return 0,
        Some("bottom" | "top") => return 1,
        Some("near" | "far") => return 2,
        Some(_) | None => {}
    }
    let places = |told: &Told<4>| -> Vec<[f64; 4]> { told.corners().chain(told.at).collect() };
    let [truth, said] = told.each_ref().map(|(told, _)| places(told));
    let apart = |axis: usize| {
        let pairs = truth.iter().zip(&said);
        let apart = pairs.map(|(a, b)| (a[axis] - b[axis]).abs());
        apart.fold(0.0, f64::max)
    };
    let farther = |a: &usize, b: &usize| apart(*a).total_cmp(&apart(*b)).then(b.cmp(a));
    (0..3).max_by(farther).unwrap_or_default()
}
