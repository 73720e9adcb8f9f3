//! What asks for a file or a name before it is done.

use egui::{Grid, TextEdit};

use crate::{
    app::{App, Command, Dialog, Figures, desk::SceneAct, exports::ending_of, prelude::*},
    widgets::{select, theme_key},
};

use super::modal::{heading, modal};

pub(super) fn path(app: &App, ctx: &Context, dialog: &Dialog) {
    let look = app.look();
    let mut changed = dialog.clone();
    let (key, action, target, figures) = match &mut changed {
        Dialog::Open(target) => ("open-title", "action-open-it", target, None),
        Dialog::Save(target) => ("save-title", "action-save", target, None),
        Dialog::Lesson(target) => ("lesson-save-title", "action-save", target, None),
        Dialog::Export(target, figures) => ("export-title", "action-export", target, Some(figures)),
        Dialog::HandIn(target) => ("hand-in-title", "action-save", target, None),
        Dialog::TakeUp(target) => ("take-up-title", "action-open-it", target, None),
        Dialog::Help | Dialog::Scene(..) | Dialog::Progress(_) => return,
    };
    let is_folder = matches!(dialog, Dialog::Lesson(_));
    let label = if is_folder {
        "save-folder"
    } else {
        "save-path"
    };
    let action = if target.replaces {
        "action-replace"
    } else {
        action
    };
    let response = modal("path", look).show(ctx, |ui| {
        ui.set_max_width((ctx.content_rect().width() - 64.0).clamp(120.0, 480.0));
        heading(app, ui, key);
        ui.add_space(8.0);
        if let Some(figures) = figures {
            choices(app, ui, figures, &mut target.path);
        }
        let entered = text_field(ui, look, label, &mut target.path);
        if target.replaces {
            ui.label(look.say("save-exists"));
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let is_ready = !target.path.trim().is_empty();
            go_and_cancel(app, ui, action, (entered, is_ready));
            if app.has_dialog(false) && ui.button(look.say("action-browse")).clicked() {
                app.push(Command::Browse);
            }
        });
    });
    if changed != *dialog {
        if let Some(target) = changed.target_mut() {
            target.replaces = false;
        }
        show_changed(app, changed);
    } else if response.should_close() {
        app.push(Command::Show(None));
    }
}

pub(super) fn scene(app: &App, ctx: &Context, act: SceneAct, name: &str) {
    const MOST_LETTERS: usize = 60;
    let look = app.look();
    let mut changed = name.to_owned();
    let response = modal("scene", look).show(ctx, |ui| {
        ui.set_max_width((ctx.content_rect().width() - 64.0).clamp(120.0, 480.0));
        heading(app, ui, act.key());
        ui.add_space(8.0);
        let is_free = app.takes_name(act, name);
        let entered = if act == SceneAct::Delete {
            let asked = Message::new("scene-delete-asks").with("name", name.to_owned());
            ui.add(Label::new(look.catalog.message(&asked)).wrap());
            let has_focus = ui.memory(|memory| memory.focused().is_some());
            !has_focus && ui.input(|input| input.key_pressed(Key::Enter))
        } else {
            text_field(ui, look, "scene-name", &mut changed)
        };
        if !is_free {
            ui.label(look.say("scene-name-taken"));
        }
        ui.add_space(8.0);
        let is_ready = is_free && !name.trim().is_empty();
        let answers = (entered, is_ready);
        ui.horizontal(|ui| go_and_cancel(app, ui, act.button_key(), answers));
    });
    if changed != name {
        let changed = changed.chars().take(MOST_LETTERS).collect();
        show_changed(app, Dialog::Scene(act, changed));
    } else if response.should_close() {
        app.push(Command::Show(None));
    }
}

/// The button that does it, where it is ready, and the one that does not.
fn go_and_cancel(app: &App, ui: &mut Ui, action: &str, (entered, is_ready): (bool, bool)) {
    let look = app.look();
    let text = RichText::new(look.say(action))
        .text_style(theme::strong())
        .color(look.theme.background);
    let go = Button::new(text).fill(look.theme.accent);
    if (ui.add_enabled(is_ready, go).clicked() || entered) && is_ready {
        app.push(Command::Confirm);
    }
    if ui.button(look.say("action-cancel")).clicked() {
        app.push(Command::Show(None));
    }
}

