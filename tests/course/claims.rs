//! What each step shows is said in a sentence of its own, what is to be kept of a lesson on a card, and every translation is made from
//! the English as it is.

use std::collections::BTreeMap;

use clipscope::{
    lesson::{Course, Embedded},
    text::Lang,
};

/// Over a figure a claim has one line; other languages are longer than English.
const LONGEST: [(Lang, usize); 4] = [
    (Lang::En, 78),
    (Lang::ZhCn, 60),
    (Lang::Es, 100),
    (Lang::PtBr, 100),
];

#[test]
fn every_step_has_a_claim_of_its_own() {
    let course = Course::embedded();
    let mut wrong = Vec::new();
    for (lang, longest) in LONGEST {
        let mut known: BTreeMap<&str, String> = BTreeMap::new();
        for lesson in &course.lessons {
            for (idx, step) in lesson.steps.iter().enumerate() {
                let place = format!("{lang} {}/{}", lesson.id, step.id);
                let claim = lesson.step_claim(idx, lang).expect("a step has a title");
                if Some(claim) == lesson.step_title(idx, lang) {
                    wrong.push(format!("{place} claims nothing"));
                }
                let n = claim.chars().count();
                if n > longest {
                    wrong.push(format!("{place}: {n} characters: {claim}"));
                }
                if claim.ends_with(['.', '。']) {
                    wrong.push(format!("{place}: a full stop: {claim}"));
                }
                if let Some(other) = known.insert(claim, place.clone()) {
                    wrong.push(format!("{place} and {other} claim the same"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn what_two_drawings_of_a_step_differ_in_is_named() {
    for lesson in &Course::embedded().lessons {
        for step in &lesson.steps {
            for lang in Lang::ALL {
                let place = format!("{lang} {}/{}", lesson.id, step.id);
                let sides = lesson.step_sides(step, lang);
                assert_eq!(sides.is_some(), step.before.is_some(), "{place}");
                assert!(sides.is_none_or(|[was, is]| was != is), "{place}");
            }
        }
    }
}

#[test]
fn every_lesson_ends_with_a_card() {
    for lesson in &Course::embedded().lessons {
        for lang in Lang::ALL {
            assert!(
                lesson.card(lang).is_some(),
                "{}: no card in {lang}",
                lesson.id
            );
        }
    }
}

#[test]
fn no_translation_is_older_than_its_english() {
    let problems = Course::check(&Embedded).problems;
    let told: Vec<String> = problems
        .iter()
        .map(|it| {
            format!(
                "{} {:?}",
                it.file,
                it.place.as_ref().map(|at| &at.source_line)
            )
        })
        .collect();
    assert!(told.is_empty(), "{told:#?}");
}
