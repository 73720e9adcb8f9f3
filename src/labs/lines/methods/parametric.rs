//! What the clippers of a parameter interval have in common: the interval's sentences, its picture on the segment and
//! on the axis, its rows in tables. Nothing here knows against what is clipped.

use crate::{
    algo::line::{End, Ratio, Visible},
    figure::{Caption, LineTick, Link, Mark, NumberLine, Role, Shape, Side, WatchRow},
    geom::{Point, Segment},
    labs::words::name,
    text::{Formula, Message, Value},
};

use super::shared::{end_link, end_name, end_name_now, segment_marks};

/// A crossing that has been computed.
pub struct ShownCrossing {
    /// Its parameter.
    pub at: f64,
    /// The quotient that it was computed as.
    pub quotient: Ratio,
    /// Which bound it may move.
    pub side: Side,
    /// Does it hold that bound now?
    pub holds: bool,
    /// Is it this step's?
    pub current: bool,
    /// The border's name.
    pub name: Value,
    /// What it is about.
    pub link: Link,
}

/// The interval as a step shows it: on the stage, on the number line, in the watch table.
pub struct ShownInterval {
    /// The parameter: `u` or `t`.
    pub symbol: &'static str,
    /// What a crossing's parameter is called: `r` or `t`.
    pub crossing_symbol: &'static str,
    /// Lower and upper bound.
    pub bounds: [f64; 2],
    /// Computed so far.
    pub crossings: Vec<ShownCrossing>,
    /// The answer, once known.
    pub verdict: Option<Visible>,
    /// Is the segment's line drawn beyond its ends, with the crossings there?
    pub goes_on: bool,
    /// At this step the segment is seen as a vector of this name, from P₁ to P₂.
    pub vector: Option<&'static str>,
}

impl ShownInterval {
    /// Have the bounds passed each other?
    fn is_crossed_over(&self) -> bool {
        self.bounds[0] > self.bounds[1]
    }

    /// A parameter as the quotient that it was computed as.
    pub fn written(&self, at: f64) -> Value {
        value_of(written(at, &self.crossings))
    }

    /// The segment with the part that is left standing out, and the crossings on it.
    pub fn marks(&self, segment: &Segment) -> Vec<Mark> {
        if let Some(Some(visible)) = self.verdict {
            return segment_marks(segment, [visible.p1, visible.p2], self.verdict);
        }
        let mut marks = self.parts(segment);
        for crossing in &self.crossings {
            let at = on_line(segment, crossing.at);
            let is_drawn = self.goes_on || (0.0..=1.0).contains(&crossing.at);
            let on_end = End::BOTH.iter().any(|end| end.of(segment).to_array() == at);
            let mark = if crossing.holds {
                self.bound_mark(crossing, segment)
            } else if crossing.current {
                let label = Formula::default()
                    .sym(self.crossing_symbol)
                    .sym(" = ")
                    .ratio(crossing.quotient.num, crossing.quotient.den);
                Mark::new(Role::Signal, Shape::Cross(at))
                    .labelled(label)
                    .strong()
            } else if on_end || !is_drawn {
                // The end itself is enough; a cross on no line says nothing.
                continue;
            } else {
                Mark::new(Role::Discarded, Shape::Cross(at))
            };
            marks.push(mark.linked(crossing.link));
        }
        marks
    }

    /// A bound where it stands on the segment, with what it is.
    fn bound_mark(&self, crossing: &ShownCrossing, segment: &Segment) -> Mark {
        let at = on_line(segment, crossing.at);
        let role = match (crossing.current, self.is_crossed_over()) {
            (true, _) => Role::Signal,
            (false, true) => Role::Ink,
            (false, false) => Role::Accent,
        };
        let label = Formula::default()
            .sym(self.bound_symbol(crossing.side))
            .sym(" = ")
            .ratio(crossing.quotient.num, crossing.quotient.den);
        // The bound allows what comes after u_min and before u_max.
        let allowed = match crossing.side {
            Side::Entering => segment.p2,
            Side::Leaving => segment.p1,
        };
        let head = Shape::Bound([at, allowed.to_array()]);
        Mark::new(role, head).labelled(label).strong()
    }

