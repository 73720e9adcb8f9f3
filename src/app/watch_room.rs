//! The room that a run's watch table takes: found once, and kept until another run asks for more.

use egui::Ui;

use crate::{
    figure::{Run, Watch, watches},
    paint::ThemeKind,
    text::Lang,
    widgets::WatchRoom,
};

use super::model::Model;

/// The room of each method's table, and what it was found for.
#[derive(Default)]
pub struct WatchRooms {
    known: [Option<(Asked, WatchRoom)>; 2],
}

/// What the room of a table depends on.
#[derive(Clone, Copy, PartialEq)]
struct Asked {
    recording: u64,
    lang: Lang,
    theme: ThemeKind,
}

impl WatchRooms {
    /// The room for the table of the method in this column at all steps, `now` among them. While a handle is dragged it
    /// grows, but is not found anew.
    pub fn of(
        &mut self,
        model: &Model<'_>,
        ui: &Ui,
        (column, run): (usize, &dyn Run),
        now: &Watch,
    ) -> &WatchRoom {
        let asked = Asked {
            recording: model.playback.recording(),
            lang: model.settings.lang,
            theme: model.settings.theme,
        };
        let is_held = ui.input(|input| input.pointer.any_down());
        let known = &mut self.known[column];
        let is_known = known.as_ref().is_some_and(|(known, _)| {
            let recording = known.recording;
            *known == asked || (is_held && Asked { recording, ..asked } == *known)
        });
        if !is_known {
            *known = None;
        }
        let (_, room) = known.get_or_insert_with(|| {
            let mut room = WatchRoom::default();
            watches(run).for_each(|watch| room.widen(ui, model.look, &watch));
            (asked, room)
        });
        room.widen(ui, model.look, now);
        room
    }
}
