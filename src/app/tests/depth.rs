//! Moving what stands in space: along an axis, along the sight line, to round numbers, and what it is taken hold of by.

use glam::DVec3;

use super::*;
use crate::figure::Seer;

/// The free scene of the frustum lab, the camera's handle in focus.
fn focused() -> (Bench, Handle) {
    let mut bench = Bench::lab("frustum");
    let handles = bench.document().handles();
    let camera = handle(&bench, "camera");
    let i = handles.iter().position(|&known| known == camera);
    let i = i.expect("there is a camera");
    bench.focus(bench.app.stage.handle_ids[i]);
    bench.frame(0.1, Vec::new());
    (bench, camera)
}

/// The first of its kind.
fn handle(bench: &Bench, id: &str) -> Handle {
    let mut handles = bench.document().handles().into_iter();
    let found = handles.find(|handle| handle.kind().id == id);
    found.unwrap_or_else(|| panic!("no {id}"))
}

fn seen(bench: &Bench, at: DVec3) -> Pos2 {
    let seen = bench.app.stage.on_screen(at.into());
    seen.expect("before the eye")
}

fn is_round(x: f64, step: f64) -> bool {
    ((x / step).round() * step - x).abs() < 1e-12
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

#[test]
fn an_axis_is_kept_to_until_the_button_is_let_go() {
    let mut bench = Bench::lab("frustum");
    let camera = handle(&bench, "camera");
    let before = place(&bench, camera);
    let at = seen(&bench, before);
    let z = |pressed| key_event(Key::Z, pressed, Modifiers::NONE);
    bench.frame(0.1, vec![z(true)]);
    bench.point(at);
    bench.button(at, true);
    bench.point(at + vec2(70.0, -40.0));
    bench.frame(0.02, Vec::new());
    let dragged = place(&bench, camera);
    assert!(dragged.z != before.z, "{before} {dragged}");
    bench.frame(0.1, vec![z(false)]);
    bench.frame(0.1, Vec::new());
    assert_eq!(place(&bench, camera), dragged, "nothing jumps");
    bench.point(at + vec2(20.0, 90.0));
    bench.button(at + vec2(20.0, 90.0), false);
    bench.settle();
    let after = place(&bench, camera);
    assert_eq!([after.x, after.y], [before.x, before.y]);
}

#[test]
fn a_drag_in_space_comes_to_round_numbers_unless_alt_is_held() {
    let mut bench = Bench::lab("frustum");
    let object = handle(&bench, "object");
    let at = seen(&bench, place(&bench, object));
    bench.drag(at, at + vec2(-37.0, 23.0));
    let round = place(&bench, object).to_array();
    assert!(round.iter().all(|&x| is_round(x, 0.05)), "{round:?}");
    let is_named = |(text, _): &(String, Rect)| text.starts_with("Object 1 (");
    bench.point(at);
    bench.settle();
    let at = seen(&bench, place(&bench, object));
    bench.button(at, true);
    let moved = Event::PointerMoved(at + vec2(13.0, 8.0));
    bench.frame(0.02, vec![Event::ModifiersChanged(Modifiers::ALT), moved]);
    bench.frame(0.02, vec![Event::ModifiersChanged(Modifiers::NONE)]);
    let free = place(&bench, object);
    assert!(
        !free.to_array().iter().all(|&x| is_round(x, 0.05)),
        "{free}"
    );
    for _ in 0..3 {
        bench.frame(0.02, Vec::new());
    }
    assert_eq!(
        place(&bench, object),
        free,
        "letting go of Alt moves nothing"
    );
    assert!(
        bench.texts().iter().any(is_named),
        "its number is beside the pointer"
    );
    bench.button(at + vec2(13.0, 8.0), false);
}

#[test]
fn a_plane_is_taken_by_its_name_and_by_its_edge_and_keeps_to_round_distances() {
    let by_name = |bench: &mut Bench| {
        let mut texts = bench.texts().into_iter();
        let (_, rect) = texts.find(|(text, _)| text == "far").expect("its name");
        rect.center()
    };
    let by_edge = |bench: &mut Bench| {
        let corners = bench.space().camera.camera().corners_in_world();
        let [a, b] = [4, 6].map(|i| DVec3::from(corners[i]));
        seen(bench, a.lerp(b, 0.5))
    };
    let ways: [&dyn Fn(&mut Bench) -> Pos2; 2] = [&by_name, &by_edge];
    for way in ways {
        let mut bench = Bench::lab("frustum");
        let [near, far] = bench.space().camera.depths();
        let corners = bench.space().camera.camera().corners_in_world();
        let [to, from] = [0, 4].map(|i| seen(&bench, corners[i].into()));
        let at = way(&mut bench);
        bench.drag(at, at + 0.3 * (to - from));
        let now = bench.space().camera.depths();
        assert_eq!(now[0], near);
        assert!(now[1] < far && is_round(now[1], 0.05), "{far} {now:?}");
        bench.undo();
        assert_eq!(
            bench.space().camera.depths(),
            [near, far],
            "one step of undo"
        );
    }
}

#[test]
fn an_object_is_taken_by_its_face_and_the_right_button_turns_the_eye() {
    let mut bench = Bench::lab("frustum");
    let object = handle(&bench, "object");
    let before = place(&bench, object);
    // Off its handle, and still on it.
    let at = seen(&bench, before) + vec2(0.0, 16.0);
    bench.point(at);
    let pressed = |at, pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Secondary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    bench.frame(0.1, vec![pressed(at, true)]);
    bench.point(at + vec2(60.0, 0.0));
    bench.frame(0.1, vec![pressed(at + vec2(60.0, 0.0), false)]);
    bench.settle();
    assert_eq!(place(&bench, object), before);
    let at = seen(&bench, before) + vec2(0.0, 16.0);
    bench.drag(at, at + vec2(60.0, 0.0));
    assert!(place(&bench, object) != before, "{before}");
}

#[test]
fn of_handles_that_fall_together_a_click_takes_the_next() {
    let mut bench = Bench::lab("frustum");
    bench.edit(Edit::Method("point-planes"));
    let [point, target] = ["point", "target"].map(|id| handle(&bench, id));
    let there = place(&bench, target);
    bench.edit(Edit::Drag(point, there.into()));
    let at = seen(&bench, there);
    let places = |bench: &Bench| [point, target].map(|handle| place(bench, handle));
    bench.drag(at, at + vec2(40.0, 0.0));
    let moved = places(&bench);
    assert!(
        moved[0] != there && moved[1] == there,
        "the first: {moved:?}"
    );
    bench.undo();
    bench.point(at);
    bench.frame(1.0, Vec::new());
    assert!(
        bench
            .texts()
            .iter()
            .any(|(text, _)| text.ends_with("click: Camera target")),
        "the other is offered"
    );
    bench.tap(at);
    bench.frame(1.0, Vec::new());
    bench.drag(at, at + vec2(40.0, 0.0));
    let moved = places(&bench);
    assert!(
        moved[0] == there && moved[1] != there,
        "the other: {moved:?}"
    );
}

#[test]
fn what_the_lesson_asks_for_is_named_without_the_pointer() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([18, 0]));
    let is_named = |(text, _): &(String, Rect)| text == "Far plane";
    assert!(bench.texts().iter().any(is_named));
    bench.command(Command::Open([18, 1]));
    assert!(!bench.texts().iter().any(is_named));
}

#[test]
fn while_a_point_is_dragged_the_run_stays_at_the_plane_that_it_has_come_to() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([19, 1]));
    bench.command(Command::Seek(3));
    let plane = |bench: &Bench| {
        let decided = bench
            .app
            .playback
            .main()
            .shown(bench.app.position(), |it| it.decision());
        decided.map(|(_, plane)| plane)
    };
    let left = plane(&bench);
    assert!(left.is_some());
    let point = handle(&bench, "point");
    // From there on two planes before it say something else.
    bench.edit(Edit::Drag(point, [1.0, 0.0, -1.0]));
    assert_eq!((bench.app.position(), plane(&bench)), (3, left));
}
