//! What a person can take hold of on the stage, by mouse or by keyboard. A lab names its own handles, their groups
//! and how each may move; whoever shows them knows none by name.

use crate::{figure::Link, text::Message};

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Motion {
    Plane,
    Axis([f64; 3]),
    /// In the plane through it that faces the eye.
    FacingEye,
}

/// A kind of handle: each lab lists its own.
#[derive(Debug)]
pub struct HandleKind {
    /// Unique in its lab.
    pub id: &'static str,
    pub group: &'static str,
    pub motion: Motion,
    /// Does it move with an offset to the pointer, as a whole, and not to a place of its own?
    pub is_whole: bool,
    /// Is it one of a row, so that it can be taken out and another put in after it?
    pub is_vertex: bool,
    /// Does the figure draw a mark where it lies, so that the handle needs none?
    pub is_marked: bool,
    /// What the handle of this number is, for a screen reader.
    pub name: fn([usize; 2]) -> Message,
    /// What the scene has of this kind goes by these links wherever a step tells of it.
    pub link: Option<fn([usize; 2]) -> Link>,
}

impl HandleKind {
    pub const fn new(
        id: &'static str,
        group: &'static str,
        name: fn([usize; 2]) -> Message,
    ) -> Self {
        Self {
            id,
            group,
            motion: Motion::Plane,
            is_whole: false,
            is_vertex: false,
            is_marked: false,
            link: None,
            name,
        }
    }

    pub const fn at(&'static self, idx: [usize; 2]) -> Handle {
        Handle { kind: self, idx }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Handle {
    kind: &'static HandleKind,
    idx: [usize; 2],
}

impl PartialEq for Handle {
    fn eq(&self, other: &Self) -> bool {
        self.is(other.kind) && self.idx == other.idx
    }
}

impl Eq for Handle {}

impl Handle {
    pub const fn kind(self) -> &'static HandleKind {
        self.kind
    }

    /// Is it no figure that is taken hold of as a whole, of parts that are taken hold of as well?
    pub const fn is_part(self) -> bool {
        !self.kind.is_whole || self.kind.is_vertex
    }

    pub fn is(self, kind: &HandleKind) -> bool {
        self.kind.id == kind.id
    }

    pub const fn idx(self) -> [usize; 2] {
        self.idx
    }

    pub const fn group(self) -> &'static str {
        self.kind.group
    }

    pub fn name(self) -> Message {
        (self.kind.name)(self.idx)
    }

    pub fn link(self) -> Option<Link> {
        self.kind.link.map(|link| link(self.idx))
    }
}
