//! What Weiler–Atherton says as it works.

use serde::Serialize;

use crate::{algo::line::Ratio, geom::Point};

use super::{
    input::List,
    meeting::Contact,
    rings::{Relation, RingKind},
    side::{IntersectionLabel, Side},
};

/// Vertices and edges are numbered through all [`Region::rings`](crate::geom::Region::rings), intersections along the subject.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum WeilerAthertonEvent {
    /// A polygon's own vertex goes into its list; its edge comes next.
    Vertex {
        /// Which one.
        list: List,
        /// Its number.
        vertex_idx: u32,
        /// Where.
        at: Point,
    },
    /// Two edges meet: an intersection for the subject's list.
    Found {
        /// Its number.
        node_idx: u32,
        /// Of the subject and of the clip polygon; each from its vertex of the same number.
        edges: [u32; 2],
        /// How they meet.
        contact: Contact,
        /// Where.
        at: Point,
        /// Along the subject's edge: a₁ / (a₁ − a₂).
        t: Ratio,
        /// Along the clip polygon's edge: b₁ / (b₁ − b₂).
        u: Ratio,
        /// Whose edge a crossing is computed along.
        along: List,
    },
    /// An intersection goes into the clip polygon's list.
    Inserted {
        /// Its number.
        node_idx: u32,
        /// Where.
        at: Point,
        /// Is it the vertex that was last put there?
        at_vertex: bool,
    },
    /// What the subject does at an intersection.
    Labelled {
        /// Its number.
        node_idx: u32,
        /// For the walk.
        label: IntersectionLabel,
        /// Where the subject comes from.
        before: Side,
        /// Where it goes.
        after: Side,
    },
    /// A walk starts, in the subject's list.
    Start {
        /// An entering or pinching intersection that no walk has left along the subject yet.
        node_idx: u32,
    },
    /// The walk passes an entry of a list.
    Visit {
        /// Which list.
        list: List,
        /// The entry's number.
        place: u32,
        /// Where.
        at: Point,
        /// Does it become a corner of the ring? Not where the walk goes straight past an intersection.
        corner: bool,
    },
    /// The walk changes lists.
    Switch {
        /// The intersection at which it does.
        node_idx: u32,
        /// The list that it follows from now on.
        to: List,
        /// The intersection's place there.
        place: u32,
    },
    /// The walk is back at a corner: from there on the path is a ring.
    Closed {
        /// The corner's place on the path.
        from: u32,
        /// What it is.
        kind: RingKind,
    },
    /// A ring of either polygon that changes no lists, as a whole.
    Whole {
        /// Whose.
        list: List,
        /// Which ring.
        ring_idx: u32,
        /// Its first entry in the list, and the one after its last.
        places: [u32; 2],
        /// Where it lies by the other polygon.
        side: Side,
        /// What it is in the answer, if anything.
        kind: Option<RingKind>,
    },
    /// A hole goes to the piece that it lies in.
    Hole {
        /// Number of the ring, in the order in which they were closed.
        hole_idx: u32,
        /// Number of the ring around the piece.
        outer_idx: u32,
    },
    /// All rings are known.
    Done {
        /// How the two polygons lie.
        relation: Relation,
    },
}
