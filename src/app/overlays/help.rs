//! The list of keys.

use egui::KeyboardShortcut;

use crate::app::{App, BINDINGS, Command, prelude::*};

use super::modal::{WIDTH, heading, modal};

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

pub(super) fn show(app: &App, ctx: &Context) {
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
