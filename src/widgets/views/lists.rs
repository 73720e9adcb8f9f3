//! Vertex lists side by side, and what links them.
//!
//! ```text
//!      Subject list              Window list
//!     ┌►[  S₁  ]                  [  W₁  ]◄┐
//!     │ [○ C₁  ]- - - - - - - - - [○ C₁  ] │
//!     │ [● C₂  ]━━━━━━━━━━━━━━━━━►[● C₂  ] │
//!     └─[  S₂  ]                  [  W₂  ]─┘
//! ```

mod plan;

use std::f32::consts::PI;

use crate::figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists};

use super::{prelude::*, slate::cross};

use plan::{Column, LANE, LEGEND_GAP, MARKER, Plan, SIZE, SMALL_SIZE, Widths};

impl OnSlate for Lists {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        plan::fitted(natural, room, self)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let plan = Plan::new(slate, rect, self);
        for column in &plan.columns {
            titles(slate, column, rect.top());
            loops(slate, column);
            connectors(slate, column);
            entries(slate, column, links);
        }
        let is_taken = |link: &&ListLink| link.role == Role::Signal;
        for link in self.links.iter().filter(|link| !is_taken(link)) {
            // Both stand for the same: told where both are seen.
            if [link.from, link.to].into_iter().all(|end| plan.shows(end))
                && let Some(ends) = plan.ends(slate, link)
            {
                let stroke = slate.stroke(1.0, slate.theme().discarded);
                slate.dashed(ends, stroke, 3.5);
            }
        }
        for link in self.links.iter().filter(is_taken) {
            if let Some(ends) = plan.ends(slate, link) {
                slate.arrow(ends, slate.stroke(2.75, slate.theme().signal));
            }
        }
        legend(slate, self, pos2(rect.left(), plan.legend(slate)));
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let lists = self.lists.iter().map(|list| spoken(look, list));
        let name = |[list, entry]: [usize; 2]| {
            let list = self.lists.get(list)?;
            let entry = look.catalog.value(&list.entries.get(entry)?.name);
            Some(format!("{entry} ({})", look.catalog.value(&list.title)))
        };
        let taken = self.links.iter().filter(|link| link.role == Role::Signal);
        let taken = taken.filter_map(|link| {
            let (from, to) = (name(link.from)?, name(link.to)?);
            Some(format!("{from} → {to}"))
        });
        joined(lists.chain(taken), ". ")
    }
}

/// `Subject list: S₁, → C₁ (1/2), …`.
fn spoken(look: Look<'_>, list: &ListColumn) -> String {
    let entry = |entry: &ListRow| {
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
        let name = look.catalog.value(&entry.name);
        let arrow = now(entry.role == Role::Signal);
        format!("{arrow}{}", bracketed(&name, details))
    };
    let folded = |n: usize| (n > 0).then(|| look.catalog.message(&more(n)));
    let said = folded(list.n_before)
        .into_iter()
        .chain(list.entries.iter().map(entry))
        .chain(folded(list.n_after));
    let title = look.catalog.value(&list.title);
    format!("{title}: {}", joined(said, ", "))
}

fn legend(slate: &mut Slate<'_>, lists: &Lists, mut at: Pos2) {
    let rows = || lists.lists.iter().flat_map(|list| &list.entries);
    let is_drawn = |marker: ItemMarker| rows().any(|row| row.marker == Some(marker));
    for (marker, meaning) in lists.legend.iter().filter(|(marker, _)| is_drawn(*marker)) {
        let style = (Face::Plain, SMALL_SIZE, slate.theme().soft);
        let meaning = slate.low(meaning, style);
        let middle = at + vec2(slate.pts(0.3 * MARKER), 0.0);
        draw_marker(slate, middle, *marker, Role::Ink);
        at.x += slate.pts(MARKER);
        at.x = slate.put(&meaning, at, Align2::LEFT_CENTER).right() + slate.pts(LEGEND_GAP);
    }
}

