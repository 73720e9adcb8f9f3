//! Moving what stands in space by keys: along an axis, and along the sight line.

use glam::DVec3;

use super::*;
use crate::figure::Seer;

/// The free scene of the frustum lab, the camera's handle in focus.
fn focused() -> (Bench, Handle) {
    let mut bench = Bench::lab("frustum");
    let handles = bench.document().handles();
    let is_camera = |handle: &Handle| handle.kind().id == "camera";
    let i = handles.iter().position(is_camera);
    let i = i.expect("there is a camera");
    bench.focus(bench.app.stage.handle_ids[i]);
    bench.frame(0.1, Vec::new());
    (bench, handles[i])
}

fn place(bench: &Bench, handle: Handle) -> DVec3 {
    let at = bench.document().position(handle);
    at.expect("it is there").into()
}

#[test]
fn full_stop_takes_a_handle_away_from_the_eye() {
    let (mut bench, handle) = focused();
    let seer = bench.app.playback.frames[0].space().map(|space| space.seer);
    let Some(Seer::Eye(eye)) = seer else {
        panic!("an eye sees the scene: {seer:?}");
    };
    let eye = DVec3::from(eye.position());
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
    let x = |pressed| key_event(Key::X, pressed, Modifiers::NONE);
    bench.frame(0.1, vec![x(true)]);
    bench.key(Key::ArrowRight);
    bench.frame(0.1, vec![x(false)]);
    let after = place(&bench, handle);
    assert!(after.x != before.x);
    assert_eq!([after.y, after.z], [before.y, before.z]);
}
