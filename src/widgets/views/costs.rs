//! What methods cost, a row an operation: of two the bars stand back to back, what both do in grey and what only one does
//! in the signal's colour.
//!
//! ```text
//!   Nicholl–Lee–Nicholl  │  Liang–Barsky
//!                divisions
//!              2 ▓▓▓▓▓▓▓▓│▓▓▓▓▓▓▓▓████████ 4
//!                 in total
//!             53 ▓▓▓▓▓▓▓▓│▓▓▓▓▓▓▓▓ 53
//! ```

use crate::{
    figure::Costs,
    trace::Counts,
    widgets::cost::{KINDS, Kind},
};

use super::{prelude::*, slate::Style};

const SIZE: f32 = 13.0;
/// A bar's height, of two methods, of more, and of many; what is left under a kind's bars, of two, and of more, which have a bar each.
const BARS: [f32; 3] = [20.0, 14.0, 16.0];
/// More methods are compared by their divisions and in total only.
const MOST_WITH_KINDS: usize = 3;
const LINE: f32 = 19.0;
const GAPS: [f32; 2] = [18.0, 8.0];
const WITHIN: f32 = 7.0;
const HEAD: f32 = 32.0;
/// A row may be so many times as high as it has to be.
const APART: f32 = 1.5;
/// The gap under the last row may be missing.
const FITS: f32 = 0.3;

const TOTAL: Kind = ("cost-total", "cost-total", Counts::total);

impl Costs {
    /// Of many methods what divides them most.
    fn rows(&self) -> impl Iterator<Item = Kind> + use<> {
        let n = if self.is_crowd() { 1 } else { KINDS.len() };
        KINDS.into_iter().take(n).chain([TOTAL])
    }

    /// As many of them as there is room for: the total, and of the rest first those that differ.
    fn rows_in(&self, n_fit: usize) -> Vec<Kind> {
        let mut rows: Vec<Kind> = self.rows().collect();
        let is_same = |kind: &Kind| {
            let mut counts = self.counts.iter().map(kind.2);
            let first = counts.next();
            counts.all(|count| Some(count) == first)
        };
        while rows.len() > n_fit.max(1) {
            let of_kinds = &rows[..rows.len() - 1];
            rows.remove(of_kinds.iter().position(is_same).unwrap_or(0));
        }
        rows
    }

    const fn is_crowd(&self) -> bool {
        self.counts.len() > MOST_WITH_KINDS
    }

    /// The bars' full length: the largest total, so that bars add up to it. Of many, a kind has its own scale.
    fn most(&self, kind: &Kind) -> u64 {
        let of = if self.is_crowd() { kind.2 } else { TOTAL.2 };
        let most = self.counts.iter().map(of).max();
        most.unwrap_or_default().max(1)
    }

    /// As low as it can be.
    fn row_height(&self, slate: &Slate<'_>) -> f32 {
        let n_lines = if self.is_pair() { 1 } else { self.counts.len() };
        let gap = GAPS[usize::from(!self.is_pair())];
        Self::line(slate) + slate.pts(gap) + n_lines as f32 * self.step(slate)
    }

    /// The words over a kind's bars: text does not shrink without end.
    fn line(slate: &Slate<'_>) -> f32 {
        const LINES: f32 = 1.3;
        slate.pts(LINE).max(LINES * slate.theme().least_text)
    }

    /// From bar to bar, which have their names beside them.
    fn step(&self, slate: &Slate<'_>) -> f32 {
        const LINE: f32 = 1.2;
        slate
            .pts(self.bar() + 2.0)
            .max(LINE * slate.theme().least_text)
    }

    const fn bar(&self) -> f32 {
        match self.counts.len() {
            2 => BARS[0],
            ..=MOST_WITH_KINDS => BARS[1],
            _ => BARS[2],
        }
    }

    const fn is_pair(&self) -> bool {
        self.counts.len() == 2
    }

    fn numbers(&self, slate: &Slate<'_>) -> f32 {
        let all = self
            .rows()
            .flat_map(|kind| self.counts.iter().map(move |counts| (kind.2)(counts)));
        let width = |n: u64| slate.width(&number(n), Face::Strong, SIZE);
        all.map(width).fold(0.0, f32::max) + slate.pts(WITHIN)
    }

    fn names(&self, slate: &Slate<'_>) -> Vec<Typeset> {
        let style = (Face::Strong, SIZE, slate.theme().ink);
        let names = self.names.iter();
        names.map(|name| slate.value(name, style)).collect()
    }
}

fn number(n: u64) -> Value {
    Value::Count(usize::try_from(n).unwrap_or(usize::MAX))
}

