//! Walking through the course.

use egui::Key;

use super::{Bench, SIZE};
use crate::{
    app::{App, Command, Settings},
    labs::Edit,
    lesson::Course,
    paint::ThemeKind,
    text::Lang,
    trace::Transport,
};

fn n_steps(bench: &Bench) -> usize {
    let lessons = bench.app.bookmark.lessons();
    lessons.iter().map(|lesson| lesson.steps.len()).sum()
}

#[test]
fn a_presenter_walks_the_course_and_comes_back() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    bench.key(Key::F5);
    let n_steps = n_steps(&bench);
    for _ in 0..n_steps + 2 {
        bench.key(Key::PageDown);
        assert!(!bench.app.shown.is_answered, "no text is read there");
        let step = bench.app.bookmark.step().expect("a step is open");
        assert_eq!(Some(bench.app.position()), step.position());
        assert_eq!(bench.app.scene(), &*step.scene);
    }
    for _ in 0..n_steps + 2 {
        bench.key(Key::PageUp);
    }
    assert_eq!(bench.app.bookmark.indices(), [0, 0]);
    assert!(bench.app.shown.presenting.is_some());
    bench.key(Key::Escape);
    assert!(bench.app.shown.presenting.is_none());
}

#[test]
fn reset_brings_the_lesson_s_scene_back() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let ctx = bench.ctx.clone();
    bench.app.apply(&ctx, Command::Edit(Edit::Add(None), None));
    bench.settle();
    assert!(!bench.app.is_untouched());
    bench.key(Key::R);
    assert!(bench.app.is_untouched());
}

#[test]
fn a_course_that_breaks_or_vanishes_leaves_the_last_good_one() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let n_lessons = bench.app.bookmark.lessons().len();
    bench
        .app
        .take_course("lessons", crate::lesson::Loaded::default(), 0.0);
    assert_eq!(bench.app.bookmark.lessons().len(), n_lessons);
    assert!(!bench.app.notices.is_empty());
    bench.frame(0.1, Vec::new());
}

#[test]
fn settings_come_back() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let ctx = bench.ctx.clone();
    for command in [
        Command::Lesson { forward: true },
        Command::Speed(Transport::SPEEDS[4]),
        Command::Theme(ThemeKind::Dark),
        Command::Language(Lang::Es),
    ] {
        bench.app.apply(&ctx, command);
    }
    let stored = serde_json::to_string(&bench.app.settings()).expect("plain data");
    let settings = serde_json::from_str(&stored).expect("as it was written");
    let again = App::new(Course::embedded(), settings);
    assert_eq!(again.bookmark.indices(), bench.app.bookmark.indices());
    assert_eq!(again.settings(), bench.app.settings());
}

#[test]
fn page_down_shows_the_answer_before_it_moves_on() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let n_steps = n_steps(&bench);
    let mut n_answers = 0;
    for _ in 1..n_steps {
        let before = bench.app.bookmark.page();
        if bench.app.has_answer() {
            bench.key(Key::PageDown);
            assert!(bench.app.shown.is_answered);
            assert_eq!(bench.app.bookmark.page(), before);
            n_answers += 1;
        }
        bench.key(Key::PageDown);
        assert!(!bench.app.shown.is_answered, "another question");
    }
    assert!(n_answers > 3);
}
