//! Where lists stand, and what of them.

use egui::{Painter, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{ListColumn, ListRow, Lists},
    text::Notation,
};

use super::super::super::look::Look;
use super::super::{
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
/// The titles' height with the white space under them, and the height of the headings under them.
const TITLE: f32 = 30.0;
const HEADING: f32 = 15.0;
/// Between two lists: with links from one to the other, and without.
const GAPS: [f32; 2] = [56.0, 36.0];
/// How far apart lists may stand where there is room.
const MOST_GAP: f32 = 120.0;
/// Where there is much room, lists grow to so many times their natural size.
const MOST_GROWN: f32 = 1.2;
/// Entries are folded before text becomes smaller than this part of its size in a theme of plain size, and details are
/// left out.
const FOLD_BELOW: f32 = 0.82;
/// Of so few entries none is folded before their text becomes smaller than this part: what is folded away is soon what the
/// step is about.
const FEW: usize = 8;
const FOLD_FEW_BELOW: f32 = 0.7;
/// So many rows at least stand in a list that is folded.
const LEAST_ROWS: usize = 4;
/// A column of details is no narrower.
const LEAST_DETAIL: f32 = 18.0;
pub const TITLE_SIZE: f32 = 13.0;
pub const NAME_SIZE: f32 = 13.0;
pub const FOLD_SIZE: f32 = 12.0;
pub const DETAIL_SIZE: f32 = 12.0;
pub const HEADING_SIZE: f32 = 12.0;
pub const LEGEND_SIZE: f32 = 12.0;
/// The legend's height, with the white space over it, and the white space between two marks of it.
const LEGEND: f32 = 24.0;
pub const LEGEND_GAP: f32 = 20.0;

/// Widths of what stands in the chips of a list.
pub struct Widths {
    /// The widest name.
    pub name: f32,
    /// Of the columns of details that are shown.
    pub details: Vec<f32>,
    /// Is there a marker before any name?
    pub has_markers: bool,
    chip: f32,
    /// Of what may have to stand in the place of a chip.
    folded: f32,
    title: f32,
}

impl Widths {
    /// Keeps the first columns of details, and settles how wide the chips are.
    fn keep(&mut self, slate: &Slate<'_>, n_details: usize) {
        self.details.truncate(n_details);
        self.chip = (self.content(slate) + 2.0 * slate.pts(PAD))
            .max(slate.pts(LEAST_CHIP_WIDTH))
            .max(self.folded);
    }

    /// Of the name and all that stands beside it.
    pub fn content(&self, slate: &Slate<'_>) -> f32 {
        let details: f32 = self.details.iter().sum();
        let gaps = self.details.len() as f32 * slate.pts(DETAIL_GAP);
        self.name + details + gaps + self.marker(slate)
    }

    /// Of the marker with the white space after it.
    pub fn marker(&self, slate: &Slate<'_>) -> f32 {
        if self.has_markers {
            slate.pts(MARKER)
        } else {
            0.0
        }
    }

    /// Left and right ends of the columns of details, in a chip about this place.
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
        let widths = fitted(slate, lists, rect.width());
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
            let lane = if list.is_ring { slate.pts(LANE) } else { 0.0 };
            let aside = (0.5 * (widths.title - widths.chip)).max(0.0);
            let left = x + if is_loop_left { lane.max(aside) } else { aside };
            let top = rect.top() + over;
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

    /// The middle of the legend, in height.
    pub fn legend(&self, slate: &Slate<'_>) -> f32 {
        let bottoms = self.columns.iter().map(|column| {
            let last = column.fold.n_rows().saturating_sub(1);
            self.chip(column, last).bottom()
        });
        bottoms.fold(0.0, f32::max) + slate.pts(0.5 * LEGEND + 4.0)
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
    let fold_below = if n_rows > FEW {
        FOLD_BELOW
    } else {
        FOLD_FEW_BELOW
    };
    let said = Said::new(look, lists);
    Slate::grown(painter, look, room, MOST_GROWN, |slate| {
        let around = over(slate, lists) + under(slate, lists);
        let height = |n_rows: usize| around + slate.pts(STEPS[0]) * n_rows as f32;
        let is_folded = room.y / height(n_rows) * slate.scale < fold_below;
        // Folded, as many rows are seen as there is room for.
        let least = if is_folded {
            LEAST_ROWS.min(n_rows)
        } else {
            n_rows
        };
        let height = if is_folded && slate.scale > fold_below {
            let fits = (room.y - around * fold_below / slate.scale) / (STEPS[0] * fold_below);
            height((fits as usize).clamp(least, n_rows))
        } else {
            height(least)
        };
        let n_details = if slate.scale > fold_below {
            usize::MAX
        } else {
            0
        };
        let widths = said.widths(slate, n_details);
        vec2(width(slate, lists, &widths), height)
    })
    .writing(notation(lists))
}

/// What is said of names stands under each other, and is compared.
pub fn notation(lists: &Lists) -> Notation {
    let entries = lists.lists.iter().flat_map(|list| &list.entries);
    Notation::of(entries.flat_map(|entry| entry.details.iter().flatten()))
}

/// The titles, with the headings of the details under them.
fn over(slate: &Slate<'_>, lists: &Lists) -> f32 {
    let headings = lists.lists.iter().flat_map(|list| &list.columns);
    let has_headings = headings
        .map(|heading| slate.look.catalog.value(heading))
        .any(|heading| !heading.is_empty());
    slate.pts(if has_headings { TITLE + HEADING } else { TITLE })
}

/// The legend.
fn under(slate: &Slate<'_>, lists: &Lists) -> f32 {
    slate.pts(if lists.legend.is_empty() { 0.0 } else { LEGEND })
}

fn fold(list: &ListColumn, n_fit: usize) -> Fold {
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

/// With as many columns of details as there is room for at this scale.
fn fitted(slate: &Slate<'_>, lists: &Lists, room: f32) -> Vec<Widths> {
    let mut widths = Said::new(slate.look, lists).widths(slate, usize::MAX);
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

/// What is in the chips: said once, measured at every scale.
struct Said<'a> {
    lists: &'a Lists,
    /// Of each list the columns of details, in words.
    details: Vec<Vec<Vec<String>>>,
}

impl<'a> Said<'a> {
    fn new(look: Look<'_>, lists: &'a Lists) -> Self {
        let notation = notation(lists);
        let details = lists.lists.iter().map(|list| {
            let n_own = list.entries.iter().map(|entry| entry.details.len()).max();
            let column = |nth: usize| {
                let entries = list.entries.iter();
                let details = entries.filter_map(|entry| entry.details.get(nth)?.as_ref());
                details
                    .map(|detail| look.catalog.value_as(detail, notation))
                    .collect()
            };
            let n_columns = n_own.unwrap_or(0).max(list.columns.len());
            (0..n_columns).map(column).collect()
        });
        Self {
            lists,
            details: details.collect(),
        }
    }

    /// With so many columns of details at most.
    fn widths(&self, slate: &Slate<'_>, n_details: usize) -> Vec<Widths> {
        let style = (Face::Plain, DETAIL_SIZE, slate.theme().ink);
        let widest = |column: &Vec<String>| {
            let widths = column
                .iter()
                .map(|words| slate.words(words, style).size().x);
            widths.fold(slate.pts(LEAST_DETAIL), f32::max)
        };
        let of_list = |columns: &Vec<Vec<String>>| -> Vec<f32> {
            columns.iter().take(n_details).map(widest).collect()
        };
        let own: Vec<Vec<f32>> = self.details.iter().map(of_list).collect();
        let lists = self.lists.lists.iter().enumerate();
        lists
            .map(|(i, list)| {
                let details = (0..own[i].len()).map(|nth| self.detail(slate, &own, [i, nth]));
                widths_of(slate, list, details.collect())
            })
            .collect()
    }

    /// Columns with the same heading are as wide in every list, so that one that is still empty has its room.
    fn detail(&self, slate: &Slate<'_>, own: &[Vec<f32>], [i, nth]: [usize; 2]) -> f32 {
        let heading = self.lists.lists[i].columns.get(nth);
        let alike = self.lists.lists.iter().zip(own).filter_map(|(of, own)| {
            let nth = of.columns.iter().position(|other| Some(other) == heading)?;
            own.get(nth).copied()
        });
        let widest = alike.fold(own[i][nth], f32::max);
        let style = (Face::Plain, HEADING_SIZE, slate.theme().ink);
        let heading = heading.map_or(0.0, |heading| slate.low(heading, style).size().x);
        widest.max(heading)
    }
}

fn widths_of(slate: &Slate<'_>, list: &ListColumn, details: Vec<f32>) -> Widths {
    let ink = slate.theme().ink;
    let name = |entry: &ListRow| {
        let style = (Face::Strong, NAME_SIZE, ink);
        slate.value(&entry.name, style).size().x
    };
    let entries = list.entries.iter();
    let title = (Face::Strong, TITLE_SIZE, ink);
    let mut widths = Widths {
        name: entries.clone().map(name).fold(0.0, f32::max),
        details,
        has_markers: entries.clone().any(|entry| entry.marker.is_some()),
        chip: 0.0,
        folded: folded_width(slate, list),
        title: slate.value(&list.title, title).size().x,
    };
    widths.keep(slate, usize::MAX);
    widths
}

/// What may have to stand in the place of a chip: how many are folded.
fn folded_width(slate: &Slate<'_>, list: &ListColumn) -> f32 {
    let n_all = list.n_before + list.entries.len() + list.n_after;
    if n_all <= LEAST_ROWS {
        return 0.0;
    }
    let words = slate.look.catalog.message(&more(n_all));
    let words = slate.words(words, (Face::Plain, FOLD_SIZE, slate.theme().soft));
    words.size().x + slate.pts(4.0)
}
