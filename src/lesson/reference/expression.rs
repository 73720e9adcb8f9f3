//! What a reference says, before a run is asked for it.

use crate::figure::{Moment, Words};

#[derive(Clone, PartialEq, Debug)]
pub struct Reference {
    pub value: Expression,
    /// That of the lesson's step, where it names none.
    pub at: Option<Moment>,
    /// That of the lesson's step, where it names none.
    pub scene: Option<String>,
    /// The first of the scene, where it names none.
    pub method: Option<String>,
    pub form: Form,
}

#[derive(Clone, PartialEq, Debug)]
pub enum Expression {
    Number(f64),
    Path {
        root: Root,
        parts: Vec<Part>,
    },
    Negated(Box<Self>),
    Joined(Operator, Box<[Self; 2]>),
    Call(Function, Vec<Self>),
    /// How many events of the whole run have these words.
    Events(Words),
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Root {
    Name(String),
    Event,
    Output,
    Cost,
    Scene,
    /// How many steps the run has.
    Steps,
    /// The first step at which a mistake does something else than it should; no value where it never does.
    Differs,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Part {
    /// A coordinate, `x` to `w`, or a field.
    Field(String),
    /// Counted from 0.
    Entry(usize),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    Plus,
    Minus,
    Times,
    Over,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    /// How many entries a list has.
    Len,
    /// How many of a list's entries are a number.
    Count,
    /// What a list's entries add up to.
    Sum,
    /// Of numbers, which may be many.
    Min,
    Max,
    Abs,
    Sqrt,
    /// Of degrees, and into degrees.
    Sin,
    Cos,
    Tan,
    Acos,
    Atan,
}

impl Function {
    pub const ALL: [(&'static str, Self); 12] = [
        ("len", Self::Len),
        ("count", Self::Count),
        ("sum", Self::Sum),
        ("min", Self::Min),
        ("max", Self::Max),
        ("abs", Self::Abs),
        ("sqrt", Self::Sqrt),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("acos", Self::Acos),
        ("atan", Self::Atan),
    ];
}

/// How a number is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Form {
    /// In its best way: `1/4`, `2.5`, four significant digits.
    #[default]
    Own,
    Fraction,
    Decimal,
    /// With thousands apart.
    Grouped,
    /// Rounded to so many decimals.
    Places(usize),
}

impl Form {
    pub const WORDS: [(&'static str, Self); 3] = [
        ("fraction", Self::Fraction),
        ("decimal", Self::Decimal),
        ("grouped", Self::Grouped),
    ];
}
