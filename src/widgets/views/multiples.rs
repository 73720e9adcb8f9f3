//! Small drawings at one scale, in a row or in several; this step's has a frame.
//!
//! ```text
//!   near    3 → 4     far     4 → 5     left    5 → 5   ┌ right   5 → 6 ┐
//!      ┌────────╲        ┌─────┐           ┌─────┐      │     ┌─────┐   │
//!       ╲        ╲        ╲     ╲          │     ╲      │     │     │   │
//!        ╲────────╲        ╲─────╲         └──────╲     │      ╲────┘   │
//!                                                       └───────────────┘
//! ```

use std::borrow::Cow;

use crate::figure::{Mark, Multiples, Shape, SmallDrawing, Tiles};

use super::{super::hit, prelude::*};

const TITLE_PTS: f32 = 12.5;
const HEADING: f32 = 1.3 * TITLE_PTS;
const NOTE_PTS: f32 = 11.5;
const PAD: f32 = 5.0;
const GAP: f32 = 8.0;
const MARGIN: f32 = 5.0;
const LEAST_DRAWING: f32 = 34.0;
/// A row of text beside a bar.
const ROW: f32 = 17.0;
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
        let size = Self::cell(slate, rect.size(), [columns, rows]);
        let heading = self.heading(slate, size.x);
        for (i, drawing) in self.drawings.iter().enumerate() {
            let at = vec2((i % columns) as f32, (i / columns) as f32);
            let at = rect.min + at * (size + Vec2::splat(slate.pts(GAP)));
            let place = Rect::from_min_size(at, size);
            let is_lit = links.touch(place, drawing.link);
            self.draw_one(slate, drawing, (place, heading, is_lit), links);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let drawing = |drawing: &SmallDrawing| {
            let arrow = now(drawing.is_current);
            let title = look.catalog.value(&drawing.title);
            let note = drawing
                .note
                .as_ref()
                .map(|(_, note)| look.catalog.value(note));
            let labels = drawing.marks.iter().filter_map(|mark| mark.label.as_ref());
            let labels = labels.map(|label| look.catalog.value(&label.text));
            bracketed(
                &format!("{arrow}{title}: {}", note.unwrap_or_default()),
                labels,
            )
        };
        joined(self.drawings.iter().map(drawing), "; ")
    }
}

impl Multiples {
    const fn is_large(&self) -> bool {
        matches!(self.tiles, Tiles::Large)
    }

    fn widest(&self, slate: &Slate<'_>) -> f32 {
        let widths = self.drawings.iter().map(|drawing| {
            let note = self.note(slate, drawing, f32::INFINITY);
            let note = note.filter(|_| !self.is_large());
            self.title(slate, drawing, f32::INFINITY).size().x
                + note.map_or(0.0, |note| note.size().x)
        });
        widths.fold(0.0, f32::max) + slate.pts(3.0 * PAD)
    }

    /// Columns and rows: as many as make the drawings largest. Beside a drawing, and under it, all rows are full.
    fn grid(&self, slate: &Slate<'_>, room: Vec2) -> [usize; 2] {
        let n = self.drawings.len().max(1);
        let grid = |columns: usize| [columns, n.div_ceil(columns)];
        let widest = CROWDED * self.widest(slate) / slate.scale;
        let may_be = |columns: &usize| match self.tiles {
            Tiles::Large => true,
            Tiles::Strip | Tiles::Beside => {
                let width = Self::cell(slate, room, grid(*columns)).x;
                n.is_multiple_of(*columns) && width >= widest
            }
        };
        let scale = |&columns: &usize| {
            let size = Self::cell(slate, room, grid(columns));
            let place = Rect::from_min_size(Pos2::ZERO, size);
            let drawn = self.drawn_in(slate, place, self.heading(slate, size.x));
            self.viewport(drawn, slate.pts(MARGIN)).scale
        };
        let columns = (1..=n).filter(may_be);
        let largest = columns.max_by(|a, b| scale(a).total_cmp(&scale(b)));
        grid(largest.unwrap_or(n))
    }

    fn cell(slate: &Slate<'_>, room: Vec2, grid: [usize; 2]) -> Vec2 {
        let n = Vec2::from(grid.map(|n| n as f32));
        (room - (n - Vec2::splat(1.0)) * slate.pts(GAP)) / n
    }

    fn inner(&self, slate: &Slate<'_>, place: Rect) -> Rect {
        place.shrink(if self.is_large() { 0.0 } else { slate.pts(PAD) })
    }

