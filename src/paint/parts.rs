//! What a shape comes to on the screen: the painter, the labels and the pointer all ask here.

use egui::{Pos2, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{Shape, Solids, Texel},
    geom::Axis,
};

use super::{
    Viewport,
    hatch::{self, hatched},
};

pub const HEAD: f32 = 9.0;

const ARC_RADIUS: f32 = 32.0;
const SQUARE_SIDE: f32 = 9.0;
/// Directions along an arc that two neighbouring points of it have between them, at most.
const ARC_STEP_RAD: f32 = 0.1;
const LEAST_HEADED: f32 = 27.0;

#[derive(Clone, PartialEq, Debug)]
pub enum Part<'a> {
    Wash(Vec<Pos2>),
    /// What an odd number of outlines goes round, in world coordinates.
    Fill(&'a [Vec<[f64; 2]>]),
    Solids(&'a Solids),
    Texture(&'a [[Texel; 3]]),
    Crowd(&'a [[[f64; 2]; 2]]),
    Stroke(Vec<Pos2>),
    Ring(Vec<Pos2>),
    Arrow([Pos2; 2]),
    Head([Pos2; 2]),
    Marker(Marker, Pos2),
}

impl Part<'_> {
    /// Its points, where it is a line from point to point, and whether it leads back to the first.
    pub fn line(&self) -> Option<(&[Pos2], bool)> {
        match self {
            Self::Stroke(points) => Some((points, false)),
            Self::Ring(points) => Some((points, true)),
            Self::Arrow(ends) => Some((ends, false)),
            Self::Wash(_)
            | Self::Fill(_)
            | Self::Solids(_)
            | Self::Texture(_)
            | Self::Crowd(_)
            | Self::Head(_)
            | Self::Marker(..) => None,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Marker {
    Dot,
    Vertex,
    Circle,
    Cross,
    Bound(Vec2),
}

/// The parts of a shape, those that lie under others first. Lines without ends reach beyond the stage.
pub fn parts<'a>(viewport: &Viewport, shape: &'a Shape) -> Vec<Part<'a>> {
    let at = |p: &[f64; 2]| viewport.to_screen(*p);
    let all = |points: &[[f64; 2]]| viewport.all_to_screen(points);
    let endless = |a: Pos2, b: Pos2| {
        let reach = reach(viewport.rect, a, b);
        Part::Stroke(vec![a - reach, b + reach])
    };
    match shape {
        Shape::Segment(ends) => vec![Part::Stroke(all(ends))],
        Shape::Arrow([a, b]) => vec![Part::Arrow([at(a), at(b)])],
        Shape::Heading([a, b]) => heading(at(a), at(b)).into_iter().collect(),
        Shape::Border(axis, c) => vec![Part::Stroke(border(viewport, *axis, *c).to_vec())],
        Shape::Line([a, b]) => vec![endless(at(a), at(b))],
        Shape::Ray([a, b]) => {
            let end = at(b) + reach(viewport.rect, at(a), at(b));
            vec![Part::Stroke(vec![at(a), end])]
        }
        Shape::Area(outlines) => {
            let rings = outlines.iter().map(|outline| Part::Ring(all(outline)));
            std::iter::once(Part::Fill(outlines)).chain(rings).collect()
        }
        Shape::Fill(outlines) => vec![Part::Fill(outlines)],
        Shape::Hatch(outlines) => {
            let outlines: Vec<_> = outlines.iter().map(|outline| all(outline)).collect();
            let strokes = hatched(&outlines, viewport.rect, hatch::GAP).into_iter();
            strokes.map(|ends| Part::Stroke(ends.to_vec())).collect()
        }
        Shape::Outline(outline) => vec![Part::Ring(all(outline))],
        Shape::Path(points) => vec![Part::Stroke(all(points))],
        Shape::HalfPlane([a, b]) => {
            let wash = wash(viewport.rect, at(a), at(b));
            vec![wash, endless(at(a), at(b))]
        }
        Shape::Wash([a, b]) => vec![wash(viewport.rect, at(a), at(b))],
        Shape::Textured(triangles) => vec![Part::Texture(triangles)],
        Shape::Dot(p) => vec![Part::Marker(Marker::Dot, at(p))],
        Shape::Vertex(p) => vec![Part::Marker(Marker::Vertex, at(p))],
        Shape::Ring(p) => vec![Part::Marker(Marker::Circle, at(p))],
        Shape::Cross(p) => vec![Part::Marker(Marker::Cross, at(p))],
        Shape::Bound([a, b]) => {
            let along = (at(b) - at(a)).normalized();
            vec![Part::Marker(Marker::Bound(along), at(a))]
        }
        Shape::Angle([apex, a, b]) => vec![Part::Stroke(arc(at(apex), at(a), at(b)))],
        Shape::RightAngle([apex, a, b]) => {
            let [a, b] = [a, b].map(|p| (at(p) - at(apex)).normalized() * SQUARE_SIDE);
            let apex = at(apex);
            vec![Part::Stroke(vec![apex + a, apex + a + b, apex + b])]
        }
        Shape::Crowd(segments) => vec![Part::Crowd(segments)],
        Shape::Solids(solids) => vec![Part::Solids(solids)],
        Shape::Region(_) | Shape::Label(_) => Vec::new(),
    }
}

pub fn visible(viewport: &Viewport, [a, b]: [[f64; 2]; 2]) -> Rect {
    let rect = viewport.rect;
    let along = |i: usize, value: f64, min: f32, max: f32| {
        if value == f64::NEG_INFINITY {
            if i == 0 { min } else { max }
        } else if value == f64::INFINITY {
            if i == 0 { max } else { min }
        } else {
            let at = viewport.to_screen([value, value]);
            let on_screen = if i == 0 { at.x } else { at.y };
            on_screen.clamp(min, max)
        }
    };
    let x = [a[0], b[0]].map(|v| along(0, v, rect.left(), rect.right()));
    let y = [b[1], a[1]].map(|v| along(1, v, rect.top(), rect.bottom()));
    Rect::from_min_max(pos2(x[0], y[0]), pos2(x[1], y[1]))
}

fn border(viewport: &Viewport, axis: Axis, c: f64) -> [Pos2; 2] {
    let (rect, at) = (viewport.rect, viewport.to_screen([c, c]));
    match axis {
        Axis::X => [pos2(at.x, rect.top()), pos2(at.x, rect.bottom())],
        Axis::Y => [pos2(rect.left(), at.y), pos2(rect.right(), at.y)],
    }
}

fn reach(stage: Rect, a: Pos2, b: Pos2) -> Vec2 {
    let size = stage.size();
    (b - a).normalized() * (size.x + size.y + (b - a).length())
}

/// To the left of a → b as it is seen; the screen's y points down.
fn wash<'a>(stage: Rect, a: Pos2, b: Pos2) -> Part<'a> {
    let along = reach(stage, a, b);
    let left = vec2(along.y, -along.x);
    let [start, end] = [a - along, b + along];
    Part::Wash(vec![start, end, end + left, start + left])
}

fn heading<'a>(a: Pos2, b: Pos2) -> Option<Part<'a>> {
    (a.distance(b) > LEAST_HEADED).then(|| {
        let half = (b - a).normalized() * HEAD / 2.0;
        Part::Head([a, a.lerp(b, 0.5) + half])
    })
}

fn arc(apex: Pos2, a: Pos2, b: Pos2) -> Vec<Pos2> {
    let from = (a - apex).angle();
    let turn = (b - apex).angle() - from;
    let turn = turn - std::f32::consts::TAU * (turn / std::f32::consts::TAU).round();
    let n = (turn.abs() / ARC_STEP_RAD).ceil().max(1.0);
    (0..=n as usize)
        .map(|i| apex + Vec2::angled(from + turn * i as f32 / n) * ARC_RADIUS)
        .collect()
}
