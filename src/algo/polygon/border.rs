//! The border of a clip region, edge by edge: how far inside a vertex lies, and where an edge crosses.
//!
//! ```text
//!   inside end ●                 d = n·(V − E): positive inside, 0 on the border
//!            d₁│ ╲
//!   ───────────┴──×──┬────────  border line through E, normal n pointing inside
//!                  ╲ │d₂         crossing: (V₁·|d₂| + V₂·|d₁|) / (|d₁| + |d₂|)
//!                    ● outside end
//! ```
//!
//! A crossing is computed from the inside end, whichever way the edge is walked: polygons that share an edge get the same bits. Along an
//! axis the border coordinate is assigned and the sign of a distance is exact. On an oblique border both are rounded, so a crossing
//! is settled inside by its own distances ([`Borders::settle`]): that is why clipping again changes nothing.

use std::hint::select_unpredictable;

use crate::{
    geom::{Axis, HalfPlane, Point, Segment, Wide},
    trace::Real,
};

use super::{
    super::line::{
        convex_border::plane_distances,
        crossing::{join, split},
    },
    super::{
        parameter::{Share, Upright},
        ring::{Crossing, Limit, Rules},
    },
    ClipRegion, Vertex,
};

/// A clip edge: the line that it runs along, and its inside.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Border {
    edge_idx: usize,
    plane: HalfPlane,
    line: BorderLine,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum BorderLine {
    /// Along an axis: inside is where the `axis` coordinate is at least `c`, or at most `c` if `is_max`.
    Upright { axis: Axis, c: f64, is_max: bool },
    /// Any other: inside is where `normal·(p − origin) ≥ 0`.
    Oblique { normal: [f64; 2], origin: Point },
}

impl Border {
    fn new((edge_idx, plane): (usize, HalfPlane)) -> Self {
        let origin = plane.origin();
        let upright = |axis, c, n| BorderLine::Upright {
            axis,
            c,
            is_max: n < 0.0,
        };
        let line = match plane.normal() {
            [n, 0.0] => upright(Axis::X, origin.x(), n),
            [0.0, n] => upright(Axis::Y, origin.y(), n),
            normal => BorderLine::Oblique { normal, origin },
        };
        Self {
            edge_idx,
            plane,
            line,
        }
    }

    fn flipped(self) -> Self {
        let line = match self.line {
            BorderLine::Upright { axis, c, is_max } => BorderLine::Upright {
                axis,
                c,
                is_max: !is_max,
            },
            BorderLine::Oblique { normal, origin } => BorderLine::Oblique {
                normal: normal.map(|n| -n),
                origin,
            },
        };
        Self { line, ..self }
    }

    pub const fn edge_idx(&self) -> usize {
        self.edge_idx
    }

    /// Where it runs.
    #[inline]
    pub const fn line(&self) -> BorderLine {
        self.line
    }

    /// n, pointing inside; of length 1 along an axis only.
    pub fn normal(&self) -> [f64; 2] {
        match self.line {
            BorderLine::Upright { axis, is_max, .. } => {
                let n = if is_max { -1.0 } else { 1.0 };
                match axis {
                    Axis::X => [n, 0.0],
                    Axis::Y => [0.0, n],
                }
            }
            BorderLine::Oblique { normal, .. } => normal,
        }
    }

    /// E, a point of the border.
    pub const fn origin(&self) -> Point {
        self.plane.origin()
    }

    /// Signed distance of `p` in lengths of n, inside positive. Too large for f64, it is the largest number.
    #[inline]
    pub fn distance<R: Real>(&self, p: Point) -> R {
        let d = self.as_computed::<R>(p);
        if d.get().is_finite() {
            d
        } else {
            R::new(self.huge_distance(p))
        }
    }

    #[inline]
    fn as_computed<R: Real>(&self, p: Point) -> R {
        match self.line {
            BorderLine::Upright { axis, c, is_max } => upright_distance(axis, is_max, c, p),
            BorderLine::Oblique { normal, origin } => {
                let ([px, py], [ex, ey]) = (p.to_array(), origin.to_array());
                R::new(normal[0]) * (R::new(px) - R::new(ex))
                    + R::new(normal[1]) * (R::new(py) - R::new(ey))
            }
        }
    }

    #[cold]
    fn told_huge(&self, p: Point) -> f64 {
        self.as_computed(p)
    }

