//! Sentences and formulas before a language is chosen: typed values, never strings of prose.

use std::borrow::Cow;

#[derive(Clone, PartialEq, Debug)]
pub struct Message {
    pub key: &'static str,
    pub args: Vec<(&'static str, Value)>,
}

impl Message {
    pub const fn new(key: &'static str) -> Self {
        Self {
            key,
            args: Vec::new(),
        }
    }

    pub fn with(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.args.push((name, value.into()));
        self
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    Number(f64),
    Ratio {
        num: f64,
        den: f64,
    },
    Point([f64; 2]),
    Count(usize),
    Name(String),
    /// A key into the catalogue: a word such as an edge's name, translated.
    Term(&'static str),
    Message(Message),
    Formula(Formula),
}

macro_rules! values {
    ($($variant:ident of $of:ty),*) => {
        $(impl From<$of> for Value {
            fn from(it: $of) -> Self {
                Self::$variant(it)
            }
        })*
    };
}

values!(Number of f64, Point of [f64; 2], Count of usize, Name of String);
values!(Message of Message, Formula of Formula);

/// Arithmetic as on the board. Tokens follow each other without a space: symbols carry their own, as in `sym(" + ")`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Formula(pub Vec<Token>);

#[derive(Clone, PartialEq, Debug)]
pub enum Token {
    Sym(Cow<'static, str>),
    Number(f64),
    Operand(f64),
    /// A number that divides: in parentheses when it is negative or shown as a fraction.
    Divisor(f64),
    /// The quotient `num/den`, shown as a reduced fraction where that is exact and short.
    Ratio {
        num: f64,
        den: f64,
    },
    Point([f64; 2]),
    List(Vec<f64>),
    /// Nothing to be seen: what is not whole in this formula is a decimal, as in the matrix that it is about.
    Decimals,
    Term(&'static str),
    /// [`Token::Equals`] for a quotient: `= 1/4`, or `≈ 0.4115` where it has no short fraction.
    EqualsRatio {
        num: f64,
        den: f64,
    },
    /// A quotient: stacked where it is set, `a / b` in a line of plain text.
    Over {
        num: Formula,
        den: Formula,
    },
    /// The result: `= 3/8`, or `≈ 0.3827` where it is rounded; set apart by a space.
    Equals(f64),
}

macro_rules! tokens {
    ($($name:ident: $token:ident($of:ty)),*) => {
        $(pub fn $name(self, it: $of) -> Self {
            self.push(Token::$token(it))
        })*
    };
}

impl Formula {
    tokens!(num: Number(f64), operand: Operand(f64), divisor: Divisor(f64));
    tokens!(equals: Equals(f64), point: Point([f64; 2]), term: Term(&'static str));

    /// An empty one whose numbers will be decimals, also where they have short fractions.
    pub fn decimals() -> Self {
        Self(vec![Token::Decimals])
    }

    pub fn sym(self, symbol: impl Into<Cow<'static, str>>) -> Self {
        self.push(Token::Sym(symbol.into()))
    }

    pub fn ratio(self, num: f64, den: f64) -> Self {
        self.push(Token::Ratio { num, den })
    }

    pub fn over(self, num: Self, den: Self) -> Self {
        self.push(Token::Over { num, den })
    }

    pub fn place(self, at: [f64; 3]) -> Self {
        self.sym("(").list(&at).sym(")")
    }

    pub fn equals_ratio(self, num: f64, den: f64) -> Self {
        self.push(Token::EqualsRatio { num, den })
    }

    pub fn list(self, numbers: &[f64]) -> Self {
        self.push(Token::List(numbers.to_vec()))
    }

    fn push(mut self, token: Token) -> Self {
        self.0.push(token);
        self
    }
}
