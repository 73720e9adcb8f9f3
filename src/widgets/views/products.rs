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

mod vectors;

use crate::figure::{Measured, Product, Products};

use super::prelude::*;

const WIDTH: f32 = 136.0;
const HEIGHTS: [f32; 2] = [62.0, 104.0];
const ASIDE: f32 = 20.0;
const MOST_WORDS: f32 = 210.0;
const LEAST_WORDS: f32 = 90.0;
const GAP: f32 = 8.0;
const DECISION_SIZE: f32 = 14.0;
const AIR: f32 = 4.0;
// Distances along the normal, from the border: outside to the left of 0, inside to its right.
const TITLE_SIZE: f32 = 13.5;
const SIZE: f32 = 13.0;
const TITLE_GAPS: [f32; 2] = [10.0, 6.0];
const ROW: f32 = 22.0;
const BAR: f32 = 30.0;
const SPAN: f32 = 23.0;
const PAD: f32 = 24.0;
const MOST_WIDTH: f32 = 380.0;

impl OnSlate for Products {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        natural.fitted_in(room, |slate| {
            let aside = slate.pts(WIDTH + ASIDE);
            let widths = self.products.iter().map(|product| {
                let [decision, arithmetic] = words(slate, product, room.x - aside, false);
                decision.size().x.max(arithmetic.size().x)
            });
            let told = widths.fold(0.0, f32::max);
            let height = n_kept(self) * (least_height(slate, self, room.x) + slate.pts(GAP));
            vec2(aside + told, height + under(slate, self, room.x))
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, _: &mut Links) {
        let under = under(slate, self, rect.width());
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
            let room = Rect::from_x_y_ranges(left..=rect.right().max(left + 1.0), place.y_range());
            // While one is worked out, the other steps back.
            let is_soft = one_is_current && !product.is_current;
            let [decision, arithmetic] = words(slate, product, room.width(), is_soft);
            let height = decision.size().y + slate.pts(AIR) + arithmetic.size().y;
            let at = pos2(left, room.center().y - 0.5 * height);
            let put = slate.put(&decision, at, Align2::LEFT_TOP);
            let at = pos2(left, put.bottom() + slate.pts(AIR));
            slate.put(&arithmetic, at, Align2::LEFT_TOP);
            top = place.bottom() + slate.pts(GAP);
        }
        if let Some(measured) = &self.measured {
            draw_measured(slate, rect.with_min_y(top), measured);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let product = |product: &Product| {
            let decision = look.catalog.message(&product.decision);
            let arithmetic = look.catalog.formula(&product.arithmetic);
            format!("{}{decision} {arithmetic}", now(product.is_current))
        };
        let measured = self.measured.iter();
        let measured = measured.map(|measured| spoken(look, measured));
        joined(self.products.iter().map(product).chain(measured), "; ")
    }
}

fn n_kept(products: &Products) -> f32 {
    products.products.len().max(2) as f32
}

fn under(slate: &Slate<'_>, products: &Products, room: f32) -> f32 {
    let measured = products.measured.as_ref();
    measured.map_or(0.0, |measured| height(slate, measured, room))
}

fn words(slate: &Slate<'_>, product: &Product, width: f32, is_soft: bool) -> [Typeset; 2] {
    let theme = slate.theme();
    let ink = if is_soft { theme.soft } else { theme.ink };
    let width = width.min(slate.pts(MOST_WORDS)).max(slate.pts(LEAST_WORDS));
    let soft = (Face::Plain, SIZE, theme.soft);
    [
        slate.sentence(&product.decision, width, (Face::Strong, DECISION_SIZE, ink)),
        slate.formula(&product.arithmetic, soft),
    ]
}

fn least_height(slate: &Slate<'_>, products: &Products, room: f32) -> f32 {
    let width = room - slate.pts(WIDTH + ASIDE);
    let heights = products.products.iter().map(|product| {
        let [decision, arithmetic] = words(slate, product, width, false);
        decision.size().y + slate.pts(AIR) + arithmetic.size().y
    });
    heights.fold(slate.pts(HEIGHTS[0]), f32::max)
}

fn height(slate: &Slate<'_>, measured: &Measured, room: f32) -> f32 {
    let spans = measured.spans.len() as f32 * SPAN;
    let under = slate.pts(TITLE_GAPS[0] + TITLE_GAPS[1] + 2.0 * ROW + BAR + spans);
    title(slate, measured, width(slate, room)).size().y + under
}

fn width(slate: &Slate<'_>, room: f32) -> f32 {
    room.min(slate.pts(MOST_WIDTH))
}

fn title(slate: &Slate<'_>, measured: &Measured, width: f32) -> Typeset {
    let style = (Face::Strong, TITLE_SIZE, slate.theme().ink);
    slate.sentence(&measured.title, width, style)
}

fn draw_measured(slate: &mut Slate<'_>, rect: Rect, measured: &Measured) {
    let width = width(slate, rect.width());
    let title = title(slate, measured, width);
    let at = rect.left_top() + vec2(0.0, slate.pts(TITLE_GAPS[0]));
    let bottom = slate.put(&title, at, Align2::LEFT_TOP).bottom();
    let top = bottom + slate.pts(TITLE_GAPS[1] + ROW);
    let bar = Rect::from_min_size(pos2(rect.left(), top), vec2(width, slate.pts(BAR)));
    let scale = Scale::of(slate, bar, measured);
    // Outside, inside, and the border between them.
    let theme = slate.theme();
    let zero = scale.x(0.0);
    let outside = wash(theme, Role::Signal);
    let sides = [bar.with_max_x(zero), bar.with_min_x(zero)];
    for (side, fill) in sides.into_iter().zip([outside, theme.accent_wash]) {
        slate.painter.rect_filled(side, 0.0, fill);
    }
    let over = slate.pts(4.0);
    let ends = [bar.top() - over, bar.bottom() + over].map(|y| pos2(zero, y));
    let stroke = slate.stroke(2.25, theme.signal);
    slate.painter.line_segment(ends, stroke);
    segment(slate, bar, &scale, measured);
    let reach = bar.expand2(vec2(slate.pts(4.0), slate.pts(2.0 * ROW)));
    names(
        slate,
        reach.with_max_y(reach.bottom().min(rect.bottom())),
        (bar, &scale),
        measured,
    );
    for (nth, span) in measured.spans.iter().enumerate() {
        let y = bar.bottom() + slate.pts(ROW + (nth as f32 + 0.5) * SPAN);
        length(slate, y.round() + 0.5, &scale, bar.right(), span);
    }
}

struct Scale {
    left: f32,
    low: f64,
    per_unit: f64,
}

impl Scale {
    fn of(slate: &Slate<'_>, bar: Rect, measured: &Measured) -> Self {
        let ends = measured.ends.iter().map(|(_, at)| *at);
        let low = ends.clone().fold(0.0, f64::min);
        let high = ends.fold(0.0, f64::max);
        let pad = slate.pts(PAD);
        let room = f64::from(bar.width() - 2.0 * pad);
        Self {
            left: bar.left() + pad,
            low,
            per_unit: room / (high - low).max(1e-12),
        }
    }

