//! A depth for every pixel: the nearest so far.
//!
//! ```text
//!        picture              depth buffer                a fragment of B comes to the ringed pixel with 0.647:
//!      A A A · · ·        .53 .58 .64  ∞   ∞   ∞
//!      A A A A B B        .49 .54 .60 .66 .55 .48            0.647 < 0.695   it is nearer: B and 0.647 are written
//!      A A A(A)B B        .46 .52 .58(.70).56 .49            else            nothing is written
//! ```
//!
//! *Conventions*: depth is (z/w + 1) / 2, 0 on the near and 1 on the far plane, both closed: linear over the screen. Strictly less wins, so
//! of two that are as near the one drawn first is seen. The top-left rule settles edges. *Degenerate*: a triangle without area, or
//! edge-on, covers nothing. *Bound*: clearing; for each triangle its turn and a step for each fragment (or row) of it; the end. *Cost* of a
//! fragment: 2 ×, 2 + and 1 comparison. Clipping, and where rows begin and end, is not counted.
//!
//! *Source*: E. Catmull, "A subdivision algorithm for computer display of curved surfaces", dissertation, University of Utah, 1974.
//!
//! ```
//! use clipscope::{
//!     algo::surface::{DepthBuffer, DepthBufferInput, Surfaces},
//!     geom::ViewVolume,
//!     trace::silent,
//! };
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?;
//! let wall = |z: f64| [[-20.0, -20.0, z], [20.0, -20.0, z], [0.0, 40.0, z]];
//! let surfaces = Surfaces::new([2, 2], volume, [wall(-5.0), wall(-2.0), wall(-10.0)], false).expect("finite");
//! let output = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces));
//! assert_eq!(output.picture.ids(), [1, 1, 1, 1]);
//! // 10/9 · (1 − 1/2)
//! assert!((output.depth[0] - 5.0 / 9.0).abs() < 1e-15);
//! assert_eq!([output.tally.fragments, output.tally.writes], [12, 8]);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::ring::Right,
    trace::{Method, Real, Tell, Told},
};

use super::{DepthFormat, Picture, SurfaceRules, Surfaces, Tint, coverage::Coverage};

/// A run can go on from every so-manieth triangle: so many are drawn in less than a millisecond.
const REST_EVERY: usize = 512;

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct DepthBuffer<L = Right>(PhantomData<L>);

/// How much happens in one step.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum DepthSteps {
    /// One fragment: the pixel of one triangle.
    #[default]
    Fragments,
    /// All of a triangle's fragments in one row.
    Spans,
    /// All of a triangle's fragments.
    Triangles,
}

/// Triangles, in the order in which they are drawn.
#[derive(Clone, PartialEq, Debug)]
pub struct DepthBufferInput {
    /// What is to be seen.
    pub surfaces: Surfaces,
    /// Ids, the first that is drawn first: it wins ties. What names no triangle is passed over.
    pub order: Vec<u32>,
    /// How depths are stored.
    pub format: DepthFormat,
    /// How much happens in one step.
    pub steps: DepthSteps,
    /// Only what happens at this pixel, where one is named.
    pub pixel: Option<[u32; 2]>,
}

