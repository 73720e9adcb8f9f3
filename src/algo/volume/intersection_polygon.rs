//! A triangle against planes, as one polygon: cut into triangles once, when all planes have had their turn.
//!
//! ```text
//!        A                A                      A
//!       ╱ ╲   plane 1    ╱ ╲     plane 2        ╱ ╲      at the end
//!      ╱   ╲  ───────►  ╱   ╲   ────────►      ╱   C₂    ───────►  A B C₁, A C₁ C₂
//!     ╱     ╲           │    ╲                 │   │
//!    B───────C          B─────C                B───C₁
//! ```
//!
//! 1. The list is the triangle's three vertices.
//! 2. Each plane clips it as Sutherland and Hodgman do: vertices inside are put out, and a crossing where an edge changes sides.
//! 3. What is left after the last plane is one convex polygon: the fan from its first vertex.
//!
//! Each plane adds one vertex at most, and n vertices make n − 2 triangles: never more than [`super::PlaneAtATime`] leaves, whose
//! diagonals are cut again by later planes.
//!
//! *Conventions*: planes in the order in which they are given; normals point inside; closed; the list starts with the first vertex
//! put out and keeps order and winding. *Exact*: on a plane across an axis the crossing's coordinate is assigned; triangles that
//! share an edge share its crossings, bit for bit; clipping again changes nothing. *Degenerate*: a triangle without area leaves
//! none, nor does one that only touches. *Bound*: for each plane its turn, the first vertex with its output, a test, a crossing and
//! an output for each edge, the pass; the fan; the end. *Cost*: three multiplications, three additions and a comparison a vertex and
//! plane; for a crossing a mean of each coordinate.
//!
//! *Source*: I. E. Sutherland and G. W. Hodgman, "Reentrant polygon clipping", Communications of the ACM 17, 1974, pp. 32–42.
//!
//! ```
//! use clipscope::{
//!     algo::volume::{IntersectionPolygon, SpaceVertex, TrianglePlanes},
//!     geom::Plane,
//!     trace::silent,
//! };
//! let planes = vec![Plane::new([1.0, 0.0, 0.0, 0.0])?, Plane::new([0.0, 1.0, 0.0, 0.0])?];
//! let triangle = [[-1.0, 1.0, 0.0], [2.0, -2.0, 0.0], [2.0, 4.0, 0.0]].map(SpaceVertex::new);
//! let left = silent::<IntersectionPolygon>(&TrianglePlanes { planes, triangle });
//! // The edge from (−1, 1) to (2, −2) runs through the corner (0, 0).
//! assert_eq!(left.triangles.len(), 2);
//! assert_eq!(left.triangles[0][0].at, [0.0; 3]);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::{
        parameter::Ratio,
        ring::{Clip, Crossing, Happening, Right, Rule},
    },
    trace::{Algorithm, Real},
};

use super::{
    CutTriangles, SpaceVertex, TrianglePlanes, VolumeRules, cut_triangles::fan, has_area,
    space_vertex::LastPlane,
};

