//! The picture that surfaces leave: whose each pixel is.

use serde::Serialize;

/// Ids row by row from the top left.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
#[serde(transparent)]
pub struct Picture {
    ids: Vec<i32>,
    #[serde(skip)]
    width: u32,
}

impl Picture {
    /// Where no surface is.
    pub const BACKGROUND: i32 = -1;

    /// Nothing but background.
    #[must_use]
    pub fn empty([width, height]: [u32; 2]) -> Self {
        let n = width as usize * height as usize;
        Self {
            ids: vec![Self::BACKGROUND; n],
            width,
        }
    }

    /// Of all pixels: the id of the surface there, or [`Picture::BACKGROUND`].
    #[must_use]
    pub fn ids(&self) -> &[i32] {
        &self.ids
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        let height = self.ids.len() as u32 / self.width.max(1);
        [self.width, height]
    }

    /// The surface at a pixel, which is one of the picture's.
    #[must_use]
    pub fn at(&self, pixel: [u32; 2]) -> Option<u32> {
        u32::try_from(self.ids[self.place(pixel)]).ok()
    }

    /// Where a pixel stands in the list.
    #[must_use]
    pub const fn place(&self, [column, row]: [u32; 2]) -> usize {
        row as usize * self.width as usize + column as usize
    }

    /// The same with another id for each surface: that of the object it belongs to, say.
    #[must_use]
    pub fn renamed(&self, new: impl Fn(u32) -> u32) -> Self {
        let renamed = |&id: &i32| u32::try_from(id).map_or(id, |id| new(id) as i32);
        Self {
            ids: self.ids.iter().map(renamed).collect(),
            width: self.width,
        }
    }

    pub(super) fn put(&mut self, pixel: [u32; 2], id: u32) {
        let place = self.place(pixel);
        // Ids are below 2³¹.
        self.ids[place] = id as i32;
    }
}
