//! What the steps of each method say of parts of the triangle.

use crate::{
    algo::{
        ring::Rule,
        volume::{
            HomogeneousTriangle, HomogeneousTriangleEvent, IntersectionPolygon,
            IntersectionPolygonEvent, PlaneAtATime, PlaneAtATimeEvent, SpaceVertex, TrianglePlanes,
            VolumeRules,
        },
    },
    trace::Algorithm,
};

use super::{
    clip_space::{Uv, Vertex},
    parts::{Parts, Telling, Told},
};

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

    fn vertex(&mut self, at: V, inside: bool) {
        let (ends, inside) = ([at; 2], [inside; 2]);
        self.tell(Telling::Asked { ends, inside });
    }

    fn edge(&mut self, ends: [V; 2], rule: Rule) {
        let ends_inside = rule.ends_inside();
        let inside = [ends_inside != rule.changes_side(), ends_inside];
        self.edge = Some(if inside[0] { ends } else { [ends[1], ends[0]] });
        self.tell(Telling::Asked { ends, inside });
    }

    fn cut(&mut self, at: V) {
        if let Some(ends) = self.edge {
            self.tell(Telling::Cut { ends, at });
        }
    }
}

/// Of one polygon.
pub fn of_polygon<L: VolumeRules>(input: &TrianglePlanes) -> Parts<SpaceVertex> {
    use IntersectionPolygonEvent as Event;
    let mut teller = Teller::new();
    IntersectionPolygon::<L>::run::<f64>(input, |event| {
        teller.step += 1;
        match event {
            Event::Plane { plane_idx } => teller.plane_idx = plane_idx,
            Event::First { at, inside, .. } => teller.vertex(at, inside),
            Event::Test { ends, rule, .. } => teller.edge(ends, rule),
            Event::Cross { at, .. } => teller.cut(at),
            Event::Output { .. } | Event::Pass { .. } | Event::Fan { .. } | Event::Done { .. } => {}
        }
    });
    Parts {
        corners: input.triangle,
        told: teller.told,
    }
}

/// Of triangle by triangle.
pub fn of_triangles<L: VolumeRules>(input: &TrianglePlanes) -> Parts<SpaceVertex> {
    use PlaneAtATimeEvent as Event;
    let mut teller = Teller::new();
    let mut state = PlaneAtATime::<L>::start(input);
    PlaneAtATime::<L>::run::<f64>(input, |event| {
        teller.step += 1;
        match event {
            Event::Plane { plane_idx, .. } => teller.plane_idx = plane_idx,
            Event::Triangle {
                triangle_idx,
                inside,
                ..
            } => {
                let triangle = state.list[triangle_idx];
                for idx in [[0, 1], [1, 2], [2, 0]] {
                    let (ends, inside) = (idx.map(|i| triangle[i]), idx.map(|i| inside[i]));
                    teller.tell(Telling::Asked { ends, inside });
                }
            }
            Event::Cross { idx, at, .. } => {
                let asked = state.asked.last();
                teller.edge = asked.map(|asked| {
                    let triangle = state.list[asked.triangle_idx];
                    let [from, to] = idx;
                    let idx = if asked.inside[from] { idx } else { [to, from] };
                    idx.map(|i| triangle[i])
                });
                teller.cut(at);
            }
            Event::Piece { .. } | Event::Pass { .. } | Event::Done { .. } => {}
        }
        PlaneAtATime::<L>::apply(&mut state, event);
    });
    Parts {
        corners: input.triangle,
        told: teller.told,
    }
}

/// Before the divide: codes that have a side in common, or none, decide at once.
pub fn in_clip_space<L: VolumeRules>(triangle: &[Vertex; 3]) -> Parts<Vertex> {
    use HomogeneousTriangleEvent as Event;
    let (mut teller, mut corners) = (Teller::new(), *triangle);
    HomogeneousTriangle::<Uv, L>::run::<f64>(triangle, |event| {
        teller.step += 1;
        match event {
            Event::Codes { or, and, .. } => {
                let decided = and.lowest().map(|side| (side as usize, false));
                let decided = decided.or_else(|| or.is_inside().then_some((0, true)));
                if let Some((plane_idx, inside)) = decided {
                    teller.plane_idx = plane_idx;
                    for idx in [[0, 1], [1, 2], [2, 0]] {
                        let ends = idx.map(|i| corners[i]);
                        let inside = [inside; 2];
                        teller.tell(Telling::Asked { ends, inside });
                    }
                }
            }
            Event::Side { side } => teller.plane_idx = side as usize,
            Event::First { at, inside, .. } => teller.vertex(at, inside),
            Event::Test { ends, rule, .. } => teller.edge(ends, rule),
            Event::Cross { at, .. } => teller.cut(at),
            Event::Divide { triangle } => corners = triangle,
            Event::Output { .. } | Event::Pass { .. } | Event::Done { .. } => {}
        }
    });
    Parts {
        corners,
        told: teller.told,
    }
}
