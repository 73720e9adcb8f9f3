//! The grid of a plane: its dots, and the numbers along its edges.

use egui::Mesh;

use super::prelude::*;

const DOT: f32 = 1.5;
/// Dots at most: a stage as large as a 4K screen holds fewer at any zoom.
const MAX_DOTS: f64 = 20_000.0;
const BETWEEN: f64 = 56.0;
const FROM_EDGE: f32 = 4.0;
const MOST_NUMBERS: f64 = 200.0;

pub fn numbers(
    painter: &Painter,
    viewport: &Viewport,
    step: f64,
    (look, taken): (Look<'_>, &[Rect]),
) {
    let rect = viewport.rect;
    let lines = (BETWEEN / (step * viewport.scale)).ceil().max(1.0);
    // Of grids of 1, 2 or 5 every fifth line has a round number, of others it has one, too.
    let mut steps = [1.0, 2.0, 5.0, 10.0].into_iter();
    let every = step * steps.find(|&n| n >= lines).unwrap_or(lines);
    let font = FontId::monospace(look.theme.pts(9.5, look.theme.text_scale));
    let [left, top] = viewport.to_world(rect.min);
    let [right, bottom] = viewport.to_world(rect.max);
    let room = f64::from(font.size) * 1.5 / viewport.scale;
    let round = |from: f64, to: f64| {
        let (first, last) = ((from / every).ceil(), (to / every).floor());
        let has_numbers = last - first < MOST_NUMBERS && first.abs().max(last.abs()) < 1e15;
        let n = (last - first + 1.0).max(0.0);
        let n = if has_numbers { n } else { 0.0 };
        (0..n as u32).map(move |i| (first + f64::from(i)) * every)
    };
    let number = |at: Pos2, align: Align2, x: f64| {
        let (colour, ground) = (look.theme.soft, look.theme.background);
        // Beside each other fractions would mix with decimals.
        let text = look.catalog.alike(Notation::Decimals).value(&x.into());
        let text = painter.layout_no_wrap(text, font.clone(), colour);
        let place = align.anchor_size(at, text.size());
        // A number gives way to what the figure says, and to what is dragged.
        let around = place.expand(4.0);
        if taken.iter().any(|rect| rect.intersects(around)) {
            return;
        }
        painter.rect_filled(place.expand2(vec2(2.0, 0.0)), 0.0, ground);
        painter.galley(place.min, text, colour);
    };
    for x in round(left + 2.0 * room, right - room) {
        let at = pos2(viewport.to_screen([x, 0.0]).x, rect.bottom() - FROM_EDGE);
        number(at, Align2::CENTER_BOTTOM, x);
    }
    for y in round(bottom + 2.0 * room, top - room) {
        let at = pos2(rect.left() + FROM_EDGE, viewport.to_screen([0.0, y]).y);
        number(at, Align2::LEFT_CENTER, y);
    }
}

pub fn dots(painter: &Painter, viewport: &Viewport, step: f64, colour: Color32) {
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
