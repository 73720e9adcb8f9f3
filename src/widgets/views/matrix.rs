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

use egui::{Align2, Color32, Painter, Pos2, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{MatrixProduct, MatrixRow},
    text::{Formula, Notation, Value},
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate, Style},
};

const NAME_PTS: f32 = 14.0;
const NOTE_PTS: f32 = 12.0;
const NUMBER_PTS: f32 = 15.0;
const SUM_PTS: f32 = 13.5;
/// From one row to the next, of the matrix and of what is written out.
const ROW: f32 = 27.0;
const SUM_ROW: f32 = 20.0;
/// Height of the name with the white space under it, and of the names of the spaces.
const OVER: f32 = 28.0;
const UNDER: f32 = 30.0;
/// Between columns of a matrix, between a bracket and what is in it, and between matrix, vector and result.
const BETWEEN: f32 = 16.0;
const WITHIN: f32 = 10.0;
const APART: f32 = 14.0;
/// How far a bracket reaches inwards.
const HOOK: f32 = 5.0;
/// At most so many times its natural size.
const MOST_GROWN: f32 = 1.25;
/// And of what that comes to at least this part: smaller numbers are not read any more.
const LEAST_PART: f32 = 0.34;

impl OnSlate for MatrixProduct {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let mut slate = Slate::with_numbers(painter, look, Notation::Decimals);
        slate.scale *= MOST_GROWN;
        let least = LEAST_PART * slate.scale;
        slate.shrunk_to(least, rect.size(), |slate| wanted(slate, self))
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
        for (nth, row) in self.rows.iter().enumerate() {
            let y = top + nth as f32 * slate.pts(ROW);
            let strip = Rect::from_min_size(
                pos2(rect.left(), y),
                vec2(columns.width().min(rect.width()), slate.pts(ROW)),
            );
            let is_lit = links.touch(strip, row.link) || row.is_current;
            if is_lit {
                lit(slate, strip, row.is_current);
            }
        }
        let corner = pos2(rect.left() + slate.pts(WITHIN), top);
        columns.draw(slate, corner, self);
        let bottom = top + self.rows.len() as f32 * slate.pts(ROW) + slate.pts(UNDER);
        let place = Rect::from_min_max(pos2(corner.x, bottom), rect.max);
        sums(slate, place, &self.rows);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let row = |row: &MatrixRow| {
            let arrow = if row.is_current { "→ " } else { "" };
            let sum = row.sum.as_ref()?;
            let sum = look.catalog.formula_as(sum, Notation::Decimals);
            Some(format!("{arrow}{sum}"))
        };
        let rows: Vec<String> = self.rows.iter().filter_map(row).collect();
        format!("{}: {}", look.catalog.value(&self.name), rows.join("; "))
    }
}

/// Its band: of the step's row with a bar before it.
fn lit(slate: &Slate<'_>, strip: Rect, is_current: bool) {
    let theme = slate.theme();
    slate.painter.rect_filled(strip, 0.0, theme.accent_wash);
    if is_current {
        let bar = strip.with_max_x(strip.left() + slate.pts(3.0));
        slate.painter.rect_filled(bar, 0.0, theme.accent);
    }
}

fn number_style(slate: &Slate<'_>, row: &MatrixRow, colour: Color32) -> Style {
    let soft = if row.is_current {
        colour
    } else {
        slate.theme().ink
    };
    (Face::Mono, NUMBER_PTS, soft)
}

/// How wide each column is.
struct Columns {
    /// Of the matrix.
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
            let width = |value: f64| number(slate, value, Color32::PLACEHOLDER).x;
            values.map(width).fold(slate.pts(14.0), f32::max)
        };
        let rows = &product.rows;
        let n = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
        let entries = (0..n)
            .map(|i| widest(&mut rows.iter().filter_map(|row| row.entries.get(i).copied())))
            .collect();
        let named = |name: &Value| name_of_space(slate, name).x - 2.0 * slate.pts(WITHIN);
        let operand = widest(&mut rows.iter().filter_map(|row| row.operand));
        let result = product.into.as_ref().map(|into| {
            let widest = widest(&mut rows.iter().filter_map(|row| row.result));
            // Room for numbers that have not come yet.
            widest.max(slate.pts(44.0)).max(named(into))
        });
        Self {
            entries,
            operand: operand.max(named(&product.from)),
            operator: product.operator.as_ref().map_or(0.0, |operator| {
                let style = (Face::Mono, NUMBER_PTS, Color32::PLACEHOLDER);
                slate.formula(operator, style).size().x
            }),
            result,
            between: slate.pts(BETWEEN),
            within: slate.pts(WITHIN),
            apart: slate.pts(APART),
        }
    }

    /// Of the matrix, between its brackets.
    fn matrix(&self) -> f32 {
        let gaps = self.entries.len().saturating_sub(1) as f32 * self.between;
        self.entries.iter().sum::<f32>() + gaps + 2.0 * self.within
    }

    fn width(&self) -> f32 {
        let matrix = match self.entries.len() {
            0 => 0.0,
            _ => self.matrix() + self.apart,
        };
        let operator = match self.operator {
            0.0 => 0.0,
            width => width + self.apart,
        };
        let result = self
            .result
            .map_or(0.0, |width| width + 2.0 * self.within + 3.0 * self.apart);
        matrix + self.operand + 2.0 * self.within + operator + result + 2.0 * self.within
    }

    fn draw(&self, slate: &mut Slate<'_>, corner: Pos2, product: &MatrixProduct) {
        let theme = slate.theme();
        let height = product.rows.len() as f32 * slate.pts(ROW);
        let middle = corner.y + 0.5 * height;
        let mut left = corner.x;
        if !self.entries.is_empty() {
            let mut right = left + self.within;
            for (i, width) in self.entries.iter().enumerate() {
                right += width;
                let entries = product.rows.iter().map(|row| row.entries.get(i).copied());
                column(
                    slate,
                    pos2(right, corner.y),
                    &product.rows,
                    entries,
                    |row, x| {
                        let is_zero = x == 0.0;
                        let ink = if row.is_current {
                            theme.ink
                        } else {
                            theme.soft
                        };
                        if is_zero { theme.faint } else { ink }
                    },
                );
                right += self.between;
            }
            brackets(slate, left, self.matrix(), [corner.y, height]);
            left += self.matrix() + self.apart;
        }
        let wide = self.operand + 2.0 * self.within;
        let operands = product.rows.iter().map(|row| row.operand);
        let right = left + self.within + self.operand;
        column(
            slate,
            pos2(right, corner.y),
            &product.rows,
            operands,
            |_, _| theme.ink,
        );
        brackets(slate, left, wide, [corner.y, height]);
        under(
            slate,
            pos2(left + 0.5 * wide, corner.y + height),
            &product.from,
        );
        left += wide;
        let style = (Face::Mono, NUMBER_PTS, theme.ink);
        if let Some(operator) = &product.operator {
            let operator = slate.formula(operator, style);
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
        let wide = result + 2.0 * self.within;
        let results = product.rows.iter().map(|row| row.result);
        let right = left + self.within + result;
        column(
            slate,
            pos2(right, corner.y),
            &product.rows,
            results,
            |row, _| {
                if row.is_current {
                    theme.signal_text
                } else {
                    theme.ink
                }
            },
        );
        brackets(slate, left, wide, [corner.y, height]);
        under(slate, pos2(left + 0.5 * wide, corner.y + height), into);
    }
}

