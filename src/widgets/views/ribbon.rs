//! How much is left after each of several tests: a band that narrows, and widens, from gate to gate.
//!
//! ```text
//!   in the scene      ┃ after the spheres │ after the vertices
//!   322 triangles     ┃ 156 triangles     │ 151 triangles
//!   ──────────────────┃┄┄┄┄ −166          │
//!   ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒┃───────────────────│───────────────────
//!   ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒┃▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒│░░░░░░░░░░░░░░░░░░░
//! ```

use egui::{Align2, Painter, Rect, pos2, vec2};

use crate::{
    figure::{Ribbon, RibbonStage},
    paint::Typeset,
    text::Value,
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate},
};

const TITLE_PTS: f32 = 11.5;
const COUNTS_PTS: f32 = 13.0;
const CHANGE_PTS: f32 = 11.5;
/// Between a gate and what is written beside it.
const ASIDE: f32 = 8.0;
/// From the words to the highest band.
const UNDER_WORDS: f32 = 5.0;
/// The band's height, at least.
const LEAST_BAND: f32 = 24.0;
/// What a gate has taken away reaches so far into its stage, at most.
const STUB: f32 = 34.0;

impl OnSlate for Ribbon {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let n = self.stages.len().max(1) as f32;
        Slate::new(painter, look).fitted_in(rect.size(), |slate| {
            let widths = self.stages.iter().map(|stage| {
                let words = words(slate, stage, f32::INFINITY);
                words
                    .map(|words| words.size().x)
                    .into_iter()
                    .fold(0.0, f32::max)
            });
            let widest = widths.fold(0.0, f32::max) + slate.pts(1.5 * ASIDE);
            let high = words_height(slate, self, f32::INFINITY);
            vec2(n * widest, high + slate.pts(UNDER_WORDS + LEAST_BAND))
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
            let before = i.checked_sub(1).map(|before| places[before].top());
            if let Some(before) = before {
                change(slate, stage, places[i], (before, top));
            }
            let is_at_work = self.at_work == Some(i);
            if i > 0 || is_at_work {
                gate(slate, rect, places[i].left(), is_at_work);
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
            let arrow = if self.at_work == Some(i) { "→ " } else { "" };
            let title = look.catalog.message(&stage.title);
            if stage.is_to_come {
                return format!("{arrow}{title}");
            }
            let counts = look.catalog.message(&stage.counts);
            format!("{arrow}{title}: {counts}")
        };
        let stages: Vec<String> = self.stages.iter().enumerate().map(stage).collect();
        stages.join("; ")
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
    let strength = if stage.is_to_come { 0.09 } else { 0.27 };
    let tint = theme.background.lerp_to_gamma(theme.accent, strength);
    slate.painter.rect_filled(place, 0.0, tint);
    let (edge, width) = if stage.is_to_come {
        (theme.background.lerp_to_gamma(theme.accent, 0.4), 1.0)
    } else {
        (theme.accent, 2.0)
    };
    if stage.amount > 0 {
        let edge = slate.stroke(width, edge);
        slate.painter.hline(place.x_range(), place.top(), edge);
    }
}

/// What a gate took away, from the height before; what it added is within the band.
fn change(slate: &mut Slate<'_>, stage: &RibbonStage, place: Rect, (before, top): (f32, f32)) {
    let theme = slate.theme();
    let Some(by) = stage.change.filter(|&by| by != 0) else {
        return;
    };
    let text = signed(slate, by);
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

fn signed(slate: &Slate<'_>, by: i64) -> Typeset {
    let number = slate.look.catalog.value(&Value::Number(by as f64));
    let sign = if by > 0 { "+" } else { "" };
    let style = (Face::Mono, CHANGE_PTS, slate.theme().soft);
    slate.words(format!("{sign}{number}"), style)
}

fn gate(slate: &Slate<'_>, rect: Rect, x: f32, is_at_work: bool) {
    let theme = slate.theme();
    let line = if is_at_work {
        slate.stroke(2.5, theme.signal)
    } else {
        slate.stroke(1.0, theme.hairline.lerp_to_gamma(theme.faint, 0.4))
    };
    slate.painter.vline(x, rect.y_range(), line);
}

/// A stage's title, and its counts, which stand under it once they are known.
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
