//! The room that a run's watch table takes.

use egui::Ui;

use crate::{
    figure::{Run, Watch, watches},
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
            watches(run).for_each(|watch| room.widen(ui, model.look, &watch));
            room
        });
        room.widen(ui, model.look, now);
        room
    }
}
