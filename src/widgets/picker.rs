//! Menus for the language and the theme.

use egui::Ui;

use crate::{paint::ThemeKind, text::Lang};

use super::Look;

/// Languages by their own names; the one that was chosen.
pub fn language_menu(ui: &mut Ui, current: Lang) -> Option<Lang> {
    Lang::ALL.into_iter().find(|&lang| {
        let chosen = ui
            .selectable_label(lang == current, lang.native_name())
            .clicked();
        if chosen {
            ui.close();
        }
        chosen
    })
}

/// Catalogue key of a theme's name.
#[must_use]
pub const fn theme_key(kind: ThemeKind) -> &'static str {
    match kind {
        ThemeKind::Light => "theme-light",
        ThemeKind::Dark => "theme-dark",
        ThemeKind::Projector => "theme-projector",
    }
}

/// Themes; the one that was chosen.
pub fn theme_menu(ui: &mut Ui, look: Look<'_>) -> Option<ThemeKind> {
    ThemeKind::ALL.into_iter().find(|&kind| {
        let name = look.say(theme_key(kind));
        let chosen = ui.selectable_label(kind == look.theme.kind, name).clicked();
        if chosen {
            ui.close();
        }
        chosen
    })
}
