//! Signed numbers on axes of their own, one over the other.
//!
//! ```text
//!   One sphere, six planes                       All faces      looks away │ faces the camera
//!   near   ────────▒│▒──●──────   2.60           1                         │▇▇▇▇▇▇ 117     drawn
//!   left   ────◆───▒│▒─────────  −3.40           4                     −9 ▇│              culled
//!   top    ────────▒│▒─────────      –           5                −45 ▇▇▇▇▇│              culled
//!          out    −r r        in
//! ```

use egui::{Align2, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

use crate::{
    figure::{Gauge, Gauges, Role},
    paint::Typeset,
    text::{Notation, Value},
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate, Style, colour, text_colour},
};

const TITLE_PTS: f32 = 13.0;
const TEXT_PTS: f32 = 13.0;
const NUMBER_PTS: f32 = 12.5;
const SMALL_PTS: f32 = 11.5;
/// From one axis to the next, at most.
const ROW: f32 = 22.0;
/// Height of the title with the white space under it, and of what stands under the axes.
const OVER: f32 = 27.0;
const UNDER: f32 = 20.0;
/// Between a column and the axes.
const ASIDE: f32 = 14.0;
/// The least that axes are worth drawing with.
const LEAST_AXIS: f32 = 90.0;
const DOT: f32 = 3.6;
const DIAMOND: f32 = 5.4;
const BAR: f32 = 9.0;
/// So many times the band an axis reaches at least.
const BANDS: f64 = 3.0;

impl OnSlate for Gauges {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let slate = Slate::with_numbers(painter, look, notation(self));
        slate.fitted_in(rect.size(), |slate| {
            let [left, right] = columns(slate, self);
            let rows = self.rows.len() as f32 * 0.8 * ROW;
            vec2(
                left + right + slate.pts(LEAST_AXIS),
                slate.pts(OVER + rows + UNDER),
            )
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let theme = slate.theme();
        let style = (Face::Strong, TITLE_PTS, theme.ink);
        let title = slate.sentence(&self.title, rect.width(), style);
        let title = slate.put(&title, rect.min, Align2::LEFT_TOP);
        let axes = Axes::new(slate, self, rect, title.bottom());
        axes.ground(slate, self);
        for (nth, row) in self.rows.iter().enumerate() {
            axes.row(slate, nth, row, links);
        }
        axes.sides(slate, self, title);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let notation = notation(self);
        let row = |row: &Gauge| {
            let name = look.catalog.value(&row.name);
            let value = row.value.map(Value::Number);
            let value = value.map(|value| look.catalog.value_as(&value, notation));
            let arrow = if row.role == Role::Signal { "→ " } else { "" };
            let said = format!("{arrow}{name}: {}", value.as_deref().unwrap_or(UNKNOWN));
            match &row.verdict {
                Some(verdict) => format!("{said}, {}", look.catalog.message(verdict)),
                None => said,
            }
        };
        let rows: Vec<String> = self.rows.iter().map(row).collect();
        format!("{}: {}", look.catalog.message(&self.title), rows.join("; "))
    }
}

/// A number that has not been asked for yet.
const UNKNOWN: &str = "–";

/// They stand over each other.
fn notation(gauges: &Gauges) -> Notation {
    let values = gauges.rows.iter().filter_map(|row| row.value);
    let values: Vec<Value> = values.chain(gauges.band).map(Value::Number).collect();
    Notation::of(&values)
}

/// Where the axes stand.
struct Axes {
    rect: Rect,
    /// All of them, with names and numbers.
    whole: Rect,
    row: f32,
    reach: f64,
}

impl Axes {
    fn new(slate: &Slate<'_>, gauges: &Gauges, rect: Rect, top: f32) -> Self {
        let [left, right] = columns(slate, gauges);
        let n = gauges.rows.len().max(1) as f32;
        let under = if has_bars(gauges) {
            0.0
        } else {
            slate.pts(UNDER)
        };
        let top = top + slate.pts(8.0);
        let row = ((rect.bottom() - top - under) / n).min(slate.pts(ROW));
        let whole = Rect::from_x_y_ranges(rect.x_range(), top..=top + n * row);
        Self {
            rect: Rect::from_x_y_ranges(
                rect.left() + left..=(rect.right() - right).max(rect.left() + left + 1.0),
                whole.y_range(),
            ),
            whole,
            row,
            reach: reach(gauges),
        }
    }

    fn x(&self, value: f64) -> f32 {
        let part = (0.5 * value / self.reach).clamp(-0.5, 0.5) as f32;
        self.rect.center().x + part * self.rect.width()
    }

