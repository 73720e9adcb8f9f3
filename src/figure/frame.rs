//! Everything that one step shows.

use crate::{
    text::{Formula, Message, Value},
    trace::Counts,
};

use super::{Link, Mark, Watch};

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

/// What a crossing does to the interval on a [`NumberLine`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// The line comes in: pushes the lower end up.
    Entering,
    /// The line goes out: pulls the upper end down.
    Leaving,
}

/// A value on a [`NumberLine`].
#[derive(Clone, PartialEq, Debug)]
pub struct LineTick {
    /// Where.
    pub u: f64,
    /// Which bound it belongs to.
    pub side: Side,
    /// Does it hold the bound now?
    pub holds: bool,
    /// Is it this step's?
    pub current: bool,
    /// The border's name.
    pub name: Value,
    /// What it is about.
    pub link: Option<Link>,
}

/// The second view of parametric clippers: the interval of the parameter that is left.
#[derive(Clone, PartialEq, Debug)]
pub struct NumberLine {
    /// `u` or `t`.
    pub symbol: &'static str,
    /// Lower and upper bound so far; the interval is empty where they are out of order.
    pub interval: [f64; 2],
    /// Nothing is left: the bounds have passed each other.
    pub empty: bool,
    /// Every crossing computed so far.
    pub ticks: Vec<LineTick>,
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
    pub number_line: Option<NumberLine>,
    /// Operations done so far.
    pub counts: Counts,
}
