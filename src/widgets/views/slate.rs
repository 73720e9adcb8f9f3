//! What a view is drawn on: faces, colours and strokes at one scale. It remembers where everything stands, so that
//! a label finds a free place, and a test sees what overlaps.

use egui::FontFamily;

use crate::{
    figure::{Chip, Role},
    paint::{crosses, fonts::semibold, stroke_colour},
    text::Piece,
};

use super::{super::prelude::*, fold::more};

/// Text is not set smaller than this part of its natural size: what has still no room is folded, or left out.
pub const LEAST_SCALE: f32 = 0.6;
/// Text is set in few sizes: glyphs of each are drawn once, and a run has many steps.
const STEP: f32 = 1.0 / 64.0;
const TITLE_PTS: f32 = 13.0;
/// What is so many times as wide as high is a row.
const ROW: f32 = 1.6;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Face {
    Plain,
    Strong,
    Mono,
}

impl Face {
    pub const fn strong_if(is_strong: bool) -> Self {
        if is_strong { Self::Strong } else { Self::Plain }
    }
}

pub type Style = (Face, f32, Color32);

/// A painter with a scale and a memory.
pub struct Slate<'a> {
    pub painter: &'a Painter,
    pub look: Look<'a>,
    pub scale: f32,
    pub texts: Vec<Rect>,
    pub strokes: Vec<[Pos2; 2]>,
}

impl<'a> Slate<'a> {
    pub const fn new(painter: &'a Painter, look: Look<'a>) -> Self {
        Self {
            painter,
            look,
            scale: look.theme.text_scale,
            texts: Vec::new(),
            strokes: Vec::new(),
        }
    }

    /// As large as `room` lets it be, and never larger than other text; `wanted` is what a slate of some scale needs.
    pub fn fitted_in(self, room: Vec2, wanted: impl Fn(&Self) -> Vec2) -> Self {
        let least = LEAST_SCALE * self.scale;
        self.shrunk_to(least, room, wanted)
    }

    pub fn shrunk_to(mut self, least: f32, room: Vec2, wanted: impl Fn(&Self) -> Vec2) -> Self {
        // Text does not shrink evenly, as glyphs stand on whole pixels: what comes out is measured again.
        for _ in 0..8 {
            let wanted = wanted(&self);
            let part = (room.x / wanted.x).min(room.y / wanted.y);
            if part >= 1.0 || self.scale <= least {
                break;
            }
            let scale = (self.scale * part / STEP).ceil() - 1.0;
            self.scale = (scale * STEP).max(least);
        }
        self
    }

