//! Are all numbers finite that something tells? A serializer that writes nothing.

use std::fmt;

use serde::{
    Serialize, Serializer,
    ser::{
        self, SerializeMap, SerializeSeq, SerializeStruct, SerializeStructVariant, SerializeTuple,
        SerializeTupleStruct, SerializeTupleVariant,
    },
};

/// What numbers may be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Numbers {
    /// None is infinite, or no number at all.
    Finite,
    /// Infinite ones stand for what is farther than everything.
    OrInfinite,
}

impl Numbers {
    pub(super) const fn have(self, x: f64) -> bool {
        match self {
            Self::Finite => x.is_finite(),
            Self::OrInfinite => !x.is_nan(),
        }
    }

    pub(super) fn have_all_of(self, told: &impl Serialize) -> bool {
        told.serialize(Look(self)).is_ok()
    }
}

#[derive(Clone, Copy)]
struct Look(Numbers);

/// One was found that is none of these.
#[derive(Debug)]
struct Other;

impl fmt::Display for Other {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number that is not finite")
    }
}

impl std::error::Error for Other {}

impl ser::Error for Other {
    fn custom<T: fmt::Display>(_: T) -> Self {
        Self
    }
}

/// Whatever else there is holds no number.
macro_rules! passes {
    ($($method:ident($($value:ty),*);)+) => {
        $(fn $method(self, $(_: $value),*) -> Result<(), Other> {
            Ok(())
        })+
    };
}

/// What is inside is looked at in turn.
macro_rules! looks_inside {
    ($($compound:ident: $method:ident($($name:ty)?);)+) => {
        $(impl $compound for Look {
            type Ok = ();
            type Error = Other;

            fn $method<T: ?Sized + Serialize>(&mut self, $(_: $name,)? value: &T) -> Result<(), Other> {
                value.serialize(*self)
            }

            fn end(self) -> Result<(), Other> {
                Ok(())
            }
        })+
    };
}

impl Serializer for Look {
    type Ok = ();
    type Error = Other;
    type SerializeSeq = Self;
    type SerializeTuple = Self;
    type SerializeTupleStruct = Self;
    type SerializeTupleVariant = Self;
    type SerializeMap = Self;
    type SerializeStruct = Self;
    type SerializeStructVariant = Self;

    fn serialize_f64(self, x: f64) -> Result<(), Other> {
        self.0.have(x).then_some(()).ok_or(Other)
    }

    fn serialize_f32(self, x: f32) -> Result<(), Other> {
        self.serialize_f64(x.into())
    }

    passes! {
        serialize_bool(bool);
        serialize_i8(i8);
        serialize_i16(i16);
        serialize_i32(i32);
        serialize_i64(i64);
        serialize_u8(u8);
        serialize_u16(u16);
        serialize_u32(u32);
        serialize_u64(u64);
        serialize_char(char);
        serialize_str(&str);
        serialize_bytes(&[u8]);
        serialize_none();
        serialize_unit();
        serialize_unit_struct(&'static str);
        serialize_unit_variant(&'static str, u32, &'static str);
    }

    fn serialize_some<T: ?Sized + Serialize>(self, value: &T) -> Result<(), Other> {
        value.serialize(self)
    }

    fn serialize_newtype_struct<T: ?Sized + Serialize>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), Other> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: ?Sized + Serialize>(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        value: &T,
    ) -> Result<(), Other> {
        value.serialize(self)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Self, Other> {
        Ok(self)
    }

    fn serialize_tuple(self, _: usize) -> Result<Self, Other> {
        Ok(self)
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Self, Other> {
        Ok(self)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, Other> {
        Ok(self)
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Self, Other> {
        Ok(self)
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Self, Other> {
        Ok(self)
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, Other> {
        Ok(self)
    }
}

looks_inside! {
    SerializeSeq: serialize_element();
    SerializeTuple: serialize_element();
    SerializeTupleStruct: serialize_field();
    SerializeTupleVariant: serialize_field();
    SerializeStruct: serialize_field(&'static str);
    SerializeStructVariant: serialize_field(&'static str);
}

impl SerializeMap for Look {
    type Ok = ();
    type Error = Other;

    fn serialize_key<T: ?Sized + Serialize>(&mut self, _: &T) -> Result<(), Other> {
        Ok(())
    }

    fn serialize_value<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Other> {
        value.serialize(*self)
    }

    fn end(self) -> Result<(), Other> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Serialize)]
    #[serde(tag = "event")]
    enum Event {
        Plain {
            at: [f64; 2],
            of: Option<(f32, f64)>,
            more: Vec<Inner>,
        },
        Flat {
            #[serde(flatten)]
            inner: Inner,
        },
    }

    #[derive(Serialize)]
    struct Inner {
        x: f64,
        word: &'static str,
    }

    #[test]
    fn numbers_are_found_however_deep_they_lie() {
        let event = |x: f64, y: f64, z: f64| Event::Plain {
            at: [0.0, x],
            of: Some((1.0, y)),
            more: vec![Inner { x: z, word: "" }],
        };
        let flat = |x: f64| Event::Flat {
            inner: Inner { x, word: "inf" },
        };
        let have = |numbers: Numbers, told: &Event| numbers.have_all_of(told);
        for (number, finite, or_infinite) in [
            (f64::MAX, true, true),
            (f64::NEG_INFINITY, false, true),
            (f64::NAN, false, false),
        ] {
            for told in [
                event(number, 0.0, 0.0),
                event(0.0, number, 0.0),
                event(0.0, 0.0, number),
                flat(number),
            ] {
                assert_eq!(have(Numbers::Finite, &told), finite, "{number}");
                assert_eq!(have(Numbers::OrInfinite, &told), or_infinite, "{number}");
            }
        }
        let none = Event::Plain {
            at: [0.0; 2],
            of: None,
            more: Vec::new(),
        };
        assert!(
            have(Numbers::Finite, &none),
            "what is left out is no number"
        );
    }
}
