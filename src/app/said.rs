//! What is said to a reader, set for reading: subscripts are lowered, and no formula is broken that fits on a line.

use std::sync::Arc;

use egui::{Galley, TextStyle, accesskit::Live};

use crate::paint::{Span, Typeset};

use super::prelude::*;

pub fn words(ui: &Ui, look: Look<'_>, (text, style): (&str, TextStyle), width: f32) -> Arc<Galley> {
    let span = Span::text(text, style.resolve(ui.style()), look.theme.ink);
    Typeset::wrapped(ui.painter(), &[span], width).galley()
}

/// Screen readers say it once it is there.
pub fn said_live(ui: &mut Ui, text: Arc<Galley>) {
    let label = ui.add(Label::new(text));
    let live = |node: &mut egui::accesskit::Node| node.set_live(Live::Polite);
    ui.ctx().accesskit_node_builder(label.id, live);
}
