//! The quiet grid of a stage: dots where its lines would cross, and the numbers of those lines at the edges.

use egui::{Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Shape, Vec2, pos2, vec2};

use crate::{
    paint::{Placed, Viewport},
    text::Notation,
};

use super::look::Look;

/// Side of a dot in points.
const DOT: f32 = 1.5;
/// Dots at most: a stage as large as a 4K screen holds fewer at any zoom.
const MAX_DOTS: f64 = 20_000.0;

/// White space between two numbers of the scale, at least, in points.
const BETWEEN: f64 = 56.0;
/// Of a number from the edge of the stage.
const FROM_EDGE: f32 = 4.0;
/// Numbers along an edge at most.
const MOST_NUMBERS: f64 = 200.0;

/// Writes the coordinates of the grid's lines along the lower and the left edge.
pub fn scale(
    painter: &Painter,
    viewport: &Viewport,
    step: f64,
    (look, labels): (Look<'_>, &[Placed]),
) {
    let rect = viewport.rect;
    let lines = (BETWEEN / (step * viewport.scale)).ceil().max(1.0);
    // Of grids of 1, 2 or 5 every fifth line has a round number, of others it has one, too.
    let every = step
        * [1.0, 2.0, 5.0, 10.0]
            .into_iter()
            .find(|&n| n >= lines)
            .unwrap_or(lines);
    let font = FontId::monospace(9.5 * look.theme.text_scale.sqrt());
    let [left, top] = viewport.to_world(rect.min);
    let [right, bottom] = viewport.to_world(rect.max);
    let room = f64::from(font.size) * 1.5 / viewport.scale;
    let numbers = |from: f64, to: f64| {
        let (first, last) = ((from / every).ceil(), (to / every).floor());
        let has_numbers = last - first < MOST_NUMBERS && first.abs().max(last.abs()) < 1e15;
        let n = if has_numbers {
            (last - first + 1.0).max(0.0)
        } else {
            0.0
        };
        (0..n as u32).map(move |i| (first + f64::from(i)) * every)
    };
    let number = |at: Pos2, align: Align2, x: f64| {
        let (colour, ground) = (look.theme.soft, look.theme.background);
        let text = painter.layout_no_wrap(
            // Beside each other fractions would mix with decimals.
            look.catalog.value_as(&x.into(), Notation::Decimals),
            font.clone(),
            colour,
        );
        let place = align.anchor_size(at, text.size());
        // A number gives way to what the figure says.
        let is_taken = |label: &Placed| label.rect.intersects(place.expand(4.0));
        if labels.iter().any(is_taken) {
            return;
        }
        painter.rect_filled(place.expand2(vec2(2.0, 0.0)), 0.0, ground);
        painter.galley(place.min, text, colour);
    };
    for x in numbers(left + 2.0 * room, right - room) {
        let at = pos2(viewport.to_screen([x, 0.0]).x, rect.bottom() - FROM_EDGE);
        number(at, Align2::CENTER_BOTTOM, x);
    }
    for y in numbers(bottom + 2.0 * room, top - room) {
        let at = pos2(rect.left() + FROM_EDGE, viewport.to_screen([0.0, y]).y);
        number(at, Align2::LEFT_CENTER, y);
    }
}

/// Draws a dot wherever both coordinates are multiples of `step`, at whole pixels.
pub fn draw(painter: &Painter, viewport: &Viewport, step: f64, colour: Color32) {
    let [left, top] = viewport.to_world(viewport.rect.min);
    let [right, bottom] = viewport.to_world(viewport.rect.max);
    let [x0, x1, y0, y1] = [left, right, bottom, top].map(|w| (w / step).round());
    let n_dots = (x1 - x0 + 1.0) * (y1 - y0 + 1.0);
    // Where the numbers are too large for a step to make a difference, there is no grid.
    let is_exact = [x0, x1, y0, y1].iter().all(|k| k.abs() < 1e15);
    if !(n_dots <= MAX_DOTS && is_exact) {
        return;
    }
    let pixels = painter.pixels_per_point();
    let at_pixel = |at: Pos2| {
        let whole = |v: f32| (v * pixels).round() / pixels;
        Pos2::new(whole(at.x), whole(at.y))
    };
    let mut mesh = Mesh::default();
    for i in 0..=(x1 - x0) as u32 {
        for j in 0..=(y1 - y0) as u32 {
            let world = [(x0 + f64::from(i)) * step, (y0 + f64::from(j)) * step];
            let centre = at_pixel(viewport.to_screen(world));
            mesh.add_colored_rect(Rect::from_center_size(centre, Vec2::splat(DOT)), colour);
        }
    }
    painter.add(Shape::mesh(mesh));
}
