//! Painter's algorithm: sorting by depth, and what the overlap tests take beside it.

use std::{convert::Infallible, time::Instant};

use clipscope::{
    algo::{
        ring::Right,
        surface::{Painter, PainterAnswer, PainterEvent, PainterHeld, PairTest, Surfaces},
    },
    geom::ViewVolume,
    trace::{Listening, Method, Told},
};

use crate::{
    harness::{Target, median},
    space::Lot,
};

const N_TRIANGLES: usize = 10_000;
const N_ROUNDS: usize = 7;
const SIZE: [u32; 2] = [640, 480];

/// Seconds: keys, sorting, overlap tests, and painting where there is an order.
type Parts = [f64; 4];

pub fn run() {
    let volume = ViewVolume::perspective(60.0, 4.0 / 3.0, 1.0, 30.0).expect("a volume");
    let surfaces = Surfaces::new(SIZE, volume, soup(), false).expect("numbers");
    let mut rounds: Vec<Parts> = Vec::new();
    let mut told = String::new();
    for _ in 0..N_ROUNDS {
        let start = Instant::now();
        let (mut keyed, mut first_sorted, mut sorted) = (start, None, start);
        let mut tested = None;
        let mut listening = Listening(|_: &PainterHeld, event| {
            match event {
                PainterEvent::Key { .. } => keyed = Instant::now(),
                PainterEvent::Sort { .. } => {
                    sorted = Instant::now();
                    first_sorted.get_or_insert(sorted);
                }
                // So many that a clock would take longer than they do.
                PainterEvent::Pair { .. }
                | PainterEvent::Constraint { .. }
                | PainterEvent::Place { .. } => {}
                PainterEvent::Cycle { .. } | PainterEvent::Paint { .. } | PainterEvent::Done => {
                    tested.get_or_insert_with(Instant::now);
                }
            }
            Told::<Infallible>::Continue(())
        });
        let mut held = Painter::<Right>::begin(&surfaces);
        let Told::Continue(()) =
            Painter::<Right>::run::<f64, _>(&surfaces, &mut held, &mut listening);
        let output = Painter::<Right>::output(held);
        let done = Instant::now();
        let first_sorted = first_sorted.expect("some are sorted");
        let tested = tested.expect("the run ends");
        rounds.push([
            (keyed - start).as_secs_f64(),
            (first_sorted - keyed).as_secs_f64(),
            (tested - sorted).as_secs_f64(),
            (done - tested).as_secs_f64(),
        ]);
        let decided = PairTest::ALL.iter().zip(output.tally.decided);
        let decided: Vec<String> = decided.map(|(test, n)| format!("{test:?} {n}")).collect();
        let found = match &output.answer {
            PainterAnswer::Order { .. } => "an order".to_owned(),
            PainterAnswer::Cycle { cycle } => format!("a cycle of {}", cycle.len()),
        };
        told = format!(
            "{} ordered pairs were asked ({}); found: {found}",
            output.tally.pairs,
            decided.join(", ")
        );
    }
    println!("## Painter's algorithm\n\n{N_TRIANGLES} small triangles that do not meet; {told}.\n");
    println!("| part | ms | target | |\n|---|--:|--:|---|");
    for (i, (name, target)) in [
        (
            "each triangle's key, its extents and its plane",
            Target::None,
        ),
        ("sorting by the keys", Target::AtMost(5.0)),
        ("overlap tests", Target::None),
        ("painting 640 × 480", Target::None),
    ]
    .into_iter()
    .enumerate()
    {
        let millis = 1e3 * median(rounds.iter().map(|parts| parts[i]));
        println!("| {name} | {millis:.2} | {}", target.cells(millis));
    }
    println!();
}

/// In cells of their own.
fn soup() -> Vec<[[f64; 3]; 3]> {
    let mut lot = Lot(5);
    (0..N_TRIANGLES)
        .map(|i| {
            let cell = [i % 25, i / 25 % 20, i / 500].map(|n| n as f64);
            let corner = |lot: &mut Lot| {
                let inside = [0; 3].map(|_| 0.9 * lot.next());
                [
                    0.8 * (cell[0] + inside[0] - 12.5),
                    0.8 * (cell[1] + inside[1] - 10.0),
                    -8.0 - cell[2] - inside[2],
                ]
            };
            [0; 3].map(|_| corner(&mut lot))
        })
        .collect()
}
