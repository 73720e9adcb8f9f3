//! Where a row of clippers stands, and how much room it wants.

use std::ops::Range;

use egui::{Pos2, Rect, Vec2, pos2, vec2};

use crate::figure::ClipperRow;

use super::super::slate::Slate;

/// As many clippers as a window has sides are shown wherever they are; more only if there is room.
const LEAST_SHOWN: usize = 4;
/// A row of more than this is hard to follow.
const MOST_SHOWN: usize = 6;
/// White space beside the row, and above and below it.
const MARGIN: Vec2 = vec2(4.0, 8.0);
/// Where there is room, a row grows to so many times its natural size.
pub const MOST_GROWN: f32 = 1.2;
/// White space in a box.
pub const PAD: Vec2 = vec2(7.0, 5.0);
/// The least length of an arrow, with room for a vertex and its name.
const LEAST_ARROW: f32 = 32.0;
/// The most: a row is read as one thing.
const MOST_ARROW: f32 = 96.0;
/// Heights of a name over its box, and of a line in it.
const NAME: f32 = 19.0;
pub const LINE: f32 = 15.5;
/// Size of names.
pub const NAME_SIZE: f32 = 13.0;
/// Room for F or S before a coordinate.
pub const LETTER: f32 = 14.0;
/// V at the left end; what comes out at the right end.
pub const ENDS: [f32; 2] = [16.0, 24.0];

/// Room for `(−1/3, 0.1235)`, or stacked for `0.1235`, after the letter.
const fn text_width(is_stacked: bool) -> f32 {
    if is_stacked { 48.0 } else { 96.0 }
}

fn box_size(is_stacked: bool) -> Vec2 {
    // Stacked, F and S are set apart.
    let [n_lines, apart] = if is_stacked { [4.0, 5.0] } else { [2.0, 0.0] };
    let width = LETTER + text_width(is_stacked);
    2.0 * PAD + vec2(width, n_lines * LINE + apart)
}

/// How much it wants at natural size, with coordinates stacked or not.
fn natural(is_stacked: bool) -> Vec2 {
    let n = LEAST_SHOWN as f32;
    let size = box_size(is_stacked);
    let ends = ENDS[0] + ENDS[1] + (n + 1.0) * LEAST_ARROW;
    2.0 * MARGIN + vec2(n * size.x + ends, NAME + size.y)
}

/// A coordinate stands below the other where they have no room beside each other, not even in text of plain size.
fn is_stacked(slate: &Slate<'_>, room: Vec2) -> bool {
    room.x < slate.scale.min(1.0) * natural(false).x
}

/// How much room it wants on a slate.
pub fn wanted(slate: &Slate<'_>, room: Vec2) -> Vec2 {
    natural(is_stacked(slate, room)) * slate.scale
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
    pub fn new(slate: &Slate<'_>, rect: Rect, row: &ClipperRow) -> Self {
        let is_stacked = is_stacked(slate, rect.size());
        let natural = box_size(is_stacked) * slate.scale;
        let [left, right] = ENDS.map(|end| slate.pts(end));
        let least = slate.pts(LEAST_ARROW);
        let margin = MARGIN * slate.scale;
        let room = rect.width() - 2.0 * margin.x - left - right;
        let fit = ((room - least) / (natural.x + least)).max(0.0) as usize;
        let shown = shown(row, fit.clamp(LEAST_SHOWN, MOST_SHOWN));
        let is_cut = shown.end < row.clippers.len();
        let room = if is_cut { room - left } else { room };
        let n = shown.len() as f32;
        let width = natural
            .x
            .min((room - (n + 1.0) * least) / n)
            .max(1.0)
            .floor();
        let arrow = ((room - n * width) / (n + 1.0)).min(slate.pts(MOST_ARROW));
        let spare = 0.5 * (room - n * width - (n + 1.0) * arrow);
        let x = rect.left() + margin.x + left + spare + arrow;
        let used = slate.pts(NAME) + natural.y;
        let y = rect.top() + (0.5 * (rect.height() - used)).min(2.0 * margin.y) + slate.pts(NAME);
        Self {
            shown,
            is_stacked,
            first: Rect::from_min_size(pos2(x, y).round(), vec2(width, natural.y.round())),
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