    /// `u_min`
    fn bound_symbol(&self, side: Side) -> String {
        let suffix = match side {
            Side::Entering => "min",
            Side::Leaving => "max",
        };
        format!("{}_{suffix}", self.symbol)
    }

    /// All of the segment is still there, only the bounds move: what is left stands out. Where they have passed each
    /// other, the part between them is crossed over.
    fn parts(&self, segment: &Segment) -> Vec<Mark> {
        let ends = [segment.p1, segment.p2];
        let crossed = self.is_crossed_over();
        let verdict = self.verdict.or(crossed.then_some(None));
        let mut marks = segment_marks(segment, ends, verdict);
        let [from, to] = self.bounds;
        let between = [from, to].map(|u| on_line(segment, u));
        if crossed {
            let middle = on_line(segment, from.midpoint(to));
            marks.push(Mark::new(Role::Signal, Shape::Segment(between)));
            marks.push(Mark::new(Role::Signal, Shape::Cross(middle)));
        } else if verdict.is_none() && self.bounds != [0.0, 1.0] {
            marks[0] = Mark::new(Role::Discarded, Shape::Segment(ends.map(Point::to_array)));
            marks.insert(
                1,
                Mark::new(Role::Accent, Shape::Segment(between)).linked("segment"),
            );
        }
        if let (Some(symbol), None) = (self.vector, verdict) {
            let arrow = Mark::new(Role::Accent, Shape::Arrow(ends.map(Point::to_array)));
            if self.bounds == [0.0, 1.0] {
                marks[0] = marks[0].clone().labelled(name(symbol)).strong();
                marks.insert(1, arrow);
            } else {
                marks[0] = arrow.dashed();
                marks[1] = marks[1].clone().labelled(name(symbol)).strong();
            }
        }
        marks
    }

    /// The axis, with room for every crossing that there will be: those at `reach`.
    pub fn number_line(self, reach: impl Iterator<Item = f64>) -> NumberLine {
        let values = self
            .bounds
            .map(|bound| formula_of(written(bound, &self.crossings)));
        let empty = self.is_crossed_over() || self.verdict == Some(None);
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
        }
    }

    /// Rows for both bounds, each with the border that set it.
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

    /// Is anything left of it?
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
        Formula::default()
            .sym(format!("{} = {function}(", self.bound_symbol(side)))
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

/// A quotient that stands alone.
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
    [above, below]: [&'static str; 2],
    Ratio { num, den }: Ratio,
) -> Formula {
    let part = |symbol: &'static str| Formula::default().sym(symbol);
    let number = |x: f64| Formula::default().num(x);
    let formula = Formula::default()
        .sym(symbol)
        .sym(" = ")
        .over(part(above), part(below));
    if is_reduced(num, den) {
        return formula.equals_ratio(num, den);
    }
    formula
        .sym(" = ")
        .over(number(num), number(den))
        .equals_ratio(num, den)
}

/// Are these small numbers that the quotient is written with in any case?
fn is_reduced(num: f64, den: f64) -> bool {
    let is_small = |x: f64| x.fract() == 0.0 && (0.0..=99.0).contains(&x);
    let divides = |d: u32| num % f64::from(d) == 0.0 && den % f64::from(d) == 0.0;
    is_small(num) && is_small(den) && den > 1.0 && !(2..=den as u32).any(divides)
}

/// P(u), to place a mark: the algorithm itself never computes points that it does not put out.
pub fn on_line(segment: &Segment, u: f64) -> [f64; 2] {
    let [x1, y1, x2, y2] = segment.to_array();
    [x1 + u * (x2 - x1), y1 + u * (y2 - y1)]
}

/// An end that was inside stays where it is.
pub fn stays_caption(end: End, at: Point) -> Caption {
    let message = Message::new("param-put-end");
    Caption::new(message.with("end", end_name(end)).with("at", at.to_array()))
}

/// Rows for the ends that have been put in place.
pub fn moved_ends_rows(ends: [Option<Point>; 2]) -> impl Iterator<Item = WatchRow> {
    End::BOTH.into_iter().filter_map(move |end| {
        let at = ends[end.idx()]?.to_array();
        Some(WatchRow::new(end_name_now(end, true), Some(Value::Point(at))).linked(end_link(end)))
    })
}
