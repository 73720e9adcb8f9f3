//! A triangle and what is left of it, in the observer's view.

use crate::{
    algo::volume::{SpaceVertex, clipped},
    figure::{Link, Mark3, Role, Shape3},
    geom::{Plane, VolumeSide},
    labs::words::name,
    text::{Formula, Value},
};

use super::{
    super::{
        super::stage::{Scenery, plane_at_work},
        planes::perpendicular,
    },
    symbols::{cut_symbol, vertex_symbol},
};

pub fn places(ring: &[SpaceVertex]) -> Vec<[f64; 3]> {
    ring.iter().map(|v| v.at).collect()
}

/// What marks and rows about an edge of the triangle have in common.
pub const fn edge_link(idx: usize) -> Link {
    Link::nth("edge", idx)
}

/// The triangle as it was given, edge by edge.
pub fn given(corners: &[[f64; 3]; 3]) -> Vec<Mark3> {
    let edge = |i: usize| {
        let ends = [corners[i], corners[(i + 1) % 3]];
        let edge = Mark3::new(Role::Discarded, Shape3::Segment(ends)).edge();
        edge.linked(edge_link(i))
    };
    (0..3).map(edge).collect()
}

/// A convex part that is kept.
pub fn kept(ring: &[SpaceVertex], role: Role) -> Vec<Mark3> {
    vec![
        Mark3::new(role, Shape3::Wash(places(ring))),
        Mark3::new(role, Shape3::Outline(places(ring))),
    ]
}

/// What a plane takes away of a convex part.
pub fn lost(ring: &[SpaceVertex], plane: &Plane) -> Option<Mark3> {
    let outside = clipped(&places(ring), &plane.turned());
    (outside.len() > 2).then(|| Mark3::new(Role::Discarded, Shape3::Wash(outside)))
}

/// The plane whose turn it is.
pub fn plane_mark(scenery: &Scenery, plane_idx: usize) -> Vec<Mark3> {
    let side = VolumeSide::ALL.get(plane_idx);
    side.map_or_else(Vec::new, |&side| {
        plane_at_work(scenery.scene().culler(), side)
    })
}

/// The distance of the vertex that is looked at.
pub fn distance_mark(plane: &Plane, at: [f64; 3], d: f64) -> Vec<Mark3> {
    let label = Formula::default().sym("d").equals(d);
    perpendicular(plane, at, d, label)
}

/// A vertex of the list: hollow where it is outside, small where it has not been looked at.
pub fn vertex(idx: usize, at: [f64; 3], inside: Option<bool>) -> Mark3 {
    let (role, shape) = match inside {
        Some(true) => (Role::Accent, Shape3::Dot(at)),
        Some(false) => (Role::Discarded, Shape3::Ring(at)),
        None => (Role::Soft, Shape3::Dot(at)),
    };
    Mark3::new(role, shape).labelled(name(vertex_symbol(idx)))
}

/// Where an edge crosses the plane.
pub fn cut(idx: usize, at: [f64; 3]) -> Mark3 {
    Mark3::new(Role::Signal, Shape3::Dot(at))
        .labelled(name(cut_symbol(idx)))
        .strong()
}

/// From cut to cut.
pub fn cut_edge(cuts: &[[f64; 3]]) -> Option<Mark3> {
    let ends: [[f64; 3]; 2] = cuts.try_into().ok()?;
    Some(Mark3::new(Role::Signal, Shape3::Segment(ends)))
}

/// `V₂: uv = (1, 1/4)` where it has a place in the texture.
pub fn with_texel(mark: Mark3, symbol: &str, uv: Option<[f64; 2]>) -> Mark3 {
    match uv {
        Some(uv) => mark.labelled(Value::Formula(
            Formula::default().sym(format!("{symbol} ")).point(uv),
        )),
        None => mark,
    }
}
