//! A case as it was written: values whose text is kept, each with its place.
//!
//! Numbers are read from their text, one by one, because a JSON library would refuse `1e999` as a mistake
//! of syntax, without a place; here it is a number that is not finite, in a field that has a name.

use std::fmt;

use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{MapAccess, Visitor},
};

use super::prelude::*;

/// Objects and lists inside each other in an `id`: as many as `serde_json` reads by itself.
const MAX_DEPTH: usize = 128;

/// Below it every whole `f64` is the number that was written.
const TWO_TO_53: f64 = 9_007_199_254_740_992.0;

/// A value and its place.
#[derive(Clone, Copy, Debug)]
pub struct Node<'a> {
    /// Where.
    pub path: Path<'a>,
    pub(super) raw: &'a RawValue,
}

impl<'a> Node<'a> {
    pub(super) fn number(&self) -> Result<f64, Refusal> {
        let text = self.raw.get();
        if kind(text) != "json-number" {
            return Err(self.wrong_type("json-number"));
        }
        match text.parse::<f64>() {
            Ok(x) if x.is_finite() => Ok(x),
            _ => {
                let problem = Message::new("case-not-finite").with("number", short(text));
                Err(Refusal::at(Code::NotFinite, &self.path, problem))
            }
        }
    }

    /// Numbers in lists of lists, appended to `out`.
    pub(super) fn numbers(
        &self,
        dims: &[Dim],
        detail: Detail,
        out: &mut Vec<f64>,
    ) -> Result<(), Refusal> {
        let [dim, inner @ ..] = dims else {
            out.push(self.number()?);
            return Ok(());
        };
        let expected = ["json-numbers", "json-points", "json-list"][inner.len().min(2)];
        let entries = self.entries(expected)?;
        let found = entries.len();
        match *dim {
            Dim::Exactly(n) if n != found => {
                let key = if inner.is_empty() {
                    "case-wrong-length"
                } else {
                    "case-wrong-points"
                };
                let problem = Message::new(key).with("expected", n).with("found", found);
                return Err(Refusal::at(Code::WrongLength, &self.path, problem));
            }
            Dim::UpTo(n) if found > detail.limit(n) => {
                let problem = Message::new("case-too-many");
                let problem = problem.with("found", found).with("max", n);
                return Err(Refusal::at(Code::TooLarge, &self.path, problem));
            }
            Dim::Exactly(_) | Dim::UpTo(_) => {}
        }
        for node in entries {
            node.numbers(inner, detail, out)?;
        }
        Ok(())
    }

    pub(super) fn wholes(&self, dims: &[Dim], detail: Detail) -> Result<Got, Refusal> {
        let mut rounded = Vec::new();
        self.numbers(dims, detail, &mut rounded)?;
        let wholes = self.entries("json-numbers")?.zip(rounded);
        let wholes = wholes.map(|(node, x)| match node.raw.get().parse() {
            Ok(exact) => Ok(exact),
            Err(_) if x.fract() != 0.0 => Err(node.wrong_type("json-whole")),
            // Written as 3.0 or 3e0.
            Err(_) if x.abs() < TWO_TO_53 => Ok(x as i64),
            Err(_) => {
                let problem = Message::new("case-whole-too-large");
                let problem = problem.with("number", short(node.raw.get()));
                Err(Refusal::at(Code::TooLarge, &node.path, problem))
            }
        });
        wholes.collect::<Result<_, _>>().map(Got::Wholes)
    }

    pub(super) fn text(&self) -> Result<String, Refusal> {
        serde_json::from_str(self.raw.get()).map_err(|_| self.wrong_type("json-text"))
    }

    pub(super) fn word(&self, words: &[&str]) -> Result<Got, Refusal> {
        let text = self.text()?;
        if words.contains(&&*text) {
            return Ok(Got::Text(text));
        }
        let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
        let problem = Message::new("case-wrong-word")
            .with("expected", words.join(", "))
            .with("found", short(&text));
        Err(Refusal::at(Code::WrongType, &self.path, problem))
    }

    pub(super) fn pairs(&self) -> Result<Pairs<'a>, Refusal> {
        serde_json::from_str(self.raw.get()).map_err(|_| self.wrong_type("json-object"))
    }

    pub(super) fn entries(
        &self,
        expected: &'static str,
    ) -> Result<impl ExactSizeIterator<Item = Node<'_>>, Refusal> {
        let entries: Vec<&'a RawValue> =
            serde_json::from_str(self.raw.get()).map_err(|_| self.wrong_type(expected))?;
        let entry = |(i, raw)| {
            let path = Path::Index(&self.path, i);
            Node { path, raw }
        };
        Ok(entries.into_iter().enumerate().map(entry))
    }

    pub(super) fn wrong_type(&self, expected: &'static str) -> Refusal {
        Refusal::at(Code::WrongType, &self.path, not_a(expected, self.raw))
    }
}

