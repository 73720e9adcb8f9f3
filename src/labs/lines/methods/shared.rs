//! Words, formulas and marks that several methods share.

use crate::{
    algo::{
        line::{Ratio, corner_between},
        segment::{LineEvent, VisibleLine},
    },
    figure::Side,
    labs::{
        crossing_formulas::taken,
        interval::{ShownCrossing, ShownInterval},
    },
};

use super::prelude::*;

pub fn point([x, y]: [f64; 2]) -> Point {
    Point::new(x, y).unwrap_or_default()
}

pub fn side(edge: Edge) -> Named {
    Named::from(edge_name(edge)).linked(edge_link(edge))
}

pub fn end_now(end: End, at: Point) -> Named {
    Named::from(at.to_array()).linked(end_link(end))
}

pub fn ends(segment: Segment) -> [[f64; 2]; 2] {
    [segment.p1, segment.p2].map(Point::to_array)
}

/// The original segment, what is left of it, and its ends.
///
/// Discarded parts are ghosted; what is left is accented while it is alive, green once accepted. A segment that is
/// rejected is dashed, but in ink: it carries the point.
pub fn segment_marks(original: &Segment, ends: [Point; 2], is_visible: Option<bool>) -> Vec<Mark> {
    let rejected = is_visible == Some(false);
    let role = match is_visible {
        None => Role::Accent,
        Some(false) => Role::Ink,
        Some(true) => Role::Accepted,
    };
    let mut marks = Vec::new();
    for end in End::BOTH {
        let (from, to) = (end.of(original), ends[end.idx()]);
        if from != to {
            let ghost = Shape::Segment([from.to_array(), to.to_array()]);
            marks.push(Mark::new(Role::Discarded, ghost));
        }
    }
    let left = Shape::Segment([ends[0].to_array(), ends[1].to_array()]);
    let left = Mark::new(role, left).linked("segment");
    marks.push(if rejected { left.dashed() } else { left });
    for end in End::BOTH {
        let (from, to) = (end.of(original), ends[end.idx()]);
        let moved = from != to;
        let given = match (moved, rejected) {
            (true, _) => Role::Discarded,
            (false, true) => Role::Ink,
            (false, false) => role,
        };
        marks.push(
            Mark::new(given, Shape::Ring(from.to_array()))
                .labelled(end_name(end))
                .strong()
                .linked(end_link(end)),
        );
        if moved {
            marks.push(
                Mark::new(role, Shape::Dot(to.to_array()))
                    .labelled(end_name_now(end, true))
                    .strong()
                    .linked(end_link(end)),
            );
        }
    }
    marks
}

/// How an end came to its place on a side. Where the segment only touches the corner between the `sides` by which it
/// comes in and goes out, nothing is computed.
pub fn put_formulas(
    segment: &Segment,
    window: &Window,
    edge: Edge,
    at: Point,
    sides: Option<[Edge; 2]>,
) -> Vec<Formula> {
    let corner = sides.and_then(|sides| corner_between(window, sides));
    if corner == Some(at) {
        taken(edge.axis(), at)
    } else {
        upright(segment, edge.axis(), window.border(edge), at)
    }
}

/// `Δx = 0`: why there is no crossing.
pub fn parallel_formula(segment: &Segment, edge: Edge) -> Formula {
    let symbol = match edge.axis() {
        Axis::X => "x₁ = x₂ = ",
        Axis::Y => "y₁ = y₂ = ",
    };
    sym(symbol).num(along(segment.p1, edge.axis())[0])
}

pub const fn side_key(edge: Edge) -> &'static str {
    match edge {
        Edge::Left => "side-left",
        Edge::Right => "side-right",
        Edge::Bottom => "side-bottom",
        Edge::Top => "side-top",
    }
}

pub fn border(window: &Window, edge: Edge) -> Shape {
    Shape::Border(edge.axis(), window.border(edge))
}

pub fn border_mark(window: &Window, edge: Edge) -> Mark {
    Mark::new(Role::Signal, border(window, edge))
        .labelled(border_equation(window, edge))
        .linked(edge_link(edge))
}

pub fn inside_mark(window: &Window, edge: Edge) -> Mark {
    let relation = if edge.is_max() { " ≤ " } else { " ≥ " };
    let [x, y] = outwards(edge);
    Mark::new(Role::Soft, border(window, edge))
        .labelled(side_formula(window, edge, relation))
        .toward([-x, -y])
        .linked(edge_link(edge))
}

