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

use egui::{Align2, Painter, Rect, Stroke, StrokeKind, pos2, vec2};

use crate::{
    figure::{CellStage, Lens, SpaceCell, SpaceRow},
    paint::{self, Around},
    text::Notation,
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate},
    space::{picture_viewport, projected},
};

const NAME_PTS: f32 = 12.5;
const PLACE_PTS: f32 = 11.5;
const ARROW_PTS: f32 = 10.5;
/// Height of the names, of the places, and of the arrows with what they are called.
const NAMES: f32 = 19.0;
const PLACES: f32 = 18.0;
const ARROWS: f32 = 16.0;
/// Between one picture and the next.
const GAP: f32 = 12.0;
/// Of what is still to come so much is seen.
const PALE: f32 = 0.4;

impl OnSlate for SpaceRow {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let slate = Slate::with_numbers(painter, look, Notation::Decimals);
        slate.fitted_in(rect.size(), |slate| {
            let n = self.cells.len() as f32;
            let places = self.cells.iter().filter_map(|cell| cell.place.as_ref());
            let style = (Face::Mono, PLACE_PTS, slate.theme().ink);
            let widest = places.map(|place| slate.value(place, style).size().x);
            let arrows = self.arrows.iter().map(|name| {
                let style = (Face::Mono, ARROW_PTS, slate.theme().ink);
                slate.value(name, style).size().x + slate.pts(26.0)
            });
            let widest = widest.chain(arrows).fold(slate.pts(80.0), f32::max);
            vec2(n * (widest + slate.pts(4.0)), slate.pts(90.0))
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let n = self.cells.len().max(1) as f32;
        let gap = slate.pts(GAP);
        let width = ((rect.width() - (n - 1.0) * gap) / n).floor();
        let taken = slate.pts(NAMES + PLACES + ARROWS);
        let height = (rect.height() - taken).max(8.0).min(0.72 * width).floor();
        let mut middles = Vec::new();
        for (nth, cell) in self.cells.iter().enumerate() {
            let left = (rect.left() + nth as f32 * (width + gap)).round();
            let corner = pos2(left, (rect.top() + slate.pts(NAMES)).round());
            let place = Rect::from_min_size(corner, vec2(width, height));
            draw_cell(slate, place, cell, links);
            middles.push(place.center().x);
        }
        let y = rect.top() + taken + height - 0.5 * slate.pts(ARROWS);
        for (nth, name) in self.arrows.iter().enumerate() {
            let Some(ends) = middles.get(nth..nth + 2) else {
                continue;
            };
            let theme = slate.theme();
            let is_at_work = self.at_work == Some(nth);
            let (ink, text) = if is_at_work {
                (theme.signal, theme.signal_text)
            } else {
                (theme.faint, theme.soft)
            };
            let text = slate.value(name, (Face::Mono, ARROW_PTS, text));
            let middle = 0.5 * (ends[0] + ends[1]);
            let put = slate.put(&text, pos2(middle, y), Align2::CENTER_CENTER);
            let stroke = slate.stroke(1.0, ink);
            let (aside, inset) = (slate.pts(4.0), slate.pts(4.0));
            let [from, to] = [ends[0] + inset, ends[1] - inset];
            if put.left() - aside > from {
                slate.line([pos2(from, y), pos2(put.left() - aside, y)], stroke);
            }
            if to - put.right() > 2.0 * aside {
                let shaft = [pos2(put.right() + aside, y), pos2(to, y)];
                slate.arrow(shaft, stroke);
            }
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let cell = |cell: &SpaceCell| {
            let arrow = if cell.stage == CellStage::Current {
                "→ "
            } else {
                ""
            };
            let name = look.catalog.value(&cell.name);
            match &cell.place {
                Some(place) => {
                    let place = look.catalog.value_as(place, Notation::Decimals);
                    format!("{arrow}{name} {place}")
                }
                None => format!("{arrow}{name}"),
            }
        };
        let cells: Vec<String> = self.cells.iter().map(cell).collect();
        cells.join("; ")
    }
}

fn draw_cell(slate: &mut Slate<'_>, place: Rect, cell: &SpaceCell, links: &mut Links) {
    let theme = slate.theme();
    let is_lit = links.touch(place, cell.link);
    let (face, ink) = match cell.stage {
        CellStage::Current => (Face::Strong, theme.ink),
        CellStage::Done => (Face::Plain, theme.ink),
        CellStage::ToCome => (Face::Plain, theme.soft),
    };
    let name = slate.value(&cell.name, (face, NAME_PTS, ink));
    let above = place.left_top() - vec2(0.0, slate.pts(3.0));
    slate.put(&name, above, Align2::LEFT_BOTTOM);
    let mut painter = slate.painter.with_clip_rect(place);
    painter.rect_filled(place, 4.0, theme.panel);
    if cell.stage == CellStage::ToCome {
        painter.multiply_opacity(PALE);
    }
    let lens = Lens::from(cell.space.seer);
    let id = egui::Id::unique(("space-row", place.left() as i32, place.top() as i32));
    let marks = projected(slate.painter.ctx(), id, &cell.space, &lens);
    let viewport = picture_viewport(place, &lens);
    let Look { catalog, .. } = slate.look;
    paint::stage(
        &painter,
        &viewport,
        theme,
        catalog,
        &marks,
        None,
        Around::default(),
    );
    let frame = match cell.stage {
        CellStage::Current => slate.stroke(2.0, theme.signal),
        CellStage::Done | CellStage::ToCome if is_lit => slate.stroke(1.5, theme.accent),
        CellStage::Done | CellStage::ToCome => Stroke::new(1.0, theme.hairline),
    };
    slate
        .painter
        .rect_stroke(place, 4.0, frame, StrokeKind::Inside);
    if let Some(at) = &cell.place {
        let at = slate.value(at, (Face::Mono, PLACE_PTS, ink));
        let under = place.center_bottom() + vec2(0.0, slate.pts(3.0));
        slate.put(&at, under, Align2::CENTER_TOP);
    }
}
