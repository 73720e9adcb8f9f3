//! Handles, dragged and nudged.

use super::*;

#[test]
fn undo_shows_the_step_at_which_the_change_was_made() {
    let mut bench = Bench::new(ROOMY);
    bench.command(Command::Seek(6));
    let p2 = ends(&bench)[1];
    bench.drag(bench.on_screen(p2), bench.on_screen([2.5, 1.5]));
    bench.command(Command::Seek(2));
    bench.undo();
    assert_eq!(bench.app.position(), 6);
    bench.press(Key::Z, ctrl() | Modifiers::SHIFT);
    assert_eq!(bench.app.position(), 2, "where it was undone");
}

#[test]
fn an_end_is_dragged_and_one_undo_takes_the_whole_drag_back() {
    let mut bench = Bench::new(ROOMY);
    bench.command(Command::Seek(6));
    let before = bench.app.scene().clone();
    let moment = bench.app.playback.main().moment(6);
    let p2 = ends(&bench)[1];
    bench.drag(bench.on_screen(p2), bench.on_screen([2.5, 1.5]));
    assert_eq!(ends(&bench)[1], [2.5, 1.5]);
    let now = bench.app.playback.main().moment(bench.app.position());
    assert_eq!(now, moment, "the cursor stays at its moment");
    bench.undo();
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
    let fixed = [1.6, -1.2];
    let from = bench.on_screen(fixed);
    bench.drag(from, from + vec2(40.0, 30.0));
    assert_eq!(bench.app.scene(), &scene, "nothing but the view moved");
    assert!((bench.on_screen(fixed) - from - vec2(40.0, 30.0)).length() < 8.0);
}

