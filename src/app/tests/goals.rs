//! Each goal can be reached with what is unlocked, and is not at first.

use super::*;

/// Drags what is elsewhere in `there` to where it is there, as far as nothing is locked.
fn dragged(step: &LessonStep, there: &Scene) -> Scene {
    let mut scene = (*step.scene).clone();
    let handles = scene.document().handles();
    let locks = step.locks_in(&scene, &handles).to_vec();
    for handle in handles {
        let to = there.document().position(handle);
        let is_locked = Lock::any_holds(&locks, handle);
        if let Some(to) = to.filter(|to| scene.document().position(handle) != Some(*to))
            && !is_locked
        {
            let _ = scene.document_mut().drag(handle, to);
        }
    }
    scene
}

#[test]
fn every_goal_is_reached_by_drags_of_what_is_unlocked() {
    let course = Course::embedded();
    for lesson in &course.lessons {
        for step in &lesson.steps {
            let Some(goal) = &step.goal else { continue };
            let at = format!("{} {}", lesson.id, step.id);
            assert!(
                goal.met_by(&step.scene).contains(&false),
                "{at}: met at first"
            );
            let reached = dragged(step, &goal.reached);
            let met = goal.met_by(&reached);
            assert!(met.iter().all(|is_met| *is_met), "{at}: {met:?}");
        }
    }
}

#[test]
fn a_goal_that_is_reached_is_marked_and_stays_so() {
    let course = Course::embedded();
    let with_goal = course.lessons.iter().enumerate().find_map(|(i, lesson)| {
        let step = lesson.steps.iter().position(|step| step.goal.is_some())?;
        Some([i, step])
    });
    let at = with_goal.expect("a lesson has a goal");
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open(at));
    let step = bench.app.bookmark.step().expect("it is open").clone();
    let lesson = bench.app.bookmark.lesson().expect("it is open").clone();
    assert!(!bench.app.is_reached());
    assert_eq!(bench.app.reached_of(&lesson, &step), Some(false));
    let goal = step.goal.as_ref().expect("it has one");
    bench.edit(Edit::Replace((*goal.reached).clone()));
    assert!(bench.app.is_reached());
    assert_eq!(bench.app.reached_of(&lesson, &step), Some(true));
    bench.key(Key::R);
    assert!(!bench.app.is_reached());
    assert_eq!(
        bench.app.reached_of(&lesson, &step),
        Some(true),
        "a mark is not taken off"
    );
}

#[test]
fn a_difference_is_made_smaller_and_stays_the_same() {
    use crate::labs::{Difference, smaller};
    let text = r#"
        method = "sutherland-hodgman"
        compare = "FAULTY"
        window = [-4, -3, 4, 3]
        polygon = [[-6.3, 0.2], [-5.1, -4.4], [0.7, -3.7], [5.2, -1.1], [4.9, 2.2], [1.3, 5.6], [-1.7, 3.9], [-2.2, 2.1]]
    "#;
    let formats = crate::lesson::SceneFormats::standard();
    let mut n_differ = 0;
    for card in (crate::labs::LABS[1].methods)()
        .iter()
        .filter(|card| card.is_faulty)
    {
        let text = text.replace("FAULTY", card.id);
        let Ok(read) = formats.read("", text.as_bytes()) else {
            continue;
        };
        let Some(kind) = Difference::kind_in(&read.scene) else {
            continue;
        };
        n_differ += 1;
        let mut n_runs = 0;
        let found = smaller(&read.scene, &|_| true, &mut |scene| {
            n_runs += 1;
            Difference::kind_in(scene).as_ref() == Some(&kind)
        });
        let found = found.expect("eight vertices are not needed");
        assert_eq!(Difference::kind_in(&found), Some(kind), "{}", card.id);
        assert!(
            found.document().size() < read.scene.document().size(),
            "{}",
            card.id
        );
        assert!(n_runs <= 3_000, "{}: {n_runs}", card.id);
    }
    assert!(n_differ > 1, "{n_differ}");
}

/// The first step of the course with a goal, opened.
fn with_a_goal() -> Bench {
    let course = Course::embedded();
    let with_goal = course.lessons.iter().enumerate().find_map(|(i, lesson)| {
        let step = lesson.steps.iter().position(|step| step.goal.is_some())?;
        Some([i, step])
    });
    let mut bench = Bench::course(SIZE);
    bench.ctx.enable_accesskit();
    bench.command(Command::Open(with_goal.expect("a lesson has a goal")));
    bench
}

