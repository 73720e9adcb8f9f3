//! One line of answers: whose it is, and what it says.

use std::{fmt, ops::Range};

use serde::{
    Deserialize, Deserializer,
    de::{DeserializeSeed, IgnoredAny, MapAccess, Visitor},
};
use serde_json::value::RawValue;

use crate::{
    case::{CaseLine, Id, MAX_LINE_BYTES},
    text::Message,
};

/// An answer as it was read.
#[derive(Clone, Debug)]
pub(super) struct Answer {
    /// Counted from 1.
    pub line: usize,
    /// None where it says none; known even of a broken line, where it stood before the mistake.
    pub id: Option<Id>,
    pub submission: Option<Id>,
    text: String,
    parts: Result<Parts, Message>,
}

/// Where in the line they stand.
#[derive(Clone, Default, Debug)]
struct Parts {
    output: Option<Range<usize>>,
    events: Option<Range<usize>>,
    is_refusal: bool,
}

/// What an answer says, as it was written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Said<'a> {
    pub output: Option<&'a str>,
    pub events: Option<&'a str>,
    pub is_refusal: bool,
}

impl Answer {
    pub(super) fn read(line: usize, content: CaseLine<'_>) -> Self {
        let mut answer = Self {
            line,
            id: None,
            submission: None,
            text: String::new(),
            parts: Ok(Parts::default()),
        };
        let problem = match content {
            CaseLine::TooLong => {
                Message::new("case-line-too-long").with("max", MAX_LINE_BYTES >> 20)
            }
            CaseLine::Bytes(bytes) => match std::str::from_utf8(bytes) {
                Err(error) => Message::new("case-not-utf8").with("byte", error.valid_up_to() + 1),
                Ok(text) => match answer.fill(text) {
                    Ok(()) => return answer,
                    Err(error) if error.is_data() => Message::new("grade-no-object"),
                    Err(error) => Message::new("case-bad-json").with("column", error.column()),
                },
            },
        };
        answer.parts = Err(problem);
        answer
    }

    fn fill(&mut self, text: &str) -> serde_json::Result<()> {
        let (mut found, mut parts) = (Found::default(), Parts::default());
        let mut json = serde_json::Deserializer::from_str(text);
        let read = (&mut found).deserialize(&mut json);
        let read = read.and_then(|()| json.end());
        let id = |raw: Option<&RawValue>| {
            let id = Id::read("id", raw?).ok()?;
            (!id.is_null()).then_some(id)
        };
        (self.id, self.submission) = (id(found.id), id(found.submission));
        read?;
        let place = |raw: &RawValue| {
            let at = raw.get().as_ptr() as usize - text.as_ptr() as usize;
            at..at + raw.get().len()
        };
        parts.output = found.output.map(place);
        parts.events = found.events.map(place);
        let is_refusal = |raw: &RawValue| !matches!(raw.get(), "null" | "false");
        parts.is_refusal = found.error.is_some_and(is_refusal);
        text.clone_into(&mut self.text);
        self.parts = Ok(parts);
        Ok(())
    }

    /// What it says; why it cannot be read, where it cannot.
    pub(super) fn said(&self) -> Result<Said<'_>, &Message> {
        let part = |place: &Option<Range<usize>>| place.clone().map(|place| &self.text[place]);
        self.parts.as_ref().map(|parts| Said {
            output: part(&parts.output),
            events: part(&parts.events),
            is_refusal: parts.is_refusal,
        })
    }

    /// Has it neither an id nor any sense?
    pub(super) const fn is_noise(&self) -> bool {
        self.parts.is_err() && self.id.is_none()
    }

    pub(super) const fn n_bytes(&self) -> usize {
        self.text.len()
    }
}

/// Filled as fields come, so that what stood before a mistake is known.
#[derive(Default)]
struct Found<'a> {
    id: Option<&'a RawValue>,
    submission: Option<&'a RawValue>,
    output: Option<&'a RawValue>,
    events: Option<&'a RawValue>,
    error: Option<&'a RawValue>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Key {
    Id,
    Submission,
    Output,
    Events,
    Error,
    #[serde(other)]
    Other,
}

impl<'de> DeserializeSeed<'de> for &mut Found<'de> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for &mut Found<'de> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key()? {
            let place = match key {
                Key::Id => &mut self.id,
                Key::Submission => &mut self.submission,
                Key::Output => &mut self.output,
                Key::Events => &mut self.events,
                Key::Error => &mut self.error,
                Key::Other => {
                    map.next_value::<IgnoredAny>()?;
                    continue;
                }
            };
            *place = Some(map.next_value()?);
        }
        Ok(())
    }
}
