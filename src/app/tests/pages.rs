//! Nothing is lost: what was done on a page is there again when it is opened.

use super::*;
use crate::trace::Transport;

/// One more segment; the scene before and after.
fn change(bench: &mut Bench) -> [Scene; 2] {
    let before = bench.app.scene().clone();
    bench.edit(Edit::Add(None));
    let after = bench.app.scene().clone();
    assert_ne!(before, after);
    [before, after]
}

#[test]
fn a_change_survives_page_down_a_lesson_and_a_tab_and_can_be_undone_after_them() {
    let turn = |forward| Command::Lesson { forward };
    for [leave, come_back] in [
        [turn(true), turn(false)],
        [Command::Open([4, 1]), Command::Open([0, 0])],
        [Command::Lab("polygons"), Command::Lab("lines")],
        [Command::Free, Command::Free],
    ] {
        let mut bench = Bench::course(SIZE);
        let [before, after] = change(&mut bench);
        bench.apply(leave.clone());
        assert_ne!(bench.app.scene(), &after, "{leave:?}");
        let page = bench.app.bookmark.page_of([0, 0]).expect("the first step");
        assert!(bench.app.desk.is_changed(&page), "{leave:?}");
        bench.apply(come_back);
        assert_eq!(bench.app.scene(), &after, "{leave:?}");
        bench.undo();
        assert_eq!(bench.app.scene(), &before, "{leave:?}");
    }
}

#[test]
fn a_tab_comes_back_to_where_it_was_left() {
    let mut bench = Bench::course(SIZE);
    bench.apply(Command::Open([4, 2]));
    let page = bench.app.bookmark.page();
    for (lab, is_there) in [("polygons", false), ("lines", true)] {
        bench.apply(Command::Lab(lab));
        assert_eq!(bench.document().lab().id, lab);
        assert_eq!(bench.app.bookmark.page() == page, is_there, "{lab}");
    }
}

#[test]
fn everything_is_there_again_after_a_restart() {
    let mut bench = Bench::course(SIZE);
    let [own, changed] = change(&mut bench);
    bench.apply(Command::Speed(Transport::SPEEDS[4]));
    bench.apply(Command::Theme(ThemeKind::Dark));
    bench.apply(Command::Language(Lang::Es));
    bench.apply(Command::Lab("polygons"));
    bench.key(Key::F8);
    let outline = bench.app.scene().clone();
    bench.apply(Command::Seek(5));

    let mut again = Bench::with(restarted(&bench.app), SIZE);
    assert_eq!(again.app.bookmark.page(), bench.app.bookmark.page());
    assert_eq!((again.app.scene(), again.app.position()), (&outline, 5));
    assert_eq!(again.app.settings(), bench.app.settings());
    again.apply(Command::Open([0, 0]));
    assert_eq!(again.app.scene(), &changed);
    again.undo();
    assert_eq!(again.app.scene(), &own, "one step of undo away");
    again.apply(Command::Lesson { forward: true });
    assert_eq!(restarted(&again.app).bookmark.at, again.app.bookmark.at);
}

#[test]
fn work_on_what_is_gone_is_left_out_and_the_rest_is_kept() {
    let mut bench = Bench::course(SIZE);
    change(&mut bench);
    let mut settings = bench.app.settings();
    settings.works[0].scene = "method = \"of another version\"".to_owned();
    let again = App::new(Course::embedded(), settings.clone());
    assert!(again.is_untouched());
    let without_course = App::new(Course::default(), settings);
    assert!(without_course.bookmark.free.is_some(), "still a scene");
}

#[test]
fn a_scene_that_is_refused_offers_the_methods_that_take_it() {
    let mut bench = Bench::course(SIZE);
    let bow_tie = b"method = \"weiler-atherton\"
window = [0, 0, 4, 4]
polygon = [[1, 1], [5, 5], [5, 1], [1, 5]]
";
    bench.app.open_bytes("bow-tie.toml", bow_tie, 0.0);
    bench.settle();
    let run = bench.app.playback.main();
    assert!(run.is_refused());
    let said = format!("{:?}", run.caption(0));
    assert!(said.contains("S₁S₂") && said.contains("S₃S₄"), "{said}");
    let (scene, revision) = (bench.app.scene().clone(), bench.app.history.revision());
    let ways = bench.app.stage.ways_out(&scene, revision).iter();
    let ways: Vec<&str> = ways.map(|card| card.id).collect();
    assert_eq!(ways, ["sutherland-hodgman", "sutherland-hodgman-pipeline"]);
    for id in ways {
        bench.apply(Command::Edit(Edit::Method(id), None));
        assert!(!bench.app.playback.main().is_refused(), "{id}");
    }
}

#[test]
fn the_number_of_a_step_that_was_changed_is_marked_and_no_other() {
    // Beside the stage, and where the course is a strip.
    for size in [SIZE, vec2(1024.0, 768.0)] {
        let mut bench = Bench::course(size);
        bench.command(Command::Open([0, 1]));
        change(&mut bench);
        bench.command(Command::Open([0, 2]));
        let names = bench.named();
        let mark = Catalog::of(Lang::En).term("lesson-has-changes");
        let is_of_step = |name: &str| (1..9).any(|n| name.starts_with(&format!("{n}: ")));
        let of_steps = names.iter().map(|(name, _)| name);
        let of_steps = of_steps.filter(|name| is_of_step(name) && name.ends_with(&mark));
        let of_steps: Vec<&String> = of_steps.collect();
        let is_second = matches!(&of_steps[..], [one] if one.starts_with("2: "));
        assert!(is_second, "{size}: {of_steps:?}");
    }
}
