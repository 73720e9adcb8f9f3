//! What is drawn, in windows of every size, and when.

use egui::{Key, vec2};

use super::{Bench, SIZE, ctrl};
use crate::{
    app::{App, Command, Settings},
    labs::{Edit, lines::LinesChange},
    lesson::Course,
    paint::ThemeKind,
    text::Lang,
};

#[test]
fn an_idle_app_asks_for_no_repaint() {
    for course in [Course::default(), Course::embedded()] {
        let mut bench = Bench::with(App::new(course, Settings::default()), SIZE);
        bench.frame(10.0, Vec::new());
        assert!(
            bench.wait_secs > 1e6,
            "asks for a repaint in {} s",
            bench.wait_secs
        );
    }
}

#[test]
fn every_size_language_and_theme_is_drawn() {
    for size in [
        vec2(320.0, 240.0),
        SIZE,
        vec2(3840.0, 2160.0),
        vec2(240.0, 900.0),
    ] {
        for lang in Lang::ALL {
            for theme in ThemeKind::ALL {
                let settings = Settings {
                    lang,
                    theme,
                    ..Settings::default()
                };
                let mut bench = Bench::with(App::new(Course::embedded(), settings), size);
                for key in [
                    Key::F6,
                    Key::F7,
                    Key::F7,
                    Key::F5,
                    Key::PageDown,
                    Key::F5,
                    Key::F1,
                ] {
                    bench.key(key);
                    assert!(
                        bench.frame(0.3, Vec::new()) > 0,
                        "{size} {lang} {theme} {key:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn two_methods_stand_side_by_side_and_step_together() {
    let mut bench = Bench::new(SIZE);
    let ctx = bench.ctx.clone();
    bench.app.apply(
        &ctx,
        Command::Edit(Edit::Compare(Some("liang-barsky")), None),
    );
    bench.key(Key::End);
    assert_eq!(bench.app.playback.frames().len(), 2);
    assert_eq!(bench.app.stage.canvas_ids.len(), 2);
    let ends = bench.app.playback.costs();
    assert!(
        ends.iter().all(|[now, end]| now == end),
        "both are at their ends"
    );
}

#[test]
fn a_hundred_thousand_segments_are_drawn() {
    let mut bench = Bench::new(SIZE);
    let ctx = bench.ctx.clone();
    let edit = LinesChange::Random {
        count: 100_000,
        seed: 1,
    };
    bench.app.apply(&ctx, Command::Edit(Edit::own(edit), None));
    bench.settle();
    assert!(bench.frame(0.1, Vec::new()) > 0);
    bench.key(Key::End);
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene().document().size(), 1);
}
