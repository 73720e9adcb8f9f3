//! What was done to a stage, as commands.

use egui::{Pos2, Ui};

use crate::{
    figure::ViewId,
    geom::Polygon,
    labs::{Handle, Lock, Scene, lines, polygons},
    paint::Viewport,
    panels::{Edit, lines::LinesEdit, polygons::PolygonsEdit},
    widgets::{CanvasShown, Click, Gesture as HandleGesture, distance_to_segment, place_at},
};

use super::{Command, document::Gesture, model::Model, stage_state::StageState};

/// A click this near to a segment or an edge, in points, is on it.
const CLICK_REACH: f32 = 8.0;

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
        if handle.is_vertex() && state.selected != Some(handle) {
            commands.push(Command::Select(handle));
        }
        commands.push(Command::Edit(Edit::Drag(handle, moved.to), Some(gesture)));
    }
    if shown.released {
        commands.push(Command::EndGesture);
    }
    let Some(click) = shown.clicked else {
        return;
    };
    match model.scene {
        Scene::Lines(scene) => {
            let on_segment = segment_at(scene, &shown.viewport, click.at);
            commands.extend(on_segment.map(|i| {
                let focus = LinesEdit::Focus(i);
                Command::Edit(Edit::Lines(focus), None)
            }));
        }
        Scene::Polygons(scene) => {
            on_polygons(model, ui, shown, click, scene, (handles, locks), commands);
        }
    }
}

/// A click takes hold of a vertex; two, or one with Ctrl, put a new one on an edge.
fn on_polygons(
    model: &Model<'_>,
    ui: &Ui,
    shown: &CanvasShown,
    click: Click,
    scene: &polygons::Scene,
    (handles, locks): (&[Handle], &[Lock]),
    commands: &mut Vec<Command>,
) {
    let vertex = click.spot.and_then(|i| handles.get(i));
    if let Some(&vertex) = vertex.filter(|handle| handle.is_vertex()) {
        commands.push(Command::Select(vertex));
        return;
    }
    if !(click.is_double || click.has_ctrl) {
        return;
    }
    let before = edge_at(scene, &shown.viewport, click.at);
    let Some(before) = before.filter(|&handle| !locks.iter().any(|lock| lock.holds(handle))) else {
        return;
    };
    let to = place_at(ui, &shown.viewport, click.at, model.settings.snap);
    let insert = PolygonsEdit::Insert(Some(before), Some(to));
    commands.push(Command::Edit(Edit::Polygons(insert), None));
    commands.push(Command::Select(before.next()));
}

/// The handle of the vertex where the edge under a place on the screen begins.
fn edge_at(scene: &polygons::Scene, viewport: &Viewport, at: Pos2) -> Option<Handle> {
    let on = |ring: &Polygon, handle: &dyn Fn(usize) -> Handle| {
        nearest(ring, viewport, at).map(|(d, i)| (d, handle(i)))
    };
    let holes = scene.holes.iter().enumerate();
    let holes = holes.filter_map(|(hole, ring)| on(ring, &|i| Handle::HoleVertex(hole, i)));
    on(&scene.subject, &Handle::Vertex)
        .into_iter()
        .chain(holes)
        .chain(
            scene
                .clip_in_use()
                .and_then(|ring| on(ring, &Handle::ClipVertex)),
        )
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, handle)| handle)
}

/// The nearest edge of a ring within reach, and how far it is.
fn nearest(ring: &Polygon, viewport: &Viewport, at: Pos2) -> Option<(f32, usize)> {
    ring.edges()
        .enumerate()
        .map(|(i, edge)| {
            let [a, b] = [edge.p1, edge.p2].map(|p| viewport.to_screen(p.to_array()));
            (distance_to_segment(at, a, b), i)
        })
        .filter(|&(d, _)| d <= CLICK_REACH)
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The segment under a place on the screen, unless it is in focus already.
fn segment_at(scene: &lines::Scene, viewport: &Viewport, at: Pos2) -> Option<usize> {
    let distance = |i: usize| {
        let [a, b] = [scene.segments()[i].p1, scene.segments()[i].p2]
            .map(|p| viewport.to_screen(p.to_array()));
        distance_to_segment(at, a, b)
    };
    (0..scene.segments().len())
        .map(|i| (i, distance(i)))
        .filter(|&(_, d)| d <= CLICK_REACH)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(i, _)| i)
        .filter(|&i| i != scene.focus())
}
