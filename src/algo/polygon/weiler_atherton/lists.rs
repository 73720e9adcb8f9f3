//! The two vertex lists: each polygon's vertices in order, with the intersections put in where they lie.
//!
//! ```text
//!   subject   S₀ ─ I₀ ─ S₁ ─ S₂ ─ I₁ ─ I₂ ─ …        an intersection stands in both lists, once in each
//!                  │              │    │
//!   clip      C₀ ──┼──── C₁ ── I₂┄┼┄┄┄┄┘ …
//! ```
//!
//! The order of intersections along an edge is exact: two edges of one simple polygon do not cross, so one lies on one side of the
//! other's line, as does its crossing, and the sides of given vertices tell which comes first, never computed parameters.

use std::cmp::Ordering;

use crate::{
    geom::{Point, Rings, lexicographic},
    trace::{Real, Tell, Told},
};

use super::{
    Clipping, WeilerAtherton,
    event::WeilerAthertonEvent as Event,
    grid::{Grid, dealt},
    input::List,
    meeting::{Meeting, meetings},
    predicate::side,
    side::Labelled,
};

/// No vertex, or no intersection, here.
pub(super) const NONE: u32 = u32::MAX;

/// A place in a list.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Entry {
    vertex: u32,
    pub(super) node: u32,
    /// The entry after this one, in its ring.
    pub next: u32,
}

impl Entry {
    /// The polygon's own vertex that stands there.
    #[must_use]
    pub fn vertex(&self) -> Option<u32> {
        (self.vertex != NONE).then_some(self.vertex)
    }

    /// The intersection that stands there.
    #[must_use]
    pub fn node(&self) -> Option<u32> {
        (self.node != NONE).then_some(self.node)
    }

    /// A list's own vertices are corners, and the other polygon's along a shared edge, so that it stays shared; an intersection that a walk
    /// goes straight past is none.
    pub(super) fn is_corner(&self, labels: &[Labelled]) -> bool {
        self.vertex != NONE || self.node != NONE && labels[self.node as usize].shares_an_edge()
    }
}

/// An intersection, which is an entry in each list.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Intersection {
    /// Where, and how both borders meet there.
    pub meeting: Meeting,
    /// The edges that own it, of the subject and of the clip polygon.
    pub edges: [u32; 2],
    pub(super) places: [u32; 2],
}

impl Intersection {
    /// Its place in a list, once it is there.
    #[must_use]
    pub fn place(&self, list: List) -> Option<usize> {
        let place = self.places[list.idx()];
        (place != NONE).then_some(place as usize)
    }
}

/// Both lists and what links them.
#[derive(Clone, PartialEq, Debug)]
pub struct LinkedLists {
    /// In the order of the subject's border.
    pub nodes: Vec<Intersection>,
    /// The subject's entries, then the clip polygon's.
    pub entries: [Vec<Entry>; 2],
    /// Of each list and ring the first entry; and the number of entries at the end.
    pub(super) starts: [Vec<u32>; 2],
    /// How many edges of each polygon have been dealt with.
    n_edges: [usize; 2],
}

impl LinkedLists {
    pub(super) fn empty(borders: [&Rings; 2]) -> Self {
        Self {
            nodes: Vec::new(),
            entries: borders.map(|rings| Vec::with_capacity(2 * rings.points().len())),
            starts: [vec![0], vec![0]],
            n_edges: [0; 2],
        }
    }

    /// Where an entry of the list of this border is.
    #[must_use]
    pub fn at(&self, entry: &Entry, border: &Rings) -> Point {
        if entry.node == NONE {
            border.points()[entry.vertex as usize]
        } else {
            self.nodes[entry.node as usize].meeting.at
        }
    }

    fn push_vertex(&mut self, list: List, vertex: u32) {
        let entries = &mut self.entries[list.idx()];
        let next = entries.len() as u32 + 1;
        entries.push(Entry {
            vertex,
            node: NONE,
            next,
        });
    }

    /// An entry of its own, or the last vertex's.
    fn push_node(&mut self, list: List, node: u32, at_vertex: bool) -> u32 {
        let entries = &mut self.entries[list.idx()];
        match entries.last_mut() {
            Some(entry) if at_vertex => entry.node = node,
            _ => {
                let next = entries.len() as u32 + 1;
                entries.push(Entry {
                    vertex: NONE,
                    node,
                    next,
                });
            }
        }
        entries.len() as u32 - 1
    }

    /// An edge has been dealt with. After a ring's last one, the last entry leads back to the ring's first.
    fn end_edge(&mut self, list: List, border: &Rings) {
        let edge_idx = self.n_edges[list.idx()];
        self.n_edges[list.idx()] += 1;
        if border.next(edge_idx) > edge_idx {
            return;
        }
        let (entries, starts) = (&mut self.entries[list.idx()], &mut self.starts[list.idx()]);
        let first = starts.last().copied().unwrap_or(0);
        if let Some(last) = entries.last_mut() {
            last.next = first;
        }
        starts.push(entries.len() as u32);
    }
}

