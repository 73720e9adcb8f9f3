//! A scene's handles as a canvas needs them: places and names.

use crate::{
    labs::{Handle, Lock, Scene},
    widgets::{Look, Snap, Spot},
};

/// One spot for each of `handles` that the scene has, in their order.
#[must_use]
pub fn spots(look: Look<'_>, scene: &Scene, handles: &[Handle], locks: &[Lock]) -> Vec<Spot> {
    let spot = |&handle: &Handle| {
        Some(Spot {
            at: scene.position(handle)?,
            name: look.catalog.message(&handle.name()),
            locked: locks.iter().any(|lock| lock.holds(handle)),
            snap: if handle.is_whole() {
                Snap::Offset
            } else {
                Snap::Place
            },
            marked: handle.is_marked(),
        })
    };
    handles.iter().filter_map(spot).collect()
}
