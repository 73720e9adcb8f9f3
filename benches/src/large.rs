//! One object of very many triangles, stepped: how long it takes until a step that is asked for is seen.

use std::{sync::Arc, time::Instant};

use clipscope::{
    app::Command,
    geom::Mesh,
    labs::{
        Edit,
        space::{Model, NamedMesh, SpaceChange},
    },
};
use egui::Key;

use crate::{
    desk::{Desk, strike},
    harness::{Target, median, quantile},
    space::waves,
};

const SIZES: [usize; 7] = [1_000, 3_000, 10_000, 30_000, 100_000, 200_000, 1_000_000];
/// Milliseconds, of up to so many triangles.
const TARGET: (Target, usize) = (Target::AtMost(100.0), 200_000);
const N_FRAMES: usize = 24;
/// Through the run in steps of this part of it: no two steps after each other are near.
const STRIDE: f64 = 0.381_966;

/// A lab, its method, and how large the object is: as it comes, or so large that the camera's volume cuts it.
const RUNS: [(&str, &str, f64); 3] = [
    ("frustum", "funnel", 1.0),
    ("frustum", "funnel", 4.0),
    ("surfaces", "depth-buffer", 1.0),
];

pub fn run() {
    println!("## Steps of one large object\n");
    println!(
        "The app at 1280 × 720, layout and tessellation, milliseconds of {N_FRAMES} frames; the slowest counts. A seek goes far along the run.\n"
    );
    println!("| method | triangles | steps | first frame | slowest until then | seek | slowest | next step | slowest | target | |");
    println!("|---|--:|--:|--:|--:|--:|--:|--:|--:|---|---|");
    for run in RUNS {
        for n in SIZES {
            row(run, n);
        }
    }
    println!();
}

fn row((lab, method, size): (&'static str, &'static str, f64), n: usize) {
    let (positions, _, faces) = waves(n);
    let n_triangles = faces.len();
    let mesh = Mesh::new(positions, Vec::new(), faces).expect("a sphere with waves");
    let named = NamedMesh {
        name: "waves".to_owned(),
        mesh,
        picture: None,
    };
    let mut desk = Desk::at("04-cutting-with-outcodes", "which-end-which-edge");
    desk.apply(Command::Lab(lab));
    desk.apply(Command::Free);
    let edits = [
        Edit::own(SpaceChange::Street { count: 1, seed: 1 }),
        Edit::own(SpaceChange::Add(Model::Mesh(Arc::new(named)))),
        Edit::own(SpaceChange::Set("object.size", 0, size)),
        Edit::Method(method),
    ];
    let start = Instant::now();
    for edit in edits {
        desk.change(Command::Edit(edit, None));
    }
    let frames = desk.recorded();
    let frames: Vec<f64> = frames.into_iter().map(|took| 1e3 * took.both()).collect();
    let first = 1e3 * start.elapsed().as_secs_f64();
    let n_steps = desk.n_steps();
    let mut seek = Vec::new();
    let mut next = Vec::new();
    for i in 1..=N_FRAMES {
        let part = (i as f64 * STRIDE).fract();
        desk.seek((part * n_steps as f64) as usize);
        seek.push(1e3 * desk.frame(Vec::new()).both());
        let before = desk.app.position();
        let pressed = desk.frame(strike(Key::ArrowRight)).both();
        // The frame that takes the key may draw the old step.
        next.push(1e3 * pressed.max(desk.frame(Vec::new()).both()));
        assert_eq!(desk.app.position(), before + 1);
    }
    let slowest = |took: &[f64]| quantile(took.iter().copied(), 0.999_999);
    let meanwhile = slowest(&frames);
    let worst = slowest(&seek).max(slowest(&next)).max(meanwhile);
    let target = if n <= TARGET.1 { TARGET.0 } else { Target::None };
    let method = if size > 1.0 { "funnel, cut by the volume" } else { method };
    println!(
        "| {method} | {n_triangles} | {n_steps} | {first:.0} | {meanwhile:.1} | {:.1} | {:.1} | {:.1} | {:.1} | {} |",
        median(seek.iter().copied()),
        slowest(&seek),
        median(next.iter().copied()),
        slowest(&next),
        target.cells(worst),
    );
}
