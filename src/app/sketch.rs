//! Drawing an outline by clicking: what it looks like half done, and what a click does to it.

use egui::{Pos2, Shape, Stroke, Ui};

use crate::{
    figure::ViewId,
    labs::Sketch,
    paint::Viewport,
    widgets::{CanvasShown, place_at},
};

use super::{App, Command};

/// A click this near to the first point, in points, closes the outline.
const CLOSE_REACH: f32 = 10.0;
/// Radius of a point that was placed.
const DOT: f32 = 4.0;
/// A dash and the gap after it.
const DASH: [f32; 2] = [6.0, 4.0];

/// What was done to a canvas while an outline is drawn.
pub fn ask(app: &App, ui: &Ui, shown: &CanvasShown, sketch: &Sketch, commands: &mut Vec<Command>) {
    commands.extend(shown.view.map(|view| Command::View(ViewId::PLANE, view)));
    let Some(click) = shown.clicked else {
        return;
    };
    // The first click of the two has placed the last point.
    if click.is_double || closes(&shown.viewport, sketch, click.at) {
        commands.push(Command::CloseOutline);
    } else {
        let at = place_at(ui, &shown.viewport, click.at, app.settings.snap);
        commands.push(Command::Place(at));
    }
}

fn closes(viewport: &Viewport, sketch: &Sketch, at: Pos2) -> bool {
    let is_near = |&first: &[f64; 2]| viewport.to_screen(first).distance(at) <= CLOSE_REACH;
    sketch.can_close() && sketch.points().first().is_some_and(is_near)
}

/// The points placed so far, and dashed what the next click would add.
pub fn draw(app: &App, ui: &Ui, viewport: &Viewport, sketch: &Sketch) {
    let theme = app.look().theme;
    let painter = ui.painter_at(viewport.rect);
    let colour = theme.accent;
    let points: Vec<Pos2> = sketch
        .points()
        .iter()
        .map(|&p| viewport.to_screen(p))
        .collect();
    let pointer = ui
        .ctx()
        .pointer_hover_pos()
        .filter(|_| ui.rect_contains_pointer(viewport.rect));
    let will_close = pointer.is_some_and(|at| closes(viewport, sketch, at));
    let next = pointer.map(|at| {
        let at = place_at(ui, viewport, at, app.settings.snap);
        viewport.to_screen(at)
    });
    let next = if will_close {
        points.first().copied()
    } else {
        next
    };
    let solid = theme.stroke(2.0, colour);
    painter.add(Shape::line(points.clone(), solid));
    let dashed = |from: Pos2, to: Pos2, stroke: Stroke| {
        let [dash, gap] = DASH.map(|length| length * theme.stroke_scale);
        painter.extend(Shape::dashed_line(&[from, to], stroke, dash, gap));
    };
    if let (Some(&last), Some(next)) = (points.last(), next) {
        dashed(last, next, solid);
    }
    // The edge that would close it, once it encloses something.
    if let ([first, _, ..], Some(next), false) = (&points[..], next, will_close) {
        dashed(next, *first, theme.stroke(1.0, theme.faint));
    }
    for &at in &points {
        painter.circle(at, DOT, colour, Stroke::new(2.0, theme.background));
    }
    if let (Some(&first), true) = (points.first(), sketch.can_close()) {
        let radius = if will_close { 11.0 } else { 8.0 };
        painter.circle_stroke(first, radius, theme.stroke(1.5, colour));
    }
    if let Some(next) = next.filter(|_| !will_close) {
        painter.circle(next, DOT, theme.background, theme.stroke(1.5, colour));
    }
}
