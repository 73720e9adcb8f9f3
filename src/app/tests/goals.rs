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
        let found = smaller(&read.scene, &mut |scene| {
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
