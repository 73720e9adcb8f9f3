//! What the picture of a step needs: both lists, their intersections and labels, the walk, and the rings so far.

use std::{ops::Range, sync::Arc};

use crate::{algo::line::Ratio, geom::Point, trace::Log};

use super::{
    answer::{Relation, WeilerAthertonOutput},
    event::WeilerAthertonEvent as Event,
    input::List,
    meeting::Contact,
    rings::{RingKind, pieces},
    side::{IntersectionLabel, Side},
};

/// A place in one of the two lists.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ListEntry {
    /// The polygon's own vertex.
    pub vertex: Option<u32>,
    /// An intersection.
    pub node: Option<u32>,
    /// Where.
    pub at: Point,
}

/// An intersection.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ListNode {
    /// The edges that own it, of the subject and of the clip polygon.
    pub edges: [u32; 2],
    /// How they meet.
    pub contact: Contact,
    /// Where.
    pub at: Point,
    /// Along the subject's edge.
    pub t: Ratio,
    /// Along the clip polygon's edge.
    pub u: Ratio,
    /// Its place in the subject's list.
    pub place: u32,
}

/// A label, and what it comes from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NodeLabel {
    /// For the walk.
    pub label: IntersectionLabel,
    /// Where the subject comes from.
    pub before: Side,
    /// Where it goes.
    pub after: Side,
}

impl NodeLabel {
    /// Does the subject run along an edge of the clip polygon here, in the same direction?
    #[must_use]
    pub fn shares_an_edge(&self) -> bool {
        [self.before, self.after].contains(&Side::Along)
    }
}

/// An entry of a list that a walk has passed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Passed {
    /// Which list.
    pub list: List,
    /// The entry's number.
    pub place: u32,
    /// How many corners the path had before.
    pub n_before: u32,
}

/// A ring that is closed.
#[derive(Clone, PartialEq, Debug)]
pub struct StateRing {
    /// Its corners.
    pub points: Vec<Point>,
    /// What it is.
    pub kind: RingKind,
}

/// State of a run.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct WeilerAthertonState {
    /// The subject's list, and the clip polygon's.
    pub lists: [Log<ListEntry>; 2],
    /// In the order of the subject's list.
    pub nodes: Log<ListNode>,
    /// Of the nodes, as far as they have one.
    pub labels: Log<NodeLabel>,
    /// Of the intersections in the clip polygon's list, in its order: number and place.
    pub inserted: Log<[u32; 2]>,
    /// Where the walk stands.
    pub position: Option<(List, u32)>,
    /// Where it started: an intersection.
    pub start: Option<u32>,
    /// Corners since then that belong to no ring yet.
    pub path: Log<Point>,
    /// Entries passed since then that belong to no ring yet.
    pub passed: Log<Passed>,
    /// Entries that belong to closed rings: list and number.
    pub kept: Log<(List, u32)>,
    /// Closed rings.
    pub rings: Log<Arc<StateRing>>,
    /// Numbers of a hole and of the ring that it lies in.
    pub owners: Log<[u32; 2]>,
    /// How the two polygons lie, once all is known.
    pub relation: Option<Relation>,
}

impl WeilerAthertonState {
    /// The last entry of a list; intersections within an edge come behind its first vertex.
    fn add_node(&mut self, list: List, node: u32, at: Point, at_vertex: bool) -> u32 {
        let entries = &mut self.lists[list.idx()];
        match entries.last_mut() {
            Some(entry) if at_vertex => entry.node = Some(node),
            _ => entries.push(ListEntry {
                vertex: None,
                node: Some(node),
                at,
            }),
        }
        entries.len() as u32 - 1
    }

    /// Of a ring that changes no lists: its own vertices, and the other polygon's along an edge that both share.
    fn is_corner(&self, entry: &ListEntry) -> bool {
        let label = entry.node.and_then(|node| self.labels.get(node as usize));
        entry.vertex.is_some() || label.is_some_and(NodeLabel::shares_an_edge)
    }

    /// What the path holds from a corner on becomes a ring.
    fn close(&mut self, from: u32, kind: RingKind) {
        let points = self.path.iter().skip(from as usize).copied().collect();
        self.path.truncate(from as usize);
        self.rings.push(Arc::new(StateRing { points, kind }));
        while let Some(&last) = self.passed.last()
            && last.n_before >= from
        {
            self.kept.push((last.list, last.place));
            self.passed.truncate(self.passed.len() - 1);
        }
    }

    /// The walk stands at an entry; a corner of its path, or one that the ring does not keep.
    fn visit(&mut self, list: List, place: u32, corner: Option<Point>) {
        self.position = Some((list, place));
        self.passed.push(Passed {
            list,
            place,
            n_before: self.path.len() as u32,
        });
        if let Some(corner) = corner {
            self.path.push(corner);
        }
    }

    /// A ring without a walk: a stretch of a list.
    fn keep(&mut self, list: List, places: Range<u32>, kind: RingKind) {
        let entries = &self.lists[list.idx()];
        let ring = places.clone();
        let ring = ring.filter_map(|place| entries.get(place as usize));
        let corners = ring.filter(|entry| self.is_corner(entry));
        let points = corners.map(|entry| entry.at).collect();
        self.rings.push(Arc::new(StateRing { points, kind }));
        for place in places {
            self.kept.push((list, place));
        }
    }

    pub(super) fn apply(&mut self, event: Event) {
        match event {
            Event::Vertex {
                list,
                vertex_idx,
                at,
            } => self.lists[list.idx()].push(ListEntry {
                vertex: Some(vertex_idx),
                node: None,
                at,
            }),
            Event::Found {
                node_idx,
                edges,
                contact,
                at,
                t,
                u,
                ..
            } => {
                let at_vertex = contact.at_vertex()[0];
                let place = self.add_node(List::Subject, node_idx, at, at_vertex);
                self.nodes.push(ListNode {
                    edges,
                    contact,
                    at,
                    t,
                    u,
                    place,
                });
            }
            Event::Inserted {
                node_idx,
                at,
                at_vertex,
            } => {
                let place = self.add_node(List::Clip, node_idx, at, at_vertex);
                self.inserted.push([node_idx, place]);
            }
            Event::Labelled {
                label,
                before,
                after,
                ..
            } => {
                self.labels.push(NodeLabel {
                    label,
                    before,
                    after,
                });
            }
            Event::Start { node_idx } => {
                self.start = Some(node_idx);
                self.path.truncate(0);
                self.passed.truncate(0);
            }
            Event::Visit {
                list,
                place,
                at,
                corner,
            } => self.visit(list, place, corner.then_some(at)),
            Event::Switch { to, place, .. } => self.position = Some((to, place)),
            Event::Closed { from, kind } => self.close(from, kind),
            Event::Whole {
                list,
                places: [start, end],
                kind,
                ..
            } => {
                (self.position, self.start) = (None, None);
                if let Some(kind) = kind {
                    self.keep(list, start..end, kind);
                }
            }
            Event::Hole {
                hole_idx,
                outer_idx,
            } => self.owners.push([hole_idx, outer_idx]),
            Event::Done { relation } => {
                (self.position, self.start) = (None, None);
                self.relation = Some(relation);
            }
        }
    }

    pub(super) fn finish(&self) -> WeilerAthertonOutput {
        let rings = self.rings.iter().map(|ring| (&ring.points[..], ring.kind));
        WeilerAthertonOutput {
            relation: self.relation.unwrap_or(Relation::Disjoint),
            pieces: pieces(rings, self.owners.iter().copied()),
        }
    }
}
