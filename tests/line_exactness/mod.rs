//! What `clipscope::algo::line` promises, held to it.
//!
//! - `dyadic`: where the arithmetic is exact, all agree with an exact rational oracle, corners included.
//! - `floats`: what is promised for any finite numbers.
//! - `cases`: named cases, the worked numbers of the course, and what properties once caught.
//! - `laws`: the laws of traced execution, one line an algorithm.
//! - `turns`: the least move that a verdict names, asked of the clippers.
//! - `logs`: event logs of worked examples, as text.

mod cases;
mod dyadic;
mod floats;
mod laws;
mod logs;
mod oracle;
mod turns;

use clipscope::{
    algo::line::{
        BitOrder, BruteForce, CohenSutherland, CohenSutherlandInput, CyrusBeck, CyrusBeckInput,
        LiangBarsky, NichollLeeNicholl, Visible, WindowInput,
        batch::{ClippedSegments, Segments, clip_all},
        kernel,
    },
    geom::{Segment, Window},
    trace::silent,
};

/// A way to clip against a window, by name.
type Clipper = (&'static str, fn(&Window, &Segment) -> Visible);

/// Those that decide on the ends' distances: for any numbers, they give the same bits.
const BY_DISTANCES: [Clipper; 5] = [
    ("Liang–Barsky", |&window, &segment| {
        silent::<LiangBarsky>(&WindowInput { window, segment })
    }),
    ("Cyrus–Beck", |&window, &segment| {
        let clip = window.into();
        silent::<CyrusBeck>(&CyrusBeckInput { clip, segment })
    }),
    ("Nicholl–Lee–Nicholl", |&window, &segment| {
        silent::<NichollLeeNicholl>(&WindowInput { window, segment })
    }),
    ("the kernel", kernel::clip),
    ("the batch", clip_in_batch),
];

/// Those that cut one side after the other.
const BY_CUTS: [Clipper; 3] = [
    ("brute force", |&window, &segment| {
        silent::<BruteForce>(&WindowInput { window, segment })
    }),
    ("Cohen–Sutherland, top first", |&window, &segment| {
        silent::<CohenSutherland>(&CohenSutherlandInput {
            window,
            segment,
            bit_order: BitOrder::Tbrl,
        })
    }),
    ("Cohen–Sutherland, left first", |&window, &segment| {
        silent::<CohenSutherland>(&CohenSutherlandInput {
            window,
            segment,
            bit_order: BitOrder::Lrbt,
        })
    }),
];

fn all_clippers() -> impl Iterator<Item = Clipper> {
    BY_DISTANCES.into_iter().chain(BY_CUTS)
}

/// In a batch of 131 copies, so that full turns and the rest behind them both come up.
fn clip_in_batch(window: &Window, segment: &Segment) -> Visible {
    const N: usize = 131;
    let segments: Segments = std::iter::repeat_n(*segment, N).collect();
    let mut clipped = ClippedSegments::default();
    clip_all(window, &segments, &mut clipped);
    let first = clipped.get(0);
    for (idx, visible) in clipped.iter().enumerate() {
        assert_eq!(
            bits(visible),
            bits(first),
            "lane {idx} of a batch of {segment:?}"
        );
    }
    first
}

/// Equal where every bit is, the sign of a zero included.
fn bits(visible: Visible) -> Option<[u64; 4]> {
    visible.map(|segment| segment.to_array().map(f64::to_bits))
}
