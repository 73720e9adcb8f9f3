//! The inspector: pseudocode, watch table, cost.

use egui::{Role, TextStyle, WidgetInfo};

use crate::{
    figure::{CodeLinks, Frame, unseen},
    labs::CodeLine,
    widgets::{
        CodeStep, CodeText, Cost, Pseudocode, WatchTable, code_view_switch, cost, most_of_a_kind,
        quiet_button, rule, section, watch,
    },
};

use super::{
    App, Command, answers, bars::step_told, controls, prelude::*, stage_state::StageState,
    typing::told_of, why,
};

/// Of the panel's height the pseudocode takes more than this in smaller text, and this many points at least.
const CODE_PART: f32 = 0.42;
const CODE_LEAST: f32 = 96.0;
const WATCH_LEAST: f32 = 78.0;

/// Draws the panel. The room of its scroll bar is kept, also where there is none.
pub fn show(app: &App, ui: &mut Ui, state: &mut StageState, panels: &mut [Box<dyn LabPanel>]) {
    let room = ui.available_height();
    let width = ui.available_width() - ui.spacing().scroll.allocated_width();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.set_max_width(width);
        content(app, ui, state, (panels, room));
    });
}

/// What the panel is about: the method that was clicked last, where two stand side by side.
struct Inspected<'a> {
    /// Which of the runs.
    column: usize,
    frame: &'a Frame,
    moment: usize,
}

impl<'a> Inspected<'a> {
    fn of(app: &'a App, clicked: usize) -> Option<Self> {
        let frames = &app.playback.frames;
        let column = clicked.min(frames.len().saturating_sub(1));
        Some(Self {
            column,
            frame: frames.get(column)?,
            moment: app.playback.steps().get(column)?[0],
        })
    }
}

pub fn content(
    app: &App,
    ui: &mut Ui,
    state: &mut StageState,
    (panels, room): (&mut [Box<dyn LabPanel>], f32),
) {
    let Some(inspected) = Inspected::of(app, state.inspected) else {
        return;
    };
    let column = inspected.column;
    let look = app.look();
    let top = ui.cursor().top();
    if app.playback.frames.len() > 1 {
        methods(app, ui, column, &mut state.inspected);
    }
    code_heading(app, ui);
    let scalars = unseen(&inspected.frame.watch);
    let rows = state.watch.of(app.on_stage(), ui, column, &scalars);
    let table = rows.height;
    let lines = lines(app, column);
    let code = Pseudocode::new(ui, look, (&lines, app.shown.code), CODE_PART * room);
    // What stands below keeps its place: rows that are too many are scrolled by themselves.
    let id = Id::unique("inspector without its rows");
    let fixed: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let [code_most, watch_most] = shares(room - fixed, [code.height(), table]);
    let in_code = pseudocode(app, ui, state, (&code, code_most), &inspected);
    let in_table = watched(app, ui, state, (&scalars, watch_most), &inspected);
    controls::show(app, ui, panels);
    let is_told = why::show(app, ui, state.asked, &mut state.verdicts);
    // What it costs gives its place to what was asked.
    if !is_told {
        rule(ui, look);
        costs(app, ui, column);
    }
    asked(app, ui);
    let cost_of_all = || app.scene().document().cost_of_all(column);
    let of_all = state
        .all_costs
        .at(column)
        .get(app.on_stage(), ui, 0.0, cost_of_all);
    if let Some(of_all) = of_all.as_ref().filter(|_| !is_told && !app.hides_length()) {
        let text = RichText::new(look.catalog.message(of_all)).small();
        ui.add(Label::new(text.color(look.theme.soft)).wrap());
    }
    let scrolled = code.height().min(code_most) + table.min(watch_most);
    let now = ui.cursor().top() - top - scrolled;
    if (now - fixed).abs() > 0.5 {
        ui.data_mut(|data| data.insert_temp(id, now));
        ui.ctx().request_repaint();
    }
    state.pointed_in_inspector = in_table.or(in_code);
}

