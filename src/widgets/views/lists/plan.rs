//! Where lists stand, and what of them.

use crate::figure::{ListColumn, ListLink, Lists};

use super::super::prelude::*;

const CHIPS: [f32; 2] = [22.0, 28.0];
/// From entry to entry: where there is room, they stand apart.
const STEPS: [f32; 2] = [26.0, 46.0];
const BETWEEN: f32 = 8.0;
const LEAST_CHIP_WIDTH: f32 = 57.0;
const PAD: f32 = 12.0;
pub const MARKER: f32 = 16.0;
pub const DETAIL_GAP: f32 = 10.0;
pub const LANE: f32 = 22.0;
const TITLE: f32 = 30.0;
const HEADING: f32 = 15.0;
const GAPS: [f32; 2] = [56.0, 36.0];
const MOST_GAP: f32 = 120.0;
/// Before text becomes smaller than this part of its plain size entries are folded, and details are left out.
const FOLD_BELOW: f32 = 0.82;
/// Of so few entries none is folded before a smaller part: what is folded away is soon what the step is about.
const FEW: usize = 8;
const FOLD_FEW_BELOW: f32 = 0.7;
const LEAST_ROWS: usize = 4;
const LEAST_DETAIL: f32 = 18.0;
/// Of titles and names; and of headings, details, the legend and what is folded.
pub const SIZE: f32 = 13.0;
pub const SMALL_SIZE: f32 = 12.0;
const LEGEND: f32 = 24.0;
pub const LEGEND_GAP: f32 = 20.0;

pub struct Widths {
    pub name: f32,
    pub details: Vec<f32>,
    pub has_markers: bool,
    chip: f32,
    folded: f32,
    title: f32,
}

impl Widths {
    fn new(slate: &Slate<'_>, list: &ListColumn, details: Vec<f32>) -> Self {
        let names = list.entries.iter();
        let names = names.map(|entry| slate.width(&entry.name, Face::Strong, SIZE));
        let folded = match n_all(list) {
            ..=LEAST_ROWS => 0.0,
            n_all => slate.more(n_all, SMALL_SIZE).size().x + slate.pts(4.0),
        };
        let mut widths = Self {
            name: names.fold(0.0, f32::max),
            details,
            has_markers: list.entries.iter().any(|entry| entry.marker.is_some()),
            chip: 0.0,
            folded,
            title: slate.width(&list.title, Face::Strong, SIZE),
        };
        widths.keep(slate, usize::MAX);
        widths
    }

    fn keep(&mut self, slate: &Slate<'_>, n_details: usize) {
        self.details.truncate(n_details);
        self.chip = (self.content(slate) + 2.0 * slate.pts(PAD))
            .max(slate.pts(LEAST_CHIP_WIDTH))
            .max(self.folded);
    }

    pub fn content(&self, slate: &Slate<'_>) -> f32 {
        let details: f32 = self.details.iter().sum();
        let gaps = self.details.len() as f32 * slate.pts(DETAIL_GAP);
        self.name + details + gaps + self.marker(slate)
    }

    pub fn marker(&self, slate: &Slate<'_>) -> f32 {
        slate.pts(if self.has_markers { MARKER } else { 0.0 })
    }

    pub fn columns(&self, slate: &Slate<'_>, centre: f32) -> Vec<[f32; 2]> {
        let mut left = centre - 0.5 * self.content(slate) + self.marker(slate) + self.name;
        let column = |width: &f32| {
            left += slate.pts(DETAIL_GAP);
            let ends = [left, left + width];
            left += width;
            ends
        };
        self.details.iter().map(column).collect()
    }
}

pub struct Column<'l> {
    pub list: &'l ListColumn,
    pub chips: Rect,
    pub fold: Fold,
    pub is_loop_left: bool,
    pub widths: Widths,
    step: f32,
}

impl Column<'_> {
    pub fn chip(&self, row: usize) -> Rect {
        self.chips.translate(vec2(0.0, row as f32 * self.step))
    }

    /// The row of an entry, or the one that stands for those that are folded with it.
    pub fn row_or_fold(&self, idx: usize) -> usize {
        let last = self.fold.n_rows().saturating_sub(1);
        match self.fold.row_of(idx) {
            Some(row) => row,
            None if idx < self.fold.shown.start => 0,
            None => last,
        }
    }

    pub fn place(&self, idx: usize) -> Rect {
        self.chip(self.row_or_fold(idx))
    }
}

