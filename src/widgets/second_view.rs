//! What stands under the stage, where a method has more to show than places.

use egui::{Rect, Ui};

use crate::{
    figure::{Body, Link, View},
    paint::Theme,
};

use super::{
    Look,
    clipper_row::{clipper_row, clipper_row_height},
    number_line::{number_line, number_line_height},
};

/// Height of the view in a column of this width, where it is one that stands under the stage.
#[must_use]
pub fn second_view_height(theme: &Theme, width: f32, view: &View) -> Option<f32> {
    match view.body {
        Body::NumberLine(_) => Some(number_line_height(theme)),
        Body::Clippers(_) => Some(clipper_row_height(theme, width)),
        Body::Plane(_) | Body::Bits(_) | Body::Table(_) | Body::Lists(_) | Body::Products(_) => {
            None
        }
    }
}

/// Draws the view in `rect`; what it shows under the pointer.
pub fn second_view(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    second: &View,
    lit: Option<Link>,
) -> Option<Link> {
    match &second.body {
        Body::NumberLine(line) => number_line(ui, look, rect, line, lit),
        Body::Clippers(row) => clipper_row(ui, look, rect, row, lit),
        Body::Plane(_) | Body::Bits(_) | Body::Table(_) | Body::Lists(_) | Body::Products(_) => {
            None
        }
    }
}
