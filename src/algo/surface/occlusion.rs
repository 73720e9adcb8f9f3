//! Occlusion: an object that is hidden as a whole need not be drawn, and a box is enough to know it.
//!
//! ```text
//!        ┌─────────┐
//!   eye  │ a large │    ┌─────┐      the box's pixels are compared with the depths that are there, and nothing is
//!    ●   │ wall    │    │△ △ △│      written: if none would be seen, none of what is in the box would
//!        └─────────┘    └─────┘
//! ```
//!
//! Occluders are drawn first. Of every other object the bounding box is asked; at no pixel seen, the object is skipped.
//!
//! *Conventions*: boxes lie along the axes of the view, four snapping steps larger than what is in them; as near as what is stored is seen; a
//! box that reaches the near plane is drawn unasked. So the answer is conservative, never wrong. *Bound*: for each object its question
//! and its fate; the end. *Cost*: as of [`DepthBuffer`](super::DepthBuffer), and for each pixel of a box its depth and one comparison.
//!
//! *Source*: D. Bartz, M. Meißner and T. Hüttner, "OpenGL-assisted occlusion culling for large polygonal models", Computers & Graphics
//! 23, 1999, pp. 667–679.
//!
//! ```
//! use clipscope::{
//!     algo::surface::{Occlusion, OcclusionInput, OcclusionObject, Surfaces},
//!     geom::ViewVolume,
//!     trace::silent,
//! };
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?;
//! let wall = [[-9.0, -9.0, -3.0], [9.0, -9.0, -3.0], [0.0, 18.0, -3.0]];
//! let behind = [[-1.0, -1.0, -6.0], [1.0, -1.0, -6.0], [0.0, 1.0, -7.0]];
//! let surfaces = Surfaces::new([8, 8], volume, [wall, behind], false).expect("finite");
//! let object = |first, is_occluder| OcclusionObject { first, n_triangles: 1, is_occluder };
//! let objects = vec![object(0, true), object(1, false)];
//! let output = silent::<Occlusion>(&OcclusionInput { surfaces, objects });
//! assert_eq!((output.drawn, output.skipped), (vec![0], vec![1]));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::{
    algo::ring::Right,
    geom::{AlignedBox, Sight},
    trace::{Method, Real, Silent, Tell, Told},
};

use super::{
    DepthBuffer, DepthBufferHeld, DepthBufferInput, DepthFormat, Picture, Surfaces,
    coverage::Coverage, depth_buffer::triangle,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Occlusion;

/// Triangles that belong together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OcclusionObject {
    /// The id of its first triangle.
    pub first: u32,
    /// How many it has, one after the other.
    pub n_triangles: u32,
    /// Is it drawn first, to hide others?
    pub is_occluder: bool,
}

/// Surfaces, and which of them make objects.
#[derive(Clone, PartialEq, Debug)]
pub struct OcclusionInput {
    /// What is to be seen.
    pub surfaces: Surfaces,
    /// In the order in which they are asked. What names no triangle is passed over.
    pub objects: Vec<OcclusionObject>,
}

