//! What marks mean, and what they are about.

/// What a mark means. Each role differs by colour and also by dash, weight, fill or marker.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Role {
    /// Given: the window, a border.
    Ink,
    /// Given, and of less weight: an extended border, a region's code.
    Soft,
    /// May be missed: construction lines, segments that are not in focus.
    Faint,
    /// The living result, and what is selected.
    Accent,
    /// What happens at this step, and nothing else.
    Signal,
    /// Accepted.
    Accepted,
    /// Discarded: grey, and always dashed or hollow.
    Discarded,
}

/// A name, numbered where there are many of its kind, by which a mark, its row in the watch table, a tick on
/// the number line and a line of pseudocode know that they are about the same thing: they light up together.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub struct Link {
    name: &'static str,
    nth: Option<usize>,
}

impl Link {
    /// About the one thing of this name.
    pub const fn to(name: &'static str) -> Self {
        Self { name, nth: None }
    }

    /// Which of many of this name it is about.
    pub fn number_of(self, name: &str) -> Option<usize> {
        self.nth.filter(|_| self.name == name)
    }

    /// About one of many: vertex 3, edge 0.
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
