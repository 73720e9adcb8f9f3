//! What stands under the stage, where a method has more to show than places.

use egui::{Rect, Ui};

use crate::{
    figure::{Link, Second},
    paint::Theme,
};

use super::{
    Look,
    clipper_row::{clipper_row, clipper_row_height},
    number_line::{number_line, number_line_height},
};

/// Height of the view in a column of this width.
#[must_use]
pub fn second_view_height(theme: &Theme, width: f32, second: &Second) -> f32 {
    match second {
        Second::NumberLine(_) => number_line_height(theme),
        Second::Clippers(_) => clipper_row_height(theme, width),
    }
}

/// Draws the view in `rect`; what it shows under the pointer.
pub fn second_view(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    second: &Second,
    lit: Option<Link>,
) -> Option<Link> {
    match second {
        Second::NumberLine(line) => number_line(ui, look, rect, line, lit),
        Second::Clippers(row) => clipper_row(ui, look, rect, row, lit),
    }
}