    pub const fn theme(&self) -> &'a Theme {
        self.look.theme
    }

    pub fn pts(&self, natural: f32) -> f32 {
        natural * self.scale
    }

    /// The least size, of those that are natural, in which text is set.
    pub fn least_size(&self) -> f32 {
        self.theme().least_text / self.scale
    }

    fn font(&self, face: Face, size: f32) -> FontId {
        let family = match face {
            Face::Plain => FontFamily::Proportional,
            Face::Strong => semibold(),
            Face::Mono => FontFamily::Monospace,
        };
        FontId::new(self.pts(size).max(self.theme().least_text), family)
    }

    fn set(&self, pieces: Vec<Piece>, (face, size, colour): Style) -> Typeset {
        let span = Span::upright(pieces, self.font(face, size), colour);
        Typeset::line(self.painter, &[span])
    }

    pub fn value(&self, value: &Value, style: Style) -> Typeset {
        self.set(self.look.catalog.value_pieces(value), style)
    }

    pub fn formula(&self, formula: &Formula, style: Style) -> Typeset {
        self.set(self.look.catalog.formula_pieces(formula), style)
    }

    pub fn words(&self, words: impl AsRef<str>, (face, size, colour): Style) -> Typeset {
        Typeset::text(self.painter, words, self.font(face, size), colour)
    }

    pub fn low(&self, value: &Value, style: Style) -> Typeset {
        self.words(self.look.catalog.value(value), style)
    }

    /// A number of just this size, also where other text is larger.
    pub fn digits(&self, value: &Value, size: f32, colour: Color32) -> Typeset {
        let font = FontId::new(self.pts(size), FontFamily::Monospace);
        Typeset::text(self.painter, self.look.catalog.value(value), font, colour)
    }

    pub fn width(&self, value: &Value, face: Face, size: f32) -> f32 {
        let style = (face, size, Color32::PLACEHOLDER);
        self.value(value, style).size().x
    }

    pub fn sentence(&self, message: &Message, width: f32, (face, size, colour): Style) -> Typeset {
        let pieces = self.look.catalog.message_pieces(message);
        let span = Span::upright(pieces, self.font(face, size), colour);
        Typeset::wrapped(self.painter, &[span], width)
    }

    pub fn wrapped(&self, value: &Value, width: f32, (face, size, colour): Style) -> Typeset {
        let span = Span::upright(
            self.look.catalog.value_pieces(value),
            self.font(face, size),
            colour,
        );
        Typeset::wrapped(self.painter, &[span], width)
    }

    pub fn more(&self, count: usize, size: f32) -> Typeset {
        let words = self.look.catalog.message(&more(count));
        self.words(words, (Face::Plain, size, self.theme().soft))
    }

    pub fn put(&mut self, text: &Typeset, at: Pos2, align: Align2) -> Rect {
        let rect = text.paint(self.painter, at, align);
        self.texts.push(rect);
        rect
    }

    pub fn title(&mut self, title: &Value, room: Rect) {
        let style = |pts: f32| (Face::Strong, pts, self.theme().ink);
        let mut set = self.value(title, style(TITLE_PTS));
        let part = room.width() / set.size().x;
        if part < 1.0 {
            let pts = 0.97 * part * TITLE_PTS;
            set = if pts < self.least_size() {
                self.wrapped(title, room.width(), style(pts))
            } else {
                self.value(title, style(pts))
            };
        }
        self.put(&set, room.min, Align2::LEFT_TOP);
    }

    pub fn is_free(&self, place: Rect) -> bool {
        let around = place.expand2(vec2(self.pts(5.0), self.pts(1.0)));
        self.texts.iter().all(|text| !text.intersects(around))
            && !self.strokes.iter().any(|&stroke| crosses(stroke, around))
    }

    /// Paints it centred at the first of these places that is free, if there is one; its box.
    pub fn put_free(
        &mut self,
        text: &Typeset,
        room: Rect,
        centres: impl IntoIterator<Item = Pos2>,
    ) -> Option<Rect> {
        let place = |centre| Rect::from_center_size(centre, text.size());
        let mut centres = centres.into_iter();
        let free = |at: &Pos2| room.contains_rect(place(*at)) && self.is_free(place(*at));
        let centre = centres.find(free)?;
        Some(self.put(text, centre, Align2::CENTER_CENTER))
    }

    pub fn stroke(&self, width: f32, colour: Color32) -> Stroke {
        self.theme().stroke(width, colour)
    }

    pub fn line(&mut self, ends: [Pos2; 2], stroke: Stroke) {
        self.painter.line_segment(ends, stroke);
        self.strokes.push(ends);
    }

    pub fn dashed(&mut self, ends: [Pos2; 2], stroke: Stroke, dash: f32) {
        self.dashes(&ends, stroke, dash, 0.75);
        self.strokes.push(ends);
    }

    pub fn dashes(&self, path: &[Pos2], stroke: Stroke, dash: f32, gap: f32) {
        let dash = self.pts(dash);
        let shapes = Shape::dashed_line(path, stroke, dash, gap * dash);
        self.painter.extend(shapes);
    }

    pub fn dashed_box(&self, place: Rect, stroke: Stroke, gap: f32) {
        let [a, c] = [place.min, place.max];
        let [b, d] = [place.right_top(), place.left_bottom()];
        self.dashes(&[a, b, c, d, a], stroke, 3.5, gap);
    }

    pub fn rim(&self, place: Rect, corner: f32, stroke: Stroke, kind: StrokeKind) {
        self.painter.rect_stroke(place, corner, stroke, kind);
    }

    pub fn area(&self, corners: Vec<Pos2>, colour: Color32) {
        let area = Shape::convex_polygon(corners, colour, Stroke::NONE);
        self.painter.add(area);
    }

    pub fn ring(&self, place: Rect, corner: f32, width: f32) {
        let stroke = self.stroke(width, self.theme().accent);
        self.rim(place, corner, stroke, StrokeKind::Middle);
    }

    pub fn head(&mut self, tip: Pos2, along: Vec2, length: f32, colour: Color32) {
        let along = along.normalized() * length;
        let across = along.rot90() * 0.48;
        let foot = tip - along;
        self.area(vec![tip, foot + across, foot - across], colour);
        self.strokes.push([tip, foot]);
    }

    pub fn arrow(&mut self, [from, to]: [Pos2; 2], stroke: Stroke) {
        let length = self.head_length(stroke.width);
        let along = to - from;
        if along.length() <= length {
            self.head(to, along, along.length().max(1.0), stroke.color);
            return;
        }
        let shaft = to - along.normalized() * 0.7 * length;
        self.line([from, shaft], stroke);
        self.head(to, along, length, stroke.color);
    }

    pub fn head_length(&self, width: f32) -> f32 {
        self.pts(6.0) + 2.0 * width
    }
}

