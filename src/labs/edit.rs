//! What a person can do to a scene, whichever lab it is of.

use std::sync::Arc;

use crate::text::Diagnostic;

use super::{Change, Handle, Own, Scene};

#[derive(Clone, Debug)]
pub enum Edit {
    Method(&'static str),
    Compare(Option<&'static str>),
    Drag(Handle, [f64; 3]),
    /// Gives a handle the number that it stands for.
    Measure(Handle, f64),
    /// One more of what the lab has many of, after this handle's.
    Add(Option<Handle>),
    /// One less: without this handle's.
    Remove(Option<Handle>),
    Replace(Scene),
    /// The same scene, smaller: what is seen of it stays as it is.
    Reduce(Scene),
    Own(Own),
}

impl Edit {
    pub fn own(change: impl Change + 'static) -> Self {
        Self::Own(Arc::new(change))
    }

    pub fn brings_another(&self) -> bool {
        match self {
            Self::Replace(_) => true,
            Self::Own(change) => change.brings_another(),
            Self::Method(_)
            | Self::Compare(_)
            | Self::Reduce(_)
            | Self::Drag(..)
            | Self::Measure(..)
            | Self::Add(_)
            | Self::Remove(_) => false,
        }
    }

    /// Makes the change; the handle to select next, if there is a new one. One for another lab changes nothing.
    /// Where the scene would not be valid it is left as it was.
    pub fn apply(self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic> {
        let document = scene.document_mut();
        match self {
            Self::Method(id) => document.set_method(id),
            Self::Compare(id) => document.set_compare(id),
            Self::Drag(handle, to) => document.drag(handle, to)?,
            Self::Measure(handle, to) => document.set_measure(handle, to)?,
            Self::Add(after) => return document.add(after),
            Self::Remove(handle) => document.remove(handle)?,
            Self::Replace(other) | Self::Reduce(other) => *scene = other,
            Self::Own(change) => return change.apply(scene),
        }
        Ok(None)
    }
}
