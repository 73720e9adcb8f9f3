//! Typed access to a parsed TOML file that reports what it finds wrong and reads on.

use std::ops::Range;

use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

use crate::text::{Message, Value};

use super::sink::{Sink, clipped};

/// A value and where it stands.
pub(crate) type Item<'t> = Spanned<DeValue<'t>>;

/// A table of which only certain fields may be given.
pub(crate) struct TomlFields<'t> {
    table: &'t DeTable<'t>,
    /// Where a field would be added: the table's header.
    span: Range<usize>,
    /// Known fields that a misspelt one stands for: not reported as missing, too.
    misspelt: Vec<&'static str>,
}

impl<'t> TomlFields<'t> {
    /// A file's top level.
    pub fn of_file(table: &'t DeTable<'t>, known: &[&'static str], sink: &mut Sink<'_>) -> Self {
        Self::new(table, 0..0, known, sink)
    }

    /// A value that should be a table.
    pub fn of(item: &'t Item<'t>, known: &[&'static str], sink: &mut Sink<'_>) -> Option<Self> {
        let Some(table) = item.get_ref().as_table() else {
            wrong_type(item, "expect-table", sink);
            return None;
        };
        Some(Self::new(table, item.span(), known, sink))
    }

    fn new(
        table: &'t DeTable<'t>,
        span: Range<usize>,
        known: &[&'static str],
        sink: &mut Sink<'_>,
    ) -> Self {
        let is_known = |name: &str| known.contains(&name);
        let mut misspelt = Vec::new();
        for key in table.keys().filter(|key| !is_known(key.get_ref())) {
            let absent = known
                .iter()
                .copied()
                .filter(|name| !table.contains_key(*name));
            let meant = sink.nearest(key.get_ref(), absent);
            misspelt.extend(known.iter().copied().find(|name| Some(*name) == meant));
            let message =
                Message::new("problem-unknown-field").with("name", clipped(key.get_ref()));
            sink.error(key.span(), message, suggestion(meant, known));
        }
        Self {
            table,
            span,
            misspelt,
        }
    }

    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    pub fn get(&self, name: &str) -> Option<&'t Item<'t>> {
        self.table.get(name)
    }

    /// Is a field like this one there under a wrong name?
    pub fn is_misspelt(&self, name: &str) -> bool {
        self.misspelt.contains(&name)
    }

    /// A field that must be there.
    pub fn require(&self, name: &'static str, sink: &mut Sink<'_>) -> Option<&'t Item<'t>> {
        let item = self.get(name);
        if item.is_none() && !self.is_misspelt(name) {
            let message = Message::new("problem-missing-field").with("name", name.to_owned());
            sink.error(self.span(), message, []);
        }
        item
    }
}

/// A table of which the keys are names that the author chose.
pub(super) fn named<'t>(item: &'t Item<'t>, sink: &mut Sink<'_>) -> Option<&'t DeTable<'t>> {
    let table = item.get_ref().as_table();
    if table.is_none() {
        wrong_type(item, "expect-table", sink);
    }
    table
}

/// A text that says something.
pub(super) fn text<'t>(item: &'t Item<'t>, sink: &mut Sink<'_>) -> Option<&'t str> {
    let Some(text) = item.get_ref().as_str() else {
        wrong_type(item, "expect-text", sink);
        return None;
    };
    if text.trim().is_empty() {
        sink.error(item.span(), Message::new("problem-empty-text"), []);
        return None;
    }
    Some(text)
}

/// A finite number, whole or not.
pub(crate) fn number(item: &Item<'_>, expect: &'static str, sink: &mut Sink<'_>) -> Option<f64> {
    let number = match item.get_ref() {
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse(),
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .map_or(Ok(f64::NAN), |n| Ok(n as f64)),
        DeValue::Float(float) => float.as_str().parse::<f64>(),
        _ => {
            wrong_type(item, expect, sink);
            return None;
        }
    }
    .unwrap_or(f64::NAN);
    if !number.is_finite() {
        sink.error(item.span(), Message::new("problem-not-finite"), []);
        return None;
    }
    Some(number)
}

