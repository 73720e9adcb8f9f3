//! The text of a label, set; in pieces where it names several things or has one character lit.

use egui::{Align2, Color32, FontFamily, FontId, Painter, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{Label, Role},
    paint::{Theme, Typeset, fonts::semibold, pen::text_colour},
    text::Catalog,
};

/// Space above capitals and below the baseline that belongs to the line, not to the letters, as a part of the
/// letters' size.
const LEADING: f32 = 0.15;
/// Reach of a halo, in points, and the rings of copies that it is made of.
const HALO: f32 = 4.0;
const HALO_RINGS: [(f32, usize); 2] = [(0.5, 8), (0.9, 16)];

/// What setting a label takes.
#[derive(Clone, Copy)]
pub struct Setter<'a> {
    /// Lays out text.
    pub painter: &'a Painter,
    /// Its sizes and colours.
    pub theme: &'a Theme,
    /// Its language.
    pub catalog: &'a Catalog,
}

/// A text that stands in one place.
pub struct Text {
    /// As it reads.
    pub plain: String,
    /// Each also in the background's colour, for a halo.
    pieces: Vec<[Typeset; 2]>,
    leading: f32,
}

impl Setter<'_> {
    /// A mark's label.
    pub fn set(&self, label: &Label, role: Role) -> Text {
        let plain = self.catalog.value(&label.text);
        let font = font(label, self.theme);
        let leading = LEADING * font.size;
        let colour = text_colour(self.theme, role);
        let pieces = match label.lit {
            Some(lit) => {
                let part = |from: usize, to: usize| -> String {
                    plain.chars().skip(from).take(to - from).collect()
                };
                let signal = text_colour(self.theme, Role::Signal);
                [
                    (part(0, lit), colour),
                    (part(lit, lit + 1), signal),
                    (part(lit + 1, plain.len().max(lit + 1)), colour),
                ]
                .into_iter()
                .filter(|(text, _)| !text.is_empty())
                .map(|(text, colour)| self.words(&text, &font, colour))
                .collect()
            }
            None => vec![[colour, self.theme.background].map(|colour| {
                let (painter, catalog) = (self.painter, self.catalog);
                Typeset::value(painter, catalog, &label.text, font.clone(), colour)
            })],
        };
        Text {
            plain,
            pieces,
            leading,
        }
    }

    /// Two names of one thing: `C₁ = I₁`.
    pub fn join(&self, first: Text, second: Text) -> Text {
        let font = FontId::proportional(13.0 * self.theme.text_scale);
        let equals = self.words(" = ", &font, self.theme.soft);
        let mut pieces = first.pieces;
        pieces.push(equals);
        pieces.extend(second.pieces);
        Text {
            plain: format!("{} = {}", first.plain, second.plain),
            pieces,
            leading: first.leading,
        }
    }

    fn words(&self, text: &str, font: &FontId, colour: Color32) -> [Typeset; 2] {
        [colour, self.theme.background]
            .map(|colour| Typeset::text(self.painter, text.to_owned(), font.clone(), colour))
    }
}

impl Text {
    /// Of the box around its letters.
    pub fn size(&self) -> Vec2 {
        let sizes = self.pieces.iter().map(|[piece, _]| piece.size());
        let whole = sizes.fold(Vec2::ZERO, |all, size| {
            vec2(all.x + size.x, all.y.max(size.y))
        });
        whole - vec2(0.0, 2.0 * self.leading)
    }

    /// Into its box.
    pub fn paint(&self, painter: &Painter, place: Rect) {
        self.paint_row(painter, place, 0);
    }

    /// What sets it off from what runs under it.
    pub fn paint_halo(&self, painter: &Painter, place: Rect, scale: f32) {
        for (reach, n) in HALO_RINGS {
            for i in 0..n {
                let direction = Vec2::angled(std::f32::consts::TAU * i as f32 / n as f32);
                let place = place.translate(direction * reach * HALO * scale);
                self.paint_row(painter, place, 1);
            }
        }
    }

    fn paint_row(&self, painter: &Painter, place: Rect, which: usize) {
        let mut x = place.left();
        for piece in &self.pieces {
            let at = pos2(x, place.center().y);
            x = piece[which].paint(painter, at, Align2::LEFT_CENTER).right();
        }
    }
}

fn font(label: &Label, theme: &Theme) -> FontId {
    let (size, family) = match (label.mono, label.strong) {
        (true, _) => (14.0, FontFamily::Monospace),
        (false, true) => (13.0, semibold()),
        (false, false) => (13.0, FontFamily::Proportional),
    };
    FontId::new(size * theme.text_scale, family)
}
