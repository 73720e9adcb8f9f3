//! Liang–Barsky: clip the parameter interval, not the points.
//!
//! A point P(u) = P₁ + u (P₂ − P₁) is inside the window where four inequalities `u·p ≤ q` hold:
//!
//! ```text
//!   k  side     p     q                p < 0: the line comes in here,  u ≥ r = q/p
//!   1  left    −Δx    x₁ − xmin        p > 0: it goes out here,        u ≤ r
//!   2  right    Δx    xmax − x₁        p = 0: parallel; inside if q ≥ 0
//!   3  bottom  −Δy    y₁ − ymin
//!   4  top      Δy    ymax − y₁        0 ──[u_min ━━━━━ u_max]── 1
//! ```
//!
//! 1. Start with the whole segment: u_min = 0, u_max = 1.
//! 2. For each side, compute p and q. Parallel and outside (p = 0, q < 0): reject. Otherwise r = q/p
//!    raises u_min or lowers u_max.
//! 3. Reject as soon as u_min > u_max. Otherwise the answer is P(u_min) to P(u_max).
//!
//! u_min = u_max is one point, on the border: a touch, accepted. `max`, `min` and `>` on parameters are
//! exact ([`compare`]); an end is put on the border that set its parameter, and at a touched corner
//! both ends are that corner.
//!
//! [`compare`]: crate::algo::parameter::Param::compare
//!
//! *Conventions*: closed window, y up. *Degenerate*: a point has all p = 0 and is accepted if all q ≥ 0.
//! *Bound*: four rows. *Cost*: at most 14 +, 4 ×, 6 ÷ and 29 comparisons.
//!
//! *Source*: You-Dong Liang and Brian A. Barsky, "A New Concept and Method for Line Clipping", ACM
//! Transactions on Graphics 3(1), 1984, pp. 1–22, doi:10.1145/357332.357333.
//!
//! ```
//! use clipscope::{algo::line::{LiangBarsky, WindowInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! assert_eq!(
//!     silent::<LiangBarsky>(&WindowInput { window, segment }),
//!     Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?),
//! );
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::{
    algo::{
        parameter::Interval,
        segment::{
            Bounds, EventOf, Given, LineClip, LineEvent, LineRules, RowNumbers, Spelling,
            VisibleLine,
        },
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
pub type LiangBarskyEvent = LineEvent<Edge, 2, WindowRow>;

/// p and q of a side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WindowRow {
    /// Which way the line goes: into the window where negative.
    pub p: f64,
    /// How far P₁ lies inside the side.
    pub q: f64,
}

impl RowNumbers for WindowRow {
    const SPELLING: Spelling = Spelling {
        row: "row",
        plane: "edge",
        q: "q",
        r: "r",
        u: "u",
        bounds: ["u_min", "u_max"],
    };

    fn p_and_q(&self) -> [f64; 2] {
        [self.p, self.q]
    }
}

impl Given<2, Window> for WindowInput {
    #[inline]
    fn bounds(&self) -> &Window {
        &self.window
    }

    #[inline]
    fn ends(&self) -> [[f64; 2]; 2] {
        ends_of(&self.segment)
    }
}

impl Bounds<2> for Window {
    type Plane = Edge;
    type Row = WindowRow;
    /// Δx and Δy
    type Once<R: Real> = [R; 2];
    type Input = WindowInput;
    type Output = Visible;

    #[inline]
    fn answer(visible: VisibleLine<2>) -> Visible {
        visible.map(segment_of)
    }

    #[inline]
    fn planes(&self) -> impl Iterator<Item = Edge> {
        Edge::ALL.into_iter()
    }

    #[inline]
    fn begin<R: Real, L: LineRules>(
        &self,
        [p1, p2]: &mut [[f64; 2]; 2],
    ) -> (Option<EventOf<2, Self>>, Option<[R; 2]>) {
        let once = [0, 1].map(|axis| R::new(p2[axis]) - R::new(p1[axis]));
        let delta = once.map(R::get);
        (Some(LineEvent::Delta { delta }), Some(once))
    }

    #[inline]
    fn inequality<R: Real>(
        &self,
        edge: Edge,
        [[x1, y1], _]: &[[f64; 2]; 2],
        [dx, dy]: &[R; 2],
    ) -> ([R; 2], WindowRow) {
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
            WindowRow {
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
    fn quotient<R: Real>(&self, edge: Edge, ends: &[[f64; 2]; 2], [p, q]: [R; 2]) -> R {
        upright(&segment_of(*ends), self, edge).quotient(q, p)
    }

    #[inline]
    fn distances(&self, edge: Edge, ends: &[[f64; 2]; 2]) -> [f64; 2] {
        signed_distances(&segment_of(*ends), self, edge)
    }

    /// Where it comes in across one side and goes out across the other: a corner.
    #[inline]
    fn touched<R: Real>(
        &self,
        interval: &Interval<R, Edge>,
        ends: &[[f64; 2]; 2],
    ) -> Option<[Edge; 2]> {
        let edges = interval.borders()?;
        let is_touch = interval.is_touch(|edge| self.distances(edge, ends));
        // Opposite sides have no corner: each end stays on its own.
        (is_touch && corner_between(self, edges).is_some()).then_some(edges)
    }

    #[inline]
    fn crossing<R: Real>(
        &self,
        edge: Edge,
        touched: Option<Edge>,
        ends: &[[f64; 2]; 2],
    ) -> [f64; 2] {
        let corner = touched.and_then(|other| corner_between(self, [edge, other]));
        let at = corner.unwrap_or_else(|| on_border::<R>(&segment_of(*ends), self, edge));
        at.to_array()
    }
}
