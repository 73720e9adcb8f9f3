//! Vertex lists side by side, and what links them.
//!
//! ```text
//!      Subject list              Window list
//!     ┌►[  S₁  ]                  [  W₁  ]◄┐
//!     │ [○ C₁  ]- - - - - - - - - [○ C₁  ] │
//!     │ [● C₂  ]━━━━━━━━━━━━━━━━━►[● C₂  ] │
//!     └─[  S₂  ]                  [  W₂  ]─┘
//! ```

mod chip;
mod plan;

use egui::{Align2, Painter, Pos2, Rect, pos2, vec2};

use crate::figure::{ListColumn, ListLink, ListRow, Lists, Role};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate},
    table::more,
};

use chip::chip;
use plan::{
    Column, FOLD_SIZE, HEADING_SIZE, LANE, LEGEND_GAP, LEGEND_SIZE, MARKER, Plan, TITLE_SIZE,
};

impl OnSlate for Lists {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        plan::slate(painter, look, rect.size(), self)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let plan = Plan::new(slate, rect, self);
        for (list, column) in self.lists.iter().zip(&plan.columns) {
            title(slate, list, column, rect.top());
            loops(slate, list, column, &plan);
            connectors(slate, list, column, &plan);
            entries(slate, list, column, &plan, links);
        }
        let is_taken = |link: &&ListLink| link.role == Role::Signal;
        for link in self.links.iter().filter(|link| !is_taken(link)) {
            hairline(slate, self, &plan, link);
        }
        for link in self.links.iter().filter(is_taken) {
            taken(slate, self, &plan, link);
        }
        legend(slate, self, pos2(rect.left(), plan.legend(slate)));
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let mut parts: Vec<String> = self.lists.iter().map(|list| spoken(look, list)).collect();
        let taken = self.links.iter().filter(|link| link.role == Role::Signal);
        for link in taken {
            let name = |[list, entry]: [usize; 2]| {
                let list = self.lists.get(list)?;
                let entry = look.catalog.value(&list.entries.get(entry)?.name);
                Some(format!("{entry} ({})", look.catalog.value(&list.title)))
            };
            if let (Some(from), Some(to)) = (name(link.from), name(link.to)) {
                parts.push(format!("{from} → {to}"));
            }
        }
        parts.join(". ")
    }
}

/// `Subject list: S₁, → C₁ (1/2), …`.
fn spoken(look: Look<'_>, list: &ListColumn) -> String {
    let entry = |entry: &ListRow| {
        let arrow = if entry.role == Role::Signal {
            "→ "
        } else {
            ""
        };
        let name = look.catalog.value(&entry.name);
        let headings = list.columns.iter().map(Some).chain(std::iter::repeat(None));
        let details = entry.details.iter().zip(headings);
        let details = details.filter_map(|(detail, heading)| {
            let detail = look.catalog.value(detail.as_ref()?);
            let heading = heading.map(|heading| look.catalog.value(heading));
            Some(match heading.filter(|heading| !heading.is_empty()) {
                Some(heading) => format!("{heading} {detail}"),
                None => detail,
            })
        });
        let details: Vec<String> = details.collect();
        if details.is_empty() {
            format!("{arrow}{name}")
        } else {
            format!("{arrow}{name} ({})", details.join(", "))
        }
    };
    let folded = |n: usize| (n > 0).then(|| look.catalog.message(&more(n)));
    let said = folded(list.n_before)
        .into_iter()
        .chain(list.entries.iter().map(entry))
        .chain(folded(list.n_after));
    let said: Vec<String> = said.collect();
    format!("{}: {}", look.catalog.value(&list.title), said.join(", "))
}

/// What the marks mean, in a row.
fn legend(slate: &mut Slate<'_>, lists: &Lists, mut at: Pos2) {
    for (marker, meaning) in &lists.legend {
        let style = (Face::Plain, LEGEND_SIZE, slate.theme().soft);
        let meaning = slate.low(meaning, style);
        let middle = at + vec2(slate.pts(0.3 * MARKER), 0.0);
        chip::draw_marker(slate, middle, *marker, Role::Ink);
        at.x += slate.pts(MARKER);
        at.x = slate.put(&meaning, at, Align2::LEFT_CENTER).right() + slate.pts(LEGEND_GAP);
    }
}

fn title(slate: &mut Slate<'_>, list: &ListColumn, column: &Column, top: f32) {
    let style = (Face::Strong, TITLE_SIZE, slate.theme().ink);
    let title = slate.value(&list.title, style);
    let at = pos2(column.chips.center().x, top);
    slate.put(&title, at, Align2::CENTER_TOP);
    headings(slate, list, column);
}

/// What the columns of details are, over the first entry.
fn headings(slate: &mut Slate<'_>, list: &ListColumn, column: &Column) {
    let ends = column.widths.columns(slate, column.chips.center().x);
    for (nth, (heading, [left, right])) in list.columns.iter().zip(ends).enumerate() {
        let details = list
            .entries
            .iter()
            .filter_map(|entry| entry.details.get(nth)?.as_ref());
        let (x, align) = if details.clone().any(chip::is_flush_right) {
            (right, Align2::RIGHT_BOTTOM)
        } else {
            (left, Align2::LEFT_BOTTOM)
        };
        if details.count() > 0 {
            let style = (Face::Plain, HEADING_SIZE, slate.theme().soft);
            let heading = slate.low(heading, style);
            let at = pos2(x, column.chips.top() - slate.pts(3.0));
            slate.put(&heading, at, align);
        }
    }
}

