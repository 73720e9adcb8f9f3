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
