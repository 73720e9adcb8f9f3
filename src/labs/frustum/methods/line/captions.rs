//! What a step of a line clipper says.

use crate::{
    algo::{
        parameter::End,
        volume::{LineRow, LineRules, LineState},
    },
    figure::{Caption, Side},
    labs::{
        interval::{difference, direction, quotient_formula, value_of},
        words::{end_name, name},
    },
    text::{Formula, Message, Value},
};

use super::{
    look::{Event, Input, LineLook, PlaneLook, end_formula, listed, ratio},
    table::interval,
};

/// The sentence of an event.
pub fn caption<const N: usize, B: LineLook<N>, L: LineRules>(
    event: &Event<B::Plane, N>,
    before: &LineState<B::Plane, N>,
    input: &Input<N, B>,
) -> Caption {
    let scenery = input.scenery.as_deref();
    let say = |key: &'static str, plane: B::Plane| {
        let message = Message::new(key);
        message.with("plane", plane.name(scenery))
    };
    match *event {
        Event::Delta { delta } => delta_caption(&before.ends, &delta),
        Event::Depths { ends, behind } => depths_caption::<N, L>(&ends, behind, &before.ends),
        Event::Row { plane, p, q } => {
            let direction = Value::Term(direction(p));
            let message = say("space-line-row", plane).with("direction", direction);
            let row = LineRow {
                plane,
                p,
                q,
                r: None,
                left: None,
            };
            let formulas = input.own.bounds.row_formulas(&before.ends, before, &row);
            let formulas = formulas.into_iter();
            formulas.fold(Caption::new(message), Caption::so)
        }
        Event::Parallel { plane, q, inside } => {
            parallel_caption::<N, B>(say(parallel_key(inside), plane), q)
        }
        Event::Enter {
            plane,
            r,
            raises,
            u_min,
        } => {
            let message = say(bound_key(Side::Entering, raises), plane);
            bound_caption::<N, B>(message, before, (Side::Entering, r, u_min))
        }
        Event::Leave {
            plane,
            r,
            lowers,
            u_max,
        } => {
            let message = say(bound_key(Side::Leaving, lowers), plane);
            bound_caption::<N, B>(message, before, (Side::Leaving, r, u_max))
        }
        Event::Interval { empty, .. } => interval::<N, B>(before, None, scenery).caption(empty),
        Event::Put { end, u, plane, at } => put_caption(end, u, plane, at, before, input),
        Event::Accept { ends } => divided(&ends)
            .into_iter()
            .fold(accepted(&input.own.ends, &ends), Caption::so),
        Event::Reject { plane: Some(plane) } => Caption::new(say("space-line-reject", plane)),
        Event::Reject { plane: None } => Caption::new(Message::new("space-line-reject-behind")),
    }
}

const fn parallel_key(is_inside: bool) -> &'static str {
    if is_inside {
        "space-line-parallel-inside"
    } else {
        "space-line-parallel-outside"
    }
}

const fn bound_key(side: Side, moves: bool) -> &'static str {
    match (side, moves) {
        (Side::Entering, true) => "space-line-enter",
        (Side::Entering, false) => "space-line-enter-idle",
        (Side::Leaving, true) => "space-line-leave",
        (Side::Leaving, false) => "space-line-leave-idle",
    }
}

/// `q = 2 ≥ 0`
fn parallel_caption<const N: usize, B: LineLook<N>>(message: Message, q: f64) -> Caption {
    let symbol = if B::HEADER[1] == "q" {
        "q"
    } else {
        B::HEADER[0]
    };
    let formula = Formula::default().sym(symbol).sym(" = ").num(q);
    let relation = if q < 0.0 { " < 0" } else { " ≥ 0" };
    Caption::new(message).so(formula.sym(relation))
}

/// The last word where something is visible. One point is a touch only where it is all that is left of more.
pub fn accepted<const N: usize>(given: &[[f64; N]; 2], ends: &[[f64; N]; 2]) -> Caption {
    let [p1, p2] = ends.each_ref().map(|at| Value::Formula(listed(at)));
    let one_point = |key, at| Message::new(key).with("at", at);
    Caption::new(if given[0] == given[1] {
        one_point("space-line-point", p1)
    } else if ends[0] == ends[1] {
        one_point("space-line-touch", p1)
    } else {
        Message::new("line-accept").with("p1", p1).with("p2", p2)
    })
}

