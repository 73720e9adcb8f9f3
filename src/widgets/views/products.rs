//! Dot products, each with its own small drawing, and what they measure along the normal.
//!
//! ```text
//!      n  ·foot        n·D > 0: the line enters
//!     ↗ .·  :          3·11 + 2·(−3) = 27
//!    ·──────→ D
//!
//!   Measured along n, from the edge
//!   P₁    edge                 P₂
//!   ○- - - -●──────────────────○
//!   −9      0                  18
//! ```

mod measured;
mod vectors;

use egui::{Align2, Painter, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{Product, Products},
    paint::Typeset,
    text::{Notation, Value},
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate},
};

/// A drawing's width; its arithmetic stands beside it.
const WIDTH: f32 = 136.0;
/// Its height: the least, and the most.
const HEIGHTS: [f32; 2] = [62.0, 104.0];
/// Between a drawing and its arithmetic.
const ASIDE: f32 = 20.0;
/// A decision is broken into lines when it is wider than this.
const MOST_WORDS: f32 = 210.0;
/// It has this width at least.
const LEAST_WORDS: f32 = 90.0;
/// Between one product and the next.
const GAP: f32 = 8.0;
const DECISION_SIZE: f32 = 14.0;
const ARITHMETIC_SIZE: f32 = 13.0;
const AIR: f32 = 4.0;

impl OnSlate for Products {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let slate = Slate::with_numbers(painter, look, notation(self));
        slate.fitted_in(rect.size(), |slate| wanted(slate, self, rect.width()))
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, _: &mut Links) {
        let measured = self.measured.as_ref();
        let under = measured.map_or(0.0, |measured| {
            measured::height(slate, measured, rect.width())
        });
        let room = (rect.height() - under) / n_kept(self) - slate.pts(GAP);
        let least = least_height(slate, self, rect.width());
        let height = room.min(slate.pts(HEIGHTS[1])).max(least);
        let drawing = vec2(slate.pts(WIDTH), height);
        let scale = vectors::common_scale(slate, &self.products, drawing);
        let one_is_current = self.products.iter().any(|product| product.is_current);
        let mut top = rect.top();
        for product in &self.products {
            let place = Rect::from_min_size(pos2(rect.left(), top), drawing);
            vectors::draw(slate, place, product, scale);
            let left = place.right() + slate.pts(ASIDE);
            let words = Rect::from_x_y_ranges(left..=rect.right().max(left + 1.0), place.y_range());
            // While one is worked out, the other steps back.
            told(slate, words, product, one_is_current && !product.is_current);
            top = place.bottom() + slate.pts(GAP);
        }
        if let Some(measured) = measured {
            measured::draw(slate, rect.with_min_y(top), measured);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let notation = notation(self);
        let product = |product: &Product| {
            let arrow = if product.is_current { "→ " } else { "" };
            let decision = look.catalog.message(&product.decision);
            format!(
                "{arrow}{decision} {}",
                look.catalog.formula_as(&product.arithmetic, notation)
            )
        };
        let measured = self.measured.iter();
        let measured = measured.map(|measured| measured::spoken(look, measured, notation));
        let parts: Vec<String> = self.products.iter().map(product).chain(measured).collect();
        parts.join("; ")
    }
}

/// The same coordinates and lengths come several times: all numbers are fractions, or all decimals.
fn notation(products: &Products) -> Notation {
    let arithmetic = products.products.iter().map(|product| &product.arithmetic);
    let mut values: Vec<Value> = arithmetic.cloned().map(Value::Formula).collect();
    if let Some(measured) = &products.measured {
        values.extend(measured.ends.iter().map(|(_, at)| Value::Number(*at)));
        values.extend(measured.spans.iter().map(|(_, value, _)| value.clone()));
    }
    Notation::of(&values)
}

/// Room for two from the start: nothing moves when the second comes.
fn n_kept(products: &Products) -> f32 {
    products.products.len().max(2) as f32
}

fn wanted(slate: &Slate<'_>, products: &Products, room: f32) -> Vec2 {
    let aside = slate.pts(WIDTH + ASIDE);
    let widths = products.products.iter().map(|product| {
        let [decision, arithmetic] = words(slate, product, (room - aside, false));
        decision.size().x.max(arithmetic.size().x)
    });
    let told = widths.fold(0.0, f32::max);
    let height = n_kept(products) * (least_height(slate, products, room) + slate.pts(GAP));
    let measured = products.measured.as_ref();
    let measured = measured.map_or(0.0, |measured| measured::height(slate, measured, room));
    vec2(aside + told, height + measured)
}

/// What is said of a product: its decision, and the arithmetic under it.
fn words(slate: &Slate<'_>, product: &Product, (width, is_soft): (f32, bool)) -> [Typeset; 2] {
    let theme = slate.theme();
    let ink = if is_soft { theme.soft } else { theme.ink };
    let width = width.min(slate.pts(MOST_WORDS)).max(slate.pts(LEAST_WORDS));
    let soft = (Face::Plain, ARITHMETIC_SIZE, theme.soft);
    [
        slate.sentence(&product.decision, width, (Face::Strong, DECISION_SIZE, ink)),
        slate.formula(&product.arithmetic, soft),
    ]
}

/// So high is a drawing at least that what is said beside it has room.
fn least_height(slate: &Slate<'_>, products: &Products, room: f32) -> f32 {
    let width = room - slate.pts(WIDTH + ASIDE);
    let heights = products.products.iter().map(|product| {
        let [decision, arithmetic] = words(slate, product, (width, false));
        decision.size().y + slate.pts(AIR) + arithmetic.size().y
    });
    heights.fold(slate.pts(HEIGHTS[0]), f32::max)
}

fn told(slate: &mut Slate<'_>, place: Rect, product: &Product, is_soft: bool) {
    let [decision, arithmetic] = words(slate, product, (place.width(), is_soft));
    let height = decision.size().y + slate.pts(AIR) + arithmetic.size().y;
    let top = place.center().y - 0.5 * height;
    let put = slate.put(&decision, pos2(place.left(), top), Align2::LEFT_TOP);
    let at = pos2(place.left(), put.bottom() + slate.pts(AIR));
    slate.put(&arithmetic, at, Align2::LEFT_TOP);
}
