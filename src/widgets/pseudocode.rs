//! A method's pseudocode, with the line of this step.

use egui::{
    Align2, Color32, FontId, Rect, RichText, Role, Sense, StrokeKind, TextStyle, Ui, WidgetInfo,
    pos2, vec2,
};

use crate::{
    lesson::CodeView,
    paint::{Span, Typeset},
};

use super::{look::Look, whole_rows::WholeRows};

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

/// Lines that have been set.
pub struct Pseudocode<'a> {
    look: Look<'a>,
    lines: &'a [CodeText],
    set: Vec<SetLine>,
    heights: Vec<f32>,
}

impl<'a> Pseudocode<'a> {
    /// Sets the lines, in smaller text where they would take more than `most`; none where they are hidden.
    pub fn new(
        ui: &Ui,
        look: Look<'a>,
        (lines, view): (&'a [CodeText], CodeView),
        most: f32,
    ) -> Self {
        let (style, lines) = match view {
            CodeView::Full => (TextStyle::Monospace, lines),
            CodeView::Words => (TextStyle::Body, lines),
            CodeView::Hidden => (TextStyle::Body, &[][..]),
        };
        let natural = style.resolve(ui.style());
        let set = |part: f32| -> Vec<SetLine> {
            let font = FontId::new(part * natural.size, natural.family.clone());
            let lines = lines.iter();
            lines.map(|line| SetLine::new(ui, line, &font)).collect()
        };
        let mut sizes = SIZES.into_iter().map(set);
        let height = |set: &[SetLine]| set.iter().map(|line| line.height).sum::<f32>();
        let fitting = sizes.find(|set| height(set) <= most);
        let set = fitting.unwrap_or_else(|| set(SIZES[SIZES.len() - 1]));
        let heights = set.iter().map(|line| line.height).collect();
        Self {
            look,
            lines,
            set,
            heights,
        }
    }

    /// Of all lines.
    pub fn height(&self) -> f32 {
        self.heights.iter().sum()
    }

    /// Draws the lines, as many as have room whole, the current one on a wash with a bar at its left, each with a rim where
    /// what it is about is lit. Returns the line under the pointer.
    pub fn show(&self, ui: &mut Ui, step: &CodeStep<'_>, most: f32) -> Option<usize> {
        let rows = WholeRows {
            name: "pseudocode",
            heights: &self.heights,
            most,
            focus: step.line,
            moment: step.moment,
        };
        rows.show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let mut pointed = None;
            for (i, (line, set)) in self.lines.iter().zip(&self.set).enumerate() {
                let is_current = step.line == Some(i);
                let is_lit = step.lit.contains(&i);
                if row(ui, self.look, (line, set), is_current, is_lit) {
                    pointed = Some(i);
                }
            }
            pointed
        })
    }
}

/// Where a step is in the pseudocode.
#[derive(Clone, Copy, Debug)]
pub struct CodeStep<'a> {
    /// Its line.
    pub line: Option<usize>,
    /// Its number.
    pub moment: usize,
    /// The lines about what stands out elsewhere.
    pub lit: &'a [usize],
}

/// A line as it is set.
struct SetLine {
    indent: f32,
    text: Typeset,
    height: f32,
}

impl SetLine {
    fn new(ui: &Ui, line: &CodeText, font: &FontId) -> Self {
        let indent = 4.0 + 14.0 * line.depth as f32;
        // A line that is too long goes on under its own start.
        let room = (ui.available_width() - indent - 4.0).max(48.0);
        let text = Span::text(&line.text, font.clone(), Color32::PLACEHOLDER);
        let text = Typeset::wrapped(ui.painter(), &[text], room);
        let height = (text.size().y.max(font.size * 1.2) + 4.0).round();
        Self {
            indent,
            text,
            height,
        }
    }
}

fn row(
    ui: &mut Ui,
    look: Look<'_>,
    (line, set): (&CodeText, &SetLine),
    is_current: bool,
    is_lit: bool,
) -> bool {
    let theme = look.theme;
    let size = vec2(ui.available_width(), set.height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::selected(Role::Label, true, is_current, &line.text));
    if is_current {
        let wash = rect.expand2(vec2(8.0, 0.0));
        ui.painter().rect_filled(wash, 0.0, theme.accent_wash);
        let bar = Rect::from_min_size(wash.min, vec2(3.0, wash.height()));
        ui.painter().rect_filled(bar, 0.0, theme.accent);
    }
    if is_lit {
        let rim = theme.stroke(1.0, theme.accent);
        ui.painter().rect_stroke(rect, 0.0, rim, StrokeKind::Inside);
    }
    let colour = if is_current { theme.ink } else { theme.soft };
    let at = pos2(rect.left() + set.indent, rect.center().y);
    set.text
        .paint_in(ui.painter(), at, Align2::LEFT_CENTER, colour);
    response.hovered()
}
