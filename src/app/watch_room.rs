//! What a run has for the inspector at all its steps: the room that its watch table takes, what its lines of code are about,
//! and what all there is costs.

use egui::Ui;

use crate::{
    figure::{CodeLinks, Link, Run, Watch, watches},
    labs::Verdict,
    text::Message,
    widgets::WatchRoom,
};

use super::{model::Model, run_room::RunRoom};

/// The room of each method's table.
#[derive(Default)]
pub struct WatchRooms([RunRoom<WatchRoom>; 2]);

impl WatchRooms {
    /// The room for the table of the method in this column at all steps, `now` among them: while a handle is dragged it
    /// grows.
    pub fn of(
        &mut self,
        model: &Model<'_>,
        ui: &Ui,
        (column, run): (usize, &dyn Run),
        now: &Watch,
    ) -> &WatchRoom {
        // What a table wants does not depend on the width that it has.
        let room = self.0[column].get(model, ui, 0.0, || {
            let mut room = WatchRoom::default();
            for watch in watches(run) {
                room.widen(ui, model.look, &watch);
            }
            room
        });
        room.widen(ui, model.look, now);
        room
    }
}

/// What the lines of each method's pseudocode are about: found when it is first asked for.
#[derive(Default)]
pub struct CodeLinkRooms([RunRoom<CodeLinks>; 2]);

impl CodeLinkRooms {
    /// Of the method in this column.
    pub fn of(
        &mut self,
        model: &Model<'_>,
        ui: &Ui,
        (column, run): (usize, &dyn Run),
    ) -> &CodeLinks {
        self.0[column].get(model, ui, 0.0, || CodeLinks::of(run))
    }
}

/// Why what was clicked was kept or dropped.
#[derive(Default)]
pub struct Verdicts {
    about: Option<Link>,
    room: RunRoom<Option<Verdict>>,
}

impl Verdicts {
    /// Of what is asked about in the scene on stage.
    pub fn of(&mut self, model: &Model<'_>, ui: &Ui, about: Link) -> Option<&Verdict> {
        if self.about.replace(about) != Some(about) {
            self.room = RunRoom::default();
        }
        let verdict = || model.scene.document().verdict(about, model.playback.main());
        self.room.get(model, ui, 0.0, verdict).as_ref()
    }
}

/// What each method does for all that its run is one of.
#[derive(Default)]
pub struct AllCosts([RunRoom<Option<Message>>; 2]);

impl AllCosts {
    /// Of the method in this column, in a sentence; none where the run is of all there is.
    pub fn of(&mut self, model: &Model<'_>, ui: &Ui, column: usize) -> Option<&Message> {
        let of_all = || model.scene.document().cost_of_all(column);
        self.0[column].get(model, ui, 0.0, of_all).as_ref()
    }
}
