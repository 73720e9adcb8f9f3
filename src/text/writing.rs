//! How values and formulas are written in one language, as pieces to be set or as plain text.

use super::catalog::Catalog;
use super::message::{Formula, Token, Value};
use super::number::{Notation, Quantity, Written};
use super::piece::Piece;

impl Catalog {
    /// A value as it stands alone, to be set: in a table, beside a mark.
    pub fn value_pieces(&self, value: &Value) -> Vec<Piece> {
        self.value_pieces_as(value, Notation::of([value]))
    }

    /// A value to be set beside others that are written in the same way.
    pub fn value_pieces_as(&self, value: &Value, notation: Notation) -> Vec<Piece> {
        let writer = self.writer(notation);
        match value {
            Value::Count(n) => vec![Piece::Text(n.to_string())],
            Value::Number(x) => writer.number(Quantity::Number(*x)),
            Value::Ratio { num, den } => writer.number(Quantity::Ratio(*num, *den)),
            Value::Point(p) => writer.point(*p),
            Value::Name(name) => Piece::words(name),
            Value::Term(key) => Piece::words(&self.term(key)),
            Value::Message(message) => self.message_pieces_as(message, notation),
            Value::Formula(formula) => writer.formula(formula),
        }
    }

    /// Arithmetic to be set. All of its numbers are fractions, or all are decimals, as far as they are not whole.
    pub fn formula_pieces(&self, formula: &Formula) -> Vec<Piece> {
        let mut numbers = Vec::new();
        collect(formula, &mut numbers);
        self.formula_pieces_as(formula, Notation::of_quantities(&numbers))
    }

    /// Arithmetic to be set beside values that are written in the same way.
    pub fn formula_pieces_as(&self, formula: &Formula, notation: Notation) -> Vec<Piece> {
        self.writer(notation).formula(formula)
    }

    /// A value as it stands alone: in a table, beside a mark.
    pub fn value(&self, value: &Value) -> String {
        Piece::plain(&self.value_pieces(value))
    }

    /// A value beside others that are written in the same way.
    pub fn value_as(&self, value: &Value, notation: Notation) -> String {
        Piece::plain(&self.value_pieces_as(value, notation))
    }

    /// Arithmetic, with this language's decimal separator and words.
    pub fn formula(&self, formula: &Formula) -> String {
        Piece::plain(&self.formula_pieces(formula))
    }

    /// Arithmetic beside values that are written in the same way.
    pub fn formula_as(&self, formula: &Formula, notation: Notation) -> String {
        Piece::plain(&self.formula_pieces_as(formula, notation))
    }

    /// A number as people write it.
    ///
    /// An integer plainly; a fraction where that is exact and short, `3/8` or `5/3`; an exact short
    /// decimal, `1.5`; else four significant digits, `0.3827`, never cutting into the integer part.
    /// Below 10⁻⁴ and from 10⁹ on, `1.234×10⁹`. The minus is U+2212 and zero has no sign.
    pub fn number(&self, x: f64) -> String {
        let written = Quantity::Number(x).written(self.lang(), Notation::Own);
        written.to_string()
    }

    /// A point in the plane: `(−1, 3/8)`, or `(−1; 1,5)` where the comma is the decimal separator. Both
    /// coordinates are fractions or both decimals, as far as they are not whole.
    pub fn point(&self, p: [f64; 2]) -> String {
        self.value(&Value::Point(p))
    }

    const fn writer(&self, notation: Notation) -> Writer<'_> {
        Writer {
            catalog: self,
            notation,
            is_within_quotient: false,
        }
    }
}

impl Notation {
    /// How the numbers of all these values are written beside each other: of points, formulas and sentences too.
    pub fn of<'a>(values: impl IntoIterator<Item = &'a Value>) -> Self {
        let mut numbers = Vec::new();
        for value in values {
            collect_value(value, &mut numbers);
        }
        Self::of_quantities(&numbers)
    }
}

/// All the numbers of a value, also of a sentence within it.
fn collect_value(value: &Value, numbers: &mut Vec<Quantity>) {
    match value {
        Value::Number(x) => numbers.push(Quantity::Number(*x)),
        Value::Ratio { num, den } => numbers.push(Quantity::Ratio(*num, *den)),
        Value::Point(p) => numbers.extend(p.map(Quantity::Number)),
        Value::Formula(formula) => collect(formula, numbers),
        Value::Message(message) => {
            for (_, value) in &message.args {
                collect_value(value, numbers);
            }
        }
        Value::Count(_) | Value::Name(_) | Value::Term(_) => {}
    }
}

