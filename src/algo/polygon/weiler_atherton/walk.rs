//! The walk that switches lists.
//!
//! ```text
//!   start at an entering intersection, in the subject's list
//!   go on in the list, vertex after vertex;
//!     leaving:   switch to the clip polygon's list        pinching: switch, whichever it is
//!     entering:  switch to the subject's list             touching: go on
//!   back at an intersection that the ring already holds: cut the ring off there
//!   back at the start: done
//! ```
//!
//! Every border piece that bounds the result lies between two entries of one list, and has one successor; so
//! the walks are disjoint cycles. No entry is visited twice in the same list: the walks together take at most as
//! many steps as both lists have entries.

use std::cmp::Ordering;

use crate::geom::{Point, Rings, winding};

use super::{
    event::WeilerAthertonEvent as Event,
    input::List,
    lists::{Entry, LinkedLists, NONE},
    rings::{BorderRing, RingKind},
    side::{IntersectionLabel, Labelled, Side, bounds_the_result},
};

/// Walks over both lists.
pub struct Walker<'a> {
    pub borders: [&'a Rings; 2],
    pub lists: &'a LinkedLists,
    pub labels: &'a [Labelled],
    /// Steps that are left: see the module.
    left: usize,
    /// Intersections from which the subject's list was entered, by a start or a switch.
    entered: Vec<bool>,
    /// Of each intersection its place on the path, which may be out of date.
    on_path: Vec<u32>,
    path: Vec<(Point, u32)>,
    /// Where on the path the walk last switched lists.
    stretch: usize,
    /// Closed so far.
    pub rings: Vec<BorderRing>,
}

impl<'a> Walker<'a> {
    pub fn new(borders: [&'a Rings; 2], lists: &'a LinkedLists, labels: &'a [Labelled]) -> Self {
        let n_nodes = lists.nodes.len();
        Self {
            borders,
            lists,
            labels,
            left: lists.entries.iter().map(Vec::len).sum(),
            entered: vec![false; n_nodes],
            on_path: vec![NONE; n_nodes],
            path: Vec::new(),
            stretch: 0,
            rings: Vec::new(),
        }
    }

    /// Every ring that changes lists.
    pub fn walk_all(&mut self, emit: &mut impl FnMut(Event)) {
        for node_idx in 0..self.labels.len() {
            let starts = matches!(
                self.labels[node_idx].label,
                IntersectionLabel::Entering | IntersectionLabel::Pinching
            );
            if starts && !self.entered[node_idx] {
                self.walk(node_idx, emit);
            }
        }
    }

    fn walk(&mut self, start: usize, emit: &mut impl FnMut(Event)) {
        emit(Event::Start {
            node_idx: start as u32,
        });
        self.entered[start] = true;
        self.path.clear();
        self.stretch = 0;
        let mut list = List::Subject;
        let mut place = self.lists.nodes[start].places[0];
        let mut switched = true;
        while self.left > 0 {
            self.left -= 1;
            self.visit(list, place, switched, emit);
            let entries = &self.lists.entries[list.idx()];
            place = entries[place as usize].next;
            let node = entries[place as usize].node;
            switched = false;
            if node == NONE {
                continue;
            }
            self.cut_at(list, place, node, emit);
            switched = match self.labels[node as usize].label {
                IntersectionLabel::Entering => list == List::Clip,
                IntersectionLabel::Leaving => list == List::Subject,
                IntersectionLabel::Pinching => true,
                IntersectionLabel::Touching => false,
            };
            if !switched {
                continue;
            }
            list = list.other();
            if list == List::Subject {
                if node as usize == start {
                    return;
                }
                debug_assert!(
                    !self.entered[node as usize],
                    "each list entry is visited once"
                );
                self.entered[node as usize] = true;
            }
            place = self.lists.nodes[node as usize].places[list.idx()];
            emit(Event::Switch {
                node_idx: node,
                to: list,
                place,
            });
            self.stretch = self.path.len();
        }
        debug_assert!(false, "the walk ends where it started");
    }

    /// Adds an entry to the path where it is a corner of the ring: see [`is_corner`].
    fn visit(&mut self, list: List, place: u32, switched: bool, emit: &mut impl FnMut(Event)) {
        let entry = self.lists.entries[list.idx()][place as usize];
        let corner = switched || is_corner(&entry, self.labels);
        let at = at(&entry, self.borders[list.idx()], self.lists);
        if corner {
            if entry.node != NONE {
                self.on_path[entry.node as usize] = self.path.len() as u32;
            }
            self.path.push((at, entry.node));
        }
        emit(Event::Visit {
            list,
            place,
            at,
            corner,
        });
    }

    /// Where the path has come back to an intersection that it holds, what lies between is a ring.
    fn cut_at(&mut self, list: List, place: u32, node: u32, emit: &mut impl FnMut(Event)) {
        let from = self.on_path[node as usize] as usize;
        if self.path.get(from).is_none_or(|&(_, held)| held != node) {
            return;
        }
        let points: Vec<Point> = self.path.drain(from..).map(|(p, _)| p).collect();
        // Without a switch it is a whole ring of the subject.
        let is_hole =
            list == List::Subject && self.stretch <= from && self.ring_of(list, place) > 0;
        self.stretch = self.stretch.min(from);
        let kind = kind(&points, is_hole);
        emit(Event::Closed {
            from: from as u32,
            kind,
        });
        self.rings.push(BorderRing { points, kind });
    }

    fn ring_of(&self, list: List, place: u32) -> usize {
        let starts = &self.lists.starts[list.idx()];
        starts.partition_point(|&start| start <= place) - 1
    }
}

/// A list's own vertices are corners of a ring; so are the other polygon's along an edge that both share, so that
/// they still share it afterwards. An intersection that the walk goes straight past is not.
fn is_corner(entry: &Entry, labels: &[Labelled]) -> bool {
    entry.vertex != NONE || entry.node != NONE && labels[entry.node as usize].shares_an_edge()
}

fn at(entry: &Entry, border: &Rings, lists: &LinkedLists) -> Point {
    if entry.node == NONE {
        border.points()[entry.vertex as usize]
    } else {
        lists.nodes[entry.node as usize].meeting.at
    }
}

/// All corners of a ring that changes no lists.
pub fn whole_ring(
    entries: &[Entry],
    border: &Rings,
    lists: &LinkedLists,
    labels: &[Labelled],
) -> Vec<Point> {
    let corners = entries.iter().filter(|entry| is_corner(entry, labels));
    corners.map(|entry| at(entry, border, lists)).collect()
}

/// What the rounded corners make of it: see [`RingKind::Sliver`].
pub fn kind(points: &[Point], is_hole: bool) -> RingKind {
    if is_hole {
        RingKind::Hole
    } else if winding(points) == Ordering::Greater {
        RingKind::Outer
    } else {
        RingKind::Sliver
    }
}

/// Does a border that lies on this side all along bound the result?
pub fn whole_ring_bounds(list: List, side: Side) -> bool {
    match list {
        List::Subject => bounds_the_result(side),
        List::Clip => side == Side::Inside,
    }
}
