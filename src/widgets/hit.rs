//! What the pointer is on: the link of the mark beneath it.

use crate::{
    figure::{Mark, Shape},
    geom::distance_to_segment,
    paint::{Part, parts},
};

use super::prelude::{Link, Pos2, Viewport};

/// Of a pointer.
pub const REACH: f32 = 8.0;

/// The link of the topmost mark with one within reach of a place on the screen; else of the face of a solid there.
pub fn link_at(viewport: &Viewport, marks: &[Mark], at: Pos2, reach: f32) -> Option<Link> {
    links_at(viewport, marks, at, reach).next()
}

/// The links of all that is there, the topmost first.
pub fn links_at(
    viewport: &Viewport,
    marks: &[Mark],
    at: Pos2,
    reach: f32,
) -> impl Iterator<Item = Link> {
    let mut nearby = Vec::new();
    for mark in marks.iter().rev() {
        let Some(link) = mark.link else { continue };
        for part in parts(viewport, &mark.shape) {
            if distance(&part, at) <= reach {
                nearby.push((matches!(part, Part::Marker(..)), link));
            }
        }
    }
    // Points are drawn over lines, and are harder to hit.
    nearby.sort_by_key(|(is_point, _)| !is_point);
    let place = viewport.to_world(at);
    let shapes = marks.iter().rev().map(|mark| &mark.shape);
    let faces = shapes.filter_map(move |shape| match shape {
        Shape::Solids(solids) => solids.link_at(place),
        _ => None,
    });
    nearby.into_iter().map(|(_, link)| link).chain(faces)
}

fn distance(part: &Part<'_>, at: Pos2) -> f32 {
    let place = |at: Pos2| [at.x, at.y].map(f64::from);
    let to_edge = |a, b| distance_to_segment(place(at), [place(a), place(b)]) as f32;
    let to_line = |points: &[Pos2]| {
        let edges = points.windows(2).map(|ends| to_edge(ends[0], ends[1]));
        edges.fold(f32::INFINITY, f32::min)
    };
    match (part, part.line()) {
        (Part::Marker(_, centre), _) => centre.distance(at),
        (Part::Head(ends), _) => to_line(ends),
        (_, Some((points, is_closed))) => {
            let closing = points.last().zip(points.first()).filter(|_| is_closed);
            let closing = closing.map_or(f32::INFINITY, |(&last, &first)| to_edge(last, first));
            to_line(points).min(closing)
        }
        (_, None) => f32::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;
    use crate::figure::Role;

    #[test]
    fn the_topmost_mark_within_reach_is_found() {
        let marks = [
            Mark::new(Role::Accent, Shape::Dot([0.0, 0.0])).linked("point"),
            Mark::new(Role::Ink, Shape::Segment([[-5.0, 0.0], [5.0, 0.0]])).linked("line"),
            Mark::new(Role::Ink, Shape::Dot([2.0, 0.0])),
        ];
        let at = |x, y| link_at(&Viewport::SQUARE, &marks, pos2(x, y), REACH);
        assert_eq!(at(103.0, 101.0), Some(Link::to("point")));
        assert_eq!(at(130.0, 95.0), Some(Link::to("line")));
        assert_eq!(at(130.0, 60.0), None);
        assert_eq!(at(165.0, 100.0), None, "past the end of the segment");
    }
}