fn titles(slate: &mut Slate<'_>, column: &Column<'_>, top: f32) {
    let list = column.list;
    let style = (Face::Strong, SIZE, slate.theme().ink);
    let title = slate.value(&list.title, style);
    let at = pos2(column.chips.center().x, top);
    slate.put(&title, at, Align2::CENTER_TOP);
    let ends = column.widths.columns(slate, column.chips.center().x);
    for (nth, (heading, [left, right])) in list.columns.iter().zip(ends).enumerate() {
        let entries = list.entries.iter();
        let mut details = entries.filter_map(|entry| entry.details.get(nth)?.as_ref());
        let (x, align) = if details.clone().any(is_flush_right) {
            (right, Align2::RIGHT_BOTTOM)
        } else {
            (left, Align2::LEFT_BOTTOM)
        };
        if details.next().is_some() {
            let style = (Face::Plain, SMALL_SIZE, slate.theme().soft);
            let heading = slate.low(heading, style);
            let at = pos2(x, column.chips.top() - slate.pts(3.0));
            slate.put(&heading, at, align);
        }
    }
}

/// Each ring leads back to its first entry in a thin loop on the outer side.
fn loops(slate: &mut Slate<'_>, column: &Column<'_>) {
    let list = column.list;
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
    let starts = list.breaks.iter().map(|at| at + list.n_before);
    let starts: Vec<usize> = std::iter::once(0)
        .chain(starts)
        .chain([plan::n_all(list)])
        .collect();
    for ring in starts.windows(2) {
        let ends = [ring[0], ring[1].saturating_sub(1)];
        let [top, bottom] = ends.map(|idx| column.place(idx).center().y);
        if bottom - top < 1.0 {
            continue;
        }
        let lane = edge + out * slate.pts(LANE - 4.0);
        let turn = |from: f32, to: f32| {
            // A quarter of a circle, as a polyline.
            [0.0, 1.0, 2.0, 3.0, 4.0].map(|nth| {
                let (sin, cos) = libm::sincosf(std::f32::consts::FRAC_PI_8 * nth);
                let x = lane - out * corner * (1.0 - sin);
                pos2(x, from + (to - from) * (1.0 - cos))
            })
        };
        let mut path = vec![pos2(edge, bottom)];
        path.extend(turn(bottom, bottom - corner));
        path.extend(turn(top, top + corner).into_iter().rev());
        path.push(pos2(edge + out * (head + 1.0), top));
        let strokes = path.windows(2).map(|ends| [ends[0], ends[1]]);
        slate.strokes.extend(strokes);
        slate.painter.add(Shape::line(path, stroke));
        slate.head(pos2(edge + out, top), vec2(-out, 0.0), head, colour);
    }
}

fn connectors(slate: &mut Slate<'_>, column: &Column<'_>) {
    let (theme, list) = (slate.theme(), column.list);
    for idx in column.fold.shown.clone().skip(1) {
        let nth = idx - list.n_before;
        if list.breaks.contains(&nth) {
            continue;
        }
        let [before, after] = [nth - 1, nth].map(|nth| list.entries[nth].role);
        let row = column.row_or_fold(idx);
        let [above, below] = [row - 1, row].map(|row| column.chip(row));
        let is_walked = before == Role::Accent && matches!(after, Role::Accent | Role::Signal);
        let (width, colour) = if is_walked {
            (2.5, theme.accent)
        } else {
            (1.0, theme.discarded)
        };
        let ends = [above.center_bottom(), below.center_top()];
        slate.line(ends, slate.stroke(width, colour));
    }
}

fn entries(slate: &mut Slate<'_>, column: &Column<'_>, links: &mut Links) {
    let list = column.list;
    if list.entries.is_empty() {
        no_chip(slate, column.chip(0));
    }
    for idx in column.fold.shown.clone() {
        let entry = &list.entries[idx - list.n_before];
        chip(slate, column.place(idx), &column.widths, entry, links);
    }
    let fold = &column.fold;
    let last = fold.n_rows().saturating_sub(1);
    for (count, row) in [(fold.before, 0), (fold.after, last)] {
        if count > 0 {
            let words = slate.more(count, SMALL_SIZE);
            slate.put(&words, column.chip(row).center(), Align2::CENTER_CENTER);
        }
    }
}

