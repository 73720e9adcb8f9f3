//! What lies over the window: the list of keys, where to save, measured costs.

use egui::{Frame, Grid, KeyboardShortcut, Modal, TextEdit};

use crate::widgets::{select, theme_key};

use super::{
    App, BINDINGS, Command, Dialog, Figures, desk::SceneAct, exports::ending_of, prelude::*,
    progress_page,
};

const WIDTH: f32 = 528.0;
/// Of its width the keys take so much.
const KEYS: f32 = 0.32;
/// What an arrow key scrolls.
const LINE: f32 = 40.0;
/// Keys that are no commands.
const OTHER_KEYS: [(&str, &str); 7] = [
    ("Tab", "help-tab"),
    ("↑ ↓ ← →", "help-nudge"),
    (".  ,", "help-deeper"),
    ("X  Y  Z", "help-axis"),
    ("Shift  Alt", "help-alt"),
    ("B", "help-pen"),
    ("Enter", "help-verdict"),
];

pub fn show(app: &App, ui: &Ui, panels: &mut [Box<dyn LabPanel>]) {
    let ctx = ui.ctx();
    if app.shown.is_measuring {
        measure(app, ctx, panels);
    }
    match app.shown.dialog.as_ref() {
        Some(Dialog::Help) => help(app, ctx),
        Some(Dialog::Scene(act, name)) => scene_dialog(app, ctx, *act, name),
        Some(Dialog::Progress(is_sure)) => progress(app, ctx, *is_sure),
        Some(dialog) => path_dialog(app, ctx, dialog),
        None => {}
    }
}

fn modal(id: &str, look: Look<'_>) -> Modal {
    let frame = Frame::new()
        .fill(look.theme.background)
        .stroke(Stroke::new(1.0, look.theme.hairline))
        .corner_radius(8)
        .inner_margin(24);
    Modal::new(Id::unique(id)).frame(frame)
}

fn help(app: &App, ctx: &Context) {
    let look = app.look();
    let response = modal("help", look).show(ctx, |ui| {
        let height = (ctx.content_rect().height() - 120.0).max(60.0);
        let width = (WIDTH * look.theme.text_scale).min(ctx.content_rect().width() - 64.0);
        ui.set_max_width(width);
        heading(app, ui, "help-title");
        ScrollArea::vertical()
            .max_height(height)
            .min_scrolled_height(height)
            .show(ui, |ui| {
                scroll_by_keys(ui, height);
                let others = OTHER_KEYS.map(|(keys, help)| (in_language(look, keys), help));
                for (keys, help) in lines(look, ctx).into_iter().chain(others) {
                    ui.horizontal_top(|ui| {
                        let keys = RichText::new(keys).monospace().color(look.theme.ink);
                        let column = vec2(KEYS * width, 0.0);
                        ui.allocate_ui(column, |ui| {
                            ui.set_min_width(column.x);
                            ui.add(Label::new(keys).wrap());
                        });
                        ui.add(Label::new(soft(look, help)).wrap());
                    });
                }
                ui.add_space(8.0);
                for note in ["help-drag", "help-edge", "help-turn"] {
                    ui.add(Label::new(soft(look, note)).wrap());
                }
            });
    });
    if response.should_close() {
        app.push(Command::Show(None));
    }
}

fn progress(app: &App, ctx: &Context, is_sure: bool) {
    let response = modal("progress", app.look()).show(ctx, |ui| {
        heading(app, ui, "progress-title");
        progress_page::show(app, ui, is_sure);
    });
    if response.should_close() {
        app.push(Command::Show(None));
    }
}

/// The keys of a page scroll what is in it, as the wheel does.
fn scroll_by_keys(ui: &Ui, height: f32) {
    let page = 0.9 * height;
    let keys = [
        (Key::ArrowDown, -LINE),
        (Key::ArrowUp, LINE),
        (Key::PageDown, -page),
        (Key::PageUp, page),
        (Key::End, f32::MIN),
        (Key::Home, f32::MAX),
    ];
    for (key, by) in keys {
        if ui.input(|input| input.key_pressed(key)) {
            ui.scroll_with_delta(vec2(0.0, by));
        }
    }
}

fn heading(app: &App, ui: &mut Ui, key: &str) {
    let look = app.look();
    let size = vec2(
        ui.available_width().min(WIDTH * look.theme.text_scale),
        32.0,
    );
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        if icon_button(ui, look, Icon::Close, &look.say("action-close"), true).clicked() {
            app.push(Command::Show(None));
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.label(RichText::new(look.say(key).trim_end_matches('…')).heading());
        });
    });
}

fn lines(look: Look<'_>, ctx: &Context) -> Vec<(String, &'static str)> {
    let mut lines: Vec<(String, &'static str)> = Vec::new();
    let shown = BINDINGS.iter().filter(|(_, key, ..)| *key != Key::Equals);
    for &(modifiers, key, _, help) in shown {
        let key = written(look, ctx, modifiers, key);
        match lines.last_mut() {
            Some((known, of)) if *of == help => *known = format!("{known}  {key}"),
            _ => lines.push((key, help)),
        }
    }
    lines
}

fn written(look: Look<'_>, ctx: &Context, modifiers: Modifiers, key: Key) -> String {
    let shortcut = |key: Key| {
        let whole = ctx.format_shortcut(&KeyboardShortcut::new(modifiers, key));
        in_language(look, &whole)
    };
    let name = sign(key).map(str::to_owned);
    let name = name.or_else(|| named(key).map(|name| look.say(name)));
    name.map_or_else(
        || shortcut(key),
        |name| format!("{}{name}", shortcut(Key::A).trim_end_matches('A')),
    )
}

const fn sign(key: Key) -> Option<&'static str> {
    Some(match key {
        Key::ArrowLeft => "←",
        Key::ArrowRight => "→",
        Key::Questionmark => "?",
        Key::Plus => "+",
        Key::Minus => "−",
        _ => return None,
    })
}

fn in_language(look: Look<'_>, keys: &str) -> String {
    let keys = keys.replace("Shift", &look.say("key-shift"));
    keys.replace("Enter", &look.say("key-enter"))
}

/// What is written on a key, in each language.
const fn named(key: Key) -> Option<&'static str> {
    Some(match key {
        Key::Space => "key-space",
        Key::Enter => "key-enter",
        Key::Escape => "key-escape",
        Key::Delete => "key-delete",
        Key::Insert => "key-insert",
        Key::Home => "key-home",
        Key::End => "key-end",
        Key::PageUp => "key-page-up",
        Key::PageDown => "key-page-down",
        Key::Backspace => "key-backspace",
        _ => return None,
    })
}

fn path_dialog(app: &App, ctx: &Context, dialog: &Dialog) {
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
        let entered = text_field(ui, look, "save-path", &mut target.path);
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

fn scene_dialog(app: &App, ctx: &Context, act: SceneAct, name: &str) {
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

fn measure(app: &App, ctx: &Context, panels: &mut [Box<dyn LabPanel>]) {
    let (look, scene) = (app.look(), app.scene());
    let Some(bench) = panel_of(panels, scene).and_then(|panel| panel.bench()) else {
        return;
    };
    let response = modal("measure", look).show(ctx, |ui| {
        let height = (ctx.content_rect().height() - 96.0).max(60.0);
        ScrollArea::vertical()
            .max_height(height)
            .min_scrolled_height(height)
            .show(ui, |ui| bench.show(ui, look, scene))
            .inner
    });
    if !response.inner || response.should_close() {
        app.push(Command::Measure(false));
    }
}
