//! A triangle against planes, one plane after the other: each takes a list of triangles and leaves a list of triangles.
//!
//! ```text
//!   vertices inside:  3 kept whole     2 a quadrilateral,    1 one triangle     0 dropped
//!                                        two triangles
//!                        ╱╲               ╱╲                    ╱╲                 ──────
//!                       ╱  ╲             ╱  ╲                  ╱  ╲                  ╱╲
//!                      ╱────╲           ╱ ╲  ╲               ──────                 ╱  ╲
//!                     ────────         ──────────
//! ```
//!
//! 1. The list is the triangle.
//! 2. Each plane splits each triangle of the list; what lies inside is a triangle, or a quadrilateral, which is split at its first
//!    vertex.
//! 3. The triangles that are left are the next plane's list.
//!
//! Only triangles are ever held, which makes for simple data; but a diagonal that one plane drew, the next one cuts. So there are
//! more triangles in the end, and more crossings, than [`super::IntersectionPolygon`] has.
//!
//! *Conventions*: planes in the order in which they are given; normals point inside; closed; pieces keep order and winding.
//! *Exact*: on a plane across an axis the crossing's coordinate is assigned; triangles that share an edge share its crossings, bit
//! for bit, the pieces of one triangle among them; clipping again changes nothing. *Degenerate*: a triangle without area leaves
//! none; what only touches a plane from outside is dropped. *Bound*: the number of triangles doubles at a plane at most; a plane has
//! its turn and its pass, a triangle one test, two crossings and two pieces; the end. *Cost*: three multiplications, three additions
//! and a comparison for each corner of each triangle and plane; for a crossing a mean of each coordinate.
//!
//! *Source*: D. H. Eberly, *3D Game Engine Design*, second edition, Morgan Kaufmann 2006, section 2.4.
//!
//! ```
//! use clipscope::{
//!     algo::volume::{PlaneAtATime, SpaceVertex, TrianglePlanes},
//!     geom::Plane,
//!     trace::silent,
//! };
//! let planes = vec![Plane::new([0.0, 1.0, 0.0, 0.0])?];
//! let triangle = [[0.0, 2.0, 0.0], [-2.0, -2.0, 0.0], [2.0, 2.0, 0.0]].map(SpaceVertex::new);
//! let left = silent::<PlaneAtATime>(&TrianglePlanes { planes, triangle });
//! assert_eq!((left.triangles.len(), left.n_crossings), (2, 2));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::{
        parameter::Ratio,
        ring::{Clip, Crossing, Happening, Right},
    },
    trace::{Algorithm, Real},
};

