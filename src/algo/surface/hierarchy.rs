//! Boxes around boxes: most triangles are never asked.
//!
//! ```text
//!   ┌───────────────┐            A ray that misses a box misses all that is in it; one that has found something
//!   │ ┌───┐  ┌────┐ │  ───►      nearer than a box begins need not look into it. Which triangles go together is settled
//!   │ │△ △│  │△  △│ │            by the surfaces of their boxes ([`box_division`](super::box_division)): the chance that a ray
//!   │ └───┘  └────┘ │            which hits the outer box hits an inner one.
//!   └───────────────┘
//! ```
//!
//! 1. Of four boxes side by side those are kept that the ray meets nearer than what it has found; the nearest is opened first.
//! 2. The triangles of a last box are asked: roughly whether the ray passes by ([`RoughEdges`]), and where this is not
//!    certain in the same way as by [`RayCasting`](super::RayCasting).
//!
//! *The same answer*: all that is done in f32 errs on the safe side, as its files show: no box is passed by that holds what is hit
//! ([`FourBoxes`]), no triangle that is hit is taken for missed, and no box begins beyond the t that is told of what is in it,
//! rounding and all ([`RayTriangle::reach`]).

use std::convert::Infallible;

use crate::trace::{Real, Told};

use super::{
    Ray, RayCastingOutput, RayHit, Rays, Surfaces,
    box_division::{Boxed, Division, MOST_WAITING, divide},
    near_one::NearOne,
    ray_casting::ray_triangles,
    ray_plane::{RayTriangle, RoughEdges, RoughLine},
    rounded_box::{Contents, FourBoxes, RayInBoxes, RoundedBox},
};

/// Enough for some 100,000 triangles.
const FEW_WAITING: usize = 40;

/// Boxes that wait, the nearest last: where each begins, and its number.
struct Waiting<const N: usize> {
    boxes: [(f32, u32); N],
    n: usize,
}

/// Triangles in boxes in boxes.
pub struct Hierarchy {
    near: NearOne,
    nodes: Vec<FourBoxes>,
    most_waiting: usize,
    /// Those that can be seen at all, in the order of the last boxes.
    edges: Vec<RoughEdges>,
    triangles: Vec<RayTriangle>,
}

impl<const N: usize> Waiting<N> {
    const NONE: Self = Self {
        boxes: [(0.0, 0); N],
        n: 0,
    };

    /// Do all that wait begin there, or behind?
    #[inline(always)]
    fn are_behind(&self, begins: f32) -> bool {
        self.n == 0 || self.boxes[self.n - 1].0 >= begins
    }

    #[inline(always)]
    fn put(&mut self, begins: f32, number: u32) {
        let mut k = self.n;
        while k > 0 && self.boxes[k - 1].0 < begins {
            self.boxes[k] = self.boxes[k - 1];
            k -= 1;
        }
        self.boxes[k] = (begins, number);
        self.n += 1;
    }

    /// The nearest, if it begins within a limit; what begins beyond goes.
    #[inline(always)]
    fn nearest(&mut self, limit: f32) -> Option<u32> {
        while self.n > 0 {
            self.n -= 1;
            let (begins, number) = self.boxes[self.n];
            if begins <= limit {
                return Some(number);
            }
        }
        None
    }
}

impl Hierarchy {
    /// Around all triangles that can be seen.
    #[must_use]
    pub fn new(surfaces: &Surfaces) -> Self {
        let near = NearOne::of(surfaces);
        let surfaces = &near.surfaces;
        let shown = ray_triangles(surfaces).filter(RayTriangle::is_shown);
        let shown: Vec<RayTriangle> = shown.collect();
        let eye_z = Rays::of(surfaces).through([0, 0]).origin[2];
        let boxed = (0..).zip(&shown).map(|(place, triangle)| {
            let bounds = RoundedBox::around(triangle.reach(surfaces, eye_z));
            Boxed::new(bounds, place)
        });
        let mut boxed: Vec<Boxed> = boxed.collect();
        let Division {
            nodes,
            most_waiting,
        } = divide(&mut boxed);
        let triangles = boxed.iter().map(|one| shown[one.place as usize]);
        let triangles: Vec<RayTriangle> = triangles.collect();
        Self {
            nodes,
            most_waiting,
            edges: triangles.iter().map(RoughEdges::new).collect(),
            triangles,
            near,
        }
    }

    /// What a ray of the camera hits first, and how many triangles were asked, be it roughly.
    #[must_use]
    pub fn cast(&self, surfaces: &Surfaces, rays: &Rays, ray: &Ray) -> (Option<RayHit>, u64) {
        self.cast_over::<f64>(surfaces, rays, ray)
    }

