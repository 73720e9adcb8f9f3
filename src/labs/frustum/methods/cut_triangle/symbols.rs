//! What the vertices, cuts and triangles of a list are called, and the formulas about them.

use crate::{
    algo::volume::SpaceVertex,
    geom::Plane,
    labs::{
        telling::Named,
        words::{name, subscript},
    },
    text::{Formula, Value},
};

use super::super::{
    super::stage::Scenery,
    planes::{distance_formula, place, plane_link, plane_name},
};

/// `V₀`: vertices of lists are numbered from 0, as the triangle's corners are.
pub fn vertex_symbol(idx: usize) -> String {
    format!("V{}", subscript(idx))
}

/// `C₁`
pub fn cut_symbol(idx: usize) -> String {
    format!("C{}", subscript(idx + 1))
}

/// `T₁`
pub fn triangle_symbol(idx: usize) -> String {
    format!("T{}", subscript(idx + 1))
}

/// `V₀, V₂`
pub fn names(symbols: impl IntoIterator<Item = String>) -> Value {
    let symbols: Vec<String> = symbols.into_iter().collect();
    name(symbols.join(", "))
}

/// `d₂ = n·V₂ + D = …`
pub fn distance(plane: &Plane, idx: usize, at: [f64; 3], d: f64) -> Formula {
    let symbols = [format!("d{}", subscript(idx)), vertex_symbol(idx)];
    let relation = if d > 0.0 {
        " > 0"
    } else if d < 0.0 {
        " < 0"
    } else {
        ""
    };
    distance_formula([&symbols[0], &symbols[1]], plane, at, d).sym(relation)
}

/// `t = d₂ / (d₂ − d₃) = 1.26 / (1.26 − (−1.81)) = 0.41`
pub fn parameter(symbol: &str, idx: [usize; 2], [d1, d2]: [f64; 2]) -> Formula {
    let [s, p] = idx.map(|i| format!("d{}", subscript(i)));
    let whole = Formula::default().sym(s.clone()).sym(" − ").sym(p);
    let numbers = Formula::default().num(d1).sym(" − ").operand(d2);
    Formula::default()
        .sym(format!("{symbol} = "))
        .over(Formula::default().sym(s), whole)
        .sym(" = ")
        .over(Formula::default().num(d1), numbers)
        .equals(d1 / (d1 - d2))
}

/// What a name stands for that says something of the plane at work.
pub fn of_plane(
    name_of: &str,
    planes: &[Plane],
    plane_idx: Option<usize>,
    scenery: Option<&Scenery>,
) -> Option<Named> {
    let plane = || planes.get(plane_idx?);
    Some(match name_of {
        "planes" => planes.len().into(),
        "plane" => Named::from(plane_name(scenery, plane_idx?)).linked(plane_link(plane_idx?)),
        "normal" => Named::from(place(plane()?.normal())).labelled(name("n")),
        "D" => plane()?.d().into(),
        _ => return None,
    })
}

/// A crossing that has just been found.
pub struct Cut {
    /// Which one of the plane's.
    pub nth: usize,
    /// Between which vertices.
    pub idx: [usize; 2],
    /// How far inside they lie.
    pub distances: [f64; 2],
    /// Where.
    pub at: SpaceVertex,
}

impl Cut {
    /// What a name stands for that says something of the crossing.
    pub fn named(&self, name_of: &str) -> Option<Named> {
        let symbol = cut_symbol(self.nth);
        Some(match name_of {
            "from" => name(vertex_symbol(self.idx[0])).into(),
            "to" => name(vertex_symbol(self.idx[1])).into(),
            "cut" => name(symbol).into(),
            "t of d" => parameter("t", self.idx, self.distances).into(),
            "place of cut" => match self.at.uv {
                Some(uv) => {
                    let [s, p] = self.idx.map(|i| format!("uv{}", subscript(i)));
                    let formula = format!("uv({symbol}) = {s} + t·({p} − {s}) = ");
                    Formula::default().sym(formula).point(uv).into()
                }
                None => {
                    let formula = Formula::default().sym(format!("{symbol} = "));
                    formula.place(self.at.at).into()
                }
            },
            _ => return None,
        })
    }
}
