//! From a mesh to triangles on the screen.

use crate::{
    algo::volume::{ClipVertex, HomogeneousTriangle, SideCode},
    geom::Matrix,
    trace::silent,
};

use super::{
    ScreenTriangle, Viewport,
    screen_triangle::{Corner, double_area},
};

/// Which faces are left out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cull {
    /// None: both sides are drawn.
    Nothing,
    /// Those that run clockwise as seen.
    Clockwise,
    /// Those that run counter-clockwise.
    CounterClockwise,
}

impl Cull {
    /// Corners on the screen, y down.
    #[inline]
    fn leaves_out(self, corners: [[i32; 2]; 3]) -> bool {
        match self {
            Self::Nothing => false,
            Self::Clockwise => double_area(corners) > 0,
            Self::CounterClockwise => double_area(corners) < 0,
        }
    }
}

/// A mesh to draw: vertices, what travels with each of them, and triangles by three indices.
#[derive(Clone, Copy, Debug)]
pub struct MeshRef<'a, const N: usize> {
    /// Of the vertices; all finite.
    pub positions: &'a [[f32; 3]],
    /// One for each vertex.
    pub attributes: &'a [[f32; N]],
    /// Three vertices each, counter-clockwise as seen from outside. One that names no vertex is left out.
    pub faces: &'a [[u32; 3]],
    /// The id of the first face; the next has one more.
    pub first_id: u32,
}

#[derive(Clone, Copy)]
pub(super) struct Seen {
    code: SideCode,
    at: [i32; 2],
    /// (z/w + 1) / 2
    depth: f64,
    inverse_w: f64,
}

impl Seen {
    /// Inside, w > 0 but for one point, which lands in a corner.
    #[inline]
    pub(super) fn new(at @ [x, y, z, w]: [f64; 4], viewport: &Viewport) -> Self {
        let inverse_w = 1.0 / w;
        Self {
            code: SideCode::of(at),
            at: viewport.snapped([x * inverse_w, y * inverse_w]),
            depth: 0.5 + 0.5 * (z * inverse_w),
            inverse_w,
        }
    }

    #[inline]
    fn with<const N: usize>(&self, attributes: [f32; N]) -> Corner<N> {
        Corner {
            at: self.at,
            depth: self.depth,
            inverse_w: self.inverse_w,
            attributes,
        }
    }
}

/// Appends what is to be drawn, face by face: clipped, divided, snapped, culled, and covering a middle of a row and of a column.
pub fn assemble<const N: usize>(
    mesh: &MeshRef<'_, N>,
    clip_from_model: &Matrix,
    viewport: &Viewport,
    cull: Cull,
    triangles: &mut Vec<ScreenTriangle<N>>,
) {
    let in_clip_space =
        |[x, y, z]: [f32; 3]| clip_from_model.times([x.into(), y.into(), z.into(), 1.0]);
    let n_vertices = mesh.positions.len().min(mesh.attributes.len());
    let (positions, attributes) = (
        &mesh.positions[..n_vertices],
        &mesh.attributes[..n_vertices],
    );
    let vertices: Vec<Seen> = positions
        .iter()
        .map(|&position| Seen::new(in_clip_space(position), viewport))
        .collect();
    for (id, face) in (mesh.first_id..).zip(mesh.faces) {
        let [a, b, c] = face.map(|i| i as usize);
        let (Some(seen_a), Some(seen_b), Some(seen_c)) =
            (vertices.get(a), vertices.get(b), vertices.get(c))
        else {
            continue;
        };
        let vertex = |i: usize| ClipVertex {
            at: in_clip_space(positions[[a, b, c][i]]),
            attributes: attributes[[a, b, c][i]],
        };
        for_each_piece(
            [seen_a, seen_b, seen_c],
            vertex,
            viewport,
            cull,
            |corners| {
                if reaches_middles(&corners, viewport) {
                    triangles.extend(ScreenTriangle::new(id, &corners, viewport));
                }
            },
        );
    }
}

#[inline]
fn reaches_middles<const N: usize>(corners: &[Corner<N>; 3], viewport: &Viewport) -> bool {
    [0, 1].into_iter().all(|axis| {
        let [a, b, c] = corners.each_ref().map(|corner| corner.at[axis]);
        viewport.first_middle(a.min(b).min(c)) < viewport.first_middle(a.max(b).max(c))
    })
}

/// Calls back with what clipping before the divide leaves of a triangle, but what is culled. Only what is clipped asks for vertices.
#[inline]
pub(super) fn for_each_piece<const N: usize>(
    [a, b, c]: [&Seen; 3],
    vertex: impl Fn(usize) -> ClipVertex<[f32; N]>,
    viewport: &Viewport,
    cull: Cull,
    mut put: impl FnMut([Corner<N>; 3]),
) {
    let (or, and) = (a.code.or(b.code).or(c.code), a.code.and(b.code).and(c.code));
    if !and.is_inside() {
        return;
    }
    if or.is_inside() {
        if !cull.leaves_out([a.at, b.at, c.at]) {
            let attributes = |i: usize| vertex(i).attributes;
            put([
                a.with(attributes(0)),
                b.with(attributes(1)),
                c.with(attributes(2)),
            ]);
        }
        return;
    }
    let polygon = silent::<HomogeneousTriangle<[f32; N]>>(&[vertex(0), vertex(1), vertex(2)]);
    let corner =
        |vertex: &ClipVertex<[f32; N]>| Seen::new(vertex.at, viewport).with(vertex.attributes);
    let Some((first, rest)) = polygon.vertices().split_first() else {
        return;
    };
    let first = corner(first);
    for pair in rest.windows(2) {
        let corners = [first, corner(&pair[0]), corner(&pair[1])];
        if !cull.leaves_out(corners.each_ref().map(|corner| corner.at)) {
            put(corners);
        }
    }
}
