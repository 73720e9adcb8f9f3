//! Files that come in and go out.

use std::sync::Arc;

use egui::Key;

use super::{Bench, SIZE, ctrl};
use crate::{
    app::{App, Command, Desktop, Dialog, Figures, Settings, Target},
    export::{Picture, Steps, Studio},
    figure::Moment,
    labs::{Scene, lines},
    lesson::{Course, SceneFormats},
    paint::ThemeKind,
    text::Lang,
};

#[derive(Debug)]
struct Dropped(&'static [u8]);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        std::path::Path::new("dropped.toml")
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.0.to_vec())
    }
}

#[test]
fn garbage_that_is_dropped_is_explained_and_changes_nothing() {
    let mut bench = Bench::new(SIZE);
    let before = bench.app.scene().clone();
    for garbage in [
        &b"\xff\xfe\x00"[..],
        b"",
        b"window = [1, 0, 0, 1]",
        b"a = [[[[",
    ] {
        let bytes: &'static [u8] = Box::leak(garbage.to_vec().into_boxed_slice());
        bench.frame_with(0.1, Vec::new(), vec![Arc::new(Dropped(bytes))]);
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
    let lines = before.get::<lines::Scene>().expect("the first lab");
    let segments = lines::random_segments(&lines.window, 3, 7);
    let scene = lines::Scene::new(lines.method, lines.window, segments).expect("three segments");
    let scene = Scene::from(scene);
    let text = SceneFormats::standard()
        .write(&scene, &Moment::Start)
        .into_bytes();
    let file = Dropped(Box::leak(text.into_boxed_slice()));
    bench.frame_with(0.1, Vec::new(), vec![Arc::new(file)]);
    assert_eq!(bench.app.scene(), &scene);
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene(), &before);
}

#[test]
fn a_scene_is_saved_where_the_dialog_says() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let app = App::new(Course::default(), Settings::default()).with_platform(Desktop::default());
    let mut bench = Bench::with(app, SIZE);
    bench.press(Key::S, ctrl());
    assert!(matches!(bench.app.shown.dialog, Some(Dialog::Save(_))));
    let path = folder.path().join("scene.toml").display().to_string();
    let ctx = bench.ctx.clone();
    bench.app.apply(
        &ctx,
        Command::Show(Some(Dialog::Save(Target::new(path.clone())))),
    );
    bench.key(Key::Enter);
    bench.settle();
    assert_eq!(bench.app.shown.dialog, None);
    let bytes = std::fs::read(&path).expect("the scene was written");
    let read = SceneFormats::standard()
        .read(&path, &bytes)
        .expect("what is saved can be opened");
    assert_eq!(&read.scene, bench.app.scene());
}

#[test]
fn another_file_is_replaced_only_when_told_twice() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("mine.toml").display().to_string();
    std::fs::write(&path, "mine").expect("writable");
    let app = App::new(Course::default(), Settings::default()).with_platform(Desktop::default());
    let mut bench = Bench::with(app, SIZE);
    let ctx = bench.ctx.clone();
    let ask = Command::Show(Some(Dialog::Save(Target::new(path.clone()))));
    bench.app.apply(&ctx, ask);
    bench.app.apply(&ctx, Command::Confirm);
    assert_eq!(std::fs::read(&path).expect("it is there"), b"mine");
    bench.app.apply(&ctx, Command::Confirm);
    let written = std::fs::read(&path).expect("it is there");
    assert_ne!(written, b"mine");
    // Now it is the scene's own file: saving again asks no more.
    bench.app.apply(&ctx, Command::Last);
    bench.press(Key::S, ctrl());
    bench.app.apply(&ctx, Command::Confirm);
    assert_eq!(bench.app.shown.dialog, None);
    assert_ne!(std::fs::read(&path).expect("it is there"), written);
}

#[test]
fn a_saved_scene_keeps_its_moment_and_names_the_window() {
    let bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let mut app = bench.app;
    app.seek(3);
    let text = app.as_file();
    let read = SceneFormats::standard()
        .read("mine.toml", text.as_bytes())
        .expect("as it was written");
    assert_eq!((&read.scene, read.position), (app.scene(), 3));
    let opened = App::new(Course::embedded(), Settings::default()).with_scene("mine.toml", read);
    assert_eq!((opened.scene(), opened.position()), (app.scene(), 3));
    assert!(opened.bookmark.free().is_some());
    let opened = Bench::with(opened, SIZE);
    assert_eq!(opened.app.shown.title, "mine.toml – Clipscope");
}

