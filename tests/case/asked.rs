//! How cases are asked, and what is said of their answers.

use clipscope::{
    case::{Detail, Format, Refusing, Solvers, Style, Tally, trace},
    text::{Catalog, Lang},
};
use serde_json::Value as Json;

use super::schema;

/// Every step, in English.
pub const JSON: Style = style(Format::Json, Lang::En);
/// Answers without steps, in English.
const ANSWERS: Style = Style {
    detail: Detail::Answers,
    ..JSON
};

/// With every step.
pub const fn style(format: Format, lang: Lang) -> Style {
    Style {
        format,
        detail: Detail::Steps,
        lang,
    }
}

/// What is written about cases, and how many of them were answered.
pub fn tallied(cases: &[u8], style: Style) -> (String, Tally) {
    let mut out = Vec::new();
    let tally = trace(Solvers::standard(), cases, &mut out, style, |_| {})
        .expect("memory can be read and written");
    let answers = String::from_utf8(out).expect("answers are UTF-8");
    if style.format == Format::Json {
        let lines = cases
            .split(|byte| *byte == b'\n')
            .map(String::from_utf8_lossy);
        let cases = lines.filter(|line| !line.trim().is_empty());
        for (case, answer) in cases.zip(answers.lines()) {
            schema::check(&case, answer);
        }
    }
    (answers, tally)
}

/// What is written about cases.
pub fn answers(cases: &str, style: Style) -> String {
    tallied(cases.as_bytes(), style).0
}

/// Of one case, with its steps.
pub fn answer(case: &str) -> Json {
    serde_json::from_str(&answers(case, JSON)).expect("one answer of JSON")
}

/// Of one case, without them.
pub fn answer_alone(case: &str) -> Json {
    serde_json::from_str(&answers(case, ANSWERS)).expect("one answer of JSON")
}

/// Without its steps an answer is the same, and each of them has a name; only rays cost less, as they ask boxes first.
pub fn steps_are_all_that_is_left_out(case: &str) {
    let mut with = answer(case);
    let events = with.as_object_mut().and_then(|a| a.remove("events"));
    let events = events.expect("steps");
    let events = events.as_array().expect("a list");
    assert!(!events.is_empty());
    for event in events {
        assert!(event["event"].is_string(), "{event} has a name");
    }
    let mut alone = answer_alone(case);
    if with["algorithm"] == "ray-casting" {
        let [taught, made] = [&mut with, &mut alone].map(|answer| answer["counts"].take());
        assert!(made["mul"].as_u64() <= taught["mul"].as_u64(), "{made}");
    }
    assert_eq!(with, alone);
}

/// A case of these fields.
pub fn line(algorithm: &str, fields: &str) -> String {
    format!(r#"{{"algorithm":"{algorithm}",{fields}}}"#)
}

/// What comes out of one that is not refused.
pub fn output(algorithm: &str, fields: &str) -> Json {
    let answer = answer(&line(algorithm, fields));
    assert!(answer["error"].is_null(), "{fields}: {answer}");
    answer["output"].clone()
}

/// The code and the place of a refusal.
pub fn refusal(case: &str) -> [String; 2] {
    let answer = answer(case);
    let word = |key: &str| {
        let word = answer["error"][key].as_str();
        word.unwrap_or_else(|| panic!("{case:.200} is refused, not {answer:.200}"))
            .to_owned()
    };
    assert!(!word("message").contains('⟦'), "{answer} has its sentence");
    [word("code"), word("field")]
}

/// What people are told of a case that is refused, and that no page to hand out holds it.
pub fn refusal_said(case: &str, lang: Lang) -> String {
    let mut said = String::new();
    for format in [Format::Text, Format::Markdown, Format::Worksheet] {
        let mut out = Vec::new();
        let told = |refusing: Refusing<'_>| said = refusing.sentence(Catalog::of(lang));
        let style = style(format, lang);
        trace(Solvers::standard(), case.as_bytes(), &mut out, style, told).expect("memory");
        assert_eq!(out, b"", "{case}");
    }
    said
}

/// Holds reports on cases to the files below `tests/reports`; `UPDATE_SNAPSHOTS=1` writes what they now are.
pub fn reports_are_as_they_were(cases: &str, files: &[(&str, Format, Lang)]) {
    for &(name, format, lang) in files {
        let report = answers(cases, style(format, lang));
        assert!(!report.contains('⟦'), "{name}: every sentence is there");
        let path = format!("{}/tests/reports/{name}", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
            std::fs::write(&path, &report).expect("a snapshot can be written");
        }
        let expected = std::fs::read_to_string(&path).unwrap_or_default();
        assert_eq!(
            report, expected,
            "{path}; UPDATE_SNAPSHOTS=1 writes what is now right"
        );
    }
}

/// No line for a terminal is wider than it, in any language.
pub fn lines_are_at_most_a_hundred_columns_wide(case: &str) {
    use unicode_width::UnicodeWidthStr;
    for lang in Lang::ALL {
        for line in answers(case, style(Format::Text, lang)).lines() {
            assert!(line.width() <= 100, "{lang}, {case}: {line}");
        }
    }
}