/// A side as this step's subject: its line with `y = 1`, and what lies beyond it with `y > 1`.
pub fn outside_marks(window: &Window, edge: Edge) -> [Mark; 2] {
    let relation = if edge.is_max() { " > " } else { " < " };
    [
        Mark::new(Role::Signal, Shape::HalfPlane(beyond(window, edge)))
            .labelled(border_equation(window, edge))
            .linked(edge_link(edge)),
        Mark::new(Role::Signal, border(window, edge))
            .labelled(side_formula(window, edge, relation))
            .toward(outwards(edge)),
    ]
}

/// What lies beyond is to the left of the line from the first point to the second.
pub fn beyond(window: &Window, edge: Edge) -> [[f64; 2]; 2] {
    let c = window.border(edge);
    match edge {
        Edge::Left => [[c, 0.0], [c, 1.0]],
        Edge::Right => [[c, 1.0], [c, 0.0]],
        Edge::Bottom => [[1.0, c], [0.0, c]],
        Edge::Top => [[0.0, c], [1.0, c]],
    }
}

const fn outwards(edge: Edge) -> [f64; 2] {
    match edge {
        Edge::Left => [-1.0, 0.0],
        Edge::Right => [1.0, 0.0],
        Edge::Bottom => [0.0, -1.0],
        Edge::Top => [0.0, 1.0],
    }
}

/// `y > 1`
fn side_formula(window: &Window, edge: Edge, relation: &'static str) -> Formula {
    sym(axis_symbol(edge.axis()))
        .sym(relation)
        .num(window.border(edge))
}

pub fn crossing_mark(at: Point, symbol: &'static str, u: Ratio) -> Mark {
    let dot = Mark::new(Role::Signal, Shape::Dot(at.to_array()));
    dot.labelled(equal_to(symbol, u)).strong()
}

/// Catalogue key of the region of a point that lies beyond the sides for which `beyond` is true.
pub fn region_key(beyond: impl Fn(Edge) -> bool) -> &'static str {
    let column = usize::from(beyond(Edge::Right)) + 1 - usize::from(beyond(Edge::Left));
    let row = usize::from(beyond(Edge::Top)) + 1 - usize::from(beyond(Edge::Bottom));
    [
        ["region-below-left", "region-below", "region-below-right"],
        ["region-left", "region-inside", "region-right"],
        ["region-above-left", "region-above", "region-above-right"],
    ][row][column]
}

/// `C₁`, `C₂`, …: the window's corners are numbered counter-clockwise from the lower left.
fn corner_symbol(window: &Window, corner: Point) -> String {
    let found = window.corners().iter().position(|&c| c == corner);
    found.map_or_else(|| "C".to_owned(), |i| numbered('C', i))
}

pub fn corner_name(window: &Window, corner: Point) -> Value {
    name(corner_symbol(window, corner))
}

/// `C₄ = (−1, 1)`, in a sentence.
pub fn corner_formula(window: &Window, corner: Point) -> Formula {
    let formula = sym(corner_symbol(window, corner));
    formula.sym(" = ").point(corner.to_array())
}

pub struct SegmentInterval {
    pub shown: ShownInterval,
    pub crossing_symbol: &'static str,
    pub verdict: Option<VisibleLine<2>>,
    /// Is the segment's line drawn beyond its ends, with the crossings there?
    pub goes_on: bool,
    /// At this step the segment is seen as a vector of this name, from P₁ to P₂.
    pub vector: Option<&'static str>,
}

impl SegmentInterval {
    pub fn marks(&self, segment: &Segment) -> Vec<Mark> {
        if let Some(Some(visible)) = self.verdict {
            return segment_marks(segment, visible.map(point), Some(true));
        }
        let mut marks = self.parts(segment);
        let both = self.both_bounds();
        for crossing in &self.shown.crossings {
            if both.is_some() && crossing.holds {
                continue;
            }
            let at = on_line(segment, crossing.at);
            let is_drawn = self.goes_on || (0.0..=1.0).contains(&crossing.at);
            let on_end = End::BOTH.iter().any(|end| end.of(segment).to_array() == at);
            let mark = if crossing.holds {
                self.bound_mark(crossing, segment)
            } else if crossing.current {
                let label = equal_to(self.crossing_symbol, crossing.quotient);
                let cross = Mark::new(Role::Signal, Shape::Cross(at));
                cross.labelled(label).strong()
            } else if on_end || !is_drawn {
                // The end itself is enough; a cross on no line says nothing.
                continue;
            } else {
                Mark::new(Role::Soft, Shape::Vertex(at))
            };
            marks.push(mark.linked(crossing.link));
        }
        marks.extend(both.map(|crossing| {
            let symbols = [Side::Entering, Side::Leaving].map(|side| self.shown.bound_symbol(side));
            let Mark { role, link, .. } = self.bound_mark(crossing, segment);
            let dot = Mark::new(role, Shape::Dot(on_line(segment, crossing.at)));
            let label = equal_to(symbols.join(" = "), crossing.quotient);
            Mark {
                link,
                ..dot.labelled(label).strong()
            }
        }));
        marks
    }

