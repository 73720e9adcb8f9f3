//! Signed numbers on axes of their own, one over the other.
//!
//! ```text
//!   One sphere, six planes                       All faces      looks away │ faces the camera
//!   near   ────────▒│▒──●──────   2.60           1                         │▇▇▇▇▇▇ 117     drawn
//!   left   ────◆───▒│▒─────────  −3.40           4                     −9 ▇│              culled
//!   top    ────────▒│▒─────────      –           5                −45 ▇▇▇▇▇│              culled
//!          out    −r r        in
//! ```

use crate::figure::{Gauge, Gauges};

use super::prelude::*;

const TEXT_PTS: f32 = 13.0;
const NUMBER_PTS: f32 = 12.5;
const SMALL_PTS: f32 = 11.5;
const ROWS: [f32; 2] = [17.6, 34.0];
const OVER: f32 = 27.0;
const UNDER: f32 = 20.0;
const ASIDE: f32 = 14.0;
const LEAST_AXIS: f32 = 90.0;
const DOT: f32 = 3.6;
const DIAMOND: f32 = 5.4;
const BAR: f32 = 9.0;
const BANDS: f64 = 3.0;

impl OnSlate for Gauges {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        natural.fitted_in(room, |slate| {
            let [left, right] = columns(slate, self);
            let rows = self.rows.len() as f32 * ROWS[0];
            let width = left + right + slate.pts(LEAST_AXIS);
            vec2(width, slate.pts(OVER + rows + UNDER))
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let theme = slate.theme();
        let style = (Face::Strong, TEXT_PTS, theme.ink);
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
        let row = |row: &Gauge| {
            let name = look.catalog.value(&row.name);
            let value = row.value.map(|value| look.catalog.number(value));
            let value = value.as_deref().unwrap_or(UNKNOWN);
            let said = format!("{}{name}: {value}", now(row.role == Role::Signal));
            match &row.verdict {
                Some(verdict) => format!("{said}, {}", look.catalog.message(verdict)),
                None => said,
            }
        };
        let rows = joined(self.rows.iter().map(row), "; ");
        format!("{}: {rows}", look.catalog.message(&self.title))
    }
}

const UNKNOWN: &str = "–";

struct Axes {
    rect: Rect,
    whole: Rect,
    row: f32,
    reach: f64,
}

impl Axes {
    fn new(slate: &Slate<'_>, gauges: &Gauges, rect: Rect, top: f32) -> Self {
        let [left, right] = columns(slate, gauges);
        let n = gauges.rows.len().max(1) as f32;
        let under = slate.pts(if has_bars(gauges) { 0.0 } else { UNDER });
        let top = top + slate.pts(8.0);
        let row = ((rect.bottom() - top - under) / n).min(slate.pts(ROWS[1]));
        let whole = Rect::from_x_y_ranges(rect.x_range(), top..=top + n * row);
        let left = rect.left() + left;
        let x = left..=(rect.right() - right).max(left + 1.0);
        Self {
            rect: Rect::from_x_y_ranges(x, whole.y_range()),
            whole,
            row,
            reach: reach(gauges),
        }
    }

    fn x(&self, value: f64) -> f32 {
        let part = (0.5 * value / self.reach).clamp(-0.5, 0.5) as f32;
        self.rect.center().x + part * self.rect.width()
    }

    fn ground(&self, slate: &mut Slate<'_>, gauges: &Gauges) {
        let theme = slate.theme();
        if let Some(band) = gauges.band {
            let x = self.x(-band)..=self.x(band);
            let place = Rect::from_x_y_ranges(x, self.rect.y_range());
            slate.painter.rect_filled(place, 0.0, theme.hover);
        }
        let width = if gauges.band.is_some() { 2.0 } else { 1.0 };
        let zero = slate.stroke(width, theme.hairline.lerp_to_gamma(theme.faint, 0.4));
        let (x, y) = (self.rect.center().x, self.rect.y_range());
        slate.painter.vline(x, y, zero);
    }

