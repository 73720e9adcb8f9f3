//! Screens over each other: the square in the middle, what lands beside it, and over each how it came there.
//!
//! ```text
//!   Divide first  the wrong piece       Clip first  the right one
//!            ┌──────┐                            ┌──────┐
//!        ╌╌╌╌┼╌●    │                            │  ●━━━┥╌╌╌►
//!            └──────┘                            └──────┘
//! ```

use crate::figure::{Screen, Screens};

use super::{super::hit, prelude::*};

const TITLE_PTS: f32 = 13.0;
const NOTE_PTS: f32 = 12.0;
const GAP: f32 = 10.0;
const UNDER: f32 = 3.0;

impl OnSlate for Screens {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        natural.fitted_in(room, |slate| {
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
        let place = Rect::from_min_size(rect.left_top(), vec2(rect.width(), height));
        for (nth, screen) in self.screens.iter().enumerate() {
            let top = rect.top() + (nth as f32 * (height + gap)).round();
            let place = place.translate(vec2(0.0, top - rect.top()));
            draw_screen(slate, place, screen, links);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let spoken = |screen: &Screen| {
            let labels = screen.marks.iter().filter_map(|mark| mark.label.as_ref());
            let labels = joined(labels.map(|l| look.catalog.value(&l.text)), "; ");
            let title = look.catalog.value(&screen.title);
            let note = look.catalog.message(&screen.note);
            format!("{title}: {note} ({labels})")
        };
        joined(self.screens.iter().map(spoken), "\n")
    }
}

fn words(slate: &Slate<'_>, screen: &Screen) -> [Typeset; 2] {
    let theme = slate.theme();
    let style = (Face::Plain, NOTE_PTS, text_colour(theme, screen.role));
    [
        slate.value(&screen.title, (Face::Strong, TITLE_PTS, theme.ink)),
        slate.words(slate.look.catalog.message(&screen.note), style),
    ]
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
    let painter = slate.painter.with_clip_rect(picture);
    let (look, marks) = (slate.look, &screen.marks);
    look.stage(&painter, &viewport, marks, links.lit, Around::default());
    if let Some(pointer) = links.pointer.filter(|at| picture.contains(*at)) {
        links.pointed = hit::link_at(&viewport, marks, pointer).or(links.pointed);
    }
}
