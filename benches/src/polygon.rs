//! A hundred thousand convex polygons against a window.

use std::hint::black_box;

use clipscope::{
    algo::polygon::{
        ClipRegion, Clipped, Clipper, Pipeline, SutherlandHodgman, SutherlandHodgmanInput,
    },
    geom::{Point, Window},
    trace::{Recording, silent},
};
use line_clipping as peer;

use crate::{
    harness::{Contender, Results, Target, race},
    line::Xorshift,
};

const N_POLYGONS: usize = 100_000;

/// Percent of them that are inside, outside and cut.
const MIX: [usize; 3] = [12, 37, 51];

/// Each has between 8 and 64 vertices.
const N_VERTICES: [usize; 2] = [8, 64];

const N_ROUNDS: usize = 21;

const PEER: &str = "line-clipping 0.3, `clip_polygon`";
const OWNED: &str = "`Clipper::clip`, owned result";
const BORROWED: &str = "`Clipper::clip`, borrowed result";
const WITH_AREA: &str = "`Clipper::clip`, borrowed, asked whether it has an area";
const EXTENT: &str = "every polygon's extent, and nothing else";
const TAUGHT: &str = "Sutherland–Hodgman as taught, silent";
const PIPELINE: &str = "as a pipeline, silent";

/// Vertices of the polygon that is recorded.
const N_LARGE: usize = 10_000;

const RECORD: &str = "record every step";
const SEEK: &str = "go to a step";

/// Runs everything and prints the section.
pub fn run() {
    let window = Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window");
    let polygons = sample(window);
    check(window, &polygons);
    let n_vertices: usize = polygons.iter().map(Vec::len).sum();
    let results = measure(window, &polygons);
    println!("## Clipping {N_POLYGONS} convex polygons\n");
    println!(
        "{} to {} vertices each, {n_vertices} in all; {} % inside, {} % outside, {} % cut, in random order; \
         medians of {N_ROUNDS} interleaved rounds.\n",
        N_VERTICES[0], N_VERTICES[1], MIX[0], MIX[1], MIX[2]
    );
    println!("| what | ns a vertex | ratio | target | |\n|---|--:|--:|--:|---|");
    let row = |name: &str, target: Target| {
        let ns = results.secs(name) * 1e9 / n_vertices as f64;
        let ratio = results.ratio(name, PEER);
        println!(
            "| {name} | {ns:.2} | {ratio:.2} | {} |",
            target.cells(ratio)
        );
    };
    row(PEER, Target::None);
    row(OWNED, Target::AtMost(0.4));
    row(BORROWED, Target::AtMost(0.33));
    row(WITH_AREA, Target::None);
    row(EXTENT, Target::None);
    row(TAUGHT, Target::None);
    row(PIPELINE, Target::None);
    println!();
    record();
}

/// How long it takes to record the taught algorithm on one large polygon, as every frame of a drag does, and
/// to go to a step of the recording.
fn record() {
    let window = Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window");
    let mut random = Xorshift::seeded();
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / N_LARGE as f64;
        let radius = 0.2 + 1.8 * random.next();
        let (sin, cos) = angle.sin_cos();
        Point::new(radius * cos, radius * sin).expect("finite")
    };
    let input = SutherlandHodgmanInput {
        region: window.into(),
        vertices: (0..N_LARGE).map(corner).collect(),
    };
    let trace = Recording::<SutherlandHodgman>::new(input.clone());
    let n_steps = trace.events().len();
    let mut step = 0;
    let results = race(
        N_ROUNDS,
        vec![
            Contender::new(RECORD, || {
                black_box(Recording::<SutherlandHodgman>::new(input.clone()));
            }),
            Contender::new(SEEK, || {
                step = (step + 7_919) % n_steps;
                trace.at(step, |step| {
                    black_box(step.held);
                });
            }),
        ],
    );
    println!("A star of {N_LARGE} vertices cut by the window, {n_steps} steps:\n");
    println!("| what | ms |\n|---|--:|");
    for name in [RECORD, SEEK] {
        println!("| {name} | {:.2} |", results.secs(name) * 1e3);
    }
    println!();
}

/// Seeded polygons in the stated mix and in random order: corners of ellipses at random angles, of either
/// winding.
fn sample(window: Window) -> Vec<Vec<Point>> {
    let mut random = Xorshift::seeded();
    let mut clipper = Clipper::new(&window.into());
    let mut polygons = Vec::with_capacity(N_POLYGONS);
    let mut n_of_kind = [0; 3];
    while polygons.len() < N_POLYGONS {
        let polygon = ellipse(&mut random);
        let kind = match clipper.clip(&polygon) {
            Clipped::Inside(_) => 0,
            Clipped::Outside => 1,
            Clipped::Cut(_) => 2,
        };
        if n_of_kind[kind] < N_POLYGONS / 100 * MIX[kind] {
            n_of_kind[kind] += 1;
            polygons.push(polygon);
        }
    }
    for i in (1..N_POLYGONS).rev() {
        polygons.swap(i, (random.next() * (i + 1) as f64) as usize);
    }
    // Copied, so that they lie in memory in this order, as the peer's will.
    polygons.clone()
}

