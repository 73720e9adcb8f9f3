//! Where lists stand, and what of them.

use egui::{Painter, Rect, Vec2, pos2, vec2};

use crate::figure::{List, ListEntry, Lists};

use super::super::{
    super::Look,
    fold::Fold,
    slate::{Face, Slate},
    table::more,
};

/// A chip's height, and the least and the most from one to the next.
const CHIP: f32 = 22.0;
const STEPS: [f32; 2] = [26.0, 30.0];
const LEAST_CHIP_WIDTH: f32 = 57.0;
/// White space in a chip, beside its text.
const PAD: f32 = 12.0;
/// Room for the marker before a name, and between a name and what is said of it.
pub const MARKER: f32 = 16.0;
pub const DETAIL_GAP: f32 = 10.0;
/// Room for a loop beside a list.
pub const LANE: f32 = 22.0;
/// The titles' height with the white space under them.
const TITLE: f32 = 30.0;
/// Between two lists: with links from one to the other, and without.
const GAPS: [f32; 2] = [84.0, 36.0];
/// How far apart lists may stand where there is room.
const MOST_GAP: f32 = 160.0;
/// Rows that are shown before text becomes smaller than [`FOLD_BELOW`].
const LEAST_ROWS: usize = 6;
const FOLD_BELOW: f32 = 0.85;
pub const TITLE_SIZE: f32 = 13.0;
pub const NAME_SIZE: f32 = 13.0;
pub const FOLD_SIZE: f32 = 12.0;
pub const DETAIL_SIZE: f32 = 12.0;

/// Widths of what stands in the chips of a list.
pub struct Widths {
    /// The widest name.
    pub name: f32,
    /// Of the columns of details that are shown.
    pub details: Vec<f32>,
    /// Is there a marker before any name?
    pub has_markers: bool,
    chip: f32,
    title: f32,
}

/// A list's place.
pub struct Column {
    /// The first chip at its top, wide as all of them.
    pub chips: Rect,
    /// Which entries are shown, counted from the first of all.
    pub fold: Fold,
    /// Is its loop to its left?
    pub is_loop_left: bool,
    /// What its chips have room for.
    pub widths: Widths,
}

impl Column {
    /// The row of an entry, or the one that stands for those that are folded with it.
    pub fn row_or_fold(&self, idx: usize) -> usize {
        let last = self.fold.n_rows().saturating_sub(1);
        match self.fold.row_of(idx) {
            Some(row) => row,
            None if idx < self.fold.shown.start => 0,
            None => last,
        }
    }
}

/// Where everything stands.
pub struct Plan {
    /// One a list.
    pub columns: Vec<Column>,
    step: f32,
}

impl Plan {
    pub fn new(slate: &Slate<'_>, rect: Rect, lists: &Lists) -> Self {
        let n_details = n_details(slate, lists, rect.width());
        let widths: Vec<Widths> = widths(slate, lists, n_details);
        let room = rect.height() - slate.pts(TITLE);
        let n_fit = ((room / slate.pts(STEPS[0]) + 0.2) as usize).max(3);
        let folds: Vec<Fold> = lists.lists.iter().map(|list| fold(list, n_fit)).collect();
        let n_rows = folds.iter().map(Fold::n_rows).max().unwrap_or(1).max(1);
        let [least, most] = STEPS.map(|step| slate.pts(step));
        let step = (room / n_rows as f32).clamp(least, most).floor();
        let spare = rect.width() - width(slate, lists, &widths);
        let n_gaps = lists.lists.len().saturating_sub(1).max(1) as f32;
        let gap = slate.pts(gap(lists));
        let gap = gap + (spare / n_gaps).clamp(0.0, (slate.pts(MOST_GAP) - gap).max(0.0));
        let mut x = rect.left();
        let last = lists.lists.len().saturating_sub(1);
        let columns = lists.lists.iter().zip(widths).zip(folds).enumerate();
        let columns = columns.map(|(nth, ((list, widths), fold))| {
            let is_loop_left = nth == 0 && last > 0;
            let lane = if list.is_ring { slate.pts(LANE) } else { 0.0 };
            let aside = (0.5 * (widths.title - widths.chip)).max(0.0);
            let left = x + if is_loop_left { lane.max(aside) } else { aside };
            let top = rect.top() + slate.pts(TITLE);
            let chips = vec2(widths.chip, slate.pts(CHIP));
            let right = left + widths.chip + if is_loop_left { aside } else { lane.max(aside) };
            x = right + gap;
            Column {
                chips: Rect::from_min_size(pos2(left, top).round(), chips),
                fold,
                is_loop_left,
                widths,
            }
        });
        Self {
            columns: columns.collect(),
            step,
        }
    }

    /// The chip in a row.
    pub fn chip(&self, column: &Column, row: usize) -> Rect {
        column.chips.translate(vec2(0.0, row as f32 * self.step))
    }
}

