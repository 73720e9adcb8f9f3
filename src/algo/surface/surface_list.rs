//! What all of them are asked: triangles in view space, who looks at them, and with how many pixels.

use std::{cmp::Ordering, ops::Range, sync::Arc};

use crate::geom::{Sight, ViewVolume, sign_of_three};

use super::Viewport;

/// Triangles before a camera. All numbers are finite; a triangle's id is its place in the list.
#[derive(Clone, PartialEq, Debug)]
pub struct Surfaces {
    viewport: Viewport,
    volume: ViewVolume,
    triangles: Arc<[[[f64; 3]; 3]]>,
    culls_backs: bool,
}

impl Surfaces {
    /// No more triangles than have an id below 2³¹.
    pub const MOST_TRIANGLES: usize = i32::MAX as usize;

    /// Columns and rows, each from 1 to [`Viewport::MAX_SIDE`]; what is seen; triangles in view space, counter-clockwise as
    /// seen from outside; and whether those that show their back are left out. `None` where a side is none, a coordinate is not
    /// finite, or there are too many.
    #[must_use]
    pub fn new(
        size: [u32; 2],
        volume: ViewVolume,
        triangles: impl Into<Arc<[[[f64; 3]; 3]]>>,
        culls_backs: bool,
    ) -> Option<Self> {
        let triangles = triangles.into();
        let coordinates = triangles.as_flattened().as_flattened();
        let is_usable =
            triangles.len() <= Self::MOST_TRIANGLES && coordinates.iter().all(|x| x.is_finite());
        let viewport = Viewport::new(size, Viewport::ANSWER_BITS)?;
        is_usable.then_some(Self {
            viewport,
            volume,
            triangles,
            culls_backs,
        })
    }

    /// The pixels.
    #[must_use]
    pub const fn viewport(&self) -> &Viewport {
        &self.viewport
    }

    /// Columns and rows.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.viewport.size()
    }

    /// As many pixels as there are.
    #[must_use]
    pub fn n_pixels(&self) -> usize {
        self.size().map(|side| side as usize).iter().product()
    }

    /// What is seen: it fills the picture.
    #[must_use]
    pub const fn volume(&self) -> &ViewVolume {
        &self.volume
    }

    /// In view space.
    #[must_use]
    pub fn triangles(&self) -> &[[[f64; 3]; 3]] {
        &self.triangles
    }

    /// Their ids, in order.
    pub fn ids(&self) -> impl Iterator<Item = u32> + use<> {
        (0..).take(self.triangles.len())
    }

    /// Is what shows its back left out?
    #[must_use]
    pub const fn culls_backs(&self) -> bool {
        self.culls_backs
    }

    /// The same with no more than the first so many triangles.
    #[must_use]
    pub fn first(&self, n_triangles: usize) -> Self {
        self.part(0..n_triangles)
    }

    /// The same with some of its triangles alone: their ids are counted from 0 anew.
    #[must_use]
    pub fn part(&self, ids: Range<usize>) -> Self {
        let to = ids.end.min(self.triangles.len());
        Self {
            triangles: self.triangles[ids.start.min(to)..to].into(),
            ..self.clone()
        }
    }

    /// Can anything be seen of this triangle, as far as its own turn tells? Not where it is edge-on, nor where it shows its back
    /// and such are left out. Exact.
    #[must_use]
    pub fn shows(&self, triangle: &[[f64; 3]; 3]) -> bool {
        self.shown_turn(triangle) != Ordering::Equal
    }

    /// Which way it turns; `Equal` where it is not shown.
    pub(super) fn shown_turn(&self, triangle: &[[f64; 3]; 3]) -> Ordering {
        match self.turn(*triangle) {
            Ordering::Less if self.culls_backs => Ordering::Equal,
            turn => turn,
        }
    }

    /// Which way three points turn as they are seen: `Greater` counter-clockwise, `Equal` where they lie in one line or one plane with
    /// the eye. Exact on the given coordinates.
    #[must_use]
    pub fn turn(&self, points: [[f64; 3]; 3]) -> Ordering {
        sign_of_three(points.map(|point| self.sight_line(point))).reverse()
    }

    /// Along the line from the eye through a point, as a vector; of a parallel camera, (x, y, −1).
    #[must_use]
    pub const fn sight_line(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self.volume.sight() {
            Sight::Perspective => [x, y, z],
            Sight::Parallel => [x, y, -1.0],
        }
    }

    /// Who looks, as a point or, of a parallel camera, a direction: the last coordinate is 1 or 0.
    #[must_use]
    pub const fn eye(&self) -> [f64; 4] {
        match self.volume.sight() {
            Sight::Perspective => [0.0, 0.0, 0.0, 1.0],
            Sight::Parallel => [0.0, 0.0, 1.0, 0.0],
        }
    }
}
