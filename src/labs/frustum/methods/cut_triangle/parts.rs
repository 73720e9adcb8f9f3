//! The corners, edges and cut points of a triangle that is clipped: how they are called wherever a step shows them, and what a run
//! says of each.

use crate::{
    algo::{
        ring::{Crossing, Happening, RingEvent, Rule},
        volume::{
            HomogeneousTriangleEvent, IntersectionPolygonEvent, PlaneAtATimeEvent, SpaceVertex,
            signed_distance,
        },
    },
    figure::{Link, Mark3, Run},
    geom::VolumeSide,
    labs::{Verdict, words::name},
    text::Message,
};

use super::{
    super::super::{
        Scene, Subject,
        part::{Fate, Outcome, crossing_verdict, part_verdict, region},
    },
    clip_space::{Uv, Vertex},
    marks::edge_link,
    symbols::vertex_symbol,
};

/// What a step says.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Telling<V> {
    /// On which sides of the plane both ends of an edge lie; of a vertex by itself both are the same.
    Asked {
        /// Its ends.
        ends: [V; 2],
        /// Are they inside?
        inside: [bool; 2],
    },
    /// Where an edge crosses the plane.
    Cut {
        /// Its ends, the inside one first.
        ends: [V; 2],
        /// Where.
        at: V,
    },
}

/// A step of a run that says something of a part.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Told<V> {
    /// From 1.
    pub step: usize,
    /// The plane that is asked.
    pub plane_idx: usize,
    /// What it says.
    pub telling: Telling<V>,
}

/// A triangle that is clipped, and all that its run says.
pub struct Parts<V> {
    /// As they were given.
    pub corners: [V; 3],
    /// In the run's order.
    pub told: Vec<Told<V>>,
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
        let mut cuts = self.cuts().map(|(_, _, at)| at);
        let mut cut = || cuts.position(|at| at == *vertex);
        corner.map(corner_link).or_else(|| cut().map(cut_link))
    }

    /// A mark of a vertex of any list, linked.
    pub fn linked(&self, mark: Mark3, vertex: &V) -> Mark3 {
        match self.link(vertex) {
            Some(link) => mark.linked(link),
            None => mark,
        }
    }

    /// How many crossings the run finds.
    pub fn n_cuts(&self) -> usize {
        self.cuts().count()
    }

    fn cuts(&self) -> impl Iterator<Item = (&Told<V>, [V; 2], V)> {
        self.told.iter().filter_map(|told| match told.telling {
            Telling::Cut { ends, at } => Some((told, ends, at)),
            Telling::Asked { .. } => None,
        })
    }

    /// The first test that a corner does not pass decides; of one that is kept, the last.
    fn corner_fate(&self, corner: V) -> Option<Fate> {
        let mut fate = None;
        for told in &self.told {
            let Telling::Asked { ends, inside } = told.telling else {
                continue;
            };
            let (step, plane_idx) = (told.step, told.plane_idx);
            for (_, is_inside) in ends.iter().zip(inside).filter(|(end, _)| **end == corner) {
                if !is_inside {
                    let outcome = Outcome::Lost(plane_idx);
                    return Some(Fate { step, outcome });
                }
                let outcome = Outcome::Kept;
                fate = Some(Fate { step, outcome });
            }
        }
        fate
    }

    /// What is left of an edge is followed from cut to cut.
    fn edge_fate(&self, mut left: [V; 2]) -> Option<Fate> {
        let (mut kept, mut cut) = (None, None);
        for told in &self.told {
            let (step, plane_idx) = (told.step, told.plane_idx);
            let of = |outcome| Fate { step, outcome };
            let (Telling::Asked { ends, .. } | Telling::Cut { ends, .. }) = told.telling;
            if ends != left && ends != [left[1], left[0]] {
                continue;
            }
            match told.telling {
                Telling::Asked { inside, .. } => match inside {
                    [false, false] => return Some(of(Outcome::Lost(plane_idx))),
                    [true, true] => kept = Some(of(Outcome::Kept)),
                    [true, false] | [false, true] => {}
                },
                Telling::Cut {
                    ends: [inner, _],
                    at,
                } => {
                    cut = cut.or(Some(of(Outcome::Cut(plane_idx))));
                    left = [inner, at];
                }
            }
        }
        cut.or(kept)
    }

    /// What is told of a corner, an edge or a cut point.
    pub fn verdict(
        &self,
        scene: &Scene,
        about: Link,
        in_world: impl Fn(&V) -> [f64; 3],
        run: &dyn Run,
    ) -> Option<Verdict> {
        let planes = region(scene, Subject::Triangle);
        let told = (run, scene.method.card().is_faulty);
        let places = scene.places.triangle();
        if let Some(i) = (0..3).find(|&i| about == corner_link(i)) {
            let part = Message::new("part-corner").with("vertex", name(vertex_symbol(i)));
            let fate = self.corner_fate(self.corners[i])?;
            return Some(part_verdict(
                part.into(),
                &places[i..=i],
                fate,
                &planes,
                told,
            ));
        }
        if let Some(i) = (0..3).find(|&i| about == edge_link(i)) {
            let ends = [i, (i + 1) % 3];
            let [from, to] = ends.map(|i| name(vertex_symbol(i)));
            let part = Message::new("part-edge").with("from", from).with("to", to);
            let fate = self.edge_fate(ends.map(|i| self.corners[i]))?;
            let places = ends.map(|i| places[i]);
            return Some(part_verdict(part.into(), &places, fate, &planes, told));
        }
        let mut cuts = self.cuts().enumerate();
        let (_, (cut, ends, _)) = cuts.find(|(n, _)| about == cut_link(*n))?;
        let plane = &planes[cut.plane_idx];
        let distances = ends.map(|end| signed_distance(plane, in_world(&end)));
        Some(crossing_verdict(cut.step, cut.plane_idx, distances, told))
    }
}

