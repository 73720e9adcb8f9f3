//! Moments: places in a run, named by what happens there.

use std::{fmt, str::FromStr};

use crate::text::{Diagnostic, Message};

use super::words::Words;

/// A place in a run that a lesson can name: `start`, `end`, `cut`, `cut left`, `code p1 #2`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Moment {
    Start,
    End,
    Event { words: Words, nth: usize },
}

impl Moment {
    pub fn of_any_kind(&self) -> Self {
        match self {
            Self::Start => Self::Start,
            Self::End => Self::End,
            Self::Event { words, nth } => Self::Event {
                words: words.name(),
                nth: *nth,
            },
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MomentError {
    Empty,
    BadNumber,
}

impl From<MomentError> for Diagnostic {
    fn from(error: MomentError) -> Self {
        Self::new(Message::new("error-bad-moment")).noting(Message::new(match error {
            MomentError::Empty => "expect-moment",
            MomentError::BadNumber => "expect-moment-number",
        }))
    }
}

impl fmt::Display for MomentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Diagnostic::from(*self).fmt(f)
    }
}

impl std::error::Error for MomentError {}

impl FromStr for Moment {
    type Err = MomentError;

    fn from_str(text: &str) -> Result<Self, MomentError> {
        let (words, nth) = match text.split_once('#') {
            None => (text, 1),
            Some((words, number)) => match number.trim().parse() {
                Ok(nth) if nth >= 1 => (words, nth),
                _ => return Err(MomentError::BadNumber),
            },
        };
        match words.trim() {
            "" => Err(MomentError::Empty),
            "start" => Ok(Self::Start),
            "end" => Ok(Self::End),
            words => Ok(Self::Event {
                words: words.split_whitespace().collect(),
                nth,
            }),
        }
    }
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start => f.write_str("start"),
            Self::End => f.write_str("end"),
            Self::Event { words, nth: 1 } => words.fmt(f),
            Self::Event { words, nth } => write!(f, "{words} #{nth}"),
        }
    }
}
