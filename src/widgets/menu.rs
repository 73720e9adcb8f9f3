//! Menus: rows that touch, each as wide as the menu; and the menus for the language and the theme.

use egui::{
    InnerResponse, Key, PopupCloseBehavior, ScrollArea, Style, WidgetText,
    containers::menu::{self, MenuButton, MenuConfig, SubMenuButton},
};

use crate::{
    paint::{ThemeKind, text_sizes::TEXT_SIZES},
    text::Lang,
};

use super::prelude::*;

const ROW_PTS: f32 = 4.0;
/// The bar over a menu, and what stays free below.
const AROUND_PTS: f32 = 72.0;
/// A narrower window has no room for two menus side by side.
const TWO_PTS: f32 = 640.0;
/// Over and under the rows of a menu beside another.
const BESIDE_PTS: f32 = 12.0;

/// Space inside the rows, and none between them: wherever the pointer is, it is on one.
pub fn menu_style(style: &mut Style) {
    menu::menu_style(style);
    style.spacing.item_spacing.y = 0.0;
    style.spacing.button_padding.x = 8.0;
    style.spacing.interact_size.y += ROW_PTS;
}

/// A button that opens a menu, or in a menu a row that opens another.
pub fn menu_button<R>(
    ui: &mut Ui,
    title: impl Into<WidgetText>,
    content: impl FnOnce(&mut Ui) -> R,
) -> InnerResponse<Option<R>> {
    opening(ui, title.into(), PopupCloseBehavior::CloseOnClick, content)
}

/// The same with fields to be filled in: it is open until something beside it is clicked.
pub fn form_button<R>(
    ui: &mut Ui,
    title: impl Into<WidgetText>,
    content: impl FnOnce(&mut Ui) -> R,
) -> InnerResponse<Option<R>> {
    let closes = PopupCloseBehavior::CloseOnClickOutside;
    opening(ui, title.into(), closes, content)
}

fn opening<R>(
    ui: &mut Ui,
    title: WidgetText,
    closes: PopupCloseBehavior,
    content: impl FnOnce(&mut Ui) -> R,
) -> InnerResponse<Option<R>> {
    let (mut content, mut inner) = (Some(content), None);
    let mut show = |ui: &mut Ui| inner = content.take().map(|content| content(ui));
    let response = opened(ui, title, closes, &mut show);
    InnerResponse::new(inner, response)
}

/// Compiled once, whatever is in it.
fn opened(
    ui: &mut Ui,
    title: WidgetText,
    closes: PopupCloseBehavior,
    content: &mut dyn FnMut(&mut Ui),
) -> Response {
    // What is taller than the window scrolls. A menu that a row opens is no taller than the room below that row, or above it: else
    // it would lie over the row, and a click on the row would hit what lies there.
    let (window, top) = (ui.ctx().content_rect(), ui.cursor().top());
    let most = if menu::is_in_menu(ui) && window.width() >= TWO_PTS {
        (window.bottom() - top).max(top - window.top()) - 2.0 * BESIDE_PTS
    } else {
        window.height() - AROUND_PTS
    };
    let content = |ui: &mut Ui| {
        let rows = ScrollArea::vertical().max_height(most);
        rows.show(ui, content);
    };
    let config = MenuConfig::new().style(menu_style).close_behavior(closes);
    let (response, shown) = if menu::is_in_menu(ui) {
        SubMenuButton::new(title).config(config).ui(ui, content)
    } else {
        MenuButton::new(title).config(config).ui(ui, content)
    };
    // Whoever leaves a menu by its key goes on from its button.
    if shown.is_some() && ui.input(|input| input.key_pressed(Key::Escape)) {
        response.request_focus();
    }
    response
}

pub fn is_chosen(ui: &mut Ui, is_current: bool, name: impl Into<WidgetText>) -> bool {
    let is_chosen = ui.selectable_label(is_current, name.into()).clicked();
    if is_chosen {
        ui.close();
    }
    is_chosen
}

pub fn language_menu(ui: &mut Ui, current: Lang) -> Option<Lang> {
    let mut all = Lang::ALL.into_iter();
    all.find(|&lang| is_chosen(ui, lang == current, lang.native_name()))
}

pub const fn theme_key(kind: ThemeKind) -> &'static str {
    match kind {
        ThemeKind::Light => "theme-light",
        ThemeKind::Dark => "theme-dark",
        ThemeKind::Projector => "theme-projector",
    }
}

pub fn theme_menu(ui: &mut Ui, look: Look<'_>) -> Option<ThemeKind> {
    let mut all = ThemeKind::ALL.into_iter();
    all.find(|&kind| is_chosen(ui, kind == look.theme.kind, look.say(theme_key(kind))))
}

pub fn text_menu(ui: &mut Ui, current: f32) -> Option<f32> {
    let mut all = TEXT_SIZES.into_iter();
    all.find(|&size| is_chosen(ui, size == current, format!("{:.0} %", 100.0 * size)))
}
