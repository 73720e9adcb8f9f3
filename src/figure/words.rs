//! The words of an event: its name and those of its fields that are words, without a detour through JSON.

use std::fmt::{self, Error as NoWord};

use serde::{
    Serialize, Serializer,
    ser::{Impossible, SerializeMap, SerializeStruct},
};

/// The field that holds an event's name.
const NAME: &str = "event";

/// A few words, the first of them a name, in one buffer that can be filled again and again.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Words {
    text: String,
    /// Where each word ends in the text.
    ends: Vec<usize>,
}

impl Words {
    /// One more word.
    pub fn push(&mut self, word: &str) {
        self.text.push_str(word);
        self.ends.push(self.text.len());
    }

    /// In order.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        let starts = std::iter::once(&0).chain(&self.ends);
        starts
            .zip(&self.ends)
            .map(|(&start, &end)| &self.text[start..end])
    }

    /// The name alone.
    pub fn name(&self) -> Self {
        self.iter().take(1).collect()
    }

    /// The same name, and all other words of `wanted` among these?
    pub fn include(&self, wanted: &Self) -> bool {
        let mut rest = wanted.iter();
        rest.next() == self.iter().next() && rest.all(|word| self.iter().skip(1).any(|w| w == word))
    }

    /// Takes the words of an event in place of those that are here: what its JSON has as strings, in the same order.
    pub fn read(&mut self, event: &impl Serialize) {
        self.text.clear();
        self.ends.clear();
        // What is no event, a number say, has no words.
        let _ = event.serialize(Reader {
            words: self,
            at: At::Event,
        });
    }

    fn push_name(&mut self, name: &str) {
        self.text.insert_str(0, name);
        self.ends.insert(0, 0);
        self.ends.iter_mut().for_each(|end| *end += name.len());
    }
}

/// Set apart by spaces.
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

/// Where in an event a [`Reader`] is.
#[derive(Clone, Copy)]
enum At {
    Event,
    Name,
    Field,
}

/// Takes words out of what is serialized; to everything else it says that it is none.
struct Reader<'w> {
    words: &'w mut Words,
    at: At,
}

impl Reader<'_> {
    fn field(&mut self, at: At, value: &(impl Serialize + ?Sized)) {
        // A field that is no word is passed over.
        let _ = value.serialize(Reader {
            words: self.words,
            at,
        });
    }

    fn fields(self) -> Result<Self, NoWord> {
        match self.at {
            At::Event => Ok(self),
            At::Name | At::Field => Err(NoWord),
        }
    }
}

impl SerializeStruct for Reader<'_> {
    type Ok = ();
    type Error = NoWord;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        key: &'static str,
        value: &T,
    ) -> Result<(), NoWord> {
        let at = if key == NAME { At::Name } else { At::Field };
        self.field(at, value);
        Ok(())
    }

    fn end(self) -> Result<(), NoWord> {
        Ok(())
    }
}

/// Events with another struct's fields among theirs come as maps.
impl SerializeMap for Reader<'_> {
    type Ok = ();
    type Error = NoWord;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), NoWord> {
        let mut name = Words::default();
        key.serialize(Reader {
            words: &mut name,
            at: At::Field,
        })?;
        self.at = if name.text == NAME {
            At::Name
        } else {
            At::Field
        };
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoWord> {
        self.field(self.at, value);
        Ok(())
    }

    fn end(self) -> Result<(), NoWord> {
        Ok(())
    }
}

macro_rules! no_words {
    ($($method:ident($type:ty)),*) => {
        $(fn $method(self, _: $type) -> Result<(), NoWord> {
            Err(NoWord)
        })*
    };
}

impl Serializer for Reader<'_> {
    type Ok = ();
    type Error = NoWord;
    type SerializeSeq = Impossible<(), NoWord>;
    type SerializeTuple = Impossible<(), NoWord>;
    type SerializeTupleStruct = Impossible<(), NoWord>;
    type SerializeTupleVariant = Impossible<(), NoWord>;
    type SerializeMap = Self;
    type SerializeStruct = Self;
    type SerializeStructVariant = Impossible<(), NoWord>;

    fn serialize_str(self, word: &str) -> Result<(), NoWord> {
        match self.at {
            At::Event => return Err(NoWord),
            At::Name => self.words.push_name(word),
            At::Field => self.words.push(word),
        }
        Ok(())
    }

    fn serialize_char(self, word: char) -> Result<(), NoWord> {
        self.serialize_str(word.encode_utf8(&mut [0; 4]))
    }

    fn serialize_unit_variant(
        self,
        _: &'static str,
        _: u32,
        word: &'static str,
    ) -> Result<(), NoWord> {
        self.serialize_str(word)
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), NoWord> {
        value.serialize(self)
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), NoWord> {
        value.serialize(self)
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Self, NoWord> {
        self.fields()
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Self, NoWord> {
        self.fields()
    }

    no_words!(
        serialize_bool(bool),
        serialize_i8(i8),
        serialize_i16(i16),
        serialize_i32(i32),
        serialize_i64(i64),
        serialize_u8(u8),
        serialize_u16(u16),
        serialize_u32(u32),
        serialize_u64(u64),
        serialize_f32(f32),
        serialize_f64(f64),
        serialize_bytes(&[u8]),
        serialize_unit_struct(&'static str)
    );

    fn serialize_none(self) -> Result<(), NoWord> {
        Err(NoWord)
    }

    fn serialize_unit(self) -> Result<(), NoWord> {
        Err(NoWord)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: &T,
    ) -> Result<(), NoWord> {
        Err(NoWord)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Self::SerializeSeq, NoWord> {
        Err(NoWord)
    }

    fn serialize_tuple(self, _: usize) -> Result<Self::SerializeTuple, NoWord> {
        Err(NoWord)
    }

    fn serialize_tuple_struct(
        self,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeTupleStruct, NoWord> {
        Err(NoWord)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeTupleVariant, NoWord> {
        Err(NoWord)
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeStructVariant, NoWord> {
        Err(NoWord)
    }
}
