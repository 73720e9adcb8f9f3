//! Corners and sides of a window, and the window itself, as handles of the labs that have one.

use crate::{
    geom::{Edge, GeomError, Point, Window},
    text::{Message, Value},
};

use super::{
    Handle, HandleKind, Motion,
    words::{edge_key, edge_link},
};

pub const GROUP: &str = "window";

static CORNER: HandleKind = HandleKind::new("corner", GROUP, |[i, _]| Message::new(CORNER_KEYS[i]));
static SIDE: HandleKind = HandleKind {
    motion: Motion::Axis([1.0, 0.0, 0.0]),
    link: Some(|[i, _]| edge_link(Edge::ALL[i])),
    ..HandleKind::new("side", GROUP, |[i, _]| {
        Message::new("handle-side").with("edge", Value::Term(edge_key(Edge::ALL[i])))
    })
};
/// The same of the lower and the upper side.
static LEVEL_SIDE: HandleKind = HandleKind {
    motion: Motion::Axis([0.0, 1.0, 0.0]),
    link: SIDE.link,
    ..HandleKind::new(SIDE.id, GROUP, SIDE.name)
};
static WINDOW: HandleKind = HandleKind {
    is_whole: true,
    ..HandleKind::new("window", GROUP, |_| Message::new("handle-window"))
};

/// A vertex of the polygon that clips in the window's place.
pub static CLIP_VERTEX: HandleKind = HandleKind {
    is_vertex: true,
    ..HandleKind::new("clip-vertex", "clip", |[i, _]| {
        Message::new("handle-clip-vertex").with("number", i + 1)
    })
};

const CORNER_KEYS: [&str; 4] = [
    "handle-corner-bottom-left",
    "handle-corner-bottom-right",
    "handle-corner-top-right",
    "handle-corner-top-left",
];

/// Which sides a handle moves: left, right, bottom, top.
type Moves = [bool; 4];

/// In the order in which Tab visits them.
pub fn handles() -> impl Iterator<Item = Handle> {
    let of = |kind: &'static HandleKind, n| (0..n).map(move |i| kind.at([i, 0]));
    let sides = Edge::ALL.iter().enumerate().map(|(i, edge)| match edge {
        Edge::Left | Edge::Right => SIDE.at([i, 0]),
        Edge::Bottom | Edge::Top => LEVEL_SIDE.at([i, 0]),
    });
    of(&CORNER, CORNER_KEYS.len())
        .chain(sides)
        .chain(of(&WINDOW, 1))
}

fn moves(handle: Handle) -> Option<Moves> {
    let [i, _] = handle.idx();
    if handle.is(&CORNER) {
        let (right, top) = (i == 1 || i == 2, i >= 2);
        Some([!right, right, !top, top])
    } else if handle.is(&SIDE) {
        let edge = Edge::ALL[i];
        let sides = [Edge::Left, Edge::Right, Edge::Bottom, Edge::Top];
        Some(sides.map(|side| side == edge))
    } else {
        handle.is(&WINDOW).then_some([true; 4])
    }
}

pub fn position(handle: Handle, window: &Window) -> Option<[f64; 3]> {
    let (min, max) = (window.min().to_array(), window.max().to_array());
    let centre = [0, 1].map(|i| min[i].midpoint(max[i]));
    let [left, right, bottom, top] = moves(handle)?;
    if handle.is(&WINDOW) {
        // Not in the middle, where segments like to have theirs: below it and to the right.
        return Some([centre[0].midpoint(max[0]), min[1].midpoint(centre[1]), 0.0]);
    }
    let along = |i: usize, low: bool, high: bool| match (low, high) {
        (true, _) => min[i],
        (false, true) => max[i],
        (false, false) => centre[i],
    };
    Some([along(0, left, right), along(1, bottom, top), 0.0])
}

/// The window after a handle has gone to `to`; as it is where the handle is not the window's.
pub fn dragged(handle: Handle, window: &Window, to: Point) -> Result<Window, GeomError> {
    let (Some([x, y, _]), Some([left, right, bottom, top])) =
        (position(handle, window), moves(handle))
    else {
        return Ok(*window);
    };
    let [mut xmin, mut ymin, mut xmax, mut ymax] = window.to_array();
    let [dx, dy] = [to.x() - x, to.y() - y];
    for (moves, side, by) in [
        (left, &mut xmin, dx),
        (right, &mut xmax, dx),
        (bottom, &mut ymin, dy),
        (top, &mut ymax, dy),
    ] {
        if moves {
            *side += by;
        }
    }
    Window::new(xmin, ymin, xmax, ymax)
}
