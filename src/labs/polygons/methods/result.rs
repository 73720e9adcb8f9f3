//! What the last list of Sutherland–Hodgman amounts to, and the bridges in it.

use crate::{algo::polygon::ClippedRing, geom::Polygon};

use super::{
    clip_edge::ClipEdge,
    lists::{NAMED, outline},
    prelude::*,
    skin::LabVertex,
};

impl<V: LabVertex> Answer for ClippedRing<V> {
    fn told(&self) -> impl Serialize {
        #[derive(Serialize)]
        struct Told<U> {
            polygons: Vec<Polygon>,
            outcome: RingOutcome,
            #[serde(skip_serializing_if = "Option::is_none")]
            uv: Option<U>,
        }
        let polygons = Vec::from_iter(self.polygon());
        let n_rings = polygons.len();
        let uv = move || {
            let ring = || self.vertices.iter().map(LabVertex::uv);
            (0..n_rings).map(move |_| Each(ring))
        };
        Told {
            polygons,
            outcome: self.outcome,
            uv: V::IS_TEXTURED.then_some(Each(uv)),
        }
    }
}

pub fn result<V: Vertex>(
    ring: &[V],
    (outcome, role): (RingOutcome, Role),
    region: &ClipRegion,
    given: &[V],
) -> Vec<Mark> {
    let shape = |role, shape| Mark::new(role, shape).linked("result");
    match outcome {
        RingOutcome::Empty => vec![shape(Role::Discarded, Shape::Outline(outline(given)))],
        RingOutcome::Degenerate => {
            let mut path = outline(ring);
            path.extend(path.first().copied());
            let dots = ring.iter().take(NAMED);
            let dots = dots.map(|v| shape(role, Shape::Dot(v.at().to_array())));
            std::iter::once(shape(role, Shape::Path(path)))
                .chain(dots)
                .collect()
        }
        RingOutcome::Whole | RingOutcome::Cut => {
            let mut marks = vec![shape(role, Shape::Area(vec![outline(ring)]))];
            marks.extend(bridges(ring, region));
            marks
        }
    }
}

/// Edges along the region's border that run against the ring's own winding, over others that run with it: they
/// are walked there and back, and have no area. Where they are many, the first few; the first has the name.
pub fn bridges<V: Vertex>(ring: &[V], region: &ClipRegion) -> Vec<Mark> {
    let n = ring.len();
    let edges: Vec<[Point; 2]> = (0..n)
        .map(|i| [i, (i + 1) % n].map(|k| ring[k].at()))
        .filter(|ends| ends[0] != ends[1])
        .collect();
    let is_counter_clockwise = edges.iter().map(|&e| cross(e, ring[0].at())).sum::<f64>() > 0.0;
    let borders: Vec<_> = (0..region.n_edges())
        .map(|idx| ClipEdge::new::<Right>(region, idx))
        .collect();
    let is_bridge = |&ends: &[Point; 2]| {
        let mut borders = borders.iter().filter(|border| border.carries(ends));
        borders.any(|border| {
            border.runs_forward(ends) != is_counter_clockwise
                && edges.iter().any(|&back| {
                    border.carries(back)
                        && border.runs_forward(back) == is_counter_clockwise
                        && overlap(ends, back)
                })
        })
    };
    let found = edges.iter().copied().filter(is_bridge).take(NAMED);
    let mark = |(i, ends): (usize, [Point; 2])| {
        let mark = Mark::new(Role::Signal, Shape::Segment(ends.map(Point::to_array)));
        if i == 0 {
            let [[x1, y1], [x2, y2]] = ends.map(Point::to_array);
            let length = libm::hypot(x2 - x1, y2 - y1);
            mark.labelled(Message::new("sh-bridge").with("length", length))
        } else {
            mark
        }
    };
    found.enumerate().map(mark).collect()
}

fn overlap([a, b]: [Point; 2], other: [Point; 2]) -> bool {
    let along = |p: Point| (p.x() - a.x()) * (b.x() - a.x()) + (p.y() - a.y()) * (b.y() - a.y());
    let [p, q] = other.map(along);
    p.min(q) < along(b) && p.max(q) > 0.0
}

fn cross(ends: [Point; 2], origin: Point) -> f64 {
    let [[x1, y1], [x2, y2]] = ends.map(|p| [p.x() - origin.x(), p.y() - origin.y()]);
    x1 * y2 - x2 * y1
}
