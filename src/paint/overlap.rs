//! Dashes over dashes are no pattern: a dashed line is left out where another line lies over it.

use egui::{Pos2, Vec2};

use super::{layers::LayeredPart, parts::Part};

/// Lines nearer than this, in points, lie on each other.
const NEAR: f32 = 0.75;
/// More edges are not compared.
const MOST_EDGES: usize = 120;

/// Takes from each dashed line what lies under a later one. `is_dashed` tells it of each piece that is a line of the drawing.
pub fn leave_out_covered(
    pieces: &mut Vec<LayeredPart<'_>>,
    is_dashed: impl Fn(&LayeredPart<'_>) -> Option<bool>,
) {
    let lines = pieces.iter().map(|piece| match &piece.part {
        Part::Stroke(points) if is_dashed(piece).is_some() => edges(points, false),
        Part::Ring(points) if is_dashed(piece).is_some() => edges(points, true),
        _ => Vec::new(),
    });
    let lines: Vec<Vec<[Pos2; 2]>> = lines.collect();
    if lines.iter().map(Vec::len).sum::<usize>() > MOST_EDGES {
        return;
    }
    for i in (0..lines.len()).rev() {
        if lines[i].is_empty() || is_dashed(&pieces[i]) != Some(true) {
            continue;
        }
        let over = lines[i + 1..].concat();
        let left = lines[i].iter().map(|edge| uncovered(*edge, &over));
        let left: Vec<Vec<[Pos2; 2]>> = left.collect();
        if left
            .iter()
            .zip(&lines[i])
            .all(|(left, edge)| left[..] == [*edge])
        {
            continue;
        }
        let of = pieces.remove(i);
        let strokes = joined(left.into_iter().flatten()).into_iter();
        let strokes = strokes.map(|points| LayeredPart {
            part: Part::Stroke(points),
            ..of.clone()
        });
        pieces.splice(i..i, strokes);
    }
}

fn edges(points: &[Pos2], is_closed: bool) -> Vec<[Pos2; 2]> {
    let back = points.first().filter(|_| is_closed && points.len() > 2);
    let next = points.iter().skip(1).chain(back);
    points.iter().zip(next).map(|(a, b)| [*a, *b]).collect()
}

/// What is left of an edge where others do not lie on it.
fn uncovered([a, b]: [Pos2; 2], over: &[[Pos2; 2]]) -> Vec<[Pos2; 2]> {
    let length = (b - a).length();
    if length < NEAR {
        return vec![[a, b]];
    }
    let along = (b - a) / length;
    let mut left = vec![[0.0, length]];
    for [from, to] in over.iter().filter_map(|ends| interval(a, along, *ends)) {
        let parts = left
            .iter()
            .flat_map(|&[begin, end]| [[begin, end.min(from)], [begin.max(to), end]]);
        left = parts.filter(|[begin, end]| end - begin > NEAR).collect();
    }
    let at = |t: f32| if t == length { b } else { a + along * t };
    left.into_iter().map(|ends| ends.map(at)).collect()
}

/// Where on the line another edge lies on it; none where it does not.
fn interval(a: Pos2, along: Vec2, ends: [Pos2; 2]) -> Option<[f32; 2]> {
    let across = along.rot90();
    let is_on = ends.iter().all(|end| (*end - a).dot(across).abs() < NEAR);
    let [from, to] = ends.map(|end| (end - a).dot(along));
    (is_on && (to - from).abs() > NEAR).then(|| [from.min(to), from.max(to)])
}

/// Edges that begin where the one before ends are one line.
fn joined(edges: impl Iterator<Item = [Pos2; 2]>) -> Vec<Vec<Pos2>> {
    let mut lines: Vec<Vec<Pos2>> = Vec::new();
    for [from, to] in edges {
        match lines.last_mut() {
            Some(line) if line.last() == Some(&from) => line.push(to),
            _ => lines.push(vec![from, to]),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    fn left(edge: [f32; 2], over: &[[f32; 2]]) -> Vec<[f32; 2]> {
        let on_line = |[from, to]: [f32; 2]| [pos2(from, 5.0), pos2(to, 5.0)];
        let over: Vec<_> = over.iter().map(|ends| on_line(*ends)).collect();
        let left = uncovered(on_line(edge), &over).into_iter();
        left.map(|[from, to]| [from.x, to.x]).collect()
    }

    #[test]
    fn what_another_line_covers_is_left_out() {
        assert_eq!(left([0.0, 10.0], &[]), [[0.0, 10.0]]);
        assert_eq!(left([0.0, 10.0], &[[6.0, 4.0]]), [[0.0, 4.0], [6.0, 10.0]]);
        assert_eq!(left([10.0, 0.0], &[[-5.0, 4.0]]), [[10.0, 4.0]]);
        assert_eq!(
            left([0.0, 10.0], &[[-1.0, 5.0], [5.0, 20.0]]),
            [[0.0; 2]; 0]
        );
        assert_eq!(left([0.0, 10.0], &[[12.0, 20.0]]), [[0.0, 10.0]]);
    }

    #[test]
    fn lines_that_only_cross_cover_nothing() {
        let edge = [pos2(0.0, 0.0), pos2(10.0, 0.0)];
        let crossing = [pos2(5.0, -5.0), pos2(5.0, 5.0)];
        let beside = [pos2(0.0, 2.0), pos2(10.0, 2.0)];
        assert_eq!(uncovered(edge, &[crossing, beside]), [edge]);
    }
}
