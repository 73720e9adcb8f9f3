//! The corners, edges and cut points of a triangle that is clipped: how they are called wherever a step shows them, and what a run
//! says of each.

use crate::{
    algo::{
        ring::{Happening, RingEvent},
        volume::{
            HomogeneousTriangleEvent, IntersectionPolygonEvent, PlaneAtATimeEvent, signed_distance,
        },
    },
    labs::frustum::prelude::*,
};

use super::{
    super::super::part::{Fate, Outcome, crossing_verdict, part_verdict, region},
    clip_space::{Uv, Vertex},
    marks::{cut, edge_link, vertex_symbol},
};

#[derive(Clone, Copy)]
struct Told<V> {
    /// From 1.
    step: usize,
    plane_idx: usize,
    /// Of an edge, of a cut one the inside end first; of a vertex by itself both are the same.
    ends: [V; 2],
    said: Said<V>,
}

impl<V> Told<V> {
    fn fate(&self, outcome: fn(usize) -> Outcome) -> Fate {
        let (step, outcome) = (self.step, outcome(self.plane_idx));
        Fate { step, outcome }
    }
}

#[derive(Clone, Copy)]
enum Said<V> {
    AreInside([bool; 2]),
    Cut(V),
}

/// A triangle that is clipped, and what its run has said of its parts.
pub struct Parts<V> {
    pub corners: [V; 3],
    told: Vec<Told<V>>,
    step: usize,
    plane_idx: usize,
    /// The edge that was asked last, the inside end first where it has one.
    edge: Option<[V; 2]>,
}

const fn corner_link(idx: usize) -> Link {
    Link::nth("corner", idx)
}

const fn cut_link(idx: usize) -> Link {
    Link::nth("cut", idx)
}

impl<V: Copy + PartialEq> Parts<V> {
    /// What marks and rows about a vertex of any list have in common: each is a corner, or a cut.
    pub fn link(&self, vertex: &V) -> Option<Link> {
        let corner = self.corners.iter().position(|corner| corner == vertex);
        let mut cuts = self.cuts().map(|(_, at)| at);
        let mut cut = || cuts.position(|at| at == *vertex);
        corner.map(corner_link).or_else(|| cut().map(cut_link))
    }

    pub fn linked(&self, mark: Mark3, vertex: &V) -> Mark3 {
        match self.link(vertex) {
            Some(link) => mark.linked(link),
            None => mark,
        }
    }

    fn cuts(&self) -> impl Iterator<Item = (&Told<V>, V)> {
        self.told.iter().filter_map(|told| match told.said {
            Said::Cut(at) => Some((told, at)),
            Said::AreInside(_) => None,
        })
    }

    /// The first test that a corner does not pass decides; of one that is kept, the last.
    fn corner_fate(&self, corner: V) -> Option<Fate> {
        let mut fate = None;
        for told in &self.told {
            let Said::AreInside(inside) = told.said else {
                continue;
            };
            let ends = told.ends.iter().zip(inside);
            for (_, is_inside) in ends.filter(|(end, _)| **end == corner) {
                if !is_inside {
                    return Some(told.fate(Outcome::Lost));
                }
                fate = Some(told.fate(|_| Outcome::Kept));
            }
        }
        fate
    }

    /// What is left of an edge is followed from cut to cut.
    fn edge_fate(&self, mut left: [V; 2]) -> Option<Fate> {
        let (mut kept, mut cut) = (None, None);
        for told in &self.told {
            if told.ends != left && told.ends != [left[1], left[0]] {
                continue;
            }
            match told.said {
                Said::AreInside([false, false]) => return Some(told.fate(Outcome::Lost)),
                Said::AreInside([true, true]) => kept = Some(told.fate(|_| Outcome::Kept)),
                Said::AreInside(_) => {}
                Said::Cut(at) => {
                    cut = cut.or(Some(told.fate(Outcome::Cut)));
                    left = [told.ends[0], at];
                }
            }
        }
        cut.or(kept)
    }

    pub fn verdict(
        &self,
        scene: &Scene,
        about: Link,
        in_world: impl Fn(&V) -> [f64; 3],
        run: &dyn Run,
    ) -> Option<Verdict> {
        let (subject, run) = (Subject::Triangle, (scene, run));
        let places = scene.places().triangle;
        if let Some(i) = (0..3).find(|&i| about == corner_link(i)) {
            let part = Message::new("part-corner").with("vertex", name(vertex_symbol(i)));
            let fate = self.corner_fate(self.corners[i])?;
            let part = (part.into(), &places[i..=i]);
            return Some(part_verdict(part, fate, subject, run));
        }
        if let Some(i) = (0..3).find(|&i| about == edge_link(i)) {
            let ends = [i, (i + 1) % 3];
            let [from, to] = ends.map(|i| name(vertex_symbol(i)));
            let part = Message::new("part-edge").with("from", from).with("to", to);
            let fate = self.edge_fate(ends.map(|i| self.corners[i]))?;
            let part = (part.into(), &ends.map(|i| places[i])[..]);
            return Some(part_verdict(part, fate, subject, run));
        }
        let mut cuts = self.cuts().enumerate();
        let (_, (cut, _)) = cuts.find(|(n, _)| about == cut_link(*n))?;
        let plane = &region(scene, subject)[cut.plane_idx];
        let distances = cut.ends.map(|end| signed_distance(plane, in_world(&end)));
        Some(crossing_verdict(cut.step, cut.plane_idx, distances, run))
    }
}

