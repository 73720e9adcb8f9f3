//! A triangle against the clip volume −w ≤ x, y, z ≤ w, before anything is divided by w.
//!
//! ```text
//!        x ╲      │      ╱ x = w        a vertex behind the eye has w < 0: divided first, it would land on the
//!           ╲     │  B  ╱               screen's other side. Here it is just another point outside, and the
//!            ╲    │ ╱╲ ╱                edge to it is cut where x = w, a place that can be divided
//!        A ───╲───┼╱──╳──► w
//!              ╲  ╱  ╱ ╲
//! ```
//!
//! 1. Six bits for each vertex ([`SideCode`]). OR = 0: keep it whole. AND ≠ 0: nothing of it is visible.
//! 2. Else clip it as Sutherland and Hodgman do, one side after the other, by those sides that a code names.
//! 3. What is left is one convex polygon of at most nine vertices: fan it from its first.
//!
//! *Conventions*: sides in the order near, far, left, right, bottom, top; closed; the list starts with the first vertex put
//! out and keeps order and winding. *Exact*: signs of w ± x; a clipped coordinate is assigned (x = w, bit for bit);
//! triangles that share an edge share its cuts, bit for bit, and a cut stays inside every side that both ends of its edge are
//! inside of. *Bound*: the codes; for each side its turn, the first vertex with its output, a test, a crossing and an output for
//! each edge, the pass; the end. *Cost*: six comparisons a vertex; a side costs an addition and a comparison a vertex, a
//! crossing a mean for each coordinate but one and for each attribute.
//!
//! *Source*: J. F. Blinn and M. E. Newell, "Clipping using homogeneous coordinates", SIGGRAPH 1978, pp. 245–251.
//!
//! ```
//! use clipscope::{algo::volume::{ClipVertex, HomogeneousTriangle}, trace::silent};
//! // One vertex behind the eye.
//! let at = |at| ClipVertex { at, attributes: () };
//! let triangle = [at([0.0, 0.0, 0.0, 1.0]), at([4.0, 0.0, 0.0, 1.0]), at([0.0, 2.0, 0.0, -1.0])];
//! let polygon = silent::<HomogeneousTriangle>(&triangle);
//! assert!(polygon.vertices().iter().all(|v| v.at[3] > 0.0));
//! ```

use std::{marker::PhantomData, mem};

use serde::Serialize;

use crate::{
    algo::{
        parameter::Ratio,
        ring::{Clip, Crossing, Happening, Right, Rule},
    },
    geom::VolumeSide,
    trace::{Algorithm, Real},
};

use super::{
    VolumeRules,
    clip_polygon::ClipPolygon,
    clip_vertex::{Attributes, ClipVertex, divided},
    side_code::SideCode,
};

/// The algorithm, on vertices with attributes `A` and by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct HomogeneousTriangle<A = (), L = Right>(PhantomData<(A, L)>);

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum HomogeneousTriangleEvent<A> {
    /// By a mistake: the vertices are divided by w before anything is clipped.
    Divide {
        /// What comes of them.
        triangle: [ClipVertex<A>; 3],
    },
    /// The vertices' codes.
    Codes {
        /// Of each vertex.
        codes: [SideCode; 3],
        /// Of all three: the sides that clip.
        or: SideCode,
        /// Of all three: a side that all lie beyond.
        and: SideCode,
    },
    /// The next side's turn.
    Side {
        /// That a code names.
        side: VolumeSide,
    },
    /// The first vertex of the input list.
    First {
        /// F
        at: ClipVertex<A>,
        /// w ± its coordinate.
        distance: f64,
        /// Is it inside?
        inside: bool,
    },
    /// The edge from S to P, the last one closing the ring.
    Test {
        /// Where S and P stand in the input list.
        idx: [usize; 2],
        /// S and P.
        ends: [ClipVertex<A>; 2],
        /// Their w ± the coordinate.
        distances: [f64; 2],
        /// What follows.
        rule: Rule,
    },
    /// The edge crosses the side.
    Cross {
        /// I
        at: ClipVertex<A>,
        /// Where from S to P.
        t: Ratio,
    },
    /// A vertex is appended to the output list.
    Output {
        /// F, P or I.
        at: ClipVertex<A>,
    },
    /// The output list becomes the input list.
    Pass {
        /// The side that is done with.
        side: VolumeSide,
        /// How many vertices there are now.
        n_vertices: usize,
    },
    /// No side is left to do, or no vertex.
    Done {
        /// How many vertices are left.
        n_vertices: usize,
    },
}

/// What the picture of a step needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HomogeneousTriangleState<A> {
    /// The list that is clipped; after the end, the answer.
    pub input: ClipPolygon<A>,
    /// The list that grows.
    pub output: ClipPolygon<A>,
    /// The three codes, their OR and AND, once known.
    pub codes: Option<([SideCode; 3], SideCode, SideCode)>,
    /// The side whose turn it is.
    pub side: Option<VolumeSide>,
    /// Where S and P stand, their distances, and what follows.
    pub test: Option<([usize; 2], [f64; 2], Rule)>,
    /// Where that edge crosses.
    pub crossing: Option<(ClipVertex<A>, Ratio)>,
    /// Is there nothing left to do?
    pub is_done: bool,
}

