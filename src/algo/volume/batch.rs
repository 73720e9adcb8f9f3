//! Many triangles before the divide, as a renderer has them: by their codes most are inside or outside and are not copied; the
//! others are cut between the same two polygons, side by side as [`HomogeneousTriangle`](super::HomogeneousTriangle) does and to the
//! same bits.
//!
//! ```
//! use clipscope::algo::volume::{ClipVertex, clip_triangles};
//! let at = |x: f64, w: f64| ClipVertex { at: [x, 0.0, 0.5 * x, w], attributes: () };
//! let up = |x: f64, w: f64| ClipVertex { at: [x, 1.0, 0.0, w], attributes: () };
//! let inside = [at(0.0, 2.0), at(1.0, 2.0), up(0.0, 2.0)];
//! let outside = [at(3.0, 1.0), at(4.0, 1.0), up(3.0, 1.0)];
//! let cut = [at(0.0, 1.0), at(4.0, 1.0), up(0.0, 1.0)];
//! let mut left = Vec::new();
//! clip_triangles(&[inside, outside, cut], &mut left);
//! assert_eq!(left.len(), 1 + 2);
//! assert_eq!(left[0], inside);
//! ```

use crate::{algo::ring::Lists, geom::VolumeSide};

use super::{
    Attributes, ClipVertex, SideCode, clip_vertex::ClipPolygon, space_vertex::independent,
};

/// Appends what is left of each triangle, in order.
pub fn clip_triangles<A: Attributes>(
    given: &[[ClipVertex<A>; 3]],
    left: &mut Vec<[ClipVertex<A>; 3]>,
) {
    let Some(first) = given.first() else { return };
    let polygon = ClipPolygon::of(first);
    let mut lists = Lists::new([polygon, polygon.emptied()]);
    for triangle in given {
        let [a, b, c] = triangle;
        let [code_a, code_b, code_c] = [SideCode::of(a.at), SideCode::of(b.at), SideCode::of(c.at)];
        let or = code_a.or(code_b).or(code_c);
        if !code_a.and(code_b).and(code_c).is_inside() {
            continue;
        }
        if or.is_inside() {
            if independent([a.at, b.at, c.at]) {
                left.push(*triangle);
            }
        } else {
            lists.list_mut().begin(triangle);
            for side in VolumeSide::ALL.into_iter().filter(|&side| or.has(side)) {
                lists.pass(&side);
            }
            left.extend(lists.list().triangles());
        }
    }
}
