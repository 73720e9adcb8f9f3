//! The places that a label may take, each with how little it is liked.

use egui::{Pos2, Rect, Vec2};

use crate::geom::pairs_around;

use super::anchor::Anchor;

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LabelPlace {
    pub centre: Pos2,
    /// In points of distance that it would rather go.
    pub dislike: f32,
    /// On the wrong side of a line, where a label says what is not true.
    pub is_wrong: bool,
    pub leader: Option<Pos2>,
}

impl LabelPlace {
    const fn new(centre: Pos2, dislike: f32) -> Self {
        Self {
            centre,
            dislike,
            is_wrong: false,
            leader: None,
        }
    }
}

/// Directions around a point: to the right, as one reads, is best, then the corners, then what is in between.
const DIRECTIONS: [(f32, f32); 16] = [
    (0.0, 0.0),
    (-45.0, 1.0),
    (45.0, 1.5),
    (180.0, 2.0),
    (-90.0, 2.5),
    (90.0, 3.0),
    (-135.0, 3.5),
    (135.0, 4.0),
    (-22.5, 4.5),
    (22.5, 4.5),
    (-67.5, 5.0),
    (67.5, 5.0),
    (-157.5, 5.0),
    (157.5, 5.0),
    (-112.5, 5.5),
    (112.5, 5.5),
];
/// White space between a marker and its label, in points; from the last two a leader comes.
const GAPS: [f32; 7] = [6.0, 9.0, 13.0, 18.0, 25.0, 36.0, 50.0];
const LED: f32 = 30.0;
/// Places along an edge, the nicest first: near its ends it is the least crossed.
const ALONG: [f32; 15] = [
    0.12, 0.88, 0.25, 0.75, 0.5, 0.06, 0.94, 0.37, 0.63, 0.19, 0.81, 0.31, 0.69, 0.44, 0.56,
];
/// White space between an edge and its label; what holds on all of a side may stand further off.
const ASIDE: [f32; 6] = [5.0, 9.0, 15.0, 24.0, 36.0, 50.0];
const ASIDE_OF_AN_EDGE: usize = 3;
/// Where on an edge a chip lies: near an end first, then farther in.
const ON: [f32; 9] = [0.08, 0.16, 0.24, 0.32, 0.42, 0.52, 0.64, 0.78, 0.9];
const ACROSS: [f32; 9] = [0.5, 0.38, 0.62, 0.26, 0.74, 0.14, 0.86, 0.02, 0.98];
const TURNED: f32 = 5.0;
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Lean {
    pub toward: Option<Vec2>,
    pub away: Option<Vec2>,
    pub is_of_side: bool,
    /// It lies on an edge, not beside it.
    pub is_on: bool,
}

pub fn places(anchor: &Anchor, size: Vec2, stage: Rect, lean: Lean) -> Vec<LabelPlace> {
    let half = 0.5 * size;
    match anchor {
        Anchor::Point(at, radius) => around(*at, *radius, half, lean),
        Anchor::Along(edges) => edges
            .iter()
            .enumerate()
            .flat_map(|(i, &ends)| beside(ends, half, stage, lean, 4.0 * i as f32))
            .collect(),
        Anchor::Inside(rect) => {
            let seen = stage.shrink2((half + Vec2::splat(4.0)).min(stage.size() * 0.5));
            let mut places = inside(*rect, half);
            for place in &mut places {
                place.centre = seen.clamp(place.centre);
            }
            places.extend(near(seen.clamp(rect.center()), half));
            places
        }
        Anchor::Within(outlines) => {
            let points = outlines.iter().flatten().copied().collect::<Vec<_>>();
            let bounds = Rect::from_points(&points).intersect(stage);
            let mut places = inside(bounds, half);
            places.retain(|place| {
                let place = Rect::from_center_size(place.centre, size);
                let mut places = corners(place).into_iter().chain([place.center()]);
                places.all(|at| goes_round(outlines, at))
            });
            if places.is_empty() {
                places = near(bounds.center(), half);
            }
            places
        }
    }
}

