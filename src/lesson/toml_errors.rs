//! What is said of a file that is not TOML.

use toml::de::{DeTable, Error};

use crate::text::Message;

use super::sink::Sink;

/// Parses the file and reads what of it is TOML. Where not all is, what was read is checked but not used.
pub(super) fn with_toml<'s, T>(
    sink: &mut Sink<'s>,
    read: impl FnOnce(&DeTable<'_>, &mut Sink<'s>) -> Option<T>,
) -> Option<T> {
    if sink.source().bad_byte.is_some() {
        return None;
    }
    let (table, errors) = DeTable::parse_recoverable(&sink.source().text);
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
    let mut rest = Sink::new(sink.source());
    read(table.get_ref(), &mut rest);
    sink.take_from(rest, |code| {
        !code.starts_with("missing")
            && !matches!(code, "unknown-scene" | "no-steps" | "unused-scene")
    });
    None
}

const DUPLICATE: &str = "duplicate key";

/// The parser speaks English only: its most frequent complaints have a sentence in the catalogue.
fn report(error: &Error, sink: &mut Sink<'_>) {
    let end = sink.source().text.len();
    let span = error.span().unwrap_or(end..end);
    let reason = error.message();
    let (complaint, expected) = reason.split_once(", expected ").unwrap_or((reason, ""));
    let is_unclosed = complaint.starts_with("unclosed")
        || matches!(complaint, "invalid basic string" | "invalid literal string");
    let (message, note) = match complaint {
        DUPLICATE => (Message::new("problem-toml-duplicate"), None),
        "string values must be quoted" => (
            Message::new("problem-toml-value"),
            Some("expect-toml-value"),
        ),
        "key with no value" => (Message::new("problem-toml-no-value"), None),
        "invalid unquoted key" => (Message::new("problem-toml-name"), Some("expect-toml-name")),
        _ if is_unclosed => {
            let closer = expected.trim_matches('`').to_owned();
            (
                Message::new("problem-toml-unclosed").with("closer", closer),
                None,
            )
        }
        _ => {
            let reason = reason.replace(", expected nothing", "");
            (Message::new("problem-toml").with("reason", reason), None)
        }
    };
    sink.error(span, message, note.map(Message::new));
}