#[test]
fn a_hint_comes_in_two_parts_which_are_marked_as_seen_and_cost_nothing() {
    let mut bench = with_a_goal();
    let step = bench.app.bookmark.step().expect("it is open").clone();
    let lesson = bench.app.bookmark.lesson().expect("it is open").clone();
    let hints = |bench: &Bench| {
        let mark = bench.app.settings.progress.mark(&lesson.id, &step.id);
        mark.map_or(0, |mark| mark.hints)
    };
    assert_eq!(hints(&bench), 0);
    for seen in [1, 2, 2] {
        bench.key(Key::T);
        assert_eq!((bench.app.goals.help.n_shown, hints(&bench)), (seen, seen));
    }
    let hint = bench.app.goals.help.hint.clone();
    let decides = hint.decides.expect("its run decides something");
    let decides = Catalog::of(Lang::En).message(&decides);
    bench.frame(0.1, Vec::new());
    let is_said = |(name, _): &(String, Rect)| *name == decides;
    assert!(bench.names.iter().any(is_said), "{decides}");
    let goal = step.goal.as_ref().expect("it has one");
    bench.edit(Edit::Replace((*goal.reached).clone()));
    assert_eq!(bench.app.reached_of(&lesson, &step), Some(true));
    assert_eq!(hints(&bench), 2);
    bench.key(Key::PageUp);
    assert_eq!(bench.app.goals.help.n_shown, 0, "another step has its own");
}

#[test]
fn where_runs_ended_is_counted_once_the_drag_is_over() {
    let mut bench = with_a_goal();
    let ended = |bench: &Bench| -> Vec<(usize, bool)> {
        let ended = bench.app.goals.help.ended.iter();
        ended.map(|it| (it.count, it.is_now)).collect()
    };
    assert_eq!(ended(&bench), [], "the step's own run is nobody's");
    let goal = bench.app.bookmark.step().and_then(|step| step.goal.clone());
    let reached = goal.expect("it has one").reached;
    bench.edit(Edit::Replace((*reached).clone()));
    bench.frame(0.1, Vec::new());
    assert_eq!(ended(&bench), [(1, true)]);
    bench.command(Command::Undo);
    bench.frame(0.1, Vec::new());
    let all: usize = ended(&bench).iter().map(|(count, _)| count).sum();
    let now: Vec<_> = ended(&bench)
        .into_iter()
        .filter(|(_, is_now)| *is_now)
        .collect();
    assert_eq!((all, now.len()), (2, 1));
}

#[test]
fn every_mistake_is_exposed_by_a_scene_of_the_course() {
    use crate::labs::LABS;
    let course = Course::embedded();
    let steps = course.lessons.iter().flat_map(|lesson| &lesson.steps);
    let mut exposed = std::collections::BTreeSet::new();
    for step in steps {
        let reached = step.goal.iter().map(|goal| &*goal.reached);
        for scene in std::iter::once(&*step.scene).chain(reached) {
            let methods = scene.document().methods();
            if !methods
                .iter()
                .any(|card| card.is_faulty && !exposed.contains(card.id))
            {
                continue;
            }
            for (card, run) in methods.iter().zip(scene.document().record()) {
                if card.is_faulty && run.differs_at().is_some() {
                    exposed.insert(card.id);
                }
            }
        }
    }
    let all = LABS.iter().flat_map(|lab| (lab.methods)());
    let hidden = all.filter(|card| card.is_faulty && !exposed.contains(card.id));
    let hidden: Vec<&str> = hidden.map(|card| card.id).collect();
    assert!(
        hidden.is_empty(),
        "nothing shows that these are wrong: {hidden:?}"
    );
}

