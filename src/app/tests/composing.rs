//! A lesson is made in the window: its files are what was done, and all of it can be undone.

mod arranged;

use std::fs;

use super::{compose::Act, *};
use crate::lesson::{CodeView, Draft, Folder, Severity};

/// A lesson that begins with the free scene of the lines lab, in a folder of its own.
fn begun() -> (Bench, tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let root = folder.path().join("mine");
    let app = App::new(Course::embedded(), Settings::default()).with_platform(Desktop::default());
    let mut bench = Bench::with(app, SIZE);
    bench.command(Command::OpenPage(Page::Free("lines".to_owned())));
    bench.command(Command::LAST);
    save(&mut bench, &root);
    assert!(bench.app.composed().is_some(), "{}", bench.said());
    (bench, folder, root)
}

fn save(bench: &mut Bench, root: &Path) {
    bench.act(Act::Save);
    let Some(Dialog::Lesson(mut target)) = bench.app.shown.dialog.clone() else {
        panic!("a folder is asked for");
    };
    target.path = root.display().to_string();
    bench.command(Command::Show(Some(Dialog::Lesson(target))));
    bench.command(Command::Confirm);
}

impl Bench {
    fn act(&mut self, act: Act) {
        self.command(Command::Compose(act));
    }

    /// Until what was changed is written.
    fn pause(&mut self) {
        self.frame(1.1, Vec::new());
        self.settle();
    }

    fn drag_first(&mut self, by: f64) {
        let handle = self.document().handles()[0];
        let at = self.document().position(handle).expect("it lies somewhere");
        self.edit(Edit::Drag(handle, at.map(|x| x + by)));
        // Changes that follow at once are undone together.
        self.pause();
    }

    fn step_titles(&self) -> Vec<String> {
        let lesson = self.app.bookmark.lesson().expect("it is open");
        let titles = (0..lesson.steps.len()).filter_map(|i| lesson.step_title(i, Lang::En));
        titles.map(str::to_owned).collect()
    }
}

fn written(root: &Path) -> Vec<Vec<u8>> {
    ["lesson.toml", "en.md"]
        .map(|name| fs::read(root.join(name)).expect("it is there"))
        .into()
}

fn checked(root: &Path) -> Course {
    let loaded = Course::check(&Folder::new(root));
    let errors = loaded
        .problems
        .iter()
        .filter(|it| it.severity == Severity::Error);
    assert_eq!(errors.count(), 0, "{:?}", loaded.problems);
    loaded.course
}

#[test]
fn a_scene_becomes_a_lesson_of_three_steps_and_all_is_undone_in_order() {
    let (mut bench, _folder, root) = begun();
    let first = written(&root);
    let scene = bench.app.scene().clone();
    bench.command(Command::FIRST);
    bench.pause();
    bench.act(Act::Title("Nothing is decided".to_owned()));
    bench.pause();
    bench.press(Key::Enter, ctrl());
    bench.settle();
    bench.command(Command::Step(2));
    bench.pause();
    bench.act(Act::Add(None));
    bench.command(Command::LAST);
    bench.drag_first(0.25);
    let moved = bench.app.scene().clone();
    let course = checked(&root);
    let [lesson] = &course.lessons[..] else {
        panic!("one lesson")
    };
    assert_eq!(lesson.title(Lang::En), "Free scene");
    let stands: Vec<_> = lesson.steps.iter().map(|step| step.position()).collect();
    assert_eq!(
        (stands.len(), stands[0], stands[2]),
        (3, Some(0), Some(bench.n_steps()))
    );
    assert_eq!(bench.step_titles()[0], "Nothing is decided");
    assert!(*lesson.steps[2].scene == moved && moved != scene);
    // One scene is shown by all three, until one has its own.
    assert_eq!(*lesson.steps[0].scene, moved);
    let mut n_undone = 0;
    while bench.app.can_travel()[0] {
        bench.undo();
        n_undone += 1;
    }
    bench.pause();
    assert!(n_undone >= 6, "{n_undone}");
    assert_eq!(written(&root), first);
    assert_eq!(bench.app.scene(), &scene);
    for _ in 0..n_undone {
        bench.press(Key::Y, ctrl());
    }
    bench.pause();
    assert_eq!(*checked(&root).lessons[0].steps[2].scene, moved);
}

