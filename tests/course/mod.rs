//! Every number of the course's texts comes from a run: as a reference, or from the list under `numbers/`, which is recomputed here.
//! A translation has the references of the English text, and no number besides that the English has not.

mod claims;
mod glossary;
mod order;

use std::{collections::BTreeMap, fs, path::PathBuf};

use clipscope::{
    lesson::{Block, Course, Embedded, Files, Lesson},
    text::Lang,
};

/// Why a numeral may be no reference.
///
/// A *definition* belongs to the rule, whatever the scene; a *name* names something; a *source* is quoted for what it claims; what is
/// *given* the reader is asked to do or to imagine. Of a translation's own numerals, in a table `"step.language"`, a *word* is a digit where
/// the English has a word.
const REASONS: [&str; 4] = ["definition", "name", "source", "given"];

/// Of all numerals of the English course so many in a hundred are references, at least.
const LEAST_SHARE: usize = 80;

/// A piece of a text that is a number, as it was written.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Numeral<'t> {
    at: usize,
    digits: &'t str,
}

/// Runs of digits, with a decimal separator among them or not.
fn numerals(text: &str) -> Vec<Numeral<'_>> {
    let mut found = Vec::new();
    let mut rest = 0;
    while let Some(start) = text[rest..].find(|c: char| c.is_ascii_digit()) {
        let at = rest + start;
        let is_inner = |i: usize, c: char| {
            c.is_ascii_digit()
                || ".,".contains(c) && text[at + i + 1..].starts_with(|c: char| c.is_ascii_digit())
        };
        let mut inner = text[at..].char_indices();
        let end = inner.find(|&(i, c)| !is_inner(i, c));
        let end = end.map_or(text.len(), |(i, _)| at + i);
        let digits = &text[at..end];
        found.push(Numeral { at, digits });
        rest = end;
    }
    found
}

/// What stands between braces, braces included.
fn references(text: &str) -> Vec<(usize, &str)> {
    let within = |[open, close]: [&'static str; 2]| {
        let starts = text.match_indices(open).map(|(at, _)| at);
        starts.filter_map(move |at| Some((at, &text[at..=at + text[at..].find(close)?])))
    };
    // What a link leads to is as little said as what a reference names.
    within(["{", "}"])
        .chain(within(["(control:", ")"]))
        .collect()
}

/// The sections of a text by their ids, title and body in one, without blocks of code.
fn sections(text: &str) -> BTreeMap<&str, String> {
    let mut sections: BTreeMap<&str, String> = BTreeMap::new();
    let mut open = None;
    let mut is_code = false;
    for line in text.lines() {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if line == "## card" {
            // It speaks of the method, and not of a scene: it has no numbers of a run.
            open = None;
        } else if let Some(heading) = line.strip_prefix("## ") {
            let (id, title) = heading.split_once([':', '：']).expect("a heading");
            open = Some(id.trim());
            sections.insert(id.trim(), format!("{title}\n"));
        } else if let Some(id) = open.filter(|_| !is_code) {
            let section = sections.get_mut(id).expect("a section is open");
            section.push_str(line);
            section.push('\n');
        }
    }
    sections
}

fn source(lesson: &Lesson, name: &str) -> String {
    let bytes = Embedded.read(&format!("{}/{name}", lesson.id));
    String::from_utf8(bytes.expect("the course has all files")).expect("UTF-8")
}

/// The list of a lesson: for each step, snippets with what they come to, or why they need not.
fn list(lesson: &Lesson) -> BTreeMap<String, BTreeMap<String, String>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/course/numbers");
    let path = folder.join(format!("{}.toml", lesson.id));
    let text = fs::read_to_string(&path).unwrap_or_default();
    toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// What expressions come to in the texts of a lesson's steps, in English.
fn computed(lesson: &Lesson, expressions: &[(String, String)]) -> Vec<String> {
    let of_step = |id: &str| {
        let own = expressions.iter().filter(|(step, _)| step == id);
        let lines: Vec<String> = own.map(|(_, says)| format!("{{{says}}}\n\n")).collect();
        let lines = lines.concat();
        format!("## {id}: T\n\nNothing.\n\n{lines}")
    };
    let text: String = lesson.steps.iter().map(|step| of_step(&step.id)).collect();
    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    files.insert("a/en.md".to_owned(), format!("# T\n\n{text}").into());
    files.insert(
        "a/lesson.toml".to_owned(),
        source(lesson, "lesson.toml").into(),
    );
    // Files that scenes name, such as meshes.
    for path in Embedded.list().expect("files") {
        if let Some(name) = path.strip_prefix(&format!("{}/", lesson.id)) {
            let bytes = Embedded.read(&path).expect("a file that is listed");
            files.entry(format!("a/{name}")).or_insert(bytes);
        }
    }
    for lang in [Lang::ZhCn, Lang::Es, Lang::PtBr] {
        files.remove(&format!("a/{lang}.md"));
    }
    let course = Course::load(&files).course;
    let [read] = &course.lessons[..] else {
        panic!(
            "{}: the list cannot be read: {:?}",
            lesson.id,
            Course::load(&files).problems
        );
    };
    let mut values = BTreeMap::new();
    for (i, step) in read.steps.iter().enumerate() {
        let text = read.step_text(i, Lang::En).expect("a text a step");
        let lines = text.body.iter().skip(1).map(|block| match block {
            Block::Paragraph(parts) => parts.iter().map(|part| &*part.text).collect::<String>(),
            other => panic!("{other:?} is a paragraph"),
        });
        values.insert(&*step.id, lines.collect::<Vec<_>>().into_iter());
    }
    let next = |(step, _): &(String, String)| values.get_mut(&**step).and_then(Iterator::next);
    expressions.iter().filter_map(next).collect()
}

