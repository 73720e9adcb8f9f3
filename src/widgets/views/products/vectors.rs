//! Two vectors from one point, and the foot of the perpendicular from the one to the other.

use crate::figure::{Product, Vector};

use super::super::prelude::*;

const MARGIN: Vec2 = vec2(20.0, 18.0);
const NAME_SIZE: f32 = 13.0;
/// How much longer than the others a normal may be drawn, and how much shorter; it is only drawn in proportion to
/// them between these.
const NORMAL: [f64; 2] = [0.3, 1.0];
/// A vector that would be drawn shorter than this part of its drawing is drawn larger.
const LEAST_PART: f32 = 0.45;
const BEYOND: f32 = 12.0;

struct Figure {
    onto: [f64; 2],
    of: [f64; 2],
    foot: [f64; 2],
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

impl Figure {
    /// With the normal as long as it may be, where the longest of the vectors that are projected is `longest`.
    fn of(product: &Product, longest: f64) -> Self {
        let (n, of) = (product.onto.to, product.of.to);
        let n_length = length(n);
        let unit = n.map(|x| if n_length > 0.0 { x / n_length } else { 0.0 });
        let along = unit[0] * of[0] + unit[1] * of[1];
        let drawn = if longest > 0.0 {
            n_length.clamp(NORMAL[0] * longest, NORMAL[1] * longest)
        } else {
            n_length
        };
        Self {
            onto: unit.map(|x| x * drawn),
            of,
            foot: unit.map(|x| x * along),
        }
    }

    fn extent(&self) -> [[f64; 2]; 2] {
        let ends = [self.onto, self.of, self.foot];
        let axis = |i: usize| {
            let values = ends.iter().map(|end| end[i]);
            let low = values.clone().fold(0.0, f64::min);
            [low, values.fold(0.0, f64::max)]
        };
        let [x, y] = [axis(0), axis(1)];
        [[x[0], y[0]], [x[1], y[1]]]
    }

    fn scale(&self, room: Vec2) -> f64 {
        let [low, high] = self.extent();
        let fit = |i: usize, room: f32| f64::from(room) / (high[i] - low[i]).max(1e-12);
        fit(0, room.x).min(fit(1, room.y))
    }
}

/// The scale, and the longest vector: the same for all products, so that lengths can be compared.
pub fn common_scale(slate: &Slate<'_>, products: &[Product], drawing: Vec2) -> (f64, f64) {
    let lengths = products.iter().map(|product| length(product.of.to));
    let longest = lengths.fold(0.0, f64::max);
    let room = drawing - 2.0 * MARGIN * slate.scale;
    let figures = products.iter().map(|product| Figure::of(product, longest));
    let scales = figures.map(|figure| figure.scale(room));
    (scales.fold(f64::INFINITY, f64::min), longest)
}

pub fn draw(slate: &mut Slate<'_>, place: Rect, product: &Product, (common, longest): (f64, f64)) {
    let theme = slate.theme();
    let figure = Figure::of(product, longest);
    let room = place.size() - 2.0 * MARGIN * slate.scale;
    let scale = common.max(f64::from(LEAST_PART) * figure.scale(room));
    let [low, high] = figure.extent();
    let middle = [0, 1].map(|i| 0.5 * (low[i] + high[i]));
    let at = |p: [f64; 2]| {
        let [x, y] = [0, 1].map(|i| ((p[i] - middle[i]) * scale) as f32);
        place.center() + vec2(x, -y)
    };
    let [origin, onto, of, foot] = [[0.0; 2], figure.onto, figure.of, figure.foot].map(at);
    through(slate, [origin, onto, foot]);
    if of.distance(foot) > slate.pts(4.0) {
        if foot.distance(origin) > slate.pts(3.0) {
            let stroke = slate.stroke(1.0, theme.soft);
            slate.dashed([of, foot], stroke, 3.0);
        } else {
            // The product is 0: the vectors stand at a right angle.
            let side = slate.pts(8.0);
            let [a, b] = [onto, of].map(|tip| (tip - origin).normalized() * side);
            let stroke = slate.stroke(1.0, theme.ink);
            slate.line([origin + a, origin + a + b], stroke);
            slate.line([origin + b, origin + a + b], stroke);
        }
    }
    for (vector, tip) in [(&product.of, of), (&product.onto, onto)] {
        let stroke = slate.stroke(2.25, colour(theme, vector.role));
        if tip.distance(origin) > 1.0 {
            slate.arrow([origin, tip], stroke);
        }
    }
    for dot in [origin, foot] {
        let (r, rim) = (slate.pts(2.75), slate.stroke(0.75, theme.background));
        slate.painter.circle(dot, r, theme.ink, rim);
    }
    for (vector, tip, other) in [(&product.onto, onto, of), (&product.of, of, onto)] {
        name(slate, place, vector, [origin, tip, other]);
    }
}

fn through(slate: &mut Slate<'_>, [origin, onto, foot]: [Pos2; 3]) {
    let along = (onto - origin).normalized();
    let places = [origin, onto, foot].map(|at| (at - origin).dot(along));
    let from = places.into_iter().fold(f32::INFINITY, f32::min) - slate.pts(BEYOND);
    let to = places.into_iter().fold(f32::NEG_INFINITY, f32::max) + slate.pts(BEYOND);
    let stroke = slate.stroke(1.0, slate.theme().discarded);
    slate.line([from, to].map(|t| origin + along * t), stroke);
}

fn name(slate: &mut Slate<'_>, place: Rect, vector: &Vector, [origin, tip, other]: [Pos2; 3]) {
    let ink = text_colour(slate.theme(), vector.role);
    let name = slate.value(&vector.name, (Face::Strong, NAME_SIZE, ink));
    let half = 0.5 * name.size();
    let mut along = (tip - origin).normalized();
    if along == Vec2::ZERO {
        along = vec2(0.0, -1.0);
    }
    let mut away = along.rot90();
    if away.dot(other - origin) > 0.0 {
        away = -away;
    }
    let middle = origin + 0.6 * (tip - origin);
    let sides = [
        (tip, away),
        (tip, along + away),
        (tip, along),
        (middle, away),
        (tip, along - away),
        (middle, -away),
        (tip, -away),
    ];
    let centres = [5.0, 9.0, 14.0].into_iter().flat_map(|gap| {
        let gap = slate.pts(gap);
        sides.map(|(from, side)| {
            let side = side.normalized();
            let reach = side.x.abs() * half.x + side.y.abs() * half.y + gap;
            from + side * reach
        })
    });
    let centres: Vec<Pos2> = centres.collect();
    let room = place.expand(slate.pts(8.0));
    if slate.put_free(&name, room, centres).is_none() {
        // A drawing without names says nothing: over a line it is still read.
        let at = tip + along * half.length();
        slate.put(&name, at, Align2::CENTER_CENTER);
    }
}
