//! How far a point, a segment or a triangle is from another answer: the least move as a whole along a plane's normal that brings
//! something of it inside all planes, or takes all of it out. A move is positive inwards; what touches vanishes by any move out.
//!
//! A point V0 + u (V1 − V0) + v (V2 − V0) of the part, moved by s, is inside a plane where one inequality in s, u and v holds, beside
//! u ≥ 0, v ≥ 0, u + v ≤ 1. Eliminate v, then u (J. Fourier, 1826; T. Motzkin, 1936): what is left is an interval of moves, and its
//! end nearer to 0 is the answer. *Cost*: for n planes at most (n + 3)² / 4 inequalities without v, and a quarter of the square of
//! that in the end: for the six of a view volume some dozens.
//!
//! ```
//! use clipscope::{algo::volume::{PartTurn, part_move_in, part_move_out}, geom::Plane};
//! // −1 ≤ x, x ≤ 1
//! let planes = [Plane::new([1.0, 0.0, 0.0, 1.0])?, Plane::new([-2.0, 0.0, 0.0, 2.0])?];
//! let segment = [[-4.0, 0.0, 0.0], [-1.5, 3.0, 0.0]];
//! assert_eq!(part_move_in(&planes, &segment, 0), Some(0.5));
//! let triangle = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 1.0]];
//! assert_eq!(part_move_out(&planes, &triangle), Some(PartTurn { plane_idx: 1, by: -1.0 }));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use crate::{
    algo::parameter::{least_move, moves_allowed, nearest_move},
    geom::Plane,
};

use super::signed_distance;

/// A move along a plane's normal that turns an answer.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PartTurn {
    /// Which plane.
    pub plane_idx: usize,
    /// How far: inwards where positive.
    pub by: f64,
}

/// `room + slope · s + … · u + … · v ≥ 0`
type Row = [f64; 4];

/// How far what lies between one, two or three corners has to be moved along a plane's normal so that something of it is inside.
#[must_use]
pub fn part_move_in(planes: &[Plane], corners: &[[f64; 3]], plane_idx: usize) -> Option<f64> {
    let along = planes.get(plane_idx)?.unit_normal();
    nearest_move(moves_that_meet(planes, corners, along)?)
}

/// The least move outwards across a plane, beyond which nothing is left of it.
#[must_use]
pub fn part_move_out(planes: &[Plane], corners: &[[f64; 3]]) -> Option<PartTurn> {
    let moves = |plane: &Plane| moves_that_meet(planes, corners, plane.unit_normal());
    let borders = planes.iter().enumerate();
    let (plane_idx, by) = least_move(borders.map(|(idx, plane)| (idx, moves(plane))))?;
    Some(PartTurn { plane_idx, by })
}

/// The moves along a direction after which something of it is inside all planes.
fn moves_that_meet(planes: &[Plane], corners: &[[f64; 3]], along: [f64; 3]) -> Option<[f64; 2]> {
    let first = *corners.first()?;
    let of_plane = |plane: &Plane| -> Row {
        let distance = |at| signed_distance::<f64>(plane, at);
        let room = distance(first);
        let both = plane.unit_normal().into_iter().zip(along);
        let slope = both.map(|(a, b)| a * b).sum();
        let way = |i: usize| corners.get(i).map_or(0.0, |&at| distance(at) - room);
        [room, slope, way(1), way(2)]
    };
    let mut rows: Vec<Row> = planes.iter().map(of_plane).collect();
    rows.extend([
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [1.0, 0.0, -1.0, -1.0],
    ]);
    let rows = without(3, &without(2, &rows));
    moves_allowed(rows.into_iter().map(|[room, slope, ..]| [room, slope]))
}

/// What the rows say of all but one of their variables.
fn without(idx: usize, rows: &[Row]) -> Vec<Row> {
    let is_free = |row: &&Row| row[idx] == 0.0;
    let mut kept: Vec<Row> = rows.iter().filter(is_free).copied().collect();
    for up in rows.iter().filter(|row| row[idx] > 0.0) {
        for down in rows.iter().filter(|row| row[idx] < 0.0) {
            kept.push(std::array::from_fn(|i| {
                sum(up[i] * -down[idx], down[i] * up[idx])
            }));
        }
    }
    kept
}

/// Nothing where the two cancel but for the rounding of products and distances: a slope of 10⁻¹⁷ would bound the move.
fn sum(a: f64, b: f64) -> f64 {
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let sum = a + b;
    if sum.abs() <= ROUNDING * (a.abs() + b.abs()) {
        0.0
    } else {
        sum
    }
}
