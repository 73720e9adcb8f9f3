//! Which handle the pointer takes: one within reach, or one whose drawing is under it.

use super::{
    handles::{Handles, Spot, gripped},
    prelude::*,
};

/// A shaky hand finds a handle within this distance, in points.
pub const REACH: f32 = 14.0;
/// A press this near to a handle was meant for it: the view does not move.
const MISSED: f32 = 28.0;
/// Handles this near to each other fall together, and a click takes the next of them.
const TOGETHER: f32 = 3.0;

impl Handles<'_> {
    fn distance(&self, spot: &Spot, at: Pos2) -> f32 {
        self.viewport.to_screen(spot.at).distance(at)
    }

    /// The nearest within reach, and all that fall together with it. One that stays where it is takes no press from others.
    pub fn group(&self, at: Pos2) -> Vec<usize> {
        let by_distance = |a: &&Spot, b: &&Spot| {
            let [to_a, to_b] = [a, b].map(|spot| self.distance(spot, at));
            a.locked.cmp(&b.locked).then(to_a.total_cmp(&to_b))
        };
        let within = |spot: &&Spot| self.distance(spot, at) <= self.reach;
        let Some(nearest) = self.spots.iter().filter(within).min_by(by_distance) else {
            return Vec::new();
        };
        let centre = self.viewport.to_screen(nearest.at);
        let others = self
            .spots
            .iter()
            .filter(|spot| spot.index != nearest.index && spot.locked == nearest.locked)
            .filter(|spot| self.distance(spot, centre) <= TOGETHER);
        let indices = std::iter::once(nearest).chain(others);
        indices.map(|spot| spot.index).collect()
    }

    /// The one that the pointer would take: the nearest, or of what falls together the one that was taken last.
    pub fn near(&self, ui: &Ui, at: Pos2) -> Option<usize> {
        let group = self.group(at);
        let taken = self.taken(ui).filter(|i| group.contains(i));
        taken.or(group.first().copied())
    }

    /// What a press there takes hold of: a handle that may move, else the one of what is drawn there, else one that is locked.
    pub fn held(&self, ui: &Ui, at: Pos2, drawn: Option<usize>) -> Option<usize> {
        let near = self.near(ui, at);
        self.free_near(ui, at).or(drawn).or(near)
    }

    pub fn free_near(&self, ui: &Ui, at: Pos2) -> Option<usize> {
        let is_free = |&i: &usize| self.spot(i).is_some_and(|spot| !spot.locked);
        self.near(ui, at).filter(is_free)
    }

    /// The one that the keyboard is at.
    pub fn focused(&self, ui: &Ui) -> Option<usize> {
        let focused = ui.memory(egui::Memory::focused)?;
        let mut indices = self.spots.iter().map(|spot| spot.index);
        indices.find(|&i| self.id_of(i) == focused)
    }

    /// Does the one that was taken last, or has the focus, lie out of sight?
    pub fn is_lost(&self, ui: &Ui) -> bool {
        // One that has been typed has the focus.
        let meant = self.taken(ui).into_iter().chain(self.focused(ui));
        let mut spots = meant.filter_map(|i| self.spot(i));
        let room = self.viewport.rect;
        spots.any(|spot| !room.contains(self.viewport.to_screen(spot.at)))
    }

    fn taken(&self, ui: &Ui) -> Option<usize> {
        ui.data(|data| data.get_temp(self.id.with("taken")))
    }

    pub fn take(&self, ui: &Ui, spot: usize) {
        ui.data_mut(|data| data.insert_temp(self.id.with("taken"), spot));
    }

    /// The one that a click means: of what falls together, each click the next.
    pub fn clicked(&self, ui: &Ui, at: Pos2, is_double: bool) -> Option<usize> {
        let near = self.near(ui, at)?;
        let group = self.group(at);
        let taken = self.taken(ui).filter(|_| !is_double);
        let nth = group.iter().position(|&i| taken == Some(i));
        let next = nth.map_or(near, |nth| group[(nth + 1) % group.len()]);
        self.take(ui, next);
        Some(next)
    }

    pub fn is_about(&self, at: Pos2) -> bool {
        let mut spots = self.spots.iter();
        spots.any(|spot| self.distance(spot, at) <= MISSED)
    }

    pub fn touched(&self, ui: &Ui, canvas: &Response) -> Option<usize> {
        let pointed = canvas.hover_pos();
        let pointed = pointed.map_or(self.pointed, |at| self.held(ui, at, self.pointed));
        gripped(ui, self.id).or(pointed)
    }
}
