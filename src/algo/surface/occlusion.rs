//! Occlusion: an object that is hidden as a whole need not be drawn, and a box is enough to know it.
//!
//! ```text
//!        ┌─────────┐
//!   eye  │ a large │    ┌─────┐      the box's pixels are compared with the depths that are there, and nothing is
//!    ●   │ wall    │    │△ △ △│      written: if none would be seen, none of what is in the box would
//!        └─────────┘    └─────┘
//! ```
//!
//! 1. Draw what hides much: the occluders, into the depth buffer.
//! 2. Of every other object ask its bounding box: at how many of its pixels would it be seen?
//! 3. None: the object is skipped. Else it is drawn.
//!
//! *Conventions*: boxes lie along the axes of the view, and are larger than what is in them by four of the steps that vertices are snapped
//! to; as near as what is stored is seen; a box that reaches the near plane is drawn unasked. So what is skipped has no visible pixel: the
//! answer is conservative, never wrong. *Bound*: for each object its question, its answer and its drawing; the end. *Cost*: as of
//! [`DepthBuffer`](super::DepthBuffer), and for each pixel of a box its depth and one comparison.
//!
//! *Source*: D. Bartz, M. Meißner and T. Hüttner, "OpenGL-assisted occlusion culling for large polygonal models", Computers &
//! Graphics 23, 1999, pp. 667–679.
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
//! assert_eq!((output.n_drawn, output.n_skipped), (1, 1));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::sync::Arc;

use serde::Serialize;

use crate::{
    algo::ring::Right,
    geom::AlignedBox,
    trace::{Algorithm, Real},
};

use super::{
    DepthBufferInput, Fragment, Picture, Surfaces,
    depth_drawing::{Drawing, Told},
    occlusion_query::{ask, query_box, reaches_near},
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
        /// Its pixels: from, and up to, a place in the list of the states.
        #[serde(skip)]
        pixels: [usize; 2],
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
        /// What it has written: from, and up to, a place in the list of the states.
        #[serde(skip)]
        writes: [usize; 2],
    },
    /// No object is left.
    Done,
}

/// The answer.
#[derive(Clone, PartialEq, Debug)]
pub struct OcclusionOutput {
    /// Whose each pixel is: as if everything had been drawn.
    pub picture: Picture,
    /// What is stored of each pixel.
    pub depth: Vec<f64>,
    /// As many objects as were drawn, the occluders among them.
    pub n_drawn: usize,
    /// As many as were skipped.
    pub n_skipped: usize,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct OcclusionState {
    /// Picture and counts so far; after the end, the answer.
    pub so_far: OcclusionOutput,
    /// The object whose turn it is.
    pub object_idx: Option<usize>,
    /// Its box and the answer, once it is asked.
    pub query: Option<(Option<[[f64; 3]; 2]>, QueryResult)>,
    /// Every object that has been asked, in order, and the answer.
    pub answers: Vec<(usize, QueryResult)>,
    /// The pixels of its box, and whether it would be seen there.
    pub asked: Vec<([u32; 2], bool)>,
    /// Objects drawn so far, in order.
    pub drawn: Vec<usize>,
    /// Objects skipped so far.
    pub skipped: Vec<usize>,
    /// Is nothing left to do?
    pub is_done: bool,
    /// All that will be written, and all that will be asked, in order.
    lists: Arc<Lists>,
}

/// What a run writes and asks.
#[derive(PartialEq, Debug, Default)]
struct Lists {
    writes: Vec<([u32; 2], u32, f64)>,
    pixels: Vec<([u32; 2], bool)>,
}

impl Algorithm for Occlusion {
    type Input = OcclusionInput;
    type Output = OcclusionOutput;
    type Event = OcclusionEvent;
    type State = OcclusionState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        let output = all::<R>(input, &mut Lists::default(), &mut emit);
        emit(OcclusionEvent::Done);
        output
    }

