//! Nothing is lost: what was done on a page is there again when it is opened.

use super::*;
use crate::{
    figure::{Mark, Role, Shape},
    labs::polygons,
    trace::Transport,
};

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
fn a_scene_that_was_changed_is_seen_as_it_was_after_another_lab() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Lab("frustum"));
    bench.key(Key::F8);
    bench.command(Command::Zoom(1.5));
    let turned = bench.app.stage.turned_eye();
    assert!(turned.is_some());
    bench.command(Command::Lab("lines"));
    bench.command(Command::Lab("frustum"));
    assert_eq!(bench.app.stage.turned_eye(), turned);
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
    bench.app.open_bytes("bow-tie.toml", bow_tie);
    bench.settle();
    let run = bench.app.playback.main();
    assert!(run.is_refused());
    let said = format!("{:?}", run.caption(0));
    assert!(said.contains("S₁S₂") && said.contains("S₃S₄"), "{said}");
    let (scene, revision) = (bench.app.scene().clone(), bench.app.history.revision());
    let ways = bench.app.stage.ways_out(&scene, revision);
    let ways: Vec<&str> = ways.methods.iter().map(|card| card.id).collect();
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

/// Whoever leaves by a free scene comes back to the lab's own step, after a restart too.
#[test]
fn from_a_free_scene_one_comes_back_to_the_step_of_its_lab() {
    let mut bench = Bench::course(SIZE);
    let last_of = |bench: &Bench, lab: &str| {
        let mut lessons = bench.app.bookmark.course.lessons.iter();
        lessons
            .rposition(|it| it.lab == lab)
            .expect("it has lessons")
    };
    let [frustum, surfaces] = ["frustum", "surfaces"].map(|lab| [last_of(&bench, lab), 1]);
    bench.command(Command::Open(frustum));
    bench.command(Command::Free);
    bench.command(Command::Open(surfaces));
    bench.command(Command::Lab("frustum"));
    assert!(bench.app.bookmark.free.is_some());
    let mut again = Bench::with(restarted(&bench.app), SIZE);
    for bench in [&mut bench, &mut again] {
        bench.command(Command::Free);
        assert_eq!(
            (bench.app.bookmark.at, bench.app.bookmark.free.as_ref()),
            (frustum, None)
        );
    }
    again.command(Command::Lab("surfaces"));
    assert_eq!(again.app.bookmark.at, surfaces);
}

#[test]
fn a_free_scene_of_the_first_lab_lies_beside_the_step_that_was_open_after_a_restart_too() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([4, 3]));
    bench.command(Command::Free);
    let mut again = Bench::with(restarted(&bench.app), SIZE);
    assert!(again.app.bookmark.free.is_some());
    again.command(Command::Free);
    assert_eq!(
        (again.app.bookmark.at, again.app.bookmark.free.as_ref()),
        ([4, 3], None)
    );
}

#[test]
fn what_is_restored_is_said_and_undo_takes_it_away() {
    let mut bench = Bench::course(SIZE);
    let [own, _] = change(&mut bench);
    let mut again = Bench::with(restarted(&bench.app), SIZE);
    let said = Catalog::of(Lang::En).term("status-restored");
    let is_said = again.texts().iter().any(|(text, _)| text.contains(&said));
    assert!(is_said);
    again.undo();
    assert_eq!(again.app.scene(), &own);
}

#[test]
fn the_place_in_a_folders_course_is_its_own() {
    let places = |step: usize| {
        let page = Bench::course(SIZE).app.bookmark.page_of([0, step]);
        Places {
            page,
            ..Places::default()
        }
    };
    let built_in = Settings::default().with_places(places(1));
    let folder = Some("/mine".to_owned());
    let mine = Settings { folder, ..built_in }.with_places(places(2));
    assert_eq!((mine.places(), &mine.places), (places(2), &places(1)));
    let stored = serde_json::to_string(&mine).expect("plain data");
    let read: Settings = serde_json::from_str(&stored).expect("as it was written");
    assert_eq!(
        read.places(),
        places(1),
        "the built-in course is open again"
    );
    assert_eq!(
        Settings {
            folder: mine.folder,
            ..read
        }
        .places(),
        places(2)
    );
}

#[test]
fn a_drag_across_a_refused_position_comes_back_to_its_moment() {
    let mut bench = Bench::course(SIZE);
    let lessons = bench.app.bookmark.course.lessons.iter();
    let at = lessons.enumerate().find_map(|(i, lesson)| {
        let is_it = |step: &LessonStep| {
            let methods = step.scene.document().methods();
            methods.len() == 1 && methods[0].id == "weiler-atherton"
        };
        Some([i, lesson.steps.iter().position(is_it)?])
    });
    bench.command(Command::Open(at.expect("there is one")));
    bench.command(Command::Seek(3));
    let own = bench.app.scene().clone();
    let bow_tie = b"method = \"weiler-atherton\"
window = [0, 0, 4, 4]
polygon = [[1, 1], [5, 5], [5, 1], [1, 5]]
";
    let read = bench.app.kit.formats.read("bow-tie.toml", bow_tie);
    let bow_tie = read.expect("it is read").scene;
    bench.edit(Edit::Replace(bow_tie));
    assert!(bench.app.playback.main().is_refused());
    bench.edit(Edit::Replace(own));
    assert_eq!(bench.app.position(), 3);
}

