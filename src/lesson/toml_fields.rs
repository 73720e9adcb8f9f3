//! Typed access to a parsed TOML file that reports what it finds wrong and reads on.

use toml::{
    Spanned,
    de::{DeString, DeTable, DeValue},
};

use crate::{
    input::{At, Dim, Got, Part, Presence, Shape, Table},
    text::Value,
};

use super::prelude::*;

/// A value, where it stands, and who hears what is wrong with it.
#[derive(Clone, Copy)]
pub(crate) struct Node<'t> {
    item: &'t Spanned<DeValue<'t>>,
    pub sink: &'t Sink<'t>,
}

/// A table of which only certain fields may be given.
pub(crate) struct TomlFields<'t> {
    table: &'t DeTable<'t>,
    /// Where a field would be added: the table's header.
    pub span: Range<usize>,
    /// Known fields that a misspelt one stands for: not reported as missing, too.
    misspelt: Vec<&'static str>,
    pub sink: &'t Sink<'t>,
}

impl<'t> TomlFields<'t> {
    pub fn new(
        table: &'t DeTable<'t>,
        span: Range<usize>,
        known: &[&'static str],
        sink: &'t Sink<'t>,
    ) -> Self {
        let is_known = |name: &str| known.contains(&name);
        let mut misspelt = Vec::new();
        for key in table.keys().filter(|key| !is_known(key.get_ref())) {
            let absent = known.iter().copied();
            let absent = absent.filter(|name| !table.contains_key(*name));
            let meant = sink.nearest(key.get_ref(), absent);
            misspelt.extend(known.iter().copied().find(|name| Some(*name) == meant));
            let message = Message::new("problem-unknown-field");
            let message = message.with("name", clipped(key.get_ref()));
            sink.error(key.span(), message, suggestion(meant, known));
        }
        Self {
            table,
            span,
            misspelt,
            sink,
        }
    }

    pub fn get(&self, name: &str) -> Option<Node<'t>> {
        let (item, sink) = (self.table.get(name)?, self.sink);
        Some(Node { item, sink })
    }

    /// Is a field like this one there under a wrong name?
    pub fn is_misspelt(&self, name: &str) -> bool {
        self.misspelt.contains(&name)
    }

    /// A field that must be there.
    pub fn require(&self, name: &'static str) -> Option<Node<'t>> {
        let node = self.get(name);
        if node.is_none() && !self.is_misspelt(name) {
            self.missing(name, []);
        }
        node
    }

    pub fn missing(&self, name: &'static str, notes: impl IntoIterator<Item = Message>) {
        let message = Message::new("problem-missing-field").with("name", name.to_owned());
        self.sink.error(self.span.clone(), message, notes);
    }

    pub fn need<T>(&self, part: &Part<T>) -> Option<T> {
        self.require(part.name())?.made(part)
    }

    pub fn part<T>(&self, part: &Part<T>) -> Option<T> {
        self.get(part.name())?.made(part)
    }
}

impl<'t> Node<'t> {
    pub const fn of(item: &'t Spanned<DeValue<'t>>, sink: &'t Sink<'t>) -> Self {
        Self { item, sink }
    }

    pub fn table(self) -> Option<&'t DeTable<'t>> {
        self.expecting(self.item.get_ref().as_table(), "expect-table")
    }

    pub fn value_of(self) -> &'t DeValue<'t> {
        self.item.get_ref()
    }

    pub fn span(self) -> Range<usize> {
        self.item.span()
    }

    pub fn error(self, what: impl Into<Diagnostic>, notes: impl IntoIterator<Item = Message>) {
        self.sink.error(self.span(), what, notes);
    }

    /// What is `made` of the value, or why that is refused.
    pub fn accept<T>(self, made: Result<T, impl Into<Diagnostic>>) -> Option<T> {
        made.map_err(|error| self.error(error, [])).ok()
    }

    pub fn wrong_type(self, expect: &'static str) {
        self.error(self.type_message(), [Message::new(expect)]);
    }

    fn type_message(self) -> Message {
        let found = match self.item.get_ref() {
            DeValue::String(_) => "type-text",
            DeValue::Integer(_) => "type-integer",
            DeValue::Float(_) => "type-float",
            DeValue::Boolean(_) => "type-boolean",
            DeValue::Datetime(_) => "type-date",
            DeValue::Array(_) => "type-list",
            DeValue::Table(_) => "type-table",
        };
        Message::new("problem-wrong-type").with("found", Value::Term(found))
    }

