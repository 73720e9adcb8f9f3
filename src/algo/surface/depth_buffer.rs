//! A depth for every pixel: the nearest so far.
//!
//! ```text
//!        picture              depth buffer                a fragment of B comes to the ringed pixel with 0.647:
//!      A A A · · ·        .53 .58 .64  ∞   ∞   ∞
//!      A A A A B B        .49 .54 .60 .66 .55 .48            0.647 < 0.695   it is nearer: B and 0.647 are written
//!      A A A(A)B B        .46 .52 .58(.70).56 .49            else            nothing is written
//! ```
//!
//! 1. Clear: the picture to background, every depth to ∞.
//! 2. Of every triangle find the pixels whose middles it covers, row by row, and its depth at each.
//! 3. Less than the depth that stands there: write id and depth. Not less: nothing happens.
//!
//! *Conventions*: depth is (z/w + 1) / 2, 0 on the near and 1 on the far plane, both closed: after the divide it is linear over
//! the screen. Strictly less wins, so of two that are as near the one drawn first is seen. The top-left rule settles edges.
//! The order in which triangles come changes nothing but such ties. *Degenerate cases*: a triangle without area, or edge-on,
//! covers nothing. *Bound*: clearing; for each triangle its turn and a step for each fragment (or row) of it; the end.
//! *Cost*: of a fragment two multiplications and two additions for its depth, and one comparison. Clipping, and where rows begin
//! and end, is not counted here.
//!
//! A recording by spans or triangles keeps what was written in a list that the states share: no step is drawn twice.
//!
//! *Source*: E. Catmull, "A subdivision algorithm for computer display of curved surfaces", dissertation, University of Utah,
//! 1974.
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

use std::{marker::PhantomData, sync::Arc};

use serde::Serialize;

use crate::{
    algo::ring::Right,
    trace::{Algorithm, Real},
};

use super::{
    DepthBufferInput, DepthSteps, Fragment, FragmentTally, Picture, SurfaceRules,
    depth_drawing::{Drawing, Told, cleared},
};

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct DepthBuffer<L = Right>(PhantomData<L>);

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
        /// What it has written: from, and up to, a place in the list of the states.
        #[serde(skip)]
        writes: [usize; 2],
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
        /// What it has written: from, and up to, a place in the list of the states.
        #[serde(skip)]
        writes: [usize; 2],
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
#[derive(Clone, PartialEq, Debug)]
pub struct DepthBufferOutput {
    /// Whose each pixel is.
    pub picture: Picture,
    /// What is stored of each pixel, row by row; not finite where nothing was written.
    pub depth: Vec<f64>,
    /// How much was done.
    pub tally: FragmentTally,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct DepthBufferState {
    /// Picture, depths and counts so far; after the end, the answer.
    pub so_far: DepthBufferOutput,
    /// The triangle whose turn it is, and whether anything of it is drawn.
    pub triangle: Option<(u32, bool)>,
    /// The row that has been drawn, and its columns.
    pub span: Option<(u32, [u32; 2])>,
    /// The fragment that has been asked.
    pub fragment: Option<Fragment>,
    /// Where only one pixel is looked at, all its fragments so far.
    pub story: Vec<Fragment>,
    /// Is nothing left to do?
    pub is_done: bool,
    /// Is only one pixel looked at?
    keeps_story: bool,
    /// What a run by spans or triangles writes, in order.
    writes: Arc<[([u32; 2], u32, f64)]>,
}

impl<L: SurfaceRules> Algorithm for DepthBuffer<L> {
    type Input = DepthBufferInput;
    type Output = DepthBufferOutput;
    type Event = DepthBufferEvent;
    type State = DepthBufferState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use DepthBufferEvent as Event;
        emit(Event::Clear {
            depth: cleared::<L>(&input.format),
        });
        let mut drawing = Drawing::<L>::new(input);
        let mut telling = Telling::new(input.steps);
        drawing.all::<R>(&mut |told| {
            if let Some(event) = telling.event(&told) {
                emit(event);
            }
        });
        emit(Event::Done);
        DepthBufferOutput {
            picture: drawing.picture,
            depth: drawing.depth,
            tally: telling.tally,
        }
    }

