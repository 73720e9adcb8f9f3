//! What the last list of Sutherland–Hodgman amounts to, and the bridges in it.

use crate::{
    algo::polygon::{
        ClippedRing,
        weiler_atherton::{WeilerAtherton, WeilerAthertonInput},
    },
    geom::{Polygon, SimplePolygon, pairs_around},
};

use super::{
    clip_edge::ClipEdge,
    lists::{NAMED, middle, outline},
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
            let bridges = bridges(ring, region, "sh-bridge-adds");
            if !bridges.is_empty() && role == Role::Accepted {
                marks.extend(areas(given, region));
            }
            marks.extend(bridges);
            marks
        }
    }
}

/// Edges along the region's border that run against the ring's own winding, over others that run with it: they
/// are walked there and back, and have no area. Where they are many, the first few; the first says how long they are.
pub fn bridges<V: Vertex>(ring: &[V], region: &ClipRegion, key: &'static str) -> Vec<Mark> {
    let ring: Vec<Point> = ring.iter().map(Vertex::at).collect();
    let edges: Vec<[Point; 2]> = pairs_around(&ring)
        .filter(|ends| ends[0] != ends[1])
        .collect();
    let is_counter_clockwise = twice_area(&ring) > 0.0;
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
    let found: Vec<_> = found.map(|ends| ends.map(Point::to_array)).collect();
    let length = |[[x1, y1], [x2, y2]]: &[[f64; 2]; 2]| libm::hypot(x2 - x1, y2 - y1);
    let said = Message::new(key).with("length", found.iter().map(length).sum::<f64>());
    let mark = |(i, ends): (usize, &[[f64; 2]; 2])| {
        let mark = Mark::new(Role::Signal, Shape::Segment(*ends));
        if i == 0 {
            mark.labelled(said.clone())
        } else {
            mark
        }
    };
    found.iter().enumerate().map(mark).collect()
}

/// Of the pieces, as Weiler–Atherton leaves them without bridges.
fn areas<V: Vertex>(given: &[V], region: &ClipRegion) -> Vec<Mark> {
    let clip = match region {
        ClipRegion::Window(window) => (*window).into(),
        ClipRegion::Convex(polygon) => polygon.into(),
    };
    let input = SimplePolygon::new(&outline(given)).map(|subject| WeilerAthertonInput {
        subject: subject.into(),
        clip,
    });
    let pieces = input.map_or_else(|_| Vec::new(), |it| silent::<WeilerAtherton>(&it).pieces);
    let label = |ring: &[Point]| {
        let area = Message::new("sh-area").with("area", twice_area(ring) / 2.0);
        Mark::new(Role::Accepted, Shape::Label(middle(ring))).labelled(area)
    };
    let rings = pieces.iter().take(NAMED).map(|piece| &piece.outer);
    rings.map(|ring| label(ring)).collect()
}

/// Positive where it runs counter-clockwise.
fn twice_area(ring: &[Point]) -> f64 {
    pairs_around(ring).map(|ends| cross(ends, ring[0])).sum()
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
