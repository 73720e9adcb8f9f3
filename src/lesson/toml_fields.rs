//! Typed access to a parsed TOML file that reports what it finds wrong and reads on.

use std::ops::Range;

use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

use crate::{
    input::{At, Dim, Got, Part, Presence, Shape, Table},
    text::{Message, Value},
};

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

    /// A part that must be there.
    pub fn need<T>(&self, part: &Part<T>, sink: &mut Sink<'_>) -> Option<T> {
        made(self.require(part.name(), sink)?, part, sink)
    }

    /// A part that may be left out.
    pub fn part<T>(&self, part: &Part<T>, sink: &mut Sink<'_>) -> Option<T> {
        made(self.get(part.name())?, part, sink)
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

/// What a value means as this part of a file.
pub(crate) fn made<T>(item: &Item<'_>, part: &Part<T>, sink: &mut Sink<'_>) -> Option<T> {
    let got = got(item, part.optional.shape, part.expect, sink)?;
    let fault = match (part.make)(&got) {
        Ok(made) => return Some(made),
        Err(fault) => fault,
    };
    let inner = match fault.at {
        At::Whole => None,
        At::Entry(i) => item.get_ref().get(i),
        At::Field(name) => item.get_ref().get(name),
    };
    let span = inner.unwrap_or(item).span();
    sink.refuse(span, fault.what, [Message::new(part.expect)]);
    None
}

/// A value, once it has this shape.
pub(super) fn got(
    item: &Item<'_>,
    shape: &Shape,
    expect: &'static str,
    sink: &mut Sink<'_>,
) -> Option<Got> {
    match shape {
        Shape::Number => number(item, expect, sink).map(Got::Number),
        Shape::Whole(least, most) => {
            let whole = whole(item, *least as u64..*most as u64 + 1, sink)?;
            Some(Got::Wholes(vec![whole as i64]))
        }
        Shape::Text => Some(Got::Text(text(item, sink)?.to_owned())),
        Shape::Word(words) => one_of(item, words, "problem-unknown-value", sink, |word| {
            words.contains(&word).then(|| Got::Text(word.to_owned()))
        }),
        Shape::Numbers(dims) => {
            let mut numbers = Vec::new();
            let expect = [expect, expected(dims)];
            lists(item, dims, expect, sink, &mut |item, sink| {
                numbers.extend(number(item, "expect-number", sink));
            })?;
            Some(Got::Numbers(numbers))
        }
        Shape::Wholes(dims, least, most) => {
            let mut wholes = Vec::new();
            let range = *least as u64..*most as u64 + 1;
            lists(item, dims, [expect; 2], sink, &mut |item, sink| {
                wholes.extend(whole(item, range.clone(), sink).map(|n| n as i64));
            })?;
            Some(Got::Wholes(wholes))
        }
        Shape::Table(table) => fields_of(item, table, sink).map(Got::Table),
        Shape::List(entry) => each(item, expect, sink, |item, sink| {
            got(item, entry, expect, sink)
        })
        .map(Got::List),
        Shape::OrNull(shape) => got(item, shape, expect, sink),
        // Answers alone have it.
        Shape::Bool => None,
    }
}

/// Lists in lists: calls back with each of the innermost entries. `None` where anything is wrong; `expect` says what was
/// expected of the list, and of the lists in it.
fn lists(
    item: &Item<'_>,
    dims: &[Dim],
    [expect, inner_expect]: [&'static str; 2],
    sink: &mut Sink<'_>,
    entry: &mut dyn FnMut(&Item<'_>, &mut Sink<'_>),
) -> Option<()> {
    let n_errors = sink.n_errors();
    let [dim, inner @ ..] = dims else {
        entry(item, sink);
        return (sink.n_errors() == n_errors).then_some(());
    };
    let items = list(item, expect, sink)?;
    let is_wrong = matches!(dim, Dim::Exactly(n) if *n != items.len());
    let is_flat = inner.is_empty();
    if !(is_wrong && is_flat) {
        for item in items {
            lists(item, inner, [inner_expect; 2], sink, entry);
        }
    }
    if is_wrong && sink.n_errors() == n_errors {
        let key = if is_flat {
            "problem-wrong-length"
        } else {
            "problem-too-few-places"
        };
        let message = Message::new(key).with("count", items.len());
        sink.error(item.span(), message, [Message::new(expect)]);
    }
    (sink.n_errors() == n_errors).then_some(())
}

/// Catalogue key of what so many numbers are.
const fn expected(dims: &[Dim]) -> &'static str {
    match dims {
        [.., Dim::Exactly(2)] => "expect-point",
        [.., Dim::Exactly(3)] => "expect-place",
        [.., Dim::Exactly(4)] => "expect-segment",
        _ => "expect-number",
    }
}

/// All fields of a table that are right; `None` where one is not.
fn fields_of(
    item: &Item<'_>,
    table: &Table,
    sink: &mut Sink<'_>,
) -> Option<Vec<(&'static str, Got)>> {
    let n_errors = sink.n_errors();
    let names: Vec<&str> = table.fields.iter().map(|field| field.name).collect();
    let fields = TomlFields::of(item, &names, sink)?;
    let choices = table.fields.iter().filter(|f| f.need == Presence::Choice);
    let names = choices.map(|field| field.name);
    let mut chosen = names.clone().filter_map(|name| fields.get(name));
    if let Some(name) = names.clone().next()
        && chosen.next().is_none()
    {
        fields.require(name, sink);
    }
    if let Some(second) = chosen.next() {
        sink.error(second.span(), Message::new(table.both_key), []);
    }
    let mut all = Vec::new();
    for field in table.fields {
        let given = match field.need {
            Presence::Required => fields.require(field.name, sink),
            Presence::Choice | Presence::Optional => fields.get(field.name),
        };
        let expect = match field.shape {
            Shape::Numbers(dims) => expected(dims),
            Shape::Wholes(..) => "expect-pixel",
            _ => "expect-number",
        };
        let got = given.and_then(|item| got(item, field.shape, expect, sink));
        all.extend(got.map(|got| (field.name, got)));
    }
    (sink.n_errors() == n_errors).then_some(all)
}

/// A list, each entry read; `None` where one of them is wrong.
pub(super) fn each<'t, T>(
    item: &'t Item<'t>,
    expect: &'static str,
    sink: &mut Sink<'_>,
    mut read: impl FnMut(&'t Item<'t>, &mut Sink<'_>) -> Option<T>,
) -> Option<Vec<T>> {
    let items = list(item, expect, sink)?;
    let read: Vec<T> = items.iter().filter_map(|item| read(item, sink)).collect();
    (read.len() == items.len()).then_some(read)
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
