//! Methods in the order in which they are taught: the same list for every lab.

use std::fmt;

use super::MethodCard;

pub struct MethodEntry<I> {
    pub card: MethodCard,
    pub info: I,
}

pub trait Listed: Sized + 'static {
    fn all() -> &'static [MethodEntry<Self>];
}

pub struct Method<I: 'static>(&'static MethodEntry<I>);

impl<I> Method<I> {
    pub const fn of(entry: &'static MethodEntry<I>) -> Self {
        Self(entry)
    }

    pub const fn info(self) -> &'static I {
        &self.0.info
    }

    pub const fn card(self) -> &'static MethodCard {
        &self.0.card
    }
}

impl<I: Listed> Method<I> {
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        I::all().iter().map(Self)
    }

    /// But for those that are wrong on purpose, and for proofs.
    pub fn all_right() -> impl Iterator<Item = Self> {
        Self::all().filter(|method| !method.card().is_faulty && !method.card().is_proof)
    }

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
