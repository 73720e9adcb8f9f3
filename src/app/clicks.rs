//! What was done to a stage, as commands; and an outline that is drawn by clicking.

use egui::Shape;

use crate::{
    panels::moved_to,
    widgets::{CanvasShown, Gesture, Moved, place_at},
};

use super::{App, Command, history::UndoGroup, prelude::*, stage_state::StageState};

/// A click this near to a segment or an edge, in points, is on it.
const CLICK_REACH: f64 = 8.0;
/// An eye goes round by so many degrees while the pointer crosses half the height of the picture.
const TURN_DEG: f64 = 90.0;

pub fn ask(
    app: &App,
    ui: &Ui,
    shown: &CanvasShown,
    (id, lens): (ViewId, Lens),
    (handles, locks): (&[Handle], &[Lock]),
    state: &StageState,
) {
    // Wheel and drag over the camera's picture are not about what lies under it.
    let view = shown.view.filter(|_| shown.picture.is_none());
    app.push_all(view.and_then(|view| match lens {
        Lens::Plane => Some(Command::View(id, view)),
        Lens::Eye(eye) => {
            let moved = if shown.pans { panned } else { turned };
            Some(Command::Turn(id, moved(eye, &shown.viewport, view)))
        }
        // It is part of the scene.
        Lens::Camera(_) => None,
    }));
    if let Some(moved) = shown.moved {
        move_handle(app, ui, (handles[moved.spot], &moved), lens, state);
    }
    if shown.released {
        app.push(Command::EndGesture);
    }
    let Some(click) = shown.clicked else {
        return;
    };
    let vertex = click.spot.and_then(|i| handles.get(i));
    let is_free = |handle: &&Handle| !Lock::any_holds(locks, **handle);
    if let Some(&handle) = vertex.filter(|handle| click.is_double && is_free(handle)) {
        app.push(Command::Type(Some(handle), None));
        return;
    }
    if let Some(&vertex) = vertex.filter(|handle| handle.kind().is_vertex) {
        app.push(Command::Select(vertex));
        app.push(Command::Ask(vertex.link()));
        return;
    }
    let place = place_at(ui, &shown.viewport, click.at, app.settings.snap);
    let click = Click {
        place: lens.world_from_drawing(place, [0.0; 3]),
        inserts: click.is_double || click.has_ctrl,
        picture: shown.picture,
        ..click_at(&shown.viewport, lens, locks, (click.at, shown.pointed))
    };
    let document = app.scene().document();
    let change = document.click(&click);
    app.push_all(change.map(|change| Command::Edit(Edit::Own(change), None)));
    app.push(Command::Ask(document.asked(&click)));
}

fn move_handle(
    app: &App,
    ui: &Ui,
    (handle, moved): (Handle, &Moved),
    lens: Lens,
    state: &StageState,
) {
    let gesture = match moved.by {
        Gesture::Drag => UndoGroup::Drag(moved.spot),
        Gesture::Nudge => UndoGroup::Nudge(moved.spot),
    };
    if handle.kind().is_vertex && state.selected != Some(handle) {
        app.push(Command::Select(handle));
    }
    let from = app.scene().document().position(handle);
    let motion = held_axis(ui, lens).unwrap_or(handle.kind().motion);
    let to = from.map(|from| {
        let to = moved_to(&lens, motion, from, moved.to);
        lens.deeper(to, moved.deeper)
    });
    app.push_all(to.map(|to| Command::Edit(Edit::Drag(handle, to), Some(gesture))));
}

/// In space X, Y or Z held: along that axis only.
fn held_axis(ui: &Ui, lens: Lens) -> Option<Motion> {
    const AXES: [(Key, [f64; 3]); 3] = [
        (Key::X, [1.0, 0.0, 0.0]),
        (Key::Y, [0.0, 1.0, 0.0]),
        (Key::Z, [0.0, 0.0, 1.0]),
    ];
    let mut axes = AXES.into_iter().filter(|_| lens != Lens::Plane);
    let held = axes.find(|&(key, _)| ui.input(|input| input.key_down(key)));
    held.map(|(_, axis)| Motion::Axis(axis))
}

pub fn click_at<'a>(
    viewport: &Viewport,
    lens: Lens,
    locks: &'a [Lock],
    (at, link): (Pos2, Option<Link>),
) -> Click<'a> {
    let at = lens.world_from_drawing(viewport.to_world(at), [0.0; 3]);
    Click {
        at,
        place: at,
        reach: CLICK_REACH / viewport.scale,
        link,
        locks,
        ..Click::default()
    }
}

fn turned(eye: Orbit, seen: &Viewport, to: PanZoom) -> Orbit {
    let by = [0, 1].map(|i| TURN_DEG * (to.centre[i] - seen.centre[i]));
    eye.turned(by).zoomed(to.scale / seen.scale)
}

fn panned(eye: Orbit, seen: &Viewport, to: PanZoom) -> Orbit {
    // The picture's half height is 1, whatever part of it is seen.
    let by = [0, 1].map(|i| to.centre[i] - seen.centre[i]);
    eye.panned(by).zoomed(to.scale / seen.scale)
}

/// A click this near to the first point, in points, closes the outline.
const CLOSE_REACH: f32 = 10.0;
const DOT: f32 = 4.0;
/// A dash and the gap after it.
const DASH: [f32; 2] = [6.0, 4.0];

pub fn ask_of_sketch(app: &App, ui: &Ui, shown: &CanvasShown, sketch: &Sketch) {
    app.push_all(shown.view.map(|view| Command::View(ViewId::PLANE, view)));
    let Some(click) = shown.clicked else {
        return;
    };
    // The first click of the two has placed the last point.
    if click.is_double || closes(&shown.viewport, sketch, click.at) {
        app.push(Command::CloseOutline);
    } else {
        let at = place_at(ui, &shown.viewport, click.at, app.settings.snap);
        app.push(Command::Place(at));
    }
}

fn closes(viewport: &Viewport, sketch: &Sketch, at: Pos2) -> bool {
    let is_near = |&first: &[f64; 2]| viewport.to_screen(first).distance(at) <= CLOSE_REACH;
    sketch.can_close() && sketch.points().first().is_some_and(is_near)
}

pub fn draw_sketch(app: &App, ui: &Ui, viewport: &Viewport, sketch: &Sketch) {
    let theme = app.look().theme;
    let painter = ui.painter_at(viewport.rect);
    let colour = theme.accent;
    let points = sketch.points().iter().map(|&p| viewport.to_screen(p));
    let points: Vec<Pos2> = points.collect();
    let pointer = ui.ctx().pointer_hover_pos();
    let pointer = pointer.filter(|_| ui.rect_contains_pointer(viewport.rect));
    let will_close = pointer.is_some_and(|at| closes(viewport, sketch, at));
    let place = |at| viewport.to_screen(place_at(ui, viewport, at, app.settings.snap));
    let next = if will_close {
        points.first().copied()
    } else {
        pointer.map(place)
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