/// The three edges of a triangle.
const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// The steps of a run so far.
struct Teller<V> {
    step: usize,
    plane_idx: usize,
    told: Vec<Told<V>>,
    /// The edge that was asked last, the inside end first where it has one.
    edge: Option<[V; 2]>,
}

impl<V: Copy> Teller<V> {
    const fn new() -> Self {
        Self {
            step: 0,
            plane_idx: 0,
            told: Vec::new(),
            edge: None,
        }
    }

    fn tell(&mut self, telling: Telling<V>) {
        self.told.push(Told {
            step: self.step,
            plane_idx: self.plane_idx,
            telling,
        });
    }

    /// What all clippers of rings say.
    fn hear(&mut self, event: &impl RingEvent<V>) {
        match event.happening() {
            Some(Happening::First { at, inside, .. }) => {
                let (ends, inside) = ([at; 2], [inside; 2]);
                self.tell(Telling::Asked { ends, inside });
            }
            Some(Happening::Test { ends, rule, .. }) => self.edge(ends, rule),
            Some(Happening::Cross(Crossing { at, .. })) => self.cut(at),
            Some(Happening::Output(_)) | None => {}
        }
    }

    fn edge(&mut self, ends: [V; 2], rule: Rule) {
        let inside = [rule.starts_inside(), rule.ends_inside()];
        self.edge = Some(if inside[0] { ends } else { [ends[1], ends[0]] });
        self.tell(Telling::Asked { ends, inside });
    }

    fn cut(&mut self, at: V) {
        if let Some(ends) = self.edge {
            self.tell(Telling::Cut { ends, at });
        }
    }

    fn parts(self, corners: [V; 3]) -> Parts<V> {
        let told = self.told;
        Parts { corners, told }
    }
}

/// Of one polygon.
pub fn of_polygon(
    corners: [SpaceVertex; 3],
    events: &[IntersectionPolygonEvent],
) -> Parts<SpaceVertex> {
    let mut teller = Teller::new();
    for event in events {
        teller.step += 1;
        if let IntersectionPolygonEvent::Plane { plane_idx } = *event {
            teller.plane_idx = plane_idx;
        }
        teller.hear(event);
    }
    teller.parts(corners)
}

/// Of triangle by triangle.
pub fn of_triangles(corners: [SpaceVertex; 3], events: &[PlaneAtATimeEvent]) -> Parts<SpaceVertex> {
    use PlaneAtATimeEvent as Event;
    let mut teller = Teller::new();
    let (mut list, mut next) = (vec![corners], Vec::new());
    let mut asked = (corners, [false; 3]);
    for event in events {
        teller.step += 1;
        match *event {
            Event::Plane { plane_idx, .. } => teller.plane_idx = plane_idx,
            Event::Triangle {
                triangle_idx,
                inside,
                ..
            } => {
                asked = (list[triangle_idx], inside);
                for idx in EDGES {
                    let (ends, inside) = (idx.map(|i| asked.0[i]), idx.map(|i| inside[i]));
                    teller.tell(Telling::Asked { ends, inside });
                }
            }
            Event::Cross {
                idx: [from, to],
                at,
                ..
            } => {
                let (triangle, inside) = asked;
                let [inner, outer] = if inside[from] { [from, to] } else { [to, from] };
                teller.edge = Some([triangle[inner], triangle[outer]]);
                teller.cut(at);
            }
            Event::Piece { triangle } => next.push(triangle),
            Event::Pass { .. } => list = std::mem::take(&mut next),
            Event::Done { .. } => {}
        }
    }
    teller.parts(corners)
}

/// Before the divide: codes that have a side in common, or none, decide at once.
pub fn in_clip_space(
    corners: [Vertex; 3],
    events: &[HomogeneousTriangleEvent<Uv>],
) -> Parts<Vertex> {
    use HomogeneousTriangleEvent as Event;
    let (mut teller, mut corners) = (Teller::new(), corners);
    let idx_of = |side: VolumeSide| side as usize;
    for event in events {
        teller.step += 1;
        match *event {
            Event::Divide { triangle } => corners = triangle,
            Event::Codes { or, and, .. } => {
                let decided = and.lowest().map(|side| (idx_of(side), false));
                let decided = decided.or_else(|| or.is_inside().then_some((0, true)));
                if let Some((plane_idx, inside)) = decided {
                    teller.plane_idx = plane_idx;
                    for idx in EDGES {
                        let ends = idx.map(|i| corners[i]);
                        let inside = [inside; 2];
                        teller.tell(Telling::Asked { ends, inside });
                    }
                }
            }
            Event::Side { side } => teller.plane_idx = idx_of(side),
            Event::First { .. }
            | Event::Test { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Done { .. } => teller.hear(event),
        }
    }
    teller.parts(corners)
}
