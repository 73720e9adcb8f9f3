//! A triangle against planes, one plane after the other: each takes a list of triangles and leaves a list of triangles. What a
//! plane leaves of a triangle is a triangle, or a quadrilateral, which is split at its first vertex. The data are simple; but a
//! diagonal that one plane drew, the next one cuts: there are more triangles in the end, and more crossings, than
//! [`super::IntersectionPolygon`] has.
//!
//! *Exact*: as there, the pieces of one triangle among those that share an edge. *Degenerate*: a triangle without area leaves
//! none; what only touches a plane from outside is dropped. *Cost*: three multiplications, three additions and a comparison for
//! each corner of each triangle and plane; for a crossing a mean of each coordinate.
//!
//! *Source*: D. H. Eberly, *3D Game Engine Design*, second edition, Morgan Kaufmann 2006, section 2.4.
//!
//! ```
//! use clipscope::{algo::volume::{PlaneAtATime, SpaceVertex, TrianglePlanes}, geom::Plane, trace::silent};
//! let planes = vec![Plane::new([0.0, 1.0, 0.0, 0.0])?];
//! let triangle = [[0.0, 2.0, 0.0], [-2.0, -2.0, 0.0], [2.0, 2.0, 0.0]].map(SpaceVertex::new);
//! let left = silent::<PlaneAtATime>(&TrianglePlanes { planes, triangle });
//! assert_eq!((left.triangles.len(), left.n_crossings), (2, 2));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::{convert::Infallible, marker::PhantomData};

use serde::Serialize;

use crate::{
    algo::{
        parameter::Ratio,
        ring::{Clip, Crossing, Happening, Right},
    },
    trace::{Method, Real, Tell, Told},
};

use super::{
    CutTriangles, SpaceVertex, TrianglePlanes, VolumeRules, has_area,
    space_vertex::{LastPlane, fan},
};

