//! The words of an event: its name and those of its fields that are words, without a detour through JSON.

use std::{
    fmt,
    io::{self, Write},
};

use serde::Serialize;
use serde_json::{Serializer, ser::Formatter};

const NAME: &str = "event";

/// A few words, the first of them a name, in one buffer that can be filled again and again.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Words {
    text: String,
    ends: Vec<usize>,
}

impl Words {
    pub fn push(&mut self, word: &str) {
        self.text.push_str(word);
        self.ends.push(self.text.len());
    }

    pub fn iter(&self) -> impl Iterator<Item = &str> {
        let starts = std::iter::once(&0).chain(&self.ends);
        starts
            .zip(&self.ends)
            .map(|(&start, &end)| &self.text[start..end])
    }

    pub fn name(&self) -> Self {
        self.iter().take(1).collect()
    }

    pub fn include(&self, wanted: &Self) -> bool {
        let mut rest = wanted.iter();
        rest.next() == self.iter().next() && rest.all(|word| self.iter().skip(1).any(|w| w == word))
    }

    /// Takes the words of an event in place of those that are here: what its JSON has as strings, in the same order.
    pub fn read(&mut self, event: &impl Serialize) {
        self.text.clear();
        self.ends.clear();
        let reader = Reader {
            words: self,
            word: String::new(),
            depth: 0,
            is_key: false,
            is_name: false,
        };
        // What cannot be written has no further words.
        let _ = event.serialize(&mut Serializer::with_formatter(io::sink(), reader));
    }

    fn push_name(&mut self, name: &str) {
        self.text.insert_str(0, name);
        self.ends.insert(0, 0);
        self.ends.iter_mut().for_each(|end| *end += name.len());
    }
}

impl fmt::Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut gap = "";
        for word in self.iter() {
            write!(f, "{gap}{word}")?;
            gap = " ";
        }
        Ok(())
    }
}

impl<'a> FromIterator<&'a str> for Words {
    fn from_iter<I: IntoIterator<Item = &'a str>>(words: I) -> Self {
        let mut all = Self::default();
        words.into_iter().for_each(|word| all.push(word));
        all
    }
}

/// Writes an event's JSON nowhere, and takes the strings among its fields.
struct Reader<'w> {
    words: &'w mut Words,
    /// What has come of a string: it comes in pieces.
    word: String,
    /// 1 among the event's own fields.
    depth: usize,
    is_key: bool,
    is_name: bool,
}

impl Formatter for Reader<'_> {
    fn begin_object<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.depth += 1;
        Ok(())
    }

    fn end_object<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.depth -= 1;
        Ok(())
    }

    fn begin_array<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.depth += 2;
        Ok(())
    }

    fn end_array<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.depth -= 2;
        Ok(())
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, _: &mut W, _: bool) -> io::Result<()> {
        self.is_key = true;
        Ok(())
    }

    fn end_object_key<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.is_key = false;
        Ok(())
    }

    fn write_string_fragment<W: ?Sized + Write>(&mut self, _: &mut W, s: &str) -> io::Result<()> {
        self.word.push_str(s);
        Ok(())
    }

    fn end_string<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        match self.depth {
            1 if self.is_key => self.is_name = self.word == NAME,
            1 if self.is_name => self.words.push_name(&self.word),
            1 => self.words.push(&self.word),
            _ => {}
        }
        self.word.clear();
        Ok(())
    }

    /// Digits take most of the time.
    fn write_f64<W: ?Sized + Write>(&mut self, _: &mut W, _: f64) -> io::Result<()> {
        Ok(())
    }
}