pub struct Plan<'l> {
    pub columns: Vec<Column<'l>>,
}

impl<'l> Plan<'l> {
    pub fn new(slate: &Slate<'_>, rect: Rect, lists: &'l Lists) -> Self {
        let widths = fitted_widths(slate, lists, rect.width());
        let over = over(slate, lists);
        let room = rect.height() - over - under(slate, lists);
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
            let [lane, aside] = sides(slate, list, &widths);
            let [before, after] = if is_loop_left {
                [lane, aside]
            } else {
                [aside, lane]
            };
            let left = x + before;
            let top = rect.top() + over;
            let [low, high] = CHIPS.map(|height| slate.pts(height));
            let height = (step - slate.pts(BETWEEN)).clamp(low, high);
            let chips = vec2(widths.chip, height);
            x = left + widths.chip + after + gap;
            Column {
                list,
                chips: Rect::from_min_size(pos2(left, top).round(), chips),
                fold,
                is_loop_left,
                widths,
                step,
            }
        });
        let columns = columns.collect();
        Self { columns }
    }

    pub fn legend(&self, slate: &Slate<'_>) -> f32 {
        let bottoms = self.columns.iter().map(|column| {
            let last = column.fold.n_rows().saturating_sub(1);
            column.chip(last).bottom()
        });
        bottoms.fold(0.0, f32::max) + slate.pts(0.5 * LEGEND + 4.0)
    }

    pub fn shows(&self, [list, entry]: [usize; 2]) -> bool {
        let column = self.columns.get(list);
        column.is_some_and(|column| column.fold.shown.contains(&(entry + column.list.n_before)))
    }

    /// From the side of one entry, or of what stands for it, to the facing side of the other.
    pub fn ends(&self, slate: &Slate<'_>, link: &ListLink) -> Option<[Pos2; 2]> {
        let place = |[list, entry]: [usize; 2]| {
            let column = self.columns.get(list)?;
            Some(column.place(entry + column.list.n_before))
        };
        let (from, to) = (place(link.from)?, place(link.to)?);
        let off = vec2(slate.pts(3.0), 0.0);
        Some(if from.center().x <= to.center().x {
            [from.right_center() + off, to.left_center() - off]
        } else {
            [from.left_center() - off, to.right_center() + off]
        })
    }
}

/// Beside the chips: on the side of the loop, and on the other.
fn sides(slate: &Slate<'_>, list: &ListColumn, widths: &Widths) -> [f32; 2] {
    let lane = if list.is_ring { slate.pts(LANE) } else { 0.0 };
    let aside = (0.5 * (widths.title - widths.chip)).max(0.0);
    [lane.max(aside), aside]
}

pub const fn n_all(list: &ListColumn) -> usize {
    list.n_before + list.entries.len() + list.n_after
}

pub fn fitted<'a>(natural: Slate<'a>, room: Vec2, lists: &Lists) -> Slate<'a> {
    let n_rows = lists.lists.iter().map(|list| list.entries.len()).max();
    let n_rows = n_rows.unwrap_or(1).max(1);
    let is_few = n_rows <= FEW;
    let fold_below = if is_few { FOLD_FEW_BELOW } else { FOLD_BELOW };
    let details = details_of(natural.look, lists);
    natural.fitted_in(room, |slate| {
        let around = over(slate, lists) + under(slate, lists);
        let height = |n_rows: usize| around + slate.pts(STEPS[0]) * n_rows as f32;
        let is_large = slate.scale > fold_below;
        let is_folded = room.y / height(n_rows) * slate.scale < fold_below;
        let n_seen = match (is_folded, is_large) {
            (false, _) => n_rows,
            (true, false) => LEAST_ROWS.min(n_rows),
            (true, true) => {
                let room = room.y - around * fold_below / slate.scale;
                let fits = (room / (STEPS[0] * fold_below)) as usize;
                fits.clamp(LEAST_ROWS.min(n_rows), n_rows)
            }
        };
        let n_details = if is_large { usize::MAX } else { 0 };
        let widths = widths(slate, lists, &details, n_details);
        vec2(width(slate, lists, &widths), height(n_seen))
    })
}

