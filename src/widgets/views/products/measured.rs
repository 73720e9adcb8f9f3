//! Distances along the normal, from the border: outside to the left of 0, inside to its right.

use egui::{Align2, Color32, Pos2, Rangef, Rect, Stroke, pos2, vec2};

use crate::{
    figure::{Measured, Role},
    paint::Typeset,
    text::{Notation, Value},
};

use super::super::super::look::Look;
use super::super::slate::{Face, Slate, colour, text_colour, wash};

const TITLE_SIZE: f32 = 13.5;
const NAME_SIZE: f32 = 13.0;
const NUMBER_SIZE: f32 = 13.0;
/// White space above the title, and under it.
const TITLE_GAPS: [f32; 2] = [10.0, 6.0];
/// Heights of a row of text, of the bar, and of a length under it.
const ROW: f32 = 22.0;
const BAR: f32 = 30.0;
const SPAN: f32 = 23.0;
/// White space at both ends of the bar, as far as the first mark.
const PAD: f32 = 24.0;
/// The bar is no longer than this.
const MOST_WIDTH: f32 = 380.0;

/// How high it is where there is so much room.
pub fn height(slate: &Slate<'_>, measured: &Measured, room: f32) -> f32 {
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

/// Draws it from the top left of `rect`.
pub fn draw(slate: &mut Slate<'_>, rect: Rect, measured: &Measured) {
    let width = width(slate, rect.width());
    let title = title(slate, measured, width);
    let at = rect.left_top() + vec2(0.0, slate.pts(TITLE_GAPS[0]));
    let bottom = slate.put(&title, at, Align2::LEFT_TOP).bottom();
    let top = bottom + slate.pts(TITLE_GAPS[1] + ROW);
    let bar = Rect::from_min_size(pos2(rect.left(), top), vec2(width, slate.pts(BAR)));
    let scale = Scale::of(slate, bar, measured);
    surfaces(slate, bar, &scale);
    segment(slate, bar, &scale, measured);
    names(slate, bar, &scale, measured);
    for (nth, span) in measured.spans.iter().enumerate() {
        let y = bar.bottom() + slate.pts(ROW + (nth as f32 + 0.5) * SPAN);
        length(
            slate,
            y.round() + 0.5,
            &scale,
            (rect.left()..=bar.right()).into(),
            span,
        );
    }
}

/// From distances to places on the bar.
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

/// Outside, inside, and the border between them.
fn surfaces(slate: &mut Slate<'_>, bar: Rect, scale: &Scale) {
    let theme = slate.theme();
    let zero = scale.x(0.0);
    let outside = wash(theme, Role::Signal);
    slate
        .painter
        .rect_filled(bar.with_max_x(zero), 0.0, outside);
    slate
        .painter
        .rect_filled(bar.with_min_x(zero), 0.0, theme.accent_wash);
    let over = slate.pts(4.0);
    let ends = [bar.top() - over, bar.bottom() + over].map(|y| pos2(zero, y));
    let stroke = slate.stroke(2.25, theme.signal);
    slate.painter.line_segment(ends, stroke);
}

/// Dashed as long as it is outside; its ends hollow, its crossing filled.
fn segment(slate: &mut Slate<'_>, bar: Rect, scale: &Scale, measured: &Measured) {
    let theme = slate.theme();
    let y = bar.center().y;
    let at = |distance: f64| pos2(scale.x(distance), y);
    let [low, high] = {
        let [a, b] = [measured.ends[0].1, measured.ends[1].1];
        [a.min(b), a.max(b)]
    };
    let stroke = slate.stroke(2.25, theme.accent);
    if low < 0.0 {
        slate.dashed([at(low), at(high.min(0.0))], stroke, 6.0);
    }
    if high > 0.0 {
        slate.line([at(low.max(0.0)), at(high)], stroke);
    }
    let r = slate.pts(5.0);
    for (_, distance) in &measured.ends {
        slate
            .painter
            .circle(at(*distance), r, theme.background, stroke);
    }
    if low < 0.0 && high > 0.0 {
        let halo = slate.stroke(1.5, theme.background);
        slate.painter.circle(at(0.0), r, theme.signal, halo);
    }
}

/// Over the bar the names, under it the distances; neighbours make way for each other.
fn names(slate: &mut Slate<'_>, bar: Rect, scale: &Scale, measured: &Measured) {
    let theme = slate.theme();
    let room = bar.expand2(vec2(slate.pts(4.0), slate.pts(2.0 * ROW)));
    let above = bar.top() - 0.6 * slate.pts(ROW);
    let below = bar.bottom() + 0.6 * slate.pts(ROW);
    let [(first, from), (second, to)] = &measured.ends;
    let zero = (Face::Strong, NAME_SIZE, theme.signal_text);
    let end = (Face::Strong, NAME_SIZE, theme.accent);
    let number = (Face::Plain, NUMBER_SIZE, theme.ink);
    let labels: [(&Value, f64, f32, _); 6] = [
        (&measured.zero, 0.0, above, zero),
        (first, *from, above, end),
        (second, *to, above, end),
        (&Value::Number(*from), *from, below, number),
        (&Value::Number(*to), *to, below, number),
        (&Value::Number(0.0), 0.0, below, number),
    ];
    for (value, distance, y, style) in labels {
        let text = slate.value(value, style);
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

/// A length with a stroke at both ends, and what it is in its middle, or beside it where it is short.
fn length(
    slate: &mut Slate<'_>,
    y: f32,
    scale: &Scale,
    room: Rangef,
    ([from, to], value, role): &([f64; 2], Value, Role),
) {
    let ink: Color32 = colour(slate.theme(), *role);
    let stroke: Stroke = slate.stroke(1.5, ink);
    let [from, to] = [scale.x(from.min(*to)), scale.x(from.max(*to))];
    let tick = slate.pts(4.5);
    for x in [from, to] {
        slate.line([pos2(x, y - tick), pos2(x, y + tick)], stroke);
    }
    let text = slate.value(
        value,
        (Face::Strong, NAME_SIZE, text_colour(slate.theme(), *role)),
    );
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
    if to + aside + text.size().x <= room.max {
        slate.put(&text, pos2(to + aside, y), Align2::LEFT_CENTER);
    } else {
        slate.put(&text, pos2(from - aside, y), Align2::RIGHT_CENTER);
    }
}

/// `Measured along n, from the edge: P₁ −9, P₂ 18; 9; n·D = 27`.
pub fn spoken(look: Look<'_>, measured: &Measured, notation: Notation) -> String {
    let said = |value: &Value| look.catalog.value_as(value, notation);
    let ends = measured
        .ends
        .iter()
        .map(|(name, at)| format!("{} {}", said(name), said(&Value::Number(*at))));
    let ends: Vec<String> = ends.collect();
    let spans = measured.spans.iter();
    let spans: Vec<String> = spans.map(|(_, value, _)| said(value)).collect();
    let title = look.catalog.message(&measured.title);
    format!("{title}: {}; {}", ends.join(", "), spans.join("; "))
}
