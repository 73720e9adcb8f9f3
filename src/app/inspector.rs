//! The inspector: pseudocode, watch table, cost.

use egui::{Align, Id, Layout, RichText, ScrollArea, Ui};

use crate::{
    figure::{Frame, Link, Role, Watch, unseen},
    labs::MethodCard,
    lesson::CodeView,
    widgets::{
        CodeText, Cost, code_view_switch, cost, most_of_a_kind, pseudocode, rule, section, watch,
    },
};

use super::{Command, model::Model, stage_state::StageState};

/// Of the panel's height the pseudocode takes more than this in smaller text, and this many points at least.
const CODE_PART: f32 = 0.42;
const CODE_LEAST: f32 = 96.0;

/// Draws the panel.
pub fn show(model: &Model<'_>, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    let Some(frame) = model.playback.frames().first() else {
        return;
    };
    let lit = state.lit;
    let room = ui.available_height();
    let shown = ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| content(model, ui, (frame, lit), room, commands));
    state.pointed_in_inspector = shown.inner;
}

/// All that the panel holds, in a room of this height where that can be; what the pointer is on.
pub fn content(
    model: &Model<'_>,
    ui: &mut Ui,
    (frame, lit): (&Frame, Option<Link>),
    room: f32,
    commands: &mut Vec<Command>,
) -> Option<Link> {
    let look = model.look;
    let mut pointed = None;
    // Beside the heading where there is room for both, below it in large type.
    let switch = |ui: &mut Ui, commands: &mut Vec<Command>| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            commands.extend(code_view_switch(ui, look, model.code).map(Command::Code));
        });
    };
    ui.horizontal(|ui| {
        section(ui, look, &look.say("panel-pseudocode"));
        if look.theme.text_scale <= 1.0 {
            switch(ui, commands);
        }
    });
    if look.theme.text_scale > 1.0 {
        ui.horizontal(|ui| switch(ui, commands));
    }
    // What stands below keeps its place: lines that are too many are scrolled by themselves.
    let id = Id::unique("below the pseudocode");
    let below: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let top = ui.cursor().top();
    let most = (room - (top - ui.min_rect().top()) - below).max(CODE_LEAST);
    let code = ScrollArea::vertical()
        .id_salt("pseudocode")
        .max_height(most)
        .show(ui, |ui| {
            let lines = lines(model);
            let code = (&lines[..], model.code);
            pseudocode(ui, look, code, frame.code_line, CODE_PART * room)
        });
    if code.inner {
        // The line of this step is about what happens at this step.
        let mut signal = frame
            .marks()
            .iter()
            .filter(|mark| mark.role == Role::Signal);
        pointed = signal.find_map(|mark| mark.link);
    }
    let start = ui.min_rect().bottom();
    pointed = alive(model, ui, &frame.watch, lit).or(pointed);
    rule(ui, look);
    costs(model, ui, commands);
    let now = ui.min_rect().bottom() - start;
    if (now - below).abs() > 0.5 {
        ui.data_mut(|data| data.insert_temp(id, now));
        ui.ctx().request_repaint();
    }
    pointed
}

/// The values that are alive, but those that stand on the stage; the link of the one under the pointer.
fn alive(model: &Model<'_>, ui: &mut Ui, values: &Watch, lit: Option<Link>) -> Option<Link> {
    let look = model.look;
    let is_empty = |watch: &Watch| watch.iter().all(|section| section.rows.is_empty());
    let scalars = unseen(values);
    if is_empty(&scalars) && !is_empty(values) {
        return None;
    }
    rule(ui, look);
    section(ui, look, &look.say("panel-watch"));
    if is_empty(&scalars) {
        ui.label(RichText::new(look.say("watch-empty")).color(look.theme.soft));
    }
    ui.scope(|ui| watch(ui, look, &scalars, lit)).inner
}

fn lines(model: &Model<'_>) -> Vec<CodeText> {
    let code = model
        .scene
        .document()
        .methods()
        .first()
        .map_or(&[][..], |card| card.code);
    let line = |line: &crate::labs::CodeLine| CodeText {
        depth: line.depth,
        text: model.look.say(if model.code == CodeView::Words {
            line.words
        } else {
            line.code
        }),
    };
    code.iter().map(line).collect()
}

fn costs(model: &Model<'_>, ui: &mut Ui, commands: &mut Vec<Command>) {
    let look = model.look;
    ui.horizontal(|ui| {
        section(ui, look, &look.say("cost-title"));
        if model.measures {
            let measure = RichText::new(look.say("cost-measure"));
            let measure = measure.small().color(look.theme.accent);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if ui.add(egui::Button::new(measure).frame(false)).clicked() {
                    commands.push(Command::Measure(true));
                }
            });
        }
    });
    let costs = model.playback.costs();
    let Some([now, end]) = costs.first().copied() else {
        return;
    };
    // Beside another method, both at this step; alone, with what brute force does in all.
    let beside = costs
        .get(1)
        .zip(model.scene.document().methods().get(1).copied())
        .map(|([counts, end], method)| (*counts, *end, method));
    let baseline = || {
        let (method, counts) = model.playback.baseline()?;
        Some((counts, counts, method))
    };
    let compared = beside.or_else(baseline);
    let name = |method: &MethodCard| look.say(method.name_key);
    let other_name = compared
        .map(|(_, _, method)| name(method))
        .unwrap_or_default();
    let shown = Cost {
        now,
        compared: compared.map(|(counts, _, _)| (counts, &*other_name)),
        most: most_of_a_kind(&[end, compared.map_or(end, |(_, end, _)| end)]),
    };
    ui.scope(|ui| cost(ui, look, &shown));
}