fn over(slate: &Slate<'_>, lists: &Lists) -> f32 {
    let headings = lists.lists.iter().flat_map(|list| &list.columns);
    let mut headings = headings.map(|heading| slate.look.catalog.value(heading));
    let has_headings = headings.any(|heading| !heading.is_empty());
    slate.pts(if has_headings { TITLE + HEADING } else { TITLE })
}

fn under(slate: &Slate<'_>, lists: &Lists) -> f32 {
    slate.pts(if lists.legend.is_empty() { 0.0 } else { LEGEND })
}

fn fold(list: &ListColumn, n_fit: usize) -> Fold {
    let n_all = n_all(list);
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

fn fitted_widths(slate: &Slate<'_>, lists: &Lists, room: f32) -> Vec<Widths> {
    let details = details_of(slate.look, lists);
    let mut widths = widths(slate, lists, &details, usize::MAX);
    let n_all = widths.iter().map(|widths| widths.details.len()).max();
    for n in (0..n_all.unwrap_or(0)).rev() {
        if width(slate, lists, &widths) <= room {
            break;
        }
        for widths in &mut widths {
            widths.keep(slate, n);
        }
    }
    widths
}

fn gap(lists: &Lists) -> f32 {
    GAPS[usize::from(lists.links.is_empty())]
}

fn width(slate: &Slate<'_>, lists: &Lists, widths: &[Widths]) -> f32 {
    let columns = lists.lists.iter().zip(widths).map(|(list, widths)| {
        let [lane, aside] = sides(slate, list, widths);
        widths.chip + lane + aside
    });
    let n_gaps = lists.lists.len().saturating_sub(1) as f32;
    columns.sum::<f32>() + n_gaps * slate.pts(gap(lists))
}

/// The columns of details of each list, in words: said once, measured at every scale.
fn details_of(look: Look<'_>, lists: &Lists) -> Vec<Vec<Vec<String>>> {
    let said = |detail: &Value| look.catalog.value(detail);
    let of_list = |list: &ListColumn| {
        let n_own = list.entries.iter().map(|entry| entry.details.len()).max();
        let column = |nth: usize| {
            let entries = list.entries.iter();
            let details = entries.filter_map(|entry| entry.details.get(nth)?.as_ref());
            details.map(said).collect()
        };
        let n_columns = n_own.unwrap_or(0).max(list.columns.len());
        (0..n_columns).map(column).collect()
    };
    lists.lists.iter().map(of_list).collect()
}

fn widths(
    slate: &Slate<'_>,
    lists: &Lists,
    details: &[Vec<Vec<String>>],
    n_details: usize,
) -> Vec<Widths> {
    let style = |size: f32| (Face::Plain, size, slate.theme().ink);
    let widest = |column: &Vec<String>| {
        let widths = column.iter();
        let widths = widths.map(|words| slate.words(words, style(SMALL_SIZE)).size().x);
        widths.fold(slate.pts(LEAST_DETAIL), f32::max)
    };
    let of_list = |columns: &Vec<Vec<String>>| -> Vec<f32> {
        columns.iter().take(n_details).map(widest).collect()
    };
    let own: Vec<Vec<f32>> = details.iter().map(of_list).collect();
    // Columns with the same heading are as wide in every list, so that one that is still empty has its room.
    let detail = |i: usize, nth: usize| {
        let heading = lists.lists[i].columns.get(nth);
        let alike = lists.lists.iter().zip(&own).filter_map(|(of, own)| {
            let nth = of.columns.iter().position(|other| Some(other) == heading)?;
            own.get(nth).copied()
        });
        let widest = alike.fold(own[i][nth], f32::max);
        let heading = heading.map(|heading| slate.low(heading, style(SMALL_SIZE)).size().x);
        widest.max(heading.unwrap_or(0.0))
    };
    let widths = |(i, list): (usize, &ListColumn)| {
        let details = (0..own[i].len()).map(|nth| detail(i, nth));
        Widths::new(slate, list, details.collect())
    };
    lists.lists.iter().enumerate().map(widths).collect()
}
