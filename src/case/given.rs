//! What a problem gives, for people.

use crate::text::Value;

/// One thing that a problem gives: "clip window: −1 ≤ x ≤ 1, −1 ≤ y ≤ 1".
#[derive(Clone, PartialEq, Debug)]
pub struct Given {
    /// Catalogue key of its name.
    pub name_key: &'static str,
    /// Set one after the other.
    pub values: Vec<Value>,
}
