//! Small drawings at one scale: in a row, or as large as they can be; this step's has a frame.
//!
//! ```text
//!   near    3 → 4     far     4 → 5     left    5 → 5   ┌ right   5 → 6 ┐
//!      ┌────────╲        ┌─────┐           ┌─────┐      │     ┌─────┐   │
//!       ╲        ╲        ╲     ╲          │     ╲      │     │     │   │
//!        ╲────────╲        ╲─────╲         └──────╲     │      ╲────┘   │
//!                                                       └───────────────┘
//! ```

use crate::figure::{Multiples, SmallDrawing};

use super::{super::hit, prelude::*};

const TITLE_PTS: f32 = 12.5;
const HEADING: f32 = 1.3 * TITLE_PTS;
const NOTE_PTS: f32 = 11.5;
const PAD: f32 = 7.0;
const GAP: f32 = 8.0;
const MARGIN: f32 = 5.0;
const LEAST_DRAWING: f32 = 34.0;

impl OnSlate for Multiples {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let in_row = self.columns(&natural, room) as f32;
        natural.fitted_in(room, |slate| {
            let widths = self.drawings.iter().map(|drawing| {
                let note = self.note(slate, drawing, f32::INFINITY);
                let note = note.filter(|_| self.is_strip);
                self.title(slate, drawing).size().x + note.map_or(0.0, |note| note.size().x)
            });
            let widest = widths.fold(0.0, f32::max) + slate.pts(3.0 * PAD);
            let high = slate.pts(HEADING) + slate.pts(2.0 * PAD + LEAST_DRAWING);
            vec2(in_row * (widest + slate.pts(GAP)), high)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let n = self.drawings.len().max(1);
        let gap = slate.pts(GAP);
        let columns = self.columns(slate, rect.size());
        let rows = n.div_ceil(columns);
        let side = |whole: f32, n: usize| (whole - (n - 1) as f32 * gap) / n as f32;
        let size = vec2(side(rect.width(), columns), side(rect.height(), rows));
        let heading = self.heading(slate, size.x);
        for (i, drawing) in self.drawings.iter().enumerate() {
            let at = vec2((i % columns) as f32, (i / columns) as f32) * (size + Vec2::splat(gap));
            let place = Rect::from_min_size(rect.min + at, size);
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
    /// So many in a row that they are as large as they can be.
    fn columns(&self, slate: &Slate<'_>, room: Vec2) -> usize {
        let n = self.drawings.len().max(1);
        if self.is_strip {
            return n;
        }
        let (aspect, heading) = (self.aspect() as f32, slate.pts(HEADING));
        let width = |columns: &usize| {
            let rows = n.div_ceil(*columns) as f32;
            (room.x / *columns as f32).min((room.y / rows - heading) * aspect)
        };
        let larger = |a: &usize, b: &usize| width(a).total_cmp(&width(b));
        (1..=n).max_by(larger).unwrap_or(n)
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

    /// How high title and note are at most, in a tile of this width: all drawings have one size.
    fn heading(&self, slate: &Slate<'_>, width: f32) -> f32 {
        let high = self.drawings.iter().map(|drawing| {
            let title = self.title(slate, drawing).size().x + slate.pts(GAP);
            let note = self.note(slate, drawing, width);
            let under = note.filter(|note| !self.is_strip && title + note.size().x > width);
            slate.pts(HEADING) + under.map_or(0.0, |note| note.size().y)
        });
        high.fold(slate.pts(HEADING), f32::max)
    }

    fn title(&self, slate: &Slate<'_>, drawing: &SmallDrawing) -> Typeset {
        let theme = slate.theme();
        let (face, ink) = match (drawing.is_current, drawing.is_to_come) {
            (true, _) => (Face::Strong, theme.signal_text),
            (false, true) => (Face::Plain, theme.soft),
            (false, false) => (Face::strong_if(!self.is_strip), theme.ink),
        };
        slate.value(&drawing.title, (face, TITLE_PTS, ink))
    }

    /// On one line in a strip; else on as many as it takes.
    fn note(&self, slate: &Slate<'_>, drawing: &SmallDrawing, width: f32) -> Option<Typeset> {
        let (role, note) = drawing.note.as_ref()?;
        let role = if drawing.is_to_come {
            Role::Soft
        } else {
            *role
        };
        let ink = text_colour(slate.theme(), role);
        Some(if self.is_strip {
            slate.value(note, (Face::Mono, NOTE_PTS, ink))
        } else {
            slate.wrapped(note, width, (Face::Plain, NOTE_PTS, ink))
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
        let pad = if self.is_strip { slate.pts(PAD) } else { 0.0 };
        let inner = place.shrink(pad);
        let top = inner.top() + heading;
        let title = self.title(slate, drawing);
        let title = slate.put(&title, inner.left_top(), Align2::LEFT_TOP);
        if let Some(note) = self.note(slate, drawing, inner.width()) {
            let beside = title.right() + slate.pts(GAP);
            let has_room = beside + note.size().x <= inner.right();
            let (at, align) = match (self.is_strip, has_room) {
                (true, _) => (inner.right_top(), Align2::RIGHT_TOP),
                (false, true) => (pos2(beside, inner.top()), Align2::LEFT_TOP),
                (false, false) => {
                    let under = inner.top() + slate.pts(HEADING);
                    (pos2(inner.left(), under), Align2::LEFT_TOP)
                }
            };
            slate.put(&note, at, align);
        }
        let room = inner.with_min_y(top.min(inner.bottom() - 1.0));
        let viewport = self.viewport(room, slate.pts(MARGIN));
        let (look, around) = (slate.look, Around::default());
        look.stage(slate.painter, &viewport, &drawing.marks, links.lit, around);
        if let Some(pointer) = links.pointer.filter(|at| room.contains(*at)) {
            let pointed = hit::link_at(&viewport, &drawing.marks, pointer);
            links.pointed = pointed.or(links.pointed);
        }
    }
}
