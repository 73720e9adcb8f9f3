//! One frame of the interface: layout and tessellation, nothing painted.

use std::f32::consts::TAU;

use clipscope::{
    algo::surface::DepthSteps,
    app::Command,
    labs::{
        Edit,
        lines::LinesChange,
        polygons::{self, PolygonsChange},
        space::{RasterPlan, SpaceChange},
    },
};
use egui::{Event, Key, vec2};

use crate::{
    desk::{Desk, Took, strike},
    harness::{Target, median, quantile},
};

const N_FRAMES: usize = 600;
/// A scene of 100,000 segments takes longer.
const N_CROWDED_FRAMES: usize = 60;
const N_CROWD: usize = 100_000;
const N_VERTICES: usize = 10_000;
const N_POLYGON_FRAMES: usize = 120;
/// Milliseconds: what a screen with 60 pictures a second leaves.
const POLYGON_TARGET: Target = Target::AtMost(16.0);
/// Milliseconds, in a lesson.
const TARGET: Target = Target::AtMost(2.0);
/// A lesson and its step.
const CUTTING: [&str; 2] = ["04-cutting-with-outcodes", "which-end-which-edge"];
/// The pointer goes round in this many frames.
const ROUND: usize = 97;

/// What is done while the frames are measured.
#[derive(Clone, Copy)]
enum Doing {
    /// Nothing changes: what a repaint costs that something outside asked for.
    Nothing,
    /// The next step of the run in every frame, from its end back to its start.
    Stepping,
    /// The pointer goes round over the stage, and things light up.
    Hovering,
    /// The first handle follows the pointer, and all is clipped and recorded again.
    Dragging,
    /// The next step of the lesson, or the one before.
    Turning,
    /// Another step of the run in every frame, far from the last.
    Scrubbing,
    /// Time passes: a step in some frames, nothing in the others.
    Playing,
}

impl Doing {
    /// In a lesson.
    const ALL: [Self; 5] = [
        Self::Nothing,
        Self::Stepping,
        Self::Hovering,
        Self::Dragging,
        Self::Turning,
    ];

    /// With a polygon of very many vertices.
    const OF_A_POLYGON: [Self; 6] = [
        Self::Nothing,
        Self::Stepping,
        Self::Scrubbing,
        Self::Playing,
        Self::Hovering,
        Self::Dragging,
    ];

    const fn name(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Stepping => "a step a frame",
            Self::Hovering => "hovering",
            Self::Dragging => "dragging a handle",
            Self::Turning => "a lesson step a frame",
            Self::Scrubbing => "scrubbing",
            Self::Playing => "playing",
        }
    }

    /// Measures so many frames.
    fn frames(self, desk: &mut Desk, n: usize) -> Vec<Took> {
        let start = desk.first_handle();
        if matches!(self, Self::Dragging) {
            desk.grip(start);
        }
        let took = (0..n).map(|i| {
            let round = i as f32 / ROUND as f32 * TAU;
            let events = match self {
                Self::Nothing => Vec::new(),
                Self::Stepping => {
                    let before = desk.app.position();
                    let took = desk.frame(strike(Key::ArrowRight));
                    if desk.app.position() == before {
                        desk.frame(strike(Key::Home));
                    }
                    return took;
                }
                Self::Scrubbing => {
                    let n_steps = desk.n_steps();
                    desk.seek(i * 7919 % (n_steps + 1));
                    Vec::new()
                }
                Self::Playing => {
                    if i == 0 {
                        desk.frame(strike(Key::Space));
                    }
                    Vec::new()
                }
                Self::Hovering => {
                    let at = start + vec2(round.cos() - 1.0, round.sin()) * 120.0;
                    vec![Event::PointerMoved(at)]
                }
                Self::Dragging => {
                    let at = start + vec2(round.cos() - 1.0, round.sin()) * 40.0;
                    vec![Event::PointerMoved(at)]
                }
                Self::Turning => {
                    let key = [Key::PageDown, Key::PageUp][i % 2];
                    // The frame that takes the key draws the old step.
                    desk.frame(strike(key));
                    Vec::new()
                }
            };
            let before = desk.first_place();
            let took = desk.frame(events);
            if matches!(self, Self::Dragging) && i % ROUND == ROUND / 2 {
                assert_ne!(desk.first_place(), before, "the handle follows");
            }
            took
        });
        let took = took.collect();
        if matches!(self, Self::Dragging) {
            let at = desk.first_handle();
            desk.let_go(at);
        }
        took
    }
}