    #[cold]
    fn huge_distance(&self, p: Point) -> f64 {
        let sign = self.as_computed::<Wide>(p).bounded();
        if sign == 0.0 {
            0.0
        } else {
            f64::MAX.copysign(sign)
        }
    }

    /// `d1` and `d2` are the distances of the ends, one positive and one negative.
    #[inline]
    fn share<R: Real>(&self, [p1, p2]: [Point; 2], [d1, d2]: [R; 2]) -> Share<R> {
        match self.line {
            BorderLine::Upright { axis, c, is_max } => upright_share([p1, p2], axis, is_max, c),
            BorderLine::Oblique { normal, .. } => {
                let whole = d1 - d2;
                let [d1, d2, whole] = if whole.get().is_finite() {
                    [d1, d2, whole]
                } else {
                    // Both to one scale: only their ratio counts. A flipped border's plane is not.
                    let is_flipped = normal[0].signum() != self.plane.normal()[0].signum();
                    let distances = plane_distances::<R>(&Segment { p1, p2 }, &self.plane);
                    let [d1, d2] = distances.map(|d| if is_flipped { -d } else { d });
                    [d1, d2, d1 - d2]
                };
                Share {
                    weights: [d1, -d2],
                    whole,
                    raw: [-d1.get(), -d2.get(), 0.0],
                }
            }
        }
    }
}

/// The crossing of an edge, given by its inside end first; `None` at that end.
#[inline(always)]
fn unless_at_end<R: Real, V: Vertex>(
    [inside, outside]: [&V; 2],
    at: Point,
    (share, is_leaving): (&Share<R>, bool),
) -> Option<Crossing<V>> {
    (at != inside.at()).then(|| Crossing {
        at: inside.crossing(outside, at, share),
        t: share.ratio(is_leaving),
    })
}

#[inline(always)]
fn upright_distance<R: Real>(axis: Axis, is_max: bool, c: f64, p: Point) -> R {
    let ([a, _], c) = (split::<R>(p, axis), R::new(c));
    if is_max { c - a } else { a - c }
}

#[inline(always)]
fn upright_share<R: Real>(ends: [Point; 2], axis: Axis, is_max: bool, at: f64) -> Share<R> {
    let ends = ends.map(|p| split::<f64>(p, axis)[0]);
    Upright { ends, at, is_max }.share()
}

#[inline(always)]
fn upright_crossing<R: Real>(ends: [Point; 2], axis: Axis, c: f64, share: &Share<R>) -> Point {
    let [[_, o1], [_, o2]] = ends.map(|p| split::<f64>(p, axis));
    join(axis, c, share.mean(o1, o2))
}

/// All borders of a region, in the order in which they clip.
#[derive(Clone, Debug)]
pub struct Borders {
    all: Vec<Border>,
    /// Index of the first oblique one; that of the end where there is none.
    first_oblique: usize,
    /// A point well inside all of them.
    middle: Point,
}

impl Borders {
    pub fn by<L: Rules>(region: &ClipRegion) -> Self {
        let mut all: Vec<Border> = (0..).zip(region.half_planes()).map(Border::new).collect();
        if L::CLOCKWISE {
            all.reverse();
            all = all.into_iter().map(Border::flipped).collect();
        }
        Self::new(all)
    }

    fn new(all: Vec<Border>) -> Self {
        let middle = middle(&all);
        let is_oblique = |border: &Border| matches!(border.line, BorderLine::Oblique { .. });
        let first_oblique = all.iter().position(is_oblique).unwrap_or(all.len());
        Self {
            all,
            first_oblique,
            middle,
        }
    }

    pub fn all(&self) -> &[Border] {
        &self.all
    }

    pub fn has_oblique(&self) -> bool {
        self.first_oblique < self.all.len()
    }

    /// Where an edge with one end strictly inside border `idx` and one outside crosses it; `None` where that rounds to the inside end.
    #[inline]
    pub fn crossing<R: Real, V: Vertex>(
        &self,
        idx: usize,
        ends: [&V; 2],
        distances: [R; 2],
    ) -> Option<Crossing<V>> {
        let border = &self.all[idx];
        let is_leaving = distances[0].get() > 0.0;
        let ([inside, outside], along) = if is_leaving {
            (ends, distances)
        } else {
            ([ends[1], ends[0]], [distances[1], distances[0]])
        };
        let [p1, p2] = [inside.at(), outside.at()];
        let share = border.share([p1, p2], along);
        let at = match border.line {
            BorderLine::Upright { axis, c, .. } => upright_crossing([p1, p2], axis, c, &share),
            BorderLine::Oblique { .. } => {
                let [x, y] = [0, 1].map(|i| share.mean(p1.to_array()[i], p2.to_array()[i]));
                Point::from_finite(x, y)
            }
        };
        let at = if idx < self.first_oblique {
            at
        } else {
            self.settle(idx, at, p1)
        };
        unless_at_end([inside, outside], at, (&share, is_leaving))
    }

