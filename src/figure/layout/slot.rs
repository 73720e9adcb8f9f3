//! A place on a sheet.

/// A rectangle, in points; y goes down.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Slot {
    /// Left and top.
    pub min: [f32; 2],
    /// Right and bottom.
    pub max: [f32; 2],
}

impl Slot {
    /// Of this size, from its corner at the left and top.
    #[must_use]
    pub const fn new(min: [f32; 2], size: [f32; 2]) -> Self {
        let max = [min[0] + size[0], min[1] + size[1]];
        Self { min, max }
    }

    /// Width and height.
    #[must_use]
    pub const fn size(&self) -> [f32; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    /// Cuts a strip of this height off the top.
    pub(super) fn take_top(&mut self, height: f32) -> Self {
        let y = (self.min[1] + height.min(self.size()[1])).round();
        let top = Self {
            max: [self.max[0], y],
            ..*self
        };
        self.min[1] = y;
        top
    }

    /// Cuts a strip of this height off the bottom.
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