fn around(at: Pos2, radius: f32, half: Vec2, lean: Lean) -> Vec<LabelPlace> {
    let directions = DIRECTIONS.map(|(degrees, dislike)| {
        let direction = Vec2::angled(degrees.to_radians());
        // The box touches the circle with its edge where the direction is along an axis, else with its corner.
        let corner = (direction * 1.42).clamp(Vec2::splat(-1.0), Vec2::splat(1.0));
        let is_wrong = (lean.toward).is_some_and(|to| to.normalized().dot(direction) < 0.3);
        let turned = lean.away.map_or(0.0, |away| 1.0 - away.dot(direction));
        let centre = at + half * corner;
        (centre, direction, dislike + TURNED * turned, is_wrong)
    });
    let mut places = Vec::with_capacity(GAPS.len() * DIRECTIONS.len());
    for gap in GAPS {
        for (centre, direction, dislike, is_wrong) in directions {
            places.push(LabelPlace {
                centre: centre + direction * (radius + gap),
                dislike: dislike + 1.5 * (gap - GAPS[0]),
                is_wrong,
                leader: (gap > LED).then(|| at + direction * radius),
            });
        }
    }
    places
}

/// Along an edge, from its lower or left end on.
fn on([a, b]: [Pos2; 2], half: Vec2, stage: Rect, dislike: f32) -> Vec<LabelPlace> {
    let low = |at: Pos2| at.y - at.x;
    let [from, to] = if low(b) > low(a) { [b, a] } else { [a, b] };
    let seen = stage.shrink2((half + Vec2::splat(4.0)).min(stage.size() * 0.5));
    let place = |(i, t): (usize, f32)| {
        let at = seen.clamp(from.lerp(to, t));
        LabelPlace::new(at, dislike + 4.0 * i as f32)
    };
    ON.into_iter().enumerate().map(place).collect()
}

fn beside([a, b]: [Pos2; 2], half: Vec2, stage: Rect, lean: Lean, dislike: f32) -> Vec<LabelPlace> {
    if lean.is_on {
        return on([a, b], half, stage, dislike);
    }
    let normal = (b - a).normalized().rot90();
    let support = normal.x.abs() * half.x + normal.y.abs() * half.y;
    let seen = stage.shrink2((half + Vec2::splat(4.0)).min(stage.size() * 0.5));
    let n_gaps = if lean.is_of_side {
        ASIDE.len()
    } else {
        ASIDE_OF_AN_EDGE
    };
    let mut places = Vec::new();
    for (i, t) in ALONG.into_iter().enumerate() {
        for (k, side) in [normal, -normal].into_iter().enumerate() {
            for gap in &ASIDE[..n_gaps] {
                let at = a + (b - a) * t + side * (support + gap);
                // Along the edge it moves into the stage, not across it.
                let moved = seen.clamp(at) - at;
                let along = (b - a).normalized();
                let centre = at + along * moved.dot(along);
                let dislike = dislike + 1.2 * i as f32 + k as f32 + 0.8 * (gap - ASIDE[0]);
                places.push(LabelPlace {
                    is_wrong: (lean.toward).is_some_and(|toward| toward.dot(side) < 0.0),
                    ..LabelPlace::new(centre, dislike)
                });
            }
        }
    }
    places
}

fn inside(rect: Rect, half: Vec2) -> Vec<LabelPlace> {
    let inner = rect.shrink2((half + Vec2::splat(5.0)).min(rect.size() * 0.5));
    let mut places = Vec::new();
    // Sideways first: labels of neighbouring regions keep one height.
    for (row, y) in ACROSS.into_iter().enumerate() {
        for (column, x) in ACROSS.into_iter().enumerate() {
            let at = [
                inner.left() + x * inner.width(),
                inner.top() + y * inner.height(),
            ];
            let dislike = 3.0 * row as f32 + column as f32;
            places.push(LabelPlace::new(at.into(), dislike));
        }
    }
    // Where the label hardly fits between two lines, a little to one side is better than on either.
    for i in 0..ACROSS.len() {
        let place = places[i * ACROSS.len()];
        for by in [-10.0, -5.0, 5.0, 10.0] {
            let centre = place.centre + by * Vec2::X;
            places.push(LabelPlace::new(centre, place.dislike + 2.0));
        }
    }
    places
}

fn near(middle: Pos2, half: Vec2) -> Vec<LabelPlace> {
    let mut places = around(middle, 0.0, half, Lean::default());
    places.push(LabelPlace::new(middle, 0.0));
    for place in &mut places {
        place.dislike += 36.0;
        place.leader = None;
    }
    places
}

/// Does an odd number of outlines go round a place?
fn goes_round(outlines: &[Vec<Pos2>], at: Pos2) -> bool {
    let crossed = outlines.iter().flat_map(|outline| {
        pairs_around(outline).filter(|[a, b]| {
            (a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)
        })
    });
    crossed.count() % 2 == 1
}

pub fn corners(rect: Rect) -> [Pos2; 4] {
    [
        rect.left_top(),
        rect.right_top(),
        rect.left_bottom(),
        rect.right_bottom(),
    ]
}
