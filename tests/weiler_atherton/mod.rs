//! What `clipscope::algo::polygon::weiler_atherton` promises, held to it.
//!
//! - `cases`: every degeneracy by name, with the answer written out.
//! - `properties`: random polygons on small grids, against an exact rational oracle and i_overlay.
//! - `floats`: what is promised for any finite numbers.
//! - `logs`: event logs of worked examples, as text.
#![allow(
    clippy::unreadable_literal,
    reason = "failing cases stand as they were found, digit for digit"
)]

mod cases;
mod floats;
mod logs;
mod oracle;
mod properties;
mod shapes;

use clipscope::{
    algo::polygon::weiler_atherton::{WeilerAtherton, WeilerAthertonInput, WeilerAthertonOutput},
    geom::{Point, Region, SimplePolygon},
    trace::silent,
};

fn clip(subject: &Region, clip: &SimplePolygon) -> WeilerAthertonOutput {
    let (subject, clip) = (subject.clone(), clip.clone());
    silent::<WeilerAtherton>(&WeilerAthertonInput { subject, clip })
}

/// Every ring, from its lowest vertex on the left, in order: the same for the same set of polygons.
fn rings(clipped: &WeilerAthertonOutput) -> Vec<Vec<[f64; 2]>> {
    let all = clipped
        .pieces
        .iter()
        .flat_map(|piece| std::iter::once(&piece.outer).chain(&piece.holes));
    let mut rings: Vec<Vec<[f64; 2]>> = all.map(|ring| from_lowest(ring)).collect();
    rings.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
    rings
}

fn from_lowest(ring: &[Point]) -> Vec<[f64; 2]> {
    let mut ring: Vec<[f64; 2]> = ring.iter().map(|p| p.to_array()).collect();
    let lowest = (0..ring.len()).min_by(|&i, &j| ring[i].partial_cmp(&ring[j]).expect("finite"));
    ring.rotate_left(lowest.unwrap_or(0));
    ring
}

/// Positive where a ring runs counter-clockwise.
fn area_of(ring: &[Point]) -> f64 {
    let [ox, oy] = ring[0].to_array();
    let pairs = (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()]));
    let doubled: f64 = pairs
        .map(|(p, q)| (p.x() - ox) * (q.y() - oy) - (p.y() - oy) * (q.x() - ox))
        .sum();
    doubled / 2.0
}

/// Of all pieces.
fn total_area(clipped: &WeilerAthertonOutput) -> f64 {
    let piece = |piece: &clipscope::algo::polygon::weiler_atherton::OutputPolygon| {
        area_of(&piece.outer) + piece.holes.iter().map(|hole| area_of(hole)).sum::<f64>()
    };
    clipped.pieces.iter().map(piece).sum()
}
