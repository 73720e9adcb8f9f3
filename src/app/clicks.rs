//! What was done to a stage, as commands.

use egui::{Key, Pos2, Ui};

use crate::{
    figure::{Lens, Link, ViewId},
    geom::Orbit,
    labs::{Click, Edit, Handle, Lock, Motion},
    paint::Viewport,
    panels::moved_to,
    widgets::{CanvasShown, Gesture, PanZoom, place_at},
};

use super::{App, Command, history::UndoGroup, stage_state::StageState};

/// A click this near to a segment or an edge, in points, is on it.
const CLICK_REACH: f64 = 8.0;
/// An eye goes round by so many degrees while the pointer crosses half the height of the picture.
const TURN_DEG: f64 = 90.0;

/// What was done to a canvas with these handles and locks.
pub fn ask(
    app: &App,
    ui: &Ui,
    shown: &CanvasShown,
    (id, lens): (ViewId, Lens),
    (handles, locks): (&[Handle], &[Lock]),
    state: &StageState,
    commands: &mut Vec<Command>,
) {
    commands.extend(shown.view.and_then(|view| match lens {
        Lens::Plane => Some(Command::View(id, view)),
        Lens::Eye(eye) => {
            let moved = if shown.pans { panned } else { turned };
            Some(Command::Turn(id, moved(eye, &shown.viewport, view)))
        }
        // It is part of the scene.
        Lens::Camera(_) => None,
    }));
    if let Some(moved) = shown.moved {
        let handle = handles[moved.spot];
        let gesture = match moved.by {
            Gesture::Drag => UndoGroup::Drag(moved.spot),
            Gesture::Nudge => UndoGroup::Nudge(moved.spot),
        };
        if handle.kind().is_vertex && state.selected != Some(handle) {
            commands.push(Command::Select(handle));
        }
        let from = app.scene().document().position(handle);
        let motion = held_axis(ui, lens).unwrap_or(handle.kind().motion);
        let to = from.map(|from| {
            let to = moved_to(&lens, motion, from, moved.to);
            lens.deeper(to, moved.deeper)
        });
        commands.extend(to.map(|to| Command::Edit(Edit::Drag(handle, to), Some(gesture))));
    }
    if shown.released {
        commands.push(Command::EndGesture);
    }
    let Some(click) = shown.clicked else {
        return;
    };
    let vertex = click.spot.and_then(|i| handles.get(i));
    let is_free = |handle: &&Handle| !Lock::any_holds(locks, **handle);
    if let Some(&handle) = vertex.filter(|handle| click.is_double && is_free(handle)) {
        commands.push(Command::Type(Some(handle)));
        return;
    }
    if let Some(&vertex) = vertex.filter(|handle| handle.kind().is_vertex) {
        commands.push(Command::Select(vertex));
        commands.push(Command::Ask(vertex.link()));
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
    commands.extend(change.map(|change| Command::Edit(Edit::Own(change), None)));
    commands.push(Command::Ask(document.asked(&click)));
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

/// A plain click at a place on the screen.
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
        inserts: false,
        picture: None,
        link,
        locks,
    }
}

/// Where an eye has gone that was pushed round instead of panned, and drawn nearer.
fn turned(eye: Orbit, seen: &Viewport, to: PanZoom) -> Orbit {
    let by = [0, 1].map(|i| TURN_DEG * (to.centre[i] - seen.centre[i]));
    eye.turned(by).zoomed(to.scale / seen.scale)
}

/// Where an eye has gone that was moved sideways, and drawn nearer.
fn panned(eye: Orbit, seen: &Viewport, to: PanZoom) -> Orbit {
    // The picture's half height is 1, whatever part of it is seen.
    let by = [0, 1].map(|i| to.centre[i] - seen.centre[i]);
    eye.panned(by).zoomed(to.scale / seen.scale)
}
