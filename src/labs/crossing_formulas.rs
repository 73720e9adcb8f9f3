//! How a crossing is worked out, written as it is computed ([`crate::algo::parameter`]): the ends' own coordinates,
//! each weighted by the other end's distance from the border. Three differences, two products, one sum and one
//! quotient for each coordinate; where along the segment it lies is shown, but not divided out.

use crate::{
    geom::{Axis, Point, Segment},
    text::Formula,
};

use super::words::{along, axis_symbol, sum_of, sym};

/// Both ends' distances from a border, positive where it lies between them.
pub struct Weights {
    pub ends: [f64; 2],
    whole: [f64; 2],
}

impl Weights {
    /// From the border at `c`, along the axis of which `a1` and `a2` are the ends' coordinates.
    pub fn along([a1, a2]: [f64; 2], c: f64) -> Self {
        let [ends, whole] = if a1 <= a2 {
            [[c - a1, a2 - c], [a2, a1]]
        } else {
            [[a1 - c, c - a2], [a1, a2]]
        };
        Self { ends, whole }
    }

    /// From an oblique border, `d1` and `d2` being the signed distances.
    pub fn across([d1, d2]: [f64; 2]) -> Self {
        let [ends, whole] = if d1 <= d2 {
            [[-d1, d2], [d2, d1]]
        } else {
            [[d1, -d2], [d1, d2]]
        };
        Self { ends, whole }
    }

    /// `w₁ = −1 − (−2) = 1` and `w₂ = 2 − (−1) = 3`
    fn differences([a1, a2]: [f64; 2], c: f64) -> [Formula; 2] {
        let [w1, w2] = Self::along([a1, a2], c).ends;
        let [first, second] = if a1 <= a2 {
            [[c, a1], [a2, c]]
        } else {
            [[a1, c], [c, a2]]
        };
        [("w₁ = ", first, w1), ("w₂ = ", second, w2)].map(|(symbol, [a, b], w)| {
            let formula = sym(symbol).num(a).sym(" − ");
            formula.operand(b).equals(w)
        })
    }

    /// `uv = (2 · (0, 0) + 6 · (1, 1/4)) / (6 − (−2)) = (3/4, 3/16)`: of all that the ends have two of.
    pub fn mean_of_points(
        &self,
        symbol: &'static str,
        ends: [[f64; 2]; 2],
        at: [f64; 2],
    ) -> Formula {
        self.mean_of_all(symbol, ends, at, Formula::point)
    }

    /// `C = (2 · (0, 0, 1, 2) + 6 · (1, 0, 3, 4)) / (6 − (−2)) = (…)`: of all coordinates at once.
    pub fn mean_of_places<const N: usize>(
        &self,
        symbol: &'static str,
        ends: &[[f64; N]; 2],
        at: [f64; N],
    ) -> Formula {
        let written = |formula: Formula, at: [f64; N]| formula.sym("(").list(&at).sym(")");
        self.mean_of_all(symbol, *ends, at, written)
    }

    fn mean_of_all<P>(
        &self,
        symbol: &'static str,
        [p1, p2]: [P; 2],
        at: P,
        written: impl Fn(Formula, P) -> Formula,
    ) -> Formula {
        let [w1, w2] = self.ends;
        let sum = written(Formula::default().num(w2).sym(" · "), p1);
        let sum = written(sum.sym(" + ").operand(w1).sym(" · "), p2);
        let mean = sym(symbol).sym(" = ").over(sum, self.whole());
        written(mean.sym(" = "), at)
    }

    /// `y = (−1 · 3 + 3/2 · 1) / (2 − (−2)) = −3/8`
    fn mean(&self, symbol: &'static str, [o1, o2]: [f64; 2], free: f64) -> Formula {
        let [w1, w2] = self.ends;
        let sum = Formula::default()
            .num(o1)
            .sym(" · ")
            .operand(w2)
            .sym(" + ")
            .operand(o2)
            .sym(" · ")
            .operand(w1);
        let formula = sym(symbol).sym(" = ");
        formula.over(sum, self.whole()).equals(free)
    }

    fn whole(&self) -> Formula {
        let [high, low] = self.whole;
        Formula::default().num(high).sym(" − ").operand(low)
    }
}

/// The coordinate that a line with this normal, through `origin`, fixes, if it runs along an axis.
pub fn fixed([nx, ny]: [f64; 2], origin: Point) -> Option<(Axis, f64)> {
    if ny == 0.0 {
        Some((Axis::X, origin.x()))
    } else {
        (nx == 0.0).then(|| (Axis::Y, origin.y()))
    }
}

/// Where a segment crosses the line on which the `axis` coordinate is `c`: both weights, then the other coordinate.
/// Where the line passes through an end there is nothing to compute.
pub fn upright(segment: &Segment, axis: Axis, c: f64, at: Point) -> Vec<Formula> {
    let ends = [segment.p1, segment.p2].map(Point::to_array);
    upright_in_space(&ends, axis as usize, c, at.to_array())
}

/// The same on the face on which the coordinate of `axis` is `c`: both weights, then the other coordinates.
pub fn upright_in_space<const N: usize>(
    ends: &[[f64; N]; 2],
    axis: usize,
    c: f64,
    at: [f64; N],
) -> Vec<Formula> {
    const SYMBOLS: [&str; 3] = ["x", "y", "z"];
    let along = ends.map(|end| end[axis]);
    let others = (0..N).filter(|&other| other != axis);
    if along.contains(&c) {
        let taken = |i: usize| sym(SYMBOLS[i]).sym(" = ").num(at[i]);
        return others.map(taken).collect();
    }
    let weights = Weights::along(along, c);
    let mean = |i: usize| weights.mean(SYMBOLS[i], ends.map(|end| end[i]), at[i]);
    let formulas = Weights::differences(along, c).into_iter();
    formulas.chain(others.map(mean)).collect()
}

/// `y = 1`: the other coordinate of a point that was there already, an end or a corner.
pub fn taken(axis: Axis, at: Point) -> Vec<Formula> {
    let symbol = match axis {
        Axis::X => axis_symbol(Axis::Y),
        Axis::Y => axis_symbol(Axis::X),
    };
    vec![sym(symbol).sym(" = ").num(along(at, axis)[1])]
}

pub fn oblique(symbol: &'static str, ends: [Point; 2], distances: [f64; 2], at: Point) -> Formula {
    let ends = ends.map(Point::to_array);
    Weights::across(distances).mean_of_points(symbol, ends, at.to_array())
}

/// `2 · (−3 − 0) + (−1) · (1 − 2)`: a normal times what lies between a point and the origin of its line.
pub fn dot_product(formula: Formula, normal: [f64; 2], at: Point, origin: Point) -> Formula {
    let differences = at.to_array().into_iter().zip(origin.to_array());
    let terms = normal.into_iter().zip(differences);
    let terms = terms.filter(|&(n, _)| n != 0.0);
    sum_of(formula, terms, |formula, (a, o)| {
        formula.sym(" · (").num(a).sym(" − ").operand(o).sym(")")
    })
}
