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
//! Every entry of a list has one successor among the border pieces that bound the result, so the walks are disjoint cycles: together they
//! take at most as many steps as both lists have entries.

use std::cmp::Ordering;

use crate::{
    geom::{Point, winding},
    trace::{Tell, Told},
};

use super::{
    Clipping, WeilerAtherton,
    event::WeilerAthertonEvent as Event,
    input::List,
    lists::NONE,
    rings::{BorderRing, RingKind},
    side::{IntersectionLabel, Side, bounds_the_result},
};

/// Walks over both lists.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Walk {
    /// Where the walk stands.
    pub position: Option<(List, u32)>,
    /// Where it started: an intersection.
    pub start: Option<u32>,
    /// Corners since then that belong to no ring yet, and the intersections that they are.
    pub path: Vec<(Point, u32)>,
    /// The entry that comes next, and whether lists are changed there; none between two walks.
    next: Option<(List, u32, bool)>,
    n_asked: usize,
    /// Steps that have been taken: see the module.
    n_steps: usize,
    /// Intersections from which the subject's list was entered, by a start or a switch.
    entered: Vec<bool>,
    /// Of each intersection its place on the path, which may be out of date.
    on_path: Vec<u32>,
    /// Where on the path the walk last switched lists.
    stretch: usize,
}

impl Walk {
    pub(super) const fn end(&mut self) {
        (self.position, self.start) = (None, None);
    }
}

impl<T: Tell<WeilerAtherton>> Clipping<'_, T> {
    pub fn walk_all(&mut self) -> Told<T::Stop> {
        let n_nodes = self.held.labels.len();
        let most_steps = self.held.lists.entries.iter().map(Vec::len).sum();
        self.held.walk.entered.resize(n_nodes, false);
        self.held.walk.on_path.resize(n_nodes, NONE);
        if self.held.walk.next.is_some() {
            self.walk_on(most_steps)?;
        }
        while self.held.walk.n_asked < n_nodes {
            let node_idx = self.held.walk.n_asked;
            self.held.walk.n_asked += 1;
            let starts = matches!(
                self.held.labels[node_idx].label,
                IntersectionLabel::Entering | IntersectionLabel::Pinching
            );
            if starts && !self.held.walk.entered[node_idx] {
                self.start(node_idx)?;
                self.walk_on(most_steps)?;
            }
        }
        Told::Continue(())
    }

    fn start(&mut self, node_idx: usize) -> Told<T::Stop> {
        let place = self.held.lists.nodes[node_idx].places[0];
        let walk = &mut self.held.walk;
        walk.start = Some(node_idx as u32);
        walk.entered[node_idx] = true;
        walk.path.clear();
        walk.stretch = 0;
        walk.next = Some((List::Subject, place, true));
        self.tell(Event::Start {
            node_idx: node_idx as u32,
        })
    }

    fn walk_on(&mut self, most_steps: usize) -> Told<T::Stop> {
        while let Some((mut list, mut place, switched)) = self.held.walk.next {
            if self.held.walk.n_steps == most_steps {
                debug_assert!(false, "the walk ends where it started");
                break;
            }
            self.rest(self.held.walk.n_steps, most_steps);
            self.held.walk.n_steps += 1;
            self.visit(list, place, switched)?;
            let lists = &self.held.lists;
            place = lists.entries[list.idx()][place as usize].next;
            let node = lists.entries[list.idx()][place as usize].node;
            self.held.walk.next = Some((list, place, false));
            if node == NONE {
                continue;
            }
            self.cut_at(list, place, node)?;
            let switches = match self.held.labels[node as usize].label {
                IntersectionLabel::Entering => list == List::Clip,
                IntersectionLabel::Leaving => list == List::Subject,
                IntersectionLabel::Pinching => true,
                IntersectionLabel::Touching => false,
            };
            if !switches {
                continue;
            }
            list = list.other();
            let walk = &mut self.held.walk;
            if list == List::Subject {
                if walk.start == Some(node) {
                    walk.next = None;
                    return Told::Continue(());
                }
                debug_assert!(
                    !walk.entered[node as usize],
                    "each list entry is visited once"
                );
                walk.entered[node as usize] = true;
            }
            place = self.held.lists.nodes[node as usize].places[list.idx()];
            walk.next = Some((list, place, true));
            walk.position = Some((list, place));
            walk.stretch = walk.path.len();
            self.tell(Event::Switch {
                node_idx: node,
                to: list,
                place,
            })?;
        }
        Told::Continue(())
    }

    /// Adds an entry to the path where it is a corner of the ring.
    #[inline]
    fn visit(&mut self, list: List, place: u32, switched: bool) -> Told<T::Stop> {
        let entry = self.held.lists.entries[list.idx()][place as usize];
        let corner = switched || entry.is_corner(&self.held.labels);
        let at = self.held.lists.at(&entry, self.borders[list.idx()]);
        let walk = &mut self.held.walk;
        if corner {
            if entry.node != NONE {
                walk.on_path[entry.node as usize] = walk.path.len() as u32;
            }
            walk.path.push((at, entry.node));
        }
        walk.position = Some((list, place));
        self.tell(Event::Visit {
            list,
            place,
            at,
            corner,
        })
    }

    /// Where the path has come back to an intersection that it holds, what lies between is a ring.
    #[inline]
    fn cut_at(&mut self, list: List, place: u32, node: u32) -> Told<T::Stop> {
        let walk = &mut self.held.walk;
        let from = walk.on_path[node as usize] as usize;
        if walk.path.get(from).is_none_or(|&(_, held)| held != node) {
            return Told::Continue(());
        }
        let points: Vec<Point> = walk.path.drain(from..).map(|(p, _)| p).collect();
        // Without a switch it is a whole ring of the subject.
        let has_switched = list == List::Clip || walk.stretch > from;
        walk.stretch = walk.stretch.min(from);
        let is_hole = !has_switched && self.ring_of(list, place) > 0;
        let kind = kind(&points, is_hole);
        self.held.rings.push(BorderRing { points, kind });
        self.tell(Event::Closed {
            from: from as u32,
            kind,
        })
    }

    fn ring_of(&self, list: List, place: u32) -> usize {
        let starts = &self.held.lists.starts[list.idx()];
        starts.partition_point(|&start| start <= place) - 1
    }
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