impl OnSlate for Costs {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        natural.fitted_in(room, |slate| {
            let names = self.names(slate);
            let widest = names.iter().map(|name| name.size().x).fold(0.0, f32::max);
            let height = slate.pts(HEAD) + self.rows().count() as f32 * self.row_height(slate);
            let n = if self.is_pair() { 2.0 } else { 1.0 };
            vec2(n * (widest + slate.pts(WITHIN)), height)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, _: &mut Links) {
        let names = self.names(slate);
        let middle = rect.center().x.round();
        let mut head = slate.pts(HEAD);
        if let ([left, right], true) = (&names[..], self.is_pair()) {
            let gap = vec2(slate.pts(WITHIN), 0.0);
            let top = pos2(middle, rect.top());
            let half = 0.5 * rect.width() - gap.x;
            for (nth, (name, at, align)) in [
                (left, top - gap, Align2::RIGHT_TOP),
                (right, top + gap, Align2::LEFT_TOP),
            ]
            .into_iter()
            .enumerate()
            {
                if name.size().x <= half {
                    slate.put(name, at, align);
                } else {
                    let style = (Face::Strong, SIZE, slate.theme().ink);
                    let name = slate.wrapped(&self.names[nth], half, style);
                    head = head.max(name.size().y + slate.pts(WITHIN));
                    slate.put(&name, at, align);
                }
            }
        }
        let least = self.row_height(slate);
        let mut top = rect.top() + head;
        let room = rect.bottom() - top;
        let rows = self.rows_in((room / least + FITS).floor() as usize);
        // Where there is room, they stand apart.
        let height = (room / rows.len() as f32).clamp(least, APART * least);
        for kind in rows {
            let place = Rect::from_min_size(pos2(rect.left(), top), vec2(rect.width(), height));
            let style = (Face::Plain, SIZE, slate.theme().soft);
            let words = slate.words(slate.look.say(kind.0), style);
            if self.is_pair() {
                slate.put(&words, pos2(middle, top), Align2::CENTER_TOP);
                self.pair(slate, place, &kind);
            } else {
                slate.put(&words, place.min, Align2::LEFT_TOP);
                self.stack(slate, place, &kind, &names);
            }
            top += height;
        }
    }

    /// `divisions: Nicholl–Lee–Nicholl 2, Liang–Barsky 6; …`.
    fn spoken(&self, look: Look<'_>) -> String {
        let of = |kind: Kind| {
            let named = self.names.iter().zip(&self.counts);
            let said = |(name, counts): (&Value, &Counts)| {
                format!("{} {}", look.catalog.value(name), (kind.2)(counts))
            };
            format!("{}: {}", look.say(kind.1), joined(named.map(said), ", "))
        };
        joined(self.rows().map(of), "; ")
    }
}

impl Costs {
    fn pair(&self, slate: &mut Slate<'_>, place: Rect, kind: &Kind) {
        let theme = slate.theme();
        let middle = pos2(place.center().x.round(), place.top() + Self::line(slate));
        let room = 0.5 * place.width() - self.numbers(slate);
        let unit = room / self.most(kind) as f32;
        let both = self.least(kind);
        for (counts, side) in self.counts.iter().zip([-1.0, 1.0]) {
            let n = (kind.2)(counts);
            let is_more = n > both;
            let ink = if is_more {
                theme.signal_text
            } else {
                theme.ink
            };
            let style = (Face::strong_if(is_more), SIZE, ink);
            self.draw_bar(slate, middle, side * unit, [both, n], style);
        }
        let axis = slate.stroke(1.5, theme.ink);
        let ends = [-2.0, self.bar() + 2.0].map(|off| middle + vec2(0.0, slate.pts(off)));
        slate.line(ends, axis);
    }

    /// Of three or more: each has a bar of its own, after its name.
    fn stack(&self, slate: &mut Slate<'_>, place: Rect, kind: &Kind, names: &[Typeset]) {
        let widest = names.iter().map(|name| name.size().x).fold(0.0, f32::max);
        let left = place.left() + widest + slate.pts(WITHIN);
        let unit = (place.right() - left - self.numbers(slate)) / self.most(kind) as f32;
        let mut from = pos2(left, place.top() + Self::line(slate));
        for (nth, counts) in self.counts.iter().enumerate() {
            if let Some(name) = names.get(nth) {
                let y = from.y + 0.5 * slate.pts(self.bar());
                slate.put(name, pos2(place.left(), y), Align2::LEFT_CENTER);
            }
            let style = (Face::Plain, SIZE, slate.theme().ink);
            let counts = [self.least(kind), (kind.2)(counts)];
            self.draw_bar(slate, from, unit, counts, style);
            from.y += self.step(slate);
        }
    }

    fn least(&self, kind: &Kind) -> u64 {
        let counts = self.counts.iter().map(kind.2);
        counts.min().unwrap_or_default()
    }

    /// Of a count, what all do and what is more, and the number at its end; a negative `unit` leads to the left.
    fn draw_bar(
        &self,
        slate: &mut Slate<'_>,
        from: Pos2,
        unit: f32,
        [all, n]: [u64; 2],
        style: Style,
    ) {
        let theme = slate.theme();
        let height = slate.pts(self.bar());
        let along = |n: u64| from.x + unit * n as f32;
        let bar = |from_x: f32, to: f32| {
            let xs = from_x.min(to)..=from_x.max(to);
            Rect::from_x_y_ranges(xs, from.y..=from.y + height)
        };
        for (bar, colour) in [
            (bar(from.x, along(all)), theme.discarded),
            (bar(along(all), along(n)), theme.signal),
        ] {
            slate.painter.rect_filled(bar, 0.0, colour);
        }
        let text = slate.value(&number(n), style);
        let (side, align) = if unit < 0.0 {
            (-1.0, Align2::RIGHT_CENTER)
        } else {
            (1.0, Align2::LEFT_CENTER)
        };
        let at = pos2(along(n) + side * slate.pts(WITHIN), from.y + 0.5 * height);
        slate.put(&text, at, align);
    }
}
