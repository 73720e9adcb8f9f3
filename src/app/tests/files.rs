//! Files that come in and go out.

use std::fs;

use super::*;
use crate::{
    export::{Options, Picture, Steps, Studio},
    lesson::{
        Folder, SceneFormats,
        tests::{LESSON, TEXT},
    },
};

fn on_a_desktop() -> Bench {
    let app = App::new(Course::default(), Settings::default()).with_platform(Desktop::default());
    Bench::with(app, SIZE)
}

#[test]
fn garbage_that_is_dropped_is_explained_and_changes_nothing() {
    let mut bench = Bench::new(SIZE);
    let before = bench.app.scene().clone();
    let garbage = [
        &b"\xff\xfe\x00"[..],
        b"",
        b"window = [1, 0, 0, 1]",
        b"a = [[[[",
    ];
    for garbage in garbage {
        bench.drop_file("dropped.toml", Some(garbage));
        assert!(!bench.app.notices.is_empty(), "{garbage:?} is explained");
        assert_eq!(bench.app.scene(), &before);
        bench.key(Key::Escape);
        assert!(bench.app.notices.is_empty());
    }
}

#[test]
fn a_scene_that_is_dropped_is_opened_and_can_be_undone() {
    let mut bench = Bench::new(SIZE);
    let before = bench.app.scene().clone();
    let &lines::Scene { method, window, .. } = bench.scene();
    let segments = lines::random_segments(&window, 3, 7);
    let scene = lines::Scene::new(method, window, segments).expect("three segments");
    let scene = Scene::from(scene);
    let text = SceneFormats::standard().write(&scene, &Moment::Start);
    bench.drop_file("dropped.toml", Some(text.as_bytes()));
    assert_eq!(bench.app.scene(), &scene);
    bench.undo();
    assert_eq!(bench.app.scene(), &before);
}

#[test]
fn a_scene_is_saved_where_the_dialog_says_over_another_file_when_told_twice() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("mine.toml").display().to_string();
    let now = || fs::read(&path).expect("it is there");
    fs::write(&path, "mine").expect("writable");
    let mut bench = on_a_desktop();
    bench.press(Key::S, ctrl());
    assert!(matches!(bench.app.shown.dialog, Some(Dialog::Save(_))));
    bench.apply(Command::Show(Some(Dialog::Save(Target::new(path.clone())))));
    bench.key(Key::Enter);
    bench.settle();
    assert_eq!(now(), b"mine");
    bench.apply(Command::Confirm);
    assert_eq!(bench.app.shown.dialog, None);
    let written = now();
    let read = SceneFormats::standard().read(&path, &written);
    let read = read.expect("what is saved can be opened");
    assert_eq!(&read.scene, bench.app.scene());
    // Now it is the scene's own file: saving again asks no more.
    bench.settle();
    bench.apply(Command::LAST);
    bench.press(Key::S, ctrl());
    bench.apply(Command::Confirm);
    assert_eq!(bench.app.shown.dialog, None);
    assert_ne!(now(), written);
}

#[test]
fn a_saved_scene_keeps_its_moment_and_names_the_window() {
    let mut app = Bench::course(SIZE).app;
    app.seek(3);
    let read = SceneFormats::standard().read("mine.toml", app.as_file().as_bytes());
    let read = read.expect("as it was written");
    assert_eq!((&read.scene, read.position), (app.scene(), 3));
    let opened = App::new(Course::embedded(), Settings::default()).with_scene("mine.toml", read);
    assert_eq!((opened.scene(), opened.position()), (app.scene(), 3));
    assert!(opened.bookmark.free.is_some());
    let opened = Bench::with(opened, SIZE);
    assert_eq!(opened.app.shown.title, "mine.toml – Clipscope");
}

