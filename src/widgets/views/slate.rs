//! What a view is drawn on: faces, colours and strokes at one scale. It remembers where everything stands, so that
//! a label finds a free place, and a test sees what overlaps.

use egui::{Align2, Color32, FontFamily, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};

use crate::{
    figure::Role,
    paint::{Span, Theme, Typeset, crosses, fonts::semibold},
    text::{Formula, Message, Notation, Piece, Value},
};

use super::super::look::Look;

/// Text is not set smaller than this part of its natural size: what has still no room is folded, or left out.
pub const LEAST_SCALE: f32 = 0.6;

/// Text is set in few sizes: glyphs of each are drawn once, and a run has many steps.
const STEP: f32 = 1.0 / 64.0;

/// The size of a view's title, in points.
const TITLE_PTS: f32 = 13.0;

/// The faces that views are set in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Face {
    /// Words and symbols.
    Plain,
    /// The one that matters in its row.
    Strong,
    /// Codes and numbers that stand in columns.
    Mono,
}

/// How something is set: face, size in points before any scale, colour.
pub type Style = (Face, f32, Color32);

/// A painter with a scale and a memory.
pub struct Slate<'a> {
    /// Paints.
    pub painter: &'a Painter,
    /// Colours and language.
    pub look: Look<'a>,
    /// Factor on every length, text included.
    pub scale: f32,
    /// How the numbers of the view are written; else those of a value suit each other.
    notation: Option<Notation>,
    /// Where text stands.
    pub texts: Vec<Rect>,
    /// What text keeps clear of.
    pub strokes: Vec<[Pos2; 2]>,
}

impl<'a> Slate<'a> {
    /// At natural size.
    pub const fn new(painter: &'a Painter, look: Look<'a>) -> Self {
        Self {
            painter,
            look,
            scale: look.theme.text_scale,
            notation: None,
            texts: Vec::new(),
            strokes: Vec::new(),
        }
    }

    /// As large as `room` lets it be, and at most so many times its natural size; `wanted` says how much a slate of some
    /// scale needs.
    pub fn grown(
        painter: &'a Painter,
        look: Look<'a>,
        room: Vec2,
        most: f32,
        wanted: impl Fn(&Self) -> Vec2,
    ) -> Self {
        let slate = Self::new(painter, look);
        let least = LEAST_SCALE * slate.scale;
        let scale = slate.scale * most;
        Self { scale, ..slate }.shrunk_to(least, room, wanted)
    }

    /// The same where numbers stand beside each other.
    pub fn with_numbers(painter: &'a Painter, look: Look<'a>, notation: Notation) -> Self {
        Self::new(painter, look).writing(notation)
    }

    /// The same slate where numbers stand beside each other.
    pub fn writing(self, notation: Notation) -> Self {
        Self {
            notation: Some(notation),
            ..self
        }
    }

    /// As large as `room` lets it be, and at most of natural size.
    pub fn fitted_in(self, room: Vec2, wanted: impl Fn(&Self) -> Vec2) -> Self {
        let least = LEAST_SCALE * self.scale;
        self.shrunk_to(least, room, wanted)
    }

    /// As large as `room` lets it be, down to this scale.
    pub fn shrunk_to(self, least: f32, room: Vec2, wanted: impl Fn(&Self) -> Vec2) -> Self {
        let mut slate = self;
        // Text does not shrink evenly, as glyphs stand on whole pixels: what comes out is measured again.
        for _ in 0..8 {
            let wanted = wanted(&slate);
            let part = (room.x / wanted.x).min(room.y / wanted.y);
            if part >= 1.0 || slate.scale <= least {
                break;
            }
            let scale = (slate.scale * part / STEP).ceil() - 1.0;
            slate.scale = (scale * STEP).max(least);
        }
        slate
    }

