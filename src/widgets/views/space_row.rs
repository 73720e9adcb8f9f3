//! Small pictures of several spaces in a row: each in its place, the one at work ringed, those to come pale.
//!
//! ```text
//!   model        world        view        clip          NDC        screen
//!   ┌──────┐    ┌──────┐    ┌──────┐    ╔══════╗    ┌──────┐    ┌──────┐
//!   │  ◳   │    │ ▱ ◳  │    │  ◳   │    ║  ◳   ║    │  ◳   │    │  ◳   │
//!   └──────┘    └──────┘    └──────┘    ╚══════╝    └──────┘    └──────┘
//!   (1, 1, 1)   (3.5, 3, 2) (3, 2, −5)
//!        world_from_model   view_from_world …
//! ```

use crate::figure::{Lens, SpaceCell, SpaceRow};

use super::{
    prelude::*,
    space::{picture_viewport, projected},
};

const NAME_PTS: f32 = 12.5;
const PLACE_PTS: f32 = 11.5;
const ARROW_PTS: f32 = 10.5;
const NAMES: f32 = 19.0;
const PLACES: f32 = 18.0;
const ARROWS: f32 = 16.0;
const GAP: f32 = 12.0;
const PALE: f32 = 0.4;

impl OnSlate for SpaceRow {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        natural.fitted_in(room, |slate| {
            let n = self.cells.len() as f32;
            let places = self.cells.iter().filter_map(|cell| cell.place.as_ref());
            let widest = places.map(|place| slate.width(place, Face::Mono, PLACE_PTS));
            let arrows = self.arrows.iter();
            let arrows = arrows.map(|name| slate.width(name, Face::Mono, ARROW_PTS));
            let arrows = arrows.map(|width| width + slate.pts(26.0));
            let widest = widest.chain(arrows).fold(slate.pts(80.0), f32::max);
            vec2(n * (widest + slate.pts(4.0)), slate.pts(90.0))
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let n = self.cells.len().max(1) as f32;
        let gap = slate.pts(GAP);
        let width = ((rect.width() - (n - 1.0) * gap) / n).floor();
        let [names, places, arrows] = [NAMES, PLACES, ARROWS].map(|pts| line(slate, pts));
        let taken = names + places + arrows;
        let height = (rect.height() - taken).max(8.0).min(0.72 * width).floor();
        let mut middles = Vec::new();
        // Where places have no room beside each other, the one at work is told.
        let widths = self.cells.iter().filter_map(|cell| cell.place.as_ref());
        let mut widths = widths.map(|at| slate.width(at, Face::Mono, PLACE_PTS));
        let has_room = widths.all(|at| at <= width + gap);
        for (nth, cell) in self.cells.iter().enumerate() {
            let left = (rect.left() + nth as f32 * (width + gap)).round();
            let corner = pos2(left, (rect.top() + names).round());
            let place = Rect::from_min_size(corner, vec2(width, height));
            draw_cell(slate, place, cell, links);
            if has_room || cell.stage == CellStage::Current {
                place_under(slate, (rect, place), cell);
            }
            middles.push(place.center().x);
        }
        let y = rect.top() + taken + height - 0.5 * arrows;
        for (nth, (name, ends)) in self.arrows.iter().zip(middles.windows(2)).enumerate() {
            arrow(slate, name, ends, y, self.at_work == Some(nth));
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let cell = |cell: &SpaceCell| {
            let arrow = now(cell.stage == CellStage::Current);
            let place = cell.place.iter();
            let place = place.map(|place| look.catalog.value(place));
            let name = std::iter::once(look.catalog.value(&cell.name));
            format!("{arrow}{}", joined(name.chain(place), " "))
        };
        joined(self.cells.iter().map(cell), "; ")
    }
}

fn arrow(slate: &mut Slate<'_>, name: &Value, ends: &[f32], y: f32, is_at_work: bool) {
    let theme = slate.theme();
    let (ink, text) = if is_at_work {
        (theme.signal, theme.signal_text)
    } else {
        (theme.faint, theme.soft)
    };
    let text = slate.value(name, (Face::Mono, ARROW_PTS, text));
    let middle = 0.5 * (ends[0] + ends[1]);
    let put = slate.put(&text, pos2(middle, y), Align2::CENTER_CENTER);
    let stroke = slate.stroke(1.0, ink);
    let aside = slate.pts(4.0);
    let [from, to] = [ends[0] + aside, ends[1] - aside];
    if put.left() - aside > from {
        slate.line([pos2(from, y), pos2(put.left() - aside, y)], stroke);
    }
    if to - put.right() > 2.0 * aside {
        slate.arrow([pos2(put.right() + aside, y), pos2(to, y)], stroke);
    }
}

fn draw_cell(slate: &mut Slate<'_>, place: Rect, cell: &SpaceCell, links: &mut Links) {
    let theme = slate.theme();
    let is_lit = links.touch(place, cell.link);
    let (face, ink) = look_of(theme, cell.stage);
    let name = slate.value(&cell.name, (face, NAME_PTS, ink));
    let above = place.left_top() - vec2(0.0, slate.pts(3.0));
    slate.put(&name, above, Align2::LEFT_BOTTOM);
    let mut painter = slate.painter.with_clip_rect(place);
    painter.rect_filled(place, 4.0, theme.panel);
    if cell.stage == CellStage::ToCome {
        painter.multiply_opacity(PALE);
    }
    let lens = Lens::from(cell.space.seer);
    let id = Id::unique(("space-row", place.left() as i32, place.top() as i32));
    let marks = projected(slate.painter.ctx(), id, &cell.space, &lens);
    let viewport = picture_viewport(place, &lens);
    let (look, around) = (slate.look, Around::default());
    look.stage(&painter, &viewport, &marks, None, around);
    let frame = match cell.stage {
        CellStage::Current => slate.stroke(2.0, theme.signal),
        CellStage::Done | CellStage::ToCome if is_lit => slate.stroke(1.5, theme.accent),
        CellStage::Done | CellStage::ToCome => Stroke::new(1.0, theme.hairline),
    };
    slate.rim(place, 4.0, frame, StrokeKind::Inside);
}

/// Under its cell, and within the row.
fn place_under(slate: &mut Slate<'_>, (row, cell_at): (Rect, Rect), cell: &SpaceCell) {
    let Some(at) = &cell.place else { return };
    let (_, ink) = look_of(slate.theme(), cell.stage);
    let at = slate.value(at, (Face::Mono, PLACE_PTS, ink));
    let under = cell_at.center_bottom() + vec2(0.0, slate.pts(3.0));
    let left = under.x - 0.5 * at.size().x;
    let left = left.min(row.right() - at.size().x).max(row.left());
    slate.put(&at, pos2(left, under.y), Align2::LEFT_TOP);
}

/// As high as it is at this scale, and as its text at least.
fn line(slate: &Slate<'_>, pts: f32) -> f32 {
    const LINE: f32 = 1.4;
    slate.pts(pts).max(LINE * slate.theme().least_text)
}

const fn look_of(theme: &Theme, stage: CellStage) -> (Face, Color32) {
    match stage {
        CellStage::Current => (Face::Strong, theme.ink),
        CellStage::Done => (Face::Plain, theme.ink),
        CellStage::ToCome => (Face::Plain, theme.soft),
    }
}