    /// Moves a crossing towards the middle of the region, by ulps and then twice as far each time, until it is inside this border and
    /// all before it. Of a region whose middle is not inside by its own distances, the inside end does.
    fn settle(&self, idx: usize, at: Point, inside: Point) -> Point {
        let is_inside = |p: Point| {
            let borders = &self.all[..=idx];
            borders.iter().all(|b| b.distance::<f64>(p) >= 0.0)
        };
        if is_inside(at) {
            return at;
        }
        let moved = |by: f64| {
            let [x, y] = [0, 1].map(|i| {
                let (from, to) = (at.to_array()[i], self.middle.to_array()[i]);
                let mean = from * (1.0 - by) + to * by;
                mean.clamp(from.min(to), from.max(to))
            });
            Point::from_finite(x, y)
        };
        let mut steps = (0..=53).rev().map(|k| moved(2f64.powi(-k)));
        steps.find(|&p| is_inside(p)).unwrap_or(inside)
    }
}

fn middle(borders: &[Border]) -> Point {
    let n = borders.len() as f64;
    let mean = |i: usize| borders.iter().map(|b| b.origin().to_array()[i] / n).sum();
    Point::from_finite(mean(0), mean(1))
}

/// Border `idx` of some, as what a clipper works against.
#[derive(Clone, Copy, Debug)]
pub struct NthBorder<'a> {
    pub borders: &'a Borders,
    pub idx: usize,
}

impl NthBorder<'_> {
    #[inline]
    pub fn border(&self) -> &Border {
        &self.borders.all[self.idx]
    }
}

impl<V: Vertex> Limit<V> for NthBorder<'_> {
    #[inline]
    fn distance<R: Real>(&self, vertex: &V) -> R {
        self.border().distance(vertex.at())
    }

    /// That of a vertex too far away is asked once more.
    #[inline]
    fn told(&self, vertex: &V, distance: f64) -> f64 {
        if distance.abs() < f64::MAX {
            distance
        } else {
            self.border().told_huge(vertex.at())
        }
    }

    #[inline]
    fn crossing<R: Real>(&self, ends: [&V; 2], distances: [R; 2]) -> Option<Crossing<V>> {
        self.borders.crossing(self.idx, ends, distances)
    }
}

/// A border along an axis, whose axis and side are known when a pass is compiled: where its coordinate is. In a region without oblique
/// ones.
#[derive(Clone, Copy, Debug)]
pub struct AlongAxis<const IS_Y: bool, const IS_MAX: bool>(pub f64);

impl<const IS_Y: bool, const IS_MAX: bool> AlongAxis<IS_Y, IS_MAX> {
    const AXIS: Axis = if IS_Y { Axis::Y } else { Axis::X };
}

impl<V: Vertex, const IS_Y: bool, const IS_MAX: bool> Limit<V> for AlongAxis<IS_Y, IS_MAX> {
    /// Infinite where it is too large: only its sign is asked for.
    #[inline]
    fn distance<R: Real>(&self, vertex: &V) -> R {
        upright_distance(Self::AXIS, IS_MAX, self.0, vertex.at())
    }

    #[inline]
    fn is_inside(&self, vertex: &V) -> bool {
        let [a, _] = split::<f64>(vertex.at(), Self::AXIS);
        if IS_MAX { a <= self.0 } else { a >= self.0 }
    }

    #[inline]
    fn crossing<R: Real>(&self, ends: [&V; 2], [d1, _]: [R; 2]) -> Option<Crossing<V>> {
        let is_leaving = d1.get() > 0.0;
        let pick = |a, b| select_unpredictable(is_leaving, a, b);
        let [inside, outside] = [pick(ends[0], ends[1]), pick(ends[1], ends[0])];
        let along = [inside.at(), outside.at()];
        let share = upright_share::<R>(along, Self::AXIS, IS_MAX, self.0);
        let at = upright_crossing(along, Self::AXIS, self.0, &share);
        unless_at_end([inside, outside], at, (&share, is_leaving))
    }
}
