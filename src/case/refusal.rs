//! Why a case is refused.

use std::fmt;

use crate::{
    input::{At, Fault},
    text::{Catalog, Lang, Message},
};

/// A place in a case: `segment`, `clip[1][0]`, `frustum.near`.
#[derive(Clone, Copy, Debug)]
pub enum Path<'a> {
    /// A field of the case.
    Field(&'a str),
    /// An element of a list, from 0.
    Index(&'a Path<'a>, usize),
    /// A field of an object inside.
    Member(&'a Path<'a>, &'a str),
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Field(name) => f.write_str(name),
            Self::Index(list, i) => write!(f, "{list}[{i}]"),
            Self::Member(object, name) => write!(f, "{object}.{name}"),
        }
    }
}

/// The stable codes of the command line's JSON.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Code {
    /// Not JSON, not UTF-8, or a field given twice.
    BadJson,
    /// No lab knows this algorithm.
    UnknownAlgorithm,
    /// A field that this algorithm does not take.
    UnknownField,
    /// A field that it needs is not there.
    MissingField,
    /// A value of another type than expected.
    WrongType,
    /// A list that is too short or too long.
    WrongLength,
    /// A number beyond the range of an `f64`.
    NotFinite,
    /// A minimum that is not below its maximum.
    EmptyWindow,
    /// A clip polygon that turns both ways.
    NotConvex,
    /// An outline that crosses itself.
    SelfIntersecting,
    /// A shape without an extent where it needs one.
    Degenerate,
    /// More than is handled.
    TooLarge,
}

impl Code {
    /// Every code as JSON spells it, in the order of the variants.
    pub(super) const IDS: [(Self, &'static str); 12] = [
        (Self::BadJson, "bad-json"),
        (Self::UnknownAlgorithm, "unknown-algorithm"),
        (Self::UnknownField, "unknown-field"),
        (Self::MissingField, "missing-field"),
        (Self::WrongType, "wrong-type"),
        (Self::WrongLength, "wrong-length"),
        (Self::NotFinite, "not-finite"),
        (Self::EmptyWindow, "empty-window"),
        (Self::NotConvex, "not-convex"),
        (Self::SelfIntersecting, "self-intersecting"),
        (Self::Degenerate, "degenerate"),
        (Self::TooLarge, "too-large"),
    ];

    /// As JSON spells it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        Self::IDS[self as usize].1
    }
}

/// Why a case is refused, and where.
#[derive(Clone, PartialEq, Debug)]
pub struct Refusal {
    /// What kind of mistake.
    pub code: Code,
    /// Path into the case, such as `segment[2]`; empty where it is the case as a whole.
    pub field: String,
    /// What was expected and what is there.
    pub problem: Message,
}

impl Refusal {
    /// At a place in the case.
    #[must_use]
    pub fn at(code: Code, place: &Path<'_>, problem: Message) -> Self {
        Self {
            code,
            field: place.to_string(),
            problem,
        }
    }

    /// About the line as a whole.
    #[must_use]
    pub const fn whole(code: Code, problem: Message) -> Self {
        Self {
            code,
            field: String::new(),
            problem,
        }
    }

    /// A value of the right shape that means nothing, at the very place in it that is to blame; where a minimum is not
    /// below its maximum, the value as a whole.
    #[must_use]
    pub(super) fn of(value: &Path<'_>, Fault { at, what }: Fault) -> Self {
        let known = Code::IDS.into_iter().find(|(_, id)| *id == what.code);
        let code = known.map_or(Code::Degenerate, |(code, _)| code);
        let problem = what.message;
        match at {
            At::Entry(i) if code != Code::EmptyWindow => {
                Self::at(code, &Path::Index(value, i), problem)
            }
            At::Field(name) => Self::at(code, &Path::Member(value, name), problem),
            At::Entry(_) | At::Whole => Self::at(code, value, problem),
        }
    }

    /// The sentence of the JSON answer: English, like its keys.
    #[must_use]
    pub fn message(&self) -> String {
        Catalog::of(Lang::En).message(&self.problem)
    }

    /// Place and problem, for people.
    #[must_use]
    pub fn sentence(&self, catalog: &Catalog) -> String {
        if self.field.is_empty() {
            return catalog.message(&self.problem);
        }
        let said = Message::new("error-at")
            .with("place", short(&self.field))
            .with("problem", self.problem.clone());
        catalog.message(&said)
    }
}

/// What came from outside, cut to a length that a sentence can hold, on one line.
pub(crate) fn short(text: &str) -> String {
    const MAX_CHARS: usize = 60;
    let mut chars = text
        .chars()
        .map(|c| if c.is_control() { '\u{fffd}' } else { c });
    let head: String = chars.by_ref().take(MAX_CHARS).collect();
    if chars.next().is_some() {
        head + "…"
    } else {
        head
    }
}
