//! A plot that only shows.

use egui::Vec2b;
use egui_plot::Plot;

/// A plot that only shows: it has no axes and cannot be moved.
#[must_use]
pub fn still_plot(key: &str) -> Plot<'static> {
    Plot::new(key)
        .show_axes(false)
        .show_grid(false)
        .show_background(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_x(false)
        .show_y(false)
        .cursor_color(egui::Color32::TRANSPARENT)
        .auto_bounds(Vec2b::FALSE)
}