impl<T: Tell<WeilerAtherton>> Clipping<'_, T> {
    pub fn find<R: Real>(&mut self) -> Told<T::Stop> {
        let [subject, clip] = self.borders;
        let n_edges = subject.points().len();
        if self.held.lists.n_edges[0] == n_edges {
            return Told::Continue(());
        }
        let mut grid = Grid::new::<R>(subject, clip);
        let mut found: Vec<(u32, Meeting)> = Vec::new();
        for edge_idx in self.held.lists.n_edges[0]..n_edges {
            self.rest(edge_idx, n_edges);
            let edge = subject.edge(edge_idx);
            self.vertex(List::Subject, edge_idx, edge[0])?;
            grid.candidates::<R>(edge_idx, edge, |clip_edge| {
                let both = meetings::<R>(edge, clip.edge(clip_edge));
                found.extend(both.into_iter().flatten().map(|m| (clip_edge as u32, m)));
            });
            sort_along::<R, _>(edge, &mut found, |&(clip_edge, meeting)| On {
                at_vertex: meeting.contact.at_vertex(),
                at: meeting.at,
                other: clip.edge(clip_edge as usize),
            });
            for (clip_edge, meeting) in found.drain(..) {
                self.found([edge_idx as u32, clip_edge], meeting)?;
            }
            self.held.lists.end_edge(List::Subject, subject);
        }
        Told::Continue(())
    }

    pub fn insert<R: Real>(&mut self) -> Told<T::Stop> {
        let [subject, clip] = self.borders;
        let n_edges = clip.points().len();
        if self.held.lists.n_edges[1] == n_edges {
            return Told::Continue(());
        }
        let nodes = (0..).zip(&self.held.lists.nodes);
        let (mut by_edge, starts) = dealt(n_edges, nodes.map(|(i, node)| [node.edges[1], i]));
        for edge_idx in self.held.lists.n_edges[1]..n_edges {
            self.rest(edge_idx, n_edges);
            let edge = clip.edge(edge_idx);
            self.vertex(List::Clip, edge_idx, edge[0])?;
            let [start, end] = [starts[edge_idx], starts[edge_idx + 1]].map(|i| i as usize);
            let nodes = &self.held.lists.nodes;
            sort_along::<R, _>(edge, &mut by_edge[start..end], |&node_idx| {
                let node = &nodes[node_idx as usize];
                let [subject_vertex, clip_vertex] = node.meeting.contact.at_vertex();
                On {
                    at_vertex: [clip_vertex, subject_vertex],
                    at: node.meeting.at,
                    other: subject.edge(node.edges[0] as usize),
                }
            });
            for &node_idx in &by_edge[start..end] {
                let lists = &mut self.held.lists;
                let Meeting { contact, at, .. } = lists.nodes[node_idx as usize].meeting;
                let at_vertex = contact.at_vertex()[1];
                let place = lists.push_node(List::Clip, node_idx, at_vertex);
                lists.nodes[node_idx as usize].places[1] = place;
                self.tell(Event::Inserted {
                    node_idx,
                    at,
                    at_vertex,
                })?;
            }
            self.held.lists.end_edge(List::Clip, clip);
        }
        Told::Continue(())
    }

    #[inline]
    fn vertex(&mut self, list: List, vertex_idx: usize, at: Point) -> Told<T::Stop> {
        let vertex_idx = vertex_idx as u32;
        self.held.lists.push_vertex(list, vertex_idx);
        self.tell(Event::Vertex {
            list,
            vertex_idx,
            at,
        })
    }

    #[inline]
    fn found(&mut self, edges: [u32; 2], meeting: Meeting) -> Told<T::Stop> {
        let Meeting {
            contact,
            at,
            t,
            u,
            along,
            ..
        } = meeting;
        let lists = &mut self.held.lists;
        let node_idx = lists.nodes.len() as u32;
        let place = lists.push_node(List::Subject, node_idx, contact.at_vertex()[0]);
        lists.nodes.push(Intersection {
            meeting,
            edges,
            places: [place, NONE],
        });
        self.tell(Event::Found {
            node_idx,
            edges,
            contact,
            at,
            t,
            u,
            along,
        })
    }
}

struct On {
    /// Is it a vertex of this polygon, of the other one?
    at_vertex: [bool; 2],
    at: Point,
    /// The other polygon's edge; where it is a vertex of that polygon, `other[0]` is it.
    other: [Point; 2],
}

/// Sorts intersections of one edge from its first end to its last, exactly.
#[inline]
fn sort_along<R: Real, T>(edge: [Point; 2], items: &mut [T], on: impl Fn(&T) -> On) {
    if items.len() > 1 {
        items.sort_unstable_by(|x, y| compare::<R>(edge, &on(x), &on(y)));
    }
}

fn compare<R: Real>([from, to]: [Point; 2], x: &On, y: &On) -> Ordering {
    // Is `p` on the side of the line that the edge comes from? None on the line itself.
    let is_before = |[a, b]: [Point; 2], p: Point| {
        let [p, from]: [R; 2] = [p, from].map(|point| side(a, b, point));
        let zero = R::new(0.0);
        (p != zero).then(|| (p > zero) == (from > zero))
    };
    let order = |before: bool| {
        if before {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    };
    match (x.at_vertex, y.at_vertex) {
        // The edge's own first end comes first.
        ([true, _], _) => Ordering::Less,
        (_, [true, _]) => Ordering::Greater,
        // Both are given points of one line.
        ([_, true], [_, true]) => {
            let order = lexicographic(x.at, y.at);
            if lexicographic(from, to) == Ordering::Less {
                order
            } else {
                order.reverse()
            }
        }
        ([_, true], _) => is_before(y.other, x.at).map_or(Ordering::Equal, order),
        (_, [_, true]) => is_before(x.other, y.at).map_or(Ordering::Equal, |before| order(!before)),
        // Where the edge of x lies on one side of that of y, its crossing lies there too; otherwise the other
        // way round.
        _ => {
            let one_side = |a: &On, b: &On| {
                let [p, q] = a.other.map(|p| is_before(b.other, p));
                match (p, q) {
                    (Some(p), Some(q)) => (p == q).then_some(p),
                    (p, q) => p.or(q),
                }
            };
            let before = one_side(x, y).or_else(|| one_side(y, x).map(|before| !before));
            before.map_or(Ordering::Equal, order)
        }
    }
}