/// Runs everything and prints the section.
pub fn run() {
    println!("## A frame of the interface\n");
    println!(
        "The lines lab at 1280 × 720, layout and tessellation, milliseconds; medians of {N_FRAMES} frames, of \
         {N_CROWDED_FRAMES} with {N_CROWD} segments, of {N_POLYGON_FRAMES} with {N_VERTICES} vertices.\n"
    );
    println!("| scene | doing | layout | tessellation | both | 95 % under | slowest | target | |");
    println!("|---|---|--:|--:|--:|--:|--:|--:|---|");
    for (name, lesson, step) in [
        ("Cohen–Sutherland", CUTTING[0], CUTTING[1]),
        ("Liang–Barsky", "05-intervals", "entering"),
    ] {
        for doing in Doing::ALL {
            let mut desk = Desk::at(lesson, step);
            row(name, doing, &doing.frames(&mut desk, N_FRAMES), TARGET);
        }
    }
    for doing in [Doing::Stepping, Doing::Dragging] {
        let mut desk = edited(Edit::Compare(Some("liang-barsky")));
        let took = doing.frames(&mut desk, N_FRAMES);
        row("both, side by side", doing, &took, TARGET);
    }
    for (name, position) in [
        ("100,000 segments, not clipped yet", 0),
        ("100,000 segments, clipped", usize::MAX),
    ] {
        for doing in [Doing::Nothing, Doing::Hovering, Doing::Dragging] {
            let mut desk = edited(Edit::own(LinesChange::Random {
                count: N_CROWD,
                seed: 1,
            }));
            desk.apply(Command::Seek(position));
            let took = doing.frames(&mut desk, N_CROWDED_FRAMES);
            row(name, doing, &took, Target::None);
        }
    }
    for doing in Doing::OF_A_POLYGON {
        let mut desk = Desk::at(CUTTING[0], CUTTING[1]);
        desk.apply(Command::Lab(polygons::LAB.id));
        desk.apply(Command::Edit(
            Edit::own(PolygonsChange::Random {
                count: N_VERTICES,
                seed: 1,
            }),
            None,
        ));
        let n_steps = desk.n_steps();
        desk.seek(n_steps / 2);
        let took = doing.frames(&mut desk, N_POLYGON_FRAMES);
        row("a polygon of 10,000 vertices", doing, &took, POLYGON_TARGET);
    }
    println!();
}

/// Long runs in space: a street through the funnel, its triangles drawn into a raster for teaching.
pub fn run_in_space() {
    println!("## Long runs in space\n");
    println!(
        "Layout and tessellation at 1280 × 720, milliseconds of {N_POLYGON_FRAMES} frames; the run in the middle at first.\n"
    );
    println!("| scene | doing | layout | tessellation | both | 95 % under | slowest | target | |");
    println!("|---|---|--:|--:|--:|--:|--:|--:|---|");
    let mut plan = RasterPlan::default().with_rows(120);
    plan.steps = DepthSteps::Fragments;
    for (name, lab, count, method) in [
        (
            "a street of 300 boxes in the funnel",
            "frustum",
            300,
            "funnel",
        ),
        (
            "a raster of 120 rows, 1,008 triangles",
            "surfaces",
            84,
            "depth-buffer",
        ),
    ] {
        for doing in [Doing::Nothing, Doing::Stepping, Doing::Scrubbing] {
            let mut desk = Desk::at(CUTTING[0], CUTTING[1]);
            desk.apply(Command::Lab(lab));
            desk.apply(Command::Free);
            let edits = [
                Edit::own(SpaceChange::Street { count, seed: 1 }),
                Edit::own(SpaceChange::Raster(plan)),
                Edit::Method(method),
            ];
            for edit in edits {
                desk.apply(Command::Edit(edit, None));
            }
            let n_steps = desk.n_steps();
            desk.seek(n_steps / 2);
            let took = doing.frames(&mut desk, N_POLYGON_FRAMES);
            let name = format!("{name}: {n_steps} steps");
            row(&name, doing, &took, POLYGON_TARGET);
        }
    }
    println!();
}

/// The app at a step of the course whose scene has been changed.
fn edited(edit: Edit) -> Desk {
    let mut desk = Desk::at(CUTTING[0], CUTTING[1]);
    desk.apply(Command::Edit(edit, None));
    desk
}

fn row(scene: &str, doing: Doing, took: &[Took], target: Target) {
    let ms = |part: fn(&Took) -> f64| 1e3 * median(took.iter().map(part));
    let both = ms(|took| took.both());
    let slowest = 1e3 * quantile(took.iter().map(|took| took.both()), 0.999_999);
    println!(
        "| {scene} | {} | {:.2} | {:.2} | {both:.2} | {:.2} | {slowest:.2} | {} |",
        doing.name(),
        ms(|took| took.layout),
        ms(|took| took.tessellation),
        1e3 * quantile(took.iter().map(|took| took.both()), 0.95),
        target.cells(if scene.contains("10,000") || scene.contains("steps") {
            slowest
        } else {
            both
        }),
    );
}
