//! Many segments at once, out of focus: quiet lines, with what is visible of each set off.

use egui::{Color32, Mesh, Pos2, Shape, Stroke};

use crate::geom::Segment;

use super::{Theme, Viewport};

/// Up to here each line is drawn with smooth edges; beyond, all of them are one mesh.
const MAX_SMOOTH: usize = 2_000;
/// More are not drawn: at one line to each pixel of the stage's width, nobody could tell.
const MAX_DRAWN: usize = 250_000;

/// Draws segments and the visible part of each.
#[must_use]
pub fn crowd(
    viewport: &Viewport,
    theme: &Theme,
    segments: impl ExactSizeIterator<Item = (Segment, Option<Segment>)>,
) -> Vec<Shape> {
    let is_smooth = segments.len() <= MAX_SMOOTH;
    let quiet = theme.stroke(1.0, theme.discarded.gamma_multiply(0.45));
    let visible = theme.stroke(1.5, theme.accent.gamma_multiply(0.55));
    let mut under = Lines::new(is_smooth);
    let mut over = Lines::new(is_smooth);
    for (segment, part) in segments.take(MAX_DRAWN) {
        let ends =
            |segment: Segment| [segment.p1, segment.p2].map(|p| viewport.to_screen(p.to_array()));
        let [a, b] = ends(segment);
        if !egui::Rect::from_two_pos(a, b)
            .expand(1.0)
            .intersects(viewport.rect)
        {
            continue;
        }
        under.add([a, b], quiet);
        if let Some(part) = part {
            over.add(ends(part), visible);
        }
    }
    under
        .shapes
        .into_iter()
        .chain(under.mesh.map(Shape::mesh))
        .chain(over.shapes)
        .chain(over.mesh.map(Shape::mesh))
        .collect()
}

struct Lines {
    shapes: Vec<Shape>,
    mesh: Option<Mesh>,
}

impl Lines {
    fn new(is_smooth: bool) -> Self {
        Self {
            shapes: Vec::new(),
            mesh: (!is_smooth).then(Mesh::default),
        }
    }

    fn add(&mut self, [a, b]: [Pos2; 2], stroke: Stroke) {
        match &mut self.mesh {
            None => self.shapes.push(Shape::line_segment([a, b], stroke)),
            Some(mesh) => quad(mesh, [a, b], stroke.width, stroke.color),
        }
    }
}

fn quad(mesh: &mut Mesh, [a, b]: [Pos2; 2], width: f32, colour: Color32) {
    let across = (b - a).normalized().rot90() * (0.5 * width);
    let first = mesh.vertices.len() as u32;
    for corner in [a + across, b + across, b - across, a - across] {
        mesh.colored_vertex(corner, colour);
    }
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}
