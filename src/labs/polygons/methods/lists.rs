//! The two lists of Sutherland–Hodgman, as rows of the watch table; and what their last one amounts to.

use crate::{
    algo::polygon::{ClipRegion, ClippedRing, RingOutcome, Vertex},
    figure::{Link, Mark, Role, Shape, WatchRow, WatchSection},
    geom::Point,
    labs::{
        Answer,
        words::{name, subscript},
    },
    text::Value,
};

use super::{
    clip_edge::{ClipEdge, Look},
    skin::Corner,
};

use serde_json::{Value as Json, json};

/// Lists up to this length are shown whole, side by side.
const FEW: usize = 12;
/// Of longer ones this many rows.
const ROWS: usize = 6;
/// Up to this many vertices get their names on stage.
const NAMED: usize = 24;

impl<V: Corner> Answer for ClippedRing<V> {
    fn json(&self) -> Json {
        let polygon = self.polygon();
        let mut json = json!({ "polygons": Vec::from_iter(&polygon), "outcome": self.outcome });
        if V::IS_TEXTURED {
            let uv = || self.vertices.iter().map(Corner::uv).collect::<Vec<_>>();
            json["uv"] = json!(Vec::from_iter(polygon.map(|_| uv())));
        }
        json
    }
}

/// `V₃`: in the input list.
pub fn input_symbol(idx: usize) -> String {
    format!("V{}", subscript(idx + 1))
}

/// `V₃′`: in the output list.
pub fn output_symbol(idx: usize) -> String {
    format!("{}′", input_symbol(idx))
}

/// What marks and rows about a vertex of the input list have in common.
pub const fn vertex_link(idx: usize) -> Link {
    Link::nth("vertex", idx)
}

fn point<V: Vertex>(vertex: &V) -> Value {
    Value::Point(vertex.at().to_array())
}

/// Input list and output list, with their places in the texture where they have such. Where they are long: the
/// input about `current`, and the output's end.
pub fn rows<V: Corner>(input: &[V], output: &[V], current: usize) -> Vec<WatchSection> {
    let n = input.len().max(output.len());
    if n <= FEW {
        let table = |header: [&'static str; 2], value: fn(&V) -> Option<Value>| {
            let row = |i: usize| {
                let cells = [input, output].map(|list| list.get(i).and_then(value));
                WatchRow::table(name((i + 1).to_string()), cells.to_vec()).linked(vertex_link(i))
            };
            WatchSection::table(header.to_vec(), (0..n).map(row).collect())
        };
        let places = table(["V", "V′"], |v| Some(point(v)));
        let texels = V::IS_TEXTURED.then(|| table(["uv", "uv′"], |v| v.uv().map(Value::Point)));
        return std::iter::once(places).chain(texels).collect();
    }
    let start = current
        .saturating_sub(ROWS / 2)
        .min(input.len().saturating_sub(ROWS));
    let shown = input.iter().enumerate().skip(start).take(ROWS);
    let input = shown
        .map(|(i, v)| WatchRow::new(name(input_symbol(i)), Some(point(v))).linked(vertex_link(i)));
    let start = output.len().saturating_sub(ROWS);
    let shown = output.iter().enumerate().skip(start);
    let output = shown.map(|(i, v)| WatchRow::new(name(output_symbol(i)), Some(point(v))));
    vec![
        WatchSection::list(input.collect()),
        WatchSection::list(output.collect()),
    ]
}

/// The vertices and their names, where they are few; but for those that this step shows by themselves.
pub fn names<V: Vertex>(list: &[V], shown: &[usize]) -> Vec<Mark> {
    if list.len() > NAMED {
        return Vec::new();
    }
    let others = list.iter().enumerate().filter(|(i, _)| !shown.contains(i));
    let mark = |(i, v): (usize, &V)| {
        Mark::new(Role::Soft, Shape::Dot(v.at().to_array()))
            .labelled(name(input_symbol(i)))
            .linked(vertex_link(i))
    };
    others.map(mark).collect()
}

pub fn outline<V: Vertex>(ring: &[V]) -> Vec<[f64; 2]> {
    ring.iter().map(|v| v.at().to_array()).collect()
}

/// What is left, and its bridges.
pub fn result<V: Vertex>(
    ring: &[V],
    outcome: RingOutcome,
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
            let dots = dots.map(|v| shape(Role::Accepted, Shape::Dot(v.at().to_array())));
            std::iter::once(shape(Role::Accepted, Shape::Path(path)))
                .chain(dots)
                .collect()
        }
        RingOutcome::Whole | RingOutcome::Cut => {
            let mut marks = vec![shape(Role::Accepted, Shape::Area(vec![outline(ring)]))];
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
        .map(|idx| ClipEdge::new(region, idx, Look::RIGHT))
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
            mark.labelled(Value::Term("sh-bridge"))
        } else {
            mark
        }
    };
    found.enumerate().map(mark).collect()
}

/// Have two edges of one line more than a point in common?
fn overlap([a, b]: [Point; 2], other: [Point; 2]) -> bool {
    let along = |p: Point| (p.x() - a.x()) * (b.x() - a.x()) + (p.y() - a.y()) * (b.y() - a.y());
    let [p, q] = other.map(along);
    p.min(q) < along(b) && p.max(q) > 0.0
}

fn cross(ends: [Point; 2], origin: Point) -> f64 {
    let [[x1, y1], [x2, y2]] = ends.map(|p| [p.x() - origin.x(), p.y() - origin.y()]);
    x1 * y2 - x2 * y1
}
