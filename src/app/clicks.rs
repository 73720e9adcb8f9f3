//! What was done to a stage, as commands; and an outline that is drawn by clicking.

use egui::Shape;

use crate::{
    figure::{Mark, Role},
    paint::round_step,
    panels::moved_to,
    widgets::{CanvasShown, Gesture, Moved, Seized, gripped, link_at, place_at, reach, snapped},
};

use super::{App, Command, history::UndoGroup, prelude::*, stage_state::StageState, why};

/// A click this near to a segment or an edge, in points, is on it.
const CLICK_REACH: f32 = 8.0;
/// An eye goes round by so many degrees while the pointer crosses half the height of the picture.
const TURN_DEG: f64 = 90.0;
/// In space a drag goes by round steps of at least so many points: three coordinates are rounded, and it is not to leave the pointer.
const STEP_PTS: f64 = 12.0;
/// A measure goes by round steps of at least this part of it: to two digits.
const STEP_OF_MEASURE: f64 = 0.05;

pub fn ask(
    app: &App,
    ui: &Ui,
    shown: &CanvasShown,
    (column, (id, lens)): (usize, (ViewId, Lens)),
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
    let hold = hold(app, ui, shown.response.id, handles);
    if let Some(moved) = shown.moved {
        let handle = handles[moved.spot];
        if handle.kind().is_vertex && state.selected != Some(handle) {
            app.push(Command::Select(handle));
        }
        let hold = hold.filter(|_| moved.by == Gesture::Drag);
        let hold = hold.or_else(|| Hold::new(app, ui, handle));
        let moved = (handle, &moved);
        app.push_all(
            hold.and_then(|hold| moved_by(app.scene(), &shown.viewport, moved, lens, hold)),
        );
    }
    if shown.released {
        app.push(Command::EndGesture);
    }
    clicked(app, ui, shown, (column, lens), (handles, locks));
}

/// A click answers an open question, else it is about what it hits.
fn clicked(
    app: &App,
    ui: &Ui,
    shown: &CanvasShown,
    (column, lens): (usize, Lens),
    (handles, locks): (&[Handle], &[Lock]),
) {
    let Some(click) = shown.clicked else {
        return;
    };
    let in_column = |about| (about, column);
    let vertex = click.spot.and_then(|i| handles.get(i));
    let pointed = vertex.and_then(|handle| handle.link()).or(shown.pointed);
    if let Some(nth) = pointed.and_then(|link| app.practice.option_of(link)) {
        app.push(Command::Choose(nth));
        return;
    }
    let is_free = |handle: &&Handle| !Lock::any_holds(locks, **handle);
    if let Some(&handle) = vertex.filter(|handle| click.is_double && is_free(handle)) {
        app.push(Command::Type(Some(handle), None));
        return;
    }
    if let Some(&vertex) = vertex.filter(|handle| handle.kind().is_vertex) {
        app.push(Command::Select(vertex));
        app.push(Command::Ask(vertex.link().map(in_column)));
        return;
    }
    let place = place_at(ui, &shown.viewport, click.at, app.settings.snap);
    let click = Click {
        place: lens.world_from_drawing(place, [0.0; 3]),
        inserts: click.is_double || click.has_ctrl,
        picture: shown.picture,
        ..click_at(ui, &shown.viewport, lens, locks, (click.at, shown.pointed))
    };
    let document = app.scene().document();
    let change = document.click(&click);
    app.push_all(change.map(|change| Command::Edit(Edit::Own(change), None)));
    let asked = why::asked(app.scene(), column, &click);
    app.push(Command::Ask(asked.map(in_column)));
}

/// What a handle goes on from that is moved: where it was when the button went down, or when an axis was taken.
#[derive(Clone, Copy, Default)]
struct Hold {
    from: [f64; 3],
    /// From there to where it is taken hold of.
    to_held: [f64; 3],
    axis: Option<[f64; 3]>,
}

