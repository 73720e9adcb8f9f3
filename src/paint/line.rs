//! Lines from point to point: solid with round joins, or dashed; and crowds of segments.

use egui::{Mesh, Painter, Pos2, Shape, Stroke, Vec2};

use super::{Theme, Viewport, cut::cut_to, pen::Pen};

/// Length of a dash and of the gap after it, as multiples of the pattern's scale, in points.
const DASH: [f32; 2] = [6.0, 4.0];
/// A line that would take more dashes is drawn solid: no dash could be told from the next.
const MOST_DASHES: f32 = 4_000.0;
/// Of more points than this, joins are too many to be seen one by one.
const MOST_JOINS: usize = 1_000;
const SHARP: f32 = 0.7;
const BEYOND: f32 = 16.0;

/// Beyond this number lines have no soft edges: these take most of the time.
const MAX_SMOOTH: usize = 2_000;
/// Of more than this, every second, third, … is drawn: they cover the same pixels, and a frame stays short.
const MAX_DRAWN: usize = 20_000;

pub struct Line {
    points: Vec<Pos2>,
    is_closed: bool,
}

impl Line {
    pub fn new(points: &[Pos2], is_closed: bool) -> Self {
        let mut points = points.to_vec();
        points.dedup_by(|a, b| a.distance_sq(*b) < 1e-4);
        let is_closed = is_closed && points.len() > 2;
        if is_closed && points[0].distance_sq(points[points.len() - 1]) < 1e-4 {
            points.pop();
        }
        Self { points, is_closed }
    }

    pub fn draw(&self, painter: &Painter, stroke: Stroke) {
        if let [a, b] = self.points[..] {
            let seen = cut_to([a, b], painter.clip_rect().expand(BEYOND));
            painter.extend(seen.map(|ends| Shape::line_segment(ends, stroke)));
            return;
        }
        let turns = match self.points.len() {
            ..=MOST_JOINS => self.sharp_turns(),
            _ => vec![],
        };
        if !turns.is_empty() {
            for run in self.between(&turns) {
                painter.add(Shape::line(run, stroke));
            }
            // egui's own joins are mitred: a needle at an acute vertex.
            for turn in turns {
                painter.circle_filled(self.points[turn], 0.5 * stroke.width, stroke.color);
            }
        } else if self.is_closed {
            painter.add(Shape::closed_line(self.points.clone(), stroke));
        } else if self.points.len() > 1 {
            painter.add(Shape::line(self.points.clone(), stroke));
        }
    }

    pub fn dash(&self, painter: &Painter, stroke: Stroke, scale: f32) {
        let [dash, gap] = DASH.map(|length| length * scale);
        let whole = self.around(0);
        let length: f32 = whole.windows(2).map(|e| e[0].distance(e[1])).sum();
        if length <= MOST_DASHES * (dash + gap) && self.points.len() != 2 {
            painter.extend(Shape::dashed_line(&whole, stroke, dash, gap));
        } else if self.points.len() <= MOST_JOINS {
            let stage = painter.clip_rect().expand(BEYOND);
            for ends in whole.windows(2) {
                if let Some(ends) = cut_to([ends[0], ends[1]], stage) {
                    painter.extend(Shape::dashed_line(&ends, stroke, dash, gap));
                }
            }
        } else {
            self.draw(painter, stroke);
        }
    }

    fn around(&self, first: usize) -> Vec<Pos2> {
        let n = self.points.len();
        let n_ends = if self.is_closed { n + 1 } else { n };
        (0..n_ends).map(|i| self.points[(first + i) % n]).collect()
    }

    fn sharp_turns(&self) -> Vec<usize> {
        let n = self.points.len();
        let inner = if self.is_closed {
            0..n
        } else {
            1..n.max(2) - 1
        };
        let is_sharp = |&i: &usize| {
            let [before, at, after] = [i + n - 1, i, i + 1].map(|i| self.points[i % n]);
            (at - before).normalized().dot((after - at).normalized()) < SHARP
        };
        inner.filter(is_sharp).collect()
    }

    /// The runs from each of these places to the next; an open line's from its first point and to its last.
    fn between(&self, turns: &[usize]) -> Vec<Vec<Pos2>> {
        let first = if self.is_closed { turns[0] } else { 0 };
        let whole = self.around(first);
        let mut cuts: Vec<usize> = turns.iter().map(|turn| turn - first).collect();
        cuts.insert(0, 0);
        cuts.push(whole.len() - 1);
        let runs = cuts.windows(2).filter(|ends| ends[0] < ends[1]);
        runs.map(|ends| whole[ends[0]..=ends[1]].to_vec()).collect()
    }
}

pub fn crowd(
    painter: &Painter,
    theme: &Theme,
    viewport: &Viewport,
    segments: &[[[f64; 2]; 2]],
    pen: &Pen,
) {
    let each = segments.len().div_ceil(MAX_DRAWN).max(1);
    let lines = segments.iter().step_by(each).filter_map(|ends| {
        let ends = ends.map(|p| viewport.to_screen(p));
        cut_to(ends, viewport.rect.expand(4.0))
    });
    if pen.is_dashed {
        lines.for_each(|ends| {
            Line::new(&ends, false).dash(painter, pen.stroke, theme.stroke_scale);
        });
    } else if segments.len() <= MAX_SMOOTH {
        painter.extend(lines.map(|ends| Shape::line_segment(ends, pen.stroke)));
    } else {
        painter.add(quads(lines, segments.len().div_ceil(each), pen.stroke));
    }
}

fn quads(lines: impl Iterator<Item = [Pos2; 2]>, most: usize, stroke: Stroke) -> Mesh {
    let mut mesh = Mesh::default();
    // Growing would copy megabytes, again and again.
    mesh.reserve_vertices(4 * most);
    mesh.reserve_triangles(2 * most);
    for [a, b] in lines {
        let along = (b - a).normalized();
        let along = if along == Vec2::ZERO { Vec2::X } else { along };
        let across = along.rot90() * (0.5 * stroke.width);
        let first = mesh.vertices.len() as u32;
        for corner in [a - across, a + across, b + across, b - across] {
            mesh.colored_vertex(corner, stroke.color);
        }
        mesh.add_triangle(first, first + 1, first + 2);
        mesh.add_triangle(first, first + 2, first + 3);
    }
    mesh
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    #[test]
    fn a_line_is_parted_where_it_turns_sharply_and_nowhere_else() {
        let [a, b, c, d] =
            [(0.0, 0.0), (10.0, 1.0), (20.0, 0.0), (0.0, 0.0)].map(|(x, y)| pos2(x, y));
        let open = Line::new(&[a, b, c, d], false);
        assert_eq!(open.sharp_turns(), [2]);
        assert_eq!(open.between(&[2]), [vec![a, b, c], vec![c, d]]);
        // Closed, its last point is its first.
        let closed = Line::new(&[a, b, c, d], true);
        assert_eq!(closed.sharp_turns(), [0, 2]);
        assert_eq!(closed.between(&[0, 2]), [vec![a, b, c], vec![c, a]]);
    }

    #[test]
    fn nothing_is_drawn_of_nothing() {
        for points in [vec![], vec![Pos2::ZERO], vec![Pos2::ZERO; 3]] {
            for is_closed in [false, true] {
                let line = Line::new(&points, is_closed);
                assert!(line.sharp_turns().is_empty());
                assert!(line.around(0).len() < 2);
            }
        }
    }
}
