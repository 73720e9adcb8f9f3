//! From space to the plane: what an eye sees, as marks that painter, labels, pointer and export know already.
//!
//! ```text
//!    eye ●───────────╱▔╲            hidden by a facet is what lies behind its plane and, seen from the eye,
//!         ╲      A ━╱━━━╲┅┅┅ B      within its edges: the part of a segment on the inner side of those planes,
//!          ╲       ╲____╱          found as a clipper finds it, with an interval of the parameter
//! ```
//!
//! Lines are cut at the plane in front of the eye first; nothing behind it is ever divided by its depth.

use glam::DVec3;

use crate::{
    algo::parameter::{Interval, Param},
    geom::Orbit,
};

use super::{Facet, Mark, Mark3, Role, Shape, Shape3, Space};

/// A segment hides behind a facet only from this part of the eye's distance on: edges lie in the planes of their own
/// facets, as exactly as rounding lets them.
const BEHIND: f64 = 1e-9;
/// Parts of a segment shorter than this share of it are what that rounding leaves at its ends, not to be seen.
const SLIVER: f64 = 1e-6;

/// How places in the world and on a drawing belong together.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Lens {
    /// The drawing is the plane z = 0.
    Plane,
    /// The drawing is what an eye sees.
    Eye(Orbit),
}

impl Lens {
    /// Where a world point is drawn; `None` where it is behind the eye.
    #[must_use]
    pub fn drawing_from_world(&self, at: [f64; 3]) -> Option<[f64; 2]> {
        match self {
            Self::Plane => Some([at[0], at[1]]),
            Self::Eye(eye) => {
                let view = eye.view_from_world(at);
                (view[2] < -eye.near()).then(|| eye.picture_from_view(view))
            }
        }
    }

    /// The world point of a place on the drawing, as far away as `beside`.
    #[must_use]
    pub fn world_from_drawing(&self, at: [f64; 2], beside: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Plane => [at[0], at[1], 0.0],
            Self::Eye(eye) => {
                let [_, _, depth] = eye.view_from_world(beside);
                eye.world_from_view(eye.view_from_picture(at, depth))
            }
        }
    }
}

/// What `eye` sees of a space, on a picture whose lower edge is at y = −1 and upper at 1: the faces, the farthest first,
/// their edges, then the marks, each in two parts where a solid hides one.
///
/// Faces are sorted by their middles: right as long as no two solids interlock.
#[must_use]
pub fn project(space: &Space, eye: &Orbit) -> Vec<Mark> {
    let seen = Seen {
        eye,
        facets: space
            .facets
            .iter()
            .map(|facet| InView::of(facet, eye))
            .collect(),
    };
    let mut marks = seen.faces();
    for ends in edges(&space.facets) {
        marks.extend(seen.segment(&ends, Role::Ink, |ends| Shape::Path(ends.to_vec())));
    }
    for mark in &space.marks {
        marks.extend(seen.mark(mark));
    }
    marks
}

/// Every edge once, whichever facets share it.
fn edges(facets: &[Facet]) -> Vec<[[f64; 3]; 2]> {
    let mut known: Vec<[[f64; 3]; 2]> = Vec::new();
    for [a, b] in facets.iter().flat_map(Facet::edges) {
        if !known.contains(&[a, b]) && !known.contains(&[b, a]) {
            known.push([a, b]);
        }
    }
    known
}

/// A facet in the eye's own axes.
struct InView<'a> {
    facet: &'a Facet,
    corners: Vec<DVec3>,
    /// Away from the solid; not normalised.
    normal: DVec3,
}

impl<'a> InView<'a> {
    fn of(facet: &'a Facet, eye: &Orbit) -> Self {
        let corners: Vec<DVec3> = facet
            .corners
            .iter()
            .map(|&at| eye.view_from_world(at).into())
            .collect();
        let from_first = |i: usize| corners[i] - corners[0];
        let normal = (2..corners.len())
            .map(|i| from_first(i - 1).cross(from_first(i)))
            .sum();
        Self {
            facet,
            corners,
            normal,
        }
    }

    /// Does it show its outer side? The eye is at the origin.
    fn faces_eye(&self) -> bool {
        self.normal.dot(self.corners[0]) < 0.0
    }

    /// Planes whose common inner side is what the facet hides: behind it, and within its edges as seen from the eye.
    /// Each is a normal that points inwards, and a distance: n·p − d ≥ 0 is inside.
    fn shadow(&self) -> impl Iterator<Item = (DVec3, f64)> + '_ {
        let turn = if self.faces_eye() { 1.0 } else { -1.0 };
        let n = self.corners.len();
        let through_eye = (0..n).map(move |i| {
            let normal = self.corners[(i + 1) % n].cross(self.corners[i]) * turn;
            (normal, 0.0)
        });
        let back = -self.normal * turn;
        let depth = back.dot(self.corners[0]) * (1.0 + BEHIND);
        std::iter::once((back, depth)).chain(through_eye)
    }
}