    fn start(input: &Self::Input) -> Self::State {
        let mut writes = Vec::new();
        if input.steps != DepthSteps::Fragments {
            Drawing::<L>::new(input).all::<f64>(&mut |told| {
                if let Told::Fragment(Fragment {
                    id,
                    pixel,
                    new,
                    kept: true,
                    ..
                }) = told
                {
                    writes.push((pixel, id, new));
                }
            });
        }
        DepthBufferState {
            so_far: DepthBufferOutput {
                picture: Picture::empty(input.surfaces.size()),
                depth: vec![input.format.nothing(); input.surfaces.n_pixels()],
                tally: FragmentTally::default(),
            },
            triangle: None,
            span: None,
            fragment: None,
            story: Vec::new(),
            is_done: false,
            keeps_story: input.pixel.is_some(),
            writes: writes.into(),
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        state.so_far.clone()
    }

    /// Clearing and the end; for each triangle its turn, and by fragments each pixel once, by spans each row of each of the seven
    /// triangles that clipping may make of it.
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

/// What the loops come past, as events.
struct Telling {
    steps: DepthSteps,
    tally: FragmentTally,
    /// The triangle whose turn it is, and whether anything of it is drawn.
    turn: (u32, bool),
    /// The place in the list of the states where what is told next began.
    begun: usize,
}

impl Telling {
    fn new(steps: DepthSteps) -> Self {
        Self {
            steps,
            tally: FragmentTally::default(),
            turn: (0, false),
            begun: 0,
        }
    }

    /// Nothing where the steps are larger, or smaller.
    #[inline]
    fn event(&mut self, told: &Told) -> Option<DepthBufferEvent> {
        match *told {
            Told::Triangle { id, drawn } => {
                self.turn = (id, drawn);
                (self.steps != DepthSteps::Triangles).then(|| self.triangle())
            }
            Told::Fragment(fragment) => {
                self.tally.add(&fragment);
                (self.steps == DepthSteps::Fragments).then(|| {
                    self.writes();
                    let tally = self.tally;
                    DepthBufferEvent::Fragment { fragment, tally }
                })
            }
            Told::SpanDone { row, columns } => (self.steps == DepthSteps::Spans).then(|| {
                let writes = self.writes();
                DepthBufferEvent::Span {
                    id: self.turn.0,
                    row,
                    columns,
                    writes,
                    tally: self.tally,
                }
            }),
            Told::TriangleDone => (self.steps == DepthSteps::Triangles).then(|| self.triangle()),
        }
    }

    fn triangle(&mut self) -> DepthBufferEvent {
        let ((id, drawn), writes) = (self.turn, self.writes());
        DepthBufferEvent::Triangle {
            id,
            drawn,
            writes,
            tally: self.tally,
        }
    }

    /// What has been written since this was last asked: places in the list of the states.
    fn writes(&mut self) -> [usize; 2] {
        let end = self.tally.writes as usize;
        [std::mem::replace(&mut self.begun, end), end]
    }
}

impl DepthBufferState {
    fn apply(&mut self, event: DepthBufferEvent) {
        use DepthBufferEvent as Event;
        match event {
            Event::Clear { depth } => self.so_far.depth.fill(depth),
            Event::Triangle {
                id,
                drawn,
                writes,
                tally,
            } => {
                self.triangle = Some((id, drawn));
                (self.span, self.fragment) = (None, None);
                self.write(writes, tally);
            }
            Event::Span {
                row,
                columns,
                writes,
                tally,
                ..
            } => {
                self.span = Some((row, columns));
                self.write(writes, tally);
            }
            Event::Fragment { fragment, tally } => {
                if fragment.kept {
                    self.put(fragment.pixel, fragment.id, fragment.new);
                }
                if self.keeps_story {
                    self.story.push(fragment);
                }
                self.fragment = Some(fragment);
                self.so_far.tally = tally;
            }
            Event::Done => {
                (self.triangle, self.span, self.fragment) = (None, None, None);
                self.is_done = true;
            }
        }
    }

    /// What stands in the list at these places.
    fn write(&mut self, [from, to]: [usize; 2], tally: FragmentTally) {
        let writes = Arc::clone(&self.writes);
        for &(pixel, id, depth) in writes.get(from..to).unwrap_or_default() {
            self.put(pixel, id, depth);
        }
        self.so_far.tally = tally;
    }

    fn put(&mut self, pixel: [u32; 2], id: u32, depth: f64) {
        let place = self.so_far.picture.place(pixel);
        self.so_far.depth[place] = depth;
        self.so_far.picture.put(pixel, id);
    }
}
