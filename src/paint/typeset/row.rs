//! One row: laid out on a line, then its quotients stacked and its subscripts lowered.

use std::{ops::Range, sync::Arc};

use egui::{
    Color32, FontFamily, Galley, Painter, Rect, TextFormat, emath::GuiRounding, epaint::text::Row,
    pos2, text::LayoutJob, vec2,
};

use crate::paint::fonts::semibold;

use super::script::{Char, Form, Half, Script};

/// The size of a subscript, and of what stands above or below a quotient's line, to that of the text.
const SUB_SIZE: f32 = 0.72;
const HALF_SIZE: f32 = 0.92;
const SUB_DROP: f32 = 0.2;
/// Capitals and digits are as high as this in all shipped fonts.
const CAPITAL: f32 = 0.73;
const BAR_GAP: f32 = 0.14;
/// How far the line reaches out on either side of the longer half, and the room beside it.
const OVERHANG: f32 = 0.1;
const BESIDE: f32 = 0.09;

pub struct SetRow {
    pub galley: Arc<Galley>,
    pub baseline: f32,
    /// Where each character begins and ends; a quotient's all where it does.
    pub places: Vec<[f32; 2]>,
    pub ends_line: bool,
}

impl SetRow {
    pub fn new(painter: &Painter, script: &Script<'_>, range: Range<usize>) -> Self {
        let chars = &script.chars[range];
        let galley = painter.layout_job(job(script, chars));
        let size = |char: &Char| script.spans[char.span].font.size;
        // Letters of two sizes stand on one line of letters, not on one bottom.
        let is_of_one_size = chars
            .windows(2)
            .all(|pair| size(&pair[0]) == size(&pair[1]));
        let is_full = |char: &Char| char.form == Form::Full && char.quotient.is_none();
        let is_plain = is_of_one_size && chars.iter().all(is_full);
        match galley.rows.first() {
            Some(row) if row.glyphs.len() == chars.len() => {
                let places = row.glyphs.iter().map(|it| [it.pos.x, it.max_x()]);
                let places = places.collect();
                let (baseline, height) = line(painter, script, chars);
                if is_plain {
                    return Self {
                        galley,
                        baseline,
                        places,
                        ends_line: false,
                    };
                }
                let mut stacker = Stacker {
                    script,
                    chars,
                    row: Row::clone(&row.row),
                    pixels_per_point: painter.pixels_per_point(),
                    baseline,
                    height,
                    shift: 0.0,
                    out: 0.0,
                    places,
                    bars: Vec::new(),
                };
                stacker.set();
                stacker.into_row(&galley)
            }
            // Nothing to set, or a line feed in a name: as it is.
            _ => Self {
                baseline: galley.rows.first().map_or(0.0, |row| row.size.y),
                places: vec![[0.0, galley.size().x]; chars.len()],
                galley,
                ends_line: false,
            },
        }
    }
}

fn job(script: &Script<'_>, chars: &[Char]) -> LayoutJob {
    let mut job = LayoutJob::default();
    let mut rest = chars;
    while let Some(first) = rest.first() {
        let is_alike = |char: &&Char| char.span == first.span && scale(char) == scale(first);
        let (run, after) = rest.split_at(rest.iter().take_while(is_alike).count());
        let span = &script.spans[first.span];
        let mut font = span.font.clone();
        font.size = size(script, first);
        let text: String = run.iter().map(|char| char.c).collect();
        let mut format = TextFormat::simple(font, span.colour);
        format.italics = span.italics;
        job.append(&text, 0.0, format);
        rest = after;
    }
    job
}

fn scale(char: &Char) -> f32 {
    let half = if char.quotient.is_some() {
        HALF_SIZE
    } else {
        1.0
    };
    match char.form {
        Form::Sub => half * SUB_SIZE,
        Form::Full | Form::Unset => half,
    }
}

/// Of a character's font. Halves of a point are fine enough, and keep the atlas small.
fn size(script: &Script<'_>, char: &Char) -> f32 {
    let size = script.spans[char.span].font.size;
    match scale(char) {
        1.0 => size,
        scale => (2.0 * size * scale).round() / 2.0,
    }
}

