//! What every widget has to know to draw.

use crate::{paint::Theme, text::Catalog};

/// What every widget has to know to draw: the colours and the language.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    /// Colours and sizes.
    pub theme: &'a Theme,
    /// Words and numbers.
    pub catalog: &'a Catalog,
}

impl Look<'_> {
    /// A word or sentence without values.
    pub fn say(&self, key: &str) -> String {
        self.catalog.term(key)
    }
}
