//! What the events of each method say of parts of the triangle.

use crate::{
    algo::{
        ring::{Crossing, Happening, RingEvent, Rule},
        volume::{
            HomogeneousTriangleEvent, IntersectionPolygonEvent, PlaneAtATimeEvent, SpaceVertex,
        },
    },
    geom::VolumeSide,
};

use super::{
    clip_space::{Uv, Vertex},
    parts::{Parts, Telling, Told},
};

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