/// Where the letters of a row stand from its top, and how high the row is: those of its first character's font.
fn line(painter: &Painter, script: &Script<'_>, chars: &[Char]) -> (f32, f32) {
    let span = &script.spans[chars.first().map_or(0, |char| char.span)];
    let digit = painter.layout_no_wrap("0".to_owned(), span.font.clone(), span.colour);
    let glyph = digit.rows.first().and_then(|row| row.glyphs.first());
    (glyph.map_or(0.0, |glyph| glyph.pos.y), digit.size().y)
}

struct Stacker<'a> {
    script: &'a Script<'a>,
    chars: &'a [Char],
    row: Row,
    pixels_per_point: f32,
    baseline: f32,
    height: f32,
    shift: f32,
    out: f32,
    places: Vec<[f32; 2]>,
    bars: Vec<(Rect, Color32)>,
}

impl Stacker<'_> {
    fn set(&mut self) {
        let mut i = 0;
        while let Some(char) = self.chars.get(i) {
            i = match char.quotient {
                Some((nth, _)) => {
                    let is_in = |char: &&Char| char.quotient.is_some_and(|(n, _)| n == nth);
                    let n = self.chars[i..].iter().take_while(is_in).count();
                    self.quotient(i..i + n);
                    i + n
                }
                None => {
                    self.shift = self.glyph(i, self.shift, self.baseline);
                    let glyph = &self.row.glyphs[i];
                    self.places[i] = [glyph.pos.x, glyph.max_x()];
                    i + 1
                }
            };
        }
    }

    /// Puts a glyph `shift` further right, and on this line of letters. How far the next one is moved.
    fn glyph(&mut self, i: usize, shift: f32, baseline: f32) -> f32 {
        let char = &self.chars[i];
        let glyph = self.row.glyphs[i];
        if char.form == Form::Unset {
            let vanish = |pos: &mut egui::Pos2| *pos = pos2(glyph.pos.x + shift, 0.0);
            self.vertices(i, vanish);
            let moved = &mut self.row.glyphs[i];
            moved.pos.x += shift;
            moved.advance_width = 0.0;
            return shift - glyph.advance_width;
        }
        // Where egui has put the line of letters: rows of mixed sizes stand on one bottom.
        let was = glyph.font_ascent + self.row.size.y - glyph.line_height;
        let by = vec2(self.px(shift), self.px(baseline + self.drop(char) - was));
        self.vertices(i, |pos| *pos += by);
        self.row.glyphs[i].pos += by;
        shift
    }

    fn vertices(&mut self, i: usize, change: impl Fn(&mut egui::Pos2)) {
        let glyph = &self.row.glyphs[i];
        if !glyph.uv_rect.is_nothing() {
            let first = glyph.first_vertex as usize;
            let vertices = &mut self.row.visuals.mesh.vertices[first..first + 4];
            for vertex in vertices.iter_mut() {
                change(&mut vertex.pos);
            }
        }
    }

    fn drop(&self, char: &Char) -> f32 {
        match char.form {
            Form::Sub => SUB_DROP * self.script.spans[char.span].font.size,
            Form::Full | Form::Unset => 0.0,
        }
    }

    /// Stacks a quotient's halves over and under a line at the height of a minus.
    fn quotient(&mut self, range: Range<usize>) {
        let span_idx = self.chars[range.start].span;
        let font = &self.script.spans[span_idx].font;
        let em = font.size;
        let (axis, thickness) = minus(&font.family);
        let [num, den] = [Half::Num, Half::Den].map(|half| {
            let is_of = |&i: &usize| self.chars[i].quotient.is_some_and(|(_, h)| h == half);
            range.clone().filter(is_of).collect::<Vec<usize>>()
        });
        let [num_width, den_width] = [&num, &den].map(|half| self.width(half));
        let [num_ink, den_ink] = [&num, &den].map(|half| self.ink(half, em));
        let pixel = 1.0 / self.pixels_per_point;
        let thick = self.px(thickness * em).max(pixel);
        let gap = self.px(BAR_GAP * em).max(pixel);
        let line_top = self.px(self.baseline - axis * em - 0.5 * thick);
        let num_baseline = self.px(line_top - gap - num_ink[1]);
        let den_baseline = self.px(line_top + thick + gap + den_ink[0]);
        let [natural, natural_end] = [self.places[range.start][0], self.places[range.end - 1][1]];
        let left = self.px(natural + self.shift + BESIDE * em);
        let length = self.px(num_width.max(den_width) + 2.0 * OVERHANG * em);
        self.half(&num, left + 0.5 * (length - num_width), num_baseline);
        self.half(&den, left + 0.5 * (length - den_width), den_baseline);
        let bar = Rect::from_min_size(pos2(left, line_top), vec2(length, thick));
        self.bars.push((bar, self.script.spans[span_idx].colour));
        let [top, bottom] = [num_baseline - num_ink[0], den_baseline + den_ink[1]];
        self.out = self.out.max(pixel - top).max(bottom - self.height + pixel);
        let [start, end] = [left - BESIDE * em, left + length + BESIDE * em];
        self.places[range].fill([start, end]);
        self.shift = end - natural_end;
    }

    fn half(&mut self, half: &[usize], start: f32, baseline: f32) {
        let first = half.first().map_or(0.0, |&i| self.places[i][0]);
        let mut shift = start - first;
        for &i in half {
            shift = self.glyph(i, shift, baseline);
        }
    }

    fn width(&self, half: &[usize]) -> f32 {
        let set = half.iter().filter(|&&i| self.chars[i].form != Form::Unset);
        set.map(|&i| self.row.glyphs[i].advance_width).sum()
    }

    fn ink(&self, half: &[usize], em: f32) -> [f32; 2] {
        let set = half.iter().filter(|&&i| self.chars[i].form != Form::Unset);
        set.fold([CAPITAL * HALF_SIZE * em, 0.0], |[above, below], &i| {
            let ink = self.row.glyphs[i].uv_rect;
            let bottom = ink.offset.y + ink.size.y + self.drop(&self.chars[i]);
            // Round digits reach a little below: nothing to make room for.
            let bottom = if bottom < 0.1 * em { 0.0 } else { bottom };
            [above.max(-ink.offset.y), below.max(bottom)]
        })
    }

    /// The row, higher by what stands out, above as below, so that its capitals stay in the middle.
    fn into_row(mut self, galley: &Galley) -> SetRow {
        let out = (self.out * self.pixels_per_point).ceil() / self.pixels_per_point;
        let width = self.places.last().map_or(0.0, |place| place[1]);
        for (bar, colour) in std::mem::take(&mut self.bars) {
            self.row.visuals.mesh.add_colored_rect(bar, colour);
        }
        self.row.visuals.mesh.translate(vec2(0.0, out));
        self.row.visuals.mesh_bounds = self.row.visuals.mesh.calc_bounds();
        for glyph in &mut self.row.glyphs {
            glyph.pos.y += out;
        }
        self.row.size = vec2(width, self.height + 2.0 * out);
        let mut set = galley.clone();
        set.rect = Rect::from_min_size(egui::Pos2::ZERO, self.row.size.round_ui());
        set.mesh_bounds = self.row.visuals.mesh_bounds;
        set.num_vertices = self.row.visuals.mesh.vertices.len();
        set.num_indices = self.row.visuals.mesh.indices.len();
        set.rows[0].row = Arc::new(self.row);
        SetRow {
            galley: Arc::new(set),
            baseline: self.baseline + out,
            places: self.places,
            ends_line: false,
        }
    }

    fn px(&self, x: f32) -> f32 {
        (x * self.pixels_per_point).round() / self.pixels_per_point
    }
}

/// Height of the middle of a minus, and its thickness, in sizes of a font: that of a quotient's line.
fn minus(family: &FontFamily) -> (f32, f32) {
    if *family == FontFamily::Monospace {
        (0.33, 0.08)
    } else if *family == semibold() {
        (0.289, 0.11)
    } else {
        (0.284, 0.08)
    }
}
