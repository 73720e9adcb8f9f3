//! Names of steps and figures: plain, and each once in a lesson.

use std::collections::BTreeMap;

use super::{prelude::*, toml_fields::Node};

/// Names that must not come twice, and the line of each.
#[derive(Default)]
pub(super) struct Names(BTreeMap<String, usize>);

impl Names {
    pub fn take(
        &mut self,
        node: Node<'_>,
        is_valid: fn(&str) -> bool,
        [invalid, expect, duplicate]: [&'static str; 3],
    ) -> Option<String> {
        let name = node.text()?;
        let about = |key| Message::new(key).with("name", clipped(name));
        if !is_valid(name) {
            node.error(about(invalid), [Message::new(expect)]);
            return None;
        }
        if let Some(line) = self.0.get(name) {
            let first = Message::new("expect-first-here").with("line", line.to_string());
            node.error(about(duplicate), [first]);
            return None;
        }
        let line = node.sink.source.line(node.span().start);
        self.0.insert(name.to_owned(), line);
        Some(name.to_owned())
    }
}

pub(super) fn is_kebab(id: &str) -> bool {
    is_figure_name(id) && id.split('-').all(|part| !part.is_empty())
}

/// Nothing that a path could be made of.
pub(super) fn is_figure_name(name: &str) -> bool {
    let is_plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-';
    name.len() <= 64 && name.bytes().all(is_plain)
}
