//! A raster in large pixels: squares with what is stored in them, the current one ringed.

use crate::{
    figure::{Raster, RasterMark, RasterShape},
    paint::{ThemeKind, hatched},
};

use super::{
    prelude::*,
    slate::{DARKEST, shaded},
};

const TITLE: f32 = 28.0;
const SCALE: f32 = 28.0;
const SHADES: usize = 16;
const LEAST_IN_GRID: f32 = 9.0;
const LARGEST: f32 = 11.0;
const SMALLEST: f32 = 4.5;
const CHARACTER: f32 = 0.6;
const AROUND: f32 = 0.3;
/// Numbers of many pixels are the picture: at arm's length they are read at this part of the least size of text.
const NEAR: f32 = 0.8;
const DIGITS: usize = 3;
/// Where there is no ink over it, a shade may be darker.
const DARKEST_BARE: f32 = 0.9;
/// Half a cross in points; of one aside from what is written, its place from the pixel's middle and half of it, in pixels.
const ARM: f32 = 4.5;
const ASIDE: [f64; 2] = [0.34, -0.34];
const ASIDE_ARM: f32 = 0.1;

impl OnSlate for Raster {
    fn slate<'a>(&self, natural: Slate<'a>, _: Vec2) -> Slate<'a> {
        natural
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let pixels = Pixels::new(slate, rect, self);
        let has_numbers = self.scale.is_some() || pixels.has_numbers(slate);
        let bare = self.bare.as_ref().filter(|_| !has_numbers);
        slate.title(bare.unwrap_or(&self.title), rect);
        pixels.fill(slate);
        pixels.lines(slate);
        let over = self.over.iter();
        let (lines, points): (Vec<_>, Vec<_>) = over.partition(|mark| mark.is_line());
        // What goes on beyond the pixels ends where they do.
        let painter = slate.painter.with_clip_rect(pixels.whole().expand(2.0));
        for mark in lines {
            pixels.draw_over(slate, &painter, mark);
        }
        let lit = links.lit.and_then(|link| link.number_of(Self::LINK));
        let lit = lit.map(|place| [place % self.size[0].max(1), place / self.size[0].max(1)]);
        if let Some(lit) = lit.filter(|&lit| self.at(lit).is_some() && self.current != Some(lit)) {
            pixels.ring(slate, lit, slate.theme().accent);
        }
        if let Some(current) = self.current {
            pixels.ring(slate, current, slate.theme().signal);
        }
        pixels.write(slate);
        if let Some([column, row]) = links.pointer.and_then(|at| pixels.pixel_at(at)) {
            links.pointed = Some(Link::nth(Self::LINK, row * self.size[0] + column));
        }
        if let Some(ends) = &self.scale {
            pixels.draw_scale(slate, ends);
        }
        pixels.write_under(slate);
        for mark in points {
            pixels.draw_over(slate, slate.painter, mark);
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

struct Pixels<'r> {
    raster: &'r Raster,
    origin: Pos2,
    width: f32,
    n_digits: usize,
}

impl<'r> Pixels<'r> {
    fn new(slate: &Slate<'_>, rect: Rect, raster: &'r Raster) -> Self {
        let [columns, rows] = raster.size.map(|n| n.max(1) as f32);
        let is_noted = raster.scale.is_some() || !raster.under.is_empty();
        let scale = if is_noted { SCALE } else { 0.0 };
        let height = rect.height() - slate.pts(TITLE + scale);
        let fits = (rect.width() / columns).min(height / rows);
        Self {
            raster,
            origin: (rect.min + vec2(0.0, slate.pts(TITLE))).round(),
            // Whole pixels of the screen, so that all squares are alike.
            width: fits.floor().max(1.0),
            n_digits: n_digits(raster),
        }
    }

    fn square(&self, [column, row]: [usize; 2]) -> Rect {
        let at = self.origin + vec2(column as f32, row as f32) * self.width;
        Rect::from_min_size(at, Vec2::splat(self.width))
    }

    /// A gap inside the line: seen on any tone, and what is stored stays to be read.
    fn ring(&self, slate: &Slate<'_>, at: [usize; 2], colour: Color32) {
        let place = self.square(at);
        let gap = slate.stroke(2.0, slate.theme().background);
        let line = slate.stroke(2.0, colour);
        slate.rim(place, 2.0, gap, StrokeKind::Outside);
        slate.rim(place.expand(gap.width), 3.0, line, StrokeKind::Outside);
    }

    fn whole(&self) -> Rect {
        let size = self.raster.size.map(|n| n as f32 * self.width);
        Rect::from_min_size(self.origin, size.into())
    }

    fn place(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.origin + vec2(x as f32, y as f32) * self.width
    }

    fn pixel_at(&self, at: Pos2) -> Option<[usize; 2]> {
        let place = (at - self.origin) / self.width;
        let [column, row] = [place.x, place.y].map(f32::floor);
        let is_in = column >= 0.0 && row >= 0.0;
        let pixel = [column as usize, row as usize];
        (is_in && (0..2).all(|i| pixel[i] < self.raster.size[i])).then_some(pixel)
    }

