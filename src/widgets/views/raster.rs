//! A raster in large pixels: squares with what is stored in them, the current one ringed.

use egui::{Align2, Color32, Painter, Pos2, Rect, StrokeKind, Vec2, vec2};

use crate::{
    figure::{Link, Raster, RasterMark, RasterShape, Role},
    paint::Theme,
    text::Value,
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate, colour},
};

/// Pixels are at most this wide, in points before any scale.
const MOST_WIDTH: f32 = 40.0;
/// Room for the title.
const TITLE: f32 = 28.0;
/// Room for the scale of shades, and so many of them are told apart.
const SCALE: f32 = 28.0;
const SHADES: usize = 16;
/// Smaller ones have no lines between them.
const LEAST_IN_GRID: f32 = 9.0;
/// What is stored is written in this size at most, and at least; in points.
const LARGEST: f32 = 11.0;
const SMALLEST: f32 = 4.5;
/// Width of a character over its size, and of the white space around all.
const CHARACTER: f32 = 0.6;
const AROUND: f32 = 0.3;
/// Numbers are as large as so many digits have room for.
const DIGITS: usize = 3;
/// The darkest that a shade may be under ink, and where there is none.
const DARKEST: f32 = 0.45;
const DARKEST_BARE: f32 = 0.9;
/// Half a cross in points; of one aside from what is written, its place from the pixel's middle and half of it, in pixels.
const ARM: f32 = 4.5;
const ASIDE: [f64; 2] = [0.34, -0.34];
const ASIDE_ARM: f32 = 0.1;

impl OnSlate for Raster {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, _rect: Rect) -> Slate<'a> {
        Slate::new(painter, look)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        slate.title(&self.title, rect);
        let origin = rect.min + vec2(0.0, slate.pts(TITLE));
        let width = self.pixel_width(slate, rect);
        self.fill(slate, origin, width);
        if width >= slate.pts(LEAST_IN_GRID) {
            self.grid(slate, origin, width);
        } else {
            let [columns, rows] = self.size.map(|n| n as f32 * width);
            let whole = Rect::from_min_size(origin.round(), vec2(columns, rows));
            let line = slate.theme().stroke(2.0, slate.theme().hairline);
            slate
                .painter
                .rect_stroke(whole, 0.0, line, StrokeKind::Outside);
        }
        let (lines, points) = self
            .over
            .iter()
            .partition::<Vec<_>, _>(|mark| mark.is_line());
        for mark in lines {
            draw_over(slate, (origin.round(), width), mark);
        }
        if let Some(current) = self.current {
            ring(slate, square(origin, width, current));
        }
        self.write(slate, origin, width);
        if let Some(at) = links.pointer
            && let Some(pixel) = self.pixel_at(origin, width, at)
        {
            links.pointed = Some(Link::nth(Self::LINK, pixel[1] * self.size[0] + pixel[0]));
        }
        if let Some(ends) = &self.scale {
            self.draw_scale(slate, (origin, width), ends);
        }
        for mark in points {
            match mark.shape {
                RasterShape::Cross(at) if self.is_written(slate, width, at) => {
                    let middle = vec2((at[0] + ASIDE[0]) as f32, (at[1] + ASIDE[1]) as f32);
                    let ink = colour(slate.theme(), mark.role);
                    cross(
                        slate,
                        origin.round() + middle * width,
                        ASIDE_ARM * width,
                        ink,
                    );
                }
                RasterShape::Cross(_) | RasterShape::Dot(_) | RasterShape::Line(_) => {
                    draw_over(slate, (origin.round(), width), mark);
                }
            }
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let stored = self.current.and_then(|at| self.at(at));
        let stored = stored.and_then(|pixel| pixel.value.as_ref());
        let title = look.catalog.value(&self.title);
        match stored {
            Some(value) => format!("{title}: {}", look.catalog.value(value)),
            None => title,
        }
    }
}

impl Raster {
    /// What is stored, paler where nothing has been drawn.
    fn write(&self, slate: &mut Slate<'_>, origin: Pos2, width: f32) {
        let theme = slate.theme();
        for row in 0..self.size[1] {
            for column in 0..self.size[0] {
                let Some(pixel) = self.at([column, row]) else {
                    continue;
                };
                let ink = pixel.role.map_or(theme.soft, |_| theme.ink);
                if let Some(value) = &pixel.value {
                    write(slate, square(origin, width, [column, row]), (value, ink));
                }
            }
        }
    }

