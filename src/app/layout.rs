//! Where everything stands: five places in a wide window, one at a time in a narrow one.

use egui::{CentralPanel, Frame, Margin, Panel, Ui, Vec2};

use crate::{
    panels::LabPanel,
    widgets::{Icon, transport_width},
};

use super::{
    App, Command, bars, course_panel, inspector, model::Model, overlays, stage,
    stage_state::StageState,
};

/// In windows narrower than this, in points, the course and the inspector take the stage's place.
const NARROW: f32 = 860.0;
/// Widths of the side panels: they leave the stage 60 % of 1280.
const COURSE: f32 = 216.0;
const INSPECTOR: f32 = 296.0;

/// What a narrow window shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Room {
    /// The stage.
    Stage,
    /// The course.
    Course,
    /// The inspector.
    Inspector,
}

impl Room {
    /// Opens a place, or the stage where it is open already.
    #[must_use]
    pub fn toggled(self, to: Self) -> Self {
        if self == to { Self::Stage } else { to }
    }
}

/// Is a window of this size narrow?
#[must_use]
pub fn is_narrow(size: Vec2) -> bool {
    size.x < NARROW
}

/// Draws the window; what is asked for is pushed onto `commands`.
pub fn show(app: &mut App, ui: &mut Ui, commands: &mut Vec<Command>) {
    let size = ui.ctx().content_rect().size();
    let mut stage_state = std::mem::take(&mut app.stage);
    (
        stage_state.pointed_on_stage,
        stage_state.pointed_in_inspector,
    ) = (None, None);
    let measures = app.measures();
    let mut panels = std::mem::take(&mut app.kit.panels);
    let model = Model {
        measures,
        ..app.model(size)
    };
    let room = if model.is_narrow {
        app.shown.room
    } else {
        Room::Stage
    };
    if app.shown.presenting {
        presentation(&model, ui, &mut stage_state, commands);
    } else {
        top(&model, ui, &mut panels, room, commands);
        bottom(&model, ui, commands);
        if !model.is_narrow {
            sides(&model, ui, &mut stage_state, commands);
        }
        let panel = Frame::new().fill(model.look.theme.panel).inner_margin(16);
        match room {
            Room::Stage => centre(&model, ui, &mut stage_state, commands),
            Room::Course => {
                CentralPanel::no_frame()
                    .frame(panel)
                    .show(ui, |ui| course_panel::show(&model, ui, commands));
            }
            Room::Inspector => {
                CentralPanel::no_frame().frame(panel).show(ui, |ui| {
                    inspector::show(&model, ui, &mut stage_state, commands);
                });
            }
        }
    }
    stage_state.lit = stage_state
        .pointed_on_stage
        .or(stage_state.pointed_in_inspector);
    app.stage = stage_state;
    app.kit.panels = panels;
    overlays::show(app, ui, commands);
}

fn centre(model: &Model<'_>, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    CentralPanel::no_frame().show(ui, |ui| stage::show(model, ui, state, commands));
}

/// Stage, caption, and the smallest transport there is.
fn presentation(
    model: &Model<'_>,
    ui: &mut Ui,
    state: &mut StageState,
    commands: &mut Vec<Command>,
) {
    let frame = Frame::new()
        .fill(model.look.theme.panel)
        .inner_margin(Margin::symmetric(16, 0));
    Panel::bottom("small transport")
        .exact_size(40.0)
        .frame(frame)
        .show(ui, |ui| {
            bars::small_transport(model, ui, commands);
        });
    centre(model, ui, state, commands);
}

fn top(
    model: &Model<'_>,
    ui: &mut Ui,
    panels: &mut [Box<dyn LabPanel>],
    room: Room,
    commands: &mut Vec<Command>,
) {
    let scale = model.look.theme.text_scale.sqrt();
    let height = if model.is_low { 36.0 } else { 44.0 * scale };
    let margin = if model.is_narrow { 8 } else { 16 };
    let frame = Frame::new()
        .fill(model.look.theme.panel)
        .inner_margin(Margin::symmetric(margin, 0));
    Panel::top("top bar")
        .exact_size(height.round())
        .frame(frame)
        .show(ui, |ui| {
            bars::top(model, ui, panels, room, COURSE, commands);
        });
}

fn bottom(model: &Model<'_>, ui: &mut Ui, commands: &mut Vec<Command>) {
    let height = if model.is_low { 40.0 } else { 56.0 };
    let margin = if model.is_narrow { 4 } else { 12 };
    let frame = Frame::new()
        .fill(model.look.theme.panel)
        .inner_margin(Margin::symmetric(margin, 0));
    Panel::bottom("transport")
        .exact_size(height)
        .frame(frame)
        .show(ui, |ui| {
            bars::transport(model, ui, commands);
        });
}

fn sides(model: &Model<'_>, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    let width = ui.ctx().content_rect().width();
    let widest = 0.28 * width;
    // Larger text wants wider panels, as far as three fifths are left to the stage.
    let scale = model.look.theme.text_scale.sqrt();
    let scale = scale.min(0.4 * width / (COURSE + INSPECTOR)).max(1.0);
    let frame = Frame::new().fill(model.look.theme.panel);
    if model.settings.course {
        Panel::left("course")
            .default_size((COURSE * scale).round())
            .size_range(160.0..=widest.max(COURSE * scale))
            .frame(frame.inner_margin(Margin {
                left: 8,
                right: 8,
                top: 12,
                bottom: 8,
            }))
            .show(ui, |ui| course_panel::show(model, ui, commands));
    }
    if model.settings.inspector {
        Panel::right("inspector")
            .default_size((INSPECTOR * scale).round())
            .size_range(220.0..=widest.max(INSPECTOR * scale))
            .frame(frame.inner_margin(Margin {
                left: 16,
                right: 16,
                top: 12,
                bottom: 8,
            }))
            .show(ui, |ui| inspector::show(model, ui, state, commands));
    }
}

/// Is there room in `width` for the transport, a timeline and what stands after it?
pub fn transport_has_room(width: f32) -> bool {
    width > transport_width() + 260.0
}

/// The signs of the buttons that show and hide the side panels.
pub const SIDES: [(Icon, &str, Command); 2] = [
    (Icon::LeftPanel, "panel-course", Command::Course),
    (Icon::RightPanel, "panel-inspector", Command::Inspector),
];