    /// The theme.
    pub const fn theme(&self) -> &'a Theme {
        self.look.theme
    }

    /// A length in points at this scale.
    pub fn pts(&self, natural: f32) -> f32 {
        natural * self.scale
    }

    fn font(&self, face: Face, size: f32) -> FontId {
        let family = match face {
            Face::Plain => FontFamily::Proportional,
            Face::Strong => semibold(),
            Face::Mono => FontFamily::Monospace,
        };
        FontId::new(self.pts(size), family)
    }

    /// A value, set.
    pub fn value(&self, value: &Value, (face, size, colour): Style) -> Typeset {
        let font = self.font(face, size);
        let catalog = self.look.catalog;
        let pieces = match self.notation {
            Some(notation) => catalog.value_pieces_as(value, notation),
            None => catalog.value_pieces(value),
        };
        self.set(pieces, font, colour)
    }

    /// A formula, set.
    pub fn formula(&self, formula: &Formula, (face, size, colour): Style) -> Typeset {
        let font = self.font(face, size);
        let catalog = self.look.catalog;
        let pieces = match self.notation {
            Some(notation) => catalog.formula_pieces_as(formula, notation),
            None => catalog.formula_pieces(formula),
        };
        self.set(pieces, font, colour)
    }

    fn set(&self, pieces: Vec<Piece>, font: FontId, colour: Color32) -> Typeset {
        let span = Span::upright(pieces, font, colour);
        Typeset::line(self.painter, &[span])
    }

    /// Words, set.
    pub fn words(&self, words: impl Into<String>, (face, size, colour): Style) -> Typeset {
        let font = self.font(face, size);
        Typeset::text(self.painter, words.into(), font, colour)
    }

    /// A value on one plain line, its quotients not stacked: where rows are low.
    pub fn low(&self, value: &Value, style: Style) -> Typeset {
        let catalog = self.look.catalog;
        let words = match self.notation {
            Some(notation) => catalog.value_as(value, notation),
            None => catalog.value(value),
        };
        self.words(words, style)
    }

    /// A sentence, on as many lines as it takes.
    pub fn sentence(&self, message: &Message, width: f32, (face, size, colour): Style) -> Typeset {
        let font = self.font(face, size);
        let catalog = self.look.catalog;
        let pieces = match self.notation {
            Some(notation) => catalog.message_pieces_as(message, notation),
            None => catalog.message_pieces(message),
        };
        Typeset::wrapped(self.painter, &[Span::upright(pieces, font, colour)], width)
    }

    /// Paints it with this corner, edge or middle of its box at `at`; the box.
    pub fn put(&mut self, text: &Typeset, at: Pos2, align: Align2) -> Rect {
        let rect = text.paint(self.painter, at, align);
        self.texts.push(rect);
        rect
    }

    /// A view's title in its upper left corner, smaller where there is little room.
    pub fn title(&mut self, title: &Value, room: Rect) {
        let style = |pts: f32| (Face::Strong, pts, self.theme().ink);
        let set = self.value(title, style(TITLE_PTS));
        let part = room.width() / set.size().x;
        let set = if part < 1.0 {
            self.value(title, style(0.97 * part * TITLE_PTS))
        } else {
            set
        };
        self.put(&set, room.min, Align2::LEFT_TOP);
    }

    /// Is there nothing within this rectangle and beside it?
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

    /// A stroke of this theme.
    pub fn stroke(&self, width: f32, colour: Color32) -> Stroke {
        self.theme().stroke(width, colour)
    }

    /// A line that text keeps clear of.
    pub fn line(&mut self, ends: [Pos2; 2], stroke: Stroke) {
        self.painter.line_segment(ends, stroke);
        self.strokes.push(ends);
    }

    /// A dashed line that text keeps clear of.
    pub fn dashed(&mut self, ends: [Pos2; 2], stroke: Stroke, dash: f32) {
        let dash = self.pts(dash);
        let shapes = Shape::dashed_line(&ends, stroke, dash, 0.75 * dash);
        self.painter.extend(shapes);
        self.strokes.push(ends);
    }

    /// An arrowhead with its tip here, as long as this, pointing along `along`.
    pub fn head(&mut self, tip: Pos2, along: Vec2, length: f32, colour: Color32) {
        let along = along.normalized() * length;
        let across = along.rot90() * 0.48;
        let foot = tip - along;
        let corners = vec![tip, foot + across, foot - across];
        let head = Shape::convex_polygon(corners, colour, Stroke::NONE);
        self.painter.add(head);
        self.strokes.push([tip, foot]);
    }

    /// A line with a head at its second end.
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

    /// How long the head of an arrow of this width is.
    pub fn head_length(&self, width: f32) -> f32 {
        self.pts(6.0) + 2.0 * width
    }
}

/// The colour of marks of a role.
pub const fn colour(theme: &Theme, role: Role) -> Color32 {
    match role {
        Role::Ink => theme.ink,
        Role::Soft => theme.soft,
        Role::Faint => theme.faint,
        Role::Accent => theme.accent,
        Role::Signal => theme.signal,
        Role::Accepted => theme.accepted,
        Role::Discarded => theme.discarded,
    }
}

/// The colour of text of a role: thinner than strokes, so darker where those are light.
pub const fn text_colour(theme: &Theme, role: Role) -> Color32 {
    match role {
        Role::Signal => theme.signal_text,
        Role::Accepted => theme.accepted,
        Role::Faint | Role::Discarded => theme.soft,
        Role::Ink | Role::Soft | Role::Accent => colour(theme, role),
    }
}

/// The colour of a surface that belongs to a role.
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