#[test]
fn a_search_for_a_smaller_scene_can_be_stopped_and_what_it_found_stays() {
    // Up and down along the top, and back below.
    let across = |i: i32| 0.613 * f64::from(i) - 6.13;
    let above = (0..20).map(|i| [across(20 - i), if i % 2 == 0 { 5.37 } else { 1.71 }]);
    let below = (0..20).map(|i| [across(i), if i % 2 == 0 { -5.21 } else { -1.43 }]);
    let ring = above.chain(below).map(|[x, y]| format!("[{x:.3}, {y:.2}]"));
    let ring: Vec<String> = ring.collect();
    let text = format!(
        "method = \"faulty-open\"\ncompare = \"sutherland-hodgman\"\nwindow = [-4, -3, 4, 3]\npolygon = [{}]\n",
        ring.join(", ")
    );
    let read = crate::lesson::SceneFormats::standard().read("", text.as_bytes());
    let scene = read.expect("a scene").scene;
    let mut bench = Bench::lab("polygons");
    bench.edit(Edit::Replace(scene.clone()));
    let kind = crate::labs::Difference::kind_in(bench.app.scene());
    assert!(kind.is_some());
    bench.apply(Command::Smaller);
    if bench.app.is_making_smaller() {
        bench.apply(Command::Cancel);
    }
    let begun = std::time::Instant::now();
    while bench.app.is_making_smaller() {
        bench.frame(0.01, Vec::new());
        assert!(begun.elapsed().as_secs() < 60, "stopped, it ends");
    }
    assert_eq!(crate::labs::Difference::kind_in(bench.app.scene()), kind);
    // To its end, and undone at once.
    bench.edit(Edit::Replace(scene.clone()));
    bench.command(Command::Smaller);
    while bench.app.is_making_smaller() {
        bench.frame(0.01, Vec::new());
    }
    assert!(bench.document().size() < scene.document().size());
    assert_eq!(crate::labs::Difference::kind_in(bench.app.scene()), kind);
    bench.undo();
    assert!(*bench.app.scene() == scene);
}

#[test]
fn hunts_by_their_answers_stay_found_when_they_are_made_smaller() {
    for (lesson, step) in [
        ("18-what-is-wrong-here", "hunt-answer"),
        ("18-what-is-wrong-here", "hunt-empty"),
        ("26-culled-by-mistake", "hunt-side"),
        ("26-culled-by-mistake", "hunt-faces"),
        ("30-one-polygon", "hunt-pieces"),
        ("32-before-the-divide", "hunt-image"),
    ] {
        let mut bench = Bench::course(SIZE);
        bench.open_step(lesson, step);
        assert!(!bench.app.is_reached(), "{step}");
        let open = bench.app.bookmark.step().expect("it is there").clone();
        assert_eq!(open.id, step);
        let goal = open.goal.expect("a hunt is a goal");
        bench.edit(Edit::Replace((*goal.reached).clone()));
        assert!(bench.app.is_reached(), "{step}");
        bench.command(Command::Smaller);
        let begun = std::time::Instant::now();
        while bench.app.is_making_smaller() {
            bench.frame(0.01, Vec::new());
            assert!(begun.elapsed().as_secs() < 120, "{step}");
        }
        assert!(bench.app.is_reached(), "{step}: what was found is lost");
    }
}

#[test]
fn a_hint_says_which_part_is_open_and_its_numbers_first() {
    let mut bench = Bench::course(SIZE);
    bench.ctx.enable_accesskit();
    bench.open_step("29-plane-by-plane", "one-piece");
    bench.key(Key::T);
    bench.frame(0.1, Vec::new());
    let said = "“One triangle is left”: now 2, wanted 1.";
    let is_said = |(name, _): &(String, Rect)| name == said;
    assert!(bench.names.iter().any(is_said), "{:?}", bench.names);
    bench.key(Key::T);
    bench.frame(0.1, Vec::new());
    let way = "One solution moves only: Given vertex V₁.";
    let is_said = |(name, _): &(String, Rect)| name == way;
    assert!(bench.names.iter().any(is_said), "{:?}", bench.names);
}

#[test]
fn a_hunt_shows_no_costs_on_the_stage_until_it_is_solved() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("34-the-nearer-wins", "hunt-pixel");
    let has_costs = |bench: &Bench| {
        let mut views = bench
            .app
            .playback
            .on_stage()
            .iter()
            .flat_map(|it| &it.views);
        views.any(|view| matches!(view.body, crate::figure::Body::Costs(_)))
    };
    assert!(
        !has_costs(&bench),
        "they would tell that the programs differ"
    );
    bench.edit(Edit::Replace(bench.solution()));
    bench.frame(0.1, Vec::new());
    assert!(bench.app.is_reached() && has_costs(&bench));
}
