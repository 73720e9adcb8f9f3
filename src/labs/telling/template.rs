//! Formulas as templates: text with names in braces.
//!
//! ```text
//!   {x}        a value as it is: a number, a point, a word; of a formula its tokens
//!   {(x)}      an operand: in parentheses where it is negative
//!   {=x}       what it comes to: `= 3/8`, or `≈ 0.3827` where the shown number is rounded
//!   {a / b}    a stacked quotient of two values
//!   −x         in any of these, a number with its sign turned
//!   ~ …        at the head: what is not whole is a decimal
//! ```

use crate::text::{Formula, Token, Value};

use super::teller::Teller;

impl dyn Teller + '_ {
    /// A template with this step's values; none where one of its names is not alive.
    pub fn formula(&self, template: &str) -> Option<Formula> {
        let (mut rest, mut formula) = match template.strip_prefix("~ ") {
            Some(rest) => (rest, Formula::decimals()),
            None => (template, Formula::default()),
        };
        while let Some((text, after)) = rest.split_once('{') {
            let (hole, after) = after.split_once('}')?;
            formula = self.fill(with_text(formula, text), hole)?;
            rest = after;
        }
        Some(with_text(formula, rest))
    }

    fn fill(&self, mut formula: Formula, hole: &str) -> Option<Formula> {
        if let Some((num, den)) = hole.split_once(" / ") {
            let [num, den] = [num, den].map(|part| self.fill(Formula::default(), part));
            return Some(formula.over(num?, den?));
        }
        let (way, sign, name) = read(hole);
        formula.0.push(match (self.value(name)?, way) {
            (Value::Number(x), Way::ComesTo) => Token::Equals(sign * x),
            (Value::Number(x), Way::Operand) => Token::Operand(sign * x),
            (Value::Number(x), Way::AsItIs) => Token::Number(sign * x),
            (Value::Ratio { num, den }, Way::ComesTo) => {
                let num = sign * num;
                Token::EqualsRatio { num, den }
            }
            (Value::Ratio { num, den }, Way::Operand | Way::AsItIs) => {
                let num = sign * num;
                Token::Ratio { num, den }
            }
            (Value::Point(p), _) => Token::Point(p),
            (Value::Count(n), _) => Token::Sym(n.to_string().into()),
            (Value::Name(name), _) => Token::Sym(name.into()),
            (Value::Term(key), _) => Token::Term(key),
            (Value::Formula(own), _) => {
                formula.0.extend(own.0);
                return Some(formula);
            }
            (Value::Message(_), _) => return None,
        });
        Some(formula)
    }
}

#[derive(Clone, Copy)]
enum Way {
    AsItIs,
    Operand,
    ComesTo,
}

/// How a hole's value is written, its sign, and its name.
fn read(hole: &str) -> (Way, f64, &str) {
    let in_parentheses = hole.strip_prefix('(').and_then(|it| it.strip_suffix(')'));
    let (way, name) = match (hole.strip_prefix('='), in_parentheses) {
        (Some(name), _) => (Way::ComesTo, name),
        (None, Some(name)) => (Way::Operand, name),
        (None, None) => (Way::AsItIs, hole),
    };
    match name.strip_prefix('−') {
        Some(name) => (way, -1.0, name),
        None => (way, 1.0, name),
    }
}

/// The names of a template's holes.
pub fn names(template: &str) -> impl Iterator<Item = &str> {
    let holes = template
        .split('{')
        .skip(1)
        .filter_map(|rest| Some(rest.split_once('}')?.0));
    holes
        .flat_map(|hole| hole.split(" / "))
        .map(|part| read(part).2)
}

fn with_text(formula: Formula, text: &str) -> Formula {
    if text.is_empty() {
        formula
    } else {
        formula.sym(text.to_owned())
    }
}
