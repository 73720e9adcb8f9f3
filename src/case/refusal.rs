//! Why a case is refused.

use crate::{
    geom::{GeomError, SpaceError},
    text::{Catalog, Diagnostic, Lang, Message},
};

use super::Path;

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
    /// As JSON spells it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::BadJson => "bad-json",
            Self::UnknownAlgorithm => "unknown-algorithm",
            Self::UnknownField => "unknown-field",
            Self::MissingField => "missing-field",
            Self::WrongType => "wrong-type",
            Self::WrongLength => "wrong-length",
            Self::NotFinite => "not-finite",
            Self::EmptyWindow => "empty-window",
            Self::NotConvex => "not-convex",
            Self::SelfIntersecting => "self-intersecting",
            Self::Degenerate => "degenerate",
            Self::TooLarge => "too-large",
        }
    }
}

impl From<GeomError> for Code {
    fn from(error: GeomError) -> Self {
        match error {
            GeomError::NotFinite { .. } => Self::NotFinite,
            GeomError::EmptyWindow { .. } => Self::EmptyWindow,
            GeomError::TooFewVertices | GeomError::Degenerate { .. } => Self::Degenerate,
            GeomError::NotConvex { .. } => Self::NotConvex,
            GeomError::SelfIntersecting { .. }
            | GeomError::EdgesMeet { .. }
            | GeomError::MisplacedHole { .. } => Self::SelfIntersecting,
        }
    }
}

impl From<SpaceError> for Code {
    fn from(error: SpaceError) -> Self {
        match error {
            SpaceError::NotFinite { .. } => Self::NotFinite,
            SpaceError::EmptyBox { .. } => Self::EmptyWindow,
            SpaceError::ZeroNormal
            | SpaceError::NegativeRadius(_)
            | SpaceError::NoVertices
            | SpaceError::TargetAtPosition
            | SpaceError::UpAlongView
            | SpaceError::FieldOfView(_)
            | SpaceError::Size(_)
            | SpaceError::Height(_)
            | SpaceError::Aspect(_)
            | SpaceError::Near(_)
            | SpaceError::Far { .. }
            | SpaceError::NotAffine => Self::Degenerate,
        }
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

    /// A primitive that the field's numbers do not make.
    #[must_use]
    pub fn geometry(field: &Path<'_>, error: GeomError) -> Self {
        let idx = match error {
            GeomError::Degenerate { vertex_idx }
            | GeomError::NotConvex { vertex_idx }
            | GeomError::SelfIntersecting { vertex_idx } => Some(vertex_idx),
            // Edge i starts from vertex i: the place is the first of the two.
            GeomError::EdgesMeet { edges: [i, _] } => Some(i),
            GeomError::MisplacedHole { hole_idx } => Some(hole_idx),
            // The numbers were read one by one before: this names the place as well as it can.
            GeomError::NotFinite { .. }
            | GeomError::EmptyWindow { .. }
            | GeomError::TooFewVertices => None,
        };
        let problem = Diagnostic::from(error).message;
        match idx {
            Some(idx) => Self::at(error.into(), &Path::Index(field, idx), problem),
            None => Self::at(error.into(), field, problem),
        }
    }

    /// The same in space, at the very place that is to blame.
    #[must_use]
    pub fn space(place: &Path<'_>, error: SpaceError) -> Self {
        Self::at(error.into(), place, Diagnostic::from(error).message)
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
pub(super) fn short(text: &str) -> String {
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
