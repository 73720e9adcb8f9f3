//! Moving what stands in space by keys: along an axis, and along the sight line.

use egui::{Event, Key, Modifiers};
use glam::DVec3;

use super::{Bench, SIZE};
use crate::app::{App, Command, Settings};
use crate::{
    labs::{Handle, space},
    lesson::Course,
};

/// The free scene of the frustum lab, the camera's handle in focus.
fn focused() -> (Bench, Handle) {
    let mut bench = Bench::with(App::new(Course::default(), Settings::default()), SIZE);
    bench.command(Command::Lab("frustum"));
    bench.settle();
    let handles = bench.app.scene().document().handles();
    let (i, handle) = handles
        .iter()
        .enumerate()
        .find(|(_, handle)| handle.kind().id == "camera")
        .map(|(i, &handle)| (i, handle))
        .expect("there is a camera");
    let id = bench.app.stage.handle_ids[i];
    bench.ctx.memory_mut(|memory| memory.request_focus(id));
    bench.frame(0.1, Vec::new());
    (bench, handle)
}

fn place(bench: &Bench, handle: Handle) -> DVec3 {
    let at = bench.app.scene().document().position(handle);
    at.expect("it is there").into()
}

#[test]
fn full_stop_takes_a_handle_away_from_the_eye() {
    let (mut bench, handle) = focused();
    let scene = bench.app.scene().get::<space::Scene>();
    let eye = DVec3::from(scene.expect("of that lab").eye.position());
    let before = place(&bench, handle);
    bench.key(Key::Period);
    let after = place(&bench, handle);
    assert!(after.distance(eye) > before.distance(eye) + 0.01);
    let sight = (before - eye).normalize();
    assert!((after - eye).normalize().dot(sight) > 1.0 - 1e-12);
    bench.key(Key::Comma);
    // A step is as long as it looks: back from farther away it is a little longer.
    assert!(place(&bench, handle).distance(before) < 0.2 * after.distance(before));
}

#[test]
fn an_axis_that_is_held_is_kept_to() {
    let (mut bench, handle) = focused();
    let before = place(&bench, handle);
    let x = |pressed| Event::Key {
        key: Key::X,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    bench.frame(0.1, vec![x(true)]);
    bench.key(Key::ArrowRight);
    bench.frame(0.1, vec![x(false)]);
    let after = place(&bench, handle);
    assert!(after.x != before.x);
    assert_eq!([after.y, after.z], [before.y, before.z]);
}
