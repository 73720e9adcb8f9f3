//! A clip edge in words, formulas and marks: half of every sentence about Sutherland–Hodgman.

use crate::{
    algo::polygon::Rules,
    figure::Weight,
    geom::{Axis, Edge, Segment, Window},
    labs::{
        crossing_formulas::{Weights, dot_product, fixed, oblique, upright},
        words::{
            along, axis_symbol, border_equation, edge_link, edge_name, polygon_edge_link,
            polygon_edge_name,
        },
    },
};

use super::prelude::*;

#[derive(Clone, Copy)]
pub struct ClipEdge<'a> {
    region: &'a ClipRegion,
    idx: usize,
    /// Takes the wrong side of every edge for its inside.
    is_flipped: bool,
    /// Takes what lies on an edge for outside.
    is_strict: bool,
}

pub fn clip_edge_name(region: &ClipRegion, edge_idx: usize) -> Value {
    ClipEdge::new::<Right>(region, edge_idx).name()
}

impl<'a> ClipEdge<'a> {
    /// As these rules look at it.
    pub const fn new<L: Rules>(region: &'a ClipRegion, idx: usize) -> Self {
        Self {
            region,
            idx,
            is_flipped: L::CLOCKWISE,
            is_strict: !L::BORDER_IS_INSIDE,
        }
    }

    pub const fn idx(&self) -> usize {
        self.idx
    }

    fn side(&self) -> Option<(&'a Window, Edge)> {
        match self.region {
            ClipRegion::Window(window) => Some((window, Edge::ALL[self.idx])),
            ClipRegion::Convex(_) => None,
        }
    }

    /// Its two ends, the region to its left; as a flipped variant walks it, the other way.
    fn ends(&self) -> [[f64; 2]; 2] {
        let [a, b] = match self.region {
            ClipRegion::Window(window) => {
                let [low_left, low_right, high_right, high_left] = window.corners();
                match Edge::ALL[self.idx] {
                    Edge::Left => [high_left, low_left],
                    Edge::Right => [low_right, high_right],
                    Edge::Bottom => [low_left, low_right],
                    Edge::Top => [high_right, high_left],
                }
            }
            ClipRegion::Convex(polygon) => {
                let vertices = polygon.vertices();
                [0, 1].map(|k| vertices[(self.idx + k) % vertices.len()])
            }
        };
        let ends = [a, b].map(Point::to_array);
        if self.is_flipped {
            [ends[1], ends[0]]
        } else {
            ends
        }
    }

    /// `left edge`, or `e₃`.
    pub fn name(&self) -> Value {
        match self.side() {
            Some((_, edge)) => edge_name(edge),
            None => polygon_edge_name(self.idx),
        }
    }

    pub fn link(&self) -> Link {
        match self.side() {
            Some((_, edge)) => edge_link(edge),
            None => polygon_edge_link(self.idx),
        }
    }

    /// `x = −1`, or `e₃`.
    pub fn border(&self) -> Value {
        match self.side() {
            Some((window, edge)) => border_equation(window, edge).into(),
            None => self.name(),
        }
    }

    fn is_upper(&self, edge: Edge) -> bool {
        edge.is_max() != self.is_flipped
    }

