//! What the open step of a lesson that is made says, asks and locks.

use egui::{Role, TextEdit, WidgetInfo, accesskit::Live};

use crate::{
    lesson::{in_words, quoted},
    widgets::{code_view_switch, rule, tick_sign},
};

use super::{
    super::{Command, bars::step_text, prelude::*},
    Act, App, Compose,
};

pub fn show(app: &App, ui: &mut Ui) {
    let Some(compose) = app.composed() else {
        return;
    };
    let width = ui.available_width() - ui.spacing().scroll.allocated_width();
    ScrollArea::vertical()
        .id_salt("step that is made")
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.set_max_width(width);
            ui.spacing_mut().item_spacing.y = 6.0;
            head(app, ui, compose);
            outside(app, ui, compose);
            mistakes(app, ui, compose);
            rule(ui, app.look());
            texts(app, ui, compose);
            stands(app, ui);
            rule(ui, app.look());
            locks(app, ui, compose);
            switches(app, ui, compose);
            goal(app, ui, compose);
        });
}

fn act(app: &App, act: Act) {
    app.push(Command::Compose(act));
}

/// Words at the left, and at the right what is chosen about them.
fn row(ui: &mut Ui, words: RichText, content: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.label(words);
        ui.with_layout(Layout::right_to_left(Align::Center), content);
    });
}

fn head(app: &App, ui: &mut Ui, compose: &Compose) {
    let look = app.look();
    let title = RichText::new(look.say("compose-title")).text_style(theme::strong());
    row(ui, title, |ui| {
        if icon_button(ui, look, Icon::Close, &look.say("compose-leave"), true).clicked() {
            act(app, Act::Compose);
        }
        let tries = Button::new(accent(look, "compose-try"));
        if ui.add(tries).on_hover_text("F9").clicked() {
            act(app, Act::Try);
        }
    });
    let key = if compose.is_saved() {
        "compose-saved"
    } else {
        "compose-unsaved"
    };
    ui.label(soft(look, key).small());
}

/// What another program has made of the files, and whose version stays.
fn outside(app: &App, ui: &mut Ui, compose: &Compose) {
    let Some(theirs) = &compose.theirs else {
        return;
    };
    let look = app.look();
    let asks = RichText::new(look.say("compose-outside")).color(look.theme.signal_text);
    let label = ui.add(Label::new(asks).wrap());
    live(ui, label.id);
    for (file, line, text) in compose.draft().others(theirs) {
        let place = RichText::new(format!("{file}:{line}")).small();
        ui.label(place.color(look.theme.soft));
        ui.add(Label::new(RichText::new(text).monospace()).wrap());
    }
    ui.horizontal_wrapped(|ui| {
        for (key, takes_theirs) in [("compose-take-theirs", true), ("compose-keep-mine", false)] {
            if ui.button(look.say(key)).clicked() {
                act(app, Act::Settle(takes_theirs));
            }
        }
    });
}

fn mistakes(app: &App, ui: &mut Ui, compose: &Compose) {
    // That a goal is still to be dragged away from is said where the goal is set.
    let mut problems = compose.problems.iter();
    let Some(problem) = problems.find(|it| it.code() != "problem-goal-met") else {
        return;
    };
    let look = app.look();
    let said = app.listing(std::slice::from_ref(problem));
    let mut lines = said.lines();
    // The place without the folder, which stands beside the steps.
    let first = lines.next().unwrap_or_default();
    let first = first.rsplit(['/', '\\']).next().unwrap_or_default();
    let label = RichText::new(first).color(look.theme.signal_text);
    let label = ui.add(Label::new(label).wrap());
    live(ui, label.id);
    for line in lines {
        let words = RichText::new(line).monospace().small();
        ui.add(Label::new(words).truncate());
    }
    ui.add(Label::new(soft(look, "status-last-good").small()).wrap());
}

fn live(ui: &Ui, id: Id) {
    let live = |node: &mut egui::accesskit::Node| node.set_live(Live::Polite);
    ui.ctx().accesskit_node_builder(id, live);
}

fn texts(app: &App, ui: &mut Ui, compose: &Compose) {
    let look = app.look();
    ui.horizontal_wrapped(|ui| {
        for lang in Lang::ALL {
            let name = RichText::new(lang.native_name());
            let name = if compose.draft().speaks(lang) {
                name
            } else {
                name.color(look.theme.soft)
            };
            if ui.selectable_label(lang == compose.lang, name).clicked() {
                act(app, Act::Lang(lang));
            }
        }
    });
    let [mut title, mut body] = compose.draft().passage(&app.open_id(), compose.lang);
    let [_, step] = app.bookmark.at;
    let of = app.bookmark.lesson().map_or(0, |lesson| lesson.steps.len());
    let said = Message::new("compose-step-title")
        .with("n", step + 1)
        .with("total", of);
    let name = ui.label(
        RichText::new(look.catalog.message(&said))
            .color(look.theme.soft)
            .small(),
    );
    let field = TextEdit::singleline(&mut title).id(Id::unique("title that is made"));
    let field = ui.add(field.desired_width(f32::INFINITY).font(theme::strong()));
    if field.labelled_by(name.id).changed() {
        act(app, Act::Title(title));
    }
    let name = ui.label(soft(look, "compose-text").small());
    let field = TextEdit::multiline(&mut body).id(Id::unique("text that is made"));
    let field = ui.add(field.desired_width(f32::INFINITY).desired_rows(6));
    if field.labelled_by(name.id).changed() {
        act(app, Act::Body(body));
    }
    ui.add(Label::new(soft(look, "compose-text-how").small()).wrap());
}

