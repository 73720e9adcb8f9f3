//! What marks mean, what they are about, and the text beside them.

use crate::text::Value;

/// What a mark means. Each role differs by colour and also by dash, weight, fill or marker.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Role {
    Ink,
    /// Given, and of less weight: an extended border, a region's code.
    Soft,
    /// May be missed: construction lines, segments that are not in focus.
    Faint,
    Accent,
    /// What happens at this step, and nothing else.
    Signal,
    Accepted,
    /// Discarded: grey, and always dashed or hollow.
    Discarded,
}

/// What marks, rows, ticks and lines of pseudocode are about: those about the same light up together.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub struct Link {
    name: &'static str,
    nth: Option<usize>,
}

impl Link {
    pub const fn to(name: &'static str) -> Self {
        Self { name, nth: None }
    }

    pub fn number_of(self, name: &str) -> Option<usize> {
        self.nth.filter(|_| self.name == name)
    }

    pub const fn nth(name: &'static str, idx: usize) -> Self {
        Self {
            name,
            nth: Some(idx),
        }
    }
}

impl From<&'static str> for Link {
    fn from(name: &'static str) -> Self {
        Self::to(name)
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct Label {
    pub text: Value,
    pub mono: bool,
    pub strong: bool,
    /// The direction, in the world, in which it has to stand off its mark; for an inequality, where it holds.
    pub toward: Option<[f64; 2]>,
    /// The character, by its index, that is this step's: drawn in the signal's colour, as one bit of a code.
    pub lit: Option<usize>,
}

/// How a mark of the plane and one of space are told alike: what is written beside it, and what it is about.
macro_rules! told {
    ($mark:ty) => {
        impl $mark {
            pub fn labelled(mut self, text: impl Into<Value>) -> Self {
                self.label = Some(Label::new(text, false));
                self
            }

            pub fn strong(mut self) -> Self {
                if let Some(label) = &mut self.label {
                    label.strong = true;
                }
                self
            }

            pub const fn dashed(mut self) -> Self {
                self.is_dashed = true;
                self
            }

            pub fn linked(mut self, link: impl Into<Link>) -> Self {
                self.link = Some(link.into());
                self
            }
        }
    };
}

pub(super) use told;

impl Label {
    pub(super) fn new(text: impl Into<Value>, mono: bool) -> Self {
        Self {
            text: text.into(),
            mono,
            strong: false,
            toward: None,
            lit: None,
        }
    }
}