#[test]
fn an_export_is_what_was_chosen_and_the_choice_is_remembered() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let app = App::new(Course::default(), Settings::default()).with_platform(Desktop::default());
    let mut bench = Bench::with(app, SIZE);
    let ctx = bench.ctx.clone();
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
    let ask = Command::Show(Some(Dialog::Export(Target::new(path), figures)));
    bench.app.apply(&ctx, ask);
    bench.app.apply(&ctx, Command::Confirm);
    let n_steps = bench.app.playback.transport().n_steps();
    for _ in 0..n_steps {
        bench.frame(0.1, Vec::new());
    }
    assert!(bench.app.exporting.is_none());
    for step in [0, n_steps] {
        let written = std::fs::read(folder.path().join(format!("cut-{step:03}.png")));
        let picture = Picture {
            title: None,
            scene: bench.app.scene(),
            step,
            lang: Lang::Es,
            theme: ThemeKind::Projector,
            size_px: Figures::SIZES[0],
            among: Steps::All,
        };
        let drawn = Studio::new(ThemeKind::Projector).draw(&picture).to_png();
        assert!(
            written.expect("a step") == drawn,
            "as `clipscope export` draws it"
        );
    }
    assert_eq!(
        std::fs::read_dir(folder.path())
            .expect("it is there")
            .count(),
        n_steps + 1
    );
    let again = App::new(Course::default(), bench.app.settings());
    assert_eq!(again.settings().figures, Some(figures));
}

#[derive(Debug)]
struct DroppedFolder(std::path::PathBuf);

impl egui::DroppedFile for DroppedFolder {
    fn path(&self) -> &std::path::Path {
        &self.0
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("os error 21".to_owned())
    }
}

const LESSON: &str = r#"
lab = "lines"
source = "D. Cohen and I. Sutherland, 1967"

[scenes.two-cuts]
method = "cohen-sutherland"
window = [-1, -1, 1, 1]
segments = [[-2, -1, 2, 1.5]]

[[step]]
id = "outside"
scene = "two-cuts"
"#;

#[test]
fn a_dropped_folder_of_lessons_opens_and_says_so_when_it_changes_only() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let before = bench.app.bookmark.lessons().len();
    let drop_it = |bench: &mut Bench| {
        let dropped = DroppedFolder(folder.path().to_owned());
        bench.frame_with(0.1, Vec::new(), vec![Arc::new(dropped)]);
    };
    drop_it(&mut bench);
    assert_eq!(
        bench.app.bookmark.lessons().len(),
        before,
        "there is none in it"
    );
    let said = &bench.app.notices.shown()[0].text;
    assert!(!said.contains("os error"), "{said}");
    let lesson = folder.path().join("01-two-cuts");
    std::fs::create_dir(&lesson).expect("writable");
    std::fs::write(lesson.join("lesson.toml"), LESSON).expect("writable");
    std::fs::write(
        lesson.join("en.md"),
        "# Two cuts\n\n## outside: Nothing yet\n\nWhy?\n",
    )
    .expect("writable");
    drop_it(&mut bench);
    let said: Vec<_> = bench
        .app
        .notices
        .shown()
        .iter()
        .map(|n| n.text.clone())
        .collect();
    assert_eq!(bench.app.bookmark.lessons().len(), 1, "{said:?}");
    let segment = bench
        .app
        .scene()
        .get::<lines::Scene>()
        .map(|scene| scene.segments().len());
    assert_eq!(segment, Some(1));
    let read = |bench: &mut Bench| {
        let files = crate::lesson::Folder::new(folder.path());
        bench
            .app
            .take_course("mine", Course::check(&files), bench.time);
        bench.app.notices.shown().len()
    };
    assert_eq!(read(&mut bench), 0, "nothing has changed");
    std::fs::write(
        lesson.join("en.md"),
        "# Two cuts\n\n## outside: Why?\n\nWhy?\n",
    )
    .expect("writable");
    assert_eq!(read(&mut bench), 1);
}

#[test]
fn an_error_that_is_too_long_scrolls_in_sight() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let line = "a = ".to_owned() + &"[".repeat(400);
    let text = (0..60).map(|_| line.clone()).collect::<Vec<_>>().join("\n");
    bench
        .app
        .notices
        .push(crate::app::notice::Notice::problem(text));
    bench.settle();
    let area = bench
        .ctx
        .memory(|memory| memory.area_rect(egui::Id::unique("notices")));
    let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, SIZE);
    assert!(
        area.is_some_and(|area| screen.contains_rect(area)),
        "{area:?}"
    );
}

#[test]
fn the_last_line_of_a_listing_is_whole_where_its_lines_are_too_long() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let long = "a = ".to_owned() + &"[".repeat(400);
    let text = format!("{long}\nthe last line");
    let notice = crate::app::notice::Notice::problem(text.clone());
    bench.app.notices.push(notice);
    bench.settle();
    let (rect, clip) = bench.clipped(&text);
    assert!(clip.bottom() >= rect.bottom(), "{rect} in {clip}");
}
