//! What Cyrus–Beck knows of the edges: their names, their crossings as a table, and the vectors of the edge in hand, on the stage at
//! true length and beside it.

use glam::DVec2;

use crate::{
    algo::line::{CyrusBeckEvent as Event, CyrusBeckRow as Row},
    figure::{Measured, Product, Products, Vector},
    geom::{ConvexPolygon, extent},
    labs::{
        interval::direction,
        segments::{LineStep, row_values},
        words::{polygon_edge_link, polygon_edge_name},
    },
};

use super::{prelude::*, shared::on_line};

pub type Shown<'a> = LineStep<'a, 2, ConvexPolygon>;

/// The edge whose products are shown: the one in hand, as long as it is not rejected by.
pub fn edge_in_hand(shown: &Shown<'_>) -> Option<usize> {
    let is_rejected = matches!(shown.event, Some(Event::Reject { .. }));
    shown.in_hand().filter(|_| !is_rejected)
}

pub fn edge_table(shown: &Shown<'_>) -> Table {
    let is_interval = matches!(shown.event, Some(Event::Interval { .. }));
    let current = if let Some(Event::Put { plane, .. }) = shown.event {
        plane
    } else {
        shown.in_hand().filter(|_| !is_interval)
    };
    let values = row_values(shown, None);
    let rows = values.into_iter().enumerate().map(|(i, values)| {
        let row = shown.rows.get(i);
        let sets = shown.set_by.contains(&Some(i));
        let role = if sets { Role::Ink } else { Role::Soft };
        let mut cells: Vec<Cell> = values
            .cells
            .into_iter()
            .map(|value| Cell::new(role, value))
            .collect();
        if sets {
            let t = cells.pop();
            cells.extend(t.map(Cell::strong));
        }
        let word = row.map(|row| Value::Term(direction(row.p())));
        cells.push(Cell::new(role, word));
        TableRow {
            name: polygon_edge_name(i),
            cells,
            is_current: current == Some(i),
            link: Some(polygon_edge_link(i)),
        }
    });
    Table {
        header: vec![
            Formula::default().term("table-polygon-edge"),
            sym("n·(P₁ − E)"),
            sym("n·D"),
            sym("t"),
            Formula::default(),
        ],
        rows: rows.collect(),
        notes: Vec::new(),
    }
}

/// n·D and n·(P₁ − E) of the edge in hand, and both ends measured along n; `None` where no edge is.
pub fn products(shown: &Shown<'_>) -> Option<Products> {
    let edge_idx = edge_in_hand(shown)?;
    let row = &shown.rows.get(edge_idx)?.numbers;
    let Segment { p1, p2 } = shown.input.segment;
    let is_current = matches!(shown.event, Some(Event::Row { .. }));
    let vector = |symbol: &str, to: [f64; 2], role| Vector {
        name: name(symbol),
        to,
        role,
    };
    let difference = |a: Point, b: Point| [a.x() - b.x(), a.y() - b.y()];
    let product = |of: Vector, decision: Message, value: f64| {
        let terms = row.normal.into_iter().zip(of.to);
        let terms = terms.filter(|&(n, _)| n != 0.0);
        Product {
            arithmetic: sum_of(Formula::default(), terms, times).equals(value),
            onto: vector("n", row.normal, Role::Signal),
            of,
            decision,
            is_current,
        }
    };
    let along = sign_of(
        row.slope,
        ["cb-sign-enters", "cb-sign-parallel", "cb-sign-leaves"],
    );
    let along = Message::new(along).with("product", name("n·D"));
    let inside = sign_of(row.d1, ["cb-sign-inside", "cb-sign-on", "cb-sign-outside"]);
    let inside = Message::new(inside)
        .with("product", name("n·(P₁ − E)"))
        .with("end", name("P₁"));
    let d = vector("D", difference(p2, p1), Role::Accent);
    let from_edge = vector("P₁ − E", difference(p1, row.origin), Role::Ink);
    Some(Products {
        products: vec![
            product(d, along, row.slope),
            product(from_edge, inside, row.d1),
        ],
        measured: Some(measured(edge_idx, row)),
    })
}

