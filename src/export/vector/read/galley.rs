//! Text as egui has laid it out: each letter with its font, its colour and its place.

use egui::{
    Color32, Pos2, Rect, TextFormat,
    emath::GuiRounding,
    epaint::text::Glyph,
    epaint::text::Row,
    epaint::{TextShape, Vertex},
    vec2,
};

use crate::export::vector::page::{Form, Letter, Path, Text, Turn, What};

use super::Reader;

impl Reader<'_> {
    pub(super) fn text(&mut self, clip: Rect, text: &TextShape) {
        let at = text.pos.round_to_pixels(self.drawing.pixels_per_point);
        let galley = &text.galley;
        let mut formats = galley.job.sections.iter().flat_map(|section| {
            let range = section.byte_range.start.0..section.byte_range.end.0;
            let part = galley.job.text.get(range).unwrap_or_default();
            part.chars().filter(|c| *c != '\n').map(|_| &section.format)
        });
        let (mut letters, mut bars) = (Vec::new(), Vec::new());
        for (row, placed) in galley.rows.iter().enumerate() {
            let origin = at + placed.pos.to_vec2();
            for glyph in &placed.row.glyphs {
                let Some(format) = formats.next() else { break };
                let pen = Pen { text, origin, row };
                letters.extend(pen.letter(&placed.row, glyph, format));
            }
            bars.extend(bars_of(text, &placed.row, origin));
        }
        let what = What::Text(Text {
            plain: galley.job.text.clone(),
            turn: Turn {
                around: at,
                radians: text.angle,
            },
            letters,
            bars,
        });
        if text.opacity_factor > 0.0 && !galley.job.text.trim().is_empty() {
            let bounds = text.visual_bounding_rect();
            self.drawn(clip, bounds, what);
        }
    }
}

fn bars_of(text: &TextShape, row: &Row, origin: Pos2) -> Vec<Path> {
    let visuals = &row.visuals;
    let vertices = visuals.mesh.vertices.iter().enumerate();
    let others = vertices.filter(|(i, _)| !visuals.glyph_vertex_range.contains(i));
    let others: Vec<_> = others.map(|(_, vertex)| vertex).collect();
    let bar = |corners: &[&Vertex]| {
        let rect = Rect::from_points(&[corners[0].pos, corners[3].pos]);
        Path {
            form: Form::Rect(rect.translate(origin.to_vec2()), 0.0),
            fill: Some(shown(text, corners[0].color)),
            stroke: None,
        }
    };
    others.chunks_exact(4).map(bar).collect()
}

struct Pen<'a> {
    text: &'a TextShape,
    origin: Pos2,
    row: usize,
}

impl Pen<'_> {
    /// Where its pixels stand, which is not always where egui has put it: what is set as a subscript has been moved.
    fn letter(&self, row: &Row, glyph: &Glyph, format: &TextFormat) -> Option<Letter> {
        let first = glyph.first_vertex as usize;
        let corners = row.visuals.mesh.vertices.get(first..first + 4);
        let (at, colour) = match corners.filter(|_| !glyph.uv_rect.is_nothing()) {
            Some(corners) => {
                let [min, max] = [corners[0].pos, corners[3].pos];
                if min == max {
                    // Not set: an underscore before a subscript.
                    return None;
                }
                let top = min.y - glyph.uv_rect.offset.y;
                (vec2(glyph.pos.x, top), corners[0].color)
            }
            None => (glyph.pos.to_vec2(), format.color),
        };
        Some(Letter {
            c: glyph.chr,
            font: format.font_id.clone(),
            colour: shown(self.text, self.text.override_text_color.unwrap_or(colour)),
            at: self.origin + at,
            advance: glyph.advance_width,
            is_italic: format.italics,
            row: self.row,
        })
    }
}

fn shown(text: &TextShape, colour: Color32) -> Color32 {
    let colour = if colour == Color32::PLACEHOLDER {
        text.fallback_color
    } else {
        colour
    };
    colour.gamma_multiply(text.opacity_factor)
}
