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
//! 1. For each pixel: the ray from the eye through its middle, which is at t = 1 on the near plane.
//! 2. For each triangle: t, and what it tells ([`Meeting`]).
//! 3. Of all that are hit the smallest t is seen.
//!
//! *Conventions*: near and far are closed; of two that are as near the lower id is seen; the top-left rule settles edges; depth is
//! (z/w + 1) / 2 of the hit. *Exact*: whether a ray passes inside ([`RayTriangle`](super::ray_plane)). *Bound*: for each pixel
//! its ray, each triangle, and its end; the end. *Cost*: rays times triangles; of each question six multiplications, five additions and
//! a division, three comparisons, and where those let it pass three determinants. What belongs to a triangle alone is not counted.
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

use crate::trace::{Algorithm, Real};

use super::{Meeting, Picture, PlaneHit, Ray, Rays, Surfaces, ray_plane::RayTriangle};

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

/// A triangle that is met.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct RayHit {
    /// Of the triangle.
    pub id: u32,
    /// Where on the ray.
    pub t: f64,
    /// (z/w + 1) / 2 there.
    pub depth: f64,
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
#[derive(Clone, PartialEq, Debug)]
pub struct RayCastingOutput {
    /// Whose each pixel is.
    pub picture: Picture,
    /// Of the nearest hit of each pixel, row by row; not finite where nothing is hit.
    pub depth: Vec<f64>,
    /// How many triangles were asked, for all pixels together.
    pub n_asked: u64,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct RayCastingState {
    /// Picture so far; after the end, the answer.
    pub so_far: RayCastingOutput,
    /// The pixel whose turn it is, and its ray; after the end, the last one where only one is asked for.
    pub pixel: Option<([u32; 2], Ray)>,
    /// Every triangle that this ray has been asked about, in order.
    pub asked: Vec<(u32, PlaneHit)>,
    /// All that it has hit so far.
    pub hits: Vec<RayHit>,
    /// The nearest of them.
    pub nearest: Option<RayHit>,
    /// Is nothing left to do?
    pub is_done: bool,
}

impl Algorithm for RayCasting {
    type Input = RayCastingInput;
    type Output = RayCastingOutput;
    type Event = RayCastingEvent;
    type State = RayCastingState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use RayCastingEvent as Event;
        let surfaces = &input.surfaces;
        let rays = Rays::of(surfaces);
        let triangles: Vec<RayTriangle> = ray_triangles(surfaces).collect();
        let mut output = RayCastingOutput::empty(surfaces);
        for pixel in input.pixels() {
            let ray = rays.through(pixel);
            emit(Event::Pixel { pixel, ray });
            let mut nearest: Option<RayHit> = None;
            for triangle in &triangles {
                let (id, found) = (triangle.id, triangle.ask::<R>(surfaces, &rays, &ray));
                output.n_asked += 1;
                let hit = found.hit::<R>(id, &rays);
                let is_nearest = hit.is_some_and(|hit| hit.is_nearer::<R>(nearest.as_ref()));
                if is_nearest {
                    nearest = hit;
                }
                emit(Event::Ask {
                    id,
                    found,
                    depth: hit.map(|hit| hit.depth),
                    nearest: is_nearest,
                });
            }
            output.see(pixel, nearest);
            emit(Event::Seen {
                pixel,
                hit: nearest,
                n_asked: output.n_asked,
            });
        }
        emit(Event::Done);
        output
    }

    fn start(input: &Self::Input) -> Self::State {
        RayCastingState {
            so_far: RayCastingOutput::empty(&input.surfaces),
            pixel: None,
            asked: Vec::new(),
            hits: Vec::new(),
            nearest: None,
            is_done: false,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use RayCastingEvent as Event;
        match event {
            Event::Pixel { pixel, ray } => {
                state.pixel = Some((pixel, ray));
                state.asked.clear();
                state.hits.clear();
                state.nearest = None;
            }
            Event::Ask {
                id,
                found,
                depth,
                nearest,
            } => {
                state.asked.push((id, found));
                if let (Some(t), Some(depth)) = (found.t, depth) {
                    let hit = RayHit { id, t, depth };
                    state.hits.push(hit);
                    if nearest {
                        state.nearest = Some(hit);
                    }
                }
            }
            Event::Seen {
                pixel,
                hit,
                n_asked,
            } => {
                state.so_far.see(pixel, hit);
                state.so_far.n_asked = n_asked;
            }
            Event::Done => state.is_done = true,
        }
    }

    fn finish(state: &Self::State) -> Self::Output {
        state.so_far.clone()
    }

    /// For each pixel its turn, every triangle, and what is seen; the end.
    fn max_events(input: &Self::Input) -> usize {
        let n_pixels = input.pixel.map_or(input.surfaces.n_pixels(), |_| 1);
        1 + n_pixels * (2 + input.surfaces.triangles().len())
    }
}

impl RayCastingInput {
    /// Those that are asked for, row by row from the top left.
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

impl PlaneHit {
    pub(super) fn hit<R: Real>(&self, id: u32, rays: &Rays) -> Option<RayHit> {
        let t = self.t.filter(|_| self.meeting == Meeting::Hit)?;
        let depth = rays.depth(R::new(t)).get().clamp(0.0, 1.0);
        Some(RayHit { id, t, depth })
    }
}

impl RayHit {
    /// Is it seen before another one? Of two as near, the lower id.
    pub(super) fn is_nearer<R: Real>(&self, other: Option<&Self>) -> bool {
        other.is_none_or(|other| {
            let [t, other_t] = [self.t, other.t].map(R::new);
            t < other_t || (self.id < other.id && t == other_t)
        })
    }
}

/// All triangles, in the order of their ids.
pub(super) fn ray_triangles(surfaces: &Surfaces) -> impl Iterator<Item = RayTriangle> + use<'_> {
    let numbered = surfaces.ids().zip(surfaces.triangles());
    numbered.map(|(id, corners)| RayTriangle::new(surfaces, id, corners))
}
