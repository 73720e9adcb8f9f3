//! A line of sight through every pixel's middle: of all triangles that it meets the nearest is seen.
//!
//! ```text
//!          raster     B       A          C
//!             │      ╱        │         ╲        of every triangle's plane:
//!   eye ●─────┼─────●─────────○──────────○──►          t = −(n·o + d) / (n·r)
//!             │   ╱ t = 1.9   │ 2.9    3.9 ╲    parallel: n·r = 0. t < 0: behind the eye.
//!           t = 1                               Else: does the point lie in the triangle?
//! ```
//!
//! *Conventions*: near and far are closed; of two that are as near the lower id is seen; the top-left rule settles edges; depth is
//! (z/w + 1) / 2 of the hit. *Exact*: whether a ray passes inside ([`RayTriangle`](super::ray_plane)). *Bound*: for each pixel its ray,
//! each triangle, and its end; the end. *Cost*: rays times triangles; a question is 6 ×, 5 +, 1 ÷ and 3 comparisons, and where those let it
//! pass 3 determinants. What belongs to a triangle alone is not counted.
//!
//! *Source*: A. Appel, "Some techniques for shading machine renderings of solids", AFIPS Spring Joint Computer Conference 32, 1968,
//! pp. 37–45.
//!
//! ```
//! use clipscope::{
//!     algo::surface::{RayCasting, RayCastingInput, Surfaces},
//!     geom::ViewVolume,
//!     trace::silent,
//! };
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?;
//! let wall = |z: f64| [[-20.0, -20.0, z], [20.0, -20.0, z], [0.0, 40.0, z]];
//! let surfaces = Surfaces::new([2, 2], volume, [wall(-5.0), wall(-2.0)], false).expect("finite");
//! let output = silent::<RayCasting>(&RayCastingInput { surfaces, pixel: None });
//! assert_eq!(output.picture.ids(), [1, 1, 1, 1]);
//! assert_eq!(output.n_asked, 8);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::trace::{Method, Real, Tell, Told};

use super::{
    Picture, PlaneHit, Ray, RayHit, Rays, Surfaces, near_one::NearOne, ray_plane::RayTriangle,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct RayCasting;

/// What is asked, and by which rays.
#[derive(Clone, PartialEq, Debug)]
pub struct RayCastingInput {
    /// What is to be seen.
    pub surfaces: Surfaces,
    /// The only pixel that is asked for, where one is named.
    pub pixel: Option<[u32; 2]>,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum RayCastingEvent {
    /// The next pixel's turn.
    Pixel {
        /// Column and row.
        pixel: [u32; 2],
        /// Through its middle.
        #[serde(flatten)]
        ray: Ray,
    },
    /// A triangle is asked.
    Ask {
        /// Which.
        id: u32,
        /// Where its plane is met, and what that tells.
        #[serde(flatten)]
        found: PlaneHit,
        /// The depth there, where the triangle is hit.
        depth: Option<f64>,
        /// Is it nearer than all before it?
        nearest: bool,
    },
    /// All have been asked for this pixel.
    Seen {
        /// Column and row.
        pixel: [u32; 2],
        /// The nearest that is hit.
        hit: Option<RayHit>,
        /// How many questions there have been, for all pixels.
        n_asked: u64,
    },
    /// No pixel is left.
    Done,
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct RayCastingOutput {
    /// Whose each pixel is.
    #[serde(rename = "ids")]
    pub picture: Picture,
    /// Of the nearest hit of each pixel, row by row; not finite where nothing is hit.
    pub depth: Vec<f64>,
    /// How many triangles were asked, for all pixels together.
    #[serde(skip)]
    pub n_asked: u64,
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct RayCastingHeld {
    /// Picture, depths and questions of all pixels that are done; after the end, the answer.
    pub so_far: RayCastingOutput,
    /// The nearest hit of the ray in hand, or of the last one.
    pub nearest: Option<RayHit>,
}

impl Method for RayCasting {
    type Input = RayCastingInput;
    type Held = RayCastingHeld;
    type Output = RayCastingOutput;
    type Event = RayCastingEvent;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        RayCastingHeld {
            so_far: RayCastingOutput::empty(&input.surfaces),
            nearest: None,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use RayCastingEvent as Event;
        let near = NearOne::of(&input.surfaces);
        let surfaces = &near.surfaces;
        let rays = Rays::of(surfaces);
        let triangles: Vec<RayTriangle> = ray_triangles(surfaces).collect();
        for pixel in input.pixels() {
            let ray = rays.through(pixel);
            let mut nearest: Option<RayHit> = None;
            held.nearest = nearest;
            let told = if near.is_given() {
                ray
            } else {
                near.given_ray(pixel)
            };
            tell.tell(held, Event::Pixel { pixel, ray: told })?;
            for triangle in &triangles {
                let (id, found) = (triangle.id, triangle.ask::<R>(surfaces, &rays, &ray));
                let hit = found.hit::<R>(id, &rays);
                let is_nearest = hit.is_some_and(|hit| hit.is_nearer::<R>(nearest.as_ref()));
                if is_nearest {
                    nearest = hit;
                    held.nearest = near.given_nearest(nearest);
                }
                let found = if near.is_given() && triangle.by == 0 {
                    found
                } else {
                    near.given_hit(&found, triangle.by)
                };
                let event = Event::Ask {
                    id,
                    found,
                    depth: hit.map(|hit| hit.depth),
                    nearest: is_nearest,
                };
                tell.tell(held, event)?;
            }
            held.so_far.n_asked += triangles.len() as u64;
            held.so_far.see(pixel, nearest);
            let event = Event::Seen {
                pixel,
                hit: near.given_nearest(nearest),
                n_asked: held.so_far.n_asked,
            };
            tell.tell(held, event)?;
        }
        tell.tell(held, Event::Done)
    }

    fn output(held: Self::Held) -> Self::Output {
        held.so_far
    }

    fn max_events(input: &Self::Input) -> usize {
        let n_pixels = input.pixel.map_or(input.surfaces.n_pixels(), |_| 1);
        1 + n_pixels * (2 + input.surfaces.triangles().len())
    }
}

impl RayCastingInput {
    fn pixels(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let [width, height] = self.surfaces.size();
        let wanted = self.pixel;
        let all = (0..height).flat_map(move |row| (0..width).map(move |column| [column, row]));
        all.filter(move |pixel| wanted.is_none_or(|wanted| wanted == *pixel))
    }
}

impl RayCastingOutput {
    pub(super) fn empty(surfaces: &Surfaces) -> Self {
        Self {
            picture: Picture::empty(surfaces.size()),
            depth: vec![f64::INFINITY; surfaces.n_pixels()],
            n_asked: 0,
        }
    }

    pub(super) fn see(&mut self, pixel: [u32; 2], hit: Option<RayHit>) {
        if let Some(RayHit { id, depth, .. }) = hit {
            let place = self.picture.place(pixel);
            self.depth[place] = depth;
            self.picture.put(pixel, id);
        }
    }
}

pub(super) fn ray_triangles(surfaces: &Surfaces) -> impl Iterator<Item = RayTriangle> + use<'_> {
    let numbered = surfaces.ids().zip(surfaces.triangles());
    numbered.map(|(id, corners)| RayTriangle::new(surfaces, id, corners))
}
