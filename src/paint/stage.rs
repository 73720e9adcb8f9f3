//! A figure's marks as egui shapes.

use egui::Painter;

use crate::{
    figure::{Link, Mark},
    text::Catalog,
};

use super::{Theme, Viewport};

/// Draws the marks in order, then their labels where they cover nothing. What is about `lit` stands out.
pub fn stage(
    painter: &Painter,
    viewport: &Viewport,
    theme: &Theme,
    catalog: &Catalog,
    marks: &[Mark],
    lit: Option<Link>,
) {
    let _ = (painter, viewport, theme, catalog, marks, lit);
}