impl Parts<SpaceVertex> {
    /// The points of a cut, and the edge between two.
    pub fn cuts_of(&self, crossings: &[([usize; 2], Crossing<SpaceVertex>)]) -> Vec<Mark3> {
        let cuts = || crossings.iter().map(|(_, crossing)| &crossing.at);
        let ends = cuts().map(|v| v.at).collect::<Vec<_>>().try_into().ok();
        let edge = ends.map(|ends| Mark3::new(Role::Signal, Shape3::Segment(ends)));
        let points = cuts().enumerate();
        let points = points.map(|(i, v)| self.linked(cut(i, v), v));
        edge.into_iter().chain(points).collect()
    }
}

const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

impl<V: Copy> Parts<V> {
    const fn new(corners: [V; 3]) -> Self {
        Self {
            corners,
            told: Vec::new(),
            step: 0,
            plane_idx: 0,
            edge: None,
        }
    }

    fn tell(&mut self, ends: [V; 2], said: Said<V>) {
        let (step, plane_idx) = (self.step, self.plane_idx);
        self.told.push(Told {
            step,
            plane_idx,
            ends,
            said,
        });
    }

    /// What all clippers of rings say.
    fn hear(&mut self, event: &impl RingEvent<V>) {
        match event.happening() {
            Some(Happening::First(first)) => {
                self.tell([first.at; 2], Said::AreInside([first.inside; 2]));
            }
            Some(Happening::Test(test)) => {
                let (ends, inside) = (test.ends, test.inside());
                self.edge = Some(if inside[0] { ends } else { [ends[1], ends[0]] });
                self.tell(ends, Said::AreInside(inside));
            }
            Some(Happening::Cross(Crossing { at, .. })) => self.cut(at),
            Some(Happening::Output(_)) | None => {}
        }
    }

    fn cut(&mut self, at: V) {
        if let Some(ends) = self.edge {
            self.tell(ends, Said::Cut(at));
        }
    }
}

pub fn of_polygon(
    corners: [SpaceVertex; 3],
    events: &[IntersectionPolygonEvent],
) -> Parts<SpaceVertex> {
    let mut parts = Parts::new(corners);
    for event in events {
        parts.step += 1;
        if let IntersectionPolygonEvent::Plane { plane_idx } = *event {
            parts.plane_idx = plane_idx;
        }
        parts.hear(event);
    }
    parts
}

pub fn of_triangles(corners: [SpaceVertex; 3], events: &[PlaneAtATimeEvent]) -> Parts<SpaceVertex> {
    use PlaneAtATimeEvent as Event;
    let mut parts = Parts::new(corners);
    let (mut list, mut next) = (vec![corners], Vec::new());
    let mut asked = (corners, [false; 3]);
    for event in events {
        parts.step += 1;
        match *event {
            Event::Plane { plane_idx, .. } => parts.plane_idx = plane_idx,
            Event::Triangle {
                triangle_idx,
                inside,
                ..
            } => {
                asked = (list[triangle_idx], inside);
                for idx in EDGES {
                    let (ends, inside) = (idx.map(|i| asked.0[i]), idx.map(|i| inside[i]));
                    parts.tell(ends, Said::AreInside(inside));
                }
            }
            Event::Cross {
                idx: [from, to],
                at,
                ..
            } => {
                let (triangle, inside) = asked;
                let [inner, outer] = if inside[from] { [from, to] } else { [to, from] };
                parts.tell([triangle[inner], triangle[outer]], Said::Cut(at));
            }
            Event::Piece { triangle } => next.push(triangle),
            Event::Pass { .. } => list = std::mem::take(&mut next),
            Event::Done { .. } => {}
        }
    }
    parts
}

/// Before the divide: codes that have a side in common, or none, decide at once.
pub fn in_clip_space(given: [Vertex; 3], events: &[HomogeneousTriangleEvent<Uv>]) -> Parts<Vertex> {
    use HomogeneousTriangleEvent as Event;
    let mut parts = Parts::new(given);
    for event in events {
        parts.step += 1;
        match *event {
            Event::Divide { triangle } => parts.corners = triangle,
            Event::Codes { or, and, .. } => {
                let decided = and.lowest().map(|side| (side as usize, false));
                let decided = decided.or_else(|| or.is_inside().then_some((0, true)));
                if let Some((plane_idx, inside)) = decided {
                    parts.plane_idx = plane_idx;
                    for idx in EDGES {
                        let ends = idx.map(|i| parts.corners[i]);
                        parts.tell(ends, Said::AreInside([inside; 2]));
                    }
                }
            }
            Event::Side { side } => parts.plane_idx = side as usize,
            Event::First(_)
            | Event::Test(_)
            | Event::Cross(_)
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Done { .. } => parts.hear(event),
        }
    }
    parts
}
