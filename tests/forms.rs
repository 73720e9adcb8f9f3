//! Messages with the values that grammar stumbles over: none, one and many things, decimals, names in another script.

use std::collections::BTreeSet;

use clipscope::{
    lesson::{Course, Embedded, Files},
    text::{AREAS, Catalog, Lang, Message, Value, sources},
};

use crate::messages::messages;

/// Languages that tell one thing from several.
const WITH_PLURALS: [Lang; 3] = [Lang::En, Lang::Es, Lang::PtBr];
/// What is counted here is never one: limits, vertices of polygons, sides of a picture, planes of a volume.
const NEVER_ONE: [&str; 65] = [
    "why-fence-nothing",
    "why-row-middle",
    "case-tints-length",
    "refused-too-many-faces",
    "box-done-in-vain",
    "box-outside",
    "case-bsp-too-large",
    "case-over-budget",
    "case-picture-side",
    "case-too-many",
    "case-too-many-fragments",
    "case-too-many-pairs",
    "case-too-many-pixels",
    "case-too-many-raster-pixels",
    "case-too-many-steps",
    "case-uv-length",
    "case-wrong-length",
    "case-wrong-points",
    "culling-best-changes",
    "depth-opening",
    "ear-cut",
    "ear-opening",
    "ear-round",
    "error-too-many-objects",
    "ht-divide",
    "ht-opening",
    "occlusion-opening",
    "painter-done-cycle",
    "pat-none",
    "pat-three",
    "pat-two",
    "picture-broken",
    "pipe-opening",
    "pipeline-screen",
    "plane-from-matrix",
    "problem-face-too-long",
    "problem-goal-parts",
    "problem-long-paragraph",
    "problem-mesh-too-large",
    "problem-too-many-faces",
    "problem-too-many-lessons",
    "problem-too-many-steps",
    "problem-too-many-texels",
    "raster-depth-steps",
    "raster-line",
    "raster-line-error",
    "ray-opening",
    "sh-done-cut",
    "sh-done-degenerate",
    "sh-done-empty",
    "sh-done-whole",
    "sh-opening",
    "surface-costs-about",
    "surface-costs-fragments",
    "surface-costs-overdraw",
    "surface-costs-pairs",
    "surface-costs-questions",
    "surfaces-first",
    "tac-opening",
    "tac-piece",
    "tally-same",
    "wa-closed-hole",
    "wa-closed-outer",
    "wa-closed-sliver",
    "wa-opening",
];

/// What ends as a plural does, and is none.
const NO_NOUNS: [&str; 7] = ["as", "crosses", "das", "dos", "es", "faces", "lies"];

/// Every message of a language with each variable of this value.
fn said(lang: Lang, value: &Value) -> Vec<(String, String)> {
    let all = sources(Lang::En).into_iter().flat_map(messages);
    let said = all.map(|(key, variables)| {
        let mut message = Message::new(String::leak(key));
        for name in variables {
            message = message.with(String::leak(name), value.clone());
        }
        (message.key.to_owned(), Catalog::of(lang).message(&message))
    });
    said.collect()
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split([' ', '\u{a0}', '\u{202f}', '\n'])
}

/// What stands after each `1`.
fn after_one(text: &str) -> impl Iterator<Item = &str> {
    let pairs = words(text).zip(words(text).skip(1));
    let after = pairs.filter(|(word, _)| word.trim_start_matches(['(', '[']) == "1");
    after.map(|(_, noun)| noun.trim_end_matches([',', '.', ':', ';', ')']))
}