#[test]
fn a_step_has_a_scene_of_its_own_once_that_is_asked_for() {
    let (mut bench, _folder, root) = begun();
    bench.act(Act::Add(None));
    bench.act(Act::OwnScene);
    let before = bench.app.scene().clone();
    bench.drag_first(0.5);
    let course = checked(&root);
    let steps = &course.lessons[0].steps;
    assert_eq!(*steps[0].scene, before);
    assert_eq!(*steps[1].scene, *bench.app.scene());
}

#[test]
fn the_list_is_walked_by_keys_and_says_where_each_step_stands() {
    let (mut bench, _folder, root) = begun();
    bench.act(Act::Title("One".to_owned()));
    bench.pause();
    bench.focus(compose::row_id(0));
    bench.key(Key::Insert);
    bench.settle();
    bench.act(Act::Title("Two".to_owned()));
    bench.pause();
    assert_eq!(bench.step_titles(), ["One", "Two"]);
    bench.ctx.enable_accesskit();
    bench.settle();
    let said = "step 2 of 2, Two, at end";
    assert!(
        bench.names.iter().any(|(name, _)| name == said),
        "{:?}",
        bench.names
    );
    bench.focus(compose::row_id(1));
    bench.press(Key::ArrowUp, Modifiers::ALT);
    bench.settle();
    assert_eq!(bench.step_titles(), ["Two", "One"]);
    let focused = bench.ctx.memory(egui::Memory::focused);
    assert_eq!(focused, Some(compose::row_id(0)));
    bench.key(Key::Delete);
    bench.pause();
    assert_eq!(bench.step_titles(), ["One"]);
    bench.key(Key::Delete);
    bench.pause();
    assert_eq!(bench.step_titles(), ["One"], "a lesson keeps a step");
    checked(&root);
}

#[test]
fn letters_are_undone_with_everything_else() {
    let (mut bench, _folder, _root) = begun();
    let first = bench.step_titles();
    bench.focus(Id::unique("title that is made"));
    bench.frame(0.1, Vec::new());
    for letter in ["A", "B"] {
        bench.write(letter);
    }
    bench.pause();
    assert!(
        bench.step_titles()[0].contains("AB"),
        "{:?}",
        bench.step_titles()
    );
    bench.undo();
    bench.settle();
    assert_eq!(bench.step_titles(), first);
}

#[test]
fn what_a_step_asks_locks_and_hides_is_in_its_file() {
    let (mut bench, _folder, root) = begun();
    bench.act(Act::Lock("window"));
    bench.act(Act::Lock("p1"));
    bench.act(Act::Lock("window"));
    for (key, value) in [
        ("code", "\"words\""),
        ("ask", "true"),
        ("figure", "\"mine\""),
    ] {
        bench.act(Act::Set(key, Some(value.to_owned())));
    }
    bench.act(Act::Name("what-comes".to_owned()));
    bench.pause();
    let course = checked(&root);
    let step = &course.lessons[0].steps[0];
    assert_eq!(
        (&*step.id, step.figure.as_deref()),
        ("what-comes", Some("mine"))
    );
    assert_eq!((step.code, step.locks.len()), (CodeView::Words, 1));
    assert_eq!(step.asks, Some(crate::lesson::Asks::Decision));
    // Who makes a lesson is not asked, but who tries it is.
    assert!(!bench.app.practice.is_asking());
    let marks = bench.app.settings.progress.clone();
    bench.key(Key::F9);
    bench.settle();
    assert!(bench.app.composed().is_none() && bench.app.practice.is_asking());
    bench.command(Command::Choose(0));
    bench.key(Key::F9);
    bench.settle();
    assert!(bench.app.composed().is_some());
    assert_eq!(bench.app.settings.progress, marks, "no mark is a teacher's");
}

#[test]
fn a_goal_is_the_scene_as_it_stood_and_has_a_line_in_the_text() {
    let (mut bench, _folder, root) = begun();
    bench.act(Act::Goal(true));
    let compose = bench.app.compose.as_ref().expect("it is made");
    assert!(!compose.problems.is_empty(), "it is reached at first");
    let handles = bench.document().handles();
    let [first, second] = [0, 1].map(|i| handles[i]);
    bench.edit(Edit::Drag(first, [-3.0, -3.0, 0.0]));
    bench.edit(Edit::Drag(second, [-3.0, 3.0, 0.0]));
    bench.pause();
    let course = checked(&root);
    let goal = course.lessons[0].steps[0].goal.as_ref().expect("a goal");
    assert!(goal.met_by(&goal.reached).into_iter().all(|is_met| is_met));
    assert!(
        fs::read_to_string(root.join("en.md"))
            .expect("text")
            .contains("- [ ] Something is visible\n")
    );
    bench.act(Act::Goal(false));
    bench.pause();
    assert_eq!(checked(&root).lessons[0].steps[0].goal, None);
}

