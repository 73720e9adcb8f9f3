//! What the pointer is on: the link of the mark beneath it.

use egui::Pos2;

use crate::{
    figure::{Link, Mark, Shape},
    geom::Axis,
    paint::Viewport,
};

/// How near the pointer has to be to a line or a point, in points.
const REACH: f32 = 8.0;

/// The link of the topmost mark with one within reach of a place on the screen.
#[must_use]
pub fn link_at(viewport: &Viewport, marks: &[Mark], at: Pos2) -> Option<Link> {
    let hits = |mark: &&Mark| mark.link.is_some() && distance(viewport, &mark.shape, at) <= REACH;
    // Points are drawn over lines, and are harder to hit.
    let is_point =
        |mark: &&Mark| matches!(mark.shape, Shape::Dot(_) | Shape::Ring(_) | Shape::Cross(_));
    let topmost = || marks.iter().rev();
    topmost()
        .filter(is_point)
        .find(hits)
        .or_else(|| topmost().find(hits))
        .and_then(|mark| mark.link)
}

fn distance(viewport: &Viewport, shape: &Shape, at: Pos2) -> f32 {
    let screen = |p: [f64; 2]| viewport.to_screen(p);
    match shape {
        Shape::Segment([a, b])
        | Shape::Arrow([a, b])
        | Shape::Heading([a, b])
        | Shape::Ray([a, b])
        | Shape::Line([a, b])
        | Shape::HalfPlane([a, b]) => distance_to_segment(at, screen(*a), screen(*b)),
        Shape::Border(Axis::X, x) => (at.x - screen([*x, 0.0]).x).abs(),
        Shape::Border(Axis::Y, y) => (at.y - screen([0.0, *y]).y).abs(),
        Shape::Polygon(outline) | Shape::Outline(outline) => to_outline(viewport, outline, at),
        Shape::Area(outlines) => outlines
            .iter()
            .map(|outline| to_outline(viewport, outline, at))
            .fold(f32::INFINITY, f32::min),
        Shape::Path(points) => points
            .windows(2)
            .map(|ends| distance_to_segment(at, screen(ends[0]), screen(ends[1])))
            .fold(f32::INFINITY, f32::min),
        Shape::Dot(p) | Shape::Ring(p) | Shape::Cross(p) => screen(*p).distance(at),
        Shape::Region(_) | Shape::Crowd(_) | Shape::Textured(_) => f32::INFINITY,
    }
}

fn to_outline(viewport: &Viewport, outline: &[[f64; 2]], at: Pos2) -> f32 {
    let screen = |i: usize| viewport.to_screen(outline[i % outline.len()]);
    (0..outline.len())
        .map(|i| distance_to_segment(at, screen(i), screen(i + 1)))
        .fold(f32::INFINITY, f32::min)
}

/// Distance of a point from a segment, all on the screen.
#[must_use]
pub fn distance_to_segment(at: Pos2, a: Pos2, b: Pos2) -> f32 {
    let along = b - a;
    let length_sq = along.length_sq();
    let t = if length_sq > 0.0 {
        ((at - a).dot(along) / length_sq).clamp(0.0, 1.0)
    } else {
        0.0
    };
    at.distance(a + along * t)
}

#[cfg(test)]
mod tests {
    use egui::{Rect, pos2, vec2};

    use super::*;
    use crate::figure::Role;

    #[test]
    fn the_topmost_mark_within_reach_is_found() {
        let viewport = Viewport {
            rect: Rect::from_min_size(Pos2::ZERO, vec2(200.0, 200.0)),
            centre: [0.0; 2],
            scale: 10.0,
        };
        let marks = [
            Mark::new(Role::Accent, Shape::Dot([0.0, 0.0])).linked("point"),
            Mark::new(Role::Ink, Shape::Segment([[-5.0, 0.0], [5.0, 0.0]])).linked("line"),
            Mark::new(Role::Ink, Shape::Dot([2.0, 0.0])),
        ];
        let at = |x, y| link_at(&viewport, &marks, pos2(x, y));
        assert_eq!(at(103.0, 101.0), Some(Link::to("point")));
        assert_eq!(at(130.0, 95.0), Some(Link::to("line")));
        assert_eq!(at(130.0, 60.0), None);
        assert_eq!(at(165.0, 100.0), None, "past the end of the segment");
    }
}