fn ellipse(random: &mut Xorshift) -> Vec<Point> {
    let [least, most] = N_VERTICES;
    let n = least + (random.next() * (most - least + 1) as f64) as usize;
    let [x, y] = [(); 2].map(|()| (2.0 * random.next() - 1.0) * 2.0);
    let [width, height] = [(); 2].map(|()| 0.1 + 0.9 * random.next());
    let start = random.next();
    let turn = if random.next() < 0.5 { 1.0 } else { -1.0 };
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * (start + turn * i as f64 / n as f64);
        let (sin, cos) = angle.sin_cos();
        Point::new(x + width * cos, y + height * sin).expect("finite")
    };
    (0..n).map(corner).collect()
}

/// Lower left and upper right of a polygon, as plainly as can be.
fn extent(polygon: &[Point]) -> [[f64; 2]; 2] {
    let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in polygon {
        let p = p.to_array();
        for i in 0..2 {
            min[i] = if p[i] < min[i] { p[i] } else { min[i] };
            max[i] = if p[i] > max[i] { p[i] } else { max[i] };
        }
    }
    [min, max]
}

fn peer_polygon(polygon: &[Point]) -> peer::Polygon {
    let points = polygon.iter().map(|p| peer::Point::new(p.x(), p.y()));
    points.collect::<Vec<_>>().into()
}

fn peer_window(window: Window) -> peer::Window {
    let [xmin, ymin, xmax, ymax] = window.to_array();
    peer::Window::new(xmin, xmax, ymin, ymax)
}

/// What is compared does the same work: the clipper gives the taught ring in every bit, and the peer's is the
/// same up to where it starts and to rounding.
fn check(window: Window, polygons: &[Vec<Point>]) {
    let region = ClipRegion::from(window);
    let mut clipper = Clipper::new(&region);
    for polygon in polygons {
        let input = SutherlandHodgmanInput {
            region: region.clone(),
            vertices: polygon.clone(),
        };
        let taught = silent::<SutherlandHodgman>(&input);
        let clipped = clipper.clip(polygon).vertices();
        assert_eq!(taught.vertices, clipped, "the clipper, {polygon:?}");
        assert_eq!(
            taught,
            silent::<Pipeline>(&input),
            "the pipeline, {polygon:?}"
        );
        let theirs =
            peer::sutherland_hodgman::clip_polygon(&peer_polygon(polygon), peer_window(window));
        let n = theirs.vertices.len();
        assert_eq!(n, clipped.len(), "the peer, {polygon:?}");
        let same = |start: usize| {
            (0..n).all(|i| {
                let (p, q) = (clipped[i], theirs.vertices[(start + i) % n]);
                (p.x() - q.x).abs() < 1e-12 && (p.y() - q.y).abs() < 1e-12
            })
        };
        assert!(n == 0 || (0..n).any(same), "the peer, {polygon:?}");
    }
}

fn measure(window: Window, polygons: &[Vec<Point>]) -> Results {
    let region = ClipRegion::from(window);
    let for_peer: Vec<peer::Polygon> = polygons.iter().map(|p| peer_polygon(p)).collect();
    let inputs: Vec<SutherlandHodgmanInput> = polygons
        .iter()
        .map(|polygon| SutherlandHodgmanInput {
            region: region.clone(),
            vertices: polygon.clone(),
        })
        .collect();
    let peer_window = peer_window(window);
    let mut clippers = [(); 3].map(|()| Clipper::new(&region));
    let [owned, borrowed, with_area] = &mut clippers;
    let contenders = vec![
        Contender::new(PEER, || {
            for polygon in &for_peer {
                black_box(peer::sutherland_hodgman::clip_polygon(polygon, peer_window));
            }
        }),
        Contender::new(OWNED, || {
            for polygon in polygons {
                black_box(owned.clip(polygon).vertices().to_vec());
            }
        }),
        Contender::new(BORROWED, || {
            for polygon in polygons {
                black_box(borrowed.clip(polygon));
            }
        }),
        Contender::new(WITH_AREA, || {
            for polygon in polygons {
                black_box(with_area.clip(polygon).has_area());
            }
        }),
        Contender::new(EXTENT, || {
            for polygon in polygons {
                black_box(extent(polygon));
            }
        }),
        Contender::new(TAUGHT, || {
            for input in &inputs {
                black_box(silent::<SutherlandHodgman>(input));
            }
        }),
        Contender::new(PIPELINE, || {
            for input in &inputs {
                black_box(silent::<Pipeline>(input));
            }
        }),
    ];
    race(N_ROUNDS, contenders)
}
