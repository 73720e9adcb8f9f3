//! What was typed, done.

use egui::Pos2;

use crate::{
    labs::{Edit, Handle, place_of, written},
    text::Diagnostic,
};

use super::{
    App,
    typing::{Typing, is_held},
};

impl App {
    /// Opens the field for a handle, unless the lesson holds it in place; or closes it. It stands at the handle, or where
    /// its place was clicked.
    pub(super) fn start_typing(&mut self, handle: Option<Handle>, at: Option<Pos2>) {
        let (scene, step) = (self.history.now(), self.bookmark.step());
        let handle = handle.filter(|&handle| !is_held(step, scene, handle));
        self.stage.typing = handle.and_then(|handle| {
            let place = scene.document().position(handle)?;
            Some(Typing {
                handle,
                at,
                text: written(handle, place, self.stage.is_flat()),
                problem: None,
            })
        });
    }

    /// Puts the handle where it was typed, or says why it cannot lie there.
    pub(super) fn apply_typed(&mut self, now: f64) {
        let Some(mut typing) = self.stage.typing.take() else {
            return;
        };
        let from = self.history.now().document().position(typing.handle);
        let is_flat = self.stage.is_flat();
        let placed = from.map(|from| place_of(typing.handle, from, is_flat, &typing.text));
        let done = match placed {
            Some(Ok(to)) => self.change(Edit::Drag(typing.handle, to), None, now),
            Some(Err(problem)) => Err(problem),
            None => Ok(()),
        };
        if let Err(Diagnostic { message, .. }) = done {
            typing.problem = Some(self.catalog().message(&message));
            self.stage.typing = Some(typing);
        }
    }
}
