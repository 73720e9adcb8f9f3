//! Parallel strokes across an area: what two answers do not agree about.

use egui::{Pos2, Rect, pos2};

pub const GAP: f32 = 7.0;
/// What is shorter is where outlines run along each other.
const LEAST_PTS: f32 = 0.1;

/// The diagonals, this far apart, inside everything that an odd number of `outlines` goes round, as far as the stage shows it.
pub fn hatched(outlines: &[Vec<Pos2>], stage: Rect, gap: f32) -> Vec<[Pos2; 2]> {
    let points = outlines.iter().flatten().copied();
    let bounds = Rect::from_points(&points.collect::<Vec<_>>()).intersect(stage);
    if !bounds.is_positive() {
        return Vec::new();
    }
    let [first, last] = [bounds.min, bounds.max].map(|at| ((at.x + at.y) / gap) as i32);
    let diagonals = (first..=last).map(|i| i as f32 * gap);
    diagonals.flat_map(|sum| chords(outlines, sum)).collect()
}

/// Of the diagonal whose points have this sum of coordinates.
fn chords(outlines: &[Vec<Pos2>], sum: f32) -> Vec<[Pos2; 2]> {
    let side = |at: Pos2| at.x + at.y - sum;
    let edges = outlines.iter().flat_map(|outline| {
        let next = outline.iter().cycle().skip(1);
        outline.iter().copied().zip(next.copied())
    });
    let crossed = edges.filter(|&(a, b)| (side(a) < 0.0) != (side(b) < 0.0));
    let x = |(a, b): (Pos2, Pos2)| a.lerp(b, side(a) / (side(a) - side(b))).x;
    let mut crossings: Vec<f32> = crossed.map(x).collect();
    crossings.sort_by(f32::total_cmp);
    let (pairs, _) = crossings.as_chunks::<2>();
    let pairs = pairs.iter().filter(|[from, to]| to - from > LEAST_PTS);
    let chord = |pair: &[f32; 2]| pair.map(|x| pos2(x, sum - x));
    pairs.map(chord).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_lie_in_one_area_or_the_other_and_not_in_both() {
        let square = |left: f32| {
            let corners = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
            let corners = corners.map(|[x, y]| pos2(left + x, y));
            corners.to_vec()
        };
        let stage = Rect::EVERYTHING;
        assert!(hatched(&[square(0.0), square(0.0)], stage, 3.0).is_empty());
        let strokes = hatched(&[square(0.0), square(10.0)], stage, 3.0);
        assert!(!strokes.is_empty());
        for middle in strokes.iter().map(|[a, b]| a.lerp(*b, 0.5)) {
            assert!((0.0..=10.0).contains(&middle.x) || (20.0..=30.0).contains(&middle.x));
        }
    }
}
