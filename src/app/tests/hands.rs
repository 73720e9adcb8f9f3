//! Handles, dragged and nudged.

use egui::{CursorIcon, Event, Key, Modifiers, vec2};

use super::{Bench, ROOMY, ctrl};
use crate::{
    app::{App, Command, Settings},
    labs::{Lock, lines},
    lesson::Course,
    text::{Catalog, Lang},
};

#[test]
fn an_end_is_dragged_and_one_undo_takes_the_whole_drag_back() {
    let mut bench = Bench::new(ROOMY);
    bench.app.apply(&bench.ctx.clone(), Command::Seek(6));
    bench.settle();
    let before = bench.app.scene().clone();
    let moment = bench.app.playback.main().moment(6);
    let p2 = ends(&bench)[1];
    bench.drag(bench.on_screen(p2), bench.on_screen([2.5, 1.5]));
    assert_eq!(ends(&bench)[1], [2.5, 1.5]);
    let now = bench.app.playback.main();
    assert_eq!(
        now.moment(bench.app.position()),
        moment,
        "the cursor stays at its moment"
    );
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene(), &before);
    bench.press(Key::Z, ctrl() | Modifiers::SHIFT);
    assert_eq!(ends(&bench)[1], [2.5, 1.5]);
    assert!(!bench.app.history.can_redo());
}

#[test]
fn a_drag_keeps_to_the_grid_and_the_background_pans() {
    let mut bench = Bench::new(ROOMY);
    let p1 = ends(&bench)[0];
    bench.drag(bench.on_screen(p1), bench.on_screen([-1.61, -0.72]));
    assert_eq!(ends(&bench)[0], [-1.5, -0.5]);
    let scene = bench.app.scene().clone();
    let fixed = [2.4, -1.3];
    let from = bench.on_screen(fixed);
    bench.drag(from, from + vec2(40.0, 30.0));
    assert_eq!(bench.app.scene(), &scene, "nothing but the view moved");
    assert!((bench.on_screen(fixed) - from - vec2(40.0, 30.0)).length() < 8.0);
}

#[test]
fn a_handle_with_the_focus_takes_the_arrows_until_escape() {
    let mut bench = Bench::new(ROOMY);
    let p1 = bench.app.stage.handle_ids[0];
    bench.ctx.memory_mut(|memory| memory.request_focus(p1));
    bench.frame(0.1, Vec::new());
    bench.key(Key::ArrowRight);
    bench.key(Key::ArrowUp);
    assert_eq!(ends(&bench)[0], [-1.5, -0.5]);
    assert_eq!(bench.app.position(), 0);
    bench.press(Key::ArrowLeft, Modifiers::ALT);
    assert_eq!(ends(&bench)[0], [-1.55, -0.5]);
    bench.key(Key::Tab);
    bench.key(Key::ArrowLeft);
    assert_eq!(ends(&bench)[1], [1.5, 1.5], "Tab goes on to the next");
    bench.key(Key::Escape);
    bench.key(Key::ArrowRight);
    assert_eq!(bench.app.position(), 1);
}

/// Both ends of the segment in focus.
fn ends(bench: &Bench) -> [[f64; 2]; 2] {
    let scene = bench.app.scene().get::<lines::Scene>();
    let focused = scene.expect("the first lab").focused();
    [focused.p1, focused.p2].map(crate::geom::Point::to_array)
}

/// What is written into the field of a place.
fn type_into(bench: &mut Bench, text: &str) {
    bench.settle();
    let typing = bench.app.stage.typing.as_mut().expect("the field is open");
    text.clone_into(&mut typing.text);
    bench.frame(0.05, Vec::new());
    bench.key(Key::Enter);
    bench.settle();
}

#[test]
fn a_place_is_typed_where_it_lies_and_a_bad_one_says_why() {
    let mut bench = Bench::new(ROOMY);
    let before = ends(&bench)[0];
    let at = bench.on_screen(before);
    for _ in 0..2 {
        bench.button(at, true);
        bench.button(at, false);
    }
    type_into(&mut bench, "1/4, −3/2");
    assert_eq!(
        (ends(&bench)[0], bench.app.stage.typing.is_some()),
        ([0.25, -1.5], false)
    );
    bench.press(Key::Z, ctrl());
    assert_eq!(ends(&bench)[0], before, "one step of undo");

    bench.key(Key::Tab);
    bench.key(Key::F2);
    type_into(&mut bench, "1/4, up");
    assert_eq!(ends(&bench)[0], before);
    assert!(bench.app.stage.typing.is_some(), "it stays to be mended");
    bench.key(Key::Escape);
    bench.settle();
    assert_eq!(
        (ends(&bench)[0], bench.app.stage.typing.is_some()),
        (before, false)
    );
}