    #[inline]
    fn cast_over<R: Real>(
        &self,
        surfaces: &Surfaces,
        rays: &Rays,
        ray: &Ray,
    ) -> (Option<RayHit>, u64) {
        if self.near.is_given() {
            return self.cast_near::<R>(surfaces, rays, ray);
        }
        let surfaces = &self.near.surfaces;
        let (rays, ray) = (Rays::of(surfaces), self.near.ray(ray));
        let (hit, n_asked) = self.cast_near::<R>(surfaces, &rays, &ray);
        (self.near.given_nearest(hit), n_asked)
    }

    #[inline]
    fn cast_near<R: Real>(
        &self,
        surfaces: &Surfaces,
        rays: &Rays,
        ray: &Ray,
    ) -> (Option<RayHit>, u64) {
        // A short list is ready sooner than a long one.
        if self.most_waiting <= FEW_WAITING {
            self.descend::<R, FEW_WAITING>(surfaces, rays, ray)
        } else {
            self.descend::<R, MOST_WAITING>(surfaces, rays, ray)
        }
    }

    /// A ray for every pixel: what [`RayCasting`](super::RayCasting) answers, but for how many were asked.
    #[must_use]
    pub fn picture(&self, surfaces: &Surfaces) -> RayCastingOutput {
        let on = |_| Told::<Infallible>::Continue(());
        let Told::Continue(picture) = self.picture_while::<f64, _>(surfaces, on);
        picture
    }

    /// [`Hierarchy::picture`] over the scalar `R`, as long as what is told how many triangles a ray has asked lets it go on. What is asked
    /// roughly, in f32, is not counted: as guards are not, it decides nothing.
    ///
    /// # Errors
    /// What it was stopped for.
    pub fn picture_while<R: Real, S>(
        &self,
        surfaces: &Surfaces,
        mut goes_on: impl FnMut(u64) -> Told<S>,
    ) -> Told<S, RayCastingOutput> {
        let rays = Rays::of(surfaces);
        let mut output = RayCastingOutput::empty(surfaces);
        let [width, height] = surfaces.size();
        for row in 0..height {
            for column in 0..width {
                let pixel = [column, row];
                let (hit, n_asked) = self.cast_over::<R>(surfaces, &rays, &rays.through(pixel));
                output.n_asked += n_asked;
                output.see(pixel, hit);
                goes_on(n_asked)?;
            }
        }
        Told::Continue(output)
    }

    /// From the outermost boxes inward.
    #[inline]
    fn descend<R: Real, const N: usize>(
        &self,
        surfaces: &Surfaces,
        rays: &Rays,
        ray: &Ray,
    ) -> (Option<RayHit>, u64) {
        let (mut nearest, mut n_asked) = (None, 0);
        let mut limit = f32::INFINITY;
        let line = RoughLine::new(surfaces.sight_line(ray.at(1.0)));
        let in_boxes = RayInBoxes::new(ray);
        let mut waiting = Waiting::<N>::NONE;
        let mut contents = Contents::boxes(0);
        if self.nodes.is_empty() {
            return (None, 0);
        }
        loop {
            if contents.are_boxes() {
                let place = contents.first;
                let node = &self.nodes[place as usize];
                let (from, mut met) = node.met(&in_boxes, limit);
                if met.is_power_of_two() {
                    let i = met.trailing_zeros() as usize & 3;
                    if waiting.are_behind(from[i]) {
                        contents = node.contents[i];
                        continue;
                    }
                }
                while met != 0 {
                    let i = met.trailing_zeros() & 3;
                    met &= met - 1;
                    waiting.put(from[i as usize], 4 * place + i);
                }
            } else {
                let range = contents.range();
                n_asked += range.len() as u64;
                for i in range {
                    if self.edges[i].are_missed(&line) {
                        continue;
                    }
                    let triangle = &self.triangles[i];
                    let found = triangle.ask::<R>(surfaces, rays, ray);
                    if let Some(hit) = found.hit::<R>(triangle.id, rays)
                        && hit.is_nearer::<R>(nearest.as_ref())
                    {
                        limit = RayInBoxes::limit(hit.t);
                        nearest = Some(hit);
                    }
                }
            }
            let Some(number) = waiting.nearest(limit) else {
                return (nearest, n_asked);
            };
            contents = self.nodes[number as usize / 4].contents[number as usize % 4];
        }
    }
}
