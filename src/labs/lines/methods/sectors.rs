//! The sectors around the first end in Nicholl–Lee–Nicholl, each named by what becomes of a segment that
//! ends in it.
//!
//! The names are not worked out here: a probe, a segment to a point far away in the middle of the sector, is
//! given to the algorithm, and what it finds is the name.

use glam::DVec2;

use crate::{
    algo::line::{NichollLeeNicholl, NichollLeeNichollEvent as Event, WindowInput},
    figure::{Mark, Role, Shape},
    geom::{Edge, Point, Segment, Window},
    text::{Formula, Value},
    trace::Trace,
};

use super::shared::side_key;

/// A sector that is narrower than this part of the window, from its middle to its side, has no room for a name.
const NARROW: f64 = 0.3;

/// The rays from P₁ through the corners, and the names of the sectors between them.
pub fn marks(p1: Point, window: &Window) -> Vec<Mark> {
    let eye = DVec2::from(p1.to_array());
    let corners = in_order(eye, window);
    let mut marks: Vec<Mark> = corners
        .iter()
        .map(|c| Mark::new(Role::Faint, Shape::Ray([p1.to_array(), c.to_array()])))
        .collect();
    // Around a point inside the last sector closes the circle; outside, it is the one that looks away.
    let n_sectors = if window.contains(p1) {
        corners.len()
    } else {
        corners.len().saturating_sub(1)
    };
    let size = DVec2::from(window.max().to_array()) - DVec2::from(window.min().to_array());
    for i in 0..n_sectors {
        let [a, b] = [corners[i], corners[(i + 1) % corners.len()]].map(|c| c - eye);
        let along = a.normalize_or_zero() + b.normalize_or_zero();
        let Some(along) = along.try_normalize() else {
            continue;
        };
        let Some(name) = name(eye, eye + along * (10.0 * size.length()), window) else {
            continue;
        };
        let far = a.length().max(b.length()) + 0.15 * size.length();
        let place = eye + along * far;
        // A name that reached into the next sector would be that one's.
        let half_width = far * along.perp_dot(a.normalize_or_zero()).abs();
        let room = (0.2 * size.min_element()).min(0.5 * half_width);
        if half_width < NARROW * size.min_element() {
            continue;
        }
        let corners = [place - room, place + room].map(|p| p.to_array());
        marks.push(Mark::new(Role::Faint, Shape::Region(corners)).labelled(name));
    }
    marks
}

/// The corners as seen from a point, counter-clockwise; a corner at the point itself is left out.
fn in_order(eye: DVec2, window: &Window) -> Vec<DVec2> {
    let corners = window.corners().map(|c| DVec2::from(c.to_array()));
    let mut corners: Vec<DVec2> = corners.into_iter().filter(|&c| c != eye).collect();
    let inside = Point::new(eye.x, eye.y).is_ok_and(|p| window.contains(p));
    if !inside {
        // Seen from outside all lie within half a turn: the cross product orders them.
        corners.sort_by(|&a, &b| 0.0_f64.total_cmp(&(a - eye).perp_dot(b - eye)));
    }
    corners
}

/// What the algorithm finds for a segment into the sector: `left → top`.
fn name(eye: DVec2, far: DVec2, window: &Window) -> Option<Value> {
    let segment = Segment::new(eye.x, eye.y, far.x, far.y).ok()?;
    let input = WindowInput {
        window: *window,
        segment,
    };
    let run = Trace::<NichollLeeNicholl>::record(input);
    let sector = run.events().iter().find_map(|event| {
        if let Event::Sector { enters, leaves } = *event {
            Some((enters, leaves))
        } else {
            None
        }
    });
    let (enters, leaves) = sector?;
    let side = |formula: Formula, edge: Option<Edge>| match edge {
        Some(edge) => formula.term(side_key(edge)),
        None => formula,
    };
    let formula = side(Formula::default(), enters).sym(" → ");
    Some(Value::Formula(side(formula, leaves)))
}
