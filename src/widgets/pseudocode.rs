//! A method's pseudocode, with the line of this step.

use egui::{
    Align2, Color32, FontId, Id, Rect, RichText, Role, Sense, TextStyle, Ui, WidgetInfo, pos2,
    style::ScrollAnimation, vec2,
};

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
pub struct CodeText {
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

/// Of its natural size, what the text is set in: the largest at which the lines take no more than their height.
const SIZES: [f32; 3] = [1.0, 0.92, 0.85];

/// The lines, the current one on a wash with a bar at its left; in smaller text where they would take more than `most`.
/// Returns whether the pointer is on the current line: it is about what this step is about.
pub fn pseudocode(
    ui: &mut Ui,
    look: Look<'_>,
    (lines, view): (&[CodeText], CodeView),
    current: Option<usize>,
    most: f32,
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
    let natural = style.resolve(ui.style());
    let size = |part: f32| FontId::new(part * natural.size, natural.family.clone());
    let height = |font: &FontId| -> f32 {
        let rows = lines.iter();
        rows.map(|line| SetLine::new(ui, line, font, look.theme.soft).height)
            .sum()
    };
    let mut fonts = SIZES.map(size).into_iter();
    let fitting = fonts.find(|font| height(font) <= most);
    let font = fitting.unwrap_or_else(|| size(SIZES[SIZES.len() - 1]));
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut pointed = false;
    for (i, line) in lines.iter().enumerate() {
        pointed |= row(ui, look, line, &font, current == Some(i));
    }
    pointed
}

/// A line as it is set.
struct SetLine {
    indent: f32,
    set: Typeset,
    height: f32,
}

impl SetLine {
    fn new(ui: &Ui, line: &CodeText, font: &FontId, colour: Color32) -> Self {
        let indent = 4.0 + 14.0 * line.depth as f32;
        // A line that is too long goes on under its own start.
        let room = (ui.available_width() - indent - 4.0).max(48.0);
        let text = Span::text(&line.text, font.clone(), colour);
        let set = Typeset::wrapped(ui.painter(), &[text], room);
        let height = (set.size().y.max(font.size * 1.2) + 4.0).round();
        Self {
            indent,
            set,
            height,
        }
    }
}

fn row(ui: &mut Ui, look: Look<'_>, line: &CodeText, font: &FontId, is_current: bool) -> bool {
    let theme = look.theme;
    let colour = if is_current { theme.ink } else { theme.soft };
    let SetLine {
        indent,
        set,
        height,
    } = SetLine::new(ui, line, font, colour);
    let size = vec2(ui.available_width(), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::selected(Role::Label, true, is_current, &line.text));
    if is_current {
        let wash = rect.expand2(vec2(8.0, 0.0));
        ui.painter().rect_filled(wash, 0.0, theme.accent_wash);
        let bar = Rect::from_min_size(wash.min, vec2(3.0, wash.height()));
        ui.painter().rect_filled(bar, 0.0, theme.accent);
        keep_in_view(ui, rect, &line.text);
    }
    let at = pos2(rect.left() + indent, rect.center().y);
    set.paint(ui.painter(), at, Align2::LEFT_CENTER);
    is_current && response.hovered()
}

/// Scrolls to the current line when it has become another one.
fn keep_in_view(ui: &Ui, rect: Rect, text: &str) {
    let (id, now) = (Id::unique("code line in view"), Id::unique(text));
    if ui.data(|data| data.get_temp(id)) != Some(now) {
        ui.data_mut(|data| data.insert_temp(id, now));
        ui.scroll_to_rect_animation(rect, None, ScrollAnimation::none());
    }
}