/// What the eye sees.
struct Seen<'a> {
    eye: &'a Orbit,
    facets: Vec<InView<'a>>,
}

impl Seen<'_> {
    /// The faces that show their outer side, the farthest first.
    fn faces(&self) -> Vec<Mark> {
        let near = -self.eye.near();
        let mut seen: Vec<(f64, &InView<'_>)> = self
            .facets
            .iter()
            .filter(|facet| facet.faces_eye() && facet.corners.iter().all(|p| p.z < near))
            .map(|facet| {
                let depth: f64 = facet.corners.iter().map(|p| p.z).sum();
                (depth / facet.corners.len() as f64, facet)
            })
            .collect();
        seen.sort_by(|a, b| a.0.total_cmp(&b.0));
        let face = |(_, facet): (f64, &InView<'_>)| {
            let corners = facet.corners.iter().map(|&p| self.on_picture(p));
            Mark::new(facet.facet.role, Shape::Fill(vec![corners.collect()]))
        };
        seen.into_iter().map(face).collect()
    }

    fn on_picture(&self, at: DVec3) -> [f64; 2] {
        self.eye.picture_from_view(at.into())
    }

    fn mark(&self, mark: &Mark3) -> Vec<Mark> {
        let finished = |mut drawn: Mark| {
            (drawn.label, drawn.link) = (mark.label.clone(), mark.link);
            drawn
        };
        let point = |at: &[f64; 3], shape: fn([f64; 2]) -> Shape| {
            let view: DVec3 = self.eye.view_from_world(*at).into();
            let is_seen = view.z < -self.eye.near();
            let drawn = is_seen.then(|| Mark::new(mark.role, shape(self.on_picture(view))));
            drawn.map(finished).into_iter().collect()
        };
        match &mark.shape {
            Shape3::Segment(ends) => {
                let mut drawn = self.segment(ends, mark.role, Shape::Segment);
                // Its name stands once, where it is seen.
                let named = drawn.iter().position(|part| !part.is_dashed).unwrap_or(0);
                for (i, part) in drawn.iter_mut().enumerate() {
                    part.link = mark.link;
                    part.label = mark.label.clone().filter(|_| i == named);
                }
                drawn
            }
            Shape3::Dot(at) => point(at, Shape::Dot),
            Shape3::Ring(at) => point(at, Shape::Ring),
        }
    }

    /// The hidden parts of a segment, dashed and soft, and its visible ones, of this shape and role.
    fn segment(
        &self,
        ends: &[[f64; 3]; 2],
        role: Role,
        shape: impl Fn([[f64; 2]; 2]) -> Shape,
    ) -> Vec<Mark> {
        let ends = ends.map(|at| DVec3::from(self.eye.view_from_world(at)));
        let before_eye = [(DVec3::NEG_Z, self.eye.near())];
        let Some([from, to]) = inside(ends, before_eye) else {
            return Vec::new();
        };
        let ends = [from, to].map(|t| ends[0].lerp(ends[1], t));
        let hidden = self
            .facets
            .iter()
            .filter_map(|facet| inside(ends, facet.shadow()));
        let hidden = union(hidden.collect());
        let part =
            |[from, to]: [f64; 2]| [from, to].map(|t| self.on_picture(ends[0].lerp(ends[1], t)));
        let visible = complement(&hidden);
        let visible = visible.into_iter().map(|t| Mark::new(role, shape(part(t))));
        let hidden = hidden.iter().map(|&t| {
            let under = Shape::Path(part(t).to_vec());
            Mark::new(Role::Soft, under).dashed()
        });
        hidden.chain(visible).collect()
    }
}

/// The part of a segment that lies on the inner side of all planes, as an interval of its parameter.
fn inside([a, b]: [DVec3; 2], planes: impl IntoIterator<Item = (DVec3, f64)>) -> Option<[f64; 2]> {
    let mut left = Interval::<f64, [f64; 2]>::whole();
    for (normal, d) in planes {
        let distances = [a, b].map(|p| normal.dot(p) - d);
        let [d1, d2] = distances;
        if d1 == d2 {
            if d1 < 0.0 {
                return None;
            }
            continue;
        }
        let crossing = Param {
            u: d1 / (d1 - d2),
            border: Some(distances),
            leaving: d2 < d1,
        };
        left.shrink(crossing, |border| border, |_| false);
        if left.is_empty(|border| border) {
            return None;
        }
    }
    let [from, to] = left.values();
    (to - from > SLIVER).then_some([from, to])
}

/// Overlapping intervals joined, in order.
fn union(mut intervals: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for [from, to] in intervals {
        match joined.last_mut() {
            Some(last) if from <= last[1] => last[1] = last[1].max(to),
            _ => joined.push([from, to]),
        }
    }
    joined
}

