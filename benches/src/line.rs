//! A million segments against a window.

use std::hint::black_box;

use clipscope::{
    algo::line::{
        BitOrder, BruteForce, CohenSutherland, CohenSutherlandInput, CyrusBeck, CyrusBeckInput,
        LiangBarsky, NichollLeeNicholl, Visible, WindowInput,
        batch::{ClippedSegments, Segments, clip_all},
        kernel,
    },
    geom::{Point, Segment, Window},
    trace::silent,
};
use line_clipping as peer;

use crate::{
    hand_written,
    harness::{Contender, Results, Target, race},
};

const N_SEGMENTS: usize = 1_000_000;

/// Percent of them that are inside, rejected and cut.
const MIX: [usize; 3] = [30, 30, 40];

const N_ROUNDS: usize = 21;

const PEER: &str = "line-clipping 0.3, Cohen–Sutherland";
const COHEN_SUTHERLAND: &str = "Cohen–Sutherland, silent";
const COHEN_SUTHERLAND_BY_HAND: &str = "Cohen–Sutherland by hand, without `emit`";
const LIANG_BARSKY: &str = "Liang–Barsky as taught, silent";
const LIANG_BARSKY_BY_HAND: &str = "Liang–Barsky by hand, without `emit`";
const KERNEL: &str = "`kernel::clip`, a call a segment";
const BATCH: &str = "`batch::clip_all`";
const CYRUS_BECK: &str = "Cyrus–Beck, silent";
const NICHOLL_LEE_NICHOLL: &str = "Nicholl–Lee–Nicholl, silent";
const BRUTE_FORCE: &str = "brute force, silent";
const COPY: &str = "memory copy of the four arrays";

/// Runs everything and prints the section.
pub fn run() {
    let window = Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window");
    let segments = sample(&window);
    check(window, &segments);
    let results = measure(window, &segments);
    println!("## Clipping {N_SEGMENTS} segments\n");
    println!(
        "{} % inside, {} % rejected, {} % cut, in random order; medians of {N_ROUNDS} interleaved rounds.\n",
        MIX[0], MIX[1], MIX[2]
    );
    println!("| what | ns a segment | ratio | target | |\n|---|--:|--:|--:|---|");
    let row = |name: &str, base: &str, target: Target| {
        let ns = results.secs(name) * 1e9 / N_SEGMENTS as f64;
        let ratio = results.ratio(name, base);
        println!(
            "| {name} | {ns:.1} | {ratio:.2} | {} |",
            target.cells(ratio)
        );
    };
    row(PEER, PEER, Target::None);
    row(COHEN_SUTHERLAND, PEER, Target::AtMost(1.1));
    row(KERNEL, PEER, Target::AtMost(0.45));
    row(BATCH, PEER, Target::AtMost(0.18));
    row(COPY, PEER, Target::None);
    for taught in [LIANG_BARSKY, CYRUS_BECK, NICHOLL_LEE_NICHOLL, BRUTE_FORCE] {
        row(taught, PEER, Target::None);
    }
    println!("\nWhat tracing costs when nobody listens: silent over hand-written.\n");
    println!("| what | ns a segment | ratio | target | |\n|---|--:|--:|--:|---|");
    // Faster than by hand is no fault.
    let no_dearer = Target::AtMost(1.05);
    row(COHEN_SUTHERLAND, COHEN_SUTHERLAND_BY_HAND, no_dearer);
    row(LIANG_BARSKY, LIANG_BARSKY_BY_HAND, no_dearer);
    println!();
}

/// Seeded segments in the stated mix and in random order.
fn sample(window: &Window) -> Vec<Segment> {
    let mut random = Xorshift::seeded();
    let mut segments = Vec::with_capacity(N_SEGMENTS);
    let mut n_of_kind = [0; 3];
    while segments.len() < N_SEGMENTS {
        // Long ones for cuts and rejections, short ones for what is inside.
        let reach = if random.next() < 0.6 { 3.0 } else { 1.0 };
        let numbers = [(); 4].map(|()| (2.0 * random.next() - 1.0) * reach);
        let segment = Segment::try_from(numbers).expect("finite");
        let kind = match kernel::clip(window, &segment) {
            Some(visible) if visible == segment => 0,
            None => 1,
            Some(_) => 2,
        };
        if n_of_kind[kind] < N_SEGMENTS / 100 * MIX[kind] {
            n_of_kind[kind] += 1;
            segments.push(segment);
        }
    }
    for i in (1..N_SEGMENTS).rev() {
        segments.swap(i, (random.next() * (i + 1) as f64) as usize);
    }
    segments
}

/// G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003.
pub struct Xorshift(u64);

impl Xorshift {
    /// Always the same numbers.
    pub const fn seeded() -> Self {
        Self(88_172_645_463_325_252)
    }

