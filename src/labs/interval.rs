//! What is left of a parameter's interval, whatever is clipped against what: its sentences, its axis, its rows in tables.

use crate::{
    algo::parameter::{End, Ratio},
    figure::{Caption, LineTick, NumberLine, Side},
    labs::prelude::*,
};

pub struct ShownCrossing {
    pub at: f64,
    pub quotient: Ratio,
    /// Which bound it may move.
    pub side: Side,
    pub holds: bool,
    pub current: bool,
    pub name: Value,
    pub link: Link,
}

pub struct ShownInterval {
    pub symbol: &'static str,
    pub bounds: [f64; 2],
    pub crossings: Vec<ShownCrossing>,
    pub is_rejected: bool,
}

impl ShownInterval {
    pub fn is_crossed_over(&self) -> bool {
        self.bounds[0] > self.bounds[1]
    }

    pub fn written(&self, at: f64) -> Value {
        value_of(written(at, &self.crossings))
    }

    pub fn bound_symbol(&self, side: Side) -> String {
        let suffix = match side {
            Side::Entering => "min",
            Side::Leaving => "max",
        };
        format!("{}_{suffix}", self.symbol)
    }

    /// The axis, with room for every crossing that there will be: those at `reach`.
    pub fn number_line(self, reach: impl Iterator<Item = f64>) -> NumberLine {
        let values = self
            .bounds
            .map(|bound| formula_of(written(bound, &self.crossings)));
        let empty = self.is_crossed_over() || self.is_rejected;
        let ticks = self.crossings.into_iter().map(|crossing| LineTick {
            u: crossing.at,
            value: formula_of(crossing.quotient),
            side: crossing.side,
            holds: crossing.holds,
            current: crossing.current,
            name: crossing.name,
            link: Some(crossing.link),
        });
        let ticks: Vec<LineTick> = ticks.collect();
        NumberLine {
            symbol: self.symbol,
            ends: End::BOTH.map(end_name),
            shown: NumberLine::showing(reach),
            interval: self.bounds,
            values,
            empty,
            ticks,
            kept: None,
        }
    }

    pub fn bound_rows(&self) -> impl Iterator<Item = WatchRow> + '_ {
        let sides = [Side::Entering, Side::Leaving].into_iter();
        sides.zip(self.bounds).map(|(side, bound)| {
            let row = WatchRow::new(self.bound_symbol(side), Some(self.written(bound)));
            let set_by = |c: &&ShownCrossing| c.holds && c.side == side;
            match self.crossings.iter().find(set_by) {
                Some(crossing) => row.noted(crossing.name.clone()).linked(crossing.link),
                None => row,
            }
        })
    }

    pub fn caption(&self, empty: bool) -> Caption {
        let [min, max] = self.bounds;
        let (key, relation) = match (empty, min == max) {
            (true, _) => ("param-empty", " > "),
            (false, true) => ("param-touch", " = "),
            (false, false) => ("param-left", " < "),
        };
        let symbols = [Side::Entering, Side::Leaving].map(|side| self.bound_symbol(side));
        let message = Message::new(key)
            .with("min", symbols[0].clone())
            .with("max", symbols[1].clone());
        let bound = |formula: Formula, symbol: &String, at: f64| {
            let Ratio { num, den } = written(at, &self.crossings);
            formula.sym(symbol.clone()).sym(" = ").ratio(num, den)
        };
        let formula = bound(Formula::default(), &symbols[0], min).sym(relation);
        Caption::new(message).so(bound(formula, &symbols[1], max))
    }

    /// `u_min = max(0, 1/4) = 1/4`: what a crossing does to the bound on its side.
    pub fn bound_formula(&self, side: Side, at: f64, crossing: Ratio, new: f64) -> Formula {
        let (function, old) = match side {
            Side::Entering => ("max", self.bounds[0]),
            Side::Leaving => ("min", self.bounds[1]),
        };
        let new = if new == old {
            written(old, &self.crossings)
        } else {
            crossing
        };
        sym(format!("{} = {function}(", self.bound_symbol(side)))
            .list(&[old, at])
            .sym(")")
            .equals_ratio(new.num, new.den)
    }
}

/// The quotient that a bound was computed as; of those with the same value any tells it.
fn written(at: f64, crossings: &[ShownCrossing]) -> Ratio {
    let same = crossings.iter().find(|crossing| crossing.at == at);
    same.map_or(Ratio { num: at, den: 1.0 }, |crossing| crossing.quotient)
}

/// Catalogue key: which way a line crosses a border where it is inside for u·p ≤ q.
pub fn direction(p: f64) -> &'static str {
    if p == 0.0 {
        return "verdict-parallel";
    }
    match Side::of(p) {
        Side::Entering => "verdict-entering",
        Side::Leaving => "verdict-leaving",
    }
}

pub const fn value_of(Ratio { num, den }: Ratio) -> Value {
    Value::Ratio { num, den }
}

fn formula_of(Ratio { num, den }: Ratio) -> Formula {
    Formula::default().ratio(num, den)
}

/// The quotient of two numbers that have been divided, as long as halves of them did not have to be taken instead.
pub fn quotient(num: f64, den: f64, at: f64) -> Ratio {
    if num.is_finite() && den.is_finite() {
        Ratio { num, den }
    } else {
        Ratio { num: at, den: 1.0 }
    }
}

/// `r = q/p = −1/−4 = 1/4`; the last part is left out where it would say the same again.
pub fn quotient_formula(
    symbol: &'static str,
    [above, below]: [Formula; 2],
    Ratio { num, den }: Ratio,
) -> Formula {
    let number = |x: f64| Formula::default().num(x);
    let formula = sym(symbol).sym(" = ").over(above, below);
    if is_reduced(num, den) {
        return formula.equals_ratio(num, den);
    }
    formula
        .sym(" = ")
        .over(number(num), number(den))
        .equals_ratio(num, den)
}

/// A symbol, or one minus another: as part of a quotient.
pub fn difference(symbols: &[&'static str]) -> Formula {
    let numbered = symbols.iter().enumerate();
    numbered.fold(Formula::default(), |formula, (nth, &symbol)| match nth {
        0 => formula.sym(symbol),
        _ => formula.sym(" − ").sym(symbol),
    })
}

/// Are these small numbers that the quotient is written with in any case?
fn is_reduced(num: f64, den: f64) -> bool {
    let is_small = |x: f64| x.fract() == 0.0 && (0.0..=99.0).contains(&x);
    let divides = |d: u32| num % f64::from(d) == 0.0 && den % f64::from(d) == 0.0;
    is_small(num) && is_small(den) && den > 1.0 && !(2..=den as u32).any(divides)
}
