//! What is found once for a run and kept until another run asks for more, such as the room of its captions and of its watch
//! tables.

use crate::widgets::WatchRoom;

use super::{playback::Playback, prelude::*};

pub type OnStage<'a> = (&'a Playback, Look<'a>);

pub struct RunRoom<T> {
    known: Option<(Asked, T)>,
}

impl<T> Default for RunRoom<T> {
    fn default() -> Self {
        Self { known: None }
    }
}

#[derive(Clone, Copy, PartialEq)]
struct Asked {
    recording: u64,
    width: f32,
    lang: Lang,
    theme: ThemeKind,
    text_scale: f32,
}

impl<T> RunRoom<T> {
    /// What `find` found for the runs on stage, in lines of `width` points. While a handle is dragged it stays as it was:
    /// nothing changes its scale under the pointer.
    pub fn get(
        &mut self,
        (playback, look): OnStage<'_>,
        ui: &Ui,
        width: f32,
        find: impl FnOnce() -> T,
    ) -> &mut T {
        let asked = Asked {
            recording: playback.recording,
            width,
            lang: look.catalog.lang(),
            theme: look.theme.kind,
            text_scale: look.theme.text_scale,
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

/// The same of each method on the stage.
pub struct OfColumns<T>(Vec<RunRoom<T>>);

impl<T> Default for OfColumns<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> OfColumns<T> {
    pub fn at(&mut self, column: usize) -> &mut RunRoom<T> {
        let n_columns = self.0.len().max(column + 1);
        self.0.resize_with(n_columns, RunRoom::default);
        &mut self.0[column]
    }
}

#[derive(Default)]
pub struct WatchRooms(OfColumns<WatchRoom>);

impl WatchRooms {
    /// The room for the table of the method in this column at all steps, `now` among them: while a handle is dragged it
    /// grows.
    pub fn of(&mut self, on_stage: OnStage<'_>, ui: &Ui, column: usize, now: &Watch) -> &WatchRoom {
        // What a table wants does not depend on the width that it has.
        let room = self.0.at(column).get(on_stage, ui, 0.0, || {
            let mut room = WatchRoom::default();
            for watch in on_stage.0.watches(column) {
                room.widen(ui, on_stage.1, &watch);
            }
            room
        });
        room.widen(ui, on_stage.1, now);
        room
    }
}
