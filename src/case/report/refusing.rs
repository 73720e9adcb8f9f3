//! A refusal among many, for those who keep count.

use crate::{
    case::Refused,
    text::{Catalog, Message},
};

use super::case_name;

/// A case that was refused, for those who keep count.
#[derive(Clone, Copy, Debug)]
pub struct Refusing<'a> {
    /// The line that it stands in, from 1; empty lines count.
    pub line: usize,
    /// How many cases came before it, and one.
    pub number: usize,
    /// Which, and why.
    pub refused: &'a Refused,
}

impl Refusing<'_> {
    /// Where it stands, which it is, and why it is refused, for people.
    #[must_use]
    pub fn sentence(&self, catalog: &Catalog) -> String {
        let case = case_name(self.number, &self.refused.id, catalog);
        let message = Message::new("trace-refused-at")
            .with("line", self.line)
            .with("case", case.to_lowercase())
            .with("problem", self.refused.refusal.sentence(catalog));
        catalog.message(&message)
    }
}