#[test]
fn a_mistake_is_named_with_its_place_and_the_last_good_version_stays() {
    let (mut bench, _folder, root) = begun();
    let good = bench.app.bookmark.lesson().cloned();
    bench.act(Act::Body("See {nothing.there}.".to_owned()));
    bench.pause();
    let compose = bench.app.compose.as_ref().expect("it is made");
    let place = compose.problems[0]
        .place
        .as_ref()
        .map(|place| (place.line, place.column));
    assert_eq!(place, Some((5, 5)), "{:?}", compose.problems);
    assert_eq!(bench.app.bookmark.lesson(), good.as_ref());
    let on_disk = fs::read_to_string(root.join("en.md")).expect("text");
    assert!(
        on_disk.contains("{nothing.there}"),
        "what was written is not lost"
    );
    bench.act(Act::Add(None));
    assert_eq!(
        bench.step_titles().len(),
        1,
        "no step is put beside a mistake"
    );
    bench.act(Act::Body("Two\n\n## two: Two".to_owned()));
    assert!(bench.said().contains('#'), "{}", bench.said());
    bench.undo();
    bench.pause();
    checked(&root);
    assert!(
        bench
            .app
            .compose
            .as_ref()
            .is_some_and(|it| it.problems.is_empty())
    );
}

#[test]
fn a_file_that_another_program_has_changed_is_asked_about_and_not_written() {
    let (mut bench, _folder, root) = begun();
    let path = root.join("en.md");
    let text = fs::read_to_string(&path).expect("text");
    let theirs = text.replace("What happens here?", "By hand");
    fs::write(&path, &theirs).expect("writable");
    let now = || fs::read_to_string(&path).expect("text");
    bench.act(Act::Title("In the window".to_owned()));
    bench.pause();
    assert_eq!(now(), theirs);
    let said = bench.texts();
    assert!(
        said.iter().any(|(text, _)| text.contains("By hand")),
        "it is shown"
    );
    bench.act(Act::Settle(false));
    bench.pause();
    assert_eq!(now(), text.replace("What happens here?", "In the window"));
    fs::write(&path, &theirs).expect("writable");
    bench.app.look_outside();
    bench.act(Act::Settle(true));
    bench.pause();
    assert_eq!(now(), theirs);
    assert_eq!(bench.step_titles(), ["By hand"]);
    bench.undo();
    bench.pause();
    assert!(now().contains("In the window"), "also that can be undone");
    fs::write(&path, &theirs).expect("writable");
    bench.act(Act::Title("Not saved".to_owned()));
    bench.app.leave_composed();
    assert_eq!(now(), theirs);
    let mine = fs::read_to_string(root.join("en.md.mine")).expect("beside it");
    assert!(mine.contains("Not saved"), "nothing is lost");
}

#[test]
fn the_built_in_course_is_copied_first() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let root = folder.path().join("copied");
    let app = App::new(Course::embedded(), Settings::default()).with_platform(Desktop::default());
    let mut bench = Bench::with(app, SIZE);
    bench.command(Command::Open([3, 2]));
    bench.act(Act::Compose);
    assert!(bench.app.compose.is_none() && !bench.said().is_empty());
    let lesson = bench.app.bookmark.lesson().cloned().expect("it is open");
    save(&mut bench, &root);
    assert!(bench.app.composed().is_some(), "{}", bench.said());
    let copied = bench.app.bookmark.lesson().expect("it is open");
    assert_eq!(copied.steps, lesson.steps);
    assert_eq!(
        checked(&root).lessons[0].title(Lang::Es),
        lesson.title(Lang::Es)
    );
    bench.act(Act::Compose);
    assert!(bench.app.compose.is_none());
    let draft = Draft::read(&Folder::new(&root), "copied").expect("it is there");
    let before = Draft::read(&crate::lesson::Embedded, &lesson.id).expect("the course");
    assert_eq!(draft, before, "not a byte has changed");
}
