//! What is found once for a run and kept until another run asks for more: the room of its captions and its watch tables.

use egui::Ui;

use crate::{paint::ThemeKind, text::Lang};

use super::model::Model;

/// What was found, and for what.
pub struct RunRoom<T> {
    known: Option<(Asked, T)>,
}

impl<T> Default for RunRoom<T> {
    fn default() -> Self {
        Self { known: None }
    }
}

/// What it depends on.
#[derive(Clone, Copy, PartialEq)]
struct Asked {
    recording: u64,
    width: f32,
    lang: Lang,
    theme: ThemeKind,
}

impl<T> RunRoom<T> {
    /// What `find` found for the runs on stage, in lines of `width` points. While a handle is dragged it stays as it was:
    /// nothing changes its scale under the pointer.
    pub fn get(
        &mut self,
        model: &Model<'_>,
        ui: &Ui,
        width: f32,
        find: impl FnOnce() -> T,
    ) -> &mut T {
        let asked = Asked {
            recording: model.playback.recording(),
            width,
            lang: model.settings.lang,
            theme: model.settings.theme,
        };
        let is_held = ui.input(|input| input.pointer.any_down());
        let is_good = |known: Asked| {
            let recording = known.recording;
            known == asked || (is_held && Asked { recording, ..asked } == known)
        };
        let known = self.known.take().filter(|(known, _)| is_good(*known));
        let (_, found) = self.known.insert(known.unwrap_or_else(|| (asked, find())));
        found
    }
}