#[test]
fn a_handle_with_the_focus_takes_the_arrows_until_escape() {
    let mut bench = Bench::new(ROOMY);
    bench.focus(bench.app.stage.handle_ids[0]);
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

#[test]
fn the_boundary_beside_the_drawing_is_dragged_and_kept() {
    let mut bench = Bench::new(ROOMY);
    let drawing = |bench: &Bench| rect_of(bench.app.stage.places[0].1);
    let edge = |bench: &Bench| {
        let drawing = drawing(bench);
        let others = bench.app.stage.places[1..].iter();
        let beyond = others.map(|(_, slot)| rect_of(*slot).left());
        let beyond = beyond.filter(|left| *left >= drawing.right());
        let next = beyond.reduce(f32::min).expect("a view beside it");
        Pos2::new(drawing.right().midpoint(next), drawing.center().y)
    };
    let (first, at) = (drawing(&bench), edge(&bench));
    bench.drag(at, at - vec2(60.0, 0.0));
    let dragged = drawing(&bench);
    assert!(
        (first.right() - dragged.right() - 60.0).abs() < 12.0,
        "{first:?} {dragged:?}"
    );
    let board = bench.app.settings.board;
    assert!(board > 1.0);
    let id = Id::unique(("boundary", 0_usize));
    bench.focus(id);
    bench.frame(0.1, Vec::new());
    bench.key(Key::ArrowRight);
    bench.settle();
    assert!(
        drawing(&bench).right() > dragged.right(),
        "an arrow moves it, too"
    );
    assert_eq!(bench.app.position(), 0);
    bench.tap(edge(&bench));
    bench.tap(edge(&bench));
    bench.settle();
    assert_eq!(bench.app.settings.board, 1.0, "a double click puts it back");
    assert_eq!(drawing(&bench), first);
}

/// Both ends of the segment in focus.
pub(super) fn ends(bench: &Bench) -> [[f64; 2]; 2] {
    let focused = bench.scene::<lines::Scene>().focused();
    [focused.p1, focused.p2].map(crate::geom::Point::to_array)
}

fn type_place(bench: &mut Bench, text: &str) {
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
    let now = |bench: &Bench| (ends(bench)[0], bench.app.stage.typing.is_some());
    let at = bench.on_screen(before);
    bench.tap(at);
    bench.tap(at);
    type_place(&mut bench, "1/4, −3/2");
    assert_eq!(now(&bench), ([0.25, -1.5], false));
    bench.undo();
    assert_eq!(ends(&bench)[0], before, "one step of undo");

    bench.key(Key::Tab);
    bench.key(Key::F2);
    type_place(&mut bench, "1/4, up");
    assert_eq!(now(&bench), (before, true), "it stays to be mended");
    bench.key(Key::Escape);
    bench.settle();
    assert_eq!(now(&bench), (before, false));
}

/// Clicks on the first text like this that stands right of the drawing.
fn click_on(bench: &mut Bench, text: &str) {
    let (_, drawing) = bench.app.stage.places[0];
    let right = rect_of(drawing).right();
    let mut texts = bench.texts().into_iter();
    let found = texts.find(|(known, rect)| rect.left() >= right && known == text);
    let (_, rect) = found.unwrap_or_else(|| panic!("{text} is not shown"));
    let at = rect.center();
    bench.point(at);
    bench.frame(0.02, Vec::new());
    assert_eq!(bench.cursor, CursorIcon::Text, "{text} can be typed");
    bench.tap(at);
}

/// As the numbers of the step on stage are.
fn written(bench: &Bench, place: [f64; 2]) -> String {
    bench.app.look_at_step().catalog.value(&place.into())
}

#[test]
fn a_place_is_typed_in_the_watch_table_and_in_a_list() {
    let mut bench = Bench::new(ROOMY);
    bench.command(Command::Seek(1));
    let place = written(&bench, ends(&bench)[0]);
    click_on(&mut bench, &place);
    let typing = bench.app.stage.typing.as_ref().expect("the field is open");
    assert_eq!(typing.handle.kind().id, "p1");
    type_place(&mut bench, "-7/4, -1/2");
    assert_eq!(ends(&bench)[0], [-1.75, -0.5]);

    bench.command(Command::Lab("polygons"));
    bench.command(Command::Seek(1));
    let handle = bench.document().handles()[0];
    let at = bench.document().position(handle);
    let [x, y, _] = at.expect("the first vertex");
    let place = written(&bench, [x, y]);
    click_on(&mut bench, &place);
    type_place(&mut bench, "1/8, 3/8");
    assert_eq!(bench.document().position(handle), Some([0.125, 0.375, 0.0]));
}

#[test]
fn a_row_of_the_watch_table_and_a_handle_open_the_field_with_enter() {
    let mut bench = Bench::new(ROOMY);
    bench.command(Command::Seek(1));
    bench.focus(bench.app.stage.handle_ids[0]);
    bench.settle();
    bench.key(Key::Enter);
    assert!(bench.app.stage.typing.is_some(), "of the handle in focus");
    bench.key(Key::Escape);
    bench.settle();
    assert!(bench.app.stage.typing.is_none());
    let place = written(&bench, ends(&bench)[0]);
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
    let mut bench = Bench::course(ROOMY);
    let handles = bench.document().handles();
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

#[test]
fn what_is_typed_first_replaces_the_place_and_the_keys_after_it_are_the_handles() {
    let mut bench = Bench::new(ROOMY);
    bench.focus(bench.app.stage.handle_ids[0]);
    bench.settle();
    bench.key(Key::F2);
    bench.settle();
    bench.frame(0.05, vec![Event::Text("1/4, 1/2".to_owned())]);
    bench.key(Key::Enter);
    bench.settle();
    assert_eq!(ends(&bench)[0], [0.25, 0.5]);
    let step = bench.app.position();
    bench.key(Key::ArrowUp);
    assert!(ends(&bench)[0][1] > 0.5, "the handle has the keys");
    assert_eq!(bench.app.position(), step);
}

#[test]
fn in_space_an_arrow_goes_a_round_step_along_one_axis() {
    let mut bench = Bench::course(ROOMY);
    let lessons = bench.app.bookmark.course.lessons.iter();
    let lesson = lessons.map(|lesson| &*lesson.id);
    let lesson = lesson
        .into_iter()
        .position(|id| id.ends_with("view-volume"));
    bench.command(Command::Open([
        lesson.expect("the view volume has a lesson"),
        0,
    ]));
    bench.settle();
    let handles = bench.document().handles();
    let point = handles
        .iter()
        .position(|handle| handle.kind().id == "point");
    let point = point.expect("a point is there");
    let at = |bench: &Bench| bench.document().position(handles[point]).unwrap();
    let ids = bench.app.stage.handle_ids.clone();
    for key in [Key::ArrowRight, Key::ArrowUp, Key::ArrowLeft] {
        bench.focus(ids[point]);
        bench.settle();
        let before = at(&bench);
        bench.key(key);
        let by: Vec<f64> = (0..3).map(|i| at(&bench)[i] - before[i]).collect();
        let steps: Vec<f64> = by.iter().copied().filter(|by| *by != 0.0).collect();
        assert_eq!(steps.len(), 1, "{key:?}: {by:?}");
        let quarters = steps[0] * 20.0;
        assert!(
            (quarters - quarters.round()).abs() < 1e-9,
            "{key:?}: {by:?}"
        );
        assert!(steps[0].abs() <= 1.0, "{key:?}: {by:?}");
    }
}

#[test]
fn a_plane_takes_one_number() {
    let mut bench = Bench::lab("frustum");
    let handles = bench.document().handles();
    let near = handles.iter().position(|handle| handle.kind().id == "near");
    let near = handles[near.expect("a camera has one")];
    bench.command(Command::Type(Some(near), Some(pos2(300.0, 300.0))));
    type_place(&mut bench, "3/2");
    assert_eq!(bench.document().measure(near), Some(1.5));
    assert!(bench.app.stage.typing.is_none());
}

/// Egui takes a tooltip of the canvas for the canvas with a number: a handle's id is another.
#[test]
fn what_is_locked_says_so_where_it_is_pointed_at() {
    let mut bench = Bench::course(SIZE);
    let lesson = bench
        .app
        .bookmark
        .course
        .lesson_index("04-cutting-with-outcodes");
    bench.command(Command::Open([lesson.expect("it is there"), 0]));
    let handles = bench.document().handles();
    let step = bench.app.bookmark.step().expect("it is open").clone();
    let is_locked = |handle: &&Handle| Lock::any_holds(&step.locks, **handle);
    let locked = handles.iter().find(is_locked).expect("the window is");
    let [x, y, _] = bench.document().position(*locked).expect("it has a place");
    let at = bench.app.on_screen([x, y]).expect("a frame was drawn");
    bench.frame(0.1, vec![Event::PointerMoved(at)]);
    for _ in 0..5 {
        bench.frame(1.0, Vec::new());
    }
    assert_eq!(bench.cursor, CursorIcon::NotAllowed);
    let texts = bench.texts();
    assert!(
        texts.iter().any(|(text, _)| text.contains("locked")),
        "{texts:?}"
    );
}

#[test]
fn what_is_locked_takes_no_press_from_what_is_drawn_there() {
    let mut bench = Bench::course(ROOMY);
    let mut n_taken = 0;
    for (lesson, step) in [
        ("34-the-nearer-wins", "nothing-replaced"),
        ("41-a-tree-of-planes", "no-cut"),
        ("37-far-to-near", "farthest-vertex"),
    ] {
        bench.open_step(lesson, step);
        bench.settle();
        let handles = bench.document().handles();
        let locks = bench.app.locks(&handles).to_vec();
        let is_locked = |handle: &Handle| Lock::any_holds(&locks, *handle);
        let (ids, before) = (
            bench.app.stage.handle_ids.clone(),
            bench.app.scene().clone(),
        );
        for (id, _) in ids.iter().zip(&handles).filter(|(_, it)| is_locked(it)) {
            let place = bench.ctx.read_response(*id).expect("it is there").rect;
            bench.point(place.center());
            let lit = bench.app.stage.lit;
            let lit = lit.and_then(|link| bench.document().seized(link));
            bench.drag(place.center(), place.center() + vec2(25.0, -15.0));
            let moved = crate::labs::moved(&before, bench.app.scene());
            assert!(!moved.iter().any(is_locked), "{lesson}: {moved:?}");
            let is_other = lit.is_some_and(|it| is_locked(&it));
            assert!(moved.is_empty() || !is_other, "{lesson}: {lit:?} is lit");
            n_taken += usize::from(!moved.is_empty());
            bench.edit(Edit::Replace(before.clone()));
            bench.settle();
        }
    }
    assert!(n_taken > 0, "a face lies under one of them");
}

#[test]
fn a_triangle_is_taken_hold_of_in_its_middle_and_follows_the_pointer() {
    let mut bench = Bench::course(ROOMY);
    bench.open_step("34-the-nearer-wins", "nothing-replaced");
    bench.settle();
    let handles = bench.document().handles();
    let nth = handles.iter().position(|it| it.kind().id == "object");
    let (nth, before) = (nth.expect("triangles are there"), bench.app.scene().clone());
    let (from, by) = (bench.handle_at(nth), vec2(40.0, 0.0));
    bench.drag(from, from + by);
    bench.settle();
    assert_eq!(
        crate::labs::moved(&before, bench.app.scene()),
        [handles[nth]]
    );
    let off = (bench.handle_at(nth) - from - by).length();
    assert!(off < 16.0, "to round numbers near the pointer: {off}");
}

#[test]
fn what_was_clicked_is_what_f2_types() {
    let mut bench = Bench::new(ROOMY);
    bench.key(Key::F2);
    assert!(bench.app.stage.typing.is_none(), "nothing was clicked");
    let at = bench.on_screen(ends(&bench)[1]);
    bench.press_at(at);
    bench.key(Key::F2);
    assert!(bench.app.stage.typing.is_some());
}
