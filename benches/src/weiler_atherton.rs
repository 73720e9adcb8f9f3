//! Two simple polygons of 1,000 vertices each; and how the time grows from 100 to 10,000.

use std::{f64::consts::TAU, hint::black_box};

use clipscope::{
    algo::polygon::weiler_atherton::{WeilerAtherton, WeilerAthertonInput, WeilerAthertonOutput},
    geom::{Point, SimplePolygon},
    trace::{Recording, silent},
};
use geo::{Area, BooleanOps};
use i_overlay::{
    core::{fill_rule::FillRule, overlay_rule::OverlayRule},
    float::single::SingleFloatOverlay,
};

use crate::{
    harness::{Contender, Results, Target, race},
    plot,
};

const N_VERTICES: usize = 1000;

const GROWTH: [usize; 5] = [100, 300, 1000, 3000, 10_000];

const N_ROUNDS: usize = 21;

const OURS: &str = "Weiler–Atherton, silent";
const CHECKED: &str = "both outlines checked to be simple, then the same";
const RECORDED: &str = "recorded, as for the screen";
const GEO: &str = "geo 0.33, `intersection`";
const I_OVERLAY: &str = "i_overlay 9, `overlay`";

type Outline = Vec<[f64; 2]>;

/// Two outlines of `n` vertices each.
struct Kind {
    name: &'static str,
    make: fn(usize) -> [Outline; 2],
}

const KINDS: [Kind; 3] = [
    Kind {
        name: "stars with long spikes",
        make: |n| [star(n, 1, 0.5, [0.0; 2]), star(n, 2, 0.5, [0.01, 0.02])],
    },
    Kind {
        name: "rough discs that overlap",
        make: |n| [star(n, 1, 0.02, [0.0; 2]), star(n, 2, 0.02, [0.9, 0.3])],
    },
    Kind {
        name: "combs, tooth across tooth",
        make: |n| [comb(n, false), comb(n, true)],
    },
];

/// Runs everything and prints the section.
pub fn run() {
    println!("## Two simple polygons of {N_VERTICES} vertices each\n");
    println!(
        "Owned results; medians of {N_ROUNDS} interleaved rounds; the ratio is to the faster peer.\n"
    );
    println!("| input | what | µs | ratio | target | |\n|---|---|--:|--:|--:|---|");
    for kind in &KINDS {
        let outlines = (kind.make)(N_VERTICES);
        let n_crossings = check(&outlines);
        let results = measure(
            &outlines,
            N_ROUNDS,
            &[OURS, CHECKED, RECORDED, GEO, I_OVERLAY],
        );
        let peer = faster_peer(&results);
        let label = format!("{}: {n_crossings} intersections", kind.name);
        for (name, target) in [
            (OURS, Target::AtMost(1.0)),
            (CHECKED, Target::AtMost(1.0)),
            (RECORDED, Target::None),
            (GEO, Target::None),
            (I_OVERLAY, Target::None),
        ] {
            let ratio = results.ratio(name, peer);
            println!(
                "| {label} | {name} | {:.0} | {ratio:.2} | {} |",
                results.secs(name) * 1e6,
                target.cells(ratio)
            );
        }
    }
    growth();
}

fn faster_peer(results: &Results) -> &'static str {
    if results.secs(GEO) < results.secs(I_OVERLAY) {
        GEO
    } else {
        I_OVERLAY
    }
}

fn growth() {
    println!("\n### Growth\n\nMicroseconds, as above.\n");
    let header: Vec<String> = GROWTH.iter().map(ToString::to_string).collect();
    println!(
        "| input | what | {} |\n|---|---|{}",
        header.join(" | "),
        "--:|".repeat(GROWTH.len())
    );
    let mut panels = Vec::new();
    for kind in &KINDS {
        let contenders = [OURS, CHECKED, GEO, I_OVERLAY];
        let mut curves: Vec<Vec<f64>> = vec![Vec::new(); contenders.len()];
        for n in GROWTH {
            let outlines = (kind.make)(n);
            let n_rounds = if n > 1000 { 7 } else { N_ROUNDS };
            let results = measure(&outlines, n_rounds, &contenders);
            for (curve, name) in curves.iter_mut().zip(contenders) {
                curve.push(results.secs(name) * 1e6);
            }
        }
        for (curve, name) in curves.iter().zip(contenders) {
            let cells: Vec<String> = curve.iter().map(|us| format!("{us:.0}")).collect();
            println!("| {} | {name} | {} |", kind.name, cells.join(" | "));
        }
        let labels = ["Weiler–Atherton", "with both checked", "geo", "i_overlay"];
        panels.push(plot::Panel {
            title: kind.name,
            of: "vertices of each polygon",
            curves: labels.into_iter().zip(curves).collect(),
        });
    }
    let xs = GROWTH.map(|n| n as f64);
    plot::save("weiler_atherton.svg", &xs, &panels);
}