/// In clip space, where the ends come to lie on the screen: x/w, y/w and z/w.
fn divided<const N: usize>(ends: &[[f64; N]; 2]) -> Vec<Formula> {
    let symbols = ["P₁′ / w = ", "P₂′ / w = "].into_iter();
    let images = symbols.zip(ends).filter_map(|(symbol, at)| {
        let (w, place) = at.split_last()?;
        let image: Vec<f64> = place.iter().map(|x| x / w).collect();
        let is_image = N == 4 && *w > 0.0;
        is_image.then(|| {
            Formula::default()
                .sym(symbol)
                .sym("(")
                .list(&image)
                .sym(")")
        })
    });
    images.collect()
}

fn delta_caption<const N: usize>([p1, p2]: &[[f64; N]; 2], delta: &[f64; N]) -> Caption {
    let symbols = ["Δx = ", "Δy = ", "Δz = "].into_iter().enumerate();
    let formulas = symbols.map(|(i, symbol)| {
        let formula = Formula::default().sym(symbol).num(p2[i]).sym(" − ");
        formula.operand(p1[i]).equals(delta[i])
    });
    formulas.fold(Caption::new(Message::new("space-line-delta")), Caption::so)
}

fn depths_caption<const N: usize, L: LineRules>(
    ends: &[[f64; N]; 2],
    behind: [bool; 2],
    given: &[[f64; N]; 2],
) -> Caption {
    if L::DIVIDES_FIRST {
        let symbols = ["P₁ / w₁", "P₂ / w₂"].into_iter();
        let divided = symbols
            .zip(ends)
            .map(|(symbol, at)| end_formula(symbol, at));
        return divided.fold(
            Caption::new(Message::new("space-line-divided")),
            Caption::so,
        );
    }
    let message = match behind {
        [false, false] => Message::new("space-line-before"),
        [true, true] => Message::new("space-line-all-behind"),
        [is_first, _] => {
            let end = if is_first { End::P1 } else { End::P2 };
            Message::new("space-line-behind").with("end", end_name(end))
        }
    };
    let w = |(symbol, at): (&'static str, &[f64; N])| Formula::default().sym(symbol).num(at[N - 1]);
    let depths = ["w₁ = ", "w₂ = "].into_iter().zip(given).map(w);
    depths.fold(Caption::new(message), Caption::so)
}

/// `r = q/p = −1/−4 = 1/4`, and what it does to the bound.
fn bound_caption<const N: usize, B: LineLook<N>>(
    message: Message,
    before: &LineState<B::Plane, N>,
    (side, r, new): (Side, f64, f64),
) -> Caption {
    let shown = interval::<N, B>(before, None, None);
    let message = message.with("bound", name(shown.bound_symbol(side)));
    let Some(row) = before.rows.last() else {
        return Caption::new(message);
    };
    let quotient = ratio::<N, B>(row, r);
    let caption = Caption::new(message);
    caption
        .so(quotient_formula(
            B::SYMBOLS[1],
            B::QUOTIENT.map(difference),
            quotient,
        ))
        .so(shown.bound_formula(side, r, quotient, new))
}

fn put_caption<const N: usize, B: LineLook<N>>(
    end: End,
    u: f64,
    plane: Option<B::Plane>,
    at: [f64; N],
    before: &LineState<B::Plane, N>,
    input: &Input<N, B>,
) -> Caption {
    let scenery = input.scenery.as_deref();
    let Some(plane) = plane else {
        let at = Value::Formula(listed(&at));
        let message = Message::new("param-put-end");
        return Caption::new(message.with("end", end_name(end)).with("at", at));
    };
    let shown = interval::<N, B>(before, None, scenery);
    let written = before.rows.iter().find(|row| row.plane == plane);
    let u = written.map_or_else(|| shown.written(u), |row| value_of(ratio::<N, B>(row, u)));
    let message = Message::new("space-line-put")
        .with("end", end_name(end))
        .with("symbol", name(B::SYMBOLS[0]))
        .with("u", u)
        .with("border", input.own.bounds.border(scenery, plane));
    let formulas = input.own.bounds.put_formulas(end, plane, &before.ends, at);
    formulas
        .into_iter()
        .fold(Caption::new(message), Caption::so)
}
