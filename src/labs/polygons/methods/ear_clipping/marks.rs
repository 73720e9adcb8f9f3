//! What ear clipping draws.

use crate::{
    algo::polygon::{Corner, EarClipping, EarClippingEvent as Event, Triangle, Triangulation},
    figure::{Mark, Role, Shape},
    geom::Point,
    labs::{
        polygons::methods::triangles::{cut_off_marks, points_of, vertex_mark},
        words::vertex_name,
    },
    trace::Step,
};

use super::{corner, is_done, vertex_link};

/// Up to this number of vertices each has its mark.
const FEW_ENOUGH: usize = 60;

/// The drawing.
pub fn marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let held = step.held;
    let mut marks = cut_off_marks(&held.cut_off);
    if !is_done(step.event()) {
        let left = held.ring.iter().map(|i| held.cut_off.at(i).to_array());
        marks.push(Mark::new(Role::Accent, Shape::Outline(left.collect())));
    }
    marks.extend(event_marks(step));
    marks.extend(vertex_marks(step));
    marks
}

/// What this step is about.
fn event_marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let held = step.held;
    let candidate = |role| {
        let corner = corner(step).into_iter();
        corner
            .flat_map(|corner| ear(&held.cut_off, corner, role))
            .collect()
    };
    match step.event() {
        Some(Event::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            ..
        }) => turn([prev_idx, vertex_idx, next_idx].map(|i| held.cut_off.at(i))),
        Some(Event::Candidate { .. } | Event::Last { .. }) => candidate(Role::Signal),
        Some(Event::Blocked { by_idx, .. }) => {
            let mut marks: Vec<Mark> = candidate(Role::Signal);
            // Where it is no neighbour: an edge is there already.
            let [prev, _, next] = held.ring.corner(by_idx);
            let corners = corner(step).into_iter().flatten();
            let others = corners.filter(|&corner| corner != prev && corner != next);
            marks.extend(others.map(|corner| {
                let ends = [by_idx, corner].map(|i| held.cut_off.at(i).to_array());
                Mark::new(Role::Soft, Shape::Segment(ends)).dashed()
            }));
            marks
        }
        Some(Event::Ear { .. }) => candidate(Role::Accepted),
        Some(Event::Cut { triangle, .. }) => {
            let [from, _, to] = held.cut_off.corners(triangle).map(Point::to_array);
            vec![Mark::new(Role::Signal, Shape::Segment([from, to]))]
        }
        Some(Event::Round { .. } | Event::Pass { .. } | Event::Done { .. }) | None => Vec::new(),
    }
}

/// The triangle of a corner: its diagonal dashed, as it is no edge yet.
fn ear(whole: &Triangulation, corner: Triangle, role: Role) -> [Mark; 2] {
    let points = points_of(whole, corner);
    [
        Mark::new(role, Shape::Area(vec![points.clone()])).dashed(),
        Mark::new(role, Shape::Path(points)),
    ]
}

/// Both edges at a vertex, and how far the second turns away from where the first was going.
fn turn([before, at, after]: [Point; 3]) -> Vec<Mark> {
    let length = |a: Point, b: Point| ((b.x() - a.x()).powi(2) + (b.y() - a.y()).powi(2)).sqrt();
    // Half as far as the edge that goes on, so that the two can be compared.
    let part = 0.5 * length(at, after) / length(before, at);
    let onwards = [Point::x, Point::y].map(|along| {
        let (from, to) = (along(before), along(at));
        to + part * (to - from)
    });
    let [before, at, after] = [before, at, after].map(Point::to_array);
    let signal = |shape| Mark::new(Role::Signal, shape);
    vec![
        Mark::new(Role::Soft, Shape::Segment([at, onwards])).dashed(),
        signal(Shape::Angle([at, onwards, after])),
        signal(Shape::Segment([before, at])),
        signal(Shape::Segment([at, after])),
        signal(Shape::Heading([before, at])),
        signal(Shape::Heading([at, after])),
    ]
}

/// A dot for a convex vertex, small where nothing happens to it, a ring for any other, grey where it has been cut off.
/// Where there are many only this step's have one.
fn vertex_marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let held = step.held;
    let asked = corner(step).filter(|_| !super::cuts(step.event()));
    let mut this_step: Vec<usize> = asked.map(|[_, tip, _]| tip).into_iter().collect();
    if let Some(Event::Blocked { by_idx, .. }) = step.event() {
        this_step.push(by_idx);
    }
    let cut_off = held.cut_off.triangles().iter().map(|triangle| triangle[1]);
    let shown: Vec<usize> = if held.corners.len() <= FEW_ENOUGH {
        let cut_off = cut_off.filter(|&i| !held.ring.contains(i));
        held.ring.iter().chain(cut_off).collect()
    } else {
        this_step.clone()
    };
    let mark = |i: usize| {
        let at = held.cut_off.at(i);
        let is_convex = held.corners[i].is_none_or(|corner| corner == Corner::Convex);
        let is_left = !is_done(step.event()) && held.ring.contains(i);
        let mark = if this_step.contains(&i) {
            vertex_mark(Role::Signal, is_convex, at)
        } else if is_convex || !is_left {
            let role = if is_left { Role::Ink } else { Role::Soft };
            Mark::new(role, Shape::Vertex(at.to_array()))
        } else {
            vertex_mark(Role::Ink, false, at)
        };
        mark.labelled(vertex_name(i)).linked(vertex_link(i))
    };
    shown.into_iter().map(mark).collect()
}