impl<A: Attributes, L: VolumeRules> Algorithm for HomogeneousTriangle<A, L> {
    type Input = [ClipVertex<A>; 3];
    type Output = ClipPolygon<A>;
    type Event = HomogeneousTriangleEvent<A>;
    type State = HomogeneousTriangleState<A>;

    fn run<R: Real>(triangle: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use HomogeneousTriangleEvent as Event;
        let by_mistake;
        let triangle = if L::DIVIDES_FIRST {
            by_mistake = triangle.map(|v| ClipVertex {
                at: divided::<R>(v.at),
                ..v
            });
            emit(Event::Divide {
                triangle: by_mistake,
            });
            &by_mistake
        } else {
            triangle
        };
        let codes = triangle.each_ref().map(|v| SideCode::of(v.at.map(R::new)));
        let [a, b, c] = codes;
        let (or, and) = (a.or(b).or(c), a.and(b).and(c));
        emit(Event::Codes { codes, or, and });
        let [mut one, mut other] = [ClipPolygon::of(triangle); 2];
        if L::ASKS_CODES && !and.is_inside() {
            one.clear();
        }
        *clip_by_sides::<A, L, R>(or, [&mut one, &mut other], &mut emit)
    }

    fn start(triangle: &Self::Input) -> Self::State {
        let input = ClipPolygon::of(triangle);
        HomogeneousTriangleState {
            input,
            output: input.emptied(),
            codes: None,
            side: None,
            test: None,
            crossing: None,
            is_done: false,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use HomogeneousTriangleEvent as Event;
        match event {
            Event::Divide { triangle } => {
                state.input = ClipPolygon::of(&triangle);
                state.output = state.input.emptied();
            }
            Event::Codes { codes, or, and } => state.codes = Some((codes, or, and)),
            Event::Side { side } => state.side = Some(side),
            Event::First { .. } => {}
            Event::Test {
                idx,
                distances,
                rule,
                ..
            } => (state.test, state.crossing) = (Some((idx, distances, rule)), None),
            Event::Cross { at, t } => state.crossing = Some((at, t)),
            Event::Output { at } => state.output.push(at),
            Event::Pass { .. } => {
                (state.input, state.output) = (state.output, state.output.emptied());
                (state.test, state.crossing) = (None, None);
            }
            Event::Done { n_vertices } => {
                state.side = None;
                state.is_done = true;
                if n_vertices == 0 {
                    state.input = state.input.emptied();
                }
            }
        }
    }

    fn finish(state: &Self::State) -> Self::Output {
        state.input
    }

    /// A division by mistake, codes and end; for each of six sides its turn, the first vertex with its output, three events and as many copies of
    /// the crossing as there are for each of at most nine edges, and the pass.
    fn max_events(_: &Self::Input) -> usize {
        3 + 6 * (4 + ClipPolygon::<A>::MAX_VERTICES * (3 + L::COPIES))
    }
}

/// By one side after the other of those that are named: from one polygon into the other, whose vertices are forgotten, and back. What is left is
/// in one of them.
#[inline]
pub(super) fn clip_by_sides<'a, A: Attributes, L: VolumeRules, R: Real>(
    named: SideCode,
    [mut list, mut next]: [&'a mut ClipPolygon<A>; 2],
    emit: &mut impl FnMut(HomogeneousTriangleEvent<A>),
) -> &'a ClipPolygon<A> {
    use HomogeneousTriangleEvent as Event;
    let is_named = |side: &VolumeSide| !L::ASKS_CODES || named.has(*side);
    for side in VolumeSide::ALL.into_iter().filter(is_named) {
        if list.vertices().is_empty() {
            break;
        }
        emit(Event::Side { side });
        clip_by::<A, L, R>(side, list, next, emit);
        mem::swap(&mut list, &mut next);
        let n_vertices = list.vertices().len();
        emit(Event::Pass { side, n_vertices });
    }
    let n_vertices = list.vertices().len();
    emit(Event::Done { n_vertices });
    list
}

/// What is left of a polygon on the inner side of one side: into another one, whose vertices so far are forgotten.
#[inline]
fn clip_by<A: Attributes, L: VolumeRules, R: Real>(
    side: VolumeSide,
    input: &ClipPolygon<A>,
    output: &mut ClipPolygon<A>,
    emit: &mut impl FnMut(HomogeneousTriangleEvent<A>),
) {
    use HomogeneousTriangleEvent as Event;
    output.clear();
    let Some((&first, following)) = input.vertices().split_first() else {
        return;
    };
    let mut tell = |idx: [usize; 2], happening| match happening {
        Happening::First {
            at,
            distance,
            inside,
        } => emit(Event::First {
            at,
            distance,
            inside,
        }),
        Happening::Test {
            ends,
            distances,
            rule,
        } => emit(Event::Test {
            idx,
            ends,
            distances,
            rule,
        }),
        Happening::Cross(Crossing { at, t }) => emit(Event::Cross { at, t }),
        Happening::Output(at) => {
            output.push(at);
            emit(Event::Output { at });
        }
    };
    let mut clip = Clip::<_, ClipVertex<A>, R>::begin::<L>(side, first, &mut |happening| {
        tell([0, 0], happening);
    });
    for (i, &vertex) in following.iter().enumerate() {
        clip.vertex::<L>(vertex, &mut |happening| tell([i, i + 1], happening));
    }
    let idx = [following.len(), 0];
    clip.close::<L>(&mut |happening| tell(idx, happening));
}