fn stands(app: &App, ui: &mut Ui) {
    let look = app.look();
    let (run, position) = (app.playback.main(), app.position());
    let position = position.min(run.n_steps());
    row(ui, soft(look, "compose-stands"), |ui| {
        let n_steps = app.playback.transport.n_steps();
        let text = RichText::new(step_text(look, [position, n_steps])).small();
        ui.label(text.color(look.theme.soft));
    });
    ui.horizontal(|ui| {
        if position > 0 {
            let (rect, _) = ui.allocate_exact_size(vec2(14.0, 18.0), egui::Sense::hover());
            tick_sign(ui.painter(), rect.center(), run.tick(position), look.theme);
        }
        ui.label(RichText::new(run.shortest_moment(position).to_string()).monospace());
        ui.label(soft(look, "compose-follows").small());
    });
}

/// Groups of handles that the scene has and a lesson can lock.
fn locks(app: &App, ui: &mut Ui, compose: &Compose) {
    let (look, document) = (app.look(), app.scene().document());
    let held = compose.draft().list(&app.open_id(), "lock");
    let mut groups: Vec<&'static str> = Vec::new();
    for handle in document.handles() {
        let group = handle.group();
        if Lock::of(document.lab(), group).is_some() && !groups.contains(&group) {
            groups.push(group);
        }
    }
    ui.horizontal_wrapped(|ui| {
        ui.label(soft(look, "compose-locked"));
        for group in groups {
            let is_held = held.iter().any(|it| it == group);
            let response = ui.selectable_label(is_held, RichText::new(group).monospace());
            let name = format!("{}: {group}", look.say("compose-locked"));
            response.widget_info(|| WidgetInfo::selected(Role::Switch, true, is_held, &name));
            if response.clicked() {
                act(app, Act::Lock(group));
            }
        }
    });
}

fn switches(app: &App, ui: &mut Ui, compose: &Compose) {
    let (look, id, draft) = (app.look(), app.open_id(), compose.draft());
    let code = draft.word_of(&id, "code").unwrap_or_default();
    let mut codes = CodeView::ALL.into_iter();
    let code = codes.find(|it| it.id() == code).unwrap_or_default();
    row(ui, soft(look, "panel-pseudocode"), |ui| {
        let chosen = code_view_switch(ui, look, code);
        let spelt = |code: CodeView| (code != CodeView::Full).then(|| quoted(code.id()));
        app.push_all(chosen.map(|code| Command::Compose(Act::Set("code", spelt(code)))));
    });
    let asks = draft.field(&id, "ask");
    if switch(app, ui, "compose-ask", asks.is_some()) {
        let value = asks.is_none().then(|| "true".to_owned());
        act(app, Act::Set("ask", value));
    }
    if asks.is_some() {
        ui.indent("what is asked", |ui| {
            for (key, value) in [
                ("compose-ask-decision", "true"),
                ("compose-ask-run", "\"run\""),
            ] {
                if ui.radio(asks == Some(value), look.say(key)).clicked() {
                    act(app, Act::Set("ask", Some(value.to_owned())));
                }
            }
        });
    }
    let figure = draft.word_of(&id, "figure");
    if switch(app, ui, "compose-figure", figure.is_some()) {
        act(
            app,
            Act::Set("figure", figure.is_none().then(|| quoted(&id))),
        );
    }
    if let Some(figure) = figure {
        let changed = |name: String| Act::Set("figure", Some(quoted(&name)));
        named(app, ui, ("compose-figure-name", &figure), changed);
    }
    named(app, ui, ("compose-id", &id), Act::Name);
}

/// Is it to be turned?
fn switch(app: &App, ui: &mut Ui, key: &str, mut is_on: bool) -> bool {
    ui.checkbox(&mut is_on, app.look().say(key)).changed()
}

/// A name in a field, which changes when Enter is pressed or the focus goes.
fn named(app: &App, ui: &mut Ui, (key, name): (&str, &str), changed: impl FnOnce(String) -> Act) {
    let id = Id::unique((key, name));
    let known: Option<String> = ui.data(|data| data.get_temp(id));
    let mut written = known.unwrap_or_else(|| name.to_owned());
    ui.horizontal(|ui| {
        let label = ui.label(soft(app.look(), key).small());
        let field = TextEdit::singleline(&mut written)
            .id(id.with("field"))
            .desired_width(f32::INFINITY);
        let field = ui
            .add(field.font(egui::TextStyle::Monospace))
            .labelled_by(label.id);
        if field.changed() {
            ui.data_mut(|data| data.insert_temp(id, written.clone()));
        }
        if field.lost_focus() {
            ui.data_mut(|data| data.remove::<String>(id));
            if written != name {
                act(app, changed(written));
            }
        }
    });
}

fn goal(app: &App, ui: &mut Ui, compose: &Compose) {
    let (look, id) = (app.look(), app.open_id());
    let parts = compose.draft().list(&id, "goal");
    if switch(app, ui, "compose-goal", !parts.is_empty()) {
        act(app, Act::Goal(parts.is_empty()));
    }
    if parts.is_empty() {
        return;
    }
    ui.indent("parts of the goal", |ui| {
        ui.add(Label::new(soft(look, "compose-goal-how").small()).wrap());
        let others = compose.offered.1.iter().filter(|it| !parts.contains(it));
        for part in parts.iter().chain(others) {
            let mut is_part = parts.contains(part);
            let words = in_words(part, look.catalog.lang());
            let spelt = RichText::new(part).monospace();
            let response = ui.checkbox(&mut is_part, words);
            if response.on_hover_text(spelt).changed() {
                act(app, Act::Condition(part.clone()));
            }
        }
    });
}
