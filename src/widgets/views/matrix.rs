//! A matrix times a vector: the row at work lit through matrix, vector and result, and written out under them.
//!
//! ```text
//!   clip_from_view   90°, near 2, far 10
//!   ⎡ 0.625  0    0    0 ⎤ ⎡  3 ⎤   ⎡ 1.875 ⎤
//!   ⎢   0    1    0    0 ⎥ ⎢  2 ⎥ = ⎢     2 ⎥
//!   ⎢   0    0 −1.5   −5 ⎥ ⎢ −5 ⎥   ⎢   2.5 ⎥
//!  ▌⎣   0    0   −1    0 ⎦ ⎣  1 ⎦   ⎣     5 ⎦
//!                           view      clip
//!   w = −1 · (−5) = 5
//! ```

use crate::figure::{MatrixProduct, MatrixRow};

use super::prelude::*;

const NAME_PTS: f32 = 14.0;
const NOTE_PTS: f32 = 12.0;
const NUMBER_PTS: f32 = 15.0;
const SUM_PTS: f32 = 13.5;
const ROW: f32 = 27.0;
const SUM_ROW: f32 = 20.0;
const OVER: f32 = 28.0;
const UNDER: f32 = 30.0;
const BETWEEN: f32 = 16.0;
const WITHIN: f32 = 10.0;
const APART: f32 = 14.0;
const HOOK: f32 = 5.0;
/// And of what that comes to at least this part: smaller numbers are not read any more.
const LEAST_PART: f32 = 0.34;