    /// Under the heading.
    fn drawn_in(&self, slate: &Slate<'_>, place: Rect, heading: f32) -> Rect {
        let inner = self.inner(slate, place);
        inner.with_min_y((inner.top() + heading).min(inner.bottom() - 1.0))
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

    const fn is_bars(&self) -> bool {
        matches!(self.tiles, Tiles::Strip) && self.drawings.len() == 1
    }

    /// The same; rows of bars stand right under their heading, as far apart as what is written at them is high, if there is room.
    /// By how much are bars shorter for that?
    fn under_heading(&self, slate: &Slate<'_>, rect: Rect) -> (Viewport, f64) {
        let margin = slate.pts(MARGIN);
        let viewport = self.viewport(rect, margin);
        if !self.is_bars() {
            return (viewport, 1.0);
        }
        let [min, max] = self.bounds;
        let rows = (max[1] - min[1]).max(f64::MIN_POSITIVE);
        let most = f64::from(rect.height() - 2.0 * margin) / rows;
        // Names of marks do not shrink with the view.
        let row = f64::from(ROW * slate.theme().text_scale);
        let scale = row.min(most).max(viewport.scale);
        let height = (scale * rows) as f32 + 2.0 * margin;
        let rect = rect.with_max_y(rect.bottom().min(rect.top() + height));
        let shorter = viewport.scale / scale;
        let viewport = Viewport {
            rect,
            scale,
            ..viewport
        };
        (viewport, shorter)
    }

    /// Bars, and what is written at them, nearer to the middle.
    fn shortened(&self, marks: &[Mark], by: f64) -> Vec<Mark> {
        let middle = self.bounds[0][0].midpoint(self.bounds[1][0]);
        let nearer = |[x, y]: [f64; 2]| [middle + by * (x - middle), y];
        let shortened = marks.iter().cloned().map(|mut mark| {
            match &mut mark.shape {
                Shape::Segment(ends) => *ends = ends.map(nearer),
                Shape::Label(at) | Shape::Vertex(at) => *at = nearer(*at),
                // Rows of bars have no others.
                _ => {}
            }
            mark
        });
        shortened.collect()
    }

    /// How high title and note are at most, in a tile of this width: all drawings have one size.
    fn heading(&self, slate: &Slate<'_>, width: f32) -> f32 {
        let inner = width
            - if self.is_large() {
                0.0
            } else {
                slate.pts(2.0 * PAD)
            };
        let high = self.drawings.iter().map(|drawing| {
            let title = self.title(slate, drawing, inner).size() + vec2(slate.pts(GAP), 0.0);
            let note = self.note(slate, drawing, width);
            let under = note.filter(|note| self.is_large() && title.x + note.size().x > width);
            title.y.max(slate.pts(HEADING)) + under.map_or(0.0, |note| note.size().y)
        });
        high.fold(slate.pts(HEADING), f32::max)
    }

    /// On one line, where that has room.
    fn title(&self, slate: &Slate<'_>, drawing: &SmallDrawing, width: f32) -> Typeset {
        let theme = slate.theme();
        let (face, ink) = match (drawing.is_current, drawing.is_to_come) {
            (true, _) => (Face::Strong, theme.signal_text),
            (false, true) => (Face::Plain, theme.soft),
            (false, false) => (Face::strong_if(self.is_large()), theme.ink),
        };
        slate.wrapped(&drawing.title, width, (face, TITLE_PTS, ink))
    }

    /// On one line of a small drawing; of a large one on as many as it takes.
    fn note(&self, slate: &Slate<'_>, drawing: &SmallDrawing, width: f32) -> Option<Typeset> {
        let (role, note) = drawing.note.as_ref()?;
        let role = if drawing.is_to_come {
            Role::Soft
        } else {
            *role
        };
        let ink = text_colour(slate.theme(), role);
        Some(if self.is_large() {
            slate.wrapped(note, width, (Face::Plain, NOTE_PTS, ink))
        } else {
            slate.value(note, (Face::Mono, NOTE_PTS, ink))
        })
    }

    fn draw_one(
        &self,
        slate: &mut Slate<'_>,
        drawing: &SmallDrawing,
        (place, heading, is_lit): (Rect, f32, bool),
        links: &mut Links,
    ) {
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
        let inner = self.inner(slate, place);
        let title = self.title(slate, drawing, inner.width());
        let title = slate.put(&title, inner.left_top(), Align2::LEFT_TOP);
        if let Some(note) = self.note(slate, drawing, inner.width()) {
            let beside = title.right() + slate.pts(GAP);
            let has_room = beside + note.size().x <= inner.right();
            let (at, align) = match (self.is_large(), has_room) {
                (false, _) => (inner.right_top(), Align2::RIGHT_TOP),
                (true, true) => (pos2(beside, inner.top()), Align2::LEFT_TOP),
                (true, false) => {
                    let under = title.bottom().max(inner.top() + slate.pts(HEADING));
                    (pos2(inner.left(), under), Align2::LEFT_TOP)
                }
            };
            slate.put(&note, at, align);
        }
        let room = self.drawn_in(slate, place, heading);
        let (viewport, shorter) = self.under_heading(slate, room);
        let mut marks = Cow::Borrowed(&drawing.marks[..]);
        if shorter < 1.0 {
            marks = self.shortened(&marks, shorter).into();
        }
        let (look, around) = (slate.look, Around::default());
        look.stage(slate.painter, &viewport, &marks, links.lit, around);
        if let Some(pointer) = links.pointer.filter(|at| room.contains(*at)) {
            let pointed = hit::link_at(&viewport, &marks, pointer, hit::REACH);
            links.pointed = pointed.or(links.pointed);
        }
    }
}
