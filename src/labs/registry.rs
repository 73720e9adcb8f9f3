//! Methods in the order in which they are taught: the same list for every lab.

use std::fmt;

use super::MethodCard;

/// A line of a lab's table of methods: what the lab knows of a method without running it.
pub struct MethodEntry<I> {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// What only this lab knows of its methods.
    pub info: I,
}

/// What only one lab knows of its methods.
pub trait Listed: Sized + 'static {
    /// Every method of that lab, in the order in which they are taught.
    fn all() -> &'static [MethodEntry<Self>];
}

/// One of a lab's methods.
pub struct Method<I: 'static>(&'static MethodEntry<I>);

impl<I> Method<I> {
    /// The method of this line of the table.
    pub const fn of(entry: &'static MethodEntry<I>) -> Self {
        Self(entry)
    }

    /// What only its lab knows of it.
    pub const fn info(self) -> &'static I {
        &self.0.info
    }

    /// Its names, source and pseudocode.
    pub const fn card(self) -> &'static MethodCard {
        &self.0.card
    }
}

impl<I: Listed> Method<I> {
    /// In the order of the registry.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        I::all().iter().map(Self)
    }

    /// The method with this id.
    pub fn by_id(id: &str) -> Option<Self> {
        Self::all().find(|method| method.card().id == id)
    }

    /// Uses the method with this id instead; an unknown one is ignored. What stands `beside` goes where it is the same.
    pub fn change(&mut self, beside: &mut Option<Self>, id: &str) {
        if let Some(method) = Self::by_id(id) {
            *self = method;
            *beside = beside.filter(|&other| other != method);
        }
    }
}

impl<I> Clone for Method<I> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<I> Copy for Method<I> {}

impl<I> PartialEq for Method<I> {
    fn eq(&self, other: &Self) -> bool {
        self.card().id == other.card().id
    }
}

impl<I> Eq for Method<I> {}

impl<I> fmt::Debug for Method<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().id)
    }
}

impl<I> fmt::Display for Method<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().id)
    }
}
