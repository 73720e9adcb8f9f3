//! A method's pseudocode, with the line of this step.

use egui::{RichText, Role};

use crate::lesson::CodeView;

use super::{fingers::target, headings::quiet_button, prelude::*, whole_rows::WholeRows};

const fn key(view: CodeView) -> &'static str {
    match view {
        CodeView::Full => "pseudocode-full",
        CodeView::Words => "pseudocode-words",
        CodeView::Hidden => "pseudocode-hidden",
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CodeText {
    pub depth: usize,
    pub text: String,
    /// So many bytes of it are told; a bar stands for the rest, as long whatever that is.
    pub told: usize,
}

impl CodeText {
    pub const fn new(depth: usize, text: String) -> Self {
        let told = text.len();
        Self { depth, text, told }
    }

    /// Without the rule: an assignment without its value, a condition without what is compared, a case without what is done.
    pub fn without_rule(self) -> Self {
        let after = |sign: char| Some(self.text.find(sign)? + sign.len_utf8());
        let first_word = || self.text.find(' ').filter(|_| self.text.contains(COMPARED));
        let told = after('←').or_else(first_word).or_else(|| after(':'));
        let told = told.unwrap_or(self.text.len());
        Self { told, ..self }
    }

    fn told(&self) -> &str {
        &self.text[..self.told]
    }
}

const COMPARED: [char; 6] = ['<', '>', '=', '≠', '≤', '≥'];
const BAR: Vec2 = vec2(96.0, 8.0);

pub fn code_view_switch(ui: &mut Ui, look: Look<'_>, current: CodeView) -> Option<CodeView> {
    let mut chosen = None;
    ui.spacing_mut().item_spacing.x = 12.0;
    // Right to left, as the row is aligned to the right.
    for view in CodeView::ALL.into_iter().rev() {
        let is_current = view == current;
        let Look { theme, .. } = look;
        let colour = if is_current { theme.accent } else { theme.soft };
        let name = look.say(key(view));
        let text = RichText::new(&name).small().color(colour);
        let least = Vec2::splat(target(ui, 0.0));
        let button = egui::Button::new(text).small().min_size(least);
        let response = quiet_button(ui, look, button);
        let info = || WidgetInfo::selected(Role::RadioButton, true, is_current, &name);
        response.widget_info(info);
        if response.clicked() {
            chosen = Some(view);
        }
    }
    chosen
}

/// Of its natural size, what the text is set in: the largest at which the lines take no more than their height.
const SIZES: [f32; 3] = [1.0, 0.92, 0.85];

pub struct Pseudocode<'a> {
    look: Look<'a>,
    lines: &'a [CodeText],
    set: Vec<SetLine>,
    heights: Vec<f32>,
}

impl<'a> Pseudocode<'a> {
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
            let set = |line: &CodeText| {
                let indent = 4.0 + 14.0 * line.depth as f32;
                // A line that is too long goes on under its own start.
                let room = (ui.available_width() - indent - 4.0).max(48.0);
                let wrapped = |text: &str| {
                    let text = Span::text(text, font.clone(), Color32::PLACEHOLDER);
                    Typeset::wrapped(ui.painter(), &[text], room)
                };
                // Hidden or not, a line is as high.
                let whole = wrapped(&line.text);
                SetLine {
                    indent,
                    height: (whole.size().y.max(font.size * 1.2) + 4.0).round(),
                    text: if line.told < line.text.len() {
                        wrapped(line.told())
                    } else {
                        whole
                    },
                }
            };
            lines.iter().map(set).collect()
        };
        let least = look.theme.least_text / natural.size;
        let sizes = SIZES.map(|part| part.max(least));
        let height = |set: &[SetLine]| set.iter().map(|line| line.height).sum::<f32>();
        let fitting = sizes.into_iter().map(set).find(|set| height(set) <= most);
        let set = fitting.unwrap_or_else(|| set(sizes[SIZES.len() - 1]));
        let heights = set.iter().map(|line| line.height).collect();
        Self {
            look,
            lines,
            set,
            heights,
        }
    }

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
            focus: step.line.or((step.moment == 0).then_some(0)),
            moment: step.moment,
        };
        rows.show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let theme = self.look.theme;
            let mut pointed = None;
            for (i, (line, set)) in self.lines.iter().zip(&self.set).enumerate() {
                let is_current = step.line == Some(i);
                let is_lit = step.lit.contains(&i);
                let size = vec2(ui.available_width(), set.height);
                let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
                let info = || WidgetInfo::selected(Role::Label, true, is_current, line.told());
                response.widget_info(info);
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
                let (text, align) = (&set.text, Align2::LEFT_CENTER);
                let told = text.paint_in(ui.painter(), at, align, colour);
                if line.told < line.text.len() {
                    let bar = untold(rect, told);
                    ui.painter().rect_filled(bar, 2.0, theme.hairline);
                }
                if response.hovered() {
                    pointed = Some(i);
                }
            }
            pointed
        })
    }
}

#[derive(Clone, Copy, Debug)]
pub struct CodeStep<'a> {
    pub line: Option<usize>,
    pub moment: usize,
    pub lit: &'a [usize],
}

struct SetLine {
    indent: f32,
    text: Typeset,
    height: f32,
}

/// What stands for the rest of a line, after what is told of it.
fn untold(line: Rect, told: Rect) -> Rect {
    const GAP: f32 = 6.0;
    const LEAST: f32 = 12.0;
    let left = (told.right() + GAP).min(line.right() - LEAST);
    let size = vec2(BAR.x.min(line.right() - left), BAR.y);
    Rect::from_min_size(pos2(left, line.center().y - 0.5 * BAR.y), size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_for_the_rest_of_a_line_covers_nothing_that_is_told() {
        let line = Rect::from_min_size(pos2(10.0, 20.0), vec2(264.0, 36.0));
        for width in [0.0, 60.0, 160.0, 200.0, 246.0] {
            let told = line.with_max_x(line.left() + width);
            let bar = untold(line, told);
            assert!(
                line.contains_rect(bar) && bar.left() > told.right(),
                "{width}: {bar:?}"
            );
            assert!(
                bar.width() >= BAR.x.min(264.0 - width - 6.0),
                "{width}: {bar:?}"
            );
        }
    }
}
