//! What ear clipping draws.

use crate::{
    algo::polygon::{
        Corner, EarClipping, EarClippingEvent as Event, EarClippingState as State, Triangle,
    },
    figure::{Mark, Role, Shape},
    geom::Point,
    labs::{
        Step,
        polygons::methods::triangles::{cut_off_marks, points_of, vertex_mark},
        words::vertex_name,
    },
};

use super::vertex_link;

/// Up to this number of vertices each has its mark.
const FEW_ENOUGH: usize = 60;

/// The drawing.
pub fn marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let state = step.state;
    let mut marks = cut_off_marks(&state.cut_off);
    if !state.is_done && state.ring.len() > 2 {
        let left = state.ring.iter().map(|i| state.cut_off.at(i).to_array());
        marks.push(Mark::new(Role::Accent, Shape::Outline(left.collect())));
    }
    marks.extend(event_marks(step));
    marks.extend(vertex_marks(step));
    marks
}

/// What this step is about.
fn event_marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let state = step.state;
    let candidate = |role| {
        let corner = state.candidate.into_iter();
        corner.flat_map(|corner| ear(state, corner, role)).collect()
    };
    match step.event {
        Some(Event::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            ..
        }) => turn([prev_idx, vertex_idx, next_idx].map(|i| state.cut_off.at(i))),
        Some(Event::Candidate { .. } | Event::Last { .. }) => candidate(Role::Signal),
        Some(Event::Blocked { by_idx, .. }) => {
            let mut marks: Vec<Mark> = candidate(Role::Signal);
            // Where it is no neighbour: an edge is there already.
            let [prev, _, next] = state.ring.corner(by_idx);
            let corners = state.candidate.into_iter().flatten();
            let others = corners.filter(|&corner| corner != prev && corner != next);
            marks.extend(others.map(|corner| {
                let ends = [by_idx, corner].map(|i| state.cut_off.at(i).to_array());
                Mark::new(Role::Soft, Shape::Segment(ends)).dashed()
            }));
            marks
        }
        Some(Event::Ear { .. }) => candidate(Role::Accepted),
        Some(Event::Cut { triangle, .. }) => {
            let [from, _, to] = state.cut_off.corners(triangle).map(Point::to_array);
            vec![Mark::new(Role::Signal, Shape::Segment([from, to]))]
        }
        Some(Event::Round { .. } | Event::Pass { .. } | Event::Done { .. }) | None => Vec::new(),
    }
}

/// The triangle of a corner: its diagonal dashed, as it is no edge yet.
fn ear(state: &State, corner: Triangle, role: Role) -> [Mark; 2] {
    let points = points_of(&state.cut_off, corner);
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
    let state = step.state;
    let this_step: Vec<usize> = match step.event {
        Some(
            Event::Classify { vertex_idx, .. }
            | Event::Pass { vertex_idx, .. }
            | Event::Ear { vertex_idx },
        ) => vec![vertex_idx],
        Some(Event::Blocked {
            vertex_idx, by_idx, ..
        }) => vec![vertex_idx, by_idx],
        Some(Event::Candidate { triangle }) => vec![triangle[1]],
        Some(Event::Round { .. } | Event::Cut { .. } | Event::Last { .. } | Event::Done { .. })
        | None => Vec::new(),
    };
    let cut_off = state.cut_off.triangles().iter().map(|triangle| triangle[1]);
    let shown: Vec<usize> = if state.corners.len() <= FEW_ENOUGH {
        let cut_off = cut_off.filter(|&i| !state.ring.contains(i));
        state.ring.iter().chain(cut_off).collect()
    } else {
        this_step.clone()
    };
    let mark = |i: usize| {
        let at = state.cut_off.at(i);
        let is_convex = state.corners[i].is_none_or(|corner| corner == Corner::Convex);
        let is_left = !state.is_done && state.ring.contains(i);
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
