//! What all methods that ask planes have in common.

use glam::DVec3;

use crate::{
    figure::{Link, Mark3, Role, Shape3},
    geom::{Plane, VolumeSide},
    labs::plane_symbol,
    text::{Formula, Value},
};

use super::super::stage::{Scenery, side_link, side_name};

/// A plane's name: its side's in a scene, a symbol where a case gives planes alone.
pub fn plane_name(scenery: Option<&Scenery>, plane_idx: usize) -> Value {
    match scenery.and(VolumeSide::ALL.get(plane_idx)) {
        Some(&side) => side_name(side),
        None => Value::Name(plane_symbol(plane_idx)),
    }
}

/// What marks, rows and gauges about a plane have in common.
pub fn plane_link(plane_idx: usize) -> Link {
    let side = VolumeSide::ALL.get(plane_idx);
    side.map_or(Link::nth("plane", plane_idx), |&side| side_link(side))
}

/// `d = n·c + D = 0.9 · (−5.5) + … = −3.4`, divided by |n| where that is not 1.
pub fn distance_formula(symbol: [&str; 2], plane: &Plane, at: [f64; 3], d: f64) -> Formula {
    if plane.length() == 1.0 {
        return sum_formula(symbol, plane, at, d);
    }
    let symbol = format!("{} = (n·{} + D) / |n| = ", symbol[0], symbol[1]);
    let quotient = Formula::default().sym(symbol);
    let length = Formula::default().num(plane.length());
    let sum = terms(Formula::default(), plane, at);
    quotient.over(sum, length).equals(d)
}

/// `d₁ = n·P₁ + D = 1 · (−2) + 3 = 1`, not divided by |n|.
pub fn sum_formula([d, p]: [&str; 2], plane: &Plane, at: [f64; 3], sum: f64) -> Formula {
    let formula = Formula::default().sym(format!("{d} = n·{p} + D = "));
    terms(formula, plane, at).equals(sum)
}

/// `… 0.9 · (−5.5) + 2`
fn terms(mut formula: Formula, plane: &Plane, at: [f64; 3]) -> Formula {
    let normal = plane.normal();
    for (n, i) in (0..3).filter(|&i| normal[i] != 0.0).enumerate() {
        formula = if n == 0 {
            formula.num(normal[i])
        } else {
            formula.sym(" + ").operand(normal[i])
        };
        formula = formula.sym(" · ").operand(at[i]);
    }
    formula.sym(" + ").operand(plane.d())
}

/// A point in space as a value.
pub fn place(at: [f64; 3]) -> Value {
    Value::Formula(Formula::default().place(at))
}

/// The perpendicular from a point to a plane, and the square at its foot.
pub fn perpendicular(plane: &Plane, at: [f64; 3], d: f64, label: Formula) -> Vec<Mark3> {
    if d == 0.0 {
        let on = Mark3::new(Role::Signal, Shape3::Dot(at));
        return vec![on.labelled(Value::Formula(label)).strong()];
    }
    let from = DVec3::from(at);
    let unit = DVec3::from(plane.unit_normal());
    let foot = from - unit * d;
    let aside = unit.any_orthonormal_vector();
    let square = [foot, from, foot + aside].map(Into::into);
    vec![
        Mark3::new(Role::Signal, Shape3::Segment([at, foot.into()]))
            .labelled(Value::Formula(label))
            .strong(),
        Mark3::new(Role::Signal, Shape3::RightAngle(square)),
        Mark3::new(Role::Signal, Shape3::Dot(foot.into())),
    ]
}
