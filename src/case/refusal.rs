//! Why a case is refused.

use crate::{
    geom::{Axis, GeomError},
    text::{Catalog, Lang, Message},
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
    /// As JSON spells it; also the tail of the catalogue key `error-…`.
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

    /// A primitive that the field's numbers do not make. `n_vertices` is 0 for what has none.
    #[must_use]
    pub fn geometry(field: &Path<'_>, error: GeomError, n_vertices: usize) -> Self {
        let (code, vertex_idx, problem) = match error {
            // The numbers were read one by one before: this names the place as well as it can.
            GeomError::NotFinite { .. } => {
                (Code::NotFinite, None, Message::new("error-not-finite"))
            }
            GeomError::EmptyWindow { axis, min, max } => {
                let [low, high] = match axis {
                    Axis::X => ["xmin", "xmax"],
                    Axis::Y => ["ymin", "ymax"],
                };
                let problem = Message::new("case-empty-window")
                    .with("low", low.to_owned())
                    .with("min", min)
                    .with("high", high.to_owned())
                    .with("max", max);
                (Code::EmptyWindow, None, problem)
            }
            GeomError::Degenerate { vertex_idx } => {
                let key = if vertex_idx < n_vertices {
                    "error-degenerate"
                } else {
                    "error-too-few-vertices"
                };
                (Code::Degenerate, Some(vertex_idx), Message::new(key))
            }
            GeomError::NotConvex { vertex_idx } => {
                let problem = Message::new("error-not-convex");
                (Code::NotConvex, Some(vertex_idx), problem)
            }
            GeomError::SelfIntersecting { vertex_idx } => {
                let problem = Message::new("error-self-intersecting");
                (Code::SelfIntersecting, Some(vertex_idx), problem)
            }
            // Edge i starts from vertex i: the place is the first of the two.
            GeomError::EdgesMeet { edges: [i, j] } => {
                let problem = Message::new("error-edges-meet")
                    .with("first", i)
                    .with("second", j);
                (Code::SelfIntersecting, Some(i), problem)
            }
            GeomError::MisplacedHole { hole_idx } => {
                let problem = Message::new("error-misplaced-hole").with("hole", hole_idx);
                (Code::SelfIntersecting, None, problem)
            }
        };
        match vertex_idx.filter(|&idx| idx < n_vertices) {
            Some(idx) => Self::at(code, &Path::Index(field, idx), problem),
            None => Self::at(code, field, problem),
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
            .with("problem", catalog.message(&self.problem));
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
