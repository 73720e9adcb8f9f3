//! Files that come in and go out.

use std::sync::Arc;

use egui::Key;

use super::{Bench, SIZE, ctrl};
use crate::{
    app::{App, Command, Desktop, Dialog, Settings, dialog::Target},
    figure::Moment,
    labs::{Scene, lines},
    lesson::{Course, SceneFormats},
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
    let app = App::new(Course::default(), Settings::default()).with_platform(Desktop);
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
    let app = App::new(Course::default(), Settings::default()).with_platform(Desktop);
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
