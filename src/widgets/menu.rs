//! Menus: rows that touch, each as wide as the menu.

use egui::{
    InnerResponse, PopupCloseBehavior, Style, Ui, WidgetText,
    containers::menu::{self, MenuButton, MenuConfig, SubMenuButton},
};

/// By so much a row is higher than a button in a bar, in points: the space between its words and the next ones.
const ROW_PTS: f32 = 4.0;

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
    let config = MenuConfig::new().style(menu_style).close_behavior(closes);
    let (response, inner) = if menu::is_in_menu(ui) {
        SubMenuButton::new(title).config(config).ui(ui, content)
    } else {
        MenuButton::new(title).config(config).ui(ui, content)
    };
    InnerResponse::new(inner.map(|inner| inner.inner), response)
}
