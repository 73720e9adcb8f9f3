//! What is said at each step.

use crate::{
    algo::{
        parameter::End,
        pipeline::{LineToPixelsEvent as Event, LineToPixelsInput, LineToPixelsState as State},
    },
    figure::Caption,
    text::{Formula, Message},
};

use super::line_ends::{ends, lengths};

/// `(1.5, 2)`
pub fn list(numbers: &[f64]) -> Formula {
    Formula::decimals().sym("(").list(numbers).sym(")")
}

fn named(symbol: &'static str, numbers: &[f64]) -> Formula {
    let formula = Formula::decimals().sym(symbol).sym(" = (");
    formula.list(numbers).sym(")")
}

/// Pixels are told in brackets.
fn pixel(formula: Formula, at: [i64; 2]) -> Formula {
    let formula = formula.sym("[");
    formula.list(&at.map(|x| x as f64)).sym("]")
}

/// `[5, 4] → [23, 9]`
fn from_to(from: [i64; 2], to: [i64; 2]) -> Formula {
    let from = pixel(Formula::decimals(), from).sym(" → ");
    pixel(from, to)
}

pub fn opening(input: &LineToPixelsInput) -> Caption {
    let said = Caption::new(Message::new("drawn-line-opening"));
    match input {
        LineToPixelsInput::Pixels(ends) => said.so(from_to(ends.from(), ends.to())),
        LineToPixelsInput::Segment(drawn) => {
            let [p1, p2] = drawn.ends;
            said.so(named("P₁", &p1)).so(named("P₂", &p2))
        }
    }
}

pub fn caption(event: &Event, before: &State, input: &LineToPixelsInput) -> Caption {
    match *event {
        Event::Project { end, clip } => {
            let symbol = match end {
                End::P1 => "P₁",
                End::P2 => "P₂",
            };
            let key = if clip[3] > 0.0 {
                "drawn-line-project"
            } else {
                "drawn-line-project-behind"
            };
            let message = Message::new(key)
                .with("end", symbol.to_owned())
                .with("w", clip[3]);
            Caption::new(message).so(named(symbol, &clip))
        }
        Event::Clip { ends } => {
            let is_whole = before.projected == ends.map(Some);
            let key = if is_whole {
                "drawn-line-clip-whole"
            } else {
                "drawn-line-clip-cut"
            };
            let [p1, p2] = ends;
            Caption::new(Message::new(key))
                .so(named("P₁′", &p1))
                .so(named("P₂′", &p2))
        }
        Event::Reject => Caption::new(Message::new("drawn-line-reject")),
        Event::Divide { screen } => {
            let [p1, p2] = screen;
            Caption::new(Message::new("drawn-line-divide"))
                .so(named("S₁", &p1))
                .so(named("S₂", &p2))
        }
        Event::Round { from, to } => {
            let said = Caption::new(Message::new("drawn-line-round"));
            said.so(from_to(from, to))
        }
        Event::Pixel {
            at,
            diagonal,
            error,
        } => put(at, diagonal, error, before, input),
    }
}

fn put(
    at: [i64; 2],
    diagonal: bool,
    error: i64,
    before: &State,
    input: &LineToPixelsInput,
) -> Caption {
    let [a, b] = ends(input, before).map_or([0; 2], |ends| lengths(&ends));
    let [a, b, error] = [a as f64, b as f64, error as f64];
    let place = pixel(Formula::decimals(), at);
    let Some(last) = before.error else {
        let formula = Formula::decimals().sym("e = 2b − a = 2 · ").num(b);
        let formula = formula.sym(" − ").num(a).equals(error);
        let message = Message::new("drawn-line-first").with("at", place);
        return Caption::new(message).so(formula);
    };
    let key = match (diagonal, last == 0) {
        (true, true) => "drawn-line-tie-diagonal",
        (true, false) => "drawn-line-diagonal",
        (false, true) => "drawn-line-tie-straight",
        (false, false) => "drawn-line-straight",
    };
    let message = Message::new(key).with("at", place).with("e", last as f64);
    let formula = Formula::decimals().sym("e = ").num(last as f64);
    let formula = if diagonal {
        formula.sym(" − 2 · ").num(a)
    } else {
        formula
    };
    let formula = formula.sym(" + 2 · ").num(b).equals(error);
    Caption::new(message).so(formula)
}
