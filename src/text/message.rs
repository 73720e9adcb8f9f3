//! Sentences and formulas before a language is chosen: typed values, never strings of prose.

use std::borrow::Cow;

/// A sentence to be said: a key into the catalogues and the numbers of this very step.
#[derive(Clone, PartialEq, Debug)]
pub struct Message {
    /// The message's key in `assets/messages/<language>/*.ftl`.
    pub key: &'static str,
    /// The values of the message's variables, by name.
    pub args: Vec<(&'static str, Value)>,
}

impl Message {
    /// A message without arguments yet.
    pub const fn new(key: &'static str) -> Self {
        Self {
            key,
            args: Vec::new(),
        }
    }

    /// The same message with the variable `name` filled in.
    pub fn with(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.args.push((name, value.into()));
        self
    }
}

/// What a variable of a [`Message`] stands for.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// A number as people write it: `3/8`, `−1.5`; see [`Catalog::number`](super::Catalog::number).
    Number(f64),
    /// The quotient `num/den`, shown as a reduced fraction where that is exact and short.
    Ratio {
        /// Numerator.
        num: f64,
        /// Denominator.
        den: f64,
    },
    /// A point in the plane: `(−1, 3/8)`.
    Point([f64; 2]),
    /// How many there are of something; selects plural forms in the catalogue.
    Count(usize),
    /// Shown as it is: `P₁`, `1001`, `code₁`.
    Name(String),
    /// A key into the catalogue: a word such as an edge's name, translated.
    Term(&'static str),
    /// A sentence, or a part of one, with values of its own.
    Message(Message),
    /// Arithmetic with its numbers filled in.
    Formula(Formula),
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Self::Number(x)
    }
}

impl From<[f64; 2]> for Value {
    fn from(p: [f64; 2]) -> Self {
        Self::Point(p)
    }
}

impl From<usize> for Value {
    fn from(n: usize) -> Self {
        Self::Count(n)
    }
}

impl From<String> for Value {
    fn from(name: String) -> Self {
        Self::Name(name)
    }
}

impl From<Message> for Value {
    fn from(message: Message) -> Self {
        Self::Message(message)
    }
}

impl From<Formula> for Value {
    fn from(formula: Formula) -> Self {
        Self::Formula(formula)
    }
}

/// Arithmetic as it is written on the board: language-neutral but for the decimal separator.
///
/// Tokens follow each other without a space: symbols carry their own, as in `sym(" + ")`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Formula(
    /// The parts, from left to right.
    pub Vec<Token>,
);

/// One part of a [`Formula`].
#[derive(Clone, PartialEq, Debug)]
pub enum Token {
    /// Shown as it is: an operator, a variable's name, a parenthesis, spaces.
    Sym(Cow<'static, str>),
    /// A number.
    Number(f64),
    /// A number, in parentheses when it is negative: the right-hand side of an operator.
    Operand(f64),
    /// A number that is divided: in parentheses when it is shown as a fraction, as `3/4 / 2` is no way to write.
    Dividend(f64),
    /// A number that divides: in parentheses when it is negative or shown as a fraction.
    Divisor(f64),
    /// The quotient `num/den`, shown as a reduced fraction where that is exact and short.
    Ratio {
        /// Numerator.
        num: f64,
        /// Denominator.
        den: f64,
    },
    /// A point in the plane.
    Point([f64; 2]),
    /// Numbers after each other, set apart as the language does beside its decimal separator.
    List(Vec<f64>),
    /// Nothing to be seen: what is not whole in this formula is a decimal, as in the matrix that it is about.
    Decimals,
    /// A key into the catalogue: a word, translated.
    Term(&'static str),
    /// [`Token::Equals`] for a quotient: `= 1/4`, or `≈ 0.4115` where it has no short fraction.
    EqualsRatio {
        /// Numerator.
        num: f64,
        /// Denominator.
        den: f64,
    },
    /// A quotient: stacked where it is set, `a / b` in a line of plain text.
    Over {
        /// Above the line.
        num: Formula,
        /// Below it.
        den: Formula,
    },
    /// What the arithmetic comes to: `= 3/8`, or `≈ 0.3827` where the shown number is rounded.
    /// Sets itself apart with a space if what stands before it does not end in one.
    Equals(f64),
}

impl Formula {
    /// An empty one whose numbers will be decimals, also where they have short fractions.
    pub fn decimals() -> Self {
        Self(vec![Token::Decimals])
    }

    /// Appends a symbol, shown as it is.
    pub fn sym(self, symbol: impl Into<Cow<'static, str>>) -> Self {
        self.push(Token::Sym(symbol.into()))
    }

    /// Appends a number.
    pub fn num(self, x: f64) -> Self {
        self.push(Token::Number(x))
    }

    /// Appends a number, in parentheses when it is negative.
    pub fn operand(self, x: f64) -> Self {
        self.push(Token::Operand(x))
    }

    /// Appends a number that is divided by what follows.
    pub fn dividend(self, x: f64) -> Self {
        self.push(Token::Dividend(x))
    }

    /// Appends a number that what stands before is divided by.
    pub fn divisor(self, x: f64) -> Self {
        self.push(Token::Divisor(x))
    }

    /// Appends the quotient `num/den`.
    pub fn ratio(self, num: f64, den: f64) -> Self {
        self.push(Token::Ratio { num, den })
    }

    /// Appends a quotient of two formulas.
    pub fn over(self, num: Self, den: Self) -> Self {
        self.push(Token::Over { num, den })
    }

    /// Appends a point in the plane.
    pub fn point(self, p: [f64; 2]) -> Self {
        self.push(Token::Point(p))
    }

    /// Appends a place in space: `(−1, 0.5, 2)`.
    pub fn place(self, at: [f64; 3]) -> Self {
        self.sym("(").list(&at).sym(")")
    }

    /// Appends `=` or `≈` and the quotient `num/den`.
    pub fn equals_ratio(self, num: f64, den: f64) -> Self {
        self.push(Token::EqualsRatio { num, den })
    }

    /// Appends several numbers: the arguments of `max`.
    pub fn list(self, numbers: &[f64]) -> Self {
        self.push(Token::List(numbers.to_vec()))
    }

    /// Appends a word of the catalogue.
    pub fn term(self, key: &'static str) -> Self {
        self.push(Token::Term(key))
    }

    /// Appends what the arithmetic comes to, with `=` or, where the shown number is rounded, `≈`.
    pub fn equals(self, x: f64) -> Self {
        self.push(Token::Equals(x))
    }

    fn push(mut self, token: Token) -> Self {
        self.0.push(token);
        self
    }
}
