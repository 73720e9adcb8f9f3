//! Texts with references: what they are filled with, and each mistake in one with its place.

use crate::text::{Catalog, Lang};

use super::*;

const SCENES: &str = r#"lab = "lines"
source = "Liang and Barsky, 1984"

[scenes.practice]
method = "liang-barsky"
compare = "brute-force"
window = [-1, -1, 1, 1]
segments = [[-2, -1, 2, 1.5]]

[scenes.farther]
like = "practice"
segments.0.0 = -3

[scenes.upright]
like = "farther"
compare = "cyrus-beck"
segments.0 = { 0 = 0.5, 2 = 0.5 }

[[step]]
id = "first"
scene = "practice"
at = "enter left"
"#;

fn lesson_saying(text: &str) -> Memory {
    with(
        SCENES,
        &format!("# Intervals\n\n## first: Title\n\n{text}\n"),
    )
}

/// What is wrong with it, but for scenes that the text does not name.
fn wrong(files: &Memory) -> Vec<String> {
    let mut found = found(files);
    found.retain(|line| !line.ends_with("unused-scene"));
    found
}

/// The paragraph as a reader of this language sees it.
fn filled(text: &str, lang: Lang) -> String {
    let files = lesson_saying(text);
    assert_eq!(wrong(&files), [""; 0], "{text}");
    let lesson = &Course::check(&files).course.lessons[0];
    let step = lesson.step_text(0, lang).expect("a text for the step");
    let [Block::Paragraph(parts)] = &step.body[..] else {
        panic!("{:?} is one paragraph", step.body);
    };
    parts.iter().map(|part| &*part.text).collect()
}