/// All the numbers of a formula.
fn collect(formula: &Formula, numbers: &mut Vec<Quantity>) {
    for token in &formula.0 {
        match token {
            Token::Sym(_) | Token::Term(_) => {}
            // A number that has no fraction.
            Token::Decimals => numbers.push(Quantity::Number(std::f64::consts::PI)),
            Token::Number(x)
            | Token::Operand(x)
            | Token::Dividend(x)
            | Token::Divisor(x)
            | Token::Equals(x) => numbers.push(Quantity::Number(*x)),
            Token::Ratio { num, den } | Token::EqualsRatio { num, den } => {
                numbers.push(Quantity::Ratio(*num, *den));
            }
            Token::Point(p) => numbers.extend(p.map(Quantity::Number)),
            Token::List(list) => numbers.extend(list.iter().copied().map(Quantity::Number)),
            Token::Over { num, den } => {
                collect(num, numbers);
                collect(den, numbers);
            }
        }
    }
}

/// Writes the numbers of one point or formula.
#[derive(Clone, Copy)]
struct Writer<'a> {
    catalog: &'a Catalog,
    notation: Notation,
    /// Quotients are not stacked on quotients.
    is_within_quotient: bool,
}

impl Writer<'_> {
    fn formula(self, formula: &Formula) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for token in &formula.0 {
            let equation = matches!(token, Token::Equals(_) | Token::EqualsRatio { .. });
            if equation && !pieces.is_empty() && !ends_in_space(&pieces) {
                pieces.push(text(" "));
            }
            pieces.extend(self.token(token));
        }
        pieces
    }

    fn token(self, token: &Token) -> Vec<Piece> {
        match token {
            Token::Sym(symbol) => Piece::words(symbol),
            Token::Decimals => Vec::new(),
            Token::Number(x) => self.number(Quantity::Number(*x)),
            Token::Operand(x) => self.parenthesised(*x, *x < 0.0),
            Token::Dividend(x) => self.parenthesised(*x, self.is_fraction(*x)),
            Token::Divisor(x) => self.parenthesised(*x, *x < 0.0 || self.is_fraction(*x)),
            Token::Ratio { num, den } => self.number(Quantity::Ratio(*num, *den)),
            Token::Over { num, den } if self.is_within_quotient => self.line(num, den),
            Token::Over { num, den } => self.over(num, den),
            Token::Point(p) => vec![Piece::Kept(self.point(*p))],
            Token::List(numbers) => self.list(numbers),
            Token::Term(key) => Piece::words(&self.catalog.term(key)),
            Token::Equals(x) => self.equals(Quantity::Number(*x)),
            Token::EqualsRatio { num, den } => self.equals(Quantity::Ratio(*num, *den)),
        }
    }

    fn number(self, number: Quantity) -> Vec<Piece> {
        match number.written(self.catalog.lang(), self.notation) {
            Written::Fraction { sign, num, den } if !self.is_within_quotient => {
                let over = Piece::Over {
                    num: vec![Piece::Text(num), Piece::Unset("/")],
                    den: vec![Piece::Text(den)],
                };
                if sign.is_empty() {
                    vec![over]
                } else {
                    vec![text(sign), over]
                }
            }
            written => vec![Piece::Text(written.to_string())],
        }
    }

    fn is_fraction(self, x: f64) -> bool {
        let written = Quantity::Number(x).written(self.catalog.lang(), self.notation);
        matches!(written, Written::Fraction { .. })
    }

    fn parenthesised(self, x: f64, must: bool) -> Vec<Piece> {
        let number = self.number(Quantity::Number(x));
        if !must {
            return number;
        }
        let inner = std::iter::once(text("(")).chain(number);
        inner.chain([text(")")]).collect()
    }

    fn equals(self, number: Quantity) -> Vec<Piece> {
        let sign = if number.is_exact(self.notation) {
            "= "
        } else {
            "≈ "
        };
        let mut pieces = vec![text(sign)];
        pieces.extend(self.number(number));
        pieces
    }

    fn list(self, numbers: &[f64]) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for (i, &x) in numbers.iter().enumerate() {
            if i > 0 {
                pieces.push(text(self.catalog.lang().list_separator()));
            }
            pieces.extend(self.number(Quantity::Number(x)));
        }
        pieces
    }

    fn point(self, p: [f64; 2]) -> Vec<Piece> {
        let inner = std::iter::once(text("(")).chain(self.list(&p));
        inner.chain([text(")")]).collect()
    }

    fn over(self, num: &Formula, den: &Formula) -> Vec<Piece> {
        let within = Self {
            is_within_quotient: true,
            ..self
        };
        let mut num = within.part(num, Piece::Unset, |x| self.is_fraction(x));
        num.push(Piece::Unset(" / "));
        let den = within.part(den, Piece::Unset, |x| x < 0.0 || self.is_fraction(x));
        vec![Piece::Over { num, den }]
    }

    /// A quotient on one line.
    fn line(self, num: &Formula, den: &Formula) -> Vec<Piece> {
        let mut pieces = self.part(num, text, |x| self.is_fraction(x));
        pieces.push(text(" / "));
        pieces.extend(self.part(den, text, |x| x < 0.0 || self.is_fraction(x)));
        pieces
    }

    /// Above or below a quotient's line; on one line in parentheses where it is more than one thing.
    fn part(
        self,
        formula: &Formula,
        parenthesis: fn(&'static str) -> Piece,
        is_kept_apart: impl Fn(f64) -> bool,
    ) -> Vec<Piece> {
        let pieces = self.formula(formula);
        let is_one_thing = match formula.0[..] {
            [Token::Number(x)] => !is_kept_apart(x),
            [_] => true,
            _ => false,
        };
        if is_one_thing {
            return pieces;
        }
        let inner = std::iter::once(parenthesis("(")).chain(pieces);
        inner.chain([parenthesis(")")]).collect()
    }
}