/// The lines, as many as have room in `most`; what the one under the pointer is about: at this step, or whenever it was
/// reached last.
fn pseudocode(
    app: &App,
    ui: &mut Ui,
    state: &mut StageState,
    (code, most): (&Pseudocode<'_>, f32),
    inspected: &Inspected<'_>,
) -> Option<Link> {
    let (column, frame, moment) = (inspected.column, inspected.frame, inspected.moment);
    let is_now = |link| frame.focus().any(|about| about == link);
    // What is asked about is not told by the line where it comes.
    let mut lit = match state.lit.filter(|_| !app.practice.is_asking()) {
        Some(link) => code_links(app, ui, state, column).lines(link),
        None => Vec::new(),
    };
    lit.extend(frame.code_line.filter(|_| state.lit.is_some_and(is_now)));
    let step = CodeStep {
        line: frame.code_line,
        moment,
        lit: &lit,
    };
    let line = code.show(ui, &step, most);
    if app.shown.code == CodeView::Hidden {
        ui.label(soft(app.look(), "pseudocode-hidden-note"));
    }
    let line = line?;
    let now = frame.focus().next();
    if let Some(link) = now.filter(|_| frame.code_line == Some(line)) {
        return Some(link);
    }
    let links = code_links(app, ui, state, column);
    links.of_line(line, moment)
}

fn watched(
    app: &App,
    ui: &mut Ui,
    state: &mut StageState,
    (scalars, most): (&Watch, f32),
    inspected: &Inspected<'_>,
) -> Option<Link> {
    let (column, frame, moment) = (inspected.column, inspected.frame, inspected.moment);
    let (look, lit) = (app.look_at_step(), state.lit);
    let room = state.watch.of(app.on_stage(), ui, column, scalars);
    if room.height <= 0.0 {
        return None;
    }
    rule(ui, look);
    section(ui, look, &look.say("panel-watch"));
    if frame.watch.iter().all(|section| section.rows.is_empty()) {
        let inner = UiBuilder::new().max_rect(ui.available_rect_before_wrap());
        ui.new_child(inner).label(soft(look, "watch-empty"));
    }
    let table = WatchTable {
        watch: scalars,
        room: (room, most),
        moment,
        lit,
        is_typed: &|link| told_of(app, scalars, link).is_some(),
    };
    let shown = ui.scope(|ui| watch(ui, look, &table)).inner;
    if let Some((link, at)) = shown.clicked
        && let Some(handle) = told_of(app, scalars, link)
    {
        app.push(Command::Type(Some(handle), Some(at)));
    }
    shown.pointed
}

/// The room of the lines of code and of the rows of the table: what they want, or of what is left as much as can be.
fn shares(left: f32, [code, table]: [f32; 2]) -> [f32; 2] {
    if code + table <= left {
        return [code, table];
    }
    let code = (left - table).max(CODE_LEAST.min(code));
    [code, (left - code).max(WATCH_LEAST.min(table))]
}

fn methods(app: &App, ui: &mut Ui, column: usize, inspected: &mut usize) {
    let look = app.look();
    let cards = app.scene().document().methods();
    for (i, (card, step)) in cards.into_iter().zip(app.playback.steps()).enumerate() {
        let is_current = i == column;
        // As at the last step, so that a name that takes two lines does so at all of them.
        let last = step_told(app, [step[1]; 2]);
        let last = ui.painter().layout_no_wrap(
            last,
            TextStyle::Small.resolve(ui.style()),
            look.theme.soft,
        );
        let (name, step) = (app.name_of(card), step_told(app, step));
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.scope(|ui| {
                    ui.set_min_width(last.size().x);
                    ui.label(RichText::new(&step).small().color(look.theme.soft));
                });
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let text = RichText::new(&name);
                    let text = if is_current {
                        text.text_style(theme::strong()).color(look.theme.ink)
                    } else {
                        text.color(look.theme.accent)
                    };
                    let response = quiet_button(ui, look, Button::new(text).wrap());
                    response.widget_info(|| {
                        let said = format!("{name}, {step}");
                        WidgetInfo::selected(Role::RadioButton, true, is_current, said)
                    });
                    if response.clicked() {
                        *inspected = i;
                    }
                });
            });
        });
    }
    rule(ui, look);
}