/// A plural is a word of which some message says the singular after `1`.
#[test]
fn one_thing_is_no_plural() {
    let mut faults = Vec::new();
    for lang in WITH_PLURALS {
        let said = said(lang, &Value::Count(1));
        let ones: BTreeSet<&str> = said.iter().flat_map(|(_, text)| after_one(text)).collect();
        let is_plural = |noun: &&str| {
            let endings = ["s", "es"].into_iter();
            let mut singular = endings.filter_map(|ending| noun.strip_suffix(ending));
            !NO_NOUNS.contains(noun) && singular.any(|it| ones.contains(it))
        };
        for (key, text) in &said {
            let plural = after_one(text).find(is_plural);
            if let Some(noun) = plural.filter(|_| !NEVER_ONE.contains(&&**key)) {
                faults.push(format!("{lang} {key}: 1 {noun} in “{text}”"));
            }
        }
    }
    assert!(
        faults.is_empty(),
        "{} of\n{}",
        faults.len(),
        faults.join("\n")
    );
}

/// Where a message says nothing of its own of no things.
#[test]
fn no_things_are_said_as_five_are() {
    let mut faults = Vec::new();
    for lang in WITH_PLURALS {
        let texts: String = sources(lang).concat();
        let [none, five] = [0, 5].map(|n| said(lang, &Value::Count(n)));
        for ((key, none), (_, five)) in none.into_iter().zip(five) {
            if none.replace('0', "5") != five.replace('0', "5") && !has_form(&texts, &key, "[0]") {
                faults.push(format!("{lang} {key}: “{none}”, “{five}”"));
            }
        }
    }
    assert!(
        faults.is_empty(),
        "{} of\n{}",
        faults.len(),
        faults.join("\n")
    );
}

/// Does a message have a form of its own for this number?
fn has_form(texts: &str, key: &str, form: &str) -> bool {
    let start = format!("\n{key} =");
    let message = format!("\n{texts}")
        .split_once(&start)
        .map(|(_, rest)| rest.to_owned());
    message.is_some_and(|rest| {
        let lines = rest.lines().enumerate();
        let mut own =
            lines.take_while(|(i, line)| *i == 0 || line.starts_with(' ') || line.is_empty());
        own.any(|(_, line)| line.contains(form))
    })
}

/// `1,5, 2,5` could be four numbers: so is no text of a lesson written, with its numbers filled in.
#[test]
fn no_comma_follows_a_decimal_comma() {
    let is_list = |text: &str| {
        let mut parts = text.split(", ").zip(text.split(", ").skip(1));
        parts.any(|(before, after)| {
            let number = before.rsplit([' ', '(']).next().unwrap_or_default();
            let is_decimal = number.split_once(',').is_some_and(|(whole, part)| {
                let digits =
                    |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
                digits(whole.trim_start_matches('−')) && digits(part)
            });
            is_decimal && after.starts_with(|c: char| c.is_ascii_digit() || c == '−')
        })
    };
    assert!(is_list("de 1,3, 4,5") && !is_list("de 1,3; 4,5") && !is_list("P₁, 2"));
    let course = Course::embedded();
    for lesson in &course.lessons {
        for lang in [Lang::Es, Lang::PtBr] {
            let source = Embedded.read(&format!("{}/{lang}.md", lesson.id));
            let source = String::from_utf8(source.expect("a file")).expect("UTF-8");
            let filled = lesson.filled(&source, lang);
            let found: Vec<&str> = filled.lines().filter(|line| is_list(line)).collect();
            assert!(found.is_empty(), "{} {lang}: {found:#?}", lesson.id);
        }
    }
}

#[test]
fn chinese_keeps_latin_letters_and_digits_apart() {
    let is_han = |c: char| ('\u{4e00}'..='\u{9fff}').contains(&c);
    let is_latin = |c: char| c.is_alphanumeric() && !is_han(c);
    let mut faults = Vec::new();
    for (key, text) in said(Lang::ZhCn, &Value::Name("H₁".to_owned())) {
        let next = text.chars().skip(1);
        let mut pairs = text.chars().zip(next);
        if pairs.any(|(a, b)| is_han(a) && is_latin(b) || is_latin(a) && is_han(b)) {
            faults.push(format!("{key}: {text}"));
        }
    }
    assert!(
        faults.is_empty(),
        "{} of {}\n{}",
        faults.len(),
        AREAS.len(),
        faults.join("\n")
    );
}
