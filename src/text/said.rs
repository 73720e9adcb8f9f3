//! What is written on a picture, and the numbers in it: they decide together how they are written.

use super::catalog::Catalog;
use super::message::{Formula, Message, Token, Value};
use super::number::{Alike, Notation, Quantity};

/// A number that is written with decimals.
const NO_FRACTION: Quantity = Quantity::Number(std::f64::consts::PI);

/// Something that is written on a picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Said<'a> {
    Value(&'a Value),
    Message(&'a Message),
    Formula(&'a Formula),
    Number(f64),
    /// Nothing that is seen: what is not whole is a decimal there.
    Decimals,
}

impl Said<'_> {
    pub fn text(self, catalog: &Catalog) -> String {
        match self {
            Self::Value(value) => catalog.value(value),
            Self::Message(message) => catalog.message(message),
            Self::Formula(formula) => catalog.formula(formula),
            Self::Number(x) => catalog.number(x),
            Self::Decimals => String::new(),
        }
    }

    fn collect(self, numbers: &mut Vec<Quantity>) {
        match self {
            Self::Value(value) => collect_value(value, numbers),
            Self::Message(message) => collect_message(message, numbers),
            Self::Formula(formula) => collect(formula, numbers),
            Self::Number(x) => numbers.push(Quantity::Number(x)),
            Self::Decimals => numbers.push(NO_FRACTION),
        }
    }
}

impl Notation {
    pub fn of<'a>(said: impl IntoIterator<Item = Said<'a>>) -> Self {
        let mut alike = Alike::default();
        said.into_iter().for_each(|said| alike.see(said));
        alike.notation()
    }
}

impl Alike {
    pub fn see(&mut self, said: Said<'_>) {
        let mut numbers = Vec::new();
        said.collect(&mut numbers);
        for number in numbers {
            self.add(number);
        }
    }
}

impl Value {
    /// Are all its numbers such, and what its quotients come to? One by zero is none.
    pub fn is_all(&self, holds: impl Fn(f64) -> bool) -> bool {
        let mut numbers = Vec::new();
        collect_value(self, &mut numbers);
        numbers.into_iter().all(|number| {
            holds(match number {
                Quantity::Number(x) | Quantity::Ratio(x, 0.0) => x,
                Quantity::Ratio(num, den) => num / den,
            })
        })
    }
}

fn collect_value(value: &Value, numbers: &mut Vec<Quantity>) {
    match value {
        Value::Number(x) => numbers.push(Quantity::Number(*x)),
        Value::Ratio { num, den } => numbers.push(Quantity::Ratio(*num, *den)),
        Value::Point(p) => numbers.extend(p.map(Quantity::Number)),
        Value::Formula(formula) => collect(formula, numbers),
        Value::Message(message) => collect_message(message, numbers),
        Value::Count(_) | Value::Name(_) | Value::Term(_) => {}
    }
}

fn collect_message(message: &Message, numbers: &mut Vec<Quantity>) {
    for (_, value) in &message.args {
        collect_value(value, numbers);
    }
}

fn collect(formula: &Formula, numbers: &mut Vec<Quantity>) {
    for token in &formula.0 {
        match token {
            Token::Sym(_) | Token::Term(_) => {}
            Token::Decimals => numbers.push(NO_FRACTION),
            Token::Number(x) | Token::Operand(x) | Token::Divisor(x) | Token::Equals(x) => {
                numbers.push(Quantity::Number(*x));
            }
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
