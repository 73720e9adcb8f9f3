//! What was done to a stage, as commands.

use egui::Ui;

use crate::{
    figure::ViewId,
    labs::{Click, Edit, Handle, Lock},
    widgets::{CanvasShown, Gesture as HandleGesture, place_at},
};

use super::{Command, document::Gesture, model::Model, stage_state::StageState};

/// A click this near to a segment or an edge, in points, is on it.
const CLICK_REACH: f64 = 8.0;

/// What was done to a canvas with these handles and locks.
pub fn ask(
    model: &Model<'_>,
    ui: &Ui,
    shown: &CanvasShown,
    (handles, locks): (&[Handle], &[Lock]),
    state: &StageState,
    commands: &mut Vec<Command>,
) {
    commands.extend(shown.view.map(|view| Command::View(ViewId::PLANE, view)));
    if let Some(moved) = shown.moved {
        let handle = handles[moved.spot];
        let gesture = match moved.by {
            HandleGesture::Drag => Gesture::Drag(moved.spot),
            HandleGesture::Nudge => Gesture::Nudge(moved.spot),
        };
        if handle.kind().is_vertex && state.selected != Some(handle) {
            commands.push(Command::Select(handle));
        }
        commands.push(Command::Edit(
            Edit::Drag(handle, [moved.to[0], moved.to[1], 0.0]),
            Some(gesture),
        ));
    }
    if shown.released {
        commands.push(Command::EndGesture);
    }
    let Some(click) = shown.clicked else {
        return;
    };
    let vertex = click.spot.and_then(|i| handles.get(i));
    if let Some(&vertex) = vertex.filter(|handle| handle.kind().is_vertex) {
        commands.push(Command::Select(vertex));
        return;
    }
    let in_space = |[x, y]: [f64; 2]| [x, y, 0.0];
    let asked = model.scene.document().click(&Click {
        at: in_space(shown.viewport.to_world(click.at)),
        place: in_space(place_at(ui, &shown.viewport, click.at, model.settings.snap)),
        reach: CLICK_REACH / shown.viewport.scale,
        inserts: click.is_double || click.has_ctrl,
        locks,
    });
    commands.extend(asked.map(|change| Command::Edit(Edit::Own(change), None)));
}
