//! Stepping and playing by keyboard.

use super::*;

#[test]
fn the_keys_step() {
    let mut bench = Bench::new(SIZE);
    for (key, modifiers, expected) in [
        (Key::ArrowRight, Modifiers::NONE, 1),
        (Key::ArrowRight, Modifiers::NONE, 2),
        (Key::ArrowLeft, Modifiers::NONE, 1),
        (Key::ArrowRight, Modifiers::SHIFT, 11),
        (Key::ArrowLeft, Modifiers::SHIFT, 1),
        (Key::End, Modifiers::NONE, bench.n_steps()),
        (Key::Home, Modifiers::NONE, 0),
    ] {
        bench.press(key, modifiers);
        let position = bench.app.position();
        assert_eq!(position, expected, "after {key:?} with {modifiers:?}");
    }
}

#[test]
fn ctrl_and_arrows_jump_to_the_next_phase() {
    let mut bench = Bench::new(SIZE);
    bench.press(Key::ArrowRight, ctrl());
    let run = bench.app.playback.main();
    assert_eq!(run.tick(bench.app.position()), crate::figure::Tick::Phase);
    bench.press(Key::ArrowLeft, ctrl());
    assert_eq!(bench.app.position(), 0);
}

#[test]
fn playing_takes_its_time_and_stops_at_the_end() {
    let mut bench = Bench::new(SIZE);
    bench.key(Key::Space);
    assert!(bench.app.playback.transport.is_playing());
    bench.settle();
    let wait_secs = bench.wait_secs;
    assert!(wait_secs > 0.0 && wait_secs <= 1.0, "waits {wait_secs} s");
    let n_steps = bench.n_steps();
    for _ in 0..3 * n_steps {
        bench.frame(0.5, Vec::new());
    }
    assert_eq!(bench.app.position(), n_steps);
    assert!(!bench.app.playback.transport.is_playing());
}

/// Where Tab goes, from the first handle on: the widget of each stop.
fn stops(bench: &mut Bench, n: usize) -> Vec<egui::Response> {
    let mut stops = Vec::new();
    for _ in 0..n {
        bench.key(Key::Tab);
        let focused = bench.ctx.memory(egui::Memory::focused);
        stops.extend(focused.and_then(|id| bench.ctx.read_response(id)));
    }
    stops
}

#[test]
fn tab_walks_the_bar_from_left_to_right_and_stops_at_nothing_that_is_disabled() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::LAST);
    let stops = stops(&mut bench, 60);
    let in_bar = stops.iter().filter(|it| it.rect.bottom() < 44.0);
    let lefts: Vec<f32> = in_bar.map(|it| it.rect.left()).collect();
    let first = lefts
        .iter()
        .position(|left| *left == lefts.iter().copied().fold(f32::MAX, f32::min));
    let lefts = &lefts[first.expect("a stop in the bar")..];
    assert!(lefts.len() >= 8, "{lefts:?}");
    let round = lefts.iter().skip(1).position(|left| *left == lefts[0]);
    let once = &lefts[..round.map_or(lefts.len(), |at| at + 1)];
    assert!(once.is_sorted(), "{once:?}");
    assert!(stops.iter().all(egui::Response::enabled));
    let forward = bench.found("One step forward");
    assert!(stops.iter().all(|it| it.rect != forward), "there is none");
}

#[test]
fn tab_stays_in_what_is_open_over_the_window() {
    for lab in ["lines", "surfaces"] {
        let mut bench = Bench::course(SIZE);
        bench.command(Command::Lab(lab));
        bench.command(Command::Measure(true));
        let stops = stops(&mut bench, 6);
        assert_eq!(stops.len(), 6, "{lab}: something has the focus after each");
        let is_over = |it: &egui::Response| it.layer_id.order == egui::Order::Foreground;
        assert!(stops.iter().all(is_over), "{lab}: {stops:?}");
    }
}

#[test]
fn shift_and_tab_walk_back_over_the_stage_even_where_a_frame_takes_long() {
    let mut bench = Bench::course(SIZE);
    let mut stops = Vec::new();
    bench.key(Key::Tab);
    for _ in 0..12 {
        // Both keys are pressed and let go within a frame.
        let press = |pressed| key_event(Key::Tab, pressed, Modifiers::SHIFT);
        let gone = Event::Key {
            key: Key::Tab,
            physical_key: None,
            pressed: false,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        bench.frame(0.05, vec![press(true), gone]);
        bench.settle();
        stops.extend(bench.ctx.memory(egui::Memory::focused));
    }
    let distinct: std::collections::BTreeSet<_> = stops.iter().map(egui::Id::value).collect();
    assert_eq!(distinct.len(), stops.len(), "{stops:?}");
    assert!(stops.len() >= 11);
}

#[test]
fn the_list_of_keys_is_scrolled_by_keys() {
    let mut bench = Bench::course(vec2(1280.0, 420.0));
    bench.key(Key::Questionmark);
    bench.settle();
    let last = Catalog::of(Lang::En).term("help-turn");
    let is_seen = |bench: &mut Bench| bench.texts().iter().any(|(text, _)| *text == last);
    assert!(!is_seen(&mut bench));
    for _ in 0..8 {
        bench.key(Key::PageDown);
        bench.settle();
    }
    assert!(is_seen(&mut bench));
    bench.key(Key::Home);
    bench.settle();
    assert!(!is_seen(&mut bench));
    assert_eq!(bench.app.bookmark.at, [0, 0], "the page is not turned");
}