    fn row(&self, slate: &mut Slate<'_>, nth: usize, row: &Gauge, links: &mut Links) {
        let theme = slate.theme();
        let y = self.whole.top() + (nth as f32 + 0.5) * self.row;
        let half = 0.5 * self.row;
        let place = Rect::from_x_y_ranges(self.whole.x_range(), y - half..=y + half);
        if links.touch(place, row.link) {
            let around = place.expand2(vec2(slate.pts(4.0), 0.0));
            slate.painter.rect_filled(around, 4.0, theme.accent_wash);
        }
        if !row.is_bar {
            let axis = slate.stroke(1.0, theme.hairline);
            slate.painter.hline(self.rect.x_range(), y, axis);
        }
        let ink = match row.role {
            Role::Signal => theme.signal_text,
            _ if row.value.is_none() => theme.faint,
            _ => theme.soft,
        };
        let name = slate.value(
            &row.name,
            (Face::strong_if(row.role == Role::Signal), TEXT_PTS, ink),
        );
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
                let corners = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)];
                let corners = corners.map(|(x, y)| at + vec2(x, y) * slate.pts(DIAMOND));
                slate.area(corners.to_vec(), ink);
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
            let style = (
                Face::strong_if(row.role == Role::Signal),
                SMALL_PTS,
                text_colour(theme, row.role),
            );
            let verdict = slate.sentence(verdict, self.whole.width(), style);
            slate.put(&verdict, pos2(self.whole.right(), y), Align2::RIGHT_CENTER);
        }
        let Some(value) = row.value else { return };
        let (zero, end) = (self.x(0.0), self.x(value));
        let half = 0.5 * slate.pts(BAR).min(0.7 * self.row);
        let place = Rect::from_x_y_ranges(zero.min(end)..=zero.max(end), y - half..=y + half);
        let fill = match row.role {
            Role::Discarded => theme.background.lerp_to_gamma(theme.discarded, 0.55),
            role => colour(theme, role),
        };
        slate.painter.rect_filled(place, 0.0, fill);
        let number = number(slate, row);
        let gap = slate.pts(7.0);
        let (x, align) = match value {
            ..0.0 => (end - gap, Align2::RIGHT_CENTER),
            _ => (end + gap, Align2::LEFT_CENTER),
        };
        slate.put(&number, pos2(x, y), align);
    }

    fn sides(&self, slate: &mut Slate<'_>, gauges: &Gauges, title: Rect) {
        let theme = slate.theme();
        let [left, right] = &gauges.sides;
        let set = |slate: &Slate<'_>, side, ink| {
            slate.sentence(side, f32::INFINITY, (Face::Plain, SMALL_PTS, ink))
        };
        if has_bars(gauges) {
            let (zero, gap) = (self.x(0.0), slate.pts(8.0));
            let left = set(slate, left, theme.soft);
            let right = set(slate, right, theme.accent);
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
            let name = slate.words(name, (Face::Plain, SMALL_PTS, theme.ink));
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

fn columns(slate: &Slate<'_>, gauges: &Gauges) -> [f32; 2] {
    let widest = |widths: &mut dyn Iterator<Item = f32>| widths.fold(0.0, f32::max);
    let rows = gauges.rows.iter();
    let names = rows.clone();
    let mut names = names.map(|row| slate.width(&row.name, Face::Strong, TEXT_PTS));
    let number = widest(&mut rows.clone().map(|row| number(slate, row).size().x));
    let mut verdicts = rows.filter_map(|row| {
        let style = (Face::Strong, SMALL_PTS, slate.theme().ink);
        let verdict = row.verdict.as_ref()?;
        Some(slate.sentence(verdict, f32::INFINITY, style).size().x)
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
    let Some(value) = row.value else {
        return slate.words(UNKNOWN, (Face::Mono, NUMBER_PTS, theme.faint));
    };
    let ink = match row.role {
        Role::Signal => theme.signal_text,
        Role::Discarded | Role::Faint | Role::Soft => theme.soft,
        Role::Ink | Role::Accent | Role::Accepted => theme.ink,
    };
    slate.low(&Value::Number(value), (Face::Mono, NUMBER_PTS, ink))
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
    use super::{
        super::tests::data::frustum::{distances, gauge},
        *,
    };

    #[test]
    fn axes_reach_as_far_as_the_largest_number_and_the_band() {
        let of = |values: &[Option<f64>], band| {
            let row = |&value: &Option<f64>| gauge(Value::Count(1), value, Role::Accent);
            let rows = values.iter().map(row).collect();
            let of = Gauges {
                band,
                rows,
                ..distances()
            };
            reach(&of)
        };
        assert_eq!(of(&[None], None), 1.0);
        assert_eq!(of(&[Some(-171.0), None], None), 200.0);
        assert_eq!(of(&[Some(0.5)], Some(1.0)), 3.0);
        assert_eq!(of(&[Some(f64::NAN), Some(f64::INFINITY)], None), 1.0);
    }
}