    /// `≥`, `<` and so on: how a coordinate, or a distance, of the inside or the outside stands to the border.
    const fn relation(&self, is_inside: bool, is_upper: bool) -> &'static str {
        match (is_inside != is_upper, is_inside != self.is_strict) {
            (true, true) => " ≥ ",
            (true, false) => " > ",
            (false, true) => " ≤ ",
            (false, false) => " < ",
        }
    }

    /// `x ≥ −1`, or `n·(P − E) ≥ 0`.
    pub fn inside(&self) -> Formula {
        match self.side() {
            Some((window, edge)) => Formula::default()
                .sym(axis_symbol(edge.axis()))
                .sym(self.relation(true, self.is_upper(edge)))
                .num(window.border(edge)),
            None => Formula::default()
                .sym("n·(P − E)")
                .sym(self.relation(true, false))
                .sym("0"),
        }
    }

    /// `V₄: x = −2 < −1`, or `V₄: n·(V₄ − E) = 1 · (3 − 1) + 2 · (0 − 2) = −2 < 0`.
    pub fn position(&self, (symbol, at): (&str, Point), distance: f64, is_inside: bool) -> Formula {
        let formula = Formula::default().sym(format!("{symbol}: "));
        match self.side() {
            Some((window, edge)) => formula
                .sym(axis_symbol(edge.axis()))
                .sym(" = ")
                .num(along(at, edge.axis())[0])
                .sym(self.relation(is_inside, self.is_upper(edge)))
                .num(window.border(edge)),
            None => self
                .dot_product(formula.sym(format!("n·({symbol} − E) = ")), at)
                .equals(distance)
                .sym(self.relation(is_inside, false))
                .sym("0"),
        }
    }

    /// `1 · (3 − 1) + 2 · (0 − 2)`: as a flipped variant has it, with the normal turned round.
    fn dot_product(&self, formula: Formula, at: Point) -> Formula {
        let plane = self.region.half_planes()[self.idx];
        let sign = if self.is_flipped { -1.0 } else { 1.0 };
        let normal = plane.normal().map(|n| sign * n);
        dot_product(formula, normal, at, plane.origin())
    }

    fn upright_line(&self) -> Option<(Axis, f64)> {
        let plane = self.region.half_planes()[self.idx];
        fixed(plane.normal(), plane.origin())
    }

    pub fn crossing(&self, [p1, p2]: [Point; 2], distances: [f64; 2], at: Point) -> Vec<Formula> {
        match self.upright_line() {
            Some((axis, c)) => upright(&Segment { p1, p2 }, axis, c, at),
            None => vec![oblique("I", [p1, p2], distances, at)],
        }
    }

    /// How S and P lie to it, and the formulas by which a crossing is found, by their names in templates.
    pub fn asked<V: Vertex>(
        &self,
        name_of: &str,
        event: &impl RingEvent<V>,
        (asked, symbols): (&Asked<V>, [String; 2]),
    ) -> Option<Formula> {
        let happening = event.happening()?;
        let lies = |i: usize| {
            let test = asked.test?;
            let vertex = (&*symbols[i], test.ends[i].at());
            Some(self.position(vertex, test.distances[i], test.inside()[i]))
        };
        let nth = |i: usize| {
            let (Happening::Cross(crossing), Some(test)) = (happening, asked.test) else {
                return None;
            };
            let ends = test.ends.map(|v| v.at());
            let formulas = self.crossing(ends, test.distances, crossing.at.at());
            formulas.into_iter().nth(i)
        };
        match (name_of, happening) {
            ("P lies", Happening::First(first)) => {
                let vertex = (&*symbols[1], first.at.at());
                Some(self.position(vertex, first.distance, first.inside))
            }
            ("S lies", _) => lies(0),
            ("P lies", _) => lies(1),
            ("I 1", _) => nth(0),
            ("I 2", _) => nth(1),
            ("I 3", _) => nth(2),
            _ => None,
        }
    }

    pub fn weights(&self, ends: [Point; 2], distances: [f64; 2]) -> Weights {
        match self.upright_line() {
            Some((axis, c)) => Weights::along(ends.map(|p| along(p, axis)[0]), c),
            None => Weights::across(distances),
        }
    }

    pub fn mark(&self, role: Role) -> Mark {
        let [a, b] = self.ends();
        let label: Value = match self.side() {
            Some(_) => self.inside().into(),
            None => self.name(),
        };
        // The region lies to the left of a → b.
        Mark::new(role, Shape::HalfPlane([b, a]))
            .labelled(label)
            .toward([a[1] - b[1], b[0] - a[0]])
            .linked(self.link())
    }

    /// The other edges, which do not count as long as this one is at work; is that said?
    pub fn others(&self, is_said: bool) -> Vec<Mark> {
        let others = (0..self.region.n_edges()).filter(|&idx| idx != self.idx && !self.is_flipped);
        let mark = |idx| {
            let other = Self { idx, ..*self };
            let path = Shape::Path(other.ends().to_vec());
            let mark = Mark::new(Role::Discarded, path).weighing(Weight::of(2.5));
            if !is_said || other.side().is_none() {
                return mark;
            }
            mark.labelled(Message::new("sh-does-not-count").with("inside", other.inside()))
        };
        others.map(mark).collect()
    }

    /// Does this edge of a ring run along it? Up to a rounding, where the clip edge is oblique.
    pub fn carries(&self, ends: [Point; 2]) -> bool {
        if let Some((window, edge)) = self.side() {
            return ends
                .iter()
                .all(|&p| along(p, edge.axis())[0] == window.border(edge));
        }
        let [a, b] = self.ends();
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let is_near = |p: &Point| {
            let [x, y] = [p.x() - a[0], p.y() - a[1]];
            (dx * y - dy * x).abs() <= 1e-12 * (dx * dx + dy * dy + x * x + y * y)
        };
        ends.iter().all(is_near)
    }

    pub fn runs_forward(&self, ends: [Point; 2]) -> bool {
        let [a, b] = self.ends();
        let [p, q] = ends.map(Point::to_array);
        (b[0] - a[0]) * (q[0] - p[0]) + (b[1] - a[1]) * (q[1] - p[1]) > 0.0
    }
}