fn text(part: &'static str) -> Piece {
    Piece::Text(part.to_owned())
}

fn ends_in_space(pieces: &[Piece]) -> bool {
    match pieces.last() {
        Some(Piece::Text(part)) => part.ends_with(' '),
        Some(Piece::Sub(_) | Piece::Over { .. } | Piece::Unset(_) | Piece::Kept(_)) | None => false,
    }
}

#[cfg(test)]
mod tests {
    use super::super::Lang;
    use super::*;

    #[test]
    fn a_formula_shows_its_arithmetic() {
        let t = Formula::default()
            .sym("t = q/p = (")
            .num(-1.0)
            .sym(" − ")
            .operand(-2.0)
            .sym(") / ")
            .operand(4.0)
            .equals(0.25);
        let catalog = Catalog::of(Lang::En);
        assert_eq!(catalog.formula(&t), "t = q/p = (−1 − (−2)) / 4 = 1/4");
        for (num, den, expected) in [
            (0.75, 1.5, "(3/4) / (3/2)"),
            (-0.5, 0.25, "(−1/2) / (1/4)"),
            (-1.0, -4.0, "−1 / (−4)"),
        ] {
            let formula = Formula::default().dividend(num).sym(" / ").divisor(den);
            assert_eq!(catalog.formula(&formula), expected);
        }
        let difference = |a, b| Formula::default().num(a).sym(" − ").operand(b);
        let stacked = Formula::default()
            .over(difference(-1.0, -2.0), Formula::default().num(-4.0))
            .sym(", ")
            .over(Formula::default().sym("q"), Formula::default().num(0.75));
        assert_eq!(catalog.formula(&stacked), "(−1 − (−2)) / (−4), q / (3/4)");
        let rounded = Formula::default().sym("sin 22,5° ").equals(0.382_683_432);
        assert_eq!(
            Catalog::of(Lang::Es).formula(&rounded),
            "sin 22,5° ≈ 0,3827"
        );
        let mixed = Formula::default()
            .term("edge-left")
            .sym(": ")
            .ratio(2.0, 8.0)
            .sym(" ")
            .point([1.5, -0.5]);
        assert_eq!(
            Catalog::of(Lang::Es).formula(&mixed),
            "borde izquierdo: 1/4 (3/2; −1/2)"
        );
    }

    #[test]
    fn the_numbers_of_a_point_or_a_formula_are_of_one_kind() {
        let catalog = Catalog::of(Lang::En);
        assert_eq!(catalog.point([-1.0, 0.375]), "(−1, 3/8)");
        assert_eq!(catalog.point([1.5, 0.375]), "(3/2, 3/8)");
        assert_eq!(catalog.point([1.5, 2.0]), "(1.5, 2)");
        assert_eq!(catalog.point([0.375, 0.3827]), "(0.375, 0.3827)");
        let third = Formula::default()
            .num(0.3827)
            .sym(" > 1/3")
            .equals_ratio(1.0, 3.0);
        assert_eq!(catalog.formula(&third), "0.3827 > 1/3 ≈ 0.3333");
        let of_matrix = Formula::decimals()
            .num(0.75)
            .sym(" · ")
            .num(0.5)
            .equals(0.375);
        assert_eq!(catalog.formula(&of_matrix), "0.75 · 0.5 = 0.375");
    }

    #[test]
    fn what_is_set_leaves_out_slashes_and_their_parentheses() {
        let set = |formula: &Formula| {
            let pieces = Catalog::of(Lang::En).formula_pieces(formula);
            format!("{pieces:?}").replace("Text", "").replace('"', "")
        };
        let half = Formula::default().equals(-0.5);
        assert_eq!(
            set(&half),
            "[(= ), (−), Over { num: [(1), Unset(/)], den: [(2)] }]"
        );
        let slope = Formula::default()
            .sym("q")
            .over(Formula::default().num(0.75), Formula::default().num(-4.0));
        assert_eq!(
            set(&slope),
            "[(q), Over { num: [Unset((), (3/4), Unset()), Unset( / )], den: [Unset((), (−4), Unset())] }]"
        );
    }
}
