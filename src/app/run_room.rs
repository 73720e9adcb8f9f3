//! What is found once for a run and kept until another run asks for more, such as the room of its captions and of its watch
//! tables, and why what was clicked was kept or dropped.

use crate::{labs::Verdict, widgets::WatchRoom};

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

#[derive(Default)]
pub struct WatchRooms([RunRoom<WatchRoom>; 2]);

impl WatchRooms {
    /// The room for the table of the method in this column at all steps, `now` among them: while a handle is dragged it
    /// grows.
    pub fn of(&mut self, on_stage: OnStage<'_>, ui: &Ui, column: usize, now: &Watch) -> &WatchRoom {
        // What a table wants does not depend on the width that it has.
        let room = self.0[column].get(on_stage, ui, 0.0, || {
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

#[derive(Default)]
pub struct Verdicts {
    about: Option<(Link, usize)>,
    room: RunRoom<Option<Verdict>>,
}

impl Verdicts {
    pub fn of(
        &mut self,
        on_stage: OnStage<'_>,
        ui: &Ui,
        (scene, about): (&Scene, Link),
    ) -> Option<&Verdict> {
        let now = (about, on_stage.0.transport.position());
        if self.about.replace(now) != Some(now) {
            self.room = RunRoom::default();
        }
        let verdict = || scene.document().verdict(about, (on_stage.0.main(), now.1));
        self.room.get(on_stage, ui, 0.0, verdict).as_ref()
    }
}
