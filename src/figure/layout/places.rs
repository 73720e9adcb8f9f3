//! A place on a sheet, and the places of a method's part of a figure.

use super::ViewId;

/// A rectangle, in points; y goes down.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Slot {
    pub min: [f32; 2],
    pub max: [f32; 2],
}

impl Slot {
    pub const fn new(min: [f32; 2], size: [f32; 2]) -> Self {
        let max = [min[0] + size[0], min[1] + size[1]];
        Self { min, max }
    }

    pub const fn size(&self) -> [f32; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    pub(super) fn take_top(&mut self, height: f32) -> Self {
        let y = (self.min[1] + height.min(self.size()[1])).round();
        let top = Self {
            max: [self.max[0], y],
            ..*self
        };
        self.min[1] = y;
        top
    }

    pub(super) fn take_bottom(&mut self, height: f32) -> Self {
        let y = (self.max[1] - height.min(self.size()[1])).round();
        let bottom = Self {
            min: [self.min[0], y],
            ..*self
        };
        self.max[1] = y;
        bottom
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct ColumnLayout {
    pub whole: Slot,
    pub name: Slot,
    pub views: Vec<(ViewId, Slot)>,
    /// The step's sentence, the hairline being its upper edge.
    pub caption: Slot,
    pub cost: Slot,
}

impl ColumnLayout {
    pub fn over(&self, id: ViewId) -> impl Iterator<Item = Slot> {
        let under = self.slot(id).unwrap_or_default();
        let others = self.views.iter().filter(move |(of, _)| *of != id);
        let slots = others.map(|&(_, slot)| slot);
        slots.filter(move |slot| {
            (0..2).all(|i| slot.min[i] < under.max[i] && under.min[i] < slot.max[i])
        })
    }

    pub fn slot(&self, id: ViewId) -> Option<Slot> {
        let found = self.views.iter().find(|(of, _)| *of == id);
        found.map(|&(_, slot)| slot)
    }
}