#[test]
fn a_hole_outside_the_polygon_is_drawn_and_can_be_removed() {
    let mut bench = Bench::course(SIZE);
    let beside = b"method = \"weiler-atherton\"
window = [0, 0, 4, 4]
polygon = [[1, 1], [3, 1], [3, 3], [1, 3]]
holes = [[[1.5, 1.5], [1.5, 2], [2, 1.5]], [[5, 1], [5, 2], [6, 1]]]
";
    bench.app.open_bytes("beside.toml", beside);
    bench.settle();
    assert!(bench.app.playback.main().is_refused());
    let frame = bench.app.playback.main().frame(0);
    let is_hole =
        |mark: &&Mark| mark.shape == Shape::Outline(vec![[5.0, 1.0], [5.0, 2.0], [6.0, 1.0]]);
    let hole = frame.marks().iter().find(is_hole).expect("it is drawn");
    assert_eq!(hole.role, Role::Discarded);
    let words = Catalog::of(Lang::En).term("action-no-hole");
    let texts = bench.texts();
    // What is written at the drawing keeps away from the buttons over it.
    let buttons = bench.app.stage.ways_out_at.expect("they are there");
    let refused = texts.iter().find(|(text, _)| text.starts_with('×'));
    let (_, refused) = refused.expect("it says what is refused");
    assert!(!refused.intersects(buttons), "{refused:?} {buttons:?}");
    let button = texts.iter().find(|(text, _)| *text == words);
    bench.press_at(button.expect("a way out").1.center());
    assert!(!bench.app.playback.main().is_refused());
    assert_eq!(bench.scene::<polygons::Scene>().holes.len(), 1);
}

/// From a folder's course one comes back to the built-in one, and again, each at its own place.
#[test]
fn each_course_is_left_and_found_at_its_place() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let lesson = folder.path().join("01-mine");
    std::fs::create_dir_all(&lesson).expect("writable");
    let toml = "lab = \"lines\"\nsource = \"me\"\n[scenes.a]\nmethod = \"liang-barsky\"
window = [0, 0, 4, 4]\nsegments = [[-1, 1, 5, 2]]
[[step]]\nid = \"one\"\nscene = \"a\"\n[[step]]\nid = \"two\"\n";
    std::fs::write(lesson.join("lesson.toml"), toml).expect("writable");
    let text = "# Mine\n\n## one: First\n\nText.\n\n## two: Second\n\nText.\n";
    std::fs::write(lesson.join("en.md"), text).expect("writable");
    let mine = Some(folder.path().display().to_string());
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([4, 2]));
    bench.command(Command::OpenCourse(mine.clone()));
    assert_eq!(bench.app.bookmark.course.lessons.len(), 1);
    bench.command(Command::Open([0, 1]));
    assert_eq!(bench.app.other_courses(), [None]);
    bench.command(Command::Contents(true));
    let built_in = Catalog::of(Lang::En).term("course-built-in");
    let texts = bench.texts();
    let row = texts.iter().find(|(text, _)| *text == built_in);
    let at = row.expect("it is in the list").1.center();
    bench.press_at(at);
    assert_eq!(bench.app.bookmark.at, [4, 2]);
    bench.command(Command::OpenCourse(mine));
    assert_eq!(bench.app.bookmark.at, [0, 1]);
}

#[test]
fn someone_new_is_told_what_to_press_until_it_is_done() {
    let mut bench = Bench::course(SIZE);
    bench.app.rewind_for_someone_new();
    bench.app.greet();
    let greeting = Catalog::of(Lang::En).term("greeting");
    let is_told = |bench: &Bench| bench.app.notices.iter().any(|it| it.text == greeting);
    assert_eq!(bench.app.position(), 0, "the first → does something");
    assert!(bench.n_steps() > 0 && is_told(&bench));
    bench.key(Key::PageDown);
    assert!(is_told(&bench));
    let is_seen = |bench: &mut Bench| bench.texts().iter().any(|(text, _)| *text == greeting);
    assert!(is_seen(&mut bench));
    bench.key(Key::F5);
    assert!(!is_seen(&mut bench), "not in a presentation");
    bench.key(Key::F5);
    bench.app.open_link("#13-bridges/no-area");
    assert!(is_told(&bench));
    assert_eq!(
        bench.app.position(),
        bench.n_steps(),
        "a link leads to its moment"
    );
    bench.key(Key::ArrowLeft);
    assert!(!is_told(&bench));
    let mut again = restarted(&bench.app);
    again.greet();
    assert!(again.notices.is_empty(), "they know it by now");
}