impl DepthBufferInput {
    /// All of them in the order of their ids, at all pixels, fragment by fragment, and nothing rounded.
    #[must_use]
    pub fn new(surfaces: Surfaces) -> Self {
        Self {
            order: surfaces.ids().collect(),
            surfaces,
            format: DepthFormat::default(),
            steps: DepthSteps::default(),
            pixel: None,
        }
    }
}

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
    /// How bright the pixel was and is now, where it is written and surfaces have tints.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blend: Option<[f64; 2]>,
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
    fn add(&mut self, fragment: &Fragment) {
        self.fragments += 1;
        if fragment.kept {
            self.writes += 1;
            self.pixels += u64::from(fragment.stored_id == Picture::BACKGROUND);
        }
    }
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum DepthBufferEvent {
    /// Every pixel gets this depth, and no surface.
    Clear {
        /// Not finite: farther than everything.
        depth: f64,
    },
    /// A triangle's turn. In steps of triangles, it has been drawn.
    Triangle {
        /// Whose turn it is.
        id: u32,
        /// Is anything of it in the volume, and does it show the side that is drawn?
        drawn: bool,
        /// So far.
        tally: FragmentTally,
    },
    /// A row of it has been drawn.
    Span {
        /// Of the triangle.
        id: u32,
        /// The row.
        row: u32,
        /// Its first column, and the one after its last.
        columns: [u32; 2],
        /// So far.
        tally: FragmentTally,
    },
    /// A pixel of it is asked.
    Fragment {
        /// What is compared, and the result.
        #[serde(flatten)]
        fragment: Fragment,
        /// With this one.
        tally: FragmentTally,
    },
    /// No triangle is left.
    Done,
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct DepthBufferOutput {
    /// Whose each pixel is.
    #[serde(rename = "ids")]
    pub picture: Picture,
    /// What is stored of each pixel, row by row; not finite where nothing was written.
    pub depth: Vec<f64>,
    /// How bright each pixel is, row by row; empty where no surface has a tint.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub brightness: Vec<f64>,
    /// How much was done.
    #[serde(skip)]
    pub tally: FragmentTally,
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct DepthBufferHeld {
    /// Picture, depths and counts so far; after the end, the answer.
    pub so_far: DepthBufferOutput,
    /// Once the buffer is cleared, so many triangles of the order have had their turn.
    n_past: Option<usize>,
}

impl<L: SurfaceRules> Method for DepthBuffer<L> {
    type Input = DepthBufferInput;
    type Held = DepthBufferHeld;
    type Output = DepthBufferOutput;
    type Event = DepthBufferEvent;

    fn begin(input: &Self::Input) -> Self::Held {
        DepthBufferHeld {
            so_far: DepthBufferOutput {
                picture: Picture::empty(input.surfaces.size()),
                depth: vec![input.format.nothing(); input.surfaces.n_pixels()],
                brightness: input.surfaces.paper(),
                tally: FragmentTally::default(),
            },
            n_past: None,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        if held.n_past.is_none() {
            let depth = cleared::<L>(&input.format);
            held.so_far.depth.fill(depth);
            tell.tell(held, DepthBufferEvent::Clear { depth })?;
        }
        let n_past = held.n_past.unwrap_or_default();
        for (nth, &id) in input.order.iter().enumerate().skip(n_past) {
            if nth % REST_EVERY == 0 {
                held.n_past = Some(nth);
                tell.rest(held);
            }
            triangle::<L, R, T>(input, held, id, tell)?;
        }
        tell.tell(held, DepthBufferEvent::Done)
    }

    fn output(held: Self::Held) -> Self::Output {
        held.so_far
    }

    /// Clipping may make seven triangles of one.
    fn max_events(input: &Self::Input) -> usize {
        let [_, height] = input.surfaces.size();
        let of_triangle = match input.steps {
            DepthSteps::Fragments => input.pixel.map_or(input.surfaces.n_pixels(), |_| 1),
            DepthSteps::Spans => 7 * height as usize,
            DepthSteps::Triangles => 0,
        };
        2 + input.order.len() * (1 + of_triangle)
    }
}

fn cleared<L: SurfaceRules>(format: &DepthFormat) -> f64 {
    if L::CLEARS_TO_NEAR {
        format.nearest()
    } else {
        format.nothing()
    }
}

#[inline]
pub(super) fn triangle<L: SurfaceRules, R: Real, T: Tell<DepthBuffer<L>>>(
    input: &DepthBufferInput,
    held: &mut DepthBufferHeld,
    id: u32,
    tell: &mut T,
) -> Told<T::Stop> {
    use DepthBufferEvent as Event;
    let [_, height] = input.surfaces.size();
    let rows = input.pixel.map_or(0..height, |[_, row]| {
        row.min(height)..row.saturating_add(1).min(height)
    });
    let Some(triangle) = input.surfaces.triangles().get(id as usize) else {
        return Told::Continue(());
    };
    let coverage = Coverage::of::<L>(&input.surfaces, triangle);
    let (drawn, tint) = (coverage.is_some(), input.surfaces.tint(id));
    if input.steps != DepthSteps::Triangles {
        let tally = held.so_far.tally;
        tell.tell(held, Event::Triangle { id, drawn, tally })?;
    }
    if let Some(coverage) = coverage {
        coverage.try_for_each_span(input.surfaces.viewport(), &rows, |span| {
            let (row, columns) = (span.row, span.columns);
            let [first, end] = columns;
            let wanted = match input.pixel {
                Some([column, _]) => first.max(column)..end.min(column.saturating_add(1)),
                None => first..end,
            };
            for column in wanted {
                let depth = span.depth::<R>(column);
                let so_far = &mut held.so_far;
                let own = (id, tint, depth);
                let fragment = so_far.fragment::<L, R>(&input.format, own, [column, row]);
                so_far.tally.add(&fragment);
                if input.steps == DepthSteps::Fragments {
                    let tally = so_far.tally;
                    tell.tell(held, Event::Fragment { fragment, tally })?;
                }
            }
            if input.steps == DepthSteps::Spans {
                let event = Event::Span {
                    id,
                    row,
                    columns,
                    tally: held.so_far.tally,
                };
                tell.tell(held, event)?;
            }
            Told::Continue(())
        })?;
    }
    if input.steps == DepthSteps::Triangles {
        let tally = held.so_far.tally;
        tell.tell(held, Event::Triangle { id, drawn, tally })?;
    }
    Told::Continue(())
}

impl DepthBufferOutput {
    #[inline(always)]
    fn fragment<L: SurfaceRules, R: Real>(
        &mut self,
        format: &DepthFormat,
        (id, tint, depth): (u32, Option<Tint>, f64),
        pixel: [u32; 2],
    ) -> Fragment {
        let (place, new) = (self.picture.place(pixel), format.stored(depth));
        let (stored, stored_id) = (self.depth[place], self.picture.ids()[place]);
        let [front, behind] = if L::TURNS_COMPARISON {
            [stored, new]
        } else {
            [new, stored]
        };
        let kept = !L::COMPARES || format.is_nearer::<R>(front, behind);
        let mut blend = None;
        if kept {
            self.depth[place] = new;
            self.picture.put(pixel, id);
            if let Some(tint) = tint {
                let before = self.brightness[place];
                self.brightness[place] = tint.over::<R>(before);
                blend = Some([before, self.brightness[place]]);
            }
        }
        Fragment {
            id,
            pixel,
            depth,
            new,
            stored,
            stored_id,
            kept,
            blend,
        }
    }
}
