//! A step of a run, as it is told, whichever method it is of.

use crate::text::Value;

use super::{frame::Caption, role::Link, view::View, watch::Watch};

/// A step of a run. Nothing is worked out before it is asked for.
pub trait Shown {
    /// The sentence and the formulas.
    fn caption(&self) -> Caption;
    /// The values that are alive: none is marked as changed.
    fn watch(&self) -> Watch;
    /// First the drawing, then what the method holds.
    fn views(&self) -> Vec<View>;

    /// What the step is about, and what it decides about that.
    fn decision(&self) -> Option<(Decides, Link)> {
        None
    }

    /// The question that the step answers, as its method calls it.
    fn question(&self) -> Option<&'static str> {
        None
    }

    /// What might come at this step, and which of these does; none where the step answers no question.
    fn options(&self) -> Option<Choice> {
        None
    }
}

/// What an event does to what it is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Decides {
    /// It decides nothing.
    Nothing,
    /// What it is about stays as it is.
    Keeps,
    /// A part of what it is about is cut off.
    Cuts,
    /// What it is about is left out.
    Drops,
}

/// The options at a step's question.
#[derive(Clone, PartialEq, Debug)]
pub struct Choice {
    /// Which of the method's questions it is.
    pub question: &'static str,
    /// What might come.
    pub options: Vec<Value>,
    /// Which of these does.
    pub right: usize,
}
