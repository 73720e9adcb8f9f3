//! The height that the run's captions take: found once, and kept until another run or another width asks for more.

use egui::Ui;

use crate::{figure::sentences, paint::ThemeKind, text::Lang, widgets::height_for_all};

use super::model::Model;

/// A height, and what it was found for.
#[derive(Default)]
pub struct CaptionRoom {
    known: Option<(Asked, f32)>,
}

/// What the height of captions depends on.
#[derive(Clone, Copy, PartialEq)]
struct Asked {
    recording: u64,
    width: f32,
    lang: Lang,
    theme: ThemeKind,
}

impl CaptionRoom {
    /// The height that every caption of the runs on stage fits into, in lines of at most `width` points. While a handle
    /// is dragged it stays as it was: the drawing does not change its scale under the pointer.
    pub fn height(&mut self, model: &Model<'_>, ui: &Ui, width: f32) -> f32 {
        let asked = Asked {
            recording: model.playback.recording(),
            width,
            lang: model.settings.lang,
            theme: model.settings.theme,
        };
        let is_held = ui.input(|input| input.pointer.any_down());
        if let Some((known, height)) = self.known {
            let recording = known.recording;
            if asked == known || (is_held && Asked { recording, ..asked } == known) {
                return height;
            }
        }
        let said = model.playback.runs().flat_map(sentences);
        let height = height_for_all(ui.painter(), model.look, said, width);
        self.known = Some((asked, height));
        height
    }
}
