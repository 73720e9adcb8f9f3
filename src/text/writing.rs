//! How values and formulas are written in one language, as pieces to be set or as plain text.

use super::catalog::Catalog;
use super::message::{Formula, Message, Token, Value};
use super::number::{self, Notation, Quantity, Written};
use super::piece::Piece;
use super::said::Said;

impl Catalog {
    /// [`message`](Self::message), to be set: its values are kept whole, and written alike.
    pub fn message_pieces(&self, message: &Message) -> Vec<Piece> {
        let notation = self.notation_of(Said::Message(message));
        self.message_pieces_as(message, notation)
    }

    pub fn value_pieces(&self, value: &Value) -> Vec<Piece> {
        self.value_pieces_as(value, self.notation_of(Said::Value(value)))
    }

    pub(super) fn value_pieces_as(&self, value: &Value, notation: Notation) -> Vec<Piece> {
        let writer = self.writer(notation);
        match value {
            Value::Count(n) => vec![Piece::Text(number::count(self.lang(), *n))],
            Value::Number(x) => writer.number(Quantity::Number(*x)),
            Value::Ratio { num, den } => writer.number(Quantity::Ratio(*num, *den)),
            Value::Point(p) => writer.point(*p),
            Value::Name(name) => Piece::words(name),
            Value::Term(key) => Piece::words(&self.term(key)),
            Value::Message(message) => self.message_pieces_as(message, notation),
            Value::Formula(formula) => writer.formula(formula),
        }
    }

    pub fn formula_pieces(&self, formula: &Formula) -> Vec<Piece> {
        let notation = self.notation_of(Said::Formula(formula));
        self.writer(notation).formula(formula)
    }

    pub fn value(&self, value: &Value) -> String {
        Piece::plain(&self.value_pieces(value))
    }

    pub fn formula(&self, formula: &Formula) -> String {
        Piece::plain(&self.formula_pieces(formula))
    }

    /// `3/8`, `5/3`; an exact short decimal, `1.5`; else four significant digits, `0.3827`, but all of the integer part.
    pub fn number(&self, x: f64) -> String {
        let written = Quantity::Number(x).written(self.lang(), self.notation());
        written.to_string()
    }

    /// With so many decimals: `0.3827` as `0.38`.
    pub fn rounded(&self, x: f64, places: usize) -> String {
        number::rounded_to(self.lang(), x, places)
    }

    /// A whole number with its thousands apart: `306,288`.
    pub fn grouped(&self, x: f64) -> String {
        number::grouped(self.lang(), x)
    }

    /// `(−1, 3/8)`, or `(−1; 1,5)` where the comma is the decimal separator.
    pub fn point(&self, p: [f64; 2]) -> String {
        self.value(&Value::Point(p))
    }

    fn notation_of(&self, said: Said<'_>) -> Notation {
        match self.notation() {
            Notation::Own => Notation::of([said]),
            set => set,
        }
    }

    const fn writer(&self, notation: Notation) -> Writer<'_> {
        Writer {
            catalog: self,
            notation,
            is_within_quotient: false,
        }
    }
}

#[derive(Clone, Copy)]
struct Writer<'a> {
    catalog: &'a Catalog,
    notation: Notation,
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
            Token::Divisor(x) => self.parenthesised(*x, *x < 0.0 || self.is_fraction(*x)),
            Token::Ratio { num, den } => self.number(Quantity::Ratio(*num, *den)),
            Token::Over { num, den } if self.is_within_quotient => {
                self.halves([num, den], text).concat()
            }
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
        if must { within(text, number) } else { number }
    }

    fn equals(self, number: Quantity) -> Vec<Piece> {
        let is_exact = number.is_exact(self.notation);
        let mut pieces = vec![text(if is_exact { "= " } else { "≈ " })];
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
        within(text, self.list(&p))
    }

    fn over(self, num: &Formula, den: &Formula) -> Vec<Piece> {
        let inner = Self {
            is_within_quotient: true,
            ..self
        };
        let [num, den] = inner.halves([num, den], Piece::Unset);
        vec![Piece::Over { num, den }]
    }

    fn halves(self, [num, den]: [&Formula; 2], mark: fn(&'static str) -> Piece) -> [Vec<Piece>; 2] {
        let mut num = self.part(num, mark, |x| self.is_fraction(x));
        num.push(mark(" / "));
        let den = self.part(den, mark, |x| x < 0.0 || self.is_fraction(x));
        [num, den]
    }

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
            pieces
        } else {
            within(parenthesis, pieces)
        }
    }
}