fn sign_of(x: f64, [positive, zero, negative]: [&'static str; 3]) -> &'static str {
    if x > 0.0 {
        positive
    } else if x < 0.0 {
        negative
    } else {
        zero
    }
}

fn measured(edge_idx: usize, row: &Row) -> Measured {
    let mut spans = vec![([0.0, row.d1], Value::Number(row.d1.abs()), Role::Signal)];
    if row.slope != 0.0 {
        let whole = sym("n·D = ").num(row.slope);
        spans.push(([row.d1, row.d2], whole.into(), Role::Accent));
    }
    spans.retain(|([from, to], ..)| from != to);
    Measured {
        title: Message::new("cb-measured").with("normal", name("n")),
        zero: polygon_edge_name(edge_idx),
        ends: [(name("P₁"), row.d1), (name("P₂"), row.d2)],
        spans,
    }
}

/// Every edge with its name and the side that its normal points to; of the edge in hand everything that is multiplied.
pub fn edge_marks(shown: &Shown<'_>) -> Vec<Mark> {
    let vertices = shown.input.clip.vertices();
    let in_hand = edge_in_hand(shown);
    let [min, max] = extent(vertices.iter().copied());
    // Long enough to be seen, whatever the size of the polygon.
    let length = 0.1 * (max[0] - min[0]).max(max[1] - min[1]);
    let mut marks = Vec::new();
    for (i, plane) in shown.input.clip.half_planes().enumerate() {
        let edge = [i, (i + 1) % vertices.len()].map(|i| vertices[i].to_array());
        if in_hand == Some(i) {
            marks.extend(outside_marks(i, edge, shown.is_turned));
            continue;
        }
        let middle = DVec2::from(edge[0]).midpoint(DVec2::from(edge[1]));
        let length = if shown.is_turned { -length } else { length };
        let tip = middle + DVec2::from(plane.normal()).normalize_or_zero() * length;
        marks.push(
            Mark::new(
                Role::Soft,
                Shape::Arrow([middle.to_array(), tip.to_array()]),
            )
            .labelled(polygon_edge_name(i))
            .linked(polygon_edge_link(i)),
        );
    }
    let row = in_hand.and_then(|i| Some((i, &shown.rows.get(i)?.numbers)));
    if let Some((i, row)) = row {
        let edge = [i, (i + 1) % vertices.len()].map(|i| vertices[i].to_array());
        marks.extend(vector_marks(edge, row, &shown.input.segment));
    }
    marks
}

fn outside_marks(edge_idx: usize, [a, b]: [[f64; 2]; 2], is_turned: bool) -> [Mark; 3] {
    // The polygon lies to the left of a → b.
    let wash = if is_turned { [a, b] } else { [b, a] };
    [
        Mark::new(Role::Signal, Shape::Wash(wash)),
        Mark::new(Role::Signal, Shape::Line([a, b])).dashed(),
        Mark::new(Role::Signal, Shape::Segment([a, b]))
            .labelled(polygon_edge_name(edge_idx))
            .strong()
            .linked(polygon_edge_link(edge_idx)),
    ]
}

fn vector_marks(edge: [[f64; 2]; 2], row: &Row, segment: &Segment) -> Vec<Mark> {
    let [p1, p2, origin] = [segment.p1, segment.p2, row.origin].map(Point::to_array);
    let mut marks = Vec::new();
    if p1 != origin {
        let ends = [origin, p1];
        marks.push(Mark::new(Role::Ink, Shape::Arrow(ends)));
        let along = Mark::new(Role::Ink, Shape::Segment(ends));
        marks.push(along.labelled(name("P₁ − E")).strong());
    }
    let (from, is_crossing) = foot(edge, row, segment);
    let [nx, ny] = row.normal;
    let tip = [from[0] + nx, from[1] + ny];
    let normal = Mark::new(Role::Signal, Shape::Arrow([from, tip]));
    marks.push(normal.labelled(name("n")).strong());
    marks.push(Mark::new(
        Role::Signal,
        Shape::RightAngle([from, edge[0], tip]),
    ));
    if is_crossing && from != edge[0] {
        let along = [from[0] + p2[0] - p1[0], from[1] + p2[1] - p1[1]];
        marks.push(Mark::new(Role::Ink, Shape::Angle([from, tip, along])));
    }
    marks.push(
        Mark::new(Role::Signal, Shape::Dot(origin))
            .labelled(name("E"))
            .strong(),
    );
    marks
}

/// Where n is drawn from: from the crossing, so that its angle to D is seen, or from the middle of an edge that the
/// segment's line does not meet; is it the crossing?
fn foot([a, b]: [[f64; 2]; 2], row: &Row, segment: &Segment) -> ([f64; 2], bool) {
    let (a, b) = (DVec2::from(a), DVec2::from(b));
    if row.slope != 0.0 {
        let at = DVec2::from(on_line(segment, -row.d1 / row.slope));
        if (at - a).dot(at - b) <= 0.0 {
            return (at.to_array(), true);
        }
    }
    (a.midpoint(b).to_array(), false)
}
