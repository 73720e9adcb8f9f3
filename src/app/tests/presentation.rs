//! The presentation: what it shows, and that all is as before when it is over.

use egui::{CursorIcon, Event, Key, Modifiers, ViewportCommand, pos2};

use super::{Bench, SIZE, ctrl};
use crate::{
    app::{App, Command, Settings},
    lesson::Course,
    paint::ThemeKind,
};

fn dark() -> Bench {
    let settings = Settings {
        theme: ThemeKind::Dark,
        ..Settings::default()
    };
    Bench::with(App::new(Course::embedded(), settings), SIZE)
}

/// Presses a key; what was asked of the window.
fn asked(bench: &mut Bench, key: Key) -> Vec<ViewportCommand> {
    let event = |pressed| Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    bench.frame(0.05, vec![event(true)]);
    let asked = bench.asked_of_window.clone();
    bench.frame(0.05, vec![event(false)]);
    asked
}

#[test]
fn it_fills_the_screen_and_leaves_it_as_it_was() {
    let mut bench = dark();
    let before = bench.app.settings();
    assert!(asked(&mut bench, Key::F5).contains(&ViewportCommand::Fullscreen(true)));
    let ctx = bench.ctx.clone();
    bench.app.apply(&ctx, Command::Projector);
    assert_eq!(bench.app.look().theme.kind, ThemeKind::Projector);
    // What is remembered does not know of the lecture hall, should the window be closed in it.
    assert_eq!(bench.app.settings(), before);
    bench.app.apply(&ctx, Command::Projector);
    assert_eq!(bench.app.look().theme.kind, ThemeKind::Dark);
    bench.app.apply(&ctx, Command::Projector);
    assert!(asked(&mut bench, Key::F5).contains(&ViewportCommand::Fullscreen(false)));
    assert_eq!(bench.app.look().theme.kind, ThemeKind::Dark);
    assert_eq!(bench.app.settings(), before);
}

#[test]
fn escape_leaves_it_whatever_else_is_on_screen() {
    for open in [
        (Key::Questionmark, Modifiers::NONE),
        (Key::S, ctrl()),
        (Key::M, ctrl()),
        (Key::Tab, Modifiers::NONE),
    ] {
        let mut bench = dark();
        bench.key(Key::F5);
        bench.press(open.0, open.1);
        bench.settle();
        assert!(asked(&mut bench, Key::Escape).contains(&ViewportCommand::Fullscreen(false)));
        assert!(bench.app.shown.presenting.is_none(), "{open:?}");
        assert_eq!(bench.app.shown.dialog, None);
    }
}

#[test]
fn a_pointer_that_rests_is_hidden_and_the_app_sleeps() {
    let mut bench = dark();
    bench.key(Key::F5);
    bench.frame(0.1, vec![Event::PointerMoved(pos2(900.0, 500.0))]);
    assert_ne!(bench.cursor, CursorIcon::None);
    for _ in 0..10 {
        if bench.wait_secs > 1e6 {
            break;
        }
        assert!(bench.wait_secs <= 3.0);
        bench.frame(bench.wait_secs.max(0.01), Vec::new());
    }
    bench.frame(3.0, Vec::new());
    assert_eq!(bench.cursor, CursorIcon::None);
    assert!(bench.wait_secs > 1e6, "wakes in {} s", bench.wait_secs);
    bench.frame(0.1, vec![Event::PointerMoved(pos2(910.0, 500.0))]);
    assert_ne!(bench.cursor, CursorIcon::None);
}
