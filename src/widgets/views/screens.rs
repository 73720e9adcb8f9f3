//! Screens over each other: the square in the middle, what lands beside it, and over each how it came there.
//!
//! ```text
//!   Divide first  the wrong piece       Clip first  the right one
//!            ┌──────┐                            ┌──────┐
//!        ╌╌╌╌┼╌●    │                            │  ●━━━┥╌╌╌►
//!            └──────┘                            └──────┘
//! ```

use egui::{Align2, Painter, Rect, vec2};

use crate::{
    figure::{Screen, Screens},
    paint::{self, Around, Viewport},
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate, text_colour},
};

const TITLE_PTS: f32 = 13.0;
const NOTE_PTS: f32 = 12.0;
/// Between a title and its note, and between one screen and the next.
const GAP: f32 = 10.0;
/// Under a title.
const UNDER: f32 = 3.0;

impl OnSlate for Screens {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        Slate::new(painter, look).fitted_in(rect.size(), |slate| {
            let widths = self.screens.iter().map(|screen| {
                let [title, note] = words(slate, screen);
                title.size().x + slate.pts(GAP) + note.size().x
            });
            vec2(widths.fold(0.0, f32::max), 0.0)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let n = self.screens.len().max(1) as f32;
        let gap = slate.pts(GAP);
        let height = ((rect.height() - (n - 1.0) * gap) / n).floor();
        for (nth, screen) in self.screens.iter().enumerate() {
            let top = rect.top() + (nth as f32 * (height + gap)).round();
            let place = Rect::from_min_size(rect.left_top(), vec2(rect.width(), height));
            draw_screen(
                slate,
                place.translate(vec2(0.0, top - rect.top())),
                screen,
                links,
            );
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let spoken = |screen: &Screen| {
            let labels = screen.marks.iter().filter_map(|mark| mark.label.as_ref());
            let labels: Vec<String> = labels.map(|l| look.catalog.value(&l.text)).collect();
            let [title, note] = [
                look.catalog.value(&screen.title),
                look.catalog.message(&screen.note),
            ];
            format!("{title}: {note} ({})", labels.join("; "))
        };
        let screens: Vec<String> = self.screens.iter().map(spoken).collect();
        screens.join("\n")
    }
}

fn words(slate: &Slate<'_>, screen: &Screen) -> [paint::Typeset; 2] {
    let theme = slate.theme();
    let title = slate.value(&screen.title, (Face::Strong, TITLE_PTS, theme.ink));
    let colour = text_colour(theme, screen.role);
    let note = slate.words(
        slate.look.catalog.message(&screen.note),
        (Face::Plain, NOTE_PTS, colour),
    );
    [title, note]
}

fn draw_screen(slate: &mut Slate<'_>, place: Rect, screen: &Screen, links: &mut Links) {
    let [title, note] = words(slate, screen);
    let put = slate.put(&title, place.left_top(), Align2::LEFT_TOP);
    let beside = put.right_center() + vec2(slate.pts(GAP), 0.0);
    slate.put(&note, beside, Align2::LEFT_CENTER);
    let picture = place.with_min_y(put.bottom() + slate.pts(UNDER));
    let [min, max] = Screens::SEEN;
    let [width, height] = [0, 1].map(|i| max[i] - min[i]);
    let fits = [
        f64::from(picture.width()) / width,
        f64::from(picture.height()) / height,
    ];
    let viewport = Viewport {
        rect: picture,
        centre: [0.0; 2],
        scale: fits[0].min(fits[1]).max(1.0),
    };
    let Look { theme, catalog } = slate.look;
    let painter = slate.painter.with_clip_rect(picture);
    paint::stage(
        &painter,
        &viewport,
        theme,
        catalog,
        &screen.marks,
        links.lit,
        Around::default(),
    );
    if let Some(pointer) = links.pointer.filter(|at| picture.contains(*at)) {
        links.pointed =
            super::super::hit::link_at(&viewport, &screen.marks, pointer).or(links.pointed);
    }
}
