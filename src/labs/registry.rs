//! Methods in the order in which they are taught: the same list for every lab.

use std::fmt;

use super::MethodCard;

/// What a lab knows of a method without running it.
pub trait Carded: Sync + Sized + 'static {
    /// Names, source and pseudocode.
    fn card(&self) -> &MethodCard;
}

/// What is known of the methods of the one lab that has such.
pub trait Listed: Carded {
    /// Every method, in the order in which they are taught.
    fn all() -> &'static [Self];
}

/// One of a lab's methods.
pub struct Method<I: 'static>(&'static I);

impl<I: Carded> Method<I> {
    /// The method of which this is known.
    #[must_use]
    pub const fn of(info: &'static I) -> Self {
        Self(info)
    }

    /// What is known of it.
    #[must_use]
    pub const fn info(self) -> &'static I {
        self.0
    }

    /// Its names, source and pseudocode.
    #[must_use]
    pub fn card(self) -> &'static MethodCard {
        self.0.card()
    }
}

impl<I: Listed> Method<I> {
    /// In the order of the registry.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        I::all().iter().map(Self)
    }

    /// The method with this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<Self> {
        Self::all().find(|method| method.card().id == id)
    }
}

impl<I> Clone for Method<I> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<I> Copy for Method<I> {}

impl<I: Carded> PartialEq for Method<I> {
    fn eq(&self, other: &Self) -> bool {
        self.card().id == other.card().id
    }
}

impl<I: Carded> Eq for Method<I> {}

impl<I: Carded> fmt::Debug for Method<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().id)
    }
}

impl<I: Carded> fmt::Display for Method<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().id)
    }
}
