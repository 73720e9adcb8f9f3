//! What all of them are asked, triangles in view space before a camera, and the picture that they leave.

use std::{cmp::Ordering, ops::Range, sync::Arc};

use serde::Serialize;

use crate::geom::{Sight, ViewVolume, sign_of_three, times_power};

use super::{Tint, Viewport};

/// Triangles before a camera. All numbers are finite; a triangle's id is its place in the list.
#[derive(Clone, PartialEq, Debug)]
pub struct Surfaces {
    viewport: Viewport,
    volume: ViewVolume,
    triangles: Arc<[[[f64; 3]; 3]]>,
    /// By id; empty where all are opaque and no brightness is asked for.
    tints: Arc<[Tint]>,
    culls_backs: bool,
}

impl Surfaces {
    /// No more triangles than have an id below 2³¹.
    pub const MOST_TRIANGLES: usize = i32::MAX as usize;

    /// A size as of [`Viewport::new`]; triangles counter-clockwise from outside. `None` where the size or the number is out of range,
    /// or a coordinate is not finite.
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
            tints: Arc::default(),
            culls_backs,
        })
    }

    /// The same with a tint for each of them; `None` where there are not as many.
    #[must_use]
    pub fn with_tints(self, tints: impl Into<Arc<[Tint]>>) -> Option<Self> {
        let tints = tints.into();
        (tints.len() == self.triangles.len()).then_some(Self { tints, ..self })
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

    /// Is a picture in brightness asked for?
    #[must_use]
    pub fn is_tinted(&self) -> bool {
        !self.tints.is_empty()
    }

    /// Paper for a picture in brightness; no pixel of it where no surface has a tint.
    #[must_use]
    pub fn paper(&self) -> Vec<f64> {
        let n_pixels = if self.is_tinted() { self.n_pixels() } else { 0 };
        vec![Tint::PAPER; n_pixels]
    }

    /// How a triangle looks.
    #[must_use]
    pub fn tint(&self, id: u32) -> Option<Tint> {
        self.tints.get(id as usize).copied()
    }

    /// Is what shows its back left out?
    #[must_use]
    pub const fn culls_backs(&self) -> bool {
        self.culls_backs
    }

    /// The same, backs and all.
    #[must_use]
    pub fn with_backs(&self) -> Self {
        Self {
            culls_backs: false,
            ..self.clone()
        }
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
        let ids = ids.start.min(to)..to;
        Self {
            tints: self.tints.get(ids.clone()).unwrap_or_default().into(),
            triangles: self.triangles[ids].into(),
            ..self.clone()
        }
    }

    /// All lengths times 2 to the power of an exponent, by which none becomes infinite.
    pub(super) fn scaled(&self, exponent: i32) -> Self {
        let corner = |at: &[f64; 3]| times_power(*at, exponent);
        let triangles = self.triangles.iter().map(|t| t.each_ref().map(corner));
        Self {
            volume: self.volume.times_power(exponent),
            triangles: triangles.collect(),
            ..self.clone()
        }
    }

    /// Exact: not where the triangle is edge-on, nor where it shows its back and such are left out.
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

    /// Which way points turn as they are seen, exactly: `Greater` counter-clockwise, `Equal` in one line, or one plane with the eye.
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

    /// From the first of two columns up to, but without, the other.
    pub(super) fn put_row(&mut self, row: u32, [first, end]: [u32; 2], id: u32) {
        let places = self.place([first, row])..self.place([end, row]);
        self.ids[places].fill(id as i32);
    }
}