    fn write(&self, slate: &mut Slate<'_>) {
        let theme = slate.theme();
        let [columns, rows] = self.raster.size;
        for at in (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row])) {
            let pixel = self.raster.at(at);
            let Some((pixel, value)) = pixel.and_then(|p| Some((p, p.value.as_ref()?))) else {
                continue;
            };
            let pts = self.pts(slate, at, value);
            if pts < smallest(slate) {
                continue;
            }
            let ink = pixel.role.map_or(theme.soft, |_| theme.ink);
            let text = slate.digits(value, pts, ink);
            if text.size().x <= self.width || self.is_apart(at, value) {
                slate.put(&text, self.square(at).center(), Align2::CENTER_CENTER);
            }
        }
    }

    /// Is it a name of more than its pixel? Nothing is written around it, and it is not of a pixel that is marked by itself.
    fn is_apart(&self, [column, row]: [usize; 2], value: &Value) -> bool {
        let own = self.raster.at([column, row]);
        if own.is_some_and(|pixel| pixel.role == Some(Role::Signal)) {
            return false;
        }
        let about = |n: usize| n.saturating_sub(1)..=n + 1;
        let places = about(row).flat_map(|row| about(column).map(move |column| [column, row]));
        let mut others = places.filter(|at| *at != [column, row]);
        let is_written = |at| self.raster.at(at).is_some_and(|it| it.value.is_some());
        matches!(value, Value::Name(_)) && !others.any(is_written)
    }

    /// Tones, each as far to the right as it goes: there may be very many pixels.
    fn fill(&self, slate: &Slate<'_>) {
        let darkest = self.darkest(slate);
        let tone_at = |column: usize, row: usize| {
            let pixel = self.raster.at([column, row])?;
            Some(shaded(slate.theme(), pixel.role?, pixel.shade, darkest))
        };
        let [columns, rows] = self.raster.size;
        for row in 0..rows {
            let mut column = 0;
            while column < columns {
                let tone = tone_at(column, row);
                let run = (column..columns).take_while(|&other| tone_at(other, row) == tone);
                let end = column + run.count();
                if let Some(tone) = tone {
                    let [first, last] = [column, end - 1].map(|column| self.square([column, row]));
                    slate.painter.rect_filled(first.union(last), 0.0, tone);
                }
                column = end;
            }
        }
    }

    fn darkest(&self, slate: &Slate<'_>) -> f32 {
        let is_bare = self.number_pts(slate, self.n_digits) < smallest(slate);
        if self.raster.scale.is_some() && is_bare {
            DARKEST_BARE
        } else {
            DARKEST
        }
    }

    fn lines(&self, slate: &Slate<'_>) {
        let line = slate.stroke(2.0, slate.theme().hairline);
        let whole = self.whole();
        if self.width < slate.pts(LEAST_IN_GRID) {
            slate.rim(whole, 0.0, line, StrokeKind::Outside);
            return;
        }
        let at = self.origin;
        let along = |n: usize| (0..=n).map(|i| i as f32 * self.width);
        for x in along(self.raster.size[0]) {
            slate.painter.vline(at.x + x, whole.y_range(), line);
        }
        for y in along(self.raster.size[1]) {
            slate.painter.hline(whole.x_range(), at.y + y, line);
        }
    }

    fn write_under(&self, slate: &mut Slate<'_>) {
        let top = self.whole().bottom() + slate.pts(6.0);
        let set = |value| slate.low(value, (Face::Mono, LARGEST, slate.theme().ink));
        let texts: Vec<Typeset> = self.raster.under.iter().map(set).collect();
        let widest = texts.iter().map(|text| text.size().x).fold(0.0, f32::max);
        // Where they would run into each other, the one of the pixel that the step is about.
        let has_room = widest < self.square([0, 0]).width();
        for (column, text) in texts.iter().enumerate() {
            let is_current = self.raster.current.is_some_and(|at| at[0] == column);
            if has_room || is_current {
                let at = pos2(self.square([column, 0]).center().x, top);
                slate.put(text, at, Align2::CENTER_TOP);
            }
        }
    }

    /// Under the pixels, as wide as they are: from the darkest shade to the palest, between what they stand for.
    fn draw_scale(&self, slate: &mut Slate<'_>, ends: &[Value; 2]) {
        let whole = self.whole();
        let top = whole.left_bottom() + vec2(0.0, 0.5 * slate.pts(SCALE));
        let style = (Face::Plain, LARGEST, slate.theme().soft);
        let [near, far] = ends.each_ref().map(|end| slate.low(end, style));
        let near = slate.put(&near, top, Align2::LEFT_CENTER);
        let far = slate.put(&far, top + vec2(whole.width(), 0.0), Align2::RIGHT_CENTER);
        let gap = slate.pts(8.0);
        let bar = Rect::from_x_y_ranges(near.right() + gap..=far.left() - gap, near.y_range());
        let step = bar.width() / SHADES as f32;
        let darkest = self.darkest(slate);
        for i in 0..SHADES {
            let [left, right] = [i, i + 1].map(|i| (bar.left() + i as f32 * step).round());
            let part = Rect::from_x_y_ranges(left..=right, bar.y_range());
            let shade = 1.0 - (i as f64 + 0.5) / SHADES as f64;
            let tone = shaded(slate.theme(), Role::Soft, shade, darkest);
            slate.painter.rect_filled(part, 0.0, tone);
        }
    }

    fn pts(&self, slate: &Slate<'_>, at: [usize; 2], value: &Value) -> f32 {
        if self.is_apart(at, value) {
            return LARGEST.max(slate.least_size());
        }
        let n_characters = match value {
            Value::Name(name) => name.chars().count(),
            _ => self.n_digits,
        };
        self.number_pts(slate, n_characters)
    }

    fn number_pts(&self, slate: &Slate<'_>, n_characters: usize) -> f32 {
        let wide = CHARACTER * n_characters as f32 + AROUND;
        (self.width / (wide * slate.pts(1.0))).min(LARGEST.max(slate.least_size()))
    }

    /// Are its numbers large enough to be read?
    fn has_numbers(&self, slate: &Slate<'_>) -> bool {
        self.number_pts(slate, self.n_digits) >= smallest(slate)
    }

    fn is_written(&self, slate: &Slate<'_>, at: [f64; 2]) -> bool {
        let at = at.map(|x| x as usize);
        let value = self.raster.at(at).and_then(|pixel| pixel.value.as_ref());
        value.is_some_and(|value| self.pts(slate, at, value) >= smallest(slate))
    }

    fn draw_over(&self, slate: &Slate<'_>, painter: &Painter, mark: &RasterMark) {
        let ink = colour(slate.theme(), mark.role);
        match mark.shape {
            RasterShape::Line(ends) => {
                let wide = if mark.role == Role::Soft { 1.25 } else { 2.0 };
                cased(slate, painter, ends.map(|at| self.place(at)), wide, ink);
            }
            RasterShape::Bar(ends) => {
                painter.line_segment(ends.map(|at| self.place(at)), slate.stroke(5.0, ink));
            }
            RasterShape::Dot(at) => {
                let rim = slate.stroke(1.5, slate.theme().background);
                slate
                    .painter
                    .circle(self.place(at), slate.pts(4.0), ink, rim);
            }
            RasterShape::Ring(at) => {
                let (at, r) = (self.place(at), slate.pts(3.5));
                slate
                    .painter
                    .circle_filled(at, r + slate.pts(2.0), slate.theme().background);
                slate.painter.circle_stroke(at, r, slate.stroke(2.0, ink));
            }
            RasterShape::Hatch([x, y]) => {
                let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
                let corners = corners.map(|[right, down]| self.place([x + right, y + down]));
                let strokes = hatched(&[corners.to_vec()], Rect::EVERYTHING, slate.pts(ARM));
                for ends in strokes {
                    slate.painter.line_segment(ends, slate.stroke(1.25, ink));
                }
            }
            RasterShape::Cross([x, y]) if self.is_written(slate, [x, y]) => {
                let at = self.place([x + ASIDE[0], y + ASIDE[1]]);
                draw_cross(slate, at, ASIDE_ARM * self.width, ink);
            }
            RasterShape::Cross(at) => draw_cross(slate, self.place(at), slate.pts(ARM), ink),
        }
    }
}

