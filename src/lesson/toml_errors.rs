//! What is said of a file that is not TOML.

use toml::de::{DeTable, Error};

use super::prelude::*;

/// Parses the file and reads what of it is TOML. Where not all is, what was read is checked but not used.
pub(super) fn with_toml<T>(
    sink: &Sink<'_>,
    read: impl Fn(&DeTable<'_>, &Sink<'_>) -> Option<T>,
) -> Option<T> {
    if sink.source.bad_byte.is_some() {
        return None;
    }
    let (table, errors) = DeTable::parse_recoverable(&sink.source.text);
    for (i, error) in errors.iter().enumerate() {
        // After a broken header the parser takes the tables that follow for each other.
        if i == 0 || !error.message().starts_with(DUPLICATE) {
            report(error, sink);
        }
    }
    if errors.is_empty() {
        return read(table.get_ref(), sink);
    }
    // What was left out while recovering would be reported as missing, and what depends on it as unknown.
    let rest = Sink::new(sink.source);
    read(table.get_ref(), &rest);
    sink.take_from(rest, |code| {
        !code.starts_with("missing")
            && !matches!(code, "unknown-scene" | "no-steps" | "unused-scene")
    });
    None
}

const DUPLICATE: &str = "duplicate key";

/// The parser speaks English only: its complaints have sentences in the catalogue, the rarest ones one for all.
fn report(error: &Error, sink: &Sink<'_>) {
    let end = sink.source.text.len();
    let span = error.span().unwrap_or(end..end);
    let (message, note) = sentence(error.message());
    sink.error(span, message, note.map(Message::new));
}

fn sentence(reason: &str) -> (Message, Option<&'static str>) {
    let (complaint, expected) = reason.split_once(", expected ").unwrap_or((reason, ""));
    let starts = |words: &[&str]| words.iter().any(|start| complaint.starts_with(start));
    if starts(&["unclosed", "invalid basic string", "invalid literal string"]) {
        let closer = expected.trim_matches('`').to_owned();
        return (
            Message::new("problem-toml-unclosed").with("closer", closer),
            None,
        );
    }
    let (key, note) = if complaint == DUPLICATE {
        ("problem-toml-duplicate", None)
    } else if complaint.contains("recurs") {
        ("problem-toml-deep", None)
    } else if starts(&["string values must be quoted"]) {
        ("problem-toml-value", Some("expect-toml-value"))
    } else if starts(&["key with no value", "missing assignment"]) {
        ("problem-toml-no-value", None)
    } else if starts(&["invalid unquoted key", "keys cannot be", "unquoted keys"]) {
        ("problem-toml-name", Some("expect-toml-name"))
    } else if starts(&["missing comma"]) {
        ("problem-toml-comma", None)
    } else if starts(&["extra ", "unexpected `=`"]) {
        ("problem-toml-extra", None)
    } else if starts(&[
        "`_` may",
        "integers with",
        "radix",
        "redundant",
        "unexpected leading",
        "unexpected sign",
    ]) {
        ("problem-toml-number", Some("expect-toml-value"))
    } else if starts(&["missing escaped", "too few unicode", "invalid escape"]) {
        ("problem-toml-escape", None)
    } else {
        ("problem-toml", None)
    };
    (Message::new(key), note)
}
