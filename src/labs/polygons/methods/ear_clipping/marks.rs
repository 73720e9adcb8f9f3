//! What ear clipping draws.

use std::f64::consts::TAU;

use crate::algo::polygon::{
    Corner, EarClipping, EarClippingEvent as Event, Triangle, Triangulation,
};

use super::{
    super::{
        prelude::*,
        triangles::{cut_off_marks, points_of},
    },
    corner, is_done, vertex_link,
};

const FEW_ENOUGH: usize = 60;
const STEPS_OF_ARC: u32 = 32;

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

fn event_marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let held = step.held;
    let Some(corner) = corner(step) else {
        return Vec::new();
    };
    let candidate = |role| ear(&held.cut_off, corner, role).to_vec();
    match step.event() {
        Some(Event::Classify { .. }) => turn(held.cut_off.corners(corner)),
        Some(Event::Candidate { .. } | Event::Last { .. }) => candidate(Role::Signal),
        Some(Event::Blocked { by_idx, .. }) => {
            // Where it is no neighbour: an edge is there already.
            let [prev, _, next] = held.ring.corner(by_idx);
            let others = corner.into_iter().filter(|&i| i != prev && i != next);
            let lines = others.map(|corner| {
                let ends = [by_idx, corner].map(|i| held.cut_off.at(i).to_array());
                Mark::new(Role::Soft, Shape::Segment(ends)).dashed()
            });
            candidate(Role::Signal).into_iter().chain(lines).collect()
        }
        Some(Event::Ear { .. }) => candidate(Role::Accepted),
        Some(Event::Cut { .. }) => {
            let [from, _, to] = held.cut_off.corners(corner).map(Point::to_array);
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

/// Both edges at a vertex, the angle inside between them, and where the first was going.
fn turn([before, at, after]: [Point; 3]) -> Vec<Mark> {
    let length = |a: Point, b: Point| ((b.x() - a.x()).powi(2) + (b.y() - a.y()).powi(2)).sqrt();
    // Half as far as the edge that goes on, so that the two can be compared.
    let part = 0.5 * length(at, after) / length(before, at);
    let onwards = [Point::x, Point::y].map(|along| {
        let (from, to) = (along(before), along(at));
        to + part * (to - from)
    });
    let radius = 0.15 * length(at, after).min(length(before, at));
    let [before, at, after] = [before, at, after].map(Point::to_array);
    let signal = |shape| Mark::new(Role::Signal, shape);
    let towards = |to: [f64; 2]| libm::atan2(to[1] - at[1], to[0] - at[0]);
    // The inside is to the left of both edges.
    let inside = (towards(before) - towards(after)).rem_euclid(TAU);
    let arc = (0..=STEPS_OF_ARC).map(|i| {
        let turned = towards(after) + inside * f64::from(i) / f64::from(STEPS_OF_ARC);
        let (sin, cos) = libm::sincos(turned);
        [at[0] + radius * cos, at[1] + radius * sin]
    });
    let sector: Vec<[f64; 2]> = std::iter::once(at).chain(arc).collect();
    let degrees = sym(format!("{:.0}°", inside.to_degrees()));
    vec![
        Mark::new(Role::Soft, Shape::Segment([at, onwards])).dashed(),
        signal(Shape::Fill(vec![sector])).labelled(degrees),
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
        let at = held.cut_off.at(i).to_array();
        let is_convex = held.corners[i].is_none_or(|corner| corner == Corner::Convex);
        let is_left = !is_done(step.event()) && held.ring.contains(i);
        let mark = if this_step.contains(&i) {
            Mark::new(Role::Signal, Shape::dot_or_ring(is_convex, at))
        } else if is_convex || !is_left {
            let role = if is_left { Role::Ink } else { Role::Soft };
            Mark::new(role, Shape::Vertex(at))
        } else {
            Mark::new(Role::Ink, Shape::Ring(at))
        };
        mark.labelled(vertex_name(i)).linked(vertex_link(i))
    };
    shown.into_iter().map(mark).collect()
}