use super::{
    CutTriangles, SpaceVertex, TrianglePlanes, VolumeRules, cut_triangles::fan, has_area,
    space_vertex::LastPlane,
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

/// A triangle of the list against the plane.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AskedTriangle {
    /// In the list.
    pub triangle_idx: usize,
    /// Its corners' signed distances from the plane.
    pub distances: [f64; 3],
    /// Are they inside?
    pub inside: [bool; 3],
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct PlaneAtATimeState {
    /// The list that is cut; after the end, the answer.
    pub list: Vec<[SpaceVertex; 3]>,
    /// The list that grows.
    pub next: Vec<[SpaceVertex; 3]>,
    /// After a pass, until the next plane's turn: the list that was cut.
    pub passed: Vec<[SpaceVertex; 3]>,
    /// The plane whose turn it is.
    pub plane_idx: Option<usize>,
    /// Those of the list that this plane has been asked about, the last of them now.
    pub asked: Vec<AskedTriangle>,
    /// Which triangle of the list each of the next list comes from.
    pub origins: Vec<usize>,
    /// Its crossings, and between which corners they lie.
    pub crossings: Vec<([usize; 2], SpaceVertex, Ratio)>,
    /// Crossings with all planes so far.
    pub n_crossings: usize,
    /// Have corners places in a texture?
    pub has_uv: bool,
    /// Is there nothing left to do?
    pub is_done: bool,
}

impl<L: VolumeRules> Algorithm for PlaneAtATime<L> {
    type Input = TrianglePlanes;
    type Output = CutTriangles;
    type Event = PlaneAtATimeEvent;
    type State = PlaneAtATimeState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use PlaneAtATimeEvent as Event;
        let mut left = CutTriangles {
            triangles: start(input),
            n_crossings: 0,
            has_uv: input.has_uv(),
        };
        for plane_idx in 0..input.planes.len() {
            let Some(plane) = LastPlane::<L>::new(&input.planes, plane_idx) else {
                break;
            };
            if left.triangles.is_empty() {
                break;
            }
            let n_triangles = left.triangles.len();
            emit(Event::Plane {
                plane_idx,
                n_triangles,
            });
            let mut next = Vec::with_capacity(2 * n_triangles);
            for (triangle_idx, triangle) in left.triangles.iter().enumerate() {
                let split = Split::of::<L, R>(plane, triangle);
                emit(Event::Triangle {
                    triangle_idx,
                    distances: split.distances,
                    inside: split.inside,
                });
                for (idx, Crossing { at, t }) in split.crossings {
                    left.n_crossings += 1;
                    emit(Event::Cross { idx, at, t });
                }
                for triangle in split.pieces {
                    next.push(triangle);
                    emit(Event::Piece { triangle });
                }
            }
            left.triangles = next;
            let n_triangles = left.triangles.len();
            emit(Event::Pass {
                plane_idx,
                n_triangles,
            });
        }
        let n_triangles = left.triangles.len();
        emit(Event::Done { n_triangles });
        left
    }

    fn start(input: &Self::Input) -> Self::State {
        PlaneAtATimeState {
            list: start(input),
            has_uv: input.has_uv(),
            ..PlaneAtATimeState::default()
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        CutTriangles {
            triangles: state.list.clone(),
            n_crossings: state.n_crossings,
            has_uv: state.has_uv,
        }
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

/// The first list: empty where there is nothing to fill.
fn start(input: &TrianglePlanes) -> Vec<[SpaceVertex; 3]> {
    let triangle = Some(input.triangle).filter(has_area);
    triangle.into_iter().collect()
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
        let mut tell = |idx: [usize; 2], happening: Happening<SpaceVertex>| match happening {
            Happening::First {
                distance: d,
                inside: is_inside,
                ..
            } => (distances[0], inside[0]) = (plane.told(d), is_inside),
            Happening::Test {
                distances: [_, d],
                rule,
                ..
            } => {
                (distances[idx[1]], inside[idx[1]]) = (plane.told(d), rule.ends_inside());
            }
            Happening::Cross(crossing) => crossings.push((idx, crossing)),
            Happening::Output(vertex) => ring.push(vertex),
        };
        let [first, second, third] = *corners;
        let mut clip =
            Clip::<_, _, R>::begin::<L>(plane, first, &mut |happening| tell([0, 0], happening));
        clip.vertex::<L>(second, &mut |happening| tell([0, 1], happening));
        clip.vertex::<L>(third, &mut |happening| tell([1, 2], happening));
        clip.close::<L>(&mut |happening| tell([2, 0], happening));
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

impl PlaneAtATimeState {
    fn apply(&mut self, event: PlaneAtATimeEvent) {
        use PlaneAtATimeEvent as Event;
        match event {
            Event::Plane { plane_idx, .. } => {
                self.plane_idx = Some(plane_idx);
                self.passed.clear();
                self.asked.clear();
                self.origins.clear();
            }
            Event::Triangle {
                triangle_idx,
                distances,
                inside,
            } => {
                self.asked.push(AskedTriangle {
                    triangle_idx,
                    distances,
                    inside,
                });
                self.crossings.clear();
            }
            Event::Cross { idx, at, t } => {
                self.crossings.push((idx, at, t));
                self.n_crossings += 1;
            }
            Event::Piece { triangle } => {
                self.next.push(triangle);
                let asked = self.asked.last();
                self.origins.extend(asked.map(|asked| asked.triangle_idx));
            }
            Event::Pass { .. } => {
                let next = std::mem::take(&mut self.next);
                self.passed = std::mem::replace(&mut self.list, next);
                self.crossings.clear();
            }
            Event::Done { .. } => {
                self.plane_idx = None;
                self.is_done = true;
            }
        }
    }
}
