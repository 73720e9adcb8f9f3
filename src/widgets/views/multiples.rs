//! Small drawings at one scale, in a row or in several; this step's has a frame.
//!
//! ```text
//!   near    3 → 4     far     4 → 5     left    5 → 5   ┌ right   5 → 6 ┐
//!      ┌────────╲        ┌─────┐           ┌─────┐      │     ┌─────┐   │
//!       ╲        ╲        ╲     ╲          │     ╲      │     │     │   │
//!        ╲────────╲        ╲─────╲         └──────╲     │      ╲────┘   │
//!                                                       └───────────────┘
//! ```

use crate::figure::{Multiples, SmallDrawing};

use super::prelude::*;

const TITLE_PTS: f32 = 12.5;
const HEADING: f32 = 1.3 * TITLE_PTS;
const NOTE_PTS: f32 = 11.5;
const PAD: f32 = 7.0;
const GAP: f32 = 8.0;
const MARGIN: f32 = 5.0;
const LEAST_DRAWING: f32 = 34.0;
/// Titles shrink to this part of ordinary text before there are fewer drawings in a row.
const CROWDED: f32 = 0.85;

impl OnSlate for Multiples {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let [columns, rows] = self.grid(&natural, room);
        natural.fitted_in(room, |slate| {
            let widest = self.widest(slate) + slate.pts(GAP);
            let high = slate.pts(HEADING) + slate.pts(2.0 * PAD + LEAST_DRAWING);
            vec2(columns as f32 * widest, rows as f32 * high)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let [columns, rows] = self.grid(slate, rect.size());
        let gap = slate.pts(GAP);
        let size = Self::cell(slate, rect.size(), [columns, rows]);
        for (i, drawing) in self.drawings.iter().enumerate() {
            let at = vec2((i % columns) as f32, (i / columns) as f32);
            let at = rect.min + at * (size + Vec2::splat(gap));
            let place = Rect::from_min_size(at, size);
            let is_lit = links.touch(place, drawing.link);
            self.draw_one(slate, drawing, place, is_lit);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let drawing = |drawing: &SmallDrawing| {
            let arrow = now(drawing.is_current);
            let title = look.catalog.value(&drawing.title);
            let note = drawing.note.as_ref().map(|note| look.catalog.value(note));
            format!("{arrow}{title}: {}", note.unwrap_or_default())
        };
        joined(self.drawings.iter().map(drawing), "; ")
    }
}

impl Multiples {
    fn widest(&self, slate: &Slate<'_>) -> f32 {
        let widths = self.drawings.iter().map(|drawing| {
            let note = drawing.note.as_ref();
            let note = note.map_or(0.0, |note| slate.width(note, Face::Mono, NOTE_PTS));
            slate.width(&drawing.title, Face::Strong, TITLE_PTS) + note
        });
        widths.fold(0.0, f32::max) + slate.pts(3.0 * PAD)
    }

    /// Columns and rows, all of them full: as many as make the drawings largest.
    fn grid(&self, slate: &Slate<'_>, room: Vec2) -> [usize; 2] {
        let n = self.drawings.len().max(1);
        let grid = |columns: usize| [columns, n.div_ceil(columns)];
        let widest = CROWDED * self.widest(slate) / slate.scale;
        let fits = |&columns: &usize| Self::cell(slate, room, grid(columns)).x >= widest;
        let scale = |&columns: &usize| {
            let cell = Rect::from_min_size(Pos2::ZERO, Self::cell(slate, room, grid(columns)));
            self.viewport(drawn_in(slate, cell), slate.pts(MARGIN))
                .scale
        };
        let columns = (1..=n)
            .filter(|columns| n.is_multiple_of(*columns))
            .filter(fits);
        let largest = columns.max_by(|a, b| scale(a).total_cmp(&scale(b)));
        grid(largest.filter(|_| self.is_beside).unwrap_or(n))
    }

    fn cell(slate: &Slate<'_>, room: Vec2, grid: [usize; 2]) -> Vec2 {
        let n = Vec2::from(grid.map(|n| n as f32));
        (room - (n - Vec2::splat(1.0)) * slate.pts(GAP)) / n
    }

    fn viewport(&self, rect: Rect, margin: f32) -> Viewport {
        let [min, max] = self.bounds;
        let room = rect.shrink(margin).size().max(vec2(1.0, 1.0));
        let fits = |i: usize| {
            let side = f64::from([room.x, room.y][i]);
            side / (max[i] - min[i]).max(f64::MIN_POSITIVE)
        };
        Viewport {
            rect,
            centre: [0, 1].map(|i| min[i].midpoint(max[i])),
            scale: fits(0).min(fits(1)).clamp(f64::MIN_POSITIVE, 1e12),
        }
    }

    fn draw_one(&self, slate: &mut Slate<'_>, drawing: &SmallDrawing, place: Rect, is_lit: bool) {
        let theme = slate.theme();
        let frame = match (drawing.is_current, is_lit) {
            (true, _) => Some((1.75, theme.signal)),
            (false, true) => Some((1.5, theme.accent)),
            (false, false) => None,
        };
        if let Some((width, colour)) = frame {
            let stroke = slate.stroke(width, colour);
            slate.rim(place, slate.pts(4.0), stroke, StrokeKind::Inside);
        }
        let inner = place.shrink(slate.pts(PAD));
        let (face, title, note) = match (drawing.is_current, drawing.is_to_come) {
            (true, _) => (Face::Strong, theme.signal_text, theme.ink),
            (false, true) => (Face::Plain, theme.soft, theme.soft),
            (false, false) => (Face::Plain, theme.ink, theme.ink),
        };
        let title = slate.value(&drawing.title, (face, TITLE_PTS, title));
        slate.put(&title, inner.left_top(), Align2::LEFT_TOP);
        if let Some(value) = &drawing.note {
            let note = slate.value(value, (Face::Mono, NOTE_PTS, note));
            slate.put(&note, inner.right_top(), Align2::RIGHT_TOP);
        }
        let viewport = self.viewport(drawn_in(slate, place), slate.pts(MARGIN));
        let (look, around) = (slate.look, Around::default());
        look.stage(slate.painter, &viewport, &drawing.marks, None, around);
    }
}

/// Under the title.
fn drawn_in(slate: &Slate<'_>, place: Rect) -> Rect {
    let inner = place.shrink(slate.pts(PAD));
    let top = inner.top() + slate.pts(HEADING);
    inner.with_min_y(top.min(inner.bottom() - 1.0))
}