/// A whole number in a range.
pub(super) fn whole(item: &Item<'_>, range: Range<u64>, sink: &mut Sink<'_>) -> Option<u64> {
    let expected = || {
        Message::new("expect-whole")
            .with("min", range.start.to_string())
            .with("max", (range.end - 1).to_string())
    };
    let DeValue::Integer(integer) = item.get_ref() else {
        sink.error(item.span(), type_message(item), [expected()]);
        return None;
    };
    let number = u64::from_str_radix(integer.as_str(), integer.radix());
    let number = number.ok().filter(|n| range.contains(n));
    if number.is_none() {
        let message =
            Message::new("problem-out-of-range").with("value", clipped(&integer.to_string()));
        sink.error(item.span(), message, [expected()]);
    }
    number
}

/// A list of anything.
pub(super) fn list<'t>(
    item: &'t Item<'t>,
    expect: &'static str,
    sink: &mut Sink<'_>,
) -> Option<&'t [Item<'t>]> {
    let list = item.get_ref().as_array();
    if list.is_none() {
        wrong_type(item, expect, sink);
    }
    list.map(|list| &**list)
}

/// A list of exactly `N` numbers.
pub(super) fn numbers<const N: usize>(
    item: &Item<'_>,
    expect: &'static str,
    sink: &mut Sink<'_>,
) -> Option<[f64; N]> {
    let items = list(item, expect, sink)?;
    if items.len() != N {
        let message = Message::new("problem-wrong-length").with("count", items.len());
        sink.error(item.span(), message, [Message::new(expect)]);
        return None;
    }
    let mut all = Some([0.0; N]);
    for (i, item) in items.iter().enumerate() {
        match (number(item, "expect-number", sink), &mut all) {
            (Some(x), Some(all)) => all[i] = x,
            (_, all) => *all = None,
        }
    }
    all
}

/// A word that `parse` knows; `key` is what is said of another one.
pub(super) fn one_of<T>(
    item: &Item<'_>,
    known: &[&str],
    key: &'static str,
    sink: &mut Sink<'_>,
    parse: impl FnOnce(&str) -> Option<T>,
) -> Option<T> {
    let name = text(item, sink)?;
    let value = parse(name);
    if value.is_none() {
        let message = Message::new(key).with("name", clipped(name));
        let meant = sink.nearest(name, known.iter().copied());
        sink.error(item.span(), message, suggestion(meant, known));
    }
    value
}

/// The most names that an error lists.
const MAX_NAMES: usize = 60;

/// What may have been meant, then all that is known.
pub(super) fn suggestion(meant: Option<&str>, known: &[&str]) -> Vec<Message> {
    let meant = meant.map(|name| Message::new("expect-did-you-mean").with("name", clipped(name)));
    let mut names: Vec<String> = known.iter().take(MAX_NAMES).copied().map(clipped).collect();
    if known.len() > MAX_NAMES {
        names.push("…".to_owned());
    }
    let known =
        (!names.is_empty()).then(|| Message::new("expect-one-of").with("names", names.join(", ")));
    meant.into_iter().chain(known).collect()
}

pub(super) fn wrong_type(item: &Item<'_>, expect: &'static str, sink: &mut Sink<'_>) {
    sink.error(item.span(), type_message(item), [Message::new(expect)]);
}

fn type_message(item: &Item<'_>) -> Message {
    Message::new("problem-wrong-type").with(
        "found",
        Value::Term(match item.get_ref() {
            DeValue::String(_) => "type-text",
            DeValue::Integer(_) => "type-integer",
            DeValue::Float(_) => "type-float",
            DeValue::Boolean(_) => "type-boolean",
            DeValue::Datetime(_) => "type-date",
            DeValue::Array(_) => "type-list",
            DeValue::Table(_) => "type-table",
        }),
    )
}