/// The algorithm, by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct IntersectionPolygon<L = Right>(PhantomData<L>);

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum IntersectionPolygonEvent {
    /// The next plane's turn.
    Plane {
        /// As they were given.
        plane_idx: usize,
    },
    /// The first vertex of the input list.
    First {
        /// F
        at: SpaceVertex,
        /// Its signed distance from the plane.
        distance: f64,
        /// Is it inside?
        inside: bool,
    },
    /// The edge from S to P, the last one closing the ring.
    Test {
        /// Where S and P stand in the input list.
        idx: [usize; 2],
        /// S and P.
        ends: [SpaceVertex; 2],
        /// Their signed distances from the plane.
        distances: [f64; 2],
        /// What follows.
        rule: Rule,
    },
    /// The edge crosses the plane.
    Cross {
        /// I
        at: SpaceVertex,
        /// Where from S to P.
        t: Ratio,
    },
    /// A vertex is appended to the output list.
    Output {
        /// F, P or I.
        at: SpaceVertex,
    },
    /// The output list becomes the input list.
    Pass {
        /// The plane that is done with.
        plane_idx: usize,
        /// How many vertices there are now.
        n_vertices: usize,
    },
    /// A triangle of the fan.
    Fan {
        /// Its corners, the polygon's first vertex among them.
        triangle: [SpaceVertex; 3],
    },
    /// Nothing is left to do.
    Done {
        /// How many triangles are left.
        n_triangles: usize,
    },
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct IntersectionPolygonState {
    /// The list that is clipped; after the last plane, the polygon.
    pub input: Vec<SpaceVertex>,
    /// The list that grows.
    pub output: Vec<SpaceVertex>,
    /// After a pass, until the next plane's turn: the list that was clipped.
    pub passed: Vec<SpaceVertex>,
    /// The plane whose turn it is.
    pub plane_idx: Option<usize>,
    /// How far inside the plane the vertices lie that have been looked at, and whether that counts as inside.
    pub sides: Vec<(f64, bool)>,
    /// Where S and P stand, their distances, and what follows.
    pub test: Option<([usize; 2], [f64; 2], Rule)>,
    /// Where that edge crosses.
    pub crossing: Option<(SpaceVertex, Ratio)>,
    /// Every crossing with this plane, and between which two vertices it lies.
    pub crossings: Vec<([usize; 2], SpaceVertex, Ratio)>,
    /// Crossings with all planes so far.
    pub n_crossings: usize,
    /// The fan as far as it goes.
    pub triangles: Vec<[SpaceVertex; 3]>,
    /// Have vertices places in a texture?
    pub has_uv: bool,
    /// Is there nothing left to do?
    pub is_done: bool,
}

/// The vertices that a list begins with, and how many of them belong together: one ring, or by a mistake three edges.
fn paths<L: VolumeRules>([a, b, c]: [SpaceVertex; 3]) -> (Vec<SpaceVertex>, Vec<usize>) {
    if L::EDGE_BY_EDGE {
        (vec![a, b, b, c, c, a], vec![2; 3])
    } else {
        (vec![a, b, c], vec![3])
    }
}

impl<L: VolumeRules> Algorithm for IntersectionPolygon<L> {
    type Input = TrianglePlanes;
    type Output = CutTriangles;
    type Event = IntersectionPolygonEvent;
    type State = IntersectionPolygonState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use IntersectionPolygonEvent as Event;
        let (mut list, mut paths) = paths::<L>(input.triangle);
        let mut n_crossings = 0;
        let has_area = has_area(&input.triangle);
        for plane_idx in 0..input.planes.len() {
            let Some(plane) = LastPlane::<L>::new(&input.planes, plane_idx) else {
                break;
            };
            if list.len() < 3 || !has_area {
                break;
            }
            emit(Event::Plane { plane_idx });
            list = clip_by::<L, R>(plane, &list, &mut paths, &mut |event| {
                n_crossings += usize::from(matches!(event, Event::Cross { .. }));
                emit(event);
            });
            let n_vertices = list.len();
            emit(Event::Pass {
                plane_idx,
                n_vertices,
            });
        }
        if L::EDGE_BY_EDGE {
            join(&mut list);
        }
        let triangles = fan(&list);
        for &triangle in &triangles {
            emit(Event::Fan { triangle });
        }
        let n_triangles = triangles.len();
        emit(Event::Done { n_triangles });
        CutTriangles {
            triangles,
            n_crossings,
            has_uv: input.has_uv(),
        }
    }

    fn start(input: &Self::Input) -> Self::State {
        IntersectionPolygonState {
            input: paths::<L>(input.triangle).0,
            has_uv: input.has_uv(),
            ..IntersectionPolygonState::default()
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        CutTriangles {
            triangles: state.triangles.clone(),
            n_crossings: state.n_crossings,
            has_uv: state.has_uv,
        }
    }

    /// For each plane its turn; for each path, of which there are three at most, its first vertex, perhaps put out; for each edge
    /// a test, a crossing with its output, and an end; the pass. Then a triangle a vertex, and the end.
    fn max_events(input: &Self::Input) -> usize {
        let (mut n, mut total) = (6_usize, 1_usize);
        for _ in &input.planes {
            let clipped = n.saturating_mul(4).saturating_add(2 + 3 * 2);
            total = total.saturating_add(clipped);
            // Half of them inside, with a crossing on either side of each, is the most.
            n = n.saturating_mul(3) / 2;
        }
        total.saturating_add(n)
    }
}

/// What is left of each path on the inner side of the last plane.
fn clip_by<L: VolumeRules, R: Real>(
    plane: LastPlane<'_, L>,
    list: &[SpaceVertex],
    paths: &mut [usize],
    emit: &mut impl FnMut(IntersectionPolygonEvent),
) -> Vec<SpaceVertex> {
    let mut output = Vec::with_capacity(list.len() + 1);
    let mut start = 0;
    for path in paths {
        let end = start + *path;
        let n_before = output.len();
        let mut tell = |idx: [usize; 2], happening| {
            let idx = idx.map(|i| start + i);
            let event = told(&plane, idx, happening);
            if let IntersectionPolygonEvent::Output { at } = event {
                output.push(at);
            }
            emit(event);
        };
        if let Some((&first, following)) = list[start..end].split_first() {
            let mut clip = Clip::<_, SpaceVertex, R>::begin::<L>(plane, first, &mut |happening| {
                tell([0, 0], happening);
            });
            for (i, &vertex) in following.iter().enumerate() {
                clip.vertex::<L>(vertex, &mut |happening| tell([i, i + 1], happening));
            }
            let idx = [following.len(), 0];
            clip.close::<L>(&mut |happening| tell(idx, happening));
        }
        *path = output.len() - n_before;
        start = end;
    }
    output
}

fn told<L>(
    plane: &LastPlane<'_, L>,
    idx: [usize; 2],
    happening: Happening<SpaceVertex>,
) -> IntersectionPolygonEvent {
    use IntersectionPolygonEvent as Event;
    match happening {
        Happening::First {
            at,
            distance,
            inside,
        } => Event::First {
            at,
            distance: plane.told(distance),
            inside,
        },
        Happening::Test {
            ends,
            distances,
            rule,
        } => Event::Test {
            idx,
            ends,
            distances: distances.map(|d| plane.told(d)),
            rule,
        },
        Happening::Cross(Crossing { at, t }) => Event::Cross { at, t },
        Happening::Output(at) => Event::Output { at },
    }
}

/// Takes the ends of edges that meet for one vertex.
fn join(ring: &mut Vec<SpaceVertex>) {
    ring.dedup_by_key(|vertex| vertex.at);
    while ring.len() > 1 && ring.first().map(|v| v.at) == ring.last().map(|v| v.at) {
        ring.pop();
    }
}

impl IntersectionPolygonState {
    fn apply(&mut self, event: IntersectionPolygonEvent) {
        use IntersectionPolygonEvent as Event;
        match event {
            Event::Plane { plane_idx } => {
                self.plane_idx = Some(plane_idx);
                self.passed.clear();
                self.sides.clear();
                self.crossings.clear();
            }
            Event::First {
                distance, inside, ..
            } => self.sides.push((distance, inside)),
            Event::Test {
                idx,
                distances,
                rule,
                ..
            } => {
                self.test = Some((idx, distances, rule));
                // The edge that closes the ring ends where it began.
                if idx[1] == self.sides.len() {
                    self.sides.push((distances[1], rule.ends_inside()));
                }
                self.crossing = None;
            }
            Event::Cross { at, t } => {
                self.crossing = Some((at, t));
                self.n_crossings += 1;
                let between = self.test.map(|(idx, ..)| (idx, at, t));
                self.crossings.extend(between);
            }
            Event::Output { at } => self.output.push(at),
            Event::Pass { .. } => {
                let put_out = std::mem::take(&mut self.output);
                self.passed = std::mem::replace(&mut self.input, put_out);
                (self.test, self.crossing) = (None, None);
            }
            Event::Fan { triangle } => {
                self.plane_idx = None;
                self.triangles.push(triangle);
            }
            Event::Done { .. } => {
                self.plane_idx = None;
                self.is_done = true;
            }
        }
    }
}
