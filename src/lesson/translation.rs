//! A lesson's text in a language other than English.

use std::{
    fmt,
    sync::{Arc, LazyLock},
};

use super::reference::WrittenText;

type Reading = Box<dyn FnOnce() -> Option<WrittenText> + Send>;

/// It may be read only once someone asks for it: most readers never need three of the four languages.
#[derive(Clone)]
pub(super) struct Translation(Arc<LazyLock<Option<WrittenText>, Reading>>);

impl Translation {
    pub fn later(read: impl FnOnce() -> Option<WrittenText> + Send + 'static) -> Self {
        Self(Arc::new(LazyLock::new(Box::new(read))))
    }

    /// None where it could not be read.
    pub fn text(&self) -> Option<&WrittenText> {
        LazyLock::force(&self.0).as_ref()
    }
}

impl From<WrittenText> for Translation {
    fn from(text: WrittenText) -> Self {
        Self::later(|| Some(text))
    }
}

impl PartialEq for Translation {
    fn eq(&self, other: &Self) -> bool {
        self.text() == other.text()
    }
}

impl fmt::Debug for Translation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text().fmt(f)
    }
}