pub fn cross(at: Pos2, arm: f32) -> [[Pos2; 2]; 2] {
    [-arm, arm].map(|y| [at + vec2(-arm, -y), at + vec2(arm, y)])
}

/// As on the stage, but what may be missed is fainter.
pub const fn colour(theme: &Theme, role: Role) -> Color32 {
    match role {
        Role::Faint => theme.faint,
        role => stroke_colour(theme, role),
    }
}

pub fn wash(theme: &Theme, role: Role) -> Color32 {
    let tint = |colour| theme.background.lerp_to_gamma(colour, 0.1);
    match role {
        Role::Signal => tint(theme.signal),
        Role::Accent => theme.accent_wash,
        Role::Accepted => tint(theme.accepted),
        Role::Ink | Role::Soft | Role::Faint => theme.panel,
        Role::Discarded => theme.background,
    }
}

pub const DARKEST: f32 = 0.45;

/// Of what is seen in a picture, the darker the larger the shade, light enough for ink.
pub fn tone(theme: &Theme, role: Role, shade: f64) -> Color32 {
    shaded(theme, role, shade, DARKEST)
}

pub fn shaded(theme: &Theme, role: Role, shade: f64, darkest: f32) -> Color32 {
    let colour = match role {
        Role::Ink | Role::Soft | Role::Faint | Role::Discarded => theme.soft,
        Role::Accent | Role::Signal | Role::Accepted => colour(theme, role),
    };
    let strength = 0.1 + (darkest - 0.1) * shade.clamp(0.0, 1.0) as f32;
    colour.gamma_multiply(strength)
}

/// What a kind of view has to say so that it is drawn.
pub trait OnSlate {
    /// A slate on which it is as large as the room lets it be, from one of natural size.
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a>;
    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links);
    fn spoken(&self, look: Look<'_>) -> String;
}

/// The pointer, what stands out, and what was found.
#[derive(Default)]
pub struct Links {
    pub lit: Option<Link>,
    pub pointer: Option<Pos2>,
    pub pointed: Option<Link>,
    /// What might come and has no place here yet, and what has one.
    pub chips: Vec<Chip>,
    pub placed: Vec<(Rect, Chip)>,
}

impl Links {
    /// A part with this link takes this place: does it stand out?
    pub fn touch(&mut self, place: Rect, link: Option<Link>) -> bool {
        let is_near = self.pointer.is_some_and(|pointer| place.contains(pointer));
        if is_near && link.is_some() {
            self.pointed = link;
        }
        let is_about = |chip: &Chip| link.is_some() && chip.link == link;
        if let Some(nth) = self.chips.iter().position(is_about) {
            self.placed.push((place, self.chips.swap_remove(nth)));
        }
        link.is_some() && (is_near || link == self.lit)
    }

    /// The chips of what stands here: before a row, on the upper edge of a column, in the corner of what is as high as wide.
    pub fn draw_chips(&self, painter: &Painter, theme: &Theme) {
        for &(place, chip) in &self.placed {
            let size = chip.size(theme);
            let centre = if place.width() > ROW * place.height() {
                place.left_center() - vec2(0.5 * size.x + 3.0, 0.0)
            } else if place.height() > ROW * place.width() {
                place.center_top()
            } else {
                place.min
            };
            let is_lit = chip.link == self.lit;
            chip.draw(painter, theme, centre, is_lit);
        }
    }
}

/// What is said before the part that this step is about.
pub const fn now(is_now: bool) -> &'static str {
    if is_now { "→ " } else { "" }
}

pub fn joined(parts: impl Iterator<Item = String>, between: &str) -> String {
    parts.collect::<Vec<_>>().join(between)
}

/// `name (one, two)`.
pub fn bracketed(name: &str, details: impl Iterator<Item = String>) -> String {
    match joined(details, ", ") {
        details if details.is_empty() => name.to_owned(),
        details => format!("{name} ({details})"),
    }
}