/// Of the largest count, so that all are as large; other numbers are said in [`DIGITS`].
fn n_digits(raster: &Raster) -> usize {
    let counts = raster.pixels.iter().filter_map(|pixel| match pixel.value {
        Some(Value::Count(n)) => Some(n),
        _ => None,
    });
    let digits = |most: usize| most.max(10).ilog10() as usize + 1;
    counts.max().map_or(DIGITS, digits)
}

/// What would be smaller is read with the pointer, or in the inspector.
fn smallest(slate: &Slate<'_>) -> f32 {
    let is_far = slate.theme().kind == ThemeKind::Projector;
    let part = if is_far { 1.0 } else { NEAR };
    (part * slate.least_size()).max(SMALLEST)
}

fn cased(slate: &Slate<'_>, painter: &Painter, ends: [Pos2; 2], wide: f32, ink: Color32) {
    let casing = slate.stroke(wide + 2.0, slate.theme().background);
    painter.line_segment(ends, casing);
    painter.line_segment(ends, slate.stroke(wide, ink));
}

fn draw_cross(slate: &Slate<'_>, at: Pos2, arm: f32, ink: Color32) {
    for diagonal in [vec2(arm, arm), vec2(arm, -arm)] {
        cased(
            slate,
            slate.painter,
            [at - diagonal, at + diagonal],
            2.0,
            ink,
        );
    }
}
