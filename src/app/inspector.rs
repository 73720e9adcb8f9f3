//! The inspector: pseudocode, watch table, cost.

use egui::{Align, Layout, RichText, ScrollArea, Ui};

use crate::{
    figure::{Role, unseen},
    labs::MethodCard,
    lesson::CodeView,
    widgets::{
        CodeLine, Cost, code_view_switch, cost, most_of_a_kind, pseudocode, rule, section, watch,
    },
};

use super::{Command, model::Model, stage_state::StageState};

/// Draws the panel.
pub fn show(model: &Model<'_>, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    let look = model.look;
    let Some(frame) = model.playback.frames().first() else {
        return;
    };
    let lit = state.lit;
    let mut pointed = None;
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
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
        let lines = lines(model);
        if ui
            .scope(|ui| pseudocode(ui, look, &lines, model.code, frame.code_line))
            .inner
        {
            // The line of this step is about what happens at this step.
            let mut signal = frame
                .marks()
                .iter()
                .filter(|mark| mark.role == Role::Signal);
            pointed = signal.find_map(|mark| mark.link);
        }
        rule(ui, look);
        section(ui, look, &look.say("panel-watch"));
        let scalars = unseen(&frame.watch);
        if scalars.iter().all(|section| section.rows.is_empty()) {
            ui.label(RichText::new(look.say("watch-empty")).color(look.theme.soft));
        }
        pointed = ui
            .scope(|ui| watch(ui, look, &scalars, lit))
            .inner
            .or(pointed);
        rule(ui, look);
        costs(model, ui, commands);
    });
    state.pointed_in_inspector = pointed;
}

fn lines(model: &Model<'_>) -> Vec<CodeLine> {
    let code = model
        .scene
        .document()
        .methods()
        .first()
        .map_or(&[][..], |card| card.code);
    let line = |line: &crate::labs::CodeLine| CodeLine {
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
    section(ui, look, &look.say("cost-title"));
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
    if !model.measures {
        return;
    }
    ui.add_space(4.0);
    let measure = RichText::new(look.say("cost-measure"))
        .small()
        .color(look.theme.accent);
    if ui.add(egui::Button::new(measure).frame(false)).clicked() {
        commands.push(Command::Measure(true));
    }
}