    /// Where both bounds stand: of the two crossings there this step's.
    fn both_bounds(&self) -> Option<&ShownCrossing> {
        let [low, high] = self.shown.bounds;
        let holding = self.shown.crossings.iter().filter(|it| it.holds);
        holding
            .max_by_key(|it| it.current)
            .filter(|_| low.total_cmp(&high).is_eq())
    }

    fn bound_mark(&self, crossing: &ShownCrossing, segment: &Segment) -> Mark {
        let at = on_line(segment, crossing.at);
        let role = match (crossing.current, self.shown.is_crossed_over()) {
            (true, _) => Role::Signal,
            (false, true) => Role::Ink,
            (false, false) => Role::Accent,
        };
        let label = equal_to(self.shown.bound_symbol(crossing.side), crossing.quotient);
        // The bound allows what comes after u_min and before u_max.
        let allowed = match crossing.side {
            Side::Entering => segment.p2,
            Side::Leaving => segment.p1,
        };
        let head = Shape::Bound([at, allowed.to_array()]);
        Mark::new(role, head).labelled(label).strong()
    }

    /// All of the segment is still there, only the bounds move: what is left stands out. Where they have passed each
    /// other, the part between them is crossed over.
    fn parts(&self, segment: &Segment) -> Vec<Mark> {
        let ends = [segment.p1, segment.p2];
        let crossed = self.shown.is_crossed_over();
        let verdict = self.verdict.or(crossed.then_some(None));
        let is_visible = verdict.map(|visible| visible.is_some());
        let mut marks = segment_marks(segment, ends, is_visible);
        let [from, to] = self.shown.bounds;
        let between = [from, to].map(|u| on_line(segment, u));
        if crossed {
            let middle = on_line(segment, from.midpoint(to));
            marks.push(Mark::new(Role::Signal, Shape::Segment(between)));
            marks.push(Mark::new(Role::Signal, Shape::Cross(middle)));
        } else if verdict.is_none() && self.shown.bounds != [0.0, 1.0] {
            marks[0] = Mark::new(Role::Discarded, Shape::Segment(ends.map(Point::to_array)));
            let left = Mark::new(Role::Accent, Shape::Segment(between));
            marks.insert(1, left.linked("segment"));
        }
        if let (Some(symbol), None) = (self.vector, verdict) {
            let arrow = Mark::new(Role::Accent, Shape::Arrow(ends.map(Point::to_array)));
            if self.shown.bounds == [0.0, 1.0] {
                marks[0] = marks[0].clone().labelled(name(symbol)).strong();
                marks.insert(1, arrow);
            } else {
                marks[0] = arrow.dashed();
                marks[1] = marks[1].clone().labelled(name(symbol)).strong();
            }
        }
        marks
    }
}

/// P(u), to place a mark: the algorithm itself never computes points that it does not put out.
pub fn on_line(segment: &Segment, u: f64) -> [f64; 2] {
    let [x1, y1, x2, y2] = segment.to_array();
    [x1 + u * (x2 - x1), y1 + u * (y2 - y1)]
}

/// Of a clipper by inequalities: the end that a bound which has moved cuts off, and up to where.
pub fn bounded<P, W>(event: &LineEvent<P, 2, W>) -> Option<(End, f64)> {
    match *event {
        LineEvent::Enter {
            raises: true,
            u_min,
            ..
        } => Some((End::P1, u_min)),
        LineEvent::Leave {
            lowers: true,
            u_max,
            ..
        } => Some((End::P2, u_max)),
        LineEvent::Enter { .. }
        | LineEvent::Leave { .. }
        | LineEvent::Delta { .. }
        | LineEvent::Depths { .. }
        | LineEvent::Row { .. }
        | LineEvent::Parallel { .. }
        | LineEvent::Interval { .. }
        | LineEvent::Put { .. }
        | LineEvent::Accept { .. }
        | LineEvent::Reject { .. } => None,
    }
}
