//! The lab's handles as a canvas needs them: places and names.

use crate::{
    algo::line::End,
    geom::Edge,
    labs::lines::{Corner, Handle, Lock, Scene},
    text::{Message, Value},
    widgets::{Look, Snap, Spot},
};

/// One spot for each of `handles`, in their order.
#[must_use]
pub fn spots(look: Look<'_>, scene: &Scene, handles: &[Handle], locks: &[Lock]) -> Vec<Spot> {
    let spot = |&handle: &Handle| Spot {
        at: handle.position(scene),
        name: look.catalog.message(&name(handle)),
        locked: locks.iter().any(|lock| lock.holds(handle)),
        snap: match handle {
            Handle::Segment | Handle::Window => Snap::Offset,
            _ => Snap::Place,
        },
        marked: matches!(handle, Handle::End(_)),
    };
    handles.iter().map(spot).collect()
}

fn name(handle: Handle) -> Message {
    match handle {
        Handle::End(End::P1) => Message::new("handle-end").with("end", "P₁".to_owned()),
        Handle::End(End::P2) => Message::new("handle-end").with("end", "P₂".to_owned()),
        Handle::Segment => Message::new("handle-segment"),
        Handle::Corner(corner) => Message::new(corner_key(corner)),
        Handle::Side(edge) => Message::new("handle-side").with("edge", Value::Term(edge_key(edge))),
        Handle::Window => Message::new("handle-window"),
        Handle::Vertex(i) => Message::new("handle-vertex").with("number", i + 1),
    }
}

const fn corner_key(Corner { right, top }: Corner) -> &'static str {
    match (right, top) {
        (false, false) => "handle-corner-bottom-left",
        (true, false) => "handle-corner-bottom-right",
        (false, true) => "handle-corner-top-left",
        (true, true) => "handle-corner-top-right",
    }
}

const fn edge_key(edge: Edge) -> &'static str {
    match edge {
        Edge::Left => "edge-left",
        Edge::Right => "edge-right",
        Edge::Bottom => "edge-bottom",
        Edge::Top => "edge-top",
    }
}