#[test]
fn an_export_is_what_was_chosen_and_the_choice_is_remembered() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut bench = on_a_desktop();
    bench.press(Key::E, ctrl());
    let Some(Dialog::Export(_, first)) = bench.app.shown.dialog.clone() else {
        panic!("it asks");
    };
    let figures = Figures {
        size_px: Figures::SIZES[0],
        theme: ThemeKind::Projector,
        lang: Lang::Es,
        all: true,
    };
    assert_ne!(first, figures);
    let path = folder.path().join("cut.png").display().to_string();
    let ask = Dialog::Export(Target::new(path), figures);
    bench.apply(Command::Show(Some(ask)));
    bench.apply(Command::Confirm);
    let n_steps = bench.n_steps();
    for _ in 0..n_steps {
        bench.frame(0.1, Vec::new());
    }
    assert!(bench.app.exporting.is_none());
    for step in [0, n_steps] {
        let written = fs::read(folder.path().join(format!("cut-{step:03}.png")));
        let picture = Picture {
            title: None,
            lesson: None,
            scene: bench.app.scene(),
            step,
            before: None,
            options: Options {
                lang: figures.lang,
                theme: figures.theme,
                size_px: figures.size_px,
                steps: Steps::All,
                asks: false,
            },
        };
        let drawn = Studio::new(figures.theme).draw(&picture).to_png();
        let is_same = written.expect("a step") == drawn;
        assert!(is_same, "as `clipscope export` draws it");
    }
    let n_written = fs::read_dir(folder.path()).expect("it is there").count();
    assert_eq!(n_written, n_steps + 1);
    let again = App::new(Course::default(), bench.app.settings());
    assert_eq!(again.settings().figures, Some(figures));
}

#[test]
fn a_dropped_folder_of_lessons_opens_and_says_so_when_it_changes_only() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut bench = Bench::course(SIZE);
    let n_lessons = |bench: &Bench| bench.app.bookmark.course.lessons.len();
    let before = n_lessons(&bench);
    bench.drop_file(folder.path(), None);
    assert_eq!(n_lessons(&bench), before, "there is none in it");
    let said = &bench.app.notices[0].text;
    assert!(!said.contains("os error"), "{said}");
    let lesson = folder.path().join("01-two-cuts");
    let write = |name: &str, text: &str| fs::write(lesson.join(name), text).expect("writable");
    fs::create_dir(&lesson).expect("writable");
    write("lesson.toml", LESSON);
    write("en.md", TEXT);
    bench.drop_file(folder.path(), None);
    assert_eq!(n_lessons(&bench), 1, "{}", bench.said());
    assert_eq!(bench.scene::<lines::Scene>().segments().len(), 2);
    let read = |bench: &mut Bench| {
        let course = Course::check(&Folder::new(folder.path()));
        bench.app.take_course("mine", course, bench.time);
        bench.app.notices.len()
    };
    assert_eq!(read(&mut bench), 0, "nothing has changed");
    write("en.md", &TEXT.replace("What is", "Why is"));
    assert_eq!(read(&mut bench), 1);
}

/// A window in which a problem of so many lines is told, none of which has room, and a last one.
fn told(n_lines: usize, last: &str) -> (Bench, String) {
    let mut bench = Bench::course(SIZE);
    let line = format!("a = {}\n", "[".repeat(400));
    let text = line.repeat(n_lines) + last;
    bench.app.complain(text.clone());
    bench.settle();
    (bench, text)
}

#[test]
fn an_error_that_is_too_long_scrolls_in_sight() {
    let (bench, _) = told(59, &format!("a = {}", "[".repeat(400)));
    let notices = Id::unique("notices");
    let area = bench.ctx.memory(|memory| memory.area_rect(notices));
    let screen = Rect::from_min_size(Pos2::ZERO, SIZE);
    let is_in_sight = area.is_some_and(|area| screen.contains_rect(area));
    assert!(is_in_sight, "{area:?}");
}

#[test]
fn the_last_line_of_a_listing_is_whole_where_its_lines_are_too_long() {
    let (mut bench, text) = told(1, "the last line");
    let mut written = bench.written().into_iter();
    let found = written.find(|(known, ..)| *known == text);
    let (_, rect, clip) = found.expect("it is written");
    assert!(clip.bottom() >= rect.bottom(), "{rect} in {clip}");
}
