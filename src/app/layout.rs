//! Where everything stands: five places in a wide window, one at a time in a narrow one.

use egui::{CentralPanel, Frame, Margin, Panel, Ui};

use crate::panels::LabPanel;

use super::{
    App, Command, bars, course_panel, course_strip, free_panel, inspector, overlays,
    room::{BESIDE_TRANSPORT, COURSE, CoursePart, INSPECTOR, Room, panel_scale},
    stage,
    stage_state::StageState,
    typing,
};

/// Width of the course folded to the numbers of its steps.
const STRIP: f32 = 48.0;

/// Draws the window; what is asked for is pushed onto `commands`.
pub fn show(
    app: &App,
    ui: &mut Ui,
    state: &mut StageState,
    panels: &mut [Box<dyn LabPanel>],
    commands: &mut Vec<Command>,
) {
    (state.pointed_on_stage, state.pointed_in_inspector) = (None, None);
    if app.is_presenting() {
        presentation(app, ui, state, commands);
    } else {
        top(app, ui, panels, commands);
        bottom(app, ui, commands);
        if !app.is_narrow() {
            sides(app, ui, state, panels, commands);
        }
        let panel = Frame::new().fill(app.look().theme.panel).inner_margin(16);
        match app.room() {
            Room::Stage => centre(app, ui, state, commands),
            Room::Course => {
                CentralPanel::no_frame()
                    .frame(panel)
                    .show(ui, |ui| left(app, ui, panels, commands));
            }
            Room::Inspector => {
                CentralPanel::no_frame().frame(panel).show(ui, |ui| {
                    inspector::show(app, ui, state, commands);
                });
            }
        }
    }
    state.lit = state.pointed_on_stage.or(state.pointed_in_inspector);
    if let Some(mut typed) = state.typing.take() {
        let place = app.scene().document().position(typed.handle);
        let at_handle = || place.and_then(|place| state.on_screen(place));
        if let Some(at) = typed.at.or_else(at_handle) {
            typing::show(ui.ctx(), app.look(), (&mut typed, at), commands);
            state.typing = Some(typed);
        }
    }
    overlays::show(app, ui, panels, commands);
}

fn centre(app: &App, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    CentralPanel::no_frame().show(ui, |ui| stage::show(app, ui, state, commands));
}

/// Stage, caption, and the smallest transport there is.
fn presentation(app: &App, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    let frame = Frame::new()
        .fill(app.look().theme.panel)
        .inner_margin(Margin::symmetric(16, 0));
    Panel::bottom("small transport")
        .exact_size(40.0)
        .frame(frame)
        .show(ui, |ui| {
            bars::small_transport(app, ui, commands);
        });
    centre(app, ui, state, commands);
}

fn top(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>], commands: &mut Vec<Command>) {
    let scale = app.look().theme.text_scale.sqrt();
    let height = if app.is_low() { 36.0 } else { 44.0 * scale };
    let margin = if app.is_narrow() { 8 } else { 16 };
    let frame = Frame::new()
        .fill(app.look().theme.panel)
        .inner_margin(Margin::symmetric(margin, 0));
    Panel::top("top bar")
        .exact_size(height.round())
        .frame(frame)
        .show(ui, |ui| {
            bars::top(app, ui, panels, commands);
        });
}

fn bottom(app: &App, ui: &mut Ui, commands: &mut Vec<Command>) {
    let height = if app.is_low() { 40.0 } else { 56.0 };
    let margin = if app.is_narrow() {
        BESIDE_TRANSPORT
    } else {
        12
    };
    let frame = Frame::new()
        .fill(app.look().theme.panel)
        .inner_margin(Margin::symmetric(margin, 0));
    Panel::bottom("transport")
        .exact_size(height)
        .frame(frame)
        .show(ui, |ui| {
            bars::transport(app, ui, commands);
        });
}

/// The course, or what stands in its place in a free scene.
fn left(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>], commands: &mut Vec<Command>) {
    if app.bookmark.free().is_some() {
        free_panel::show(app, ui, panels, commands);
    } else {
        course_panel::show(app, ui, commands);
    }
}

fn sides(
    app: &App,
    ui: &mut Ui,
    state: &mut StageState,
    panels: &mut [Box<dyn LabPanel>],
    commands: &mut Vec<Command>,
) {
    let width = ui.ctx().content_rect().width();
    let widest = 0.28 * width;
    let scale = panel_scale(app.look().theme);
    let frame = Frame::new().fill(app.look().theme.panel);
    let margin = |side: i8| Margin {
        left: side,
        right: side,
        top: 12,
        bottom: 8,
    };
    match app.course_part() {
        CoursePart::Hidden => {}
        CoursePart::Strip => {
            Panel::left("course strip")
                .exact_size(STRIP)
                .frame(frame.inner_margin(margin(8)))
                .show(ui, |ui| course_strip::show(app, ui, commands));
        }
        CoursePart::Whole => {
            Panel::left("course")
                .default_size((COURSE * scale).round())
                .size_range(160.0..=widest.max(COURSE * scale))
                .frame(frame.inner_margin(margin(8)))
                .show(ui, |ui| left(app, ui, panels, commands));
        }
    }
    if app.settings.inspector {
        Panel::right("inspector")
            .default_size((INSPECTOR * scale).round())
            .size_range(220.0..=widest.max(INSPECTOR * scale))
            // The scroll bar has the rest of the margin.
            .frame(frame.inner_margin(Margin {
                right: 6,
                ..margin(16)
            }))
            .show(ui, |ui| inspector::show(app, ui, state, commands));
    }
}