fn within(parenthesis: fn(&'static str) -> Piece, pieces: Vec<Piece>) -> Vec<Piece> {
    let opened = std::iter::once(parenthesis("(")).chain(pieces);
    opened.chain([parenthesis(")")]).collect()
}

fn text(part: &'static str) -> Piece {
    Piece::Text(part.to_owned())
}

fn ends_in_space(pieces: &[Piece]) -> bool {
    match pieces.last() {
        Some(Piece::Text(part)) => part.ends_with(' '),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::super::Lang;
    use super::*;

    fn sym(symbol: &'static str) -> Formula {
        Formula::default().sym(symbol)
    }

    fn num(x: f64) -> Formula {
        Formula::default().num(x)
    }

    #[test]
    fn a_formula_shows_its_arithmetic() {
        let divided = |num, den| Formula::default().operand(num).sym(" / ").divisor(den);
        let t = sym("t = q/p = (").num(-1.0).sym(" − ").operand(-2.0);
        let stacked = Formula::default().over(num(-1.0).sym(" − ").operand(-2.0), num(-4.0));
        let mixed = Formula::default().term("edge-left").sym(": ");
        for (lang, formula, expected) in [
            (
                Lang::En,
                t.sym(") / ").operand(4.0).equals(0.25),
                "t = q/p = (−1 − (−2)) / 4 = 1/4",
            ),
            (Lang::En, divided(0.75, 1.5), "3/4 / (3/2)"),
            (Lang::En, divided(-0.5, 0.25), "(−1/2) / (1/4)"),
            (Lang::En, divided(-1.0, -4.0), "(−1) / (−4)"),
            (
                Lang::En,
                stacked.sym(", ").over(sym("q"), num(0.75)),
                "(−1 − (−2)) / (−4), q / (3/4)",
            ),
            (
                Lang::Es,
                sym("sin 22,5° ").equals(0.382_683_432),
                "sin 22,5° ≈ 0,3827",
            ),
            (
                Lang::Es,
                mixed.ratio(2.0, 8.0).sym(" ").point([1.5, -0.5]),
                "borde izquierdo: 1/4 (3/2; −1/2)",
            ),
        ] {
            assert_eq!(Catalog::of(lang).formula(&formula), expected);
        }
    }

    #[test]
    fn the_numbers_of_a_point_or_a_formula_are_of_one_kind() {
        let catalog = Catalog::of(Lang::En);
        for (point, expected) in [
            ([-1.0, 0.375], "(−1, 3/8)"),
            ([1.5, 0.375], "(3/2, 3/8)"),
            ([1.5, 2.0], "(1.5, 2)"),
            ([0.375, 0.3827], "(0.375, 0.3827)"),
        ] {
            assert_eq!(catalog.point(point), expected);
        }
        let third = num(0.3827).sym(" > 1/3").equals_ratio(1.0, 3.0);
        assert_eq!(catalog.formula(&third), "0.3827 > 1/3 ≈ 0.3333");
        let of_matrix = Formula::decimals().num(0.75).sym(" · ").num(0.5);
        let of_matrix = of_matrix.equals(0.375);
        assert_eq!(catalog.formula(&of_matrix), "0.75 · 0.5 = 0.375");
    }

    #[test]
    fn what_is_set_leaves_out_slashes_and_their_parentheses() {
        for (formula, expected) in [
            (
                Formula::default().equals(-0.5),
                "[(= ), (−), Over { num: [(1), Unset(/)], den: [(2)] }]",
            ),
            (
                sym("q").over(num(0.75), num(-4.0)),
                "[(q), Over { num: [Unset((), (3/4), Unset()), Unset( / )], den: [Unset((), (−4), Unset())] }]",
            ),
        ] {
            let pieces = Catalog::of(Lang::En).formula_pieces(&formula);
            let set = format!("{pieces:?}").replace("Text", "");
            assert_eq!(set.replace('"', ""), expected);
        }
    }
}