/// Each ring leads back to its first entry in a thin loop on the outer side.
fn loops(slate: &mut Slate<'_>, list: &ListColumn, column: &Column, plan: &Plan) {
    if !list.is_ring {
        return;
    }
    let colour = slate.theme().discarded;
    let stroke = slate.stroke(1.0, colour);
    let (edge, out) = if column.is_loop_left {
        (column.chips.left(), -1.0)
    } else {
        (column.chips.right(), 1.0)
    };
    let [corner, head] = [5.0, 7.0].map(|length| slate.pts(length));
    let n_all = list.n_before + list.entries.len() + list.n_after;
    let starts = list.breaks.iter().map(|at| at + list.n_before);
    let starts: Vec<usize> = std::iter::once(0).chain(starts).chain([n_all]).collect();
    for ring in starts.windows(2) {
        let rows = [ring[0], ring[1].saturating_sub(1)].map(|idx| column.row_or_fold(idx));
        let [top, bottom] = rows.map(|row| plan.chip(column, row).center().y);
        if bottom - top < 1.0 {
            continue;
        }
        let lane = edge + out * slate.pts(LANE - 4.0);
        let turn = |from: f32, to: f32| {
            // A quarter of a circle, as a polyline.
            let at = |nth: usize| {
                let (sin, cos) = libm::sincosf(std::f32::consts::FRAC_PI_8 * nth as f32);
                pos2(
                    lane - out * corner * (1.0 - sin),
                    from + (to - from) * (1.0 - cos),
                )
            };
            [0, 1, 2, 3, 4].map(at)
        };
        let mut path = vec![pos2(edge, bottom)];
        path.extend(turn(bottom, bottom - corner));
        path.extend(turn(top, top + corner).into_iter().rev());
        path.push(pos2(edge + out * (head + 1.0), top));
        slate
            .strokes
            .extend(path.windows(2).map(|ends| [ends[0], ends[1]]));
        slate.painter.add(egui::Shape::line(path, stroke));
        slate.head(pos2(edge + out, top), vec2(-out, 0.0), head, colour);
    }
}

/// Short strokes from entry to entry: thick where the walk has gone.
fn connectors(slate: &mut Slate<'_>, list: &ListColumn, column: &Column, plan: &Plan) {
    let theme = slate.theme();
    for idx in column.fold.shown.clone().skip(1) {
        let nth = idx - list.n_before;
        if list.breaks.contains(&nth) {
            continue;
        }
        let [before, after] = [nth - 1, nth].map(|nth| list.entries[nth].role);
        let row = column.row_or_fold(idx);
        let [above, below] = [row - 1, row].map(|row| plan.chip(column, row));
        let is_walked = before == Role::Accent && matches!(after, Role::Accent | Role::Signal);
        let stroke = if is_walked {
            slate.stroke(2.5, theme.accent)
        } else {
            slate.stroke(1.0, theme.discarded)
        };
        slate.line([above.center_bottom(), below.center_top()], stroke);
    }
}

fn entries(
    slate: &mut Slate<'_>,
    list: &ListColumn,
    column: &Column,
    plan: &Plan,
    links: &mut Links,
) {
    if list.entries.is_empty() {
        chip::none(slate, plan.chip(column, 0));
    }
    for idx in column.fold.shown.clone() {
        let place = plan.chip(column, column.row_or_fold(idx));
        let entry = &list.entries[idx - list.n_before];
        chip(slate, place, &column.widths, entry, links);
    }
    let fold = &column.fold;
    let last = fold.n_rows().saturating_sub(1);
    for (count, row) in [(fold.before, 0), (fold.after, last)] {
        if count > 0 {
            let words = slate.look.catalog.message(&more(count));
            let words = slate.words(words, (Face::Plain, FOLD_SIZE, slate.theme().soft));
            let at = plan.chip(column, row).center();
            slate.put(&words, at, Align2::CENTER_CENTER);
        }
    }
}

/// Both stand for the same: told where both are seen.
fn hairline(slate: &mut Slate<'_>, lists: &Lists, plan: &Plan, link: &ListLink) {
    let is_shown = |[list, entry]: [usize; 2]| {
        let column = plan.columns.get(list);
        column.is_some_and(|column| {
            column
                .fold
                .shown
                .contains(&(entry + lists.lists[list].n_before))
        })
    };
    if is_shown(link.from)
        && is_shown(link.to)
        && let Some(ends) = ends(slate, lists, plan, link)
    {
        let stroke = slate.stroke(1.0, slate.theme().discarded);
        slate.dashed(ends, stroke, 3.5);
    }
}

/// The one that is taken now.
fn taken(slate: &mut Slate<'_>, lists: &Lists, plan: &Plan, link: &ListLink) {
    if let Some(ends) = ends(slate, lists, plan, link) {
        let stroke = slate.stroke(2.75, slate.theme().signal);
        slate.arrow(ends, stroke);
    }
}

/// From the side of one entry, or of what stands for it, to the facing side of the other.
fn ends(slate: &Slate<'_>, lists: &Lists, plan: &Plan, link: &ListLink) -> Option<[Pos2; 2]> {
    let place = |[list, entry]: [usize; 2]| {
        let column = plan.columns.get(list)?;
        let idx = entry + lists.lists[list].n_before;
        Some(plan.chip(column, column.row_or_fold(idx)))
    };
    let (from, to) = (place(link.from)?, place(link.to)?);
    let off = vec2(slate.pts(3.0), 0.0);
    Some(if from.center().x <= to.center().x {
        [from.right_center() + off, to.left_center() - off]
    } else {
        [from.left_center() - off, to.right_center() + off]
    })
}