const FILLED: &str = "
{u_min} => 1/4 => 1/4
{P₁} to {P₂} => (−2, −1) to (2, 1.5) => (−2; −1) to (2; 1,5)
{P₂.y} = {scene.segments[0][3]} => 1.5 = 1.5 => 1,5 = 1,5
{event.r}, {event.edge} => 1/4, left => 1/4, left
{event.r : decimal}, {event.r:3} => 0.25, 0.250 => 0,25, 0,250
{scene.window[2] / 3 : fraction} => 1/3 => 1/3
{output.segment} => (−1, −3/8, 1, 7/8) => (−1; −3/8; 1; 7/8)
{P₁.x - 2 * (P₂.x − 1)} => −4 => −4
{-P₁.x} and {−(P₁.x)} => 2 and 2 => 2 and 2
{\"r = q/p\".value} => 1/4 => 1/4
{event.r @ leave right} => 3/4 => 3/4
{event.r of farther}, {P₁.x of farther @ end} => 2/5, −3 => 2/5, −3
{P₁ of upright @ end : decimal} => (0.5, −1) => (0,5; −1)
{cost.div by brute-force @ end} of {cost.div @ end} => 3 of 6 => 3 of 6
{steps} steps, {len(scene.window)} sides => 16 steps, 4 sides => 16 steps, 4 sides
{sum(scene.window)}, {count(scene.window, -1)} => 0, 2 => 0, 2
{max(abs(P₁.x), sqrt(9))}, {min(3, 2)}, {min(3, 2, 1)} => 3, 2, 1 => 3, 2, 1
{sin(30) : 1}, {cos(0)}, {tan(45) : 0}, {acos(1)}, {atan(1) : 0} => 0.5, 1, 1, 0, 45 => 0,5, 1, 1, 0, 45
{1234567 : grouped}, {-1234 : grouped}, {12 : grouped} => 1,234,567, −1,234, 12 => 1\u{a0}234\u{a0}567, −1\u{a0}234, 12
{-0.001 : 2} => 0.00 => 0,00
**{u_min}***{u_max}*`{u_max}` => 1/411 => 1/411
";

#[test]
fn a_reference_is_filled_in_as_the_language_writes_it() {
    for [text, english, spanish] in cases(FILLED) {
        let text = text.replace("\\\"", "\"");
        let said = [filled(&text, Lang::En), filled(&text, Lang::Es)];
        assert_eq!(said, [english, spanish], "{text}");
    }
}

#[test]
fn titles_and_answers_are_filled_in_and_code_is_not() {
    let text = "Is it {u_min}?\n\n> No: {u_max}.\n\n```\n{u_min}\n```";
    let mut files = lesson_saying(text);
    let english = String::from_utf8(files["01-a/en.md"].clone()).expect("text");
    let english = english.replace("Title", "From {u_min}");
    files.insert("01-a/en.md".to_owned(), english.clone().into());
    assert_eq!(wrong(&files), [""; 0]);
    let lesson = &Course::check(&files).course.lessons[0];
    assert_eq!(lesson.step_title(0, Lang::En), Some("From 1/4"));
    assert_eq!(lesson.step_title(0, Lang::Es), Some("Title"));
    let as_read = english
        .replacen("{u_min}", "1/4", 2)
        .replace("{u_max}", "1");
    assert_eq!(lesson.filled(&english, Lang::En), as_read);
    let step = lesson.step_text(0, Lang::En).expect("a text");
    assert_eq!(step.body.last(), Some(&Block::Code("{u_min}\n".to_owned())));
}

const BROKEN: &str = "
{u_mim} => 5:1 unknown-name
{} => 5:1 bad-reference
{u_min => 5:1 bad-reference
Say {u_min +} => 5:5 bad-reference
{(u_min} => 5:1 bad-reference
{u_min u_max} => 5:1 bad-reference
{P₁.} => 5:1 bad-reference
{P₁[x]} => 5:1 bad-reference
{root(2)} => 5:1 bad-reference
{max(2)} => 5:1 bad-reference
{len(2)} => 5:1 bad-reference
{P₁.z} => 5:1 no-value
{P₁ + 1} => 5:1 no-value
{output} => 5:1 no-value
{output.segment[4]} => 5:1 no-value
{event.at} => 5:1 no-value
{1 / 0} => 5:1 no-value
{u_min : decimals} => 5:1 unknown-form
{u_min : 99} => 5:1 unknown-form
{u_min @ enter top} => 5:1 moment-never-happens
{u_min @ } => 5:1 bad-moment
{u_min of nowhere} => 5:1 unknown-scene
{u_min by cyrus-beck} => 5:1 unknown-method
";

#[test]
fn every_mistake_in_a_reference_has_its_place() {
    for [text, expected] in cases(BROKEN) {
        let mut texts = Lang::ALL.map(|lang| format!("{lang}.md:{expected}"));
        texts.sort_unstable();
        assert_eq!(wrong(&lesson_saying(&text)), texts, "{text}");
    }
}

#[test]
fn a_deep_expression_is_refused_and_not_followed() {
    for text in [
        "(".repeat(10_000),
        "-".repeat(10_000),
        "abs(".repeat(10_000),
    ] {
        let found = wrong(&lesson_saying(&format!("{{{text}}}")));
        assert!(
            found.contains(&"en.md:5:1 bad-reference".to_owned()),
            "{found:?}"
        );
    }
}

#[test]
fn the_title_of_a_lesson_has_no_reference() {
    let text = "# Intervals {u_min}\n\n## first: Title\n\nText.\n";
    let found = wrong(&with(SCENES, text));
    assert!(
        found.contains(&"en.md:1:13 reference-outside".to_owned()),
        "{found:?}"
    );
}

#[test]
fn a_name_that_is_not_alive_is_answered_by_those_that_are() {
    let problems = Course::check(&lesson_saying("{u_mni}")).problems;
    let problem = problems.iter().find(|it| it.code() == "unknown-name");
    let said = problem.expect("the mistake").render(Catalog::of(Lang::En));
    assert!(said.contains("Did you mean “u_min”?"), "{said}");
    assert!(said.contains("u_max"), "{said}");
}

const LIKE: &str = r#"
like = "practice" => like = "practise" => lesson.toml:11:8 unknown-scene
like = "practice" => like = "farther" => lesson.toml:11:8 like-itself
like = "practice" => like = "upright" => lesson.toml:11:8 like-itself
like = "practice" => like = 7 => lesson.toml:11:8 wrong-type
segments.0.0 = -3 => segments.9.0 = -3 => lesson.toml:12:1 wrong-type
segments.0.0 = -3 => segments.0.0 = "a" => lesson.toml:12:16 wrong-type
segments.0.0 = -3 => sgments = [] => lesson.toml:12:1 unknown-field
window = [-1, -1, 1, 1] => window = [1, -1, -1, 1] => lesson.toml:7:11 empty-window
"#;

#[test]
fn a_scene_like_another_says_what_is_wrong_once() {
    for [old, new, expected] in cases(LIKE) {
        assert!(SCENES.contains(&old), "{old}");
        let files = with(
            &SCENES.replacen(&old, &new, 1),
            "# A\n\n## first: B\n\nC.\n",
        );
        let found = wrong(&files);
        let of_it: Vec<&String> = found.iter().filter(|line| **line == expected).collect();
        assert_eq!(of_it.len(), 1, "{new}: {found:?}");
    }
}

#[test]
fn a_scene_that_only_the_text_names_is_used() {
    let unused = |text: &str| found(&lesson_saying(text));
    let both = [
        "lesson.toml:10:9 unused-scene",
        "lesson.toml:14:9 unused-scene",
    ];
    assert_eq!(unused("Nothing."), both);
    assert_eq!(unused("{u_min of farther @ end}"), both[1..]);
}