    fn x(&self, at: f64) -> f32 {
        self.left + ((at - self.low) * self.per_unit) as f32
    }
}

fn segment(slate: &mut Slate<'_>, bar: Rect, scale: &Scale, measured: &Measured) {
    let theme = slate.theme();
    let y = bar.center().y;
    let at = |distance: f64| pos2(scale.x(distance), y);
    let [a, b] = [measured.ends[0].1, measured.ends[1].1];
    let [low, high] = [a.min(b), a.max(b)];
    let stroke = slate.stroke(2.25, theme.accent);
    if low < 0.0 {
        slate.dashed([at(low), at(high.min(0.0))], stroke, 6.0);
    }
    if high > 0.0 {
        slate.line([at(low.max(0.0)), at(high)], stroke);
    }
    let r = slate.pts(5.0);
    for (_, distance) in &measured.ends {
        let painter = slate.painter;
        painter.circle(at(*distance), r, theme.background, stroke);
    }
    if low < 0.0 && high > 0.0 {
        let halo = slate.stroke(1.5, theme.background);
        slate.painter.circle(at(0.0), r, theme.signal, halo);
    }
}

/// A number that has no room is left out.
fn names(slate: &mut Slate<'_>, room: Rect, (bar, scale): (Rect, &Scale), measured: &Measured) {
    let theme = slate.theme();
    let above = bar.top() - 0.6 * slate.pts(ROW);
    let below = bar.bottom() + 0.6 * slate.pts(ROW);
    let [(first, from), (second, to)] = &measured.ends;
    let zero = (Face::Strong, SIZE, theme.signal_text);
    let end = (Face::Strong, SIZE, theme.accent);
    let number = (Face::Plain, SIZE, theme.ink);
    let numbers = [*from, *to, 0.0].map(|at| (Value::Number(at), at, below, number));
    let names = [
        (measured.zero.clone(), 0.0, above, zero),
        (first.clone(), *from, above, end),
        (second.clone(), *to, above, end),
    ];
    let labels = names.into_iter().chain(numbers);
    for (value, distance, y, style) in labels {
        let text = slate.value(&value, style);
        let outward = if distance <= from.min(*to) { -1.0 } else { 1.0 };
        let centres = (0..16).flat_map(|nth| {
            let aside = outward * slate.pts(4.0 * nth as f32);
            [aside, -aside].map(|aside| pos2(scale.x(distance) + aside, y))
        });
        let centres: Vec<Pos2> = centres.collect();
        // The same distance twice, or 0 where an end stands there: once is enough.
        slate.put_free(&text, room, centres);
    }
}

fn length(
    slate: &mut Slate<'_>,
    y: f32,
    scale: &Scale,
    most: f32,
    ([from, to], value, role): &([f64; 2], Value, Role),
) {
    let stroke = slate.stroke(1.5, colour(slate.theme(), *role));
    let [from, to] = [scale.x(from.min(*to)), scale.x(from.max(*to))];
    let tick = slate.pts(4.5);
    for x in [from, to] {
        slate.line([pos2(x, y - tick), pos2(x, y + tick)], stroke);
    }
    let ink = text_colour(slate.theme(), *role);
    let text = slate.value(value, (Face::Strong, SIZE, ink));
    let half = 0.5 * text.size().x + slate.pts(6.0);
    let middle = 0.5 * (from + to);
    if to - from > 2.0 * half + slate.pts(12.0) {
        slate.line([pos2(from, y), pos2(middle - half, y)], stroke);
        slate.line([pos2(middle + half, y), pos2(to, y)], stroke);
        slate.put(&text, pos2(middle, y), Align2::CENTER_CENTER);
        return;
    }
    slate.line([pos2(from, y), pos2(to, y)], stroke);
    let aside = slate.pts(6.0) + tick;
    if to + aside + text.size().x <= most {
        slate.put(&text, pos2(to + aside, y), Align2::LEFT_CENTER);
    } else {
        slate.put(&text, pos2(from - aside, y), Align2::RIGHT_CENTER);
    }
}

/// `Measured along n, from the edge: P₁ −9, P₂ 18; 9; n·D = 27`.
fn spoken(look: Look<'_>, measured: &Measured) -> String {
    let said = |value: &Value| look.catalog.value(value);
    let ends = measured.ends.iter();
    let ends = ends.map(|(name, at)| format!("{} {}", said(name), said(&Value::Number(*at))));
    let spans = measured.spans.iter().map(|(_, value, _)| said(value));
    let title = look.catalog.message(&measured.title);
    format!("{title}: {}; {}", joined(ends, ", "), joined(spans, "; "))
}
