//! What is written on a page: paths, text and pictures. Within a part y points down, as in the drawing.

use std::collections::BTreeSet;

use egui::{Color32, Pos2, Rect, Vec2, pos2};
use pdf_writer::{Content, Name, Str, TextStr, writers::Resources};

use crate::export::vector::page::{
    Drawn, Form, Item, Letter, Path, Run, SLANT, Text, VectorPage, What,
};

use super::{fonts::Fonts, parts::PdfPart, pictures, tags};

/// Of a quarter of a circle by one curve.
const ROUND: f32 = 0.552_285;

pub struct Contents<'a> {
    content: Content,
    size: Vec2,
    place: Place,
    fonts: &'a Fonts,
    n_pictures: usize,
}

/// Where a part stands on its page, of which y points up.
#[derive(Clone, Copy, Default)]
struct Place {
    left: f32,
    top: f32,
    scale: f32,
}

impl Place {
    fn at(self, at: Pos2) -> [f32; 2] {
        [self.left + self.scale * at.x, self.top - self.scale * at.y]
    }

    /// Its lower left corner, and its size.
    fn rect(self, rect: Rect) -> [f32; 4] {
        let [x, y] = self.at(rect.left_bottom());
        [x, y, self.scale * rect.width(), self.scale * rect.height()]
    }
}

impl<'a> Contents<'a> {
    /// The first picture on the page is the file's `n_pictures`th.
    pub fn new(size: Vec2, fonts: &'a Fonts, n_pictures: usize) -> Self {
        Self {
            content: Content::new(),
            size,
            place: Place::default(),
            fonts,
            n_pictures,
        }
    }

    pub const fn n_pictures(&self) -> usize {
        self.n_pictures
    }

    pub fn finish(self) -> Vec<u8> {
        self.content.finish().into_vec()
    }

    pub fn part(&mut self, part: &PdfPart<'_>, mark: Option<i32>) {
        let name = tags::name(&part.tag);
        match mark {
            Some(mark) => {
                let mut marked = self.content.begin_marked_content_with_properties(name);
                marked.properties().identify(mark);
            }
            None => {
                self.content.begin_marked_content(Name(b"Artifact"));
            }
        }
        self.place = Place {
            left: part.at.x,
            top: self.size.y - part.at.y,
            scale: part.scale,
        };
        self.ground(part);
        for item in &part.drawing.items {
            if let Item::Drawn(drawn) = item {
                self.drawn(drawn);
            }
        }
        self.content.end_marked_content();
    }

    /// Of a drawing that has a page for itself.
    fn ground(&mut self, part: &PdfPart<'_>) {
        if part.rect().size() == self.size {
            let ground = Path {
                form: Form::Rect(Rect::from_min_size(Pos2::ZERO, part.drawing.size), 0.0),
                fill: Some(part.drawing.theme.background),
                stroke: None,
            };
            self.path(&ground);
        }
    }

    fn drawn(&mut self, drawn: &Drawn) {
        if let Some(clip) = drawn.clip {
            self.content.save_state();
            let [x, y, width, height] = self.place.rect(clip);
            self.content.rect(x, y, width, height);
            self.content.clip_nonzero().end_path();
        }
        match &drawn.what {
            What::Path(path) => self.path(path),
            What::Text(text) => self.text(text),
            What::Picture(picture) => {
                self.content.save_state();
                let [x, y, width, height] = self.place.rect(picture.rect);
                self.content.transform([width, 0.0, 0.0, height, x, y]);
                self.content
                    .x_object(Name(pictures::name(self.n_pictures).as_bytes()));
                self.content.restore_state();
                self.n_pictures += 1;
            }
        }
        if drawn.clip.is_some() {
            self.content.restore_state();
        }
    }

    fn path(&mut self, path: &Path) {
        let colours = [path.fill, path.stroke.map(|(_, colour)| colour)];
        let is_faded = colours.iter().flatten().any(|colour| colour.a() < 255);
        if is_faded {
            self.content.save_state();
        }
        if let Some(colour) = path.fill {
            let [r, g, b] = plain(colour);
            self.content.set_fill_rgb(r, g, b);
        }
        if let Some((width, colour)) = path.stroke {
            let [r, g, b] = plain(colour);
            self.content
                .set_stroke_rgb(r, g, b)
                .set_line_width(self.place.scale * width);
        }
        for colour in colours
            .into_iter()
            .flatten()
            .filter(|colour| colour.a() < 255)
        {
            self.content
                .set_parameters(Name(alpha_name(colour.a()).as_bytes()));
        }
        self.form(&path.form);
        match (path.fill, path.stroke) {
            (Some(_), Some(_)) => self.content.fill_even_odd_and_stroke(),
            (Some(_), None) if path.form.are_triangles() => self.content.fill_nonzero(),
            (Some(_), None) => self.content.fill_even_odd(),
            (None, Some(_)) => self.content.stroke(),
            (None, None) => self.content.end_path(),
        };
        if is_faded {
            self.content.restore_state();
        }
    }

