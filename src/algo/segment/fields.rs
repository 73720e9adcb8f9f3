//! Events as JSON, where the dimension says what a field is called.

use serde::{Serialize, Serializer, ser::SerializeMap};

/// The fields of an event, its name first.
#[derive(Debug)]
pub struct Fields<S: Serializer>(S::SerializeMap);

impl<S: Serializer> Fields<S> {
    pub fn of(serializer: S, event: &str) -> Result<Self, S::Error> {
        Self(serializer.serialize_map(None)?).with("event", event)
    }

    pub fn with(mut self, name: &str, value: &(impl Serialize + ?Sized)) -> Result<Self, S::Error> {
        self.0.serialize_entry(name, value)?;
        Ok(self)
    }

    /// The ends of what is visible: in the plane four numbers, in space two places.
    pub fn with_ends<const N: usize>(self, ends: &[[f64; N]; 2]) -> Result<Self, S::Error> {
        if N == 2 {
            self.with("segment", ends.as_flattened())
        } else {
            self.with("ends", &ends.each_ref().map(|at| &at[..]))
        }
    }

    pub fn end(self) -> Result<S::Ok, S::Error> {
        self.0.end()
    }
}