#[test]
fn every_number_is_a_reference_or_recomputed() {
    let course = Course::embedded();
    let (mut n_referred, mut n_listed) = (0, 0);
    let mut wrong = Vec::new();
    for lesson in &course.lessons {
        let english = source(lesson, "en.md");
        let (raw, filled) = (sections(&english), lesson.filled(&english, Lang::En));
        let filled = sections(&filled);
        let list = list(lesson);
        let unknown = list
            .keys()
            .filter(|key| !raw.contains_key(key.split('.').next().unwrap_or_default()));
        wrong.extend(unknown.map(|step| format!("{}: the list has a step {step}", lesson.id)));
        let mut expressions = Vec::new();
        for (id, text) in &raw {
            let listed = list.get(*id).cloned().unwrap_or_default();
            let spans = references(text);
            let in_reference = |at: usize| {
                spans
                    .iter()
                    .any(|(from, it)| (*from..from + it.len()).contains(&at))
            };
            let left = numerals(text)
                .into_iter()
                .filter(|numeral| !in_reference(numeral.at));
            let left: Vec<Numeral<'_>> = left.collect();
            n_listed += left.len();
            n_referred += numerals(&filled[id]).len() - left.len();
            let is_in = |numeral: &Numeral<'_>, snippet: &str| {
                let mut places = text
                    .match_indices(snippet)
                    .map(|(at, _)| at..at + snippet.len());
                places.any(|place| place.contains(&numeral.at))
            };
            for numeral in &left {
                if !listed.keys().any(|snippet| is_in(numeral, snippet)) {
                    let around = &text[text.floor_char_boundary(numeral.at.saturating_sub(30))..];
                    let around = &around[..around.floor_char_boundary(50)];
                    wrong.push(format!(
                        "{}/{id}: {} in “{around}”",
                        lesson.id, numeral.digits
                    ));
                }
            }
            for (snippet, says) in listed {
                let own: Vec<&Numeral<'_>> = left.iter().filter(|it| is_in(it, &snippet)).collect();
                if own.is_empty() {
                    wrong.push(format!(
                        "{}/{id}: the text has no number “{snippet}”",
                        lesson.id
                    ));
                }
                if !REASONS.contains(&&*says) {
                    expressions.push((snippet, (*id).to_owned(), says));
                } else if says == "name" {
                    wrong.extend(no_such_lesson(&snippet, course.lessons.len()));
                }
            }
        }
        let asked: Vec<(String, String)> = expressions
            .iter()
            .map(|(_, id, says)| (id.clone(), says.clone()))
            .collect();
        let values = computed(lesson, &asked);
        assert_eq!(values.len(), asked.len(), "{}", lesson.id);
        for ((snippet, id, _), value) in expressions.iter().zip(values) {
            let [said, come] = [snippet, &value].map(|text| {
                let digits = numerals(text).into_iter().map(|it| it.digits);
                digits.collect::<Vec<_>>()
            });
            if said != come || !snippet.contains(&value) {
                wrong.push(format!("{}/{id}: “{snippet}” comes to {value}", lesson.id));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    let share = 100 * n_referred / (n_referred + n_listed);
    println!("{n_referred} numerals are references, {n_listed} stand in the list");
    assert!(
        share >= LEAST_SHARE,
        "only {share} % of the numerals are references"
    );
}

/// A lesson that is named by its number exists.
fn no_such_lesson(snippet: &str, n_lessons: usize) -> Option<String> {
    let number = snippet.split("lesson ").nth(1)?;
    let number: usize = numerals(number).first()?.digits.parse().ok()?;
    (!(1..=n_lessons).contains(&number)).then(|| format!("there is no lesson {number}"))
}

/// How often each of these comes.
fn bag<T: Ord>(of: impl IntoIterator<Item = T>) -> BTreeMap<T, usize> {
    let mut bag = BTreeMap::new();
    of.into_iter()
        .for_each(|it| *bag.entry(it).or_default() += 1);
    bag
}

#[test]
fn a_translation_has_the_english_numbers() {
    let mut wrong = Vec::new();
    for lesson in &Course::embedded().lessons {
        let english = source(lesson, "en.md");
        for lang in [Lang::ZhCn, Lang::Es, Lang::PtBr] {
            let translated = source(lesson, &format!("{lang}.md"));
            let translated = sections(&translated);
            let list = list(lesson);
            for (id, text) in sections(&english) {
                let both = [&text, &translated[id]];
                let [own, other] =
                    both.map(|text| bag(references(text).into_iter().map(|it| it.1)));
                if own != other {
                    wrong.push(format!(
                        "{}/{id} in {lang}: {own:?} is {other:?}",
                        lesson.id
                    ));
                }
                let words = list.get(&format!("{id}.{lang}")).into_iter().flatten();
                let words: Vec<&str> = words.map(|(word, _)| &**word).collect();
                let plain = both.map(|text| {
                    let mut spans = references(text);
                    for &word in &words {
                        let places = text.match_indices(word);
                        spans.extend(places.map(|(at, _)| (at, &text[at..at + word.len()])));
                    }
                    let is_plain = |it: &Numeral<'_>| {
                        !spans
                            .iter()
                            .any(|(at, span)| (*at..at + span.len()).contains(&it.at))
                    };
                    let left = numerals(text).into_iter().filter(is_plain);
                    bag(left.map(|it| it.digits.replace(',', ".")))
                });
                if plain[0] != plain[1] {
                    wrong.push(format!(
                        "{}/{id} in {lang}: {:?} is {:?}",
                        lesson.id, plain[0], plain[1]
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
