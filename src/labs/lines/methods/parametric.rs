//! What the clippers of a parameter interval, Liang–Barsky and Cyrus–Beck, have in common on screen.

use glam::DVec2;

use crate::{
    algo::line::{End, Visible},
    figure::{Caption, LineTick, Link, Mark, NumberLine, Role, Shape, Side, WatchRow},
    geom::{Point, Segment},
    text::{Formula, Message, Value},
};

use super::shared::{end_link, end_name_now, segment_marks};
use crate::labs::words::name;

/// A crossing that has been computed.
pub struct Crossing {
    /// Its parameter.
    pub at: f64,
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
pub struct Interval {
    /// The parameter: `u` or `t`.
    pub symbol: &'static str,
    /// What a crossing's parameter is called: `r` or `t`.
    pub crossing_symbol: &'static str,
    /// Lower and upper bound.
    pub bounds: [f64; 2],
    /// Computed so far.
    pub crossings: Vec<Crossing>,
    /// The answer, once known.
    pub verdict: Option<Visible>,
}

impl Interval {
    /// The segment with the part that is left standing out, and the crossings on it.
    pub fn marks(&self, segment: &Segment) -> Vec<Mark> {
        if let Some(visible) = self.verdict {
            let ends = visible.unwrap_or(*segment);
            return segment_marks(segment, [ends.p1, ends.p2], self.verdict);
        }
        let mut marks = whole_segment_marks(segment, self.bounds);
        for crossing in &self.crossings {
            let at = on_line(segment, crossing.at);
            let on_end = End::BOTH.iter().any(|end| end.of(segment).to_array() == at);
            let mark = if crossing.current {
                let label = Formula::default()
                    .sym(self.crossing_symbol)
                    .sym(" = ")
                    .num(crossing.at);
                Mark::new(Role::Signal, Shape::Dot(at))
                    .labelled(label)
                    .strong()
            } else if on_end {
                // The end itself is enough.
                continue;
            } else if crossing.holds {
                Mark::new(Role::Accent, Shape::Dot(at))
            } else {
                Mark::new(Role::Discarded, Shape::Cross(at))
            };
            marks.push(mark.linked(crossing.link));
        }
        marks
    }

    /// The second view.
    pub fn number_line(self) -> NumberLine {
        let ticks = self.crossings.into_iter().map(|crossing| LineTick {
            u: crossing.at,
            side: crossing.side,
            holds: crossing.holds,
            current: crossing.current,
            name: crossing.name,
            link: Some(crossing.link),
        });
        let ticks: Vec<LineTick> = ticks.collect();
        NumberLine {
            symbol: self.symbol,
            ends: ["P₁", "P₂"].map(name),
            shown: NumberLine::showing(ticks.iter().map(|tick| tick.u)),
            interval: self.bounds,
            empty: self.verdict == Some(None),
            ticks,
        }
    }

    /// Rows for both bounds, each with the border that set it.
    pub fn bound_rows(&self) -> impl Iterator<Item = WatchRow> + '_ {
        let bounds = [(Side::Entering, "min"), (Side::Leaving, "max")];
        bounds
            .into_iter()
            .zip(self.bounds)
            .map(|((side, suffix), bound)| {
                let symbol = name(format!("{}_{suffix}", self.symbol));
                let row = WatchRow::new(symbol, Some(Value::Number(bound)));
                let set_by = |c: &&Crossing| c.holds && c.side == side;
                match self.crossings.iter().find(set_by) {
                    Some(crossing) => row.noted(crossing.name.clone()).linked(crossing.link),
                    None => row,
                }
            })
    }
}

/// The segment with the part for parameters in `interval` standing out: all of it is still there, only the
/// bounds move.
fn whole_segment_marks(segment: &Segment, [from, to]: [f64; 2]) -> Vec<Mark> {
    let ends = [segment.p1, segment.p2];
    let mut marks: Vec<Mark> = segment_marks(segment, ends, None);
    if (from, to) != (0.0, 1.0) {
        let whole = Shape::Segment(ends.map(Point::to_array));
        marks[0] = Mark::new(Role::Discarded, whole);
        if from <= to {
            let left = Shape::Segment([on_line(segment, from), on_line(segment, to)]);
            marks.insert(1, Mark::new(Role::Accent, left).linked("segment"));
        }
    }
    marks
}

/// P(u), to place a mark: the algorithm itself never computes points that it does not put out.
fn on_line(segment: &Segment, u: f64) -> [f64; 2] {
    let [p1, p2] = [segment.p1, segment.p2].map(|p| DVec2::from(p.to_array()));
    p1.lerp(p2, u).to_array()
}

/// Is anything left of the interval?
pub fn interval_caption(symbols: [&'static str; 2], [min, max]: [f64; 2], empty: bool) -> Caption {
    let (key, relation) = match (empty, min == max) {
        (true, _) => ("param-empty", " > "),
        (false, true) => ("param-touch", " = "),
        (false, false) => ("param-left", " < "),
    };
    let message = Message::new(key)
        .with("min", name(symbols[0]))
        .with("max", name(symbols[1]));
    Caption::new(message).so(Formula::default()
        .sym(symbols[0])
        .sym(" = ")
        .num(min)
        .sym(relation)
        .sym(symbols[1])
        .sym(" = ")
        .num(max))
}

/// `u_min = max(0, 1/4) = 1/4`.
pub fn bound_formula(call: &'static str, [old, r]: [f64; 2], new: f64) -> Formula {
    Formula::default()
        .sym(call)
        .list(&[old, r])
        .sym(")")
        .equals(new)
}

/// Rows for the ends that have been put in place.
pub fn moved_ends_rows(ends: [Option<Point>; 2]) -> impl Iterator<Item = WatchRow> {
    End::BOTH.into_iter().filter_map(move |end| {
        let at = ends[end.idx()]?.to_array();
        Some(WatchRow::new(end_name_now(end, true), Some(Value::Point(at))).linked(end_link(end)))
    })
}