    /// `value`, where it is of the right type.
    fn expecting<T>(self, value: Option<T>, expect: &'static str) -> Option<T> {
        if value.is_none() {
            self.wrong_type(expect);
        }
        value
    }

    pub fn fields(self, known: &[&'static str]) -> Option<TomlFields<'t>> {
        Some(TomlFields::new(
            self.table()?,
            self.span(),
            known,
            self.sink,
        ))
    }

    /// The fields of a table of which the keys are names that the author chose.
    pub fn named(self) -> Option<impl Iterator<Item = (&'t Spanned<DeString<'t>>, Self)>> {
        let Self { sink, .. } = self;
        let fields = self.table()?.iter();
        Some(fields.map(move |(key, item)| (key, Node { item, sink })))
    }

    /// A text that says something.
    pub fn text(self) -> Option<&'t str> {
        let text = self.expecting(self.value_of().as_str(), "expect-text")?;
        if text.trim().is_empty() {
            self.error(Message::new("problem-empty-text"), []);
            return None;
        }
        Some(text)
    }

    pub fn is_number(self) -> bool {
        self.item.get_ref().is_integer() || self.item.get_ref().is_float()
    }

    /// A finite number, whole or not.
    pub fn number(self, expect: &'static str) -> Option<f64> {
        let number = match self.item.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse(),
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
                .map_or(Ok(f64::NAN), |n| Ok(n as f64)),
            DeValue::Float(float) => float.as_str().parse::<f64>(),
            _ => {
                self.wrong_type(expect);
                return None;
            }
        };
        let number = number.ok().filter(|number| number.is_finite());
        if number.is_none() {
            self.error(Message::new("problem-not-finite"), []);
        }
        number
    }

    pub fn whole(self, range: Range<u64>) -> Option<u64> {
        let expected = || {
            Message::new("expect-whole")
                .with("min", range.start.to_string())
                .with("max", (range.end - 1).to_string())
        };
        let DeValue::Integer(integer) = self.item.get_ref() else {
            self.error(self.type_message(), [expected()]);
            return None;
        };
        let number = u64::from_str_radix(integer.as_str(), integer.radix());
        let number = number.ok().filter(|n| range.contains(n));
        if number.is_none() {
            let message = Message::new("problem-out-of-range");
            let message = message.with("value", clipped(&integer.to_string()));
            self.error(message, [expected()]);
        }
        number
    }

    /// The entries, where it is a list.
    pub fn entries(self) -> Option<impl ExactSizeIterator<Item = Self> + Clone + use<'t>> {
        let Self { item, sink } = self;
        let entries = item.get_ref().as_array()?.iter();
        Some(entries.map(move |item| Node { item, sink }))
    }

