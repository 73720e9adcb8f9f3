//! Walking through the course.

use super::*;
use crate::{
    labs::space::{Part, SpaceChange},
    lesson::Loaded,
};

fn n_course_steps(bench: &Bench) -> usize {
    let lessons = &bench.app.bookmark.course.lessons;
    lessons.iter().map(|lesson| lesson.steps.len()).sum()
}

#[test]
fn a_presenter_walks_the_course_and_comes_back() {
    let mut bench = Bench::course(SIZE);
    bench.key(Key::F5);
    let n_steps = n_course_steps(&bench);
    // Where something is asked, the answer comes first.
    for _ in 0..2 * n_steps + 2 {
        bench.key(Key::PageDown);
        let step = bench.app.bookmark.step().expect("a step is open");
        assert_eq!(Some(bench.app.position()), step.position());
        assert_eq!(bench.app.scene(), &*step.scene);
    }
    for _ in 0..n_steps + 2 {
        bench.key(Key::PageUp);
    }
    assert_eq!(bench.app.bookmark.at, [0, 0]);
    assert!(bench.app.shown.presenting.is_some());
    bench.key(Key::Escape);
    assert!(bench.app.shown.presenting.is_none());
}

#[test]
fn reset_brings_the_lesson_s_scene_back() {
    let mut bench = Bench::course(SIZE);
    bench.edit(Edit::Add(None));
    assert!(!bench.app.is_untouched());
    bench.key(Key::R);
    assert!(bench.app.is_untouched());
}

#[test]
fn a_course_that_breaks_or_vanishes_leaves_the_last_good_one() {
    let mut bench = Bench::course(SIZE);
    let n_lessons = bench.app.bookmark.course.lessons.len();
    bench.app.take_course("lessons", Loaded::default(), 0.0);
    assert_eq!(bench.app.bookmark.course.lessons.len(), n_lessons);
    assert!(!bench.app.notices.is_empty());
    bench.frame(0.1, Vec::new());
}

#[test]
fn page_down_shows_the_answer_before_it_moves_on() {
    let mut bench = Bench::course(SIZE);
    let mut n_answers = 0;
    for _ in 1..n_course_steps(&bench) {
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

#[test]
fn a_term_says_what_it_is_to_the_pointer_and_to_a_screen_reader() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([2, 0]));
    let mut named = bench.named().into_iter();
    let term = named.find(|(name, _)| name.starts_with("outcode: "));
    let (name, rect) = term.expect("the step says what an outcode is");
    let says = name.trim_start_matches("outcode: ")[..20].to_owned();
    let mut is_shown = || {
        bench
            .texts()
            .iter()
            .any(|(text, _)| text.starts_with(&says))
    };
    assert!(!is_shown(), "{says}");
    bench.point(rect.center());
    for _ in 0..4 {
        bench.frame(1.0, Vec::new());
    }
    let mut is_shown = || {
        bench
            .texts()
            .iter()
            .any(|(text, _)| text.starts_with(&says))
    };
    assert!(is_shown(), "{says}");
}

/// Where all objects are in the run, to look at another one is no change of the scene; where its run is that of one of them, it is.
#[test]
fn to_look_at_an_object_beside_others_is_no_edit() {
    let at_second = || Edit::own(SpaceChange::LookAt(Part::Object, 1));
    for (lesson, step, is_untouched) in [
        ("43-three-ways-one-picture", "no-order", true),
        ("25-the-funnel", "what-is-left", true),
        ("22-whole-objects-first", "straddling", false),
    ] {
        let mut bench = Bench::course(SIZE);
        bench.open_step(lesson, step);
        bench.edit(at_second());
        assert_eq!(bench.space().focus(), 1, "{lesson}");
        assert_eq!(bench.app.is_untouched(), is_untouched, "{lesson}");
        let change = SpaceChange::Set("object.size", 0, 0.5);
        bench.edit(Edit::own(change));
        assert!(!bench.app.is_untouched(), "{lesson}");
    }
}
