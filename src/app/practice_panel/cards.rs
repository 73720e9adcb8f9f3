//! Options as cards, each with the pixels as they would be.

use std::sync::Arc;

use egui::{Galley, TextStyle, Vec2};

use crate::{
    app::{prelude::*, said::words},
    figure::{Choice, Glimpse, Raster},
};

/// Beside a picture narrower words are hard to read.
const LEAST_WORDS: f32 = 80.0;
/// Of a card's picture, a side of a pixel; with its title.
const PIXEL: f32 = 20.0;
const PICTURE_TITLE: f32 = 28.0;

/// What cards stand in, and what else stands on each.
pub struct Table {
    pub width: f32,
    pub gap: f32,
    pub around: Vec2,
    pub chip: Vec2,
}

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

/// Cards with pictures, all of one size beside each other, with their words: where there is room for these.
pub fn cards(
    ui: &Ui,
    look: Look<'_>,
    choice: &Choice,
    table: &Table,
) -> Option<Vec<(Rect, Arc<Galley>)>> {
    let n = choice.options.len();
    let sizes = (0..n).map(|nth| Some(pixels(choice, nth)?.1));
    let sizes: Vec<Vec2> = sizes.collect::<Option<_>>()?;
    let picture = sizes.into_iter().reduce(Vec2::max)?;
    let most = (table.width + table.gap) / n as f32 - table.gap;
    let width = most - picture.x - table.chip.x - 2.0 * table.gap - 2.0 * table.around.x;
    let size = vec2(most, picture.y + 2.0 * table.around.y);
    let card = |(nth, text): (usize, String)| {
        let text = words(ui, look, (&text, TextStyle::Body), width);
        let at = pos2(nth as f32 * (most + table.gap), 0.0);
        (Rect::from_min_size(at, size), text)
    };
    let said = choice.said(look.catalog).into_iter();
    let boxes: Vec<_> = said.enumerate().map(card).collect();
    let fits = boxes.iter().all(|(_, text)| text.size().y <= size.y);
    (width > LEAST_WORDS && fits).then_some(boxes)
}