    /// In [0, 1).
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// What is compared does the same work: same results, bit for bit where that is promised.
fn check(window: Window, segments: &[Segment]) {
    let mut clipped = ClippedSegments::default();
    clip_all(&window, &segments.iter().copied().collect(), &mut clipped);
    for (&segment, batch) in segments.iter().zip(clipped.iter()) {
        let input = WindowInput { window, segment };
        let taught = silent::<LiangBarsky>(&input);
        assert_eq!(taught, batch, "batch, {segment:?}");
        let kernel = kernel::clip(&window, &segment);
        assert_eq!(taught, kernel, "kernel, {segment:?}");
        let by_hand = hand_written::liang_barsky(&input);
        assert_eq!(taught.map(ends), by_hand, "Liang–Barsky, {segment:?}");
        let input = coded(input);
        let taught = silent::<CohenSutherland>(&input);
        let by_hand = hand_written::cohen_sutherland(&input);
        assert_eq!(taught.map(ends), by_hand, "Cohen–Sutherland, {segment:?}");
    }
}

fn ends(segment: Segment) -> [[f64; 2]; 2] {
    [segment.p1, segment.p2].map(Point::to_array)
}

fn coded(WindowInput { window, segment }: WindowInput) -> CohenSutherlandInput {
    let bit_order = BitOrder::Tbrl;
    CohenSutherlandInput {
        window,
        segment,
        bit_order,
    }
}

/// Fills `out` with what `clip` makes of `segments`.
fn each<S, V>(segments: &[S], out: &mut Vec<V>, clip: impl FnMut(&S) -> V) {
    out.clear();
    out.extend(segments.iter().map(clip));
    black_box(out);
}

fn measure(window: Window, segments: &[Segment]) -> Results {
    let peer_window = peer::Window::new(-1.0, 1.0, -1.0, 1.0);
    let peer_segment = |&segment: &Segment| {
        let [p1, p2] = ends(segment).map(|[x, y]| peer::Point::new(x, y));
        peer::LineSegment::new(p1, p2)
    };
    let peer_segments: Vec<peer::LineSegment> = segments.iter().map(peer_segment).collect();
    let columns: Segments = segments.iter().copied().collect();
    let flat: Vec<f64> = segments.iter().flat_map(|s| s.to_array()).collect();
    let (mut clipped, mut copied) = (ClippedSegments::default(), flat.clone());
    let mut for_peer = Vec::with_capacity(N_SEGMENTS);
    let mut outs: [Vec<Visible>; 6] = [(); 6].map(|()| Vec::with_capacity(N_SEGMENTS));
    let mut by_hand: [Vec<_>; 2] = [(); 2].map(|()| Vec::with_capacity(N_SEGMENTS));
    let [cs, lb, cb, nln, bf, one] = &mut outs;
    let [cs_by_hand, lb_by_hand] = &mut by_hand;
    let input = |&segment: &Segment| WindowInput { window, segment };
    let mut convex = CyrusBeckInput {
        clip: window.into(),
        segment: segments[0],
    };
    let contenders = vec![
        Contender::new(PEER, || {
            each(&peer_segments, &mut for_peer, |&s| {
                peer::cohen_sutherland::clip_line(s, peer_window)
            });
        }),
        Contender::new(COHEN_SUTHERLAND, || {
            each(segments, cs, |s| {
                silent::<CohenSutherland>(&coded(input(s)))
            });
        }),
        Contender::new(COHEN_SUTHERLAND_BY_HAND, || {
            each(segments, cs_by_hand, |s| {
                hand_written::cohen_sutherland(&coded(input(s)))
            });
        }),
        Contender::new(KERNEL, || each(segments, one, |s| kernel::clip(&window, s))),
        Contender::new(BATCH, || {
            clip_all(&window, &columns, &mut clipped);
            black_box(&mut clipped);
        }),
        Contender::new(COPY, || {
            copied.copy_from_slice(&flat);
            black_box(&mut copied);
        }),
        Contender::new(LIANG_BARSKY, || {
            each(segments, lb, |s| silent::<LiangBarsky>(&input(s)));
        }),
        Contender::new(LIANG_BARSKY_BY_HAND, || {
            each(segments, lb_by_hand, |s| {
                hand_written::liang_barsky(&input(s))
            });
        }),
        Contender::new(CYRUS_BECK, || {
            each(segments, cb, |s| {
                convex.segment = *s;
                silent::<CyrusBeck>(&convex)
            });
        }),
        Contender::new(NICHOLL_LEE_NICHOLL, || {
            each(segments, nln, |s| silent::<NichollLeeNicholl>(&input(s)));
        }),
        Contender::new(BRUTE_FORCE, || {
            each(segments, bf, |s| silent::<BruteForce>(&input(s)));
        }),
    ];
    race(N_ROUNDS, contenders)
}
