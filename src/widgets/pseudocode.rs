//! A method's pseudocode, with the line of this step.

use egui::{Align2, FontId, Rect, RichText, Role, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2};

use crate::{
    lesson::CodeView,
    paint::{Span, Typeset},
};

use super::Look;

const fn key(view: CodeView) -> &'static str {
    match view {
        CodeView::Full => "pseudocode-full",
        CodeView::Words => "pseudocode-words",
        CodeView::Hidden => "pseudocode-hidden",
    }
}

/// A line, already in the reader's language.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CodeLine {
    /// Levels of indentation.
    pub depth: usize,
    /// What it says.
    pub text: String,
}

/// The three ways in a row; the one that was chosen.
pub fn code_view_switch(ui: &mut Ui, look: Look<'_>, current: CodeView) -> Option<CodeView> {
    let mut chosen = None;
    ui.spacing_mut().item_spacing.x = 12.0;
    // Right to left, as the row is aligned to the right.
    for view in CodeView::ALL.into_iter().rev() {
        let is_current = view == current;
        let colour = if is_current {
            look.theme.accent
        } else {
            look.theme.soft
        };
        let text = RichText::new(look.say(key(view))).small().color(colour);
        let response = ui.add(egui::Button::new(text).frame(false).small());
        response.widget_info(|| {
            WidgetInfo::selected(Role::RadioButton, true, is_current, look.say(key(view)))
        });
        if response.clicked() {
            chosen = Some(view);
        }
    }
    chosen
}

/// The lines, the current one on a wash with a bar at its left. Returns whether the pointer is on the
/// current line: it is about what this step is about.
pub fn pseudocode(
    ui: &mut Ui,
    look: Look<'_>,
    lines: &[CodeLine],
    view: CodeView,
    current: Option<usize>,
) -> bool {
    if view == CodeView::Hidden {
        ui.label(RichText::new(look.say("pseudocode-hidden-note")).color(look.theme.soft));
        return false;
    }
    let style = if view == CodeView::Full {
        TextStyle::Monospace
    } else {
        TextStyle::Body
    };
    let font = style.resolve(ui.style());
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut pointed = false;
    for (i, line) in lines.iter().enumerate() {
        pointed |= row(ui, look, line, &font, current == Some(i));
    }
    pointed
}

fn row(ui: &mut Ui, look: Look<'_>, line: &CodeLine, font: &FontId, is_current: bool) -> bool {
    let theme = look.theme;
    let colour = if is_current { theme.ink } else { theme.soft };
    let indent = 4.0 + 14.0 * line.depth as f32;
    let width = ui.available_width();
    // A line that is too long goes on under its own start.
    let room = (width - indent - 4.0).max(48.0);
    let text = Span::text(&line.text, font.clone(), colour);
    let set = Typeset::wrapped(ui.painter(), &[text], room);
    let height = set.size().y.max(font.size * 1.2) + 4.0;
    let (rect, response) = ui.allocate_exact_size(vec2(width, height.round()), Sense::hover());
    response.widget_info(|| WidgetInfo::selected(Role::Label, true, is_current, &line.text));
    if is_current {
        let wash = rect.expand2(vec2(8.0, 0.0));
        ui.painter().rect_filled(wash, 0.0, theme.accent_wash);
        let bar = Rect::from_min_size(wash.min, vec2(3.0, wash.height()));
        ui.painter().rect_filled(bar, 0.0, theme.accent);
    }
    let at = pos2(rect.left() + indent, rect.center().y);
    set.paint(ui.painter(), at, Align2::LEFT_CENTER);
    is_current && response.hovered()
}
