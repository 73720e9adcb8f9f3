//! One figure: the step's title, what the stage shows, and the run's sentence under it.

mod halves;
mod page;
mod picture;
#[cfg(test)]
mod tests;

use egui::{Ui, Vec2};

use crate::{
    figure::{Layout, ViewId},
    paint::{Headless, Image, ThemeKind},
    text::{Catalog, Message},
    widgets::{Album, Column, Medium},
};

#[cfg(not(target_arch = "wasm32"))]
use super::vector::{VectorPage, read};

use halves::{Half, halves, headings};
#[cfg(not(target_arch = "wasm32"))]
pub use page::PAGE_MARGINS;
use page::{Page, lost};
#[cfg(not(target_arch = "wasm32"))]
pub use picture::Before;
pub use picture::{Options, Picture, Steps};

/// A figure is laid out on a page of this size in points, or larger along one side as its shape asks, and then enlarged to its size in
/// pixels: text keeps its proportion to the picture. At 1280 × 720 pixels the title is 26 high, the text 17, the caption 19, the margin 64.
const PAGE_PTS: [f32; 2] = [960.0, 540.0];
/// Where a view of one method has no room, the page is enlarged by so much, and again, until all have: what is on it
/// becomes smaller, but where text is large on purpose.
const ENLARGED_BY: f32 = 0.1;
const MOST_ENLARGED: f32 = 1.4;

/// Draws figures. One that has drawn others draws faster, and records the runs of a lesson once, however many of its steps
/// it draws; the bytes are the same.
pub struct Studio {
    table: Headless,
    last: Option<Album>,
}

impl Studio {
    pub fn new(theme: ThemeKind) -> Self {
        Self {
            table: Headless::new(theme),
            last: None,
        }
    }

    /// What else is drawn without a window is drawn on this.
    pub const fn table(&mut self) -> &mut Headless {
        &mut self.table
    }

    pub fn draw(&mut self, picture: &Picture<'_>) -> Image {
        self.drawn(picture).0
    }

    /// In words what the figure shows: its title, and under each method's name its sentence.
    pub fn alternative(&mut self, picture: &Picture<'_>) -> String {
        let album = album(&mut self.last, picture);
        alternative(&shown(album, picture), picture)
    }

    /// The figure, and the views that have no room even on the largest page.
    fn drawn(&mut self, picture: &Picture<'_>) -> (Image, Vec<ViewId>) {
        let Self { table, last } = self;
        let album = album(last, picture);
        let page = Page::of(album, picture, shown(album, picture));
        drawn(table, &page, |table, size, pixels, show| {
            table.draw(size, pixels, show)
        })
    }

    /// The same as shapes and, as [`Self::alternative`], in words.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn vector(&mut self, picture: &Picture<'_>) -> (VectorPage, String) {
        let Self { table, last } = self;
        let album = album(last, picture);
        let shown = shown(album, picture);
        let alternative = alternative(&shown, picture);
        let page = Page::of(album, picture, shown);
        let write = |table: &mut Headless, size, pixels, show: &mut dyn FnMut(&mut Ui)| {
            table.write(size, pixels, show, read)
        };
        (drawn(table, &page, write).0, alternative)
    }
}

/// What is kept of this lesson; another one's goes.
fn album<'a>(last: &'a mut Option<Album>, picture: &Picture<'_>) -> &'a Album {
    last.take_if(|known| !known.holds(picture.scene, picture.lesson));
    last.get_or_insert_with(|| Album::new(picture.scene, picture.lesson, Medium::Page))
}

fn shown<'a>(album: &'a Album, picture: &Picture<'_>) -> Vec<Half<'a>> {
    halves(album, &picture.stops(), picture.asked_in())
}

fn alternative(halves: &[Half<'_>], picture: &Picture<'_>) -> String {
    let catalog = Catalog::of(picture.options.lang);
    let headings = headings(halves, picture);
    let columns = halves.iter().flat_map(|half| &half.columns);
    let sentence = |(column, name): (&Column, &String)| {
        let said = column.frame.caption.text(catalog);
        if headings.len() > 1 {
            catalog.message(
                &Message::new("named-sentence")
                    .with("name", name.clone())
                    .with("said", said),
            )
        } else {
            said
        }
    };
    let title = picture.title.map(str::to_owned);
    let lines: Vec<String> = title
        .into_iter()
        .chain(columns.zip(&headings).map(sentence))
        .collect();
    lines.join("\n") + "\n"
}

/// What `draw` makes of it on a page of a size in points and so many pixels per point, and the views that have no room.
fn drawn<R>(
    table: &mut Headless,
    page: &Page<'_>,
    draw: impl Fn(&mut Headless, Vec2, f32, &mut dyn FnMut(&mut Ui)) -> R,
) -> (R, Vec<ViewId>) {
    let options = &page.picture.options;
    table.set_theme(options.theme);
    let size = Vec2::from(options.size_px.map(|side| side as f32));
    let pixels_per_point = (size.x / PAGE_PTS[0]).min(size.y / PAGE_PTS[1]);
    let mut page_scale = 1.0;
    loop {
        let pixels_per_point = pixels_per_point / page_scale;
        let mut layout = Layout::default();
        let mut show = |ui: &mut Ui| layout = page.show(ui);
        let drawn = draw(table, size / pixels_per_point, pixels_per_point, &mut show);
        let may_grow = page.needs.len() == 1 && !page.look.theme.has_large_text();
        let lost = lost(&page.needs, &layout);
        if lost.is_empty() || page_scale >= MOST_ENLARGED || !may_grow {
            return (drawn, lost);
        }
        page_scale += ENLARGED_BY;
    }
}
