//! A step of a clipper by inequalities, with what the picture needs of those before it.

use crate::{
    algo::{
        parameter::End,
        segment::{
            Bounds, EventOf, Given, LineClip, LineEvent, LineRules, RowNumbers, VisibleLine,
        },
    },
    figure::Side,
    labs::interval::{ShownCrossing, ShownInterval},
    text::Value,
    trace::Step,
};

use super::{LineLook, line_look::ratio};

/// One line of the table.
#[derive(Debug)]
pub struct SeenRow<const N: usize, B: Bounds<N>> {
    /// The plane.
    pub plane: B::Plane,
    /// p and q, or what they follow from.
    pub numbers: B::Row,
    /// q / p, where there is one.
    pub r: Option<f64>,
    /// The interval after it, once known.
    pub left: Option<[f64; 2]>,
}

impl<const N: usize, B: Bounds<N>> SeenRow<N, B> {
    /// How much the way to P₂ takes away.
    pub fn p(&self) -> f64 {
        self.numbers.p_and_q()[0]
    }
}

/// A step, whatever the rules.
pub struct LineStep<'a, const N: usize, B: LineLook<N>> {
    /// What the method runs on.
    pub input: &'a B::Input,
    /// The event that led to the step.
    pub event: Option<EventOf<N, B>>,
    /// Are the ends divided before they are clipped?
    pub is_divided: bool,
    /// What is clipped: as given, but by wrong rules.
    pub ends: [[f64; N]; 2],
    /// P₂ − P₁, once known and where it is needed.
    pub delta: Option<[f64; N]>,
    /// The table, as far as it is filled.
    pub rows: Vec<SeenRow<N, B>>,
    /// What is left of the parameter.
    pub bounds: [f64; 2],
    /// The planes that set it.
    pub set_by: [Option<B::Plane>; 2],
    /// Ends already put in place.
    pub put: [Option<[f64; N]>; 2],
    /// The answer, once known: what lies outside a parallel plane is rejected as soon as that is seen.
    pub verdict: Option<VisibleLine<N>>,
}

impl<'a, const N: usize, B: LineLook<N>> LineStep<'a, N, B> {
    /// After all that is past.
    pub fn of<L: LineRules>(step: &Step<'a, LineClip<N, B, L>>) -> Self {
        Self::after::<L>(step.input, step.past)
    }

    /// Before the last event.
    pub fn before<L: LineRules>(step: &Step<'a, LineClip<N, B, L>>) -> Self {
        let past = step.past.split_last().map_or(&[][..], |(_, before)| before);
        Self::after::<L>(step.input, past)
    }

    fn after<L: LineRules>(input: &'a B::Input, past: &[EventOf<N, B>]) -> Self {
        let mut shown = Self {
            input,
            event: past.last().copied(),
            is_divided: L::DIVIDES_FIRST,
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
            LineEvent::Delta { .. }
            | LineEvent::Depths { .. }
            | LineEvent::Put { .. }
            | LineEvent::Accept { .. } => None,
        }
    }

    /// The row of a plane that has been asked.
    pub fn row_of(&self, plane: B::Plane) -> Option<&SeenRow<N, B>> {
        self.rows.iter().find(|row| row.plane == plane)
    }

    /// What is left of the parameter, with the crossings.
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

    /// Where the segment's line crosses the planes, to make room for it.
    pub fn reach(&self) -> impl Iterator<Item = f64> + '_ {
        let ends = self.input.ends();
        self.input.bounds().planes().map(move |plane| {
            let [d1, d2] = self.input.bounds().distances(plane, &ends);
            d1 / (d1 - d2)
        })
    }
}
