//! What every widget draws with: the colours, the language, and names of others.

pub use egui::{
    Align2, Color32, CursorIcon, FontId, Id, Painter, Pos2, Rect, Response, Sense, Shape, Stroke,
    StrokeKind, TextStyle, Ui, Vec2, WidgetInfo, pos2, vec2,
};

pub use crate::{
    figure::Link,
    paint::{Around, Span, Theme, Typeset, Viewport},
    text::{Formula, Message, Notation, Value},
};

use crate::{
    figure::Mark,
    paint::{self, Placed},
    text::Catalog,
};

#[derive(Clone, Copy)]
pub struct Look<'a> {
    pub theme: &'a Theme,
    pub catalog: &'a Catalog,
}

impl Look<'_> {
    pub fn say(&self, key: &str) -> String {
        self.catalog.term(key)
    }

    pub fn stage(
        &self,
        painter: &Painter,
        viewport: &Viewport,
        marks: &[Mark],
        lit: Option<Link>,
        around: Around<'_>,
    ) -> Vec<Placed> {
        paint::stage(
            painter,
            viewport,
            self.theme,
            self.catalog,
            marks,
            lit,
            around,
        )
    }
}