impl OnSlate for MatrixProduct {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let least = LEAST_PART * natural.scale;
        // All rows have their room from the start.
        natural.shrunk_to(least, room, |slate| {
            let columns = Columns::new(slate, self);
            let rows = self.rows.len() as f32;
            let sums = self.rows.iter().filter_map(|row| {
                let sum = row.sum.as_ref()?;
                Some(written(slate, row, sum).size().x + slate.pts(WITHIN))
            });
            let width = sums.fold(columns.width(), f32::max);
            let height = OVER + rows * ROW + UNDER + rows * SUM_ROW;
            vec2(width, slate.pts(height))
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let theme = slate.theme();
        let name = slate.value(&self.name, (Face::Strong, NAME_PTS, theme.ink));
        let mut place = slate.put(&name, rect.min, Align2::LEFT_TOP);
        let gap = slate.pts(10.0);
        for note in &self.notes {
            let note = slate.value(note, (Face::Plain, NOTE_PTS, theme.soft));
            let at = pos2(place.right() + gap, place.bottom());
            if at.x + note.size().x <= rect.right() {
                place = slate.put(&note, at, Align2::LEFT_BOTTOM);
            }
        }
        let top = rect.top() + slate.pts(OVER);
        let columns = Columns::new(slate, self);
        let size = vec2(columns.width().min(rect.width()), slate.pts(ROW));
        for (nth, row) in self.rows.iter().enumerate() {
            let y = top + nth as f32 * slate.pts(ROW);
            let strip = Rect::from_min_size(pos2(rect.left(), y), size);
            if links.touch(strip, row.link) || row.is_current {
                slate.painter.rect_filled(strip, 0.0, theme.accent_wash);
            }
            if row.is_current {
                let bar = strip.with_max_x(strip.left() + slate.pts(3.0));
                slate.painter.rect_filled(bar, 0.0, theme.accent);
            }
        }
        let corner = pos2(rect.left() + slate.pts(WITHIN), top);
        columns.draw(slate, corner, self);
        let bottom = top + self.rows.len() as f32 * slate.pts(ROW) + slate.pts(UNDER);
        let place = Rect::from_min_max(pos2(corner.x, bottom), rect.max);
        // How each known row was worked out; where there is no room for all, how the step's was.
        let height = slate.pts(SUM_ROW);
        let has_room = self.rows.len() as f32 * height <= place.height() + 1.0;
        let mut nth = 0;
        for row in &self.rows {
            let shown = row.sum.as_ref().filter(|_| has_room || row.is_current);
            if let Some(sum) = shown {
                let text = written(slate, row, sum);
                let at = pos2(place.left(), place.top() + nth as f32 * height);
                slate.put(&text, at, Align2::LEFT_TOP);
            }
            // Each has its place from the start.
            nth += usize::from(has_room || shown.is_some());
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let row = |row: &MatrixRow| {
            let sum = row.sum.as_ref()?;
            let sum = look.catalog.formula(sum);
            Some(format!("{}{sum}", now(row.is_current)))
        };
        let rows = joined(self.rows.iter().filter_map(row), "; ");
        format!("{}: {rows}", look.catalog.value(&self.name))
    }
}

struct Columns {
    entries: Vec<f32>,
    operand: f32,
    operator: f32,
    result: Option<f32>,
    between: f32,
    within: f32,
    apart: f32,
}

impl Columns {
    fn new(slate: &Slate<'_>, product: &MatrixProduct) -> Self {
        let widest = |values: &mut dyn Iterator<Item = f64>| {
            let width = |x: f64| slate.width(&Value::Number(x), Face::Mono, NUMBER_PTS);
            values.map(width).fold(slate.pts(14.0), f32::max)
        };
        let rows = &product.rows;
        let n = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
        let entries = (0..n)
            .map(|i| widest(&mut rows.iter().filter_map(|row| row.entries.get(i).copied())))
            .collect();
        let within = slate.pts(WITHIN);
        let named = |name: &Value| slate.width(name, Face::Plain, NOTE_PTS) - 2.0 * within;
        let operand = widest(&mut rows.iter().filter_map(|row| row.operand));
        let result = product.into.as_ref().map(|into| {
            let widest = widest(&mut rows.iter().filter_map(|row| row.result));
            // Room for numbers that have not come yet.
            widest.max(slate.pts(44.0)).max(named(into))
        });
        let style = (Face::Mono, NUMBER_PTS, Color32::PLACEHOLDER);
        let operator = product.operator.as_ref();
        let operator = operator.map(|operator| slate.formula(operator, style).size().x);
        Self {
            entries,
            operand: operand.max(named(&product.from)),
            operator: operator.unwrap_or(0.0),
            result,
            between: slate.pts(BETWEEN),
            within,
            apart: slate.pts(APART),
        }
    }

    fn matrix(&self) -> f32 {
        let gaps = self.entries.len().saturating_sub(1) as f32 * self.between;
        self.entries.iter().sum::<f32>() + gaps + 2.0 * self.within
    }

    fn width(&self) -> f32 {
        let some = |is_there: bool, width: f32| if is_there { width } else { 0.0 };
        let matrix = some(!self.entries.is_empty(), self.matrix() + self.apart);
        let operator = some(self.operator != 0.0, self.operator + self.apart);
        let result = self
            .result
            .map(|width| width + 2.0 * self.within + 3.0 * self.apart);
        let result = result.unwrap_or(0.0);
        matrix + self.operand + 2.0 * self.within + operator + result + 2.0 * self.within
    }

    fn draw(&self, slate: &mut Slate<'_>, corner: Pos2, product: &MatrixProduct) {
        let theme = slate.theme();
        let rows = &product.rows;
        let height = rows.len() as f32 * slate.pts(ROW);
        let middle = corner.y + 0.5 * height;
        let mut left = corner.x;
        if !self.entries.is_empty() {
            let mut right = left + self.within;
            for (i, width) in self.entries.iter().enumerate() {
                right += width;
                column(slate, pos2(right, corner.y), rows, |row| {
                    let x = *row.entries.get(i)?;
                    let ink = ink_of(row, theme);
                    Some((x, if x == 0.0 { theme.faint } else { ink }))
                });
                right += self.between;
            }
            brackets(slate, left, self.matrix(), [corner.y, height]);
            left += self.matrix() + self.apart;
        }
        let (at, name) = (pos2(left, corner.y), &product.from);
        let operand = |row: &MatrixRow| Some((row.operand?, theme.ink));
        left += self.vector(slate, at, self.operand, rows, name, operand);
        if let Some(operator) = &product.operator {
            let operator = slate.formula(operator, (Face::Mono, NUMBER_PTS, theme.ink));
            left += self.apart;
            slate.put(&operator, pos2(left, middle), Align2::LEFT_CENTER);
            left += self.operator;
        }
        let (Some(result), Some(into)) = (self.result, &product.into) else {
            return;
        };
        let equals = slate.words("=", (Face::Mono, NUMBER_PTS, theme.soft));
        let at = pos2(left + 1.5 * self.apart, middle);
        slate.put(&equals, at, Align2::CENTER_CENTER);
        left += 3.0 * self.apart;
        self.vector(slate, pos2(left, corner.y), result, rows, into, |row| {
            let is_now = row.is_current;
            Some((
                row.result?,
                if is_now { theme.signal_text } else { theme.ink },
            ))
        });
    }

    fn vector(
        &self,
        slate: &mut Slate<'_>,
        at: Pos2,
        width: f32,
        rows: &[MatrixRow],
        name: &Value,
        number: impl Fn(&MatrixRow) -> Option<(f64, Color32)>,
    ) -> f32 {
        let wide = width + 2.0 * self.within;
        let height = rows.len() as f32 * slate.pts(ROW);
        let right = at.x + self.within + width;
        column(slate, pos2(right, at.y), rows, number);
        brackets(slate, at.x, wide, [at.y, height]);
        let name = slate.value(name, (Face::Plain, NOTE_PTS, slate.theme().soft));
        let under = pos2(at.x + 0.5 * wide, at.y + height) + vec2(0.0, slate.pts(5.0));
        slate.put(&name, under, Align2::CENTER_TOP);
        wide
    }
}

fn column(
    slate: &mut Slate<'_>,
    right_top: Pos2,
    rows: &[MatrixRow],
    number: impl Fn(&MatrixRow) -> Option<(f64, Color32)>,
) {
    let height = slate.pts(ROW);
    for (nth, row) in rows.iter().enumerate() {
        let Some((value, ink)) = number(row) else {
            continue;
        };
        let text = slate.value(&Value::Number(value), (Face::Mono, NUMBER_PTS, ink));
        let y = right_top.y + (nth as f32 + 0.5) * height;
        slate.put(&text, pos2(right_top.x, y), Align2::RIGHT_CENTER);
    }
}

fn brackets(slate: &Slate<'_>, left: f32, width: f32, [top, height]: [f32; 2]) {
    let stroke = slate.stroke(1.5, slate.theme().soft);
    let hook = slate.pts(HOOK);
    for (x, inwards) in [(left, hook), (left + width, -hook)] {
        let [upper, lower] = [top, top + height].map(|y| [pos2(x + inwards, y), pos2(x, y)]);
        let path = vec![upper[0], upper[1], lower[1], lower[0]];
        slate.painter.line(path, stroke);
    }
}

const fn ink_of(row: &MatrixRow, theme: &Theme) -> Color32 {
    if row.is_current {
        theme.ink
    } else {
        theme.soft
    }
}

fn written(slate: &Slate<'_>, row: &MatrixRow, sum: &Formula) -> Typeset {
    let ink = ink_of(row, slate.theme());
    slate.low(&Value::Formula(sum.clone()), (Face::Mono, SUM_PTS, ink))
}