/// What is left of 0 to 1 between intervals in order.
fn complement(intervals: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let starts = std::iter::once(0.0).chain(intervals.iter().map(|part| part[1]));
    let ends = intervals.iter().map(|part| part[0]).chain([1.0]);
    let gaps = starts.zip(ends).map(|(from, to)| [from, to]);
    gaps.filter(|[from, to]| to - from > SLIVER).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube from −1 to 1.
    fn cube() -> Vec<Facet> {
        let face = |axis: usize, side: f64| {
            let corner = |[u, v]: [f64; 2]| {
                let mut at = [0.0; 3];
                at[axis] = side;
                at[(axis + 1) % 3] = u * side;
                at[(axis + 2) % 3] = v;
                at
            };
            let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            Facet {
                corners: square.map(corner).to_vec(),
                role: Role::Accent,
            }
        };
        (0..3)
            .flat_map(|axis| [-1.0, 1.0].map(|side| face(axis, side)))
            .collect()
    }

    fn seen(marks: Vec<Mark3>, eye: &Orbit) -> Vec<Mark> {
        let space = Space {
            eye: *eye,
            facets: cube(),
            marks,
        };
        project(&space, eye)
    }

    #[test]
    fn of_a_cube_three_faces_are_seen_and_three_edges_hidden() {
        for angles in [[30.0, 20.0], [-50.0, -35.0], [200.0, 10.0]] {
            let eye = Orbit::new([0.0; 3], angles, 8.0, 30.0);
            let marks = seen(Vec::new(), &eye);
            let n = |is: fn(&Mark) -> bool| marks.iter().filter(|mark| is(mark)).count();
            assert_eq!(
                n(|mark| matches!(mark.shape, Shape::Fill(_))),
                3,
                "{angles:?}"
            );
            let edges = [
                n(|mark| matches!(mark.shape, Shape::Path(_)) && !mark.is_dashed),
                n(|mark| mark.is_dashed),
            ];
            assert_eq!(edges, [9, 3], "{angles:?}");
        }
    }

    #[test]
    fn a_segment_through_the_cube_is_dashed_inside_and_behind_it() {
        let eye = Orbit::new([0.0; 3], [0.0, 0.0], 10.0, 30.0);
        let line = Mark3::new(
            Role::Signal,
            Shape3::Segment([[-3.0, 0.0, 2.0], [3.0, 0.0, -2.0]]),
        );
        let marks = seen(vec![line], &eye);
        let drawn: Vec<(bool, [[f64; 2]; 2])> = marks
            .iter()
            .filter_map(|mark| {
                let ends = match &mark.shape {
                    Shape::Segment(ends) => *ends,
                    Shape::Path(points) => [points[0], points[1]],
                    _ => return None,
                };
                let is_level = ends[0][1] == 0.0 && ends[1][1] == 0.0;
                is_level.then_some((mark.is_dashed, ends))
            })
            .collect();
        // From the left edge of the front, behind which it goes in and comes out, to the right one.
        let [(true, hidden), (false, before), (false, after)] = drawn[..] else {
            panic!("one hidden part between two visible ones, not {drawn:?}");
        };
        assert_eq!([hidden[0], hidden[1]], [before[1], after[0]]);
        for (end, side) in [-1.0, 1.0].into_iter().enumerate() {
            let edge = eye.picture_from_view(eye.view_from_world([side, 0.0, 1.0]));
            assert!(
                (hidden[end][0] - edge[0]).abs() < 1e-9,
                "{hidden:?}, not {edge:?}"
            );
        }
    }

    #[test]
    fn what_is_behind_the_eye_is_cut_off_before_it_is_divided() {
        let eye = Orbit::new([0.0; 3], [0.0, 0.0], 10.0, 30.0);
        let line = |from: f64, to: f64| {
            let ends = [[2.0, 2.0, from], [2.0, 2.0, to]];
            Mark3::new(Role::Signal, Shape3::Segment(ends))
        };
        let signal = |marks: Vec<Mark>| -> Vec<[[f64; 2]; 2]> {
            let ends = marks.into_iter().filter_map(|mark| match mark.shape {
                Shape::Segment(ends) if mark.role == Role::Signal => Some(ends),
                _ => None,
            });
            ends.collect()
        };
        let [near, far] = [20.0, 30.0].map(|to| signal(seen(vec![line(0.0, to)], &eye)));
        let end = |i: usize| (near[0][1][i] - far[0][1][i]).abs() / near[0][1][i].abs();
        assert!(
            end(0) < 1e-9 && end(1) < 1e-9,
            "both end before the eye: {near:?} {far:?}"
        );
        assert!(near[0][1][0] > near[0][0][0], "{near:?}: not mirrored");
        assert!(signal(seen(vec![line(12.0, 30.0)], &eye)).is_empty());
    }
}
