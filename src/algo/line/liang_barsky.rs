//! Liang–Barsky: clip the parameter interval, not the points ([`LineClip`]). P(u) = P₁ + u (P₂ − P₁) is inside a side where `u·p ≤ q`,
//! with p = ∓Δ and q the distance of P₁ inside; at a touched corner both ends are that corner.
//!
//! *Bound*: four rows. *Cost*: at most 14 +, 4 ×, 6 ÷ and 29 comparisons. *Source*: You-Dong Liang and Brian A. Barsky, "A New Concept
//! and Method for Line Clipping", ACM Transactions on Graphics 3(1), 1984, pp. 1–22, doi:10.1145/357332.357333.
//!
//! ```
//! use clipscope::{algo::line::{LiangBarsky, WindowInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! let visible = silent::<LiangBarsky>(&WindowInput { window, segment });
//! assert_eq!(visible, Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::{
    algo::{
        parameter::Interval,
        segment::{Bounds, Ends, EventOf, Given, LineClip, LineEvent, LineRules, PlaneRow},
    },
    geom::{Edge, Window},
    trace::Real,
};

use super::{
    Visible, WindowInput,
    crossing::{corner_between, on_border, signed_distances, upright},
    ends_of, segment_of,
};

/// The algorithm; see the module.
pub type LiangBarsky = LineClip<2, Window>;

/// What happens, in order.
pub type LiangBarskyEvent = LineEvent<Edge, 2>;

impl Given<2, Window> for WindowInput {
    #[inline]
    fn bounds(&self) -> &Window {
        &self.window
    }

    #[inline]
    fn ends(&self) -> Ends<2> {
        ends_of(&self.segment)
    }
}

impl Bounds<2> for Window {
    type Plane = Edge;
    type Row = PlaneRow;
    type Input = WindowInput;
    type Output = Visible;

    #[inline]
    fn planes(&self) -> impl Iterator<Item = Edge> {
        Edge::ALL.into_iter()
    }

    #[inline]
    fn begin<R: Real, L: LineRules>(
        &self,
        [p1, p2]: &mut Ends<2>,
    ) -> (Option<EventOf<2, Self>>, Option<[R; 2]>) {
        let delta = [0, 1].map(|axis| R::new(p2[axis]) - R::new(p1[axis]));
        (Some(LineEvent::delta(delta)), Some(delta))
    }

    #[inline]
    fn inequality<R: Real>(
        &self,
        edge: Edge,
        [[x1, y1], _]: &Ends<2>,
        [dx, dy]: &[R; 2],
    ) -> ([R; 2], PlaneRow) {
        let [x1, y1, border] = [*x1, *y1, self.border(edge)].map(R::new);
        let [p, q] = match edge {
            Edge::Left => [-*dx, x1 - border],
            Edge::Right => [*dx, border - x1],
            Edge::Bottom => [-*dy, y1 - border],
            Edge::Top => [*dy, border - y1],
        };
        // −Δ of a Δ of zero is shown without a sign.
        let (shown, inside) = (p.get() + 0.0, q.get());
        (
            [p, q],
            PlaneRow {
                p: shown,
                q: inside,
            },
        )
    }

    #[inline]
    fn shown(q: f64) -> f64 {
        q
    }

    #[inline]
    fn quotient<R: Real>(&self, edge: Edge, ends: &Ends<2>, [p, q]: [R; 2]) -> R {
        upright(&segment_of(*ends), self, edge).quotient(q, p)
    }

    #[inline]
    fn distances(&self, edge: Edge, ends: &Ends<2>) -> [f64; 2] {
        signed_distances(&segment_of(*ends), self, edge)
    }

    /// Where it comes in across one side and goes out across the other: a corner.
    #[inline]
    fn touched<R: Real>(&self, interval: &Interval<R, Edge>, ends: &Ends<2>) -> Option<[Edge; 2]> {
        let edges = interval.borders()?;
        let is_touch = interval.is_touch(|edge| self.distances(edge, ends));
        // Opposite sides have no corner: each end stays on its own.
        (is_touch && corner_between(self, edges).is_some()).then_some(edges)
    }

    #[inline]
    fn crossing<R: Real>(&self, edge: Edge, touched: Option<Edge>, ends: &Ends<2>) -> [f64; 2] {
        let corner = touched.and_then(|other| corner_between(self, [edge, other]));
        let at = corner.unwrap_or_else(|| on_border::<R>(&segment_of(*ends), self, edge));
        at.to_array()
    }
}
