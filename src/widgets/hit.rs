//! What the pointer is on: the link of the mark beneath it.

use egui::Pos2;

use crate::{
    figure::{Link, Mark},
    paint::{Part, Viewport, parts},
};

/// How near the pointer has to be to a line or a point, in points.
const REACH: f32 = 8.0;

/// The link of the topmost mark with one within reach of a place on the screen.
#[must_use]
pub fn link_at(viewport: &Viewport, marks: &[Mark], at: Pos2) -> Option<Link> {
    let mut nearby = Vec::new();
    for mark in marks.iter().rev() {
        let Some(link) = mark.link else { continue };
        for part in parts(viewport, &mark.shape) {
            if distance(&part, at) <= REACH {
                nearby.push((matches!(part, Part::Marker(..)), link));
            }
        }
    }
    // Points are drawn over lines, and are harder to hit.
    let point = nearby.iter().find(|(is_point, _)| *is_point);
    point.or(nearby.first()).map(|&(_, link)| link)
}

fn distance(part: &Part<'_>, at: Pos2) -> f32 {
    let to_line = |points: &[Pos2]| {
        let edges = points.windows(2);
        edges
            .map(|ends| distance_to_segment(at, ends[0], ends[1]))
            .fold(f32::INFINITY, f32::min)
    };
    match part {
        Part::Stroke(points) => to_line(points),
        Part::Ring(points) => {
            let closing = [points.last().copied(), points.first().copied()];
            let closing: Vec<Pos2> = closing.into_iter().flatten().collect();
            to_line(points).min(to_line(&closing))
        }
        Part::Arrow(ends) | Part::Head(ends) => to_line(ends),
        Part::Marker(_, centre) => centre.distance(at),
        Part::Wash(_) | Part::Fill(_) | Part::Texture(_) | Part::Crowd(_) => f32::INFINITY,
    }
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
    use crate::figure::{Role, Shape};

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