    fn form(&mut self, form: &Form) {
        match form {
            Form::Lines(runs) => runs.iter().for_each(|run| self.line(run)),
            Form::Circle(middle, radius) => {
                let rect = Rect::from_center_size(*middle, Vec2::splat(2.0 * radius));
                self.rounded(rect, *radius);
            }
            Form::Rect(rect, 0.0) => {
                let [x, y, width, height] = self.place.rect(*rect);
                self.content.rect(x, y, width, height);
            }
            Form::Rect(rect, radius) => self.rounded(*rect, *radius),
        }
    }

    fn line(&mut self, run: &Run) {
        for (i, at) in run.points.iter().enumerate() {
            let [x, y] = self.place.at(*at);
            if i == 0 {
                self.content.move_to(x, y);
            } else {
                self.content.line_to(x, y);
            }
        }
        if run.is_closed {
            self.content.close_path();
        }
    }

    fn rounded(&mut self, rect: Rect, radius: f32) {
        let radius = radius.min(0.5 * rect.width()).min(0.5 * rect.height());
        let (out, inner) = (radius, radius * (1.0 - ROUND));
        let Rect { min, max } = rect;
        let [x, y] = self.place.at(pos2(min.x + out, min.y));
        self.content.move_to(x, y);
        for [from, a, b, to] in [
            [
                pos2(max.x - out, min.y),
                pos2(max.x - inner, min.y),
                pos2(max.x, min.y + inner),
                pos2(max.x, min.y + out),
            ],
            [
                pos2(max.x, max.y - out),
                pos2(max.x, max.y - inner),
                pos2(max.x - inner, max.y),
                pos2(max.x - out, max.y),
            ],
            [
                pos2(min.x + out, max.y),
                pos2(min.x + inner, max.y),
                pos2(min.x, max.y - inner),
                pos2(min.x, max.y - out),
            ],
            [
                pos2(min.x, min.y + out),
                pos2(min.x, min.y + inner),
                pos2(min.x + inner, min.y),
                pos2(min.x + out, min.y),
            ],
        ] {
            let [from, a, b, to] = [from, a, b, to].map(|at| self.place.at(at));
            self.content.line_to(from[0], from[1]);
            self.content.cubic_to(a[0], a[1], b[0], b[1], to[0], to[1]);
        }
        self.content.close_path();
    }

    /// Read aloud and copied as it is said, however it is set.
    fn text(&mut self, text: &Text) {
        let mut marked = self
            .content
            .begin_marked_content_with_properties(Name(b"Span"));
        marked.properties().actual_text(TextStr(&text.plain));
        drop(marked);
        self.content.begin_text();
        for run in text.runs() {
            self.letters(text, run);
        }
        self.content.end_text();
        self.content.end_marked_content();
        text.bars.iter().for_each(|bar| self.path(bar));
    }

    fn letters(&mut self, text: &Text, letters: &[Letter]) {
        let Some(font) = self.fonts.of_letter(&letters[0]) else {
            return;
        };
        let Letter {
            font: id,
            colour,
            at,
            is_italic,
            ..
        } = &letters[0];
        let [r, g, b] = plain(*colour);
        self.content.set_fill_rgb(r, g, b);
        let size = self.place.scale * id.size;
        self.content.set_font(Name(font.name.as_bytes()), size);
        let slant = if *is_italic { SLANT } else { 0.0 };
        let [x, y] = self.place.at(text.turn.place(*at));
        let (sin, cos) = libm::sincosf(-text.turn.radians);
        let matrix = [cos, sin, slant * cos - sin, slant * sin + cos, x, y];
        self.content.set_text_matrix(matrix);
        let mut shown = self.content.show_positioned();
        let mut items = shown.items();
        let mut x = at.x;
        for letter in letters {
            let back = (x - letter.at.x) * 1000.0 / id.size;
            if back.abs() > 1.0 {
                items.adjust(back);
                x = letter.at.x;
            }
            items.show(Str(&font.glyph(letter.c).to_be_bytes()));
            x += font.width(letter.c) * id.size / 1000.0;
        }
    }
}

fn plain(colour: Color32) -> [f32; 3] {
    let [r, g, b, _] = colour.to_srgba_unmultiplied();
    [r, g, b].map(|channel| f32::from(channel) / 255.0)
}

fn alpha_name(alpha: u8) -> String {
    format!("A{alpha}")
}

/// Of the drawings' paths, all that are not solid.
pub fn alphas<'a>(drawings: impl Iterator<Item = &'a VectorPage>) -> BTreeSet<u8> {
    let mut alphas = BTreeSet::new();
    for item in drawings.flat_map(|drawing| &drawing.items) {
        let Item::Drawn(drawn) = item else { continue };
        for path in drawn.paths() {
            let colours = [path.fill, path.stroke.map(|(_, colour)| colour)];
            alphas.extend(colours.into_iter().flatten().map(|colour| colour.a()));
        }
    }
    alphas.remove(&255);
    alphas
}

pub fn name_alphas(resources: &mut Resources<'_>, alphas: &BTreeSet<u8>) {
    let mut states = resources.ext_g_states();
    for &alpha in alphas {
        let name = alpha_name(alpha);
        let state = states.insert(Name(name.as_bytes()));
        let mut state = state.start::<pdf_writer::writers::ExtGraphicsState<'_>>();
        let alpha = f32::from(alpha) / 255.0;
        state.non_stroking_alpha(alpha).stroking_alpha(alpha);
    }
}