fn chip(slate: &mut Slate<'_>, place: Rect, widths: &Widths, entry: &ListRow, links: &mut Links) {
    let theme = slate.theme();
    let (width, border, face, ink) = match entry.role {
        Role::Signal => (1.75, theme.signal, Face::Strong, theme.signal_text),
        Role::Accent => (1.25, theme.accent, Face::Strong, theme.accent),
        Role::Accepted => (1.25, theme.accepted, Face::Strong, theme.ink),
        Role::Discarded => (1.0, theme.discarded, Face::Plain, theme.soft),
        Role::Ink => (0.0, Color32::TRANSPARENT, Face::Strong, theme.ink),
        Role::Soft => (0.0, Color32::TRANSPARENT, Face::Plain, theme.soft),
        Role::Faint => (1.0, theme.hairline, Face::Plain, theme.soft),
    };
    let fill = match entry.role {
        Role::Faint => theme.background,
        role => wash(theme, role),
    };
    let border = slate.stroke(width, border);
    let corner = slate.pts(3.0);
    if links.touch(place, entry.link) {
        slate.ring(place.expand(slate.pts(2.5)), corner, 1.25);
    }
    if entry.role == Role::Discarded {
        slate.dashed_box(place, border, 1.0);
    } else {
        let painter = slate.painter;
        painter.rect(place, corner, fill, border, StrokeKind::Inside);
    }
    let marker = widths.marker(slate);
    // What is said of the names stands under each other; a name alone stands in the middle.
    let left = place.center().x - 0.5 * widths.content(slate);
    let y = place.center().y;
    if let Some(kind) = entry.marker {
        let at = pos2(left + 0.3 * marker, y);
        draw_marker(slate, at, kind, entry.role);
    }
    let name = slate.value(&entry.name, (face, SIZE, ink));
    let is_alone = entry.marker.is_none() && widths.details.is_empty();
    let x = if is_alone {
        place.center().x
    } else {
        left + marker + 0.5 * widths.name
    };
    slate.put(&name, pos2(x, y), Align2::CENTER_CENTER);
    let soft = match entry.role {
        Role::Signal => ink,
        _ => slate.theme().soft,
    };
    let columns = widths.columns(slate, place.center().x);
    for ([left, right], detail) in columns.into_iter().zip(&entry.details) {
        let Some(detail) = detail else { continue };
        let (x, align) = if is_flush_right(detail) {
            (right, Align2::RIGHT_CENTER)
        } else {
            (left, Align2::LEFT_CENTER)
        };
        let detail = slate.low(detail, (Face::Plain, SMALL_SIZE, soft));
        slate.put(&detail, pos2(x, y), align);
    }
}

const fn is_flush_right(detail: &Value) -> bool {
    matches!(
        detail,
        Value::Number(_) | Value::Ratio { .. } | Value::Count(_)
    )
}

fn no_chip(slate: &mut Slate<'_>, place: Rect) {
    let stroke = slate.stroke(1.0, slate.theme().faint);
    slate.dashed_box(place, stroke, 1.0);
    let dash = slate.words("–", (Face::Plain, SIZE, slate.theme().soft));
    slate.put(&dash, place.center(), Align2::CENTER_CENTER);
}

fn draw_marker(slate: &Slate<'_>, at: Pos2, marker: ItemMarker, role: Role) {
    let theme = slate.theme();
    let colour = match role {
        Role::Ink | Role::Accent | Role::Signal | Role::Accepted => theme.ink,
        Role::Soft | Role::Faint | Role::Discarded => theme.soft,
    };
    let r = slate.pts(4.0);
    let stroke = slate.stroke(1.75, colour);
    let draw_cross = |r: f32| {
        for ends in cross(at, r) {
            slate.painter.line_segment(ends, stroke);
        }
    };
    match marker {
        ItemMarker::Dot => {
            slate.painter.circle_filled(at, r, colour);
        }
        ItemMarker::Ring => {
            slate.painter.circle(at, r, theme.background, stroke);
        }
        ItemMarker::HalfDot => {
            slate.painter.circle(at, r, theme.background, stroke);
            let half = (0..=16).map(|i| at - r * Vec2::angled((0.5 + i as f32 / 16.0) * PI));
            slate.area(half.collect(), colour);
        }
        ItemMarker::Cross => draw_cross(r),
        ItemMarker::CrossedRing => {
            slate.painter.circle(at, r, theme.background, stroke);
            draw_cross(0.65 * r);
        }
    }
}
