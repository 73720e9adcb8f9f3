//! How much is left after each of several tests: a band that narrows, and widens, from gate to gate.
//!
//! ```text
//!   in the scene      ┃ after the spheres │ after the vertices
//!   322 triangles     ┃ 156 triangles     │ 151 triangles
//!   ──────────────────┃┄┄┄┄ −166          │
//!   ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒┃───────────────────│───────────────────
//!   ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒┃▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒│░░░░░░░░░░░░░░░░░░░
//! ```

use crate::figure::{Ribbon, RibbonStage};

use super::prelude::*;

const TITLE_PTS: f32 = 11.5;
const COUNTS_PTS: f32 = 13.0;
const CHANGE_PTS: f32 = 11.5;
const ASIDE: f32 = 8.0;
const UNDER_WORDS: f32 = 5.0;
const LEAST_BAND: f32 = 24.0;
const STUB: f32 = 34.0;

impl OnSlate for Ribbon {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let n = self.stages.len().max(1) as f32;
        natural.fitted_in(room, |slate| {
            let all = self.stages.iter();
            let all = all.flat_map(|stage| words(slate, stage, f32::INFINITY));
            let widest = all.map(|words| words.size().x).fold(0.0, f32::max);
            let high = words_height(slate, self, f32::INFINITY);
            let high = high + slate.pts(UNDER_WORDS + LEAST_BAND);
            vec2(n * (widest + slate.pts(1.5 * ASIDE)), high)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, _: &mut Links) {
        let width = rect.width() / self.stages.len().max(1) as f32;
        let room = width - slate.pts(1.5 * ASIDE);
        let top = rect.top() + words_height(slate, self, room) + slate.pts(UNDER_WORDS);
        let band = rect.with_min_y(top.min(rect.bottom() - 1.0));
        let places = self.stages.iter().enumerate().map(|(i, stage)| {
            let left = rect.left() + i as f32 * width;
            let top = self.height(stage.amount, band);
            Rect::from_min_max(pos2(left, top), pos2(left + width, band.bottom()))
        });
        let places: Vec<Rect> = places.collect();
        for (stage, &place) in self.stages.iter().zip(&places) {
            fill(slate, stage, place);
        }
        for (i, stage) in self.stages.iter().enumerate() {
            if let Some(before) = i.checked_sub(1) {
                change(slate, stage, places[i], (places[before].top(), top));
            }
            let is_at_work = self.at_work == Some(i);
            if i > 0 || is_at_work {
                let theme = slate.theme();
                let quiet = theme.hairline.lerp_to_gamma(theme.faint, 0.4);
                let colour = if is_at_work { theme.signal } else { quiet };
                let line = slate.stroke(if is_at_work { 2.5 } else { 1.0 }, colour);
                slate.painter.vline(places[i].left(), rect.y_range(), line);
            }
            let aside = if i == 0 { 0.0 } else { slate.pts(ASIDE) };
            let mut at = pos2(places[i].left() + aside, rect.top());
            let n_known = if stage.is_to_come { 1 } else { 2 };
            for words in words(slate, stage, room).into_iter().take(n_known) {
                at.y = slate.put(&words, at, Align2::LEFT_TOP).bottom();
            }
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let stage = |(i, stage): (usize, &RibbonStage)| {
            let arrow = now(self.at_work == Some(i));
            let title = look.catalog.message(&stage.title);
            if stage.is_to_come {
                return format!("{arrow}{title}");
            }
            let counts = look.catalog.message(&stage.counts);
            format!("{arrow}{title}: {counts}")
        };
        joined(self.stages.iter().enumerate().map(stage), "; ")
    }
}

impl Ribbon {
    /// The upper edge of a stage's part. What is left is seen, be it never so little.
    fn height(&self, amount: usize, band: Rect) -> f32 {
        let part = amount as f32 / self.most.max(1) as f32;
        let least = if amount == 0 { 0.0 } else { 1.5 };
        band.bottom() - (part.min(1.0) * band.height()).max(least)
    }
}

fn fill(slate: &Slate<'_>, stage: &RibbonStage, place: Rect) {
    let theme = slate.theme();
    let tint = |strength| theme.background.lerp_to_gamma(theme.accent, strength);
    let (fill, edge, width) = if stage.is_to_come {
        (tint(0.09), tint(0.4), 1.0)
    } else {
        (tint(0.27), theme.accent, 2.0)
    };
    slate.painter.rect_filled(place, 0.0, fill);
    if stage.amount > 0 {
        let edge = slate.stroke(width, edge);
        slate.painter.hline(place.x_range(), place.top(), edge);
    }
}

fn change(slate: &mut Slate<'_>, stage: &RibbonStage, place: Rect, (before, top): (f32, f32)) {
    let theme = slate.theme();
    let Some(by) = stage.change.filter(|&by| by != 0) else {
        return;
    };
    let number = slate
        .look
        .catalog
        .value(&Value::Count(by.unsigned_abs() as usize));
    let sign = if by > 0 { "+" } else { "−" };
    let style = (Face::Mono, CHANGE_PTS, theme.soft);
    let text = slate.words(format!("{sign}{number}"), style);
    let stub = slate.pts(STUB).min(0.4 * place.width());
    let end = place.left() + stub;
    let is_loss = before < place.top();
    if is_loss {
        let lost = Rect::from_x_y_ranges(place.left()..=end, before..=place.top());
        let tint = theme.background.lerp_to_gamma(theme.discarded, 0.13);
        slate.painter.rect_filled(lost, 0.0, tint);
        let line = slate.stroke(1.0, theme.discarded);
        slate.dashed([pos2(place.left(), before), pos2(end, before)], line, 3.5);
    }
    let gap = slate.pts(6.0);
    let high = text.size().y;
    // Between the words and the band.
    let y = (before.midpoint(place.top()) - 0.5 * high).min(place.top() - high - 1.0);
    let y = y.max(top);
    slate.put(&text, pos2(end + gap, y), Align2::LEFT_TOP);
}

fn words(slate: &Slate<'_>, stage: &RibbonStage, width: f32) -> [Typeset; 2] {
    let theme = slate.theme();
    [
        slate.sentence(&stage.title, width, (Face::Plain, TITLE_PTS, theme.soft)),
        slate.sentence(&stage.counts, width, (Face::Strong, COUNTS_PTS, theme.ink)),
    ]
}

fn words_height(slate: &Slate<'_>, ribbon: &Ribbon, width: f32) -> f32 {
    let heights = ribbon.stages.iter().map(|stage| {
        let words = words(slate, stage, width);
        words.iter().map(|words| words.size().y).sum()
    });
    heights.fold(0.0, f32::max)
}
