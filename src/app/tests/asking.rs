//! Which file: the system's dialog is asked, and where there is none, or it hangs, the path is typed.

use std::{cell::RefCell, rc::Rc};

use super::*;
use crate::paint::Image;

/// A desktop whose dialogs are answered by the test.
#[derive(Clone, Default)]
struct Asked(Rc<RefCell<Dialogs>>);

#[derive(Default)]
struct Dialogs {
    questions: Vec<Question>,
    answer: Option<Answer>,
    is_missing: bool,
    /// As a page in a browser has it: files are chosen, and written under a name alone.
    has_names_alone: bool,
}

impl Platform for Asked {
    fn suggest(&self, name: &str) -> String {
        format!("/nowhere/{name}")
    }
    fn exists(&self, path: &str) -> bool {
        Desktop::default().exists(path)
    }
    fn has_dialogs(&self) -> bool {
        !self.0.borrow().is_missing
    }
    fn has_paths(&self) -> bool {
        !self.0.borrow().has_names_alone
    }
    fn ask(&mut self, question: &Question, _ctx: &Context) {
        self.0.borrow_mut().questions.push(question.clone());
    }
    fn answer(&mut self) -> Option<Answer> {
        self.0.borrow_mut().answer.take()
    }
    fn reader(&self) -> Reader {
        Desktop::default().reader()
    }
    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, Diagnostic> {
        Desktop::default().write(path, bytes)
    }
    fn draw(&mut self, _: StageFigure<'_>, _: &Context) -> Result<Image, Diagnostic> {
        Ok(Image {
            size: [1, 1],
            rgba: vec![255; 4],
        })
    }
}

fn bench() -> (Bench, Asked) {
    let asked = Asked::default();
    let app = App::new(Course::default(), Settings::default()).with_platform(asked.clone());
    (Bench::with(app, SIZE), asked)
}

impl Asked {
    fn answers(&self, bench: &mut Bench, answer: Answer) {
        self.0.borrow_mut().answer = Some(answer);
        bench.settle();
    }

    fn n_questions(&self) -> usize {
        self.0.borrow().questions.len()
    }
}

#[test]
fn the_system_is_asked_where_to_save_and_what_to_open() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("mine.toml").display().to_string();
    std::fs::write(&path, "another's").expect("writable");
    let (mut bench, asked) = bench();
    bench.press(Key::S, ctrl());
    assert_eq!(asked.n_questions(), 1);
    assert_eq!(bench.app.shown.dialog, None, "the window asks nothing");
    bench.key(Key::ArrowRight);
    assert_eq!(bench.app.position(), 1, "and goes on");
    // The system has asked whether the file is to be replaced.
    asked.answers(&mut bench, Answer::Chosen(path.clone()));
    assert_eq!(bench.app.shown.dialog, None);
    assert_eq!(bench.app.history.file(), Some(&*path));

    let saved = bench.app.scene().clone();
    bench.command(Command::Undo);
    bench.key(Key::Insert);
    assert_ne!(*bench.app.scene(), saved);
    bench.press(Key::O, ctrl());
    assert!(asked.0.borrow().questions[1].opens);
    asked.answers(&mut bench, Answer::Chosen(path));
    assert_eq!((bench.app.scene(), bench.app.position()), (&saved, 1));
}

#[test]
fn a_dialog_that_is_closed_does_nothing() {
    let (mut bench, asked) = bench();
    for key in [Key::S, Key::O] {
        bench.press(key, ctrl());
        asked.answers(&mut bench, Answer::Cancelled);
        assert_eq!(bench.app.shown.dialog, None);
        assert!(bench.app.notices.is_empty());
    }
    // What was chosen of a figure is still there.
    bench.press(Key::E, ctrl());
    let chosen = bench.app.shown.dialog.clone();
    bench.command(Command::Browse);
    assert_eq!(bench.app.shown.dialog, None);
    asked.answers(&mut bench, Answer::Cancelled);
    assert_eq!(bench.app.shown.dialog, chosen);
}

#[test]
fn a_path_is_typed_where_no_dialog_answers() {
    let (mut bench, asked) = bench();
    let is_typed = |bench: &Bench| matches!(bench.app.shown.dialog, Some(Dialog::Save(_)));
    bench.press(Key::S, ctrl());
    asked.answers(&mut bench, Answer::NoDialog);
    assert!(is_typed(&bench), "there is none");
    bench.key(Key::Escape);
    bench.press(Key::S, ctrl());
    assert!(!is_typed(&bench));
    bench.press(Key::S, ctrl());
    assert!(is_typed(&bench), "the one that was asked is silent");
    assert_eq!(asked.n_questions(), 2);
    asked.answers(&mut bench, Answer::Chosen("/nowhere/late.toml".to_owned()));
    assert!(is_typed(&bench), "it is heard no more");
    bench.key(Key::Escape);
    asked.0.borrow_mut().is_missing = true;
    bench.press(Key::S, ctrl());
    assert!(is_typed(&bench));
    assert_eq!(asked.n_questions(), 2);
}

#[test]
fn a_path_that_cannot_be_read_is_there_to_be_mended() {
    let (mut bench, asked) = bench();
    let before = bench.app.scene().clone();
    bench.press(Key::O, ctrl());
    let path = "/nowhere/at-all.toml".to_owned();
    asked.answers(&mut bench, Answer::Chosen(path));
    assert!(matches!(bench.app.shown.dialog, Some(Dialog::Open(_))));
    assert!(bench.app.notices[0].is_problem);
    assert_eq!(*bench.app.scene(), before);
}

#[test]
fn where_files_lie_nowhere_a_name_is_typed_and_a_file_is_chosen() {
    let (mut bench, asked) = bench();
    asked.0.borrow_mut().has_names_alone = true;
    bench.press(Key::S, ctrl());
    assert!(matches!(bench.app.shown.dialog, Some(Dialog::Save(_))));
    assert_eq!(asked.n_questions(), 0);
    bench.key(Key::Escape);
    // A browser need not say that its dialog was closed: it is opened again.
    bench.press(Key::O, ctrl());
    bench.press(Key::O, ctrl());
    assert_eq!(asked.n_questions(), 2);
    let path = "/nowhere/at-all.toml".to_owned();
    asked.answers(&mut bench, Answer::Chosen(path));
    assert!(bench.app.notices[0].is_problem);
    assert_eq!(
        bench.app.shown.dialog, None,
        "there is no path to be mended"
    );
}

#[test]
fn the_name_is_selected_when_the_path_is_to_be_typed() {
    let (mut bench, asked) = bench();
    asked.0.borrow_mut().is_missing = true;
    bench.press(Key::S, ctrl());
    bench.settle();
    bench.write("mine");
    bench.settle();
    let dialog = bench.app.shown.dialog.as_mut();
    let target = dialog.and_then(Dialog::target_mut);
    let path = target.map(|target| &*target.path);
    assert_eq!(path, Some("/nowhere/mine.toml"));
}