impl Hold {
    fn new(app: &App, ui: &Ui, handle: Handle) -> Option<Self> {
        let document = app.scene().document();
        let (from, held) = (document.position(handle)?, document.held_at(handle)?);
        Some(Self {
            from,
            to_held: std::array::from_fn(|i| held[i] - from[i]),
            axis: held_axis(ui),
        })
    }

    /// Where the handle lies when it is held there.
    fn place_where_held(&self, at: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| at[i] - self.to_held[i])
    }

    fn held(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.from[i] + self.to_held[i])
    }
}

/// What is held of the handle that is being dragged: until the button is let go, whatever becomes of the keys, so that nothing jumps.
fn hold(app: &App, ui: &Ui, canvas: Id, handles: &[Handle]) -> Option<Hold> {
    let id = canvas.with("hold");
    let Some(&handle) = gripped(ui, canvas).and_then(|i| handles.get(i)) else {
        ui.data_mut(|data| data.remove_temp::<Hold>(id));
        return None;
    };
    let axis = held_axis(ui);
    let before: Option<Hold> = ui.data(|data| data.get_temp(id));
    let before = before.filter(|before| axis.is_none() || axis == before.axis);
    let now = before.or_else(|| Hold::new(app, ui, handle))?;
    ui.data_mut(|data| data.insert_temp(id, now));
    Some(now)
}

fn moved_by(
    scene: &Scene,
    viewport: &Viewport,
    (handle, moved): (Handle, &Moved),
    lens: Lens,
    hold: Hold,
) -> Option<Command> {
    let is_flat = lens == Lens::Plane;
    let motion = match scene.document().motion(handle) {
        own @ Motion::Axis(_) => own,
        own @ (Motion::Plane | Motion::FacingEye) => {
            let axis = hold.axis.filter(|_| !is_flat);
            axis.map_or(own, Motion::Axis)
        }
    };
    let to = moved_to(&lens, motion, hold.held(), moved.to);
    let to = hold.place_where_held(lens.deeper(to, moved.deeper));
    let gesture = match moved.by {
        Gesture::Drag => UndoGroup::Drag(moved.spot),
        Gesture::Nudge(_) => UndoGroup::Nudge(moved.spot),
    };
    let step = || round_step(STEP_PTS * lens.unit_at(hold.held()) / viewport.scale);
    let edit = match moved.by {
        Gesture::Nudge(times) if !is_flat && moved.deeper == 0.0 => {
            nudged(scene, handle, (motion, [hold.from, to]), [step(), times])?
        }
        Gesture::Drag if !is_flat && !moved.is_free => {
            rounded(scene, handle, (motion, to), step())?
        }
        Gesture::Drag | Gesture::Nudge(_) => Edit::Drag(handle, to),
    };
    Some(Command::Edit(edit, Some(gesture)))
}

/// The change that takes a handle so many round steps that way: of its measure, where it has one, else along the axis of space
/// that goes most that way.
fn nudged(
    scene: &Scene,
    handle: Handle,
    (motion, [from, to]): (Motion, [[f64; 3]; 2]),
    [step, times]: [f64; 2],
) -> Option<Edit> {
    if let Some(now) = scene.document().measure(handle) {
        let mut there = scene.clone();
        let document = there.document_mut();
        document.drag(handle, to).ok()?;
        let way = (document.measure(handle)? - now).signum();
        let step = times * round_step(STEP_OF_MEASURE * now);
        return Some(Edit::Measure(handle, snapped(now + way * step, step)));
    }
    let by: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    let n_axes = by.iter().filter(|by| **by != 0.0).count();
    if n_axes == 0 {
        return None;
    }
    if n_axes > 1 && matches!(motion, Motion::Axis(_)) {
        return Some(Edit::Drag(handle, to));
    }
    let most = (0..3).max_by(|&i, &j| by[i].abs().total_cmp(&by[j].abs()))?;
    let mut there = from;
    let step = times * step;
    there[most] = snapped(from[most] + by[most].signum() * step, step);
    Some(Edit::Drag(handle, there))
}

