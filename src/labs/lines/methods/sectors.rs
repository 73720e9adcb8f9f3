//! The sectors around the first end in Nicholl–Lee–Nicholl, each named by what becomes of a segment that
//! ends in it.
//!
//! The names are not worked out here: a probe, a segment to a point far away in the middle of the sector, is
//! given to the algorithm, and what it finds is the name.

use glam::DVec2;

use crate::algo::line::{NichollLeeNicholl, NichollLeeNichollEvent as Event, Turn};

use super::{prelude::*, shared::side_key};

/// Half of the room that a sector's name wants, as a part of the window's smaller side; and the steps in which it may get
/// less.
const ROOM: DVec2 = DVec2::new(0.4, 0.1);
const N_ROOMS: u32 = 10;
const LEAST_ROOM: u32 = 4;
/// How far beyond the window's corners it may be, as parts of the window's diagonal.
const BEYOND: [f64; 4] = [0.05, 0.1, 0.15, 0.25];

pub fn marks(p1: Point, window: &Window) -> Vec<Mark> {
    let eye = DVec2::from(p1.to_array());
    let corners = in_order(eye, window);
    let mut marks: Vec<Mark> = corners
        .iter()
        .map(|c| Mark::new(Role::Faint, Shape::Ray([p1.to_array(), c.to_array()])))
        .collect();
    // Around a point inside the last sector closes the circle; outside, it is the one that looks away.
    let n_open = usize::from(!window.contains(p1));
    let n_sectors = corners.len().saturating_sub(n_open);
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
        let Some(corners) = room_for_name(eye, [a, b], along, window) else {
            continue;
        };
        let corners = corners.map(|p| p.to_array());
        marks.push(Mark::new(Role::Faint, Shape::Region(corners)).labelled(name));
    }
    marks
}

/// Where the name of the sector between two directions stands: beyond the window, the largest place that reaches
/// neither into the window nor into the next sector; of those as large the nearest.
fn room_for_name(
    eye: DVec2,
    [a, b]: [DVec2; 2],
    along: DVec2,
    window: &Window,
) -> Option<[DVec2; 2]> {
    let [min, max] = [window.min(), window.max()].map(|p| DVec2::from(p.to_array()));
    let size = max - min;
    let turn = a.perp_dot(b).signum();
    let is_in = |at: DVec2| {
        let seen = at - eye;
        turn * a.perp_dot(seen) >= 0.0 && turn * seen.perp_dot(b) >= 0.0
    };
    let mut best: Option<(u32, [DVec2; 2])> = None;
    for beyond in BEYOND {
        let place = eye + along * (a.length().max(b.length()) + beyond * size.length());
        let largest = (LEAST_ROOM..=N_ROOMS).rev().find_map(|i| {
            let room = ROOM * size.min_element() * f64::from(i) / f64::from(N_ROOMS);
            let [from, to] = [place - room, place + room];
            let upright = room * DVec2::new(1.0, -1.0);
            let is_sectors = [from, to, place + upright, place - upright].map(is_in) == [true; 4];
            let is_beyond = to.cmplt(min).any() || from.cmpgt(max).any();
            (is_sectors && is_beyond).then_some((i, [from, to]))
        });
        if largest.map(|(i, _)| i) > best.map(|(i, _)| i) {
            best = largest;
        }
    }
    best.map(|(_, corners)| corners)
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
    let window = *window;
    let run = Recording::<NichollLeeNicholl>::new(WindowInput { window, segment });
    let (enters, leaves) = run.events().iter().find_map(|event| match *event {
        Event::Sector { enters, leaves } => Some((enters, leaves)),
        _ => None,
    })?;
    let side = |formula: Formula, edge: Option<Edge>| match edge {
        Some(edge) => formula.term(side_key(edge)),
        None => formula,
    };
    let formula = side(Formula::default(), enters).sym(" → ");
    Some(Value::Formula(side(formula, leaves)))
}

pub const fn turn_key(turn: Turn) -> &'static str {
    match turn {
        Turn::Left => "turn-left",
        Turn::Through => "turn-through",
        Turn::Right => "turn-right",
    }
}
