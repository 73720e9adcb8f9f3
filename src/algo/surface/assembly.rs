//! From a mesh to triangles on the screen.

use crate::{
    algo::volume::{ClipVertex, HomogeneousTriangle, SideCode},
    geom::Matrix,
    trace::silent,
};

use super::{ScreenTriangle, Viewport, screen_triangle::Corner};

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

/// A vertex in clip space, and on the screen if it is inside.
#[derive(Clone, Copy)]
pub(super) struct Seen<const N: usize> {
    clip: ClipVertex<[f32; N]>,
    code: SideCode,
    corner: Corner<N>,
}

impl<const N: usize> Seen<N> {
    #[inline]
    pub(super) fn new(clip: ClipVertex<[f32; N]>, viewport: &Viewport) -> Self {
        Self {
            clip,
            code: SideCode::of(clip.at),
            corner: corner(&clip, viewport),
        }
    }
}

/// Appends to `triangles` what is to be drawn of a mesh, in the order of its faces: clipped, divided, snapped, culled.
pub fn assemble<const N: usize>(
    mesh: &MeshRef<'_, N>,
    clip_from_model: &Matrix,
    viewport: &Viewport,
    cull: Cull,
    triangles: &mut Vec<ScreenTriangle<N>>,
) {
    let vertices: Vec<Seen<N>> = mesh
        .positions
        .iter()
        .zip(mesh.attributes)
        .map(|(&[x, y, z], &attributes)| {
            let at = clip_from_model.times([x.into(), y.into(), z.into(), 1.0]);
            Seen::new(ClipVertex { at, attributes }, viewport)
        })
        .collect();
    for (id, face) in (mesh.first_id..).zip(mesh.faces) {
        let corners = face.map(|i| vertices.get(i as usize));
        let [Some(a), Some(b), Some(c)] = corners else {
            continue;
        };
        for_each_piece([a, b, c], viewport, |corners| {
            let double_area = ScreenTriangle::double_area(&corners);
            let is_left_out = match cull {
                Cull::Nothing => false,
                Cull::Clockwise => double_area > 0,
                Cull::CounterClockwise => double_area < 0,
            };
            if !is_left_out {
                triangles.extend(ScreenTriangle::new(id, &corners, viewport.pixel()));
            }
        });
    }
}

/// Calls back with the triangles that are left of one, clipped before the divide.
#[inline]
pub(super) fn for_each_piece<const N: usize>(
    [a, b, c]: [&Seen<N>; 3],
    viewport: &Viewport,
    mut put: impl FnMut([Corner<N>; 3]),
) {
    let (or, and) = (a.code.or(b.code).or(c.code), a.code.and(b.code).and(c.code));
    if !and.is_inside() {
        return;
    }
    if or.is_inside() {
        put([a.corner, b.corner, c.corner]);
        return;
    }
    let polygon = silent::<HomogeneousTriangle<[f32; N]>>(&[a.clip, b.clip, c.clip]);
    let Some((first, rest)) = polygon.vertices().split_first() else {
        return;
    };
    let first = corner(first, viewport);
    for pair in rest.windows(2) {
        put([
            first,
            corner(&pair[0], viewport),
            corner(&pair[1], viewport),
        ]);
    }
}

/// On the screen: of a vertex that is inside, w > 0. Only the point of the volume where w is 0 lands anywhere, in a corner.
#[inline]
fn corner<const N: usize>(vertex: &ClipVertex<[f32; N]>, viewport: &Viewport) -> Corner<N> {
    let [x, y, z, w] = vertex.at;
    let inverse_w = 1.0 / w;
    Corner {
        at: viewport.snapped([x * inverse_w, y * inverse_w]),
        depth: 0.5 + 0.5 * (z * inverse_w),
        inverse_w,
        attributes: vertex.attributes,
    }
}