/// The algorithm, by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct PlaneAtATime<L = Right>(PhantomData<L>);

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum PlaneAtATimeEvent {
    /// The next plane's turn.
    Plane {
        /// As they were given.
        plane_idx: usize,
        /// How many triangles it takes.
        n_triangles: usize,
    },
    /// A triangle of the list is asked.
    Triangle {
        /// In the list.
        triangle_idx: usize,
        /// Its corners' signed distances from the plane.
        distances: [f64; 3],
        /// Are they inside?
        inside: [bool; 3],
    },
    /// An edge of it crosses the plane.
    Cross {
        /// Of the triangle's corners those that it runs between.
        idx: [usize; 2],
        /// I
        at: SpaceVertex,
        /// Where from the first of them to the second.
        t: Ratio,
    },
    /// A piece is appended to the next list.
    Piece {
        /// Its corners.
        triangle: [SpaceVertex; 3],
    },
    /// The next list becomes the list.
    Pass {
        /// The plane that is done with.
        plane_idx: usize,
        /// How many triangles there are now.
        n_triangles: usize,
    },
    /// No plane is left, or no triangle.
    Done {
        /// How many triangles are left.
        n_triangles: usize,
    },
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct PlaneAtATimeHeld {
    /// The list that is cut, which is the answer after the end, and what that has cost so far.
    pub left: CutTriangles,
    /// The list that grows; after a pass, the one that was cut.
    pub next: Vec<[SpaceVertex; 3]>,
}

impl<L: VolumeRules> Method for PlaneAtATime<L> {
    type Input = TrianglePlanes;
    type Held = PlaneAtATimeHeld;
    type Output = CutTriangles;
    type Event = PlaneAtATimeEvent;

    /// The first list is empty where there is nothing to fill.
    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        let triangle = Some(input.triangle).filter(has_area);
        PlaneAtATimeHeld {
            left: CutTriangles {
                triangles: triangle.into_iter().collect(),
                n_crossings: 0,
                has_uv: input.has_uv(),
            },
            next: Vec::new(),
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use PlaneAtATimeEvent as Event;
        for (plane_idx, plane) in LastPlane::<L>::all(&input.planes).enumerate() {
            let n_triangles = held.left.triangles.len();
            if n_triangles == 0 {
                break;
            }
            held.next.clear();
            held.next.reserve(2 * n_triangles);
            let turn = Event::Plane {
                plane_idx,
                n_triangles,
            };
            tell.tell(held, turn)?;
            for triangle_idx in 0..n_triangles {
                let split = Split::of::<L, R>(plane, &held.left.triangles[triangle_idx]);
                let asked = Event::Triangle {
                    triangle_idx,
                    distances: split.distances,
                    inside: split.inside,
                };
                tell.tell(held, asked)?;
                for (idx, Crossing { at, t }) in split.crossings {
                    held.left.n_crossings += 1;
                    tell.tell(held, Event::Cross { idx, at, t })?;
                }
                for triangle in split.pieces {
                    held.next.push(triangle);
                    tell.tell(held, Event::Piece { triangle })?;
                }
            }
            std::mem::swap(&mut held.left.triangles, &mut held.next);
            let n_triangles = held.left.triangles.len();
            let pass = Event::Pass {
                plane_idx,
                n_triangles,
            };
            tell.tell(held, pass)?;
        }
        let n_triangles = held.left.triangles.len();
        tell.tell(held, Event::Done { n_triangles })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held.left
    }

    /// The end; for each plane its turn and its pass, and for each triangle of its list, of which there may be twice as many as
    /// before, a test, two crossings and two pieces.
    fn max_events(input: &Self::Input) -> usize {
        let (mut n, mut total) = (1_usize, 1_usize);
        for _ in &input.planes {
            let cut = n.saturating_mul(5).saturating_add(2);
            total = total.saturating_add(cut);
            n = n.saturating_mul(2);
        }
        total
    }
}

/// A triangle against a plane.
struct Split {
    distances: [f64; 3],
    inside: [bool; 3],
    /// Between which corners.
    crossings: Vec<([usize; 2], Crossing<SpaceVertex>)>,
    pieces: Vec<[SpaceVertex; 3]>,
}

impl Split {
    fn of<L: VolumeRules, R: Real>(plane: LastPlane<'_, L>, corners: &[SpaceVertex; 3]) -> Self {
        let (mut distances, mut inside) = ([0.0; 3], [false; 3]);
        let (mut crossings, mut ring) = (Vec::new(), Vec::with_capacity(4));
        let mut edge = [0; 2];
        let mut note = |happening: Happening<SpaceVertex>| {
            match happening {
                Happening::First(first) => {
                    (distances[0], inside[0]) = (first.distance, first.inside);
                }
                Happening::Test(test) => {
                    edge = test.idx;
                    let [_, end] = edge;
                    (distances[end], inside[end]) = (test.distances[1], test.rule.ends_inside());
                }
                Happening::Cross(crossing) => crossings.push((edge, crossing)),
                Happening::Output(vertex) => ring.push(vertex),
            }
            Told::<Infallible>::Continue(())
        };
        let [first, second, third] = *corners;
        let mut clip = Clip::begin::<L, R>(&plane, first);
        let Told::Continue(()) = clip.tell_first(&plane, &mut note);
        let Told::Continue(()) = clip.vertex::<L, R, _>(&plane, ([0, 1], second), &mut note);
        let Told::Continue(()) = clip.vertex::<L, R, _>(&plane, ([1, 2], third), &mut note);
        let Told::Continue(()) = clip.close::<L, R, _>(&plane, [2, 0], &mut note);
        if !L::CUTS_FROM_PLANE && distances[0] == 0.0 && distances[1].max(distances[2]) > 0.0 {
            crossings.clear();
            ring = corners.to_vec();
        }
        Self {
            distances,
            inside,
            crossings,
            pieces: fan(&ring),
        }
    }
}