/// Numbers over each other, flush right.
fn column(
    slate: &mut Slate<'_>,
    right_top: Pos2,
    rows: &[MatrixRow],
    numbers: impl Iterator<Item = Option<f64>>,
    colour: impl Fn(&MatrixRow, f64) -> Color32,
) {
    let height = slate.pts(ROW);
    for (nth, (row, value)) in rows.iter().zip(numbers).enumerate() {
        let Some(value) = value else { continue };
        let (_, size, ink) = number_style(slate, row, colour(row, value));
        let ink = if row.is_current {
            ink
        } else {
            colour(row, value)
        };
        let text = slate.value(&Value::Number(value), (Face::Mono, size, ink));
        let y = right_top.y + (nth as f32 + 0.5) * height;
        slate.put(&text, pos2(right_top.x, y), Align2::RIGHT_CENTER);
    }
}

fn number(slate: &Slate<'_>, value: f64, colour: Color32) -> Vec2 {
    let style = (Face::Mono, NUMBER_PTS, colour);
    slate.value(&Value::Number(value), style).size()
}

fn name_of_space(slate: &Slate<'_>, name: &Value) -> Vec2 {
    let style = (Face::Plain, NOTE_PTS, slate.theme().soft);
    slate.value(name, style).size()
}

/// Around a column of this width, from its left edge.
fn brackets(slate: &Slate<'_>, left: f32, width: f32, [top, height]: [f32; 2]) {
    let stroke = slate.stroke(1.5, slate.theme().soft);
    let hook = slate.pts(HOOK);
    for (x, inwards) in [(left, hook), (left + width, -hook)] {
        slate.painter.line(
            vec![
                pos2(x + inwards, top),
                pos2(x, top),
                pos2(x, top + height),
                pos2(x + inwards, top + height),
            ],
            stroke,
        );
    }
}

/// The name of a space, under its column.
fn under(slate: &mut Slate<'_>, at: Pos2, name: &Value) {
    let style = (Face::Plain, NOTE_PTS, slate.theme().soft);
    let text = slate.value(name, style);
    let at = at + vec2(0.0, slate.pts(5.0));
    slate.put(&text, at, Align2::CENTER_TOP);
}

fn written(slate: &Slate<'_>, row: &MatrixRow, sum: &Formula) -> crate::paint::Typeset {
    let theme = slate.theme();
    let colour = if row.is_current {
        theme.ink
    } else {
        theme.soft
    };
    slate.low(&Value::Formula(sum.clone()), (Face::Mono, SUM_PTS, colour))
}

/// How each known row was worked out; where there is no room for all, how the step's was.
fn sums(slate: &mut Slate<'_>, place: Rect, rows: &[MatrixRow]) {
    let height = slate.pts(SUM_ROW);
    let has_room = rows.len() as f32 * height <= place.height() + 1.0;
    let mut nth = 0;
    for row in rows {
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

/// All rows have their room from the start.
fn wanted(slate: &Slate<'_>, product: &MatrixProduct) -> Vec2 {
    let columns = Columns::new(slate, product);
    let rows = product.rows.len() as f32;
    let sums = product.rows.iter().filter_map(|row| {
        let sum = row.sum.as_ref()?;
        Some(written(slate, row, sum).size().x + slate.pts(WITHIN))
    });
    let width = sums.fold(columns.width(), f32::max);
    let height = OVER + rows * ROW + UNDER + rows * SUM_ROW;
    vec2(width, slate.pts(height))
}