/// Clicks on the first text like this that stands right of the drawing.
fn click_on(bench: &mut Bench, text: &str) {
    let (_, drawing) = bench.app.stage.places[0];
    let right = crate::widgets::rect_of(drawing).right();
    let texts = bench.texts();
    let mut texts = texts.iter().filter(|(_, rect)| rect.left() >= right);
    let found = texts.find(|(known, _)| known == text);
    let (_, rect) = found.unwrap_or_else(|| panic!("{text} is not shown"));
    let at = rect.center();
    bench.frame(0.02, vec![Event::PointerMoved(at)]);
    bench.frame(0.02, Vec::new());
    assert_eq!(bench.cursor, CursorIcon::Text, "{text} can be typed");
    bench.button(at, true);
    bench.button(at, false);
}

#[test]
fn a_place_is_typed_in_the_watch_table_and_in_a_list() {
    let mut bench = Bench::new(ROOMY);
    let place = Catalog::of(Lang::En).value(&ends(&bench)[0].into());
    bench.command(Command::Seek(1));
    click_on(&mut bench, &place);
    let typing = bench.app.stage.typing.as_ref().expect("the field is open");
    assert_eq!(typing.handle.kind().id, "p1");
    type_into(&mut bench, "-7/4, -1/2");
    assert_eq!(ends(&bench)[0], [-1.75, -0.5]);

    bench.command(Command::Lab("polygons"));
    bench.command(Command::Seek(1));
    let handle = bench.app.scene().document().handles()[0];
    let at = bench.app.scene().document().position(handle);
    let [x, y, _] = at.expect("the first vertex");
    let place = Catalog::of(Lang::En).value(&[x, y].into());
    click_on(&mut bench, &place);
    type_into(&mut bench, "1/8, 3/8");
    let now = bench.app.scene().document().position(handle);
    assert_eq!(now, Some([0.125, 0.375, 0.0]));
}

#[test]
fn a_row_of_the_watch_table_and_a_handle_open_the_field_with_enter() {
    let mut bench = Bench::new(ROOMY);
    bench.command(Command::Seek(1));
    let p1 = bench.app.stage.handle_ids[0];
    bench.ctx.memory_mut(|memory| memory.request_focus(p1));
    bench.settle();
    bench.key(Key::Enter);
    assert!(
        bench.app.stage.typing.is_some(),
        "a handle that has the focus"
    );
    bench.key(Key::Escape);
    bench.settle();
    assert!(bench.app.stage.typing.is_none());
    let place = Catalog::of(Lang::En).value(&ends(&bench)[0].into());
    let texts = bench.texts();
    // The last is the inspector's.
    let shown = texts.iter().rev().find(|(text, _)| *text == place);
    let row = shown.expect("P₁ is watched").1.center();
    let has_focus = |bench: &Bench| {
        let focused = bench.ctx.memory(egui::Memory::focused);
        let response = focused.and_then(|id| bench.ctx.read_response(id));
        response.is_some_and(|response| response.rect.contains(row))
    };
    let is_reached = (0..80).any(|_| {
        bench.key(Key::Tab);
        has_focus(&bench)
    });
    assert!(is_reached, "Tab goes there");
    bench.key(Key::Enter);
    assert!(bench.app.stage.typing.is_some(), "a row that has it");
}

#[test]
fn what_the_lesson_locks_is_not_typed_either() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), ROOMY);
    let handles = bench.app.scene().document().handles();
    let locked = loop {
        let step = bench.app.bookmark.step().expect("a step locks something");
        if let Some(&locked) = handles.iter().find(|&&h| Lock::any_holds(&step.locks, h)) {
            break locked;
        }
        bench.key(Key::PageDown);
    };
    let free = handles.iter().find(|h| h.group() != locked.group());
    for (handle, is_typed) in [(Some(locked), false), (free.copied(), true)] {
        bench.app.start_typing(handle, None);
        assert_eq!(bench.app.stage.typing.is_some(), is_typed, "{handle:?}");
    }
}
