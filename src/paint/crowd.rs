//! Many segments beside the one that is stepped.

use egui::{Color32, Mesh, Painter, Pos2, Shape, Stroke, Vec2};

use super::{Theme, Viewport, cut::cut_to, line::Line, pen::Pen};

/// Beyond this number lines are drawn as bare quadrilaterals, without the soft edges that take most of the
/// time.
const MAX_SMOOTH: usize = 2_000;

/// Of more than this, every second, third, … is drawn: on any screen they cover the same pixels, and a
/// frame stays short where there is no GPU.
const MAX_DRAWN: usize = 20_000;

/// Draws the segments with one pen.
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

/// At most `most` lines.
fn quads(lines: impl Iterator<Item = [Pos2; 2]>, most: usize, stroke: Stroke) -> Mesh {
    let mut mesh = Mesh::default();
    // Growing would copy megabytes, again and again.
    mesh.reserve_vertices(4 * most);
    mesh.reserve_triangles(2 * most);
    for [a, b] in lines {
        let along = (b - a).normalized();
        let along = if along == Vec2::ZERO { Vec2::X } else { along };
        let across = along.rot90() * (0.5 * stroke.width);
        quad(
            &mut mesh,
            [a - across, a + across, b + across, b - across],
            stroke.color,
        );
    }
    mesh
}

fn quad(mesh: &mut Mesh, corners: [Pos2; 4], colour: Color32) {
    let first = mesh.vertices.len() as u32;
    for corner in corners {
        mesh.colored_vertex(corner, colour);
    }
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}
