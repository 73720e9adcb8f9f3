//! Steps and goals of a lesson that is made, as they come, go and change places.

use std::fs;

use super::{
    super::{compose::Act, *},
    begun, checked,
};

#[test]
fn whoever_steps_on_and_adds_a_step_leaves_the_open_one_where_it_stood() {
    let (mut bench, _folder, root) = begun();
    bench.command(Command::FIRST);
    bench.pause();
    bench.act(Act::Title("One".to_owned()));
    bench.pause();
    bench.command(Command::Step(1));
    bench.pause();
    bench.command(Command::Step(1));
    bench.pause();
    let at = |root: &Path| {
        let course = checked(root);
        let steps = &course.lessons[0].steps;
        steps.iter().map(|step| step.position()).collect::<Vec<_>>()
    };
    assert_eq!(
        at(&root),
        [Some(2)],
        "it follows the timeline while it is open"
    );
    bench.press(Key::Enter, ctrl());
    bench.pause();
    assert_eq!(at(&root), [Some(0), Some(2)]);
    bench.undo();
    bench.pause();
    assert_eq!(at(&root), [Some(2)], "both are undone as one");
    bench.press(Key::Y, ctrl());
    bench.pause();
    // What was done besides is where the step is to stand.
    bench.command(Command::Step(1));
    bench.pause();
    bench.act(Act::Title("Two".to_owned()));
    bench.pause();
    bench.command(Command::LAST);
    bench.pause();
    bench.act(Act::Add(None));
    bench.pause();
    let last = bench.n_steps();
    assert_eq!(at(&root), [Some(0), Some(3), Some(last)]);
}

#[test]
fn a_row_is_dragged_to_its_place_and_escape_leaves_it() {
    let (mut bench, _folder, root) = begun();
    bench.ctx.enable_accesskit();
    for title in ["A", "B", "C"] {
        if title != "A" {
            bench.act(Act::Add(None));
        }
        bench.act(Act::Title(title.to_owned()));
        bench.pause();
    }
    let row = |bench: &Bench, title: &str| {
        let is_it = |(name, _): &&(String, Rect)| name.contains(&format!(", {title}, at "));
        bench
            .names
            .iter()
            .find(is_it)
            .expect("it is listed")
            .1
            .center()
    };
    bench.settle();
    let [a, c] = ["A", "C"].map(|title| row(&bench, title));
    bench.drag(a, c + vec2(0.0, 12.0));
    bench.pause();
    assert_eq!(bench.step_titles(), ["B", "C", "A"]);
    bench.settle();
    let (a, b) = (row(&bench, "A"), row(&bench, "B"));
    bench.drag(a, b - vec2(0.0, 12.0));
    bench.pause();
    assert_eq!(bench.step_titles(), ["A", "B", "C"]);
    bench.settle();
    let (b, c) = (row(&bench, "B"), row(&bench, "C"));
    bench.point(b);
    bench.button(b, true);
    bench.point(c + vec2(0.0, 12.0));
    bench.frame(0.1, vec![key_event(Key::Escape, true, Modifiers::NONE)]);
    bench.button(c + vec2(0.0, 12.0), false);
    bench.pause();
    assert_eq!(bench.step_titles(), ["A", "B", "C"]);
    bench.undo();
    bench.pause();
    assert_eq!(bench.step_titles(), ["B", "C", "A"]);
    checked(&root);
}

#[test]
fn steps_in_one_list_are_taken_and_written_as_tables_with_the_first_change() {
    let (mut bench, _folder, root) = begun();
    bench.act(Act::Add(None));
    bench.act(Act::Compose);
    let path = root.join("lesson.toml");
    let text = fs::read_to_string(&path).expect("text");
    let (head, steps) = text.split_at(text.find("[[step]]").expect("steps"));
    let steps: Vec<String> = steps
        .split("[[step]]")
        .skip(1)
        .map(|step| format!("{{{}}}", step.trim().replace('\n', ", ")))
        .collect();
    let at = head.find("\n\n").expect("a head");
    let listed = format!(
        "{}\nstep = [{}]{}",
        &head[..at],
        steps.join(", "),
        &head[at..]
    );
    fs::write(&path, &listed).expect("writable");
    let before = checked(&root);
    bench.app.read_course_again(0.0);
    bench.settle();
    bench.act(Act::Compose);
    assert!(bench.app.composed().is_some(), "{}", bench.said());
    bench.pause();
    bench.act(Act::Compose);
    let now = || fs::read_to_string(&path).expect("text");
    assert_eq!(now(), listed, "nothing was changed");
    bench.act(Act::Compose);
    bench.act(Act::Title("Changed".to_owned()));
    bench.pause();
    assert!(
        now().contains("[[step]]") && !now().contains("step = ["),
        "{}",
        now()
    );
    assert_eq!(checked(&root).lessons[0].steps, before.lessons[0].steps);
}

#[test]
fn a_goal_that_goes_takes_its_scene_along_unless_that_is_shown() {
    let (mut bench, _folder, root) = begun();
    let toml = || fs::read_to_string(root.join("lesson.toml")).expect("text");
    bench.act(Act::Goal(true));
    bench.pause();
    assert!(toml().contains("-reached]"), "{}", toml());
    bench.act(Act::Goal(false));
    bench.pause();
    assert!(!toml().contains("-reached"), "{}", toml());
    bench.act(Act::Goal(true));
    let handles = bench.document().handles();
    bench.edit(Edit::Drag(handles[0], [-3.0, -3.0, 0.0]));
    bench.edit(Edit::Drag(handles[1], [-3.0, 3.0, 0.0]));
    bench.pause();
    let name = toml();
    let name = name
        .split("reached = \"")
        .nth(1)
        .and_then(|it| it.split('"').next());
    let name = name.map(str::to_owned);
    bench.act(Act::Add(None));
    let shows = name.map(|name| format!("\"{name}\""));
    bench.act(Act::Set("scene", shows));
    bench.pause();
    let [course, step] = bench.app.bookmark.at;
    bench.command(Command::Open([course, step - 1]));
    bench.act(Act::Goal(false));
    bench.pause();
    assert!(toml().contains("-reached]"), "{}", toml());
}

#[test]
fn a_goal_can_be_what_decides() {
    use crate::lesson::Goal;
    for lab in ["lines", "polygons", "frustum", "surfaces"] {
        let bench = Bench::lab(lab);
        let offered = Goal::offered(bench.app.scene());
        assert!(!offered.is_empty(), "{lab}");
    }
    let bench = Bench::lab("lines");
    let offered = Goal::offered(bench.app.scene());
    let is_decisive = |part: &&String| part.starts_with("event.") && part.contains(" @ ");
    assert!(offered.iter().any(|part| is_decisive(&part)), "{offered:?}");
}

#[test]
fn a_goal_is_dragged_on_a_scene_of_its_own() {
    let (mut bench, _folder, root) = begun();
    bench.act(Act::Add(None));
    bench.pause();
    let scene = |course: &Course, nth: usize| course.lessons[0].steps[nth].scene.clone();
    let before = checked(&root);
    assert!(scene(&before, 0) == scene(&before, 1), "both show one");
    bench.act(Act::Goal(true));
    let handles = bench.document().handles();
    bench.edit(Edit::Drag(handles[0], [-3.0, -3.0, 0.0]));
    bench.edit(Edit::Drag(handles[1], [-3.0, 3.0, 0.0]));
    bench.pause();
    let after = checked(&root);
    assert!(scene(&after, 0) == scene(&before, 0), "as it was");
    assert!(scene(&after, 1) != scene(&before, 1), "dragged");
}
