//! The quiet grid of a stage: dots where its lines would cross.

use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, Vec2};

use crate::paint::Viewport;

/// Side of a dot in points.
const DOT: f32 = 1.5;
/// Dots at most: a stage as large as a 4K screen holds fewer at any zoom.
const MAX_DOTS: f64 = 20_000.0;

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
