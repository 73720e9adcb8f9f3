//! What comes to a pixel, and how much of that there has been.

use serde::Serialize;

use super::Picture;

/// What comes of one triangle at one pixel.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Fragment {
    /// Of the triangle.
    pub id: u32,
    /// Column and row.
    pub pixel: [u32; 2],
    /// (z/w + 1) / 2
    pub depth: f64,
    /// The same as the buffer stores it.
    pub new: f64,
    /// What stood there; not finite where nothing had been written.
    pub stored: f64,
    /// Whose that was, or [`Picture::BACKGROUND`].
    pub stored_id: i32,
    /// Is it written?
    pub kept: bool,
}

/// How much has been done.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct FragmentTally {
    /// Fragments so far.
    pub fragments: u64,
    /// As many of them as were written.
    pub writes: u64,
    /// Pixels that have been written at all.
    pub pixels: u64,
}

impl FragmentTally {
    pub(super) fn add(&mut self, fragment: &Fragment) {
        self.fragments += 1;
        if fragment.kept {
            self.writes += 1;
            self.pixels += u64::from(fragment.stored_id == Picture::BACKGROUND);
        }
    }
}