    /// What is the same for all rows: the band, and where 0 is.
    fn ground(&self, slate: &mut Slate<'_>, gauges: &Gauges) {
        let theme = slate.theme();
        if let Some(band) = gauges.band {
            let x = self.x(-band)..=self.x(band);
            let place = Rect::from_x_y_ranges(x, self.rect.y_range());
            slate.painter.rect_filled(place, 0.0, theme.hover);
        }
        let zero = slate.stroke(
            if gauges.band.is_some() { 2.0 } else { 1.0 },
            theme.hairline,
        );
        let zero = Stroke::new(zero.width, theme.hairline.lerp_to_gamma(theme.faint, 0.4));
        slate
            .painter
            .vline(self.rect.center().x, self.rect.y_range(), zero);
    }

    fn row(&self, slate: &mut Slate<'_>, nth: usize, row: &Gauge, links: &mut Links) {
        let theme = slate.theme();
        let y = self.whole.top() + (nth as f32 + 0.5) * self.row;
        let place = Rect::from_x_y_ranges(
            self.whole.x_range(),
            y - 0.5 * self.row..=y + 0.5 * self.row,
        );
        if links.touch(place, row.link) {
            let around = place.expand2(vec2(slate.pts(4.0), 0.0));
            slate.painter.rect_filled(around, 4.0, theme.accent_wash);
        }
        if !row.is_bar {
            let axis = slate.stroke(1.0, theme.hairline);
            slate.painter.hline(self.rect.x_range(), y, axis);
        }
        let face = strength(row);
        let name = slate.value(&row.name, (face, TEXT_PTS, name_colour(slate, row)));
        slate.put(&name, pos2(self.whole.left(), y), Align2::LEFT_CENTER);
        if row.is_bar {
            self.bar(slate, y, row);
        } else {
            self.dot(slate, y, row);
        }
    }

    fn dot(&self, slate: &mut Slate<'_>, y: f32, row: &Gauge) {
        let theme = slate.theme();
        let number = number(slate, row);
        slate.put(&number, pos2(self.whole.right(), y), Align2::RIGHT_CENTER);
        let Some(value) = row.value else { return };
        let at = pos2(self.x(value), y);
        let ink = colour(theme, row.role);
        match row.role {
            Role::Signal => {
                let diamond = diamond(at, slate.pts(DIAMOND));
                let shape = Shape::convex_polygon(diamond, ink, Stroke::NONE);
                slate.painter.add(shape);
            }
            // What is culled is hollow.
            Role::Discarded => {
                let rim = slate.stroke(1.5, ink);
                let radius = slate.pts(DOT);
                slate.painter.circle(at, radius, theme.background, rim);
            }
            Role::Ink | Role::Soft | Role::Faint | Role::Accent | Role::Accepted => {
                slate.painter.circle_filled(at, slate.pts(DOT), ink);
            }
        }
    }

    fn bar(&self, slate: &mut Slate<'_>, y: f32, row: &Gauge) {
        let theme = slate.theme();
        if let Some(verdict) = &row.verdict {
            let style = (strength(row), SMALL_PTS, text_colour(theme, row.role));
            let verdict = slate.sentence(verdict, self.whole.width(), style);
            slate.put(&verdict, pos2(self.whole.right(), y), Align2::RIGHT_CENTER);
        }
        let Some(value) = row.value else { return };
        let (zero, end) = (self.x(0.0), self.x(value));
        let half = 0.5 * slate.pts(BAR).min(0.7 * self.row);
        let place = Rect::from_x_y_ranges(zero.min(end)..=zero.max(end), y - half..=y + half);
        let fill = match row.role {
            Role::Discarded => theme.background.lerp_to_gamma(theme.discarded, 0.55),
            role @ (Role::Ink
            | Role::Soft
            | Role::Faint
            | Role::Accent
            | Role::Signal
            | Role::Accepted) => colour(theme, role),
        };
        slate.painter.rect_filled(place, 0.0, fill);
        let number = number(slate, row);
        let gap = slate.pts(7.0);
        if value < 0.0 {
            slate.put(&number, pos2(end - gap, y), Align2::RIGHT_CENTER);
        } else {
            slate.put(&number, pos2(end + gap, y), Align2::LEFT_CENTER);
        }
    }

    /// What either side means: over the bars, on their sides; under the axes, at their ends.
    fn sides(&self, slate: &mut Slate<'_>, gauges: &Gauges, title: Rect) {
        let theme = slate.theme();
        let [left, right] = &gauges.sides;
        let set = |slate: &Slate<'_>, side, ink| {
            slate.sentence(side, f32::INFINITY, (Face::Plain, SMALL_PTS, ink))
        };
        if has_bars(gauges) {
            let (zero, gap) = (self.x(0.0), slate.pts(8.0));
            let [left, right] = [
                set(slate, left, theme.soft),
                set(slate, right, theme.accent),
            ];
            // Beside the title, if there is room.
            let is_free = zero - gap - left.size().x > title.right() + gap
                && zero + gap + right.size().x < self.whole.right();
            if is_free {
                let y = title.center().y;
                slate.put(&left, pos2(zero - gap, y), Align2::RIGHT_CENTER);
                slate.put(&right, pos2(zero + gap, y), Align2::LEFT_CENTER);
            }
            return;
        }
        let y = self.rect.bottom() + slate.pts(3.0);
        let [left, right] = [left, right].map(|side| set(slate, side, theme.soft));
        slate.put(&left, pos2(self.rect.left(), y), Align2::LEFT_TOP);
        slate.put(&right, pos2(self.rect.right(), y), Align2::RIGHT_TOP);
        let Some(band) = gauges.band.filter(|band| *band > 0.0) else {
            return;
        };
        for (sign, name) in [(-1.0, "−r"), (1.0, "r")] {
            let style = (Face::Plain, SMALL_PTS, theme.ink);
            let name = slate.words(name, style);
            let at = pos2(self.x(sign * band), y);
            let place = Align2::CENTER_TOP.anchor_size(at, name.size());
            if slate.is_free(place) {
                slate.put(&name, at, Align2::CENTER_TOP);
            }
        }
    }
}

