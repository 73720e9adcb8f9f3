//! The present figure as a PNG: stage and caption, as the window shows them.

use egui::{CentralPanel, Frame, Rect, pos2, vec2};

use crate::{
    labs::lines::{backdrop, bounds},
    paint::{self, Headless, Theme, Viewport},
    text::Catalog,
    widgets::{Look, caption, caption_height},
};

use super::platform::Picture;

/// In points; twice as many pixels.
const SIZE: egui::Vec2 = vec2(960.0, 540.0);
/// Lines of the caption.
const N_ROWS: usize = 2;

/// Draws the figure at 1920×1080.
pub fn draw(picture: Picture<'_>) -> Vec<u8> {
    let look = Look {
        theme: Theme::of(picture.theme),
        catalog: Catalog::of(picture.lang),
    };
    let scene = picture.scene;
    let run = scene.method.record(scene, scene.focused());
    let frame = run.frame(picture.position.min(run.n_steps()));
    let mut marks = backdrop(scene, scene.method);
    marks.extend(frame.marks);
    let split = SIZE.y - caption_height(look.theme, N_ROWS);
    let stage = Rect::from_min_max(pos2(0.0, 0.0), pos2(SIZE.x, split));
    let below = Rect::from_min_max(pos2(0.0, split), pos2(SIZE.x, SIZE.y));
    let viewport = Viewport::fit(stage, bounds(scene));
    let image = Headless::new(picture.theme).draw(SIZE, 2.0, |ui| {
        CentralPanel::default().frame(Frame::NONE).show(ui, |ui| {
            let painter = ui.painter_at(stage);
            paint::stage(&painter, &viewport, look.theme, look.catalog, &marks, None);
            caption(ui, look, below, N_ROWS, &frame.caption);
        });
    });
    image.to_png()
}
