//! Rows of bars at one scale: from where to where something reaches.

use crate::figure::{Multiples, SmallDrawing, Weight};

use super::prelude::*;

/// Of more the rows are too low.
const MOST: usize = 10;
/// Width over the height of one row; before and after a bar there is room for what is written at its ends.
const WIDTH: f64 = 11.0;
const AROUND: f64 = 3.2;

pub struct Bar {
    pub name: Value,
    pub reach: [f64; 2],
    /// What is written where it begins, and where it ends.
    pub ends: [Option<Value>; 2],
    pub role: Role,
}

/// None of none; of many those about the one in focus.
pub fn bars(title: &'static str, bars: &[Bar], focus: Option<usize>) -> Option<Multiples> {
    let bars = &bars[ListColumn::reach_of(MOST, bars.len(), focus)];
    if bars.is_empty() {
        return None;
    }
    let low = bars
        .iter()
        .fold(f64::INFINITY, |low, bar| low.min(bar.reach[0]));
    let high = bars
        .iter()
        .fold(0.0, |high: f64, bar| high.max(bar.reach[1]));
    let place = |x: f64, row: usize| {
        let part = (x - low) / (high - low).max(f64::MIN_POSITIVE);
        [WIDTH * part, -(row as f64)]
    };
    let mut marks = Vec::new();
    for (row, bar) in bars.iter().enumerate() {
        let ends = bar.reach.map(|x| place(x, row));
        marks.push(Mark::new(bar.role, Shape::Segment(ends)).weighing(Weight::of(6.0)));
        let name = Mark::new(bar.role, Shape::Label([-1.3 * AROUND, ends[0][1]]));
        marks.push(name.labelled(bar.name.clone()).strong());
        for (i, outward) in [-1.0, 1.0].into_iter().enumerate() {
            let end = Mark::new(bar.role, Shape::Vertex(ends[i])).weighing(Weight::of(2.0));
            let said = bar.ends[i].clone();
            marks.extend(said.map(|said| end.labelled(said).toward([outward, 0.0])));
        }
    }
    let (left, right) = (-1.5 * AROUND, WIDTH + AROUND);
    Some(Multiples {
        drawings: vec![SmallDrawing::new(Value::Term(title), None, marks)],
        bounds: [[left, 0.4 - bars.len() as f64], [right, 0.6]],
        tiles: Tiles::Strip,
    })
}
