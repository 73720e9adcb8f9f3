//! Everything that one step shows.

use crate::{
    text::{Formula, Message},
    trace::Counts,
};

use super::{Mark, Second, Watch};

/// One sentence: the decision, then the arithmetic that led to it.
#[derive(Clone, PartialEq, Debug)]
pub struct Caption {
    /// Set semibold.
    pub decision: Message,
    /// Set after it, one after the other.
    pub arithmetic: Vec<Formula>,
}

impl Caption {
    /// A decision without arithmetic yet.
    #[must_use]
    pub const fn new(decision: Message) -> Self {
        Self {
            decision,
            arithmetic: Vec::new(),
        }
    }

    /// With one more formula.
    #[must_use]
    pub fn so(mut self, formula: Formula) -> Self {
        self.arithmetic.push(formula);
        self
    }
}

/// The display list of one step.
#[derive(Clone, PartialEq, Debug)]
pub struct Frame {
    /// In painting order.
    pub marks: Vec<Mark>,
    /// This step's sentence.
    pub caption: Caption,
    /// Index into the method's pseudocode.
    pub code_line: Option<usize>,
    /// The values that are alive.
    pub watch: Watch,
    /// The second view, where the method has one.
    pub second: Option<Second>,
    /// Operations done so far.
    pub counts: Counts,
}