/// The answer to a query.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct QueryResult {
    /// At so many pixels the box's front was compared.
    pub asked: u64,
    /// At so many it would be seen.
    pub passed: u64,
    /// Does the box reach the near plane, so that nothing was compared?
    pub unasked: bool,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum OcclusionEvent {
    /// An object's box is asked.
    Query {
        /// Which object.
        object_idx: usize,
        /// Its lowest and its highest corner, in view space; none of an object without triangles.
        bounds: Option<[[f64; 3]; 2]>,
        /// What is found.
        result: QueryResult,
    },
    /// It is skipped: nothing of it would be seen.
    Skip {
        /// Which object.
        object_idx: usize,
    },
    /// It is drawn.
    Draw {
        /// Which object.
        object_idx: usize,
        /// So many fragments of it were written.
        #[serde(skip)]
        writes: u64,
    },
    /// No object is left.
    Done,
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct OcclusionOutput {
    /// Whose each pixel is: as if everything had been drawn.
    #[serde(rename = "ids")]
    pub picture: Picture,
    /// What is stored of each pixel.
    pub depth: Vec<f64>,
    /// The objects that were drawn, the occluders first.
    #[serde(skip)]
    pub drawn: Vec<usize>,
    /// The objects that were skipped, in the order in which they were asked.
    pub skipped: Vec<usize>,
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct OcclusionHeld {
    /// What has been drawn so far.
    pub drawing: DepthBufferHeld,
    /// Objects drawn so far, in order.
    pub drawn: Vec<usize>,
    /// Objects skipped so far, in order.
    pub skipped: Vec<usize>,
    /// The pixels of the box that was asked last, and whether it would be seen there.
    pub asked: Vec<([u32; 2], bool)>,
}

impl Method for Occlusion {
    type Input = OcclusionInput;
    type Held = OcclusionHeld;
    type Output = OcclusionOutput;
    type Event = OcclusionEvent;

    fn begin(input: &Self::Input) -> Self::Held {
        OcclusionHeld {
            drawing: DepthBuffer::<Right>::begin(&DepthBufferInput::new(input.surfaces.clone())),
            drawn: Vec::new(),
            skipped: Vec::new(),
            asked: Vec::new(),
        }
    }

    /// Occluders first, then the others, each in its order.
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use OcclusionEvent as Event;
        let drawing = DepthBufferInput::new(input.surfaces.clone());
        let numbered = || input.objects.iter().enumerate();
        let occluders = numbered().filter(|(_, object)| object.is_occluder);
        let others = numbered().filter(|(_, object)| !object.is_occluder);
        let n_past = held.drawn.len() + held.skipped.len();
        for (object_idx, object) in occluders.chain(others).skip(n_past) {
            tell.rest(held);
            held.asked.clear();
            if !object.is_occluder {
                let (bounds, result) = query::<R>(input, object, held);
                let event = Event::Query {
                    object_idx,
                    bounds,
                    result,
                };
                tell.tell(held, event)?;
                if result.passed == 0 && !result.unasked {
                    held.skipped.push(object_idx);
                    tell.tell(held, Event::Skip { object_idx })?;
                    continue;
                }
            }
            let before = held.drawing.so_far.tally.writes;
            for id in object.ids() {
                let Told::Continue(()) =
                    triangle::<Right, R, Silent>(&drawing, &mut held.drawing, id, &mut Silent);
            }
            held.drawn.push(object_idx);
            let writes = held.drawing.so_far.tally.writes - before;
            tell.tell(held, Event::Draw { object_idx, writes })?;
        }
        tell.tell(held, Event::Done)
    }

    fn output(held: Self::Held) -> Self::Output {
        let drawing = held.drawing.so_far;
        OcclusionOutput {
            picture: drawing.picture,
            depth: drawing.depth,
            drawn: held.drawn,
            skipped: held.skipped,
        }
    }

    fn max_events(input: &Self::Input) -> usize {
        2 * input.objects.len() + 1
    }
}

fn query<R: Real>(
    input: &OcclusionInput,
    object: &OcclusionObject,
    held: &mut OcclusionHeld,
) -> (Option<[[f64; 3]; 2]>, QueryResult) {
    let surfaces = &input.surfaces;
    let bounds = query_box(surfaces, object.triangles(surfaces));
    let mut result = QueryResult {
        asked: 0,
        passed: 0,
        unasked: bounds.is_some_and(|bounds| reaches_near(surfaces, &bounds)),
    };
    if let Some(bounds) = bounds.as_ref().filter(|_| !result.unasked) {
        let so_far = &held.drawing.so_far;
        let stored = |pixel: [u32; 2]| so_far.depth[so_far.picture.place(pixel)];
        ask::<R>(surfaces, bounds, stored, |pixel, passes| {
            result.asked += 1;
            result.passed += u64::from(passes);
            held.asked.push((pixel, passes));
        });
    }
    (bounds.map(|bounds| [bounds.min(), bounds.max()]), result)
}

impl OcclusionObject {
    fn ids(&self) -> impl Iterator<Item = u32> + use<> {
        self.first..self.first.saturating_add(self.n_triangles)
    }

    fn triangles<'a>(&self, surfaces: &'a Surfaces) -> &'a [[[f64; 3]; 3]] {
        let n = surfaces.triangles().len();
        let [from, to] = [self.first, self.first.saturating_add(self.n_triangles)];
        &surfaces.triangles()[(from as usize).min(n)..(to as usize).min(n)]
    }
}

/// The faces of a box, counter-clockwise as seen from outside, by the numbers of its corners.
const FACES: [[usize; 3]; 12] = [
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
];

/// A little larger than what is in it, by more than snapping moves vertices anywhere in it.
fn query_box(surfaces: &Surfaces, triangles: &[[[f64; 3]; 3]]) -> Option<AlignedBox> {
    /// Of a pixel: four of the steps that vertices are snapped to.
    const MARGIN: f64 = 1.0 / 16_384.0;
    let bounds = AlignedBox::around(triangles.as_flattened().iter().copied()).ok()?;
    let volume = surfaces.volume();
    let distance = match volume.sight() {
        Sight::Perspective => -bounds.min()[2],
        Sight::Parallel => 1.0,
    };
    let (half, size) = (volume.half_size(), surfaces.size().map(f64::from));
    let pixel = (2.0 * half[0] / size[0]).max(2.0 * half[1] / size[1]);
    let margin = MARGIN * pixel * distance.max(0.0);
    let [x, y, z] = bounds.min().map(|x| (x - margin).max(f64::MIN));
    let [right, top, front] = bounds.max().map(|x| (x + margin).min(f64::MAX));
    AlignedBox::new([x, y, z, right, top, front]).ok()
}

/// Does it reach the near plane? Then its front may be cut away, and nothing can be told from what is left.
fn reaches_near(surfaces: &Surfaces, bounds: &AlignedBox) -> bool {
    -bounds.max()[2] <= surfaces.volume().near()
}

/// Calls back with every pixel that the box's front covers, and whether it would be seen: as near as what is stored is seen.
fn ask<R: Real>(
    surfaces: &Surfaces,
    bounds: &AlignedBox,
    stored: impl Fn([u32; 2]) -> f64,
    mut tell: impl FnMut([u32; 2], bool),
) {
    let corners = bounds.corners();
    let faces: Vec<[[f64; 3]; 3]> = FACES.map(|face| face.map(|i| corners[i])).to_vec();
    let format = DepthFormat::default();
    let Some(faces) = Surfaces::new(surfaces.size(), *surfaces.volume(), faces, true) else {
        return;
    };
    for face in faces.triangles() {
        let Some(coverage) = Coverage::of::<Right>(&faces, face) else {
            continue;
        };
        coverage.for_each_span(faces.viewport(), |span| {
            let [first, end] = span.columns;
            for column in first..end {
                let pixel = [column, span.row];
                let depth = span.depth::<R>(column);
                tell(pixel, !format.is_nearer::<R>(stored(pixel), depth));
            }
        });
    }
}
