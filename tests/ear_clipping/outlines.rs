//! Simple outlines, counter-clockwise.

use proptest::prelude::*;

use super::{Outline, double_area};

fn turn([ax, ay]: [i64; 2], [bx, by]: [i64; 2], [cx, cy]: [i64; 2]) -> i64 {
    ((bx - ax) * (cy - by) - (by - ay) * (cx - bx)).signum()
}

/// Does the closed segment contain the point?
fn contains([a, b]: [[i64; 2]; 2], p: [i64; 2]) -> bool {
    let between = |axis: usize| (a[axis].min(b[axis])..=a[axis].max(b[axis])).contains(&p[axis]);
    turn(a, b, p) == 0 && between(0) && between(1)
}

/// Do two closed segments have a point in common?
fn meet(s: [[i64; 2]; 2], t: [[i64; 2]; 2]) -> bool {
    let sides = |[a, b]: [[i64; 2]; 2], [p, q]: [[i64; 2]; 2]| turn(a, b, p) * turn(a, b, q);
    let touches = t.iter().any(|&p| contains(s, p)) || s.iter().any(|&p| contains(t, p));
    touches || sides(s, t) < 0 && sides(t, s) < 0
}

/// The first two edges that have more in common than an end where they follow each other.
fn crossing(outline: &[[i64; 2]]) -> Option<[usize; 2]> {
    let n = outline.len();
    let edge = |i: usize| [outline[i % n], outline[(i + 1) % n]];
    (0..n).find_map(|i| {
        let j = (i + 1..n).find(|&j| {
            let (s, t) = (edge(i), edge(j));
            if j == i + 1 {
                contains(s, t[1]) || contains(t, s[0])
            } else if i == 0 && j == n - 1 {
                contains(t, s[1]) || contains(s, t[0])
            } else {
                meet(s, t)
            }
        })?;
        Some([i, j])
    })
}

pub fn is_simple(outline: &[[i64; 2]]) -> bool {
    outline.len() >= 3 && crossing(outline).is_none()
}

/// Turns an outline around where it runs clockwise.
fn counter_clockwise(mut outline: Outline) -> Outline {
    if double_area(&outline) < 0 {
        outline.reverse();
    }
    outline
}

/// Points in any order, untangled: two edges that cross change partners, until none do.
fn untangled(mut points: Outline) -> Option<Outline> {
    for _ in 0..400 {
        match crossing(&points) {
            None => return Some(counter_clockwise(points)),
            Some([i, j]) => points[i + 1..=j].reverse(),
        }
    }
    None
}

/// Up to `n` points on a grid of `size` × `size`: straight runs are common.
pub fn tangled(n: usize, size: i64) -> impl Strategy<Value = Outline> {
    let point = [0..size, 0..size];
    // In an order of its own: a case that fails is found again, and made smaller.
    prop::collection::btree_set(point, 3..=n)
        .prop_map(|points| points.into_iter().collect::<Outline>())
        .prop_shuffle()
        .prop_filter_map("cannot be untangled", untangled)
}

/// The border of unit squares that hang together, with a vertex at every step along it: most are straight.
pub fn squares() -> impl Strategy<Value = Outline> {
    prop::collection::vec(any::<prop::sample::Index>(), 1..30)
        .prop_filter_map("it has holes, or touches itself", |choices| {
            border(&grown(&choices))
        })
}

/// A shape of unit squares, each new one beside an old one.
fn grown(choices: &[prop::sample::Index]) -> Vec<[i64; 2]> {
    let mut cells = vec![[0, 0]];
    for choice in choices {
        let free: Vec<[i64; 2]> = cells
            .iter()
            .flat_map(|&[x, y]| [[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]])
            .filter(|cell| !cells.contains(cell))
            .collect();
        cells.push(free[choice.index(free.len())]);
    }
    cells
}

fn border(cells: &[[i64; 2]]) -> Option<Outline> {
    // Every side of a square that no other one has, with the square on its left.
    let sides: Vec<[[i64; 2]; 2]> = cells
        .iter()
        .flat_map(|&[x, y]| {
            let corners = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
            let beyond = [[x, y - 1], [x + 1, y], [x, y + 1], [x - 1, y]];
            (0..4)
                .filter(|&i| !cells.contains(&beyond[i]))
                .map(|i| [corners[i], corners[(i + 1) % 4]])
                .collect::<Vec<_>>()
        })
        .collect();
    let mut outline = vec![sides[0][0]];
    loop {
        let here = outline[outline.len() - 1];
        let [_, next] = sides.iter().find(|[from, _]| *from == here)?;
        if *next == outline[0] {
            break;
        }
        outline.push(*next);
        if outline.len() > sides.len() {
            return None;
        }
    }
    (outline.len() == sides.len() && is_simple(&outline)).then_some(outline)
}

/// Teeth of one unit, each with a gap of one, standing on a bar.
pub fn comb(n_teeth: i64) -> Outline {
    let mut outline = vec![[0, 0], [4 * n_teeth - 2, 0]];
    for tooth in (0..n_teeth).rev() {
        outline.extend([[4 * tooth + 2, 9], [4 * tooth, 9]]);
        if tooth > 0 {
            outline.extend([[4 * tooth, 1], [4 * tooth - 2, 1]]);
        }
    }
    outline
}

/// A corridor of unit width that winds inwards: along one wall and back along the other.
pub fn spiral(n_turns: i64) -> Outline {
    let mut outer = vec![[0, 0]];
    let mut inner = vec![[0, 1]];
    for turn in 0..n_turns {
        let (low, high) = (2 * turn, 4 * n_turns + 2 - 2 * turn);
        outer.extend([[high, low], [high, high], [low, high], [low, low + 2]]);
        let (low, high) = (low + 1, high - 1);
        inner.extend([[high, low], [high, high], [low, high], [low, low + 2]]);
    }
    inner.reverse();
    outer.extend(inner);
    outer
}

/// A star with `n` tips, its inner corners alternating with them.
pub fn star(n_tips: usize) -> Outline {
    (0..2 * n_tips)
        .map(|i| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / (2 * n_tips) as f64);
            let radius = if i % 2 == 0 { 1e6 } else { 3e5 };
            [radius * cos, radius * sin].map(|x| x.round() as i64)
        })
        .collect()
}
