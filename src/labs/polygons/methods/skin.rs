//! A texture on a clipped ring.

use serde::Serialize;

use crate::{
    algo::polygon::{Textured, faulty::KeepsUv},
    figure::Texel,
    labs::crossing_formulas::Weights,
};

use super::prelude::*;

/// Rings with more vertices than this are shown without their texture: to cut them into triangles takes time
/// that grows with the square.
const MOST: usize = 400;

pub trait LabVertex: Vertex + Serialize + Send + 'static {
    const IS_TEXTURED: bool = true;

    fn with_uv(at: Point, uv: [f64; 2]) -> Self;

    fn uv(&self) -> Option<[f64; 2]>;

    /// How a crossing came to its place in the texture:
    /// `uv(I) = (2 · (0, 0) + 6 · (1, 1/4)) / (6 − (−2)) = (3/4, 3/16)`.
    fn uv_formula(&self, [s, p]: [&NamedVertex<Self>; 2], weights: &Weights) -> Option<Formula> {
        let [uv, uv_s, uv_p] = [self.uv()?, s.vertex.uv()?, p.vertex.uv()?];
        Some(weights.mean_of_points("uv(I)", [uv_s, uv_p], uv))
    }
}

pub struct NamedVertex<V> {
    pub symbol: String,
    pub vertex: V,
}

impl LabVertex for Point {
    const IS_TEXTURED: bool = false;

    fn with_uv(at: Point, _: [f64; 2]) -> Self {
        at
    }

    fn uv(&self) -> Option<[f64; 2]> {
        None
    }
}

impl LabVertex for Textured {
    fn with_uv(at: Point, uv: [f64; 2]) -> Self {
        Self { at, uv }
    }

    fn uv(&self) -> Option<[f64; 2]> {
        Some(self.uv)
    }
}

impl LabVertex for KeepsUv {
    fn with_uv(at: Point, uv: [f64; 2]) -> Self {
        Self { at, uv }
    }

    fn uv(&self) -> Option<[f64; 2]> {
        Some(self.uv)
    }

    fn uv_formula(&self, ends: [&NamedVertex<Self>; 2], _: &Weights) -> Option<Formula> {
        let owner = ends.into_iter().find(|end| end.vertex.uv == self.uv)?;
        let formula = sym(format!("uv(I) = uv({}) = ", owner.symbol));
        Some(formula.point(self.uv))
    }
}

pub fn skin<V: LabVertex>(ring: &[V]) -> Option<Mark> {
    let texels = ring.iter().map(|v| Some((v.at().to_array(), v.uv()?)));
    let texels: Vec<Texel> = texels.collect::<Option<_>>()?;
    (3..=MOST).contains(&texels.len()).then(|| {
        let shape = Shape::Textured(triangles(texels));
        Mark::new(Role::Accent, shape).linked("texture")
    })
}

/// Cuts off one corner after the other: one that turns the ring's way, with no corner that turns against it inside
/// or on its border, where a bridge has them. Where the ring crosses itself none may be left: then the first that
/// turns.
fn triangles(mut ring: Vec<Texel>) -> Vec<[Texel; 3]> {
    if area(&ring) < 0.0 {
        ring.reverse();
    }
    let mut triangles = Vec::with_capacity(ring.len());
    while ring.len() >= 3 {
        let n = ring.len();
        let corner = |i: usize| [(i + n - 1) % n, i, (i + 1) % n].map(|k| ring[k]);
        let turns: Vec<f64> = (0..n).map(|i| area(&corner(i))).collect();
        let is_ear = |&i: &usize| {
            let ear = corner(i);
            let is_in_the_way = |k: usize| turns[k] < 0.0 && is_in(ring[k], &ear);
            turns[i] > 0.0 && !(0..n).any(is_in_the_way)
        };
        let Some(i) = (0..n)
            .find(|&i| turns[i] == 0.0)
            .or_else(|| (0..n).find(is_ear))
            .or_else(|| (0..n).find(|&i| turns[i] > 0.0))
        else {
            break;
        };
        if turns[i] > 0.0 {
            triangles.push(corner(i));
        }
        ring.remove(i);
    }
    triangles
}

/// In a counter-clockwise triangle or on its border, but not at one of its corners.
fn is_in(p: Texel, triangle: &[Texel; 3]) -> bool {
    triangle.iter().all(|corner| corner.0 != p.0)
        && (0..3).all(|i| area(&[triangle[i], triangle[(i + 1) % 3], p]) >= 0.0)
}

/// Twice the signed area.
fn area(ring: &[Texel]) -> f64 {
    let n = ring.len();
    let [x0, y0] = ring[0].0;
    let cross = |i: usize| {
        let [[x1, y1], [x2, y2]] = [ring[i].0, ring[(i + 1) % n].0];
        (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    };
    (0..n).map(cross).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texels(outline: &[[f64; 2]]) -> Vec<Texel> {
        outline.iter().map(|&p| (p, p)).collect()
    }

    #[test]
    fn triangles_fill_the_ring_bridges_and_all() {
        let cases: [&[[f64; 2]]; 5] = [
            &[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]],
            &[[0.0, 2.0], [2.0, 2.0], [2.0, 0.0], [0.0, 0.0]],
            &[[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [0.0, 4.0]],
            // Two legs on one base line, joined by a bridge: begun at either end of it.
            &[
                [0.0, 0.0],
                [5.0, 0.0],
                [5.0, 2.0],
                [4.0, 2.0],
                [3.0, 0.0],
                [2.0, 0.0],
                [1.0, 2.0],
                [0.0, 2.0],
            ],
            &[
                [0.75, -1.0],
                [0.75, 0.5],
                [0.25, 0.25],
                [1.0 / 14.0, -1.0],
                [-1.0 / 14.0, -1.0],
                [-0.25, 0.25],
                [-0.5, 0.25],
                [-0.5, -1.0],
            ],
        ];
        for outline in cases {
            let ring = texels(outline);
            let triangles = triangles(ring.clone());
            let sum: f64 = triangles.iter().map(|t| area(t)).sum();
            assert!(
                (sum - area(&ring).abs()).abs() < 1e-12,
                "{outline:?}: {sum}"
            );
            for [a, b, c] in triangles {
                let middle = [0, 1].map(|i| (a.0[i] + b.0[i] + c.0[i]) / 3.0);
                assert!(winds_around(&ring, middle), "{middle:?} is in {outline:?}");
            }
        }
    }

    fn winds_around(ring: &[Texel], p: [f64; 2]) -> bool {
        let n = ring.len();
        let crossings = (0..n).filter(|&i| {
            let ([x1, y1], [x2, y2]) = (ring[i].0, ring[(i + 1) % n].0);
            (y1 > p[1]) != (y2 > p[1]) && p[0] < x1 + (p[1] - y1) / (y2 - y1) * (x2 - x1)
        });
        crossings.count() % 2 == 1
    }
}
