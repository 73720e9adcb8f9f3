//! Chips: the digit of what might come, at what it is about; once that is answered, with the sign of right or wrong.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2, vec2};

use crate::figure::{Chip, ChipFate};

use super::Theme;

const SIDE: f32 = 17.0;
const DIGIT: f32 = 11.5;
const CORNER: f32 = 4.0;
const DASH: f32 = 3.0;
/// Half of a tick's and of a cross's width.
const ARM: f32 = 3.5;

impl Chip {
    /// It tells right from wrong by its fill and its sign, not by its hue. Before that it has the question's colour, which no number
    /// of the drawing has.
    pub fn draw(self, painter: &Painter, theme: &Theme, centre: Pos2, is_lit: bool) {
        let rect = self.place(theme, centre);
        let round = CORNER * scale(theme);
        let (fill, ink) = match self.fate {
            ChipFate::Open if is_lit => (theme.accent_wash, theme.accent),
            ChipFate::Open => (theme.background, theme.asks()),
            ChipFate::Wrong => (theme.background, theme.ink),
            ChipFate::Right => (theme.accent, theme.background),
        };
        painter.rect_filled(rect, round, fill);
        match self.fate {
            ChipFate::Open => {
                let (width, colour) = if is_lit {
                    (2.0, theme.accent)
                } else {
                    (1.0, theme.asks())
                };
                let rim = Stroke::new(width, colour);
                painter.rect_stroke(rect, round, rim, StrokeKind::Inside);
            }
            ChipFate::Right => {}
            ChipFate::Wrong => dashed(painter, rect.shrink(0.5), Stroke::new(1.0, theme.soft)),
        }
        let room = rect.with_max_x(rect.left() + rect.height());
        let font = FontId::monospace(DIGIT * scale(theme));
        let text = self.digit.to_string();
        painter.text(room.center(), Align2::CENTER_CENTER, text, font, ink);
        self.sign(painter, theme, rect, ink);
    }

    fn sign(self, painter: &Painter, theme: &Theme, rect: Rect, ink: Color32) {
        let arm = ARM * scale(theme);
        let middle = pos_in(rect);
        let stroke = Stroke::new(1.75 * scale(theme), ink);
        let line = |ends: [Vec2; 2]| {
            painter.line_segment(ends.map(|at| middle + arm * at), stroke);
        };
        match self.fate {
            ChipFate::Open => {}
            ChipFate::Right => {
                line([vec2(-1.0, 0.0), vec2(-0.25, 0.8)]);
                line([vec2(-0.25, 0.8), vec2(1.0, -0.8)]);
            }
            ChipFate::Wrong => {
                line([vec2(-1.0, -1.0), vec2(1.0, 1.0)]);
                line([vec2(-1.0, 1.0), vec2(1.0, -1.0)]);
            }
        }
    }

    pub fn size(self, theme: &Theme) -> Vec2 {
        let side = (SIDE * scale(theme)).round();
        match self.fate {
            ChipFate::Open => Vec2::splat(side),
            ChipFate::Right | ChipFate::Wrong => vec2((1.8 * side).round(), side),
        }
    }

    /// On whole pixels.
    fn place(self, theme: &Theme, centre: Pos2) -> Rect {
        let place = Rect::from_center_size(centre, self.size(theme));
        place.translate(place.min.round() - place.min)
    }
}

const fn scale(theme: &Theme) -> f32 {
    theme.text_scale
}

/// Where the sign stands: in what is left beside the digit.
fn pos_in(rect: Rect) -> Pos2 {
    rect.with_min_x(rect.left() + 0.9 * rect.height()).center()
}

fn dashed(painter: &Painter, rect: Rect, stroke: Stroke) {
    let [a, c] = [rect.min, rect.max];
    let path = [a, rect.right_top(), c, rect.left_bottom(), a];
    painter.extend(Shape::dashed_line(&path, stroke, DASH, DASH));
}
