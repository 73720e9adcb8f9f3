//! Clipscope shows, step by step and with the real numbers, how graphics programs decide what is visible.
//!
//! A program that wants to clip or cull needs two modules: [`geom`] has the types that go in, which cannot hold nonsense, and
//! [`algo`] has the algorithms. Every algorithm is a [`Method`](trace::Method): [`trace::silent`] gives its answer, and a
//! [`trace::Recording`] of the same code gives its steps. Kernels and batches are the fast forms of what is taught.
//!
//! ```
//! use clipscope::{
//!     algo::{
//!         cull::{Containment, SphereCull, SphereCullInput},
//!         line::{LiangBarsky, WindowInput, batch},
//!         polygon::Clipper,
//!         surface::{DepthBuffer, DepthBufferInput, Surfaces},
//!     },
//!     geom::{Camera, Polygon, Segment, Sphere, ViewVolume, Window},
//!     trace::{Recording, silent},
//! };
//!
//! // A million segments against a window.
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = |i: u32| Segment::new(-2.0, -1.0, 2.0, f64::from(i) / 250_000.0);
//! let segments = (0..1_000_000).map(segment).collect::<Result<batch::Segments, _>>()?;
//! let mut clipped = batch::ClippedSegments::default();
//! batch::clip_all(&window, &segments, &mut clipped);
//! assert_eq!(clipped.get(375_000), Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//!
//! // The same answer from the algorithm that is taught, with the steps that lead to it.
//! let input = WindowInput { window, segment: segment(375_000)? };
//! assert_eq!(silent::<LiangBarsky>(&input), clipped.get(375_000));
//! assert_eq!(Recording::<LiangBarsky>::new(input).events().len(), 16);
//!
//! // Polygons, one after the other, without new memory for each.
//! let mut clipper = Clipper::new(&window.into());
//! let triangle = Polygon::new(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
//! assert_eq!(clipper.clip(triangle.vertices()).vertices().len(), 4);
//!
//! // Does a camera see any of a ball?
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?;
//! let camera = Camera::new([0.0, 0.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0], volume)?;
//! let sphere = Sphere::new([0.0, 9.0, 0.0, 1.0])?;
//! let planes = camera.planes_in_world().to_vec();
//! assert_eq!(silent::<SphereCull>(&SphereCullInput { planes, sphere }).class, Containment::Outside);
//!
//! // Who is seen at each of 2 × 2 pixels.
//! let wall = |z: f64| [[-20.0, -20.0, z], [20.0, -20.0, z], [0.0, 40.0, z]];
//! let surfaces = Surfaces::new([2, 2], volume, [wall(-5.0), wall(-2.0)], false).expect("finite corners");
//! assert_eq!(silent::<DepthBuffer>(&DepthBufferInput::new(surfaces)).picture.ids(), [1; 4]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The order of the modules is the order to read them in; each knows only those above it.

pub mod geom;
pub mod trace;

pub mod algo;

pub mod text;

pub mod figure;

pub mod labs;

pub mod input;

pub mod lesson;

pub mod case;

pub mod grade;

#[cfg(feature = "gui")]
pub mod paint;

#[cfg(feature = "gui")]
pub mod widgets;

#[cfg(feature = "gui")]
pub mod panels;

#[cfg(feature = "gui")]
pub mod export;

#[cfg(feature = "gui")]
pub mod app;

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
pub mod cli;