    pub fn list(
        self,
        expect: &'static str,
    ) -> Option<impl ExactSizeIterator<Item = Self> + Clone + use<'t>> {
        self.expecting(self.entries(), expect)
    }

    /// What it means as this part of a file.
    pub fn made<T>(self, part: &Part<T>) -> Option<T> {
        let got = self.got(part.optional.shape, part.expect)?;
        let fault = match (part.make)(&got) {
            Ok(made) => return Some(made),
            Err(fault) => fault,
        };
        let place = self.at(fault.at);
        place.error(fault.what, [Message::new(part.expect)]);
        None
    }

    /// A place in it; it itself where there is no such place.
    pub fn at(self, at: At) -> Self {
        let Self { item, sink } = self;
        let inner = match at {
            At::Whole => None,
            At::Entry(i) => item.get_ref().get(i),
            At::Field(name) => item.get_ref().get(name),
        };
        inner.map_or(self, |item| Node { item, sink })
    }

    pub fn got(self, shape: &Shape, expect: &'static str) -> Option<Got> {
        match shape {
            Shape::Number => self.number(expect).map(Got::Number),
            Shape::Whole(least, most) => {
                let whole = self.whole(*least as u64..*most as u64 + 1)?;
                Some(Got::Wholes(vec![whole as i64]))
            }
            Shape::Text => Some(Got::Text(self.text()?.to_owned())),
            Shape::Word(words) => self.one_of(words, "problem-unknown-value", |word| {
                words.contains(&word).then(|| Got::Text(word.to_owned()))
            }),
            Shape::Numbers(dims) => {
                let mut numbers = Vec::new();
                self.lists(dims, [expect, expected(dims)], &mut |node| {
                    numbers.extend(node.number("expect-number"));
                })?;
                Some(Got::Numbers(numbers))
            }
            Shape::Wholes(dims, least, most) => {
                let mut wholes = Vec::new();
                let range = *least as u64..*most as u64 + 1;
                self.lists(dims, [expect; 2], &mut |node| {
                    wholes.extend(node.whole(range.clone()).map(|n| n as i64));
                })?;
                Some(Got::Wholes(wholes))
            }
            Shape::Table(table) => self.fields_of(table).map(Got::Table),
            Shape::List(entry) => self
                .each(expect, |node| node.got(entry, expect))
                .map(Got::List),
            Shape::OrNull(shape) => self.got(shape, expect),
            // Answers alone have it.
            Shape::Bool => None,
        }
    }

    /// Lists in lists: calls back with each of the innermost entries. `None` where anything is wrong; `expect` says what was
    /// expected of the list, and of the lists in it.
    fn lists(
        self,
        dims: &[Dim],
        [expect, inner_expect]: [&'static str; 2],
        entry: &mut dyn FnMut(Self),
    ) -> Option<()> {
        let n_errors = self.sink.n_errors();
        let is_right = || (self.sink.n_errors() == n_errors).then_some(());
        let [dim, inner @ ..] = dims else {
            entry(self);
            return is_right();
        };
        let nodes = self.list(expect)?;
        let count = nodes.len();
        let is_wrong = matches!(dim, Dim::Exactly(n) if *n != count);
        let is_flat = inner.is_empty();
        if !(is_wrong && is_flat) {
            for node in nodes {
                node.lists(inner, [inner_expect; 2], entry);
            }
        }
        if is_wrong && is_right().is_some() {
            let key = if is_flat {
                "problem-wrong-length"
            } else {
                "problem-too-few-places"
            };
            let message = Message::new(key).with("count", count);
            self.error(message, [Message::new(expect)]);
        }
        is_right()
    }

    /// All fields of a table that are right; `None` where one is not.
    fn fields_of(self, table: &Table) -> Option<Vec<(&'static str, Got)>> {
        let n_errors = self.sink.n_errors();
        let names: Vec<&str> = table.fields.iter().map(|field| field.name).collect();
        let fields = self.fields(&names)?;
        let choices = table.fields.iter().filter(|f| f.need == Presence::Choice);
        let names = choices.map(|field| field.name);
        let mut chosen = names.clone().filter_map(|name| fields.get(name));
        if let Some(name) = names.clone().next()
            && chosen.next().is_none()
        {
            fields.require(name);
        }
        if let Some(second) = chosen.next() {
            second.error(Message::new(table.both_key), []);
        }
        let mut all = Vec::new();
        for field in table.fields {
            let given = match field.need {
                Presence::Required => fields.require(field.name),
                Presence::Choice | Presence::Optional => fields.get(field.name),
            };
            let expect = match field.shape {
                Shape::Numbers(dims) => expected(dims),
                Shape::Wholes(..) => "expect-pixel",
                _ => "expect-number",
            };
            let got = given.and_then(|node| node.got(field.shape, expect));
            all.extend(got.map(|got| (field.name, got)));
        }
        (self.sink.n_errors() == n_errors).then_some(all)
    }

    /// A list, each entry read; `None` where one of them is wrong.
    pub fn each<T>(
        self,
        expect: &'static str,
        read: impl FnMut(Self) -> Option<T>,
    ) -> Option<Vec<T>> {
        let nodes = self.list(expect)?;
        let read: Vec<T> = nodes.clone().filter_map(read).collect();
        (read.len() == nodes.len()).then_some(read)
    }

    /// A word that `parse` knows; `key` is what is said of another one.
    pub fn one_of<T>(
        self,
        known: &[&str],
        key: &'static str,
        parse: impl FnOnce(&'t str) -> Option<T>,
    ) -> Option<T> {
        let name = self.text()?;
        let value = parse(name);
        if value.is_none() {
            let message = Message::new(key).with("name", clipped(name));
            let meant = self.sink.nearest(name, known.iter().copied());
            self.error(message, suggestion(meant, known));
        }
        value
    }

    /// The one of these that is spelt so.
    pub fn value<T: Copy, const N: usize>(
        self,
        all: [T; N],
        spelt: fn(T) -> &'static str,
    ) -> Option<T> {
        self.one_of(&all.map(spelt), "problem-unknown-value", |name| {
            all.into_iter().find(|&value| spelt(value) == name)
        })
    }
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
