//! What all clippers of rings tell alike, in the plane and in space: the edge that is looked at, the vertices that have been looked
//! at, and where the edges cross.

use crate::{
    algo::ring::{Crossing, EdgeTest, Happening, Known, Lists, Ring, RingEvent, Rule},
    text::Value,
};

use super::{
    interval::value_of,
    telling::{Named, Row},
    words::name,
};

/// The question of an edge.
const PUTS_OUT: &str = "puts-out";

/// The edge that was looked at last.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Asked<V> {
    /// None before the limit's first edge, and once the limit is done with.
    pub test: Option<EdgeTest<V>>,
    /// Where it crosses, once that has been found.
    pub crossing: Option<Crossing<V>>,
}

impl<V: Copy + PartialEq> Asked<V> {
    pub fn of<E: RingEvent<V>>(past: &[E]) -> Self {
        let (mut test, mut crossing) = (None, None);
        for event in past.iter().rev() {
            match event.happening() {
                Some(Happening::First { .. } | Happening::Output(_)) => {}
                Some(Happening::Cross(found)) => crossing = Some(found),
                Some(Happening::Test(asked)) => {
                    test = Some(asked);
                    break;
                }
                None => break,
            }
        }
        Self { test, crossing }
    }

    pub fn is_crossing(&self, put_out: V) -> bool {
        self.crossing.is_some_and(|crossing| crossing.at == put_out)
    }

    /// Which vertex of the list it is that is looked at, or put out: P, or the first one.
    pub fn place(&self) -> usize {
        self.test.map_or(0, |test| test.idx[1])
    }

    pub fn named(&self, name_of: &str, symbol: fn(usize) -> String) -> Option<Named> {
        let distance = |test: EdgeTest<V>, i: usize| {
            let side = Value::Term(side_term(test.inside()[i]));
            Named::from(test.distances[i]).noted(side)
        };
        Some(match name_of {
            "from" => name(symbol(self.test?.idx[0])).into(),
            "to" => name(symbol(self.test?.idx[1])).into(),
            "rule" => Value::Term(rule_term(self.test?.rule)).into(),
            "d_S" => distance(self.test?, 0),
            "d_P" => distance(self.test?, 1),
            "t" => value_of(self.crossing?.t).into(),
            _ => return None,
        })
    }
}

/// What has been told of the limit at work, or of the one that was done with last.
#[derive(Clone, PartialEq, Debug)]
pub struct Turn<V> {
    /// How far inside the vertices lie that have been looked at, and whether that counts as inside.
    pub sides: Vec<(f64, bool)>,
    /// Where edges cross, and between which two vertices of the list.
    pub crossings: Vec<([usize; 2], Crossing<V>)>,
}

impl<V> Turn<V> {
    /// By what has been told since the last event that begins a turn.
    fn of<E: RingEvent<V>>(past: &[E], begins: impl Fn(&E) -> bool) -> Self {
        let start = past.iter().rposition(begins).unwrap_or(past.len());
        let (mut sides, mut crossings) = (Vec::new(), Vec::new());
        let mut between = [0; 2];
        for happening in past[start..].iter().filter_map(RingEvent::happening) {
            match happening {
                Happening::First(first) => sides.push((first.distance, first.inside)),
                Happening::Test(test) => {
                    between = test.idx;
                    // The edge that closes the ring ends where it began.
                    if between[1] == sides.len() {
                        sides.push((test.distances[1], test.rule.ends_inside()));
                    }
                }
                Happening::Cross(crossing) => crossings.push((between, crossing)),
                Happening::Output(_) => {}
            }
        }
        Self { sides, crossings }
    }
}

/// The lists at a step, and what has been told of the limit at work.
pub struct RingStep<'a, V> {
    /// The list that is clipped; after a pass the next one, after the last the answer.
    pub list: &'a [V],
    /// The list that grows; empty once a limit is done with.
    pub output: &'a [V],
    /// The list that was clipped last; empty while one grows.
    pub passed: &'a [V],
    pub turn: Turn<V>,
    pub asked: Asked<V>,
}

impl<'a, V: Copy + PartialEq> RingStep<'a, V> {
    pub fn of<P: Ring<Vertex = V>, E: RingEvent<V>>(
        lists: &'a Lists<P>,
        past: &[E],
        begins: impl Fn(&E) -> bool,
    ) -> Self {
        let is_growing = |event: &E| event.happening().is_some() || begins(event);
        let other = lists.other().vertices();
        let (output, passed): (&[V], &[V]) = if past.last().is_some_and(is_growing) {
            (other, &[])
        } else {
            (&[], other)
        };
        Self {
            list: lists.list().vertices(),
            output,
            passed,
            turn: Turn::of(past, begins),
            asked: Asked::of(past),
        }
    }

    /// Where in the list the step is: at both ends of the edge that is looked at, or at the first vertex.
    pub fn current(&self) -> Vec<usize> {
        match self.asked.test {
            Some(test) => test.idx.to_vec(),
            None if self.passed.is_empty() => (0..self.turn.sides.len().min(1)).collect(),
            None => Vec::new(),
        }
    }
}

/// What a row answers that tests an edge: what that edge puts out.
pub const fn puts_nothing(row: Row) -> Row {
    row.answers_as(PUTS_OUT, "option-puts-nothing")
}

pub const fn puts_end(row: Row) -> Row {
    row.answers_as(PUTS_OUT, "option-puts-end")
}

pub const fn puts_crossing(row: Row) -> Row {
    row.answers_as(PUTS_OUT, "option-puts-crossing")
}

pub const fn puts_both(row: Row) -> Row {
    row.answers_as(PUTS_OUT, "option-puts-both")
}

/// The vertex that an event asks on which side it lies.
pub fn asked_vertex<V: Copy>(event: &impl RingEvent<V>) -> Option<V> {
    asked_now(event).map(|known| known.at)
}

/// The same, and what that has found.
pub fn asked_now<V: Copy>(event: &impl RingEvent<V>) -> Option<Known<V>> {
    match event.happening()? {
        Happening::First(first) => Some(first),
        Happening::Test(test) => Some(Known {
            at: test.ends[1],
            distance: test.distances[1],
            inside: test.rule.ends_inside(),
        }),
        Happening::Cross(_) | Happening::Output(_) => None,
    }
}

/// Does an edge that changes sides have a crossing? Not if it only touches the border with its inside end.
pub const fn is_crossed(distances: [f64; 2]) -> bool {
    distances[0] != 0.0 && distances[1] != 0.0
}

pub const fn side_term(is_inside: bool) -> &'static str {
    if is_inside { "sh-inside" } else { "sh-outside" }
}

pub const fn rule_term(rule: Rule) -> &'static str {
    match rule {
        Rule::InIn => "rule-in-in",
        Rule::InOut => "rule-in-out",
        Rule::OutIn => "rule-out-in",
        Rule::OutOut => "rule-out-out",
    }
}
