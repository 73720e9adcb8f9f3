//! Moments of every run of the course: an event's words are those of its JSON, and what names a step finds it again.

use clipscope::{
    figure::{Moment, Run, Words},
    lesson::Course,
};
use serde_json::Value as Json;

/// The name first, then all fields that are strings.
fn words_of(event: &Json) -> Words {
    let fields = event.as_object().expect("an event is an object");
    let (name, rest): (Vec<_>, Vec<_>) = fields.iter().partition(|(key, _)| *key == "event");
    let words = name.into_iter().chain(rest);
    words.filter_map(|(_, value)| value.as_str()).collect()
}

fn runs() -> Vec<Box<dyn Run>> {
    let course = Course::embedded();
    let steps = course.lessons.iter().flat_map(|lesson| &lesson.steps);
    steps
        .flat_map(|step| step.scene.document().record())
        .collect()
}

#[test]
fn words_are_those_of_the_json() {
    let mut words = Words::default();
    let mut names = std::collections::BTreeSet::new();
    for run in runs() {
        for step in 1..=run.n_steps() {
            run.read_words(step, &mut words);
            assert_eq!(words, words_of(&run.event_json(step)), "step {step}");
            names.insert(words.name().to_string());
        }
    }
    assert!(names.len() > 30, "{names:?}");
}

#[test]
fn a_moment_finds_its_step_again() {
    for run in runs() {
        assert_eq!(run.moment(0), Moment::Start);
        assert_eq!(run.find(&Moment::End), Some(run.n_steps()));
        for step in (1..=run.n_steps()).step_by(5) {
            let moment = run.moment(step);
            let found = run.find(&moment).expect("the run has that moment");
            // Its words may be among those of an event before it, `enter` among `enter left`.
            assert!(found <= step, "{moment} at {step} is found at {found}");
            assert_eq!(moment.to_string().parse(), Ok(moment));
        }
    }
}
