//! Where everything stands: five places in a wide window, one at a time in a narrow one.

use egui::{CentralPanel, Frame, Panel};

use crate::widgets::TARGET;

use super::{
    App, bars, compose, controls, course_panel, free_panel, inspector, notice, overlays, pen,
    phone, practice_panel,
    prelude::*,
    question, recording,
    room::{BESIDE_TRANSPORT, COURSE, CoursePart, INSPECTOR, Room},
    speaker, stage,
    stage_state::StageState,
    typing, why,
};

/// Width of the course folded to the numbers of its steps.
const STRIP: f32 = 48.0;

pub fn show(app: &App, ui: &mut Ui, state: &mut StageState, panels: &mut [Box<dyn LabPanel>]) {
    (state.pointed_on_stage, state.pointed_in_inspector) = (None, None);
    if app.is_presenting() {
        presentation(app, ui, state, panels);
    } else {
        if app.is_phone() {
            one_hand(app, ui, panels);
        } else {
            top(app, ui, panels);
            bottom(app, ui);
        }
        if !app.is_narrow() {
            sides(app, ui, state, panels);
        }
        state.taken = notice::show(app, ui);
        opened(app, ui, state, panels);
    }
    let pointed = state.pointed_on_stage.or(state.pointed_in_inspector);
    // What is asked about stays lit when the pointer is elsewhere.
    state.lit = pointed.or(state.asked.map(|(about, _)| about));
    if let Some(mut typed) = state.typing.take() {
        let place = app.scene().document().position(typed.handle);
        let at_handle = || place.and_then(|place| state.on_screen(place));
        if let Some(at) = typed.at.or_else(at_handle) {
            typing::show(app, ui.ctx(), (&mut typed, at));
            state.typing = Some(typed);
        }
    }
    overlays::show(app, ui, panels);
    if app.shown.has_notes {
        speaker::show(app, ui.ctx());
    }
}

/// The stage, or what has taken its place.
fn opened(app: &App, ui: &mut Ui, state: &mut StageState, panels: &mut [Box<dyn LabPanel>]) {
    let room = app.room();
    if room == Room::Stage {
        let pointed = practice_panel::show(app, ui, state.lit);
        state.pointed_in_inspector = state.pointed_in_inspector.or(pointed);
        if app.is_phone() {
            phone::sheet(app, ui);
        } else if app.asks_on_stage() && !app.practice.asks_for_a_step() {
            question::show(app, ui);
        }
        centre(app, ui, state);
        return;
    }
    let frame = Frame::new().fill(app.look().theme.panel).inner_margin(16);
    CentralPanel::no_frame().frame(frame).show(ui, |ui| {
        if app.is_phone() {
            phone::way_back(app, ui);
        }
        if room == Room::Course {
            left(app, ui, panels);
            return;
        }
        if app.is_phone() {
            ui.horizontal(|ui| bars::pickers(app, ui));
        }
        right(app, ui, state, panels);
    });
}

fn centre(app: &App, ui: &mut Ui, state: &mut StageState) {
    CentralPanel::no_frame().show(ui, |ui| {
        let rect = ui.max_rect();
        stage::show(app, ui, state);
        if !app.has_inspector_beside() {
            // Over the caption.
            let captions = state.laid.iter().flat_map(|laid| &laid.columns);
            let foot = captions
                .map(|column| column.caption.min[1])
                .reduce(f32::min);
            let views = rect.with_max_y(foot.unwrap_or(rect.bottom()));
            why::on_stage(app, ui, (views, state.asked), &mut state.verdicts);
        }
        recording::show(app, ui, rect);
    });
}

