//! The height that the run's captions take.

use egui::Ui;

use crate::{figure::sentences, widgets::height_for_all};

use super::{model::Model, run_room::RunRoom};

/// A height.
#[derive(Default)]
pub struct CaptionRoom(RunRoom<f32>);

impl CaptionRoom {
    /// The height that every caption of the runs on stage fits into, in lines of at most `width` points.
    pub fn height(&mut self, model: &Model<'_>, ui: &Ui, width: f32) -> f32 {
        *self.0.get(model, ui, width, || {
            let said = model.playback.runs().flat_map(sentences);
            height_for_all(ui.painter(), model.look, said, width)
        })
    }
}
