//! Where a row of clippers stands, and how much room it wants.

use std::ops::Range;

use egui::{Pos2, Rect, Vec2, pos2, vec2};

use crate::{figure::ClipperRow, paint::Theme};

/// As many clippers as a window has sides are shown wherever they are; more only if there is room.
const LEAST_SHOWN: usize = 4;
/// A row of more than this is hard to follow.
const MOST_SHOWN: usize = 6;
/// White space above and below the row.
const MARGIN_PTS: f32 = 10.0;
/// White space in a box.
pub const PAD: Vec2 = vec2(7.0, 5.0);
/// The least length of an arrow.
const LEAST_ARROW: f32 = 28.0;
/// The most, before the theme's factor: a row is read as one thing.
const MOST_ARROW: f32 = 96.0;

/// Height of the view in a column of this width.
#[must_use]
pub fn clipper_row_height(theme: &Theme, width: f32) -> f32 {
    let is_stacked = width < least_side_by_side(theme);
    (2.0 * MARGIN_PTS + name_height(theme) + box_height(theme, is_stacked)).round()
}

pub fn name_height(theme: &Theme) -> f32 {
    18.0 * theme.text_scale
}

pub fn line_height(theme: &Theme) -> f32 {
    14.5 * theme.text_scale
}

fn box_height(theme: &Theme, is_stacked: bool) -> f32 {
    // Stacked, F and S are set apart.
    let [n_lines, apart] = if is_stacked { [4.0, 5.0] } else { [2.0, 0.0] };
    2.0 * PAD.y + n_lines * line_height(theme) + apart
}

/// Room for `(−1/3, 0.1235)`, or stacked for `0.1235`, after the letter F.
fn box_width(theme: &Theme, is_stacked: bool) -> f32 {
    let text = if is_stacked { 56.0 } else { 108.0 };
    2.0 * PAD.x + text * theme.text_scale
}

/// What stands at both ends of the row.
pub fn end_widths(theme: &Theme) -> [f32; 2] {
    [14.0, 20.0].map(|width| width * theme.text_scale)
}

fn margin(width: f32) -> f32 {
    24.0_f32.min(0.04 * width)
}

/// The width from which on coordinates stand beside each other.
fn least_side_by_side(theme: &Theme) -> f32 {
    let [left, right] = end_widths(theme);
    let n = LEAST_SHOWN as f32;
    2.0 * 24.0 + left + right + n * box_width(theme, false) + (n + 1.0) * LEAST_ARROW
}

/// Where everything stands.
pub struct Plan {
    /// The clippers that are shown.
    pub shown: Range<usize>,
    /// Does a coordinate stand below the other?
    pub is_stacked: bool,
    /// The first box; the others follow at equal distances.
    pub first: Rect,
    /// The length of an arrow.
    pub arrow: f32,
    /// Are there more beyond the last one shown?
    pub is_cut: bool,
}

impl Plan {
    pub fn new(theme: &Theme, rect: Rect, row: &ClipperRow) -> Self {
        let is_stacked = rect.height() >= clipper_row_height(theme, 0.0);
        let [left, right] = end_widths(theme);
        let room = rect.width() - 2.0 * margin(rect.width()) - left - right;
        let natural = box_width(theme, is_stacked);
        let fit = ((room - LEAST_ARROW) / (natural + LEAST_ARROW)).max(0.0) as usize;
        let shown = shown(row, fit.clamp(LEAST_SHOWN, MOST_SHOWN));
        let is_cut = shown.end < row.clippers.len();
        let room = if is_cut { room - left } else { room };
        let n = shown.len() as f32;
        let least_arrows = (n + 1.0) * LEAST_ARROW;
        let width = natural.min((room - least_arrows) / n).max(1.0).floor();
        let arrow = ((room - n * width) / (n + 1.0)).min(MOST_ARROW * theme.text_scale);
        let spare = 0.5 * (room - n * width - (n + 1.0) * arrow);
        let x = rect.left() + margin(rect.width()) + left + spare + arrow;
        let height = box_height(theme, is_stacked);
        let used = name_height(theme) + height;
        let y = rect.top() + 0.5 * (rect.height() - used) + name_height(theme);
        Self {
            shown,
            is_stacked,
            first: Rect::from_min_size(pos2(x, y).round(), vec2(width, height.round())),
            arrow,
            is_cut,
        }
    }

    /// The `nth` of the boxes that are shown.
    pub fn place(&self, nth: usize) -> Rect {
        let x = nth as f32 * (self.first.width() + self.arrow);
        self.first.translate(vec2(x.round(), 0.0))
    }

    /// Both ends of the arrow into the `nth` box that is shown.
    pub fn arrow(&self, nth: usize) -> [Pos2; 2] {
        let head = self.place(nth).left_center();
        [head - vec2(self.arrow, 0.0), head]
    }
}

/// Of many clippers those about the one at work: `n` of them.
fn shown(row: &ClipperRow, n: usize) -> Range<usize> {
    let n_all = row.clippers.len();
    let last = n_all.saturating_sub(1);
    let on_its_way = row.travellers.first().map(|traveller| traveller.arrow);
    let is_done = row.clippers.iter().all(|clipper| clipper.is_closed);
    let about = row
        .at_work
        .or(on_its_way)
        .unwrap_or(if is_done { last } else { 0 });
    let n = n.min(n_all);
    let start = about.min(last).saturating_sub(n / 2).min(n_all - n);
    start..start + n
}
