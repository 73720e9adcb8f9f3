//! Nothing is used before it is taught: each term of the glossary names the step that teaches it, and none before says it.

use clipscope::{
    lesson::{Block, Course, Lesson},
    text::Lang,
};

use super::glossary::{TAUGHT, words};

/// A sentence that looks ahead says so in one of these words.
const AHEAD: &[&str] = &["later", "lesson"];
/// More of them, and the course is in another order than its words.
const MOST_AHEAD: usize = 10;

fn said(blocks: &[Block], all: &mut Vec<String>) {
    for block in blocks {
        match block {
            Block::Paragraph(text) | Block::ListItem { text, .. } | Block::Goal { text, .. } => {
                let text: String = text.iter().map(|part| &*part.text).collect();
                // A dot between digits ends nothing, but then no term stands in either half.
                let sentences = text.split_inclusive(['.', '?', '!']);
                all.extend(sentences.map(str::to_owned));
            }
            Block::Answer(inner) => said(inner, all),
            Block::Code(_) | Block::Note(_) | Block::Wait => {}
        }
    }
}

fn sentences(lesson: &Lesson, step: usize) -> Vec<String> {
    let text = lesson.step_text(step, Lang::En).expect("a text a step");
    let mut all = vec![text.title.clone()];
    all.extend(text.claim.clone());
    all.extend(text.sides.iter().flatten().cloned());
    said(&text.body, &mut all);
    all
}

fn holds(sentence: &str, form: &str) -> bool {
    let (sentence, form) = (sentence.to_lowercase(), form.to_lowercase());
    let is_letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
    sentence.match_indices(&form).any(|(at, _)| {
        let after = &sentence[at + form.len()..];
        !is_letter(sentence[..at].chars().next_back()) && !is_letter(after.chars().next())
    })
}

#[test]
fn no_term_is_used_before_the_step_that_teaches_it() {
    let course = Course::embedded();
    let places: Vec<(&Lesson, usize)> = course
        .lessons
        .iter()
        .flat_map(|lesson| (0..lesson.steps.len()).map(move |step| (lesson, step)))
        .collect();
    let (mut wrong, mut n_ahead) = (Vec::new(), 0);
    let words = words(Lang::En);
    for (id, taught) in TAUGHT.iter() {
        let place = taught.split_once('/').and_then(|(lesson, step)| {
            let lesson = course.lesson(lesson)?;
            let is_it =
                |(of, at): &(&Lesson, usize)| of.id == lesson.id && of.steps[*at].id == step;
            places.iter().position(is_it)
        });
        let Some(place) = place else {
            wrong.push(format!("{id} is taught in no step “{taught}”"));
            continue;
        };
        let forms = &words[id].forms;
        let said = |(lesson, step): &(&Lesson, usize)| {
            let all = sentences(lesson, *step);
            let mut words = forms.iter().filter(|form| form.chars().count() > 1);
            words.any(|form| all.iter().any(|sentence| holds(sentence, form)))
        };
        if !said(&places[place]) {
            wrong.push(format!("{taught} does not say {id}"));
        }
        for (lesson, step) in &places[..place] {
            for sentence in sentences(lesson, *step) {
                let mut words = forms.iter().filter(|form| form.chars().count() > 1);
                if !words.any(|form| holds(&sentence, form)) {
                    continue;
                }
                if AHEAD
                    .iter()
                    .any(|word| sentence.to_lowercase().contains(word))
                {
                    n_ahead += 1;
                } else {
                    let step = &lesson.steps[*step].id;
                    wrong.push(format!("{}/{step} says {id}: {sentence}", lesson.id));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(n_ahead <= MOST_AHEAD, "{n_ahead} sentences look ahead");
}
