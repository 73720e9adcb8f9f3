//! Options as cards, each with the pixels as they would be.

use egui::{TextStyle, Vec2};

use crate::figure::{Choice, Glimpse, Raster};

use super::{super::prelude::*, AROUND, App, GAP, Options, chip};

/// Beside a picture narrower words are hard to read.
const LEAST_WORDS: f32 = 80.0;
/// Of a card's picture, a side of a pixel; with its title.
const PIXEL: f32 = 20.0;
const PICTURE_TITLE: f32 = 28.0;

/// How an option's pixels would be, and how large that is drawn.
pub fn pixels(choice: &Choice, nth: usize) -> Option<(&Raster, Vec2)> {
    match choice.glimpses.get(nth)? {
        Glimpse::Pixels(raster) => {
            let [columns, rows] = raster.size.map(|side| side as f32 * PIXEL);
            Some((raster, vec2(columns, rows + PICTURE_TITLE)))
        }
        Glimpse::Nothing | Glimpse::Mark(_) => None,
    }
}

impl Options {
    /// Cards with pictures, all of one size beside each other: where there is room for them, and for what is written in them.
    pub fn cards(app: &App, ui: &Ui, choice: &Choice, width: f32) -> Option<Self> {
        let look = app.look();
        let n = choice.options.len();
        if look.theme.has_large_text() || app.is_low() || app.is_narrow() {
            return None;
        }
        let sizes = (0..n).map(|nth| Some(pixels(choice, nth)?.1));
        let sizes: Vec<Vec2> = sizes.collect::<Option<_>>()?;
        let picture = sizes.into_iter().reduce(Vec2::max)?;
        let chip = chip(None, 0).size(look.theme);
        let most = (width + GAP) / n as f32 - GAP;
        let words = most - picture.x - chip.x - 2.0 * GAP - 2.0 * AROUND.x;
        let font = TextStyle::Body.resolve(ui.style());
        let size = vec2(most, picture.y + 2.0 * AROUND.y);
        let card = |(nth, text): (usize, String)| {
            let text = (ui.painter()).layout(text, font.clone(), look.theme.ink, words);
            let at = pos2(nth as f32 * (most + GAP), 0.0);
            (Rect::from_min_size(at, size), text)
        };
        let said = choice.said(look.catalog);
        let boxes: Vec<_> = said.into_iter().enumerate().map(card).collect();
        let fits = boxes.iter().all(|(_, text)| text.size().y <= size.y);
        (words > LEAST_WORDS && fits).then_some(Self {
            boxes,
            height: size.y + GAP,
        })
    }
}
