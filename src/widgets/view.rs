//! A view of any kind but the drawing, which the stage draws itself.

use egui::{Rect, Ui};

use crate::{
    figure::{Body, Link, View},
    paint::Theme,
};

use super::{
    Look,
    bits::bits,
    clipper_row::{clipper_row, clipper_row_height},
    lists::lists,
    number_line::{number_line, number_line_height},
    products::products,
    table::table,
};

/// Height of a view that stands under the drawing, in a column of this width; `None` of one that stands beside it.
#[must_use]
pub fn strip_height(theme: &Theme, width: f32, shown: &View) -> Option<f32> {
    match shown.body {
        Body::NumberLine(_) => Some(number_line_height(theme)),
        Body::Clippers(_) => Some(clipper_row_height(theme, width)),
        Body::Plane(_) | Body::Bits(_) | Body::Table(_) | Body::Lists(_) | Body::Products(_) => {
            None
        }
    }
}

/// Draws the view in `rect`, from its top; what it shows under the pointer.
pub fn view(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    shown: &View,
    lit: Option<Link>,
) -> Option<Link> {
    match &shown.body {
        Body::Plane(_) => None,
        Body::Bits(body) => bits(ui, look, rect, body, lit),
        Body::Table(body) => table(ui, look, rect, body, lit),
        Body::Lists(body) => lists(ui, look, rect, body, lit),
        Body::Products(body) => products(ui, look, rect, body, lit),
        Body::NumberLine(body) => number_line(ui, look, rect, body, lit),
        Body::Clippers(body) => clipper_row(ui, look, rect, body, lit),
    }
}