pub(super) fn not_a(expected: &'static str, found: &RawValue) -> Message {
    Message::new("case-wrong-type")
        .with("expected", Value::Term(expected))
        .with("found", Value::Term(kind(found.get())))
}

/// Catalogue key of the type of a JSON text.
fn kind(text: &str) -> &'static str {
    match text.as_bytes().first() {
        Some(b'{') => "json-object",
        Some(b'[') => "json-list",
        Some(b'"') => "json-text",
        Some(b't' | b'f') => "json-bool",
        Some(b'n') | None => "json-null",
        Some(_) => "json-number",
    }
}

/// An object's fields in the order in which they come, repeated ones included.
pub(super) struct Pairs<'a>(pub Vec<(String, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Pairs<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Collect;
        impl<'de> Visitor<'de> for Collect {
            type Value = Pairs<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Pairs<'de>, A::Error> {
                let mut pairs = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(Pairs(pairs))
            }
        }
        deserializer.deserialize_map(Collect)
    }
}

impl<'a> Pairs<'a> {
    pub fn get(&self, name: &str) -> Option<&'a RawValue> {
        let found = self.0.iter().find(|(given, _)| given == name);
        found.map(|(_, raw)| *raw)
    }

    /// Refuses the first field whose name has come before, at its place.
    pub fn check_once<'p>(&'p self, place: impl Fn(&'p str) -> Path<'p>) -> Result<(), Refusal> {
        let Some(name) = self.repeated() else {
            return Ok(());
        };
        let problem = Message::new("case-repeated-field").with("name", short(name));
        Err(Refusal::at(Code::BadJson, &place(name), problem))
    }

    fn repeated(&self) -> Option<&str> {
        let mut order: Vec<usize> = (0..self.0.len()).collect();
        order.sort_by_key(|&i| (&self.0[i].0, i));
        let again = |pair: &[usize]| (self.0[pair[0]].0 == self.0[pair[1]].0).then_some(pair[1]);
        let first = order.windows(2).filter_map(again).min()?;
        Some(&self.0[first].0)
    }
}

/// What a case calls itself: any JSON value, echoed digit for digit, without spaces.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Id(String);

impl Default for Id {
    fn default() -> Self {
        Self("null".to_owned())
    }
}

impl Id {
    pub(crate) fn read(name: &str, raw: &RawValue) -> Result<Self, Refusal> {
        let mut text = String::new();
        let problem = Message::new("case-bad-id");
        compact(raw.get(), 0, &mut text)
            .map(|()| Self(text))
            .ok_or_else(|| Refusal::at(Code::BadJson, &Path::Field(name), problem))
    }

    /// Is it none?
    #[must_use]
    pub fn is_null(&self) -> bool {
        self.0 == "null"
    }

    /// As JSON.
    #[must_use]
    pub fn json(&self) -> &str {
        &self.0
    }

    /// For a heading: a text without its quotes; `None` where the case has no id.
    #[must_use]
    pub fn name(&self) -> Option<String> {
        match kind(&self.0) {
            "json-null" => None,
            "json-text" => serde_json::from_str(&self.0).ok(),
            _ => Some(self.0.clone()),
        }
    }
}

impl Serialize for Id {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let raw: &RawValue = serde_json::from_str(&self.0).map_err(serde::ser::Error::custom)?;
        raw.serialize(serializer)
    }
}

/// Writes a value without spaces, its numbers digit for digit. `None` where it is nested too deep, or
/// where a text holds half a surrogate pair: scanning does not look into texts.
fn compact(text: &str, depth: usize, out: &mut String) -> Option<()> {
    if depth > MAX_DEPTH {
        return None;
    }
    match kind(text) {
        "json-list" => {
            let elements: Vec<&RawValue> = serde_json::from_str(text).ok()?;
            out.push('[');
            for (i, element) in elements.into_iter().enumerate() {
                if i > 0 {
                    out.push(',');
                }
                compact(element.get(), depth + 1, out)?;
            }
            out.push(']');
        }
        "json-object" => {
            let pairs: Pairs<'_> = serde_json::from_str(text).ok()?;
            out.push('{');
            for (i, (name, value)) in pairs.0.into_iter().enumerate() {
                if i > 0 {
                    out.push(',');
                }
                out.push_str(&serde_json::to_string(&name).ok()?);
                out.push(':');
                compact(value.get(), depth + 1, out)?;
            }
            out.push('}');
        }
        "json-text" => {
            let string: String = serde_json::from_str(text).ok()?;
            out.push_str(&serde_json::to_string(&string).ok()?);
        }
        _ => out.push_str(text),
    }
    Some(())
}
