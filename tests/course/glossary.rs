//! The glossary: complete in four languages, of words that the course uses, and with an entry for every term of the course.

use std::{collections::BTreeMap, sync::LazyLock};

use clipscope::{
    labs::LABS,
    lesson::{Block, Course, Glossary, Inline, glossary},
    text::{AREAS, Catalog, Lang, sources},
};

/// What stands in bold in the English course and is no term: what the eye should rest on.
const EMPHASISED: &[&str] = &[
    "1/d",
    "None",
    "No order exists",
    "One",
    "Switch",
    "Three",
    "Two",
    "ahead",
    "all its signs turn",
    "behind",
    "behind something else",
    "beside",
    "closed",
    "comes in",
    "distance",
    "drawn",
    "dropped",
    "farthest",
    "first",
    "hides a part of C",
    "in front",
    "inside",
    "kept",
    "key",
    "last",
    "lost",
    "one",
    "one triangle",
    "other",
    "over the screen",
    "parallel",
    "points",
    "same",
    "six spaces",
    "skipped",
    "smaller coordinate",
    "smallest t",
    "the same t",
    "the whole triangle has vanished",
    "them",
    "top",
    "triangles",
    "two triangles",
    "−w ≤ x, y, z ≤ w",
    "d₀ = 0",
    "none",
    "three",
    "two",
];

/// The step that teaches each term, `lesson/step`.
pub(super) static TAUGHT: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    let source = include_str!("../../assets/glossary/taught.toml");
    toml::from_str(source).expect("a step for each term")
});

pub(super) fn words(lang: Lang) -> &'static Glossary {
    glossary(lang).expect("a program has all languages")
}

fn inlines(blocks: &[Block]) -> Vec<&Inline> {
    let of_block = |block| match block {
        &Block::Paragraph(ref text)
        | &Block::ListItem { ref text, .. }
        | &Block::Goal { ref text, .. }
        | &Block::Note(ref text) => text.iter().collect(),
        Block::Answer(inner) => inlines(inner),
        Block::Code(_) | Block::Wait => Vec::new(),
    };
    blocks.iter().flat_map(of_block).collect()
}

/// The texts of all steps in a language, in lower case, and which of their words are marked as terms.
fn course(lang: Lang) -> (String, Vec<&'static str>) {
    let course = Course::embedded();
    let (mut all, mut marked) = (String::new(), Vec::new());
    for lesson in &course.lessons {
        for step in 0..lesson.steps.len() {
            let text = lesson.step_text(step, lang).expect("a text a step");
            for part in inlines(&text.body) {
                all += &part.text.to_lowercase();
                marked.extend(part.term.map(|word| &*word.says));
            }
            all += "\n";
        }
    }
    (all, marked)
}

#[test]
fn every_term_has_a_sentence_in_four_languages_and_is_marked_in_the_course() {
    let mut wrong = Vec::new();
    for lang in Lang::ALL {
        let (text, marked) = course(lang);
        let mut owners: BTreeMap<String, &str> = BTreeMap::new();
        let words = words(lang);
        if !words.keys().eq(TAUGHT.keys()) {
            wrong.push(format!("{lang} has other terms than are taught"));
        }
        for (id, word) in words {
            for form in &word.forms {
                if let Some(other) = owners.insert(form.to_lowercase(), id) {
                    wrong.push(format!("“{form}” is {other} and {id} in {lang}"));
                }
                if !text.contains(&form.to_lowercase()) {
                    wrong.push(format!("no text in {lang} says “{form}” of {id}"));
                }
            }
            if !marked.contains(&&*word.says) {
                wrong.push(format!("{id} is marked nowhere in {lang}"));
            }
            if !word.says.ends_with(['.', '。']) {
                wrong.push(format!("{id} has no sentence in {lang}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_term_of_the_course_has_an_entry() {
    let forms: Vec<String> = words(Lang::En)
        .values()
        .flat_map(|word| &word.forms)
        .map(|form| form.to_lowercase())
        .collect();
    let is_known = |text: &str| {
        let text = text.to_lowercase();
        forms.iter().any(|form| text.contains(&**form))
    };
    let mut without = Vec::new();
    for lesson in &Course::embedded().lessons {
        for step in 0..lesson.steps.len() {
            let text = lesson.step_text(step, Lang::En).expect("a text a step");
            let mut bold = String::new();
            for part in inlines(&text.body).into_iter().chain([&Inline::default()]) {
                if part.strong {
                    bold += &part.text;
                    continue;
                }
                let phrase = std::mem::take(&mut bold);
                if !phrase.is_empty() && !is_known(&phrase) && !EMPHASISED.contains(&&*phrase) {
                    without.push(format!("{}: {phrase}", lesson.id));
                }
            }
        }
    }
    // What is taught has an entry, mistakes and proofs aside.
    for lab in LABS {
        let methods = (lab.methods)().into_iter();
        for card in methods.filter(|card| !card.is_faulty && !card.is_proof) {
            let name = Catalog::of(Lang::En).term(card.name_key);
            if !is_known(&name) {
                without.push(format!("{}: {name}", lab.id));
            }
        }
    }
    without.sort_unstable();
    without.dedup();
    assert!(without.is_empty(), "{without:#?}");
}

/// Every message and every lesson's file, with where it is said.
fn said(lang: Lang) -> Vec<(String, String)> {
    let messages = AREAS.iter().zip(sources(lang)).flat_map(|(area, source)| {
        let lines = source.lines().filter(|line| !line.starts_with('#'));
        lines.map(move |line| (format!("{area}.ftl"), line.to_lowercase()))
    });
    let course = Course::embedded();
    let lessons = course.lessons.iter().flat_map(|lesson| {
        (0..lesson.steps.len()).map(move |step| {
            let text = lesson.step_text(step, lang).expect("a text a step");
            let words: String = inlines(&text.body).iter().map(|it| &*it.text).collect();
            let place = format!("{}, step {}", lesson.id, step + 1);
            (place, format!("{}\n{words}", text.title).to_lowercase())
        })
    });
    messages.chain(lessons).collect()
}

#[test]
fn no_text_says_what_must_not_be_said() {
    let mut wrong = Vec::new();
    for lang in Lang::ALL {
        let said = said(lang);
        for never in words(lang).values().flat_map(|word| &word.never) {
            let found = said.iter().filter(|(_, text)| text.contains(never));
            wrong.extend(found.map(|(place, _)| format!("{lang} {place}: “{never}”")));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
