//! A step of a clipper by inequalities, with what the picture needs of those before it; and what is particular to each kind of
//! bounds: how its planes, its numbers and its crossings are called, written and drawn.

use crate::{
    algo::segment::{Bounds, EventOf},
    labs::{
        crossing_formulas::Weights,
        interval::{ShownCrossing, ShownInterval, quotient},
    },
};

use super::prelude::*;

#[derive(Debug)]
pub struct LineKeys {
    pub opening: &'static str,
    pub delta: &'static str,
    /// A row: the line comes in, goes out, is parallel.
    pub row: [&'static str; 3],
    pub parallel: [&'static str; 2],
    pub enter: [&'static str; 2],
    /// Going out lowers the upper bound, or does not.
    pub leave: [&'static str; 2],
    pub put: &'static str,
    /// The end, where one point is left, and where one was given.
    pub one_point: [&'static str; 2],
    pub reject: &'static str,
}

pub trait LineLook<const N: usize>: Bounds<N, Output: Answer> {
    type Scenery: Send + Sync + 'static;
    const SOURCE: &'static str;
    const KEYS: LineKeys;
    const WATCHED: &'static [&'static str] = &["P₁", "P₂", "Δ", "P₁′", "P₂′"];
    /// The parameter along the segment, and where it crosses a plane.
    const SYMBOLS: [&'static str; 2];
    const HEADER: [&'static str; 2];
    /// The quotient of them, as it is written: above, below, each a symbol or one minus another.
    const QUOTIENT: [&'static [&'static str]; 2];
    /// Its sign and that of the denominator, beside q/p.
    const SIGN: f64;
    /// What stands before the number that decides of a parallel line.
    const PARALLEL: &'static str;
    const ROWS_VIEW: &'static str = "rows";
    const PLANES: &'static str = "column-plane";
    const NOTES: [&'static str; 2];
    /// Has the watch table a row for each plane from the start, and a word on which way the line goes?
    const WATCHES: [bool; 2] = [false, true];
    /// Are the planes the rows of the table, and the interval an axis? Else the points are.
    const SHOWS_PLANES: bool = true;

    fn plane(plane: Self::Plane, scenery: Option<&Self::Scenery>) -> Named;

    fn plane_in_table(plane: Self::Plane, scenery: Option<&Self::Scenery>) -> Option<Value> {
        Self::plane(plane, scenery).value
    }

    fn numbers(&self, ends: &[[f64; N]; 2], row: &SeenRow<N, Self>) -> [f64; 2];

    /// What they are, where a symbol says it.
    fn meaning(_plane: Self::Plane) -> Option<[String; 2]> {
        None
    }

    fn row_formulas(&self, ends: &[[f64; N]; 2], row: &SeenRow<N, Self>) -> Vec<Formula>;

    /// Of an end; where nothing else is said it is a mean of both, all coordinates at once.
    fn put_formulas(
        shown: &LineStep<'_, N, Self>,
        end: End,
        plane: Self::Plane,
        at: [f64; N],
    ) -> Vec<Formula> {
        let symbol = ["P₁′", "P₂′"][end.idx()];
        let distances = shown.input.bounds().distances(plane, &shown.ends);
        vec![Weights::across(distances).mean_of_places(symbol, &shown.ends, at)]
    }

    fn border(&self, plane: Self::Plane, scenery: Option<&Self::Scenery>) -> Value;

    fn other_notes(_: &LineStep<'_, N, Self>) -> Vec<TableNote> {
        Vec::new()
    }

    fn quotient_header() -> Formula {
        sym(Self::SYMBOLS[1])
    }

    const STARTS_WHOLE: bool = false;

    /// What stands beside the drawing in rows, where it is not the planes in their order.
    fn rows(_: &LineStep<'_, N, Self>) -> Option<Body> {
        None
    }

    fn drawing(shown: &LineStep<'_, N, Self>, scenery: Option<&Self::Scenery>) -> Vec<View>;
}

/// How a method is called by one set of rules; `B` is what it clips against, or what it is given.
pub trait LineVariant<const N: usize, B>: Copy + 'static {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    /// Its pseudocode, as many lines and of the same sense for all rules.
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}

/// The crossing's parameter as the quotient that it was computed as, by the signs that the method writes.
pub fn ratio<const N: usize, B: LineLook<N>>(row: &SeenRow<N, B>, r: f64) -> Ratio {
    let zero = 0.0;
    let signed = |x: f64| if B::SIGN < 0.0 { zero - x } else { x };
    let [p, q] = row.numbers.p_and_q();
    quotient(signed(q), signed(p), r)
}

#[derive(Debug)]
pub struct SeenRow<const N: usize, B: Bounds<N>> {
    pub plane: B::Plane,
    /// p and q, or what they follow from.
    pub numbers: B::Row,
    pub r: Option<f64>,
    pub left: Option<[f64; 2]>,
}

impl<const N: usize, B: Bounds<N>> SeenRow<N, B> {
    /// How much the way to P₂ takes away.
    pub fn p(&self) -> f64 {
        self.numbers.p_and_q()[0]
    }
}

pub struct LineStep<'a, const N: usize, B: LineLook<N>> {
    pub input: &'a B::Input,
    past: &'a [EventOf<N, B>],
    pub event: Option<EventOf<N, B>>,
    pub is_divided: bool,
    pub is_turned: bool,
    /// What is clipped: as given, but by wrong rules.
    pub ends: [[f64; N]; 2],
    pub delta: Option<[f64; N]>,
    pub rows: Vec<SeenRow<N, B>>,
    pub bounds: [f64; 2],
    pub set_by: [Option<B::Plane>; 2],
    pub put: [Option<[f64; N]>; 2],
    /// The answer, once known: what lies outside a parallel plane is rejected as soon as that is seen.
    pub verdict: Option<VisibleLine<N>>,
}

impl<'a, const N: usize, B: LineLook<N>> LineStep<'a, N, B> {
    pub fn of<L: LineRules>(step: &Step<'a, LineClip<N, B, L>>) -> Self {
        Self::after(step.input, step.past, [L::DIVIDES_FIRST, L::TURNS_NORMALS])
    }

    /// The step before this one.
    pub fn before(&self) -> Self {
        let past = self.past.split_last().map_or(&[][..], |(_, before)| before);
        Self::after(self.input, past, [self.is_divided, self.is_turned])
    }

    fn after(
        input: &'a B::Input,
        past: &'a [EventOf<N, B>],
        [is_divided, is_turned]: [bool; 2],
    ) -> Self {
        let mut shown = Self {
            past,
            input,
            event: past.last().copied(),
            is_divided,
            is_turned,
            ends: input.ends(),
            delta: None,
            rows: Vec::new(),
            bounds: [0.0, 1.0],
            set_by: [None; 2],
            put: [None; 2],
            verdict: None,
        };
        for event in past {
            shown.see(*event);
        }
        shown
    }

    fn see(&mut self, event: EventOf<N, B>) {
        match event {
            LineEvent::Delta { delta } => self.delta = Some(delta),
            LineEvent::Depths { ends, .. } => self.ends = ends,
            LineEvent::Row { plane, row } => self.rows.push(SeenRow {
                plane,
                numbers: row,
                r: None,
                left: None,
            }),
            LineEvent::Enter {
                plane,
                r,
                raises,
                u_min,
            } => self.bound(End::P1, plane, r, raises, u_min),
            LineEvent::Leave {
                plane,
                r,
                lowers,
                u_max,
            } => self.bound(End::P2, plane, r, lowers, u_max),
            LineEvent::Parallel { inside, .. } => {
                self.keep();
                self.verdict = (!inside).then_some(None);
            }
            LineEvent::Interval { .. } => {}
            LineEvent::Put { end, at, .. } => self.put[end.idx()] = Some(at),
            LineEvent::Accept { ends } => self.verdict = Some(Some(ends)),
            LineEvent::Reject { .. } => self.verdict = Some(None),
        }
    }

    fn bound(&mut self, end: End, plane: B::Plane, r: f64, moves: bool, u: f64) {
        if let Some(row) = self.rows.last_mut() {
            row.r = Some(r);
        }
        self.bounds[end.idx()] = u;
        if moves {
            self.set_by[end.idx()] = Some(plane);
        }
        self.keep();
    }

    fn keep(&mut self) {
        if let Some(row) = self.rows.last_mut() {
            row.left = Some(self.bounds);
        }
    }

    /// The plane that the step is about; while the interval is looked at, the last one.
    pub fn in_hand(&self) -> Option<B::Plane> {
        match self.event? {
            LineEvent::Row { plane, .. }
            | LineEvent::Parallel { plane, .. }
            | LineEvent::Enter { plane, .. }
            | LineEvent::Leave { plane, .. } => Some(plane),
            LineEvent::Reject { plane } => plane,
            LineEvent::Interval { .. } => self.rows.last().map(|row| row.plane),
            _ => None,
        }
    }

    pub fn row_of(&self, plane: B::Plane) -> Option<&SeenRow<N, B>> {
        self.rows.iter().find(|row| row.plane == plane)
    }

    pub fn interval(&self, scenery: Option<&B::Scenery>) -> ShownInterval {
        let current = self.in_hand();
        let crossings = self.rows.iter().filter_map(|row| {
            let at = row.r?;
            let plane = B::plane(row.plane, scenery);
            Some(ShownCrossing {
                at,
                quotient: ratio(row, at),
                side: Side::of(row.p()),
                holds: self.set_by.contains(&Some(row.plane)),
                current: current == Some(row.plane),
                name: plane.value.unwrap_or(Value::Name(String::new())),
                link: plane.link?,
            })
        });
        ShownInterval {
            symbol: B::SYMBOLS[0],
            bounds: self.bounds,
            crossings: crossings.collect(),
            is_rejected: self.verdict == Some(None),
        }
    }

    pub fn reach(&self) -> impl Iterator<Item = f64> + '_ {
        let ends = self.input.ends();
        self.input.bounds().planes().map(move |plane| {
            let [d1, d2] = self.input.bounds().distances(plane, &ends);
            d1 / (d1 - d2)
        })
    }
}