    fn start(input: &Self::Input) -> Self::State {
        let mut lists = Lists::default();
        all::<f64>(input, &mut lists, &mut |_| {});
        OcclusionState {
            so_far: OcclusionOutput {
                picture: Picture::empty(input.surfaces.size()),
                depth: vec![f64::INFINITY; input.surfaces.n_pixels()],
                n_drawn: 0,
                n_skipped: 0,
            },
            object_idx: None,
            query: None,
            answers: Vec::new(),
            asked: Vec::new(),
            drawn: Vec::new(),
            skipped: Vec::new(),
            is_done: false,
            lists: Arc::new(lists),
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        state.so_far.clone()
    }

    /// For each object its query and its fate; the end.
    fn max_events(input: &Self::Input) -> usize {
        2 * input.objects.len() + 1
    }
}

impl OcclusionState {
    fn apply(&mut self, event: OcclusionEvent) {
        use OcclusionEvent as Event;
        let lists = Arc::clone(&self.lists);
        match event {
            Event::Query {
                object_idx,
                bounds,
                pixels: [from, to],
                result,
            } => {
                self.object_idx = Some(object_idx);
                self.query = Some((bounds, result));
                self.answers.push((object_idx, result));
                let pixels = lists.pixels.get(from..to).unwrap_or_default();
                self.asked = pixels.to_vec();
            }
            Event::Skip { object_idx } => {
                self.skipped.push(object_idx);
                self.so_far.n_skipped = self.skipped.len();
            }
            Event::Draw {
                object_idx,
                writes: [from, to],
            } => {
                if self.object_idx != Some(object_idx) {
                    (self.query, self.object_idx) = (None, Some(object_idx));
                    self.asked.clear();
                }
                for &(pixel, id, depth) in lists.writes.get(from..to).unwrap_or_default() {
                    let place = self.so_far.picture.place(pixel);
                    self.so_far.depth[place] = depth;
                    self.so_far.picture.put(pixel, id);
                }
                self.drawn.push(object_idx);
                self.so_far.n_drawn = self.drawn.len();
            }
            Event::Done => {
                (self.object_idx, self.query) = (None, None);
                self.asked.clear();
                self.is_done = true;
            }
        }
    }
}

/// Occluders first, then the others, each in its order.
fn all<R: Real>(
    input: &OcclusionInput,
    lists: &mut Lists,
    emit: &mut impl FnMut(OcclusionEvent),
) -> OcclusionOutput {
    let surfaces = &input.surfaces;
    let drawing_input = DepthBufferInput::new(surfaces.clone());
    let mut drawing = Drawing::<Right>::new(&drawing_input);
    let (mut n_drawn, mut n_skipped) = (0, 0);
    let numbered = || input.objects.iter().enumerate();
    let occluders = numbered().filter(|(_, object)| object.is_occluder);
    let others = numbered().filter(|(_, object)| !object.is_occluder);
    for (object_idx, object) in occluders.chain(others) {
        let is_hidden = !object.is_occluder && {
            let bounds = query_box(surfaces, object.triangles(surfaces));
            let begun = lists.pixels.len();
            let result = query::<R>(surfaces, bounds.as_ref(), &drawing.depth, lists);
            emit(OcclusionEvent::Query {
                object_idx,
                bounds: bounds.map(|bounds| [bounds.min(), bounds.max()]),
                pixels: [begun, lists.pixels.len()],
                result,
            });
            result.passed == 0 && !result.unasked
        };
        if is_hidden {
            n_skipped += 1;
            emit(OcclusionEvent::Skip { object_idx });
            continue;
        }
        let begun = lists.writes.len();
        for id in object.ids() {
            drawing.triangle::<R>(id, &mut |told| {
                if let Told::Fragment(Fragment {
                    id,
                    pixel,
                    new,
                    kept: true,
                    ..
                }) = told
                {
                    lists.writes.push((pixel, id, new));
                }
            });
        }
        n_drawn += 1;
        let writes = [begun, lists.writes.len()];
        emit(OcclusionEvent::Draw { object_idx, writes });
    }
    OcclusionOutput {
        picture: drawing.picture,
        depth: drawing.depth,
        n_drawn,
        n_skipped,
    }
}

fn query<R: Real>(
    surfaces: &Surfaces,
    bounds: Option<&AlignedBox>,
    depths: &[f64],
    lists: &mut Lists,
) -> QueryResult {
    let mut result = QueryResult {
        asked: 0,
        passed: 0,
        unasked: bounds.is_some_and(|bounds| reaches_near(surfaces, bounds)),
    };
    if let Some(bounds) = bounds.filter(|_| !result.unasked) {
        ask::<R>(surfaces, bounds, depths, |pixel, passes| {
            result.asked += 1;
            result.passed += u64::from(passes);
            lists.pixels.push((pixel, passes));
        });
    }
    result
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