/// As large as the room lets it be: entries are folded before their text becomes too small.
pub fn slate<'a>(painter: &'a Painter, look: Look<'a>, room: Vec2, lists: &Lists) -> Slate<'a> {
    let n_rows = lists.lists.iter().map(|list| list.entries.len()).max();
    let n_rows = n_rows.unwrap_or(1).max(1);
    Slate::fitted(painter, look, room, |slate| {
        let height = |n_rows: usize| slate.pts(TITLE + STEPS[0] * n_rows as f32);
        let would_be = room.y / height(n_rows) * slate.scale;
        let folds = would_be < FOLD_BELOW * look.theme.text_scale;
        let n_rows = if folds {
            LEAST_ROWS.min(n_rows)
        } else {
            n_rows
        };
        let widths = widths(slate, lists, 0);
        vec2(width(slate, lists, &widths), height(n_rows))
    })
}

fn fold(list: &List, n_fit: usize) -> Fold {
    let n_all = list.n_before + list.entries.len() + list.n_after;
    let focus = list.focus.unwrap_or(0) + list.n_before;
    let mut fold = Fold::about(n_all, Some(focus), n_fit);
    // Only those that are given can be shown.
    let end = list.n_before + list.entries.len();
    let start = fold.shown.start.clamp(list.n_before, end);
    fold.shown = start..fold.shown.end.clamp(start, end);
    fold.before = fold.shown.start;
    fold.after = n_all - fold.shown.end;
    fold
}

/// As many columns of details are shown as there is room for at this scale.
fn n_details(slate: &Slate<'_>, lists: &Lists, room: f32) -> usize {
    let entries = lists.lists.iter().flat_map(|list| &list.entries);
    let n_all = entries.map(|entry| entry.details.len()).max().unwrap_or(0);
    let fits = |n: &usize| width(slate, lists, &widths(slate, lists, *n)) <= room;
    (0..=n_all).rev().find(fits).unwrap_or(0)
}

fn gap(lists: &Lists) -> f32 {
    let [linked, apart] = GAPS;
    if lists.links.is_empty() {
        apart
    } else {
        linked
    }
}

fn width(slate: &Slate<'_>, lists: &Lists, widths: &[Widths]) -> f32 {
    let columns = lists.lists.iter().zip(widths).map(|(list, widths)| {
        let lane = if list.is_ring { slate.pts(LANE) } else { 0.0 };
        let aside = (0.5 * (widths.title - widths.chip)).max(0.0);
        widths.chip + lane.max(aside) + aside
    });
    let n_gaps = lists.lists.len().saturating_sub(1) as f32;
    columns.sum::<f32>() + n_gaps * slate.pts(gap(lists))
}

fn widths(slate: &Slate<'_>, lists: &Lists, n_details: usize) -> Vec<Widths> {
    let lists = lists.lists.iter();
    lists
        .map(|list| widths_of(slate, list, n_details))
        .collect()
}

fn widths_of(slate: &Slate<'_>, list: &List, n_details: usize) -> Widths {
    let ink = slate.theme().ink;
    let name = |entry: &ListEntry| {
        let style = (Face::Strong, NAME_SIZE, ink);
        slate.value(&entry.name, style).size().x
    };
    let entries = list.entries.iter();
    let name = entries.clone().map(name).fold(0.0, f32::max);
    let detail = |nth: usize| {
        let set = |entry: &ListEntry| {
            let detail = entry.details.get(nth)?.as_ref()?;
            Some(slate.low(detail, (Face::Plain, DETAIL_SIZE, ink)).size().x)
        };
        entries.clone().filter_map(set).reduce(f32::max)
    };
    let n_own = entries
        .clone()
        .map(|entry| entry.details.len())
        .max()
        .unwrap_or(0);
    let details = (0..n_details.min(n_own)).map(|nth| detail(nth).unwrap_or(0.0));
    let details: Vec<f32> = details.collect();
    let gaps = details.len() as f32 * slate.pts(DETAIL_GAP);
    let has_markers = entries.clone().any(|entry| entry.marker.is_some());
    let text = name + details.iter().sum::<f32>() + gaps;
    let marker = if has_markers { slate.pts(MARKER) } else { 0.0 };
    let folded = folded_width(slate, list);
    let title = (Face::Strong, TITLE_SIZE, ink);
    Widths {
        name,
        details,
        has_markers,
        chip: (text + marker + 2.0 * slate.pts(PAD))
            .max(slate.pts(LEAST_CHIP_WIDTH))
            .max(folded),
        title: slate.value(&list.title, title).size().x,
    }
}

/// What may have to stand in the place of a chip: how many are folded.
fn folded_width(slate: &Slate<'_>, list: &List) -> f32 {
    let n_all = list.n_before + list.entries.len() + list.n_after;
    if n_all <= LEAST_ROWS {
        return 0.0;
    }
    let words = slate.look.catalog.message(&more(n_all));
    let words = slate.words(words, (Face::Plain, FOLD_SIZE, slate.theme().soft));
    words.size().x + slate.pts(4.0)
}