    /// Tones, each as far to the right as it goes: there may be very many pixels.
    fn fill(&self, slate: &Slate<'_>, origin: Pos2, width: f32) {
        let darkest = self.darkest(slate, width);
        let tone_at = |column: usize, row: usize| {
            let pixel = self.at([column, row])?;
            Some(shaded(slate.theme(), pixel.role?, pixel.shade, darkest))
        };
        let [columns, rows] = self.size;
        for row in 0..rows {
            let mut column = 0;
            while column < columns {
                let tone = tone_at(column, row);
                let run = (column..columns).take_while(|&other| tone_at(other, row) == tone);
                let end = column + run.count();
                if let Some(tone) = tone {
                    let first = square(origin, width, [column, row]);
                    let last = square(origin, width, [end - 1, row]);
                    slate.painter.rect_filled(first.union(last), 0.0, tone);
                }
                column = end;
            }
        }
    }

    /// Where shades are to be read off, and no numbers with them, they go as far as they can.
    fn darkest(&self, slate: &Slate<'_>, width: f32) -> f32 {
        if self.scale.is_some() && number_pts(slate, width, DIGITS) < SMALLEST {
            DARKEST_BARE
        } else {
            DARKEST
        }
    }

    /// Lines between pixels, and around all.
    fn grid(&self, slate: &Slate<'_>, origin: Pos2, width: f32) {
        let theme = slate.theme();
        let line = theme.stroke(2.0, theme.hairline);
        let [columns, rows] = self.size.map(|n| n as f32 * width);
        let at = origin.round();
        let along = |n: usize| (0..=n).map(move |i| i as f32 * width);
        for x in along(self.size[0]) {
            slate.painter.vline(at.x + x, at.y..=at.y + rows, line);
        }
        for y in along(self.size[1]) {
            slate.painter.hline(at.x..=at.x + columns, at.y + y, line);
        }
    }

    /// Under the pixels, as wide as they are: from the darkest shade to the palest, between what they stand for.
    fn draw_scale(&self, slate: &mut Slate<'_>, (origin, width): (Pos2, f32), ends: &[Value; 2]) {
        let [columns, rows] = self.size.map(|n| n as f32 * width);
        let top = origin.round() + vec2(0.0, rows + 0.5 * slate.pts(SCALE));
        let style = (Face::Plain, LARGEST, slate.theme().soft);
        let [near, far] = ends.each_ref().map(|end| slate.low(end, style));
        let near = slate.put(&near, top, Align2::LEFT_CENTER);
        let far = slate.put(&far, top + vec2(columns, 0.0), Align2::RIGHT_CENTER);
        let gap = slate.pts(8.0);
        let bar = Rect::from_x_y_ranges(near.right() + gap..=far.left() - gap, near.y_range());
        let step = bar.width() / SHADES as f32;
        let darkest = self.darkest(slate, width);
        for i in 0..SHADES {
            let [left, right] = [i, i + 1].map(|i| (bar.left() + i as f32 * step).round());
            let part = Rect::from_x_y_ranges(left..=right, bar.y_range());
            let shade = 1.0 - (i as f64 + 0.5) / SHADES as f64;
            let tone = shaded(slate.theme(), Role::Soft, shade, darkest);
            slate.painter.rect_filled(part, 0.0, tone);
        }
    }

    /// Is there something to read at a place in pixels?
    fn is_written(&self, slate: &Slate<'_>, width: f32, at: [f64; 2]) -> bool {
        let pixel = self.at(at.map(|x| x as usize));
        let value = pixel.and_then(|pixel| pixel.value.as_ref());
        value.is_some_and(|value| value_pts(slate, width, value) >= SMALLEST)
    }

    /// The pixel at a place on the screen.
    fn pixel_at(&self, origin: Pos2, width: f32, at: Pos2) -> Option<[usize; 2]> {
        let place = (at - origin.round()) / width;
        let [column, row] = [place.x, place.y].map(f32::floor);
        let is_in = column >= 0.0 && row >= 0.0;
        let pixel = [column as usize, row as usize];
        (is_in && (0..2).all(|i| pixel[i] < self.size[i])).then_some(pixel)
    }

