//! Many triangles before the divide, as a renderer has them: most lie inside or outside, and need no clipper.
//!
//! ```text
//!   codes ──┬─ AND ≠ 0 ──▶ nothing
//!           ├─ OR = 0 ───▶ the triangle itself
//!           └─ else ─────▶ HomogeneousTriangle, and the fan of what it leaves
//! ```
//!
//! Codes are asked once more of those that are cut; whole triangles are not copied into a polygon and out of it. The answer is bit
//! for bit that of [`HomogeneousTriangle`], which is what cuts.
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

use crate::trace::silent;

use super::{Attributes, ClipVertex, HomogeneousTriangle, SideCode, space_vertex::independent};

/// Appends what is left of each triangle, in order.
pub fn clip_triangles<A: Attributes>(
    given: &[[ClipVertex<A>; 3]],
    left: &mut Vec<[ClipVertex<A>; 3]>,
) {
    for triangle in given {
        let [a, b, c] = triangle.each_ref().map(|v| SideCode::of(v.at));
        if !a.and(b).and(c).is_inside() {
            continue;
        }
        if a.or(b).or(c).is_inside() {
            let has_area = independent(triangle.each_ref().map(|v| v.at));
            left.extend(has_area.then_some(*triangle));
        } else {
            left.extend(silent::<HomogeneousTriangle<A>>(triangle).triangles());
        }
    }
}
