//! Who a page is for.

/// With what is found out, or with room for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sheet {
    /// For who knows, or will check.
    Answers,
    /// For who works it out.
    Questions,
}

/// Room to write an answer.
pub const BLANK: &str = "…………";