/// What is written in a dialog now, before a press of its button, so that it does what is chosen now.
fn show_changed(app: &App, changed: Dialog) {
    let mut commands = app.commands.borrow_mut();
    commands.insert(0, Command::Show(Some(changed)));
}

/// A field with this name; has Enter been pressed in it?
fn text_field(ui: &mut Ui, look: Look<'_>, key: &str, written: &mut String) -> bool {
    let label = ui.label(soft(look, key));
    let field = TextEdit::singleline(written)
        .desired_width(f32::INFINITY)
        .font(egui::TextStyle::Monospace);
    let field = ui.add(field).labelled_by(label.id);
    let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if !field.has_focus() && !entered && ui.memory(|memory| memory.focused().is_none()) {
        field.request_focus();
        select_name(ui.ctx(), field.id, written);
    }
    entered
}

/// Selects the file's name in the field of its path, without folder and ending: what is typed first replaces it.
fn select_name(ctx: &Context, field: Id, path: &str) {
    let name = path.rfind(['/', '\\']).map_or(0, |at| at + 1);
    let end = path[name..].rfind('.').map_or(path.len(), |at| name + at);
    let [start, end] = [name, end].map(|byte| path[..byte].chars().count());
    select(ctx, field, start..end);
}

/// What figures look like, and how large the file becomes, of which the ending says the format.
fn choices(app: &App, ui: &mut Ui, figures: &mut Figures, path: &mut String) {
    let look = app.look();
    let formats = app.platform.formats();
    let mut format = ending_of(path).to_lowercase();
    let names = formats
        .iter()
        .map(|it| ((*it).to_owned(), it.to_uppercase()));
    let weight = app.weight(*figures);
    let sizes = Figures::SIZES.map(|size| (size, format!("{} × {}", size[0], size[1])));
    let themes = ThemeKind::ALL.map(|kind| (kind, look.say(theme_key(kind))));
    let langs = Lang::ALL.map(|lang| (lang, lang.native_name().to_owned()));
    let steps = [(false, "export-this-step"), (true, "export-all-steps")];
    let steps = steps.map(|(all, key)| (all, look.say(key)));
    Grid::new("figures")
        .num_columns(2)
        .spacing(vec2(16.0, 4.0))
        .show(ui, |ui| {
            if formats.len() > 1 {
                choice(ui, look, "export-format", (&mut format, names.collect()));
            }
            choice(
                ui,
                look,
                "export-size",
                (&mut figures.size_px, sizes.into()),
            );
            choice(
                ui,
                look,
                "settings-theme",
                (&mut figures.theme, themes.into()),
            );
            choice(
                ui,
                look,
                "export-language",
                (&mut figures.lang, langs.into()),
            );
            choice(ui, look, "export-steps", (&mut figures.all, steps.into()));
            if let Some((n_bytes, n_files)) = weight {
                ui.label(soft(look, "export-weight"));
                let message = Message::new("export-weight-of").with("size", n_bytes.div_ceil(1000));
                let message = message.with("count", n_files);
                ui.label(look.catalog.message(&message));
                ui.end_row();
            }
        });
    if formats.contains(&&*format) && format != ending_of(path).to_lowercase() {
        let stem = path.len() - ending_of(path).len();
        path.truncate(stem);
        path.push_str(&format);
    }
}

/// A row of the grid: a name, and what there is to choose of.
fn choice<T: PartialEq>(
    ui: &mut Ui,
    look: Look<'_>,
    key: &str,
    (chosen, all): (&mut T, Vec<(T, String)>),
) {
    ui.label(soft(look, key));
    ui.horizontal_wrapped(|ui| {
        for (value, words) in all {
            ui.selectable_value(chosen, value, words);
        }
    });
    ui.end_row();
}
