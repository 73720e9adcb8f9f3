//! What every widget draws with: the colours, the language, and names of others.

pub use egui::{
    Align2, Color32, CursorIcon, FontId, Id, Painter, Pos2, Rect, Response, Sense, Shape, Stroke,
    StrokeKind, TextStyle, Ui, Vec2, WidgetInfo, pos2, vec2,
};

pub use crate::{
    figure::Link,
    paint::{Around, Look, Span, Theme, Typeset, Viewport},
    text::{Formula, Message, Notation, Value},
};
