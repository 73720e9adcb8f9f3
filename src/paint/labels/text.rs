//! The text of a label: what it says, in which face and colours.

use egui::{Align2, Color32, FontFamily, FontId, Painter, Rect, Vec2, vec2};

use crate::{
    figure::{Label, Role},
    paint::{
        Look, Theme,
        fonts::semibold,
        pen::text_colour,
        typeset::{Span, Typeset},
    },
};

/// Space above and below that belongs to the line, not to its letters, as a part of the letters' size.
const LEADING: f32 = 0.08;
const SHRUNK: [f32; 4] = [1.0, 0.9, 0.8, 0.7];
pub const INSIDE: Vec2 = vec2(2.0, 1.0);
const HALO: f32 = 4.0;
const HALO_RINGS: [(f32, usize); 2] = [(0.5, 8), (0.9, 16)];

#[derive(Clone, Copy)]
pub struct Setter<'a> {
    pub painter: &'a Painter,
    pub look: Look<'a>,
    pub scale: f32,
}

pub struct Text {
    pub plain: String,
    spans: Vec<Span>,
    set: Typeset,
}

impl Setter<'_> {
    pub fn set_in(&self, room: Vec2, label: &Label, role: Role) -> Option<Text> {
        let least = self.look.theme.least_text;
        let is_read = |part: &f32| part * font(label, self.scale).size >= least;
        let sizes = SHRUNK.into_iter().filter(is_read);
        let mut sizes = sizes.map(|part| self.set_at(part, label, role));
        sizes.find(|text| {
            let size = text.size() + 2.0 * INSIDE;
            size.x <= room.x && size.y <= room.y
        })
    }

    pub fn set_at(&self, part: f32, label: &Label, role: Role) -> Text {
        let Look { theme, catalog, .. } = self.look;
        let plain = catalog.value(&label.text);
        let (mut font, colour) = (font(label, self.scale), text_colour(theme, role));
        font.size *= part;
        let spans = match label.lit {
            Some(lit) => self.spans_lit(&plain, lit, &font, colour),
            None => vec![Span::value(catalog, &label.text, font, colour)],
        };
        self.of_spans(plain, spans)
    }

    pub fn join(&self, first: &Text, second: &Text) -> Text {
        let font = FontId::proportional(13.0 * self.scale);
        let mut spans = first.spans.clone();
        spans.push(Span::text(" = ", font, self.look.theme.soft));
        spans.extend(second.spans.iter().cloned());
        self.of_spans(format!("{} = {}", first.plain, second.plain), spans)
    }

    fn of_spans(&self, plain: String, spans: Vec<Span>) -> Text {
        let set = Typeset::line(self.painter, &spans);
        Text { plain, spans, set }
    }

    fn spans_lit(&self, plain: &str, lit: usize, font: &FontId, colour: Color32) -> Vec<Span> {
        let signal = text_colour(self.look.theme, Role::Signal);
        let mut chars = plain.char_indices().map(|(at, _)| at).skip(lit);
        let from = chars.next().unwrap_or(plain.len());
        let to = chars.next().unwrap_or(plain.len());
        [
            (&plain[..from], colour),
            (&plain[from..to], signal),
            (&plain[to..], colour),
        ]
        .into_iter()
        .filter(|(text, _)| !text.is_empty())
        .map(|(text, colour)| Span::text(text, font.clone(), colour))
        .collect()
    }
}

impl Text {
    pub fn size(&self) -> Vec2 {
        let leading = self.spans.first().map_or(0.0, |span| span.font.size) * LEADING;
        self.set.size() - vec2(0.0, 2.0 * leading)
    }

    pub fn paint(&self, painter: &Painter, place: Rect) {
        self.set
            .paint(painter, place.left_center(), Align2::LEFT_CENTER);
    }

    pub fn paint_halo(&self, painter: &Painter, theme: &Theme, place: Rect) {
        let mut spans = self.spans.clone();
        for span in &mut spans {
            span.colour = theme.background;
        }
        let set = Typeset::line(painter, &spans);
        let reach = HALO * theme.stroke_scale.sqrt();
        for (part, n) in HALO_RINGS {
            for i in 0..n {
                let direction = Vec2::angled(std::f32::consts::TAU * i as f32 / n as f32);
                let at = place.left_center() + direction * part * reach;
                set.paint(painter, at, Align2::LEFT_CENTER);
            }
        }
    }
}

fn font(label: &Label, scale: f32) -> FontId {
    let (size, family) = match (label.mono, label.strong) {
        (true, _) => (14.0, FontFamily::Monospace),
        (false, true) => (13.0, semibold()),
        (false, false) => (13.0, FontFamily::Proportional),
    };
    FontId::new(size * scale, family)
}