/// The change that brings a handle to round numbers there, if it is one: to a round measure, where it has one.
fn rounded(
    scene: &Scene,
    handle: Handle,
    (motion, to): (Motion, [f64; 3]),
    step: f64,
) -> Option<Edit> {
    if let Some(now) = scene.document().measure(handle) {
        let mut there = scene.clone();
        let document = there.document_mut();
        document.drag(handle, to).ok()?;
        let measure = document.measure(handle)?;
        let measure = snapped(measure, round_step(STEP_OF_MEASURE * measure));
        return (measure != now).then_some(Edit::Measure(handle, measure));
    }
    let is_kept = |i: usize| matches!(motion, Motion::Axis(axis) if axis[i] == 0.0);
    let round = |i: usize| {
        if is_kept(i) {
            to[i]
        } else {
            snapped(to[i], step)
        }
    };
    let to = std::array::from_fn(round);
    (scene.document().position(handle) != Some(to)).then_some(Edit::Drag(handle, to))
}

/// The axis of space whose key, X, Y or Z, is down.
fn held_axis(ui: &Ui) -> Option<[f64; 3]> {
    const AXES: [(Key, [f64; 3]); 3] = [
        (Key::X, [1.0, 0.0, 0.0]),
        (Key::Y, [0.0, 1.0, 0.0]),
        (Key::Z, [0.0, 0.0, 1.0]),
    ];
    let mut axes = AXES.into_iter();
    let held = axes.find(|&(key, _)| ui.input(|input| input.key_down(key)));
    held.map(|(_, axis)| axis)
}

pub fn click_at<'a>(
    ui: &Ui,
    viewport: &Viewport,
    lens: Lens,
    locks: &'a [Lock],
    (at, link): (Pos2, Option<Link>),
) -> Click<'a> {
    let at = lens.world_from_drawing(viewport.to_world(at), [0.0; 3]);
    Click {
        at,
        place: at,
        reach: f64::from(reach(ui, CLICK_REACH)) / viewport.scale,
        link,
        locks,
        ..Click::default()
    }
}

/// What a click under the pointer would pick.
pub fn pointed(
    app: &App,
    ui: &Ui,
    (viewport, lens): (&Viewport, Lens),
    locks: &[Lock],
    marks: &[Mark],
) -> Option<Mark> {
    if !ui.rect_contains_pointer(viewport.rect) {
        return None;
    }
    let pointer = ui.input(|input| input.pointer.hover_pos())?;
    let reach = reach(ui, CLICK_REACH);
    let there = (pointer, link_at(viewport, marks, pointer, reach));
    let click = click_at(ui, viewport, lens, locks, there);
    let shape = app.scene().document().pointed(&click)?;
    Some(Mark::new(Role::Accent, shape))
}

/// Which of the handles a press on what is drawn with this link takes hold of.
pub fn seized(app: &App, (handles, locks): (&[Handle], &[Lock]), link: Link) -> Option<Seized> {
    let seized = app.scene().document().seized(link)?;
    let nth = handles.iter().position(|&handle| handle == seized)?;
    if !Lock::any_holds(locks, seized) {
        return Some(Seized::By(nth));
    }
    // What might be the answer is pointed at like a point or an edge.
    let is_option = app.practice.option_of(link).is_some();
    (!is_option).then_some(Seized::Locked)
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
    if click.is_double || closes(ui, &shown.viewport, sketch, click.at) {
        app.push(Command::CloseOutline);
    } else {
        let at = place_at(ui, &shown.viewport, click.at, app.settings.snap);
        app.push(Command::Place(at));
    }
}

fn closes(ui: &Ui, viewport: &Viewport, sketch: &Sketch, at: Pos2) -> bool {
    let is_near =
        |&first: &[f64; 2]| viewport.to_screen(first).distance(at) <= reach(ui, CLOSE_REACH);
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
    let will_close = pointer.is_some_and(|at| closes(ui, viewport, sketch, at));
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
