//! A method's part of a figure.

use super::{Slot, ViewId};

/// Where everything of one method stands.
#[derive(Clone, PartialEq, Debug)]
pub struct ColumnLayout {
    /// All of the column.
    pub whole: Slot,
    /// The method's name.
    pub name: Slot,
    /// The views there is room for.
    pub views: Vec<(ViewId, Slot)>,
    /// The step's sentence, the hairline being its upper edge.
    pub caption: Slot,
    /// The cost so far.
    pub cost: Slot,
}

impl ColumnLayout {
    /// The places of views that stand on this one.
    pub fn over(&self, id: ViewId) -> impl Iterator<Item = Slot> {
        let under = self.slot(id).unwrap_or_default();
        let others = self.views.iter().filter(move |(of, _)| *of != id);
        let slots = others.map(|&(_, slot)| slot);
        slots.filter(move |slot| {
            (0..2).all(|i| slot.min[i] < under.max[i] && under.min[i] < slot.max[i])
        })
    }

    /// The place of a view; `None` where there is no room for it.
    #[must_use]
    pub fn slot(&self, id: ViewId) -> Option<Slot> {
        let found = self.views.iter().find(|(of, _)| *of == id);
        found.map(|&(_, slot)| slot)
    }
}
