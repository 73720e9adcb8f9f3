//! A case as it was written: values whose text is kept, each with its place.
//!
//! Numbers are read from their text, one by one, because a JSON library would refuse `1e999` as a mistake
//! of syntax, without a place; here it is a number that is not finite, in a field that has a name.

use std::fmt;

use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{MapAccess, Visitor},
};
use serde_json::value::RawValue;

use crate::text::{Message, Value};

use super::{Code, Path, Refusal, refusal::short};

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
    /// A number of an `f64`.
    ///
    /// # Errors
    /// `wrong-type` or `not-finite`
    pub fn number(&self) -> Result<f64, Refusal> {
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

    /// A list of exactly `N` numbers.
    ///
    /// # Errors
    /// `wrong-type`, `wrong-length` or `not-finite`
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N], Refusal> {
        let elements = self.elements("json-numbers")?;
        if elements.len() != N {
            return Err(self.wrong_length(N, elements.len()));
        }
        let mut numbers = [0.0; N];
        for (i, (number, raw)) in numbers.iter_mut().zip(elements).enumerate() {
            let path = Path::Index(&self.path, i);
            *number = Node { path, raw }.number()?;
        }
        Ok(numbers)
    }

    /// A list of exactly `N` whole numbers.
    ///
    /// # Errors
    /// `wrong-type`, `wrong-length`, `not-finite`, or `too-large` beyond an `i64`
    pub fn wholes<const N: usize>(&self) -> Result<[i64; N], Refusal> {
        let rounded: [f64; N] = self.numbers()?;
        let elements = self.elements("json-numbers")?;
        let mut wholes = [0; N];
        for (i, (whole, raw)) in wholes.iter_mut().zip(elements).enumerate() {
            let path = Path::Index(&self.path, i);
            *whole = match (raw.get().parse(), rounded[i]) {
                (Ok(exact), _) => exact,
                (Err(_), x) if x.fract() != 0.0 => {
                    return Err(Node { path, raw }.wrong_type("json-whole"));
                }
                // Written as 3.0 or 3e0.
                (Err(_), x) if x.abs() < TWO_TO_53 => x as i64,
                (Err(_), _) => {
                    let problem = Message::new("case-whole-too-large");
                    let problem = problem.with("number", short(raw.get()));
                    return Err(Refusal::at(Code::TooLarge, &path, problem));
                }
            };
        }
        Ok(wholes)
    }

    /// A list of exactly `R` points with `N` coordinates each.
    ///
    /// # Errors
    /// `wrong-type`, `wrong-length` or `not-finite`
    pub fn rows<const R: usize, const N: usize>(&self) -> Result<[[f64; N]; R], Refusal> {
        let elements = self.elements("json-points")?;
        if elements.len() != R {
            let problem = Message::new("case-wrong-points")
                .with("expected", R)
                .with("found", elements.len());
            return Err(Refusal::at(Code::WrongLength, &self.path, problem));
        }
        let mut rows = [[0.0; N]; R];
        for (i, (row, raw)) in rows.iter_mut().zip(elements).enumerate() {
            let path = Path::Index(&self.path, i);
            *row = Node { path, raw }.numbers()?;
        }
        Ok(rows)
    }

    /// A list of any number of points with `N` coordinates each, at most `max` of them.
    ///
    /// # Errors
    /// `wrong-type`, `wrong-length`, `not-finite`, or `too-large`
    pub fn points<const N: usize>(&self, max: usize) -> Result<Vec<[f64; N]>, Refusal> {
        let elements = self.elements("json-points")?;
        if elements.len() > max {
            let problem = Message::new("case-too-many")
                .with("found", elements.len())
                .with("max", max);
            return Err(Refusal::at(Code::TooLarge, &self.path, problem));
        }
        let point = |(i, raw)| {
            let path = Path::Index(&self.path, i);
            Node { path, raw }.numbers()
        };
        elements.into_iter().enumerate().map(point).collect()
    }

    /// A list, each element read by `read`, which is given its place.
    ///
    /// # Errors
    /// `wrong-type`, or what `read` refuses
    pub fn list<T>(
        &self,
        read: impl Fn(&Node<'_>) -> Result<T, Refusal>,
    ) -> Result<Vec<T>, Refusal> {
        let elements = self.elements("json-list")?;
        let element = |(i, raw)| {
            let path = Path::Index(&self.path, i);
            read(&Node { path, raw })
        };
        elements.into_iter().enumerate().map(element).collect()
    }

    /// A text.
    ///
    /// # Errors
    /// `wrong-type`
    pub fn text(&self) -> Result<String, Refusal> {
        serde_json::from_str(self.raw.get()).map_err(|_| self.wrong_type("json-text"))
    }

    /// One of several words.
    ///
    /// # Errors
    /// `wrong-type`, which tells the words
    pub fn choice<T: Copy>(&self, choices: &[(&'static str, T)]) -> Result<T, Refusal> {
        let text = self.text()?;
        let found = choices.iter().find(|(word, _)| *word == text);
        found.map(|&(_, value)| value).ok_or_else(|| {
            let words: Vec<String> = choices.iter().map(|(w, _)| format!("\"{w}\"")).collect();
            let problem = Message::new("case-wrong-word")
                .with("expected", words.join(", "))
                .with("found", short(&text));
            Refusal::at(Code::WrongType, &self.path, problem)
        })
    }

    /// An object's fields.
    pub(super) fn pairs(&self) -> Result<Pairs<'a>, Refusal> {
        serde_json::from_str(self.raw.get()).map_err(|_| self.wrong_type("json-object"))
    }

    fn elements(&self, expected: &'static str) -> Result<Vec<&'a RawValue>, Refusal> {
        serde_json::from_str(self.raw.get()).map_err(|_| self.wrong_type(expected))
    }

    fn wrong_type(&self, expected: &'static str) -> Refusal {
        let problem = Message::new("case-wrong-type")
            .with("expected", Value::Term(expected))
            .with("found", Value::Term(kind(self.raw.get())));
        Refusal::at(Code::WrongType, &self.path, problem)
    }

    fn wrong_length(&self, expected: usize, found: usize) -> Refusal {
        let problem = Message::new("case-wrong-length")
            .with("expected", expected)
            .with("found", found);
        Refusal::at(Code::WrongLength, &self.path, problem)
    }
}

/// Catalogue key of the type of a JSON text.
pub(super) fn kind(text: &str) -> &'static str {
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

impl Pairs<'_> {
    /// The first field whose name has come before.
    pub fn repeated(&self) -> Option<&str> {
        let mut order: Vec<usize> = (0..self.0.len()).collect();
        order.sort_by_key(|&i| (&self.0[i].0, i));
        let again = |pair: &[usize]| (self.0[pair[0]].0 == self.0[pair[1]].0).then_some(pair[1]);
        let first = order.windows(2).filter_map(again).min()?;
        Some(&self.0[first].0)
    }
}

/// What a case calls itself: any JSON value, echoed digit for digit, without spaces.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Id(String);

impl Default for Id {
    fn default() -> Self {
        Self("null".to_owned())
    }
}

impl Id {
    pub(super) fn read(raw: &RawValue) -> Result<Self, Refusal> {
        let mut text = String::new();
        match compact(raw.get(), 0, &mut text) {
            Some(()) => Ok(Self(text)),
            None => Err(Refusal::at(
                Code::BadJson,
                &Path::Field("id"),
                Message::new("case-bad-id"),
            )),
        }
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