fn measure(outlines: &[Outline; 2], n_rounds: usize, names: &[&'static str]) -> Results {
    let input = prepared(outlines);
    let [subject, clip] = outlines;
    let [geo_subject, geo_clip] = outlines.each_ref().map(as_geo);
    let contender = |name: &'static str| match name {
        OURS => Contender::new(name, || {
            black_box(silent::<WeilerAtherton>(black_box(&input)));
        }),
        CHECKED => Contender::new(name, || {
            black_box(silent::<WeilerAtherton>(&prepared(black_box(outlines))));
        }),
        RECORDED => Contender::new(name, || {
            black_box(Recording::<WeilerAtherton>::new(black_box(&input).clone()));
        }),
        GEO => Contender::new(name, || {
            black_box(black_box(&geo_subject).intersection(black_box(&geo_clip)));
        }),
        _ => Contender::new(name, || {
            let rule = (OverlayRule::Intersect, FillRule::NonZero);
            black_box(black_box(subject).overlay(black_box(clip), rule.0, rule.1));
        }),
    };
    race(n_rounds, names.iter().map(|name| contender(name)).collect())
}

fn prepared(outlines: &[Outline; 2]) -> WeilerAthertonInput {
    let [subject, clip] = outlines
        .each_ref()
        .map(|outline| SimplePolygon::new(outline).expect("simple"));
    WeilerAthertonInput {
        subject: subject.into(),
        clip,
    }
}

fn as_geo(outline: &Outline) -> geo::Polygon<f64> {
    geo::Polygon::new(
        outline.iter().map(|&[x, y]| geo::Coord { x, y }).collect(),
        Vec::new(),
    )
}

/// All find the same area. Returns the number of intersections.
fn check(outlines: &[Outline; 2]) -> usize {
    let input = prepared(outlines);
    let ours = area(&silent::<WeilerAtherton>(&input));
    let [s, c] = outlines.each_ref().map(as_geo);
    let geo = s.intersection(&c).unsigned_area();
    let shapes = outlines[0].overlay(&outlines[1], OverlayRule::Intersect, FillRule::NonZero);
    let i_overlay: f64 = shapes
        .iter()
        .flatten()
        .map(|ring| as_geo(ring).signed_area())
        .sum();
    for (name, theirs) in [(GEO, geo), (I_OVERLAY, i_overlay)] {
        // Both round coordinates to a grid of 32 bits.
        assert!(
            (ours - theirs).abs() < 1e-6 * ours,
            "{name} finds {theirs}, not {ours}"
        );
    }
    let run = Recording::<WeilerAtherton>::new(input);
    run.held().lists.nodes.len()
}

fn area(clipped: &WeilerAthertonOutput) -> f64 {
    let ring = |ring: &Vec<Point>| {
        let points: Outline = ring.iter().map(|p| p.to_array()).collect();
        as_geo(&points).signed_area()
    };
    let rings = clipped
        .pieces
        .iter()
        .flat_map(|piece| std::iter::once(&piece.outer).chain(&piece.holes));
    rings.map(ring).sum()
}

/// Corners at equal angles around a centre, at distances between 1 − `depth` and 1.
fn star(n: usize, seed: u64, depth: f64, [cx, cy]: [f64; 2]) -> Outline {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let corner = |i: usize| {
        let angle = TAU * i as f64 / n as f64;
        let radius = 1.0 - depth * random();
        [cx + radius * angle.cos(), cy + radius * angle.sin()]
    };
    (0..n).map(corner).collect()
}

/// Long teeth that hang from a back, notched finely so that there are `n` vertices; the other comb lies, so that
/// every tooth crosses every tooth.
fn comb(n: usize, lying: bool) -> Outline {
    let n_teeth = (n as f64).sqrt() as usize / 2;
    let n_notches = (n - 4 * n_teeth) / n_teeth;
    let mut outline = Vec::with_capacity(n);
    for tooth in 0..n_teeth {
        let [left, step] = [tooth as f64 / n_teeth as f64, 1.0 / n_teeth as f64];
        outline.push([left, 1.0]);
        outline.push([left + 0.013 * step, 0.0]);
        for notch in 0..n_notches {
            let x = left + step * (0.1 + 0.3 * notch as f64 / n_notches as f64);
            outline.push([x, 0.02 * (notch % 2) as f64 + 0.01]);
        }
        outline.push([left + 0.5 * step, 0.0]);
        outline.push([left + 0.513 * step, 1.0]);
    }
    outline.push([1.1, 1.1]);
    outline.push([-0.1, 1.1]);
    if lying {
        outline.iter().map(|&[x, y]| [y, x]).collect()
    } else {
        outline
    }
}
