//! A triangle and what is left of it in the observer's view, and what its vertices, cuts and pieces are called.

use crate::{algo::volume::clipped, labs::frustum::prelude::*};

use super::super::asked::{distance_formula, place, plane_link, plane_name};

/// `V₀`: vertices of lists are numbered from 0, as the triangle's corners are.
pub fn vertex_symbol(idx: usize) -> String {
    format!("V{}", subscript(idx))
}

pub fn cut_symbol(idx: usize) -> String {
    format!("C{}", subscript(idx + 1))
}

pub fn triangle_symbol(idx: usize) -> String {
    format!("T{}", subscript(idx + 1))
}

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
    let whole = sym(s.clone()).sym(" − ").sym(p);
    let numbers = Formula::default().num(d1).sym(" − ").operand(d2);
    sym(format!("{symbol} = "))
        .over(sym(s), whole)
        .sym(" = ")
        .over(Formula::default().num(d1), numbers)
        .equals(d1 / (d1 - d2))
}

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

/// What is said of a cut between two vertices, which lie so far inside.
pub fn named_cut(
    name_of: &str,
    nth: usize,
    (idx, distances): ([usize; 2], [f64; 2]),
    at: &SpaceVertex,
) -> Option<Named> {
    let symbol = cut_symbol(nth);
    Some(match name_of {
        "from" => name(vertex_symbol(idx[0])).into(),
        "to" => name(vertex_symbol(idx[1])).into(),
        "cut" => name(symbol).into(),
        "t of d" => parameter("t", idx, distances).into(),
        "place of cut" => match at.uv {
            Some(uv) => {
                let [s, p] = idx.map(|i| format!("uv{}", subscript(i)));
                let formula = format!("uv({symbol}) = {s} + t·({p} − {s}) = ");
                sym(formula).point(uv).into()
            }
            None => sym(format!("{symbol} = ")).place(at.at).into(),
        },
        _ => return None,
    })
}

pub fn places(ring: &[SpaceVertex]) -> Vec<[f64; 3]> {
    ring.iter().map(|v| v.at).collect()
}

pub const fn edge_link(idx: usize) -> Link {
    Link::nth("edge", idx)
}

pub const fn triangle_link(idx: usize) -> Link {
    Link::nth("triangle", idx)
}

/// A triangle's name, in its middle.
pub fn triangle_label(idx: usize, triangle: &[SpaceVertex; 3]) -> Mark3 {
    label_amid(triangle, name(triangle_symbol(idx))).linked(triangle_link(idx))
}

pub fn label_amid(corners: &[SpaceVertex], text: impl Into<Value>) -> Mark3 {
    let middle = |i: usize| corners.iter().map(|v| v.at[i]).sum::<f64>() / corners.len() as f64;
    Mark3::new(Role::Ink, Shape3::Label([0, 1, 2].map(middle))).labelled(text)
}

pub fn given(corners: &[[f64; 3]; 3]) -> Vec<Mark3> {
    let edge = |i: usize| {
        let ends = [corners[i], corners[(i + 1) % 3]];
        let edge = Mark3::new(Role::Discarded, Shape3::Segment(ends)).edge();
        edge.linked(edge_link(i))
    };
    (0..3).map(edge).collect()
}

pub fn kept(outline: Vec<[f64; 3]>, role: Role) -> Vec<Mark3> {
    vec![
        Mark3::new(role, Shape3::Wash(outline.clone())),
        Mark3::new(role, Shape3::Outline(outline)),
    ]
}

pub fn lost(ring: &[SpaceVertex], plane: &Plane) -> Option<Mark3> {
    let outside = clipped(&places(ring), &plane.turned());
    (outside.len() > 2).then(|| Mark3::new(Role::Discarded, Shape3::Wash(outside)))
}

pub fn plane_mark(scenery: &Scenery, plane_idx: usize) -> Vec<Mark3> {
    let side = VolumeSide::ALL.get(plane_idx);
    side.map_or_else(Vec::new, |&side| {
        plane_at_work(scenery.scene().culler(), side)
    })
}

/// A vertex of the list: hollow where it is outside, small where it has not been looked at.
pub fn vertex(idx: usize, v: &SpaceVertex, inside: Option<bool>) -> Mark3 {
    let (role, shape) = match inside {
        Some(true) => (Role::Accent, Shape3::Dot(v.at)),
        Some(false) => (Role::Discarded, Shape3::Ring(v.at)),
        None => (Role::Soft, Shape3::Dot(v.at)),
    };
    Mark3::new(role, shape).labelled(label(vertex_symbol(idx), v.uv))
}

/// `V₀: d₀ = 0`
pub fn measured(idx: usize, d: f64) -> Formula {
    sym(format!("{}: d{}", vertex_symbol(idx), subscript(idx))).equals(d)
}

pub fn cut(idx: usize, v: &SpaceVertex) -> Mark3 {
    let mark = Mark3::new(Role::Signal, Shape3::Dot(v.at));
    let mark = mark.labelled(label(cut_symbol(idx), v.uv));
    // With its place in the texture the label is long enough.
    if v.uv.is_none() { mark.strong() } else { mark }
}

/// `V₂ (1, 1/4)` where it has a place in the texture.
fn label(symbol: String, uv: Option<[f64; 2]>) -> Value {
    match uv {
        Some(uv) => Value::Formula(sym(symbol + " ").point(uv)),
        None => name(symbol),
    }
}
