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
    let mut bench = Bench::on_a_desktop();
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
    let mut bench = Bench::on_a_desktop();
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
    assert!(!bench.app.end_export());
    for step in [0, n_steps] {
        let written = fs::read(folder.path().join(format!("cut-{step:03}.png")));
        let picture = Picture {
            title: None,
            lesson: None,
            scene: bench.app.scene(),
            step,
            before: None,
            foot: None,
            options: Options {
                lang: figures.lang,
                theme: figures.theme,
                size_px: figures.size_px,
                steps: Steps::All,
                asks: false,
            },
        };
        let moment = bench.app.playback.main().moment(step);
        let link = bench.app.link_at(step, &moment).fitting();
        let drawn = Studio::new(figures.theme).draw(&picture);
        let drawn = drawn.to_linked_png(link.as_deref());
        let is_same = written.expect("a step") == drawn;
        assert!(is_same, "as `clipscope export` draws it");
    }
    let n_written = fs::read_dir(folder.path()).expect("it is there").count();
    assert_eq!(n_written, n_steps + 1);
    let again = App::new(Course::default(), bench.app.settings());
    assert_eq!(again.settings().figures, Some(figures));
}

#[test]
fn the_ending_of_an_export_says_its_format_and_the_dialog_how_large_it_becomes() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (ending, begins) in [("svg", "<svg "), ("pdf", "%PDF-"), ("png", "\u{89}PNG")] {
        let mut bench = Bench::on_a_desktop();
        bench.press(Key::E, ctrl());
        let Some(Dialog::Export(mut target, figures)) = bench.app.shown.dialog.clone() else {
            panic!("it asks");
        };
        let path = folder.path().join(format!("cut.{ending}"));
        target.path = path.display().to_string();
        bench.apply(Command::Show(Some(Dialog::Export(target, figures))));
        bench.frame(0.1, Vec::new());
        let weight = bench.app.weight(figures);
        bench.apply(Command::Confirm);
        let written = fs::read(&path).expect("it is there");
        let text = String::from_utf8_lossy(&written);
        let begins = begins.trim_start_matches('\u{89}');
        assert!(
            text.trim_start_matches('\u{FFFD}').starts_with(begins),
            "{ending}"
        );
        assert_eq!(weight, Some((written.len(), 1)), "{ending}");
    }
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
fn a_message_stands_above_the_stage_and_hides_neither_it_nor_the_lesson() {
    let screen = Rect::from_min_size(Pos2::ZERO, SIZE);
    for n_lines in [0, 59] {
        let (mut bench, text) = told(n_lines, "the last line");
        let close = bench.found("Close");
        assert!(screen.contains_rect(close), "{close}");
        let lesson = bench
            .app
            .bookmark
            .title(Lang::En, false)
            .expect("a step")
            .to_owned();
        let texts = bench.texts();
        let title = texts.iter().find(|(text, _)| *text == lesson);
        let title = title.expect("the lesson is read").1;
        let lines = texts
            .iter()
            .filter(|(line, _)| text.lines().any(|it| it == line));
        let lines: Vec<Rect> = lines.map(|(_, rect)| *rect).collect();
        assert!(!lines.is_empty());
        let stage = bench.on_screen([0.0, 0.0]);
        for line in lines {
            assert!(
                line.left() > title.right() && line.bottom() < stage.y,
                "{line}"
            );
            assert!(screen.contains_rect(line), "it is wrapped: {line}");
        }
    }
}

#[test]
fn recent_files_are_at_hand_and_one_that_is_gone_leaves() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |n: usize| {
        folder
            .path()
            .join(format!("{n}.toml"))
            .display()
            .to_string()
    };
    let mut bench = Bench::on_a_desktop();
    for n in 0..9 {
        bench.edit(Edit::Add(None));
        let save = Dialog::Save(Target::new(path(n)));
        bench.command(Command::Show(Some(save)));
        bench.command(Command::Confirm);
    }
    let recent = |bench: &Bench| bench.app.settings().recent;
    let newest_first: Vec<String> = (1..9).rev().map(path).collect();
    assert_eq!(recent(&bench), newest_first, "eight, the last one first");
    bench.open_menus(&["Scene", "Open a recent file"]);
    let mut named = bench.named().into_iter();
    let row = named.find(|(name, _)| name.starts_with("3.toml"));
    bench.press_at(row.expect("it is in the list").1.center());
    assert_eq!(bench.app.history.file(), Some(&*path(3)));
    assert_eq!(recent(&bench)[0], path(3));
    fs::remove_file(path(8)).expect("it is there");
    bench.command(Command::OpenRecent(path(8)));
    assert!(bench.said().contains(&path(8)), "{}", bench.said());
    assert!(!recent(&bench).contains(&path(8)));
    assert_eq!(
        bench.app.history.file(),
        Some(&*path(3)),
        "all else is as it was"
    );
}

#[test]
fn the_figure_goes_to_the_clipboard_as_an_export_writes_it() {
    let mut bench = Bench::on_a_desktop();
    let event = key_event(Key::C, true, ctrl() | Modifiers::SHIFT);
    let output = bench.run(vec![event], Vec::new());
    let copied = output
        .platform_output
        .commands
        .iter()
        .find_map(|command| match command {
            egui::OutputCommand::CopyImage(image) => Some(image),
            _ => None,
        });
    let copied = copied.expect("an image");
    assert_eq!(copied.size, [1920, 1080]);
    let said = bench.said();
    assert!(said.contains("1920") && said.contains("1080"), "{said}");
    let picture = Picture {
        title: None,
        lesson: None,
        scene: bench.app.scene(),
        step: bench.app.position(),
        before: None,
        foot: None,
        options: Options {
            lang: Lang::En,
            theme: ThemeKind::Light,
            size_px: [1920, 1080],
            steps: Steps::Figures,
            asks: false,
        },
    };
    let drawn = Studio::new(ThemeKind::Light).draw(&picture);
    let pixels = copied.pixels.iter().flat_map(egui::Color32::to_array);
    assert!(pixels.eq(drawn.rgba), "as `clipscope export` draws it");
}

#[test]
fn the_figure_goes_to_the_clipboard_as_the_text_of_an_svg_file_that_opens_again() {
    let mut bench = Bench::on_a_desktop();
    bench.app.push(Command::CopySvg);
    let output = bench.run(Vec::new(), Vec::new());
    let mut commands = output.platform_output.commands.iter();
    let copied = commands.find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text),
        _ => None,
    });
    let copied = copied.expect("a text");
    assert!(
        copied.starts_with("<svg") && copied.ends_with("</svg>\n"),
        "{copied}"
    );
    let position = bench.app.position();
    bench.command(Command::LAST);
    bench.run(vec![egui::Event::Paste(copied.clone())], Vec::new());
    assert_eq!(bench.app.position(), position, "{}", bench.said());
    let other = Bench::new(egui::vec2(1280.0, 720.0));
    assert!(
        !other.app.platform.formats().contains(&"svg"),
        "not offered there"
    );
}