fn code_heading(app: &App, ui: &mut Ui) {
    let look = app.look();
    let switch = |ui: &mut Ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            app.push_all(code_view_switch(ui, look, app.shown.code).map(Command::Code));
        });
    };
    ui.horizontal(|ui| {
        section(ui, look, &look.say("panel-pseudocode"));
        if look.theme.text_scale <= 1.0 {
            switch(ui);
        }
    });
    if look.theme.text_scale > 1.0 {
        ui.horizontal(|ui| switch(ui));
    }
}

fn lines(app: &App, column: usize) -> Vec<CodeText> {
    let methods = app.scene().document().methods();
    let code = methods.get(column).map_or(&[][..], |card| card.code);
    let has_words = app.shown.code == CodeView::Words;
    let is_asking = app.practice.is_asking();
    let line = |&CodeLine { depth, code, words }: &CodeLine| {
        let said = app.look().say(if has_words { words } else { code });
        let line = CodeText::new(depth, said);
        match is_asking {
            // The sentence is the rule.
            true if has_words => CodeText { told: 0, ..line },
            true => line.without_rule(),
            false => line,
        }
    };
    code.iter().map(line).collect()
}

fn asked(app: &App, ui: &mut Ui) {
    if app.answers_told().is_empty() {
        return;
    }
    rule(ui, app.look());
    section(ui, app.look(), &app.look().say("answers-title"));
    answers::table(app, ui);
}

/// With the way to a measurement at its right, or under it where both have no room on one line.
fn costs_heading(app: &App, ui: &mut Ui) {
    let look = app.look();
    ui.horizontal_wrapped(|ui| {
        section(ui, look, &look.say("cost-title"));
        if !app.shown.measures {
            return;
        }
        let font = TextStyle::Small.resolve(ui.style());
        let words = look.say("cost-measure");
        let words = ui.painter().layout_no_wrap(words, font, look.theme.accent);
        let width = words.size().x.ceil();
        let spare = ui.available_size_before_wrap().x - width;
        ui.add_space(spare.max(0.0));
        let measure = accent(look, "cost-measure").small();
        if quiet_button(ui, look, Button::new(measure)).clicked() {
            app.push(Command::Measure(true));
        }
    });
}

fn costs(app: &App, ui: &mut Ui, column: usize) {
    let look = app.look();
    costs_heading(app, ui);
    let costs = app.playback.costs();
    let Some([now, end]) = costs.get(column).copied() else {
        return;
    };
    // While it is asked what comes, the bars do not tell what all of it costs.
    let end = if app.hides_length() { now } else { end };
    // Beside another method, both at this step; alone, with what brute force does in all.
    let methods = app.scene().document().methods();
    let mut others = costs.iter().zip(methods).enumerate();
    let beside = others.find(|(i, _)| *i != column);
    let beside = beside.map(|(_, ([counts, end], method))| (*counts, *end, method));
    let baseline = || {
        let (method, counts) = app.playback.baseline.filter(|_| !app.hides_length())?;
        Some((counts, counts, method))
    };
    let compared = beside.or_else(baseline);
    let compared = compared.filter(|_| !app.is_hunting());
    let name = |method: &MethodCard| app.name_of(method);
    let other_name = compared.map(|(.., method)| name(method));
    let other_name = other_name.unwrap_or_default();
    let shown = Cost {
        now,
        compared: compared.map(|(counts, _, _)| (counts, &*other_name)),
        most: most_of_a_kind(&[end, compared.map_or(end, |(_, end, _)| end)]),
    };
    ui.scope(|ui| cost(ui, look, &shown));
}

fn code_links<'a>(app: &App, ui: &Ui, state: &'a mut StageState, column: usize) -> &'a CodeLinks {
    let found = || app.playback.code_links(column);
    state
        .code_links
        .at(column)
        .get(app.on_stage(), ui, 0.0, found)
}
