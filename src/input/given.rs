//! What a problem gives, for people.

use crate::text::Value;

/// One thing that a problem gives: "clip window: −1 ≤ x ≤ 1, −1 ≤ y ≤ 1".
#[derive(Clone, PartialEq, Debug)]
pub struct Given {
    /// Catalogue key of its name.
    pub name_key: &'static str,
    /// Set one after the other: the first of them, as many as are shown.
    pub values: Vec<Value>,
    /// How many there are.
    pub n_values: usize,
}

/// A polygon's vertices beyond these are not put into words.
const MAX_SHOWN: usize = 16;

impl Given {
    /// Of this name.
    pub fn new(name_key: &'static str, values: impl ExactSizeIterator<Item = Value>) -> Self {
        Self {
            name_key,
            n_values: values.len(),
            values: values.take(MAX_SHOWN).collect(),
        }
    }

    /// All that is told: these values.
    #[must_use]
    pub fn only<const N: usize>(name_key: &'static str, values: [Value; N]) -> Vec<Self> {
        vec![Self::new(name_key, values.into_iter())]
    }
}