    /// Whole pixels of the screen, so that all squares are alike.
    fn pixel_width(&self, slate: &Slate<'_>, rect: Rect) -> f32 {
        let [columns, rows] = self.size.map(|n| n.max(1) as f32);
        let scale = if self.scale.is_some() { SCALE } else { 0.0 };
        let height = rect.height() - slate.pts(TITLE + scale);
        let fits = (rect.width() / columns).min(height / rows);
        fits.min(slate.pts(MOST_WIDTH)).floor().max(1.0)
    }
}

fn square(origin: Pos2, width: f32, [column, row]: [usize; 2]) -> Rect {
    let at = origin.round() + vec2(column as f32, row as f32) * width;
    Rect::from_min_size(at, Vec2::splat(width))
}

/// What is stored at a pixel, if it can be read.
fn write(slate: &mut Slate<'_>, place: Rect, (value, ink): (&Value, Color32)) {
    let pts = value_pts(slate, place.width(), value);
    if pts < SMALLEST {
        return;
    }
    let text = slate.low(value, (Face::Mono, pts, ink));
    if text.size().x <= place.width() {
        slate.put(&text, place.center(), Align2::CENTER_CENTER);
    }
}

/// The size of what is stored in a pixel of this width.
fn value_pts(slate: &Slate<'_>, width: f32, value: &Value) -> f32 {
    let n_characters = match value {
        Value::Name(name) => name.chars().count(),
        _ => DIGITS,
    };
    number_pts(slate, width, n_characters)
}

/// The size of so many characters in a pixel of this width.
fn number_pts(slate: &Slate<'_>, width: f32, n_characters: usize) -> f32 {
    let wide = CHARACTER * n_characters as f32 + AROUND;
    (width / (wide * slate.pts(1.0))).min(LARGEST)
}

/// A role's tone, the darker the larger the shade, light enough for ink.
pub fn tone(theme: &Theme, role: Role, shade: f64) -> Color32 {
    shaded(theme, role, shade, DARKEST)
}

fn shaded(theme: &Theme, role: Role, shade: f64, darkest: f32) -> Color32 {
    let colour = match role {
        Role::Ink | Role::Soft | Role::Faint | Role::Discarded => theme.soft,
        Role::Accent => theme.accent,
        Role::Signal => theme.signal,
        Role::Accepted => theme.accepted,
    };
    let strength = 0.1 + (darkest - 0.1) * shade.clamp(0.0, 1.0) as f32;
    colour.gamma_multiply(strength)
}

/// A line with a casing that is seen on any tone.
fn cased(slate: &Slate<'_>, ends: [Pos2; 2], wide: f32, ink: Color32) {
    let theme = slate.theme();
    let casing = theme.stroke(wide + 2.0, theme.background);
    slate.painter.line_segment(ends, casing);
    slate.painter.line_segment(ends, theme.stroke(wide, ink));
}

fn cross(slate: &Slate<'_>, at: Pos2, arm: f32, ink: Color32) {
    for diagonal in [vec2(arm, arm), vec2(arm, -arm)] {
        cased(slate, [at - diagonal, at + diagonal], 2.0, ink);
    }
}

/// Over the pixels.
fn draw_over(slate: &Slate<'_>, (origin, width): (Pos2, f32), mark: &RasterMark) {
    let theme = slate.theme();
    let ink = colour(theme, mark.role);
    let place = |[x, y]: [f64; 2]| origin + vec2(x as f32, y as f32) * width;
    match mark.shape {
        RasterShape::Line(ends) => {
            let wide = if mark.role == Role::Soft { 1.25 } else { 2.0 };
            cased(slate, ends.map(place), wide, ink);
        }
        RasterShape::Dot(at) => {
            let rim = theme.stroke(1.5, theme.background);
            slate.painter.circle(place(at), slate.pts(4.0), ink, rim);
        }
        RasterShape::Cross(at) => cross(slate, place(at), slate.pts(ARM), ink),
    }
}

/// A gap in the background's colour inside the signal's line: seen on any tone, and what is stored stays to be read.
fn ring(slate: &Slate<'_>, place: Rect) {
    let theme = slate.theme();
    let gap = theme.stroke(2.0, theme.background);
    let line = theme.stroke(2.0, theme.signal);
    let painter = slate.painter;
    painter.rect_stroke(place, 2.0, gap, StrokeKind::Outside);
    painter.rect_stroke(place.expand(gap.width), 3.0, line, StrokeKind::Outside);
}