fn presentation(app: &App, ui: &mut Ui, state: &mut StageState, panels: &mut [Box<dyn LabPanel>]) {
    let height = (40.0 * app.enlarged()).max(least_bar(app));
    let bar = Panel::bottom("small transport").exact_size(height);
    bar.frame(bar_frame(app, 16))
        .show(ui, |ui| bars::small_transport(app, ui));
    let pointed = practice_panel::show(app, ui, state.lit);
    state.pointed_in_inspector = state.pointed_in_inspector.or(pointed);
    if !app.practice.is_on && app.practice.asked.is_none() {
        question::show(app, ui);
    }
    state.taken = notice::show(app, ui);
    if app.shown.controls.are_presented() {
        let frame = Frame::new().fill(app.look().theme.panel);
        Panel::right("presented controls")
            .default_size((INSPECTOR * app.look().theme.text_scale.sqrt()).round())
            .frame(frame.inner_margin(16))
            .show(ui, |ui| controls::show(app, ui, panels));
    }
    centre(app, ui, state);
    pen::show(app, ui, &mut state.pen);
}

fn bar_frame(app: &App, margin: i8) -> Frame {
    let frame = Frame::new().fill(app.look().theme.panel);
    frame.inner_margin(Margin::symmetric(margin, 0))
}

/// What fingers press has room in a bar.
fn least_bar(app: &App) -> f32 {
    if app.has_fingers() { TARGET + 4.0 } else { 0.0 }
}

fn top(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let scale = app.look().theme.text_scale.sqrt();
    let low = 36.0 * app.enlarged();
    let height = if app.is_low() { low } else { 44.0 * scale };
    let margin = if app.is_narrow() { 8 } else { 16 };
    let bar = Panel::top("top bar").exact_size(height.max(least_bar(app)).round());
    bar.frame(bar_frame(app, margin))
        .show(ui, |ui| bars::top(app, ui, panels));
}

fn one_hand(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let [over, under] = phone::BARS.map(|height| (height * app.enlarged()).round());
    let top = Panel::top("top bar").exact_size(over);
    top.frame(bar_frame(app, 4))
        .show(ui, |ui| phone::top(app, ui, panels));
    let bottom = Panel::bottom("transport").exact_size(under);
    bottom
        .frame(bar_frame(app, 12))
        .show(ui, |ui| phone::transport(app, ui));
}

fn bottom(app: &App, ui: &mut Ui) {
    let height = if app.is_low() { 40.0 } else { 56.0 };
    let margin = if app.is_narrow() {
        BESIDE_TRANSPORT
    } else {
        12
    };
    let height = (height * app.enlarged()).max(least_bar(app));
    let bar = Panel::bottom("transport").exact_size(height);
    bar.frame(bar_frame(app, margin))
        .show(ui, |ui| bars::transport(app, ui));
}

fn left(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    if app.bookmark.free.is_some() {
        free_panel::show(app, ui, panels);
    } else if app.composed().is_some() {
        compose::steps(app, ui);
    } else {
        compose::tried(app, ui);
        course_panel::show(app, ui);
    }
}

fn right(app: &App, ui: &mut Ui, state: &mut StageState, panels: &mut [Box<dyn LabPanel>]) {
    if app.composed().is_some() {
        compose::step(app, ui);
    } else {
        inspector::show(app, ui, state, panels);
    }
}

fn sides(app: &App, ui: &mut Ui, state: &mut StageState, panels: &mut [Box<dyn LabPanel>]) {
    let width = ui.ctx().content_rect().width();
    let widest = 0.28 * width;
    let scale = app.look().theme.text_scale.sqrt();
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
                .show(ui, |ui| course_panel::strip(app, ui));
        }
        CoursePart::Whole => {
            Panel::left("course")
                .default_size((COURSE * scale).round())
                .size_range(160.0..=widest.max(COURSE * scale))
                .frame(frame.inner_margin(margin(8)))
                .show(ui, |ui| left(app, ui, panels));
        }
    }
    if app.has_inspector_beside() {
        Panel::right("inspector")
            .default_size((INSPECTOR * scale).round())
            .size_range(220.0..=widest.max(INSPECTOR * scale))
            // The scroll bar has the rest of the margin.
            .frame(frame.inner_margin(Margin {
                right: 6,
                ..margin(16)
            }))
            .show(ui, |ui| right(app, ui, state, panels));
    }
}
