//! A place on a sheet, and the places of a method's part of a figure.

use super::ViewId;

/// A rectangle, in points; y goes down.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Slot {
    pub min: [f32; 2],
    pub max: [f32; 2],
}

/// Of a drawing's width and height.
const INSET: [f32; 2] = [0.27, 0.4];

impl Slot {
    pub const fn new(min: [f32; 2], size: [f32; 2]) -> Self {
        let max = [min[0] + size[0], min[1] + size[1]];
        Self { min, max }
    }

    pub const fn size(&self) -> [f32; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    /// A small picture of this shape in the lower right corner, so far from the edges.
    pub fn inset(&self, natural: [f32; 2], gap: f32) -> Self {
        let [width, height] = [0, 1].map(|i| INSET[i] * self.size()[i]);
        let part = (width / natural[0]).min(height / natural[1]);
        let size = natural.map(|side| (part * side).round());
        Self::new([0, 1].map(|i| self.max[i] - gap - size[i]), size)
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

/// Between a drawing and what stands beside it, or under it where nothing does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Boundary {
    pub is_upright: bool,
    pub gap: Slot,
    /// How wide, or high, that is.
    pub size: f32,
}

impl ColumnLayout {
    pub fn boundary(&self) -> Option<Boundary> {
        let [(_, drawing), others @ ..] = &self.views[..] else {
            return None;
        };
        [0, 1].into_iter().find_map(|i| {
            let beyond = others.iter().map(|(_, slot)| slot);
            let beyond = || beyond.clone().filter(|slot| slot.min[i] >= drawing.max[i]);
            let first = beyond().map(|slot| slot.min[i]).reduce(f32::min)?;
            let last = beyond().map(|slot| slot.max[i]).reduce(f32::max)?;
            let mut gap = *drawing;
            (gap.min[i], gap.max[i]) = (drawing.max[i], first);
            Some(Boundary {
                is_upright: i == 0,
                gap,
                size: last - first,
            })
        })
    }

    pub fn over(&self, id: ViewId) -> impl Iterator<Item = Slot> {
        let under = self.slot(id).unwrap_or_default();
        let others = self.views.iter().filter(move |(of, _)| *of != id);
        let slots = others.map(|&(_, slot)| slot);
        slots.filter(move |slot| {
            (0..2).all(|i| slot.min[i] < under.max[i] && under.min[i] < slot.max[i])
        })
    }

    /// Does a view lie over another one?
    pub fn overlaps(&self) -> bool {
        let mut views = self.views.iter();
        views.any(|&(id, _)| self.over(id).next().is_some())
    }

    /// Moves a view that has a slot.
    pub fn put(&mut self, id: ViewId, to: Slot) {
        let mut views = self.views.iter_mut();
        if let Some((_, slot)) = views.find(|(of, _)| *of == id) {
            *slot = to;
        }
    }

    pub fn slot(&self, id: ViewId) -> Option<Slot> {
        let found = self.views.iter().find(|(of, _)| *of == id);
        found.map(|&(_, slot)| slot)
    }
}
