//! The words of every file of the window: what it draws with, and what it is about.

pub(super) use egui::{
    Align, Align2, Button, Context, CursorIcon, Id, Key, Label, Layout, Margin, Modifiers, Pos2,
    Rect, RichText, ScrollArea, Stroke, Ui, UiBuilder, pos2, vec2,
};

pub(super) use crate::{
    figure::{Lens, Link, Moment, ViewId, Watch},
    geom::Orbit,
    labs::{Click, Edit, Handle, Lab, Lock, MethodCard, Motion, Scene, Sketch},
    lesson::{CodeView, Course, Lesson, LessonStep, Problem, SceneFile, Told},
    paint::{Theme, ThemeKind, Viewport, theme},
    panels::{LabPanel, panel_of},
    text::{Diagnostic, Lang, Message, Value},
    widgets::{Icon, Look, PanZoom, caption_text, icon_button, menu_button},
};

/// Words that stand back.
pub(super) fn soft(look: Look<'_>, key: &str) -> RichText {
    RichText::new(look.say(key)).color(look.theme.soft)
}

/// Words that can be pressed.
pub(super) fn accent(look: Look<'_>, key: &str) -> RichText {
    RichText::new(look.say(key)).color(look.theme.accent)
}