fn has_bars(gauges: &Gauges) -> bool {
    gauges.rows.iter().any(|row| row.is_bar)
}

/// Widths of names on the left, and of numbers or verdicts on the right.
fn columns(slate: &Slate<'_>, gauges: &Gauges) -> [f32; 2] {
    let widest = |texts: &mut dyn Iterator<Item = Typeset>| {
        texts.map(|text| text.size().x).fold(0.0, f32::max)
    };
    let ink = slate.theme().ink;
    let names = gauges.rows.iter();
    let mut names = names.map(|row| slate.value(&row.name, (Face::Strong, TEXT_PTS, ink)));
    let mut numbers = gauges.rows.iter().map(|row| number(slate, row));
    let number = widest(&mut numbers);
    let mut verdicts = gauges.rows.iter().filter_map(|row| {
        let style = (Face::Strong, SMALL_PTS, ink);
        let verdict = row.verdict.as_ref();
        verdict.map(|verdict| slate.sentence(verdict, f32::INFINITY, style))
    });
    let aside = slate.pts(ASIDE);
    let (left, right) = (widest(&mut names) + aside, widest(&mut verdicts) + aside);
    if has_bars(gauges) {
        // A number stands at the end of the longest bar.
        let number = number + slate.pts(8.0);
        [left + number, right + number]
    } else {
        // Room for a number before it is known.
        [left, number.max(slate.pts(40.0)) + aside]
    }
}

fn number(slate: &Slate<'_>, row: &Gauge) -> Typeset {
    let theme = slate.theme();
    match row.value {
        Some(value) => {
            let ink = match row.role {
                Role::Signal => theme.signal_text,
                Role::Discarded | Role::Faint | Role::Soft => theme.soft,
                Role::Ink | Role::Accent | Role::Accepted => theme.ink,
            };
            let style: Style = (Face::Mono, NUMBER_PTS, ink);
            slate.low(&Value::Number(value), style)
        }
        None => slate.words(UNKNOWN, (Face::Mono, NUMBER_PTS, theme.faint)),
    }
}

fn strength(row: &Gauge) -> Face {
    if row.role == Role::Signal {
        Face::Strong
    } else {
        Face::Plain
    }
}

fn name_colour(slate: &Slate<'_>, row: &Gauge) -> egui::Color32 {
    let theme = slate.theme();
    if row.role == Role::Signal {
        theme.signal_text
    } else if row.value.is_none() {
        theme.faint
    } else {
        theme.soft
    }
}

fn diamond(at: Pos2, radius: f32) -> Vec<Pos2> {
    [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)]
        .map(|(x, y)| at + vec2(x, y) * radius)
        .to_vec()
}

/// As far as axes reach on either side: round, so that it seldom changes while numbers come.
fn reach(gauges: &Gauges) -> f64 {
    let values = gauges.rows.iter().filter_map(|row| row.value);
    let band = gauges.band.map(|band| BANDS * band);
    let most = values.chain(band).map(f64::abs).fold(0.0, f64::max);
    if !(most.is_normal() && most.is_finite()) {
        return 1.0;
    }
    let power = libm::pow(10.0, libm::log10(most).floor());
    let round = [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    let mut round = round.into_iter().map(|m| m * power);
    round.find(|&round| round >= most).unwrap_or(most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Message;

    #[test]
    fn axes_reach_as_far_as_the_largest_number_and_the_band() {
        let of = |values: &[Option<f64>], band| {
            let row = |&value: &Option<f64>| Gauge {
                name: Value::Count(1),
                value,
                verdict: None,
                role: Role::Accent,
                is_bar: false,
                link: None,
            };
            reach(&Gauges {
                title: Message::new("view-empty"),
                sides: [Message::new("view-empty"), Message::new("view-empty")],
                band,
                rows: values.iter().map(row).collect(),
            })
        };
        assert_eq!(of(&[None], None), 1.0);
        assert_eq!(of(&[Some(-171.0), None], None), 200.0);
        assert_eq!(of(&[Some(0.5)], Some(1.0)), 3.0);
        assert_eq!(of(&[Some(f64::NAN), Some(f64::INFINITY)], None), 1.0);
    }
}
