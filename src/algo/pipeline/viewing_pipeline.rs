//! The viewing pipeline: one vertex, carried through all spaces to its place on the screen: rows of `world_from_model`,
//! `view_from_world` and `clip_from_view` times the vertex; −w ≤ x, y, z ≤ w asked before anything is divided; the divide where w > 0,
//! else there is no place; and the viewport, in pixels from the top left, y down. The matrices are those of [`geom`](crate::geom).
//!
//! *Bound*: 13 events. *Cost*: three multiplications and three additions a row; at most seven comparisons; three divisions; four
//! multiplications, and two additions. *Source*: L. G. Roberts, "Homogeneous matrix representation and manipulation of n-dimensional
//! constructs", MIT Lincoln Laboratory MS-1405, 1965.
//!
//! ```
//! use clipscope::{algo::{pipeline::{ViewingPipeline, ViewingPipelineInput}, surface::Viewport}, geom::{Camera, Matrix, ViewVolume}, trace::silent};
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 3.0)?;
//! let camera = Camera::new([0.0, 0.0, 4.0], [0.0; 3], [0.0, 1.0, 0.0], volume)?;
//! let through = |point| {
//!     silent::<ViewingPipeline>(&ViewingPipelineInput {
//!         point,
//!         world_from_model: Matrix::IDENTITY,
//!         camera,
//!         viewport: Viewport::new([200, 100], Viewport::ANSWER_BITS).expect("a picture"),
//!     })
//! };
//! let output = through([1.0, 1.0, 2.0]);
//! assert_eq!(output.view, [1.0, 1.0, -2.0]);
//! assert_eq!(output.clip, [1.0, 1.0, 1.0, 2.0]);
//! assert_eq!((output.inside, output.ndc), (true, Some([0.5, 0.5, 0.5])));
//! assert_eq!(output.screen, Some([150.0, 25.0]));
//! assert_eq!(through([0.0, 0.0, 5.0]).screen, None, "behind the eye");
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::{
    algo::{surface::Viewport, volume::is_plain},
    geom::{Camera, Matrix, Wide},
    trace::{Method, Real, Tell, Told},
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct ViewingPipeline;

/// A vertex, and all that it goes through.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewingPipelineInput {
    /// In the coordinates of its model; finite.
    pub point: [f64; 3],
    /// Affine; it may be singular.
    pub world_from_model: Matrix,
    /// Who looks.
    pub camera: Camera,
    /// The pixels of the picture.
    pub viewport: Viewport,
}

impl ViewingPipelineInput {
    /// The matrix that leads into a space.
    #[must_use]
    pub fn matrix(&self, into: PipelineSpace) -> Matrix {
        match into {
            PipelineSpace::World => self.world_from_model,
            PipelineSpace::View => self.camera.view_from_world(),
            PipelineSpace::Clip => self.camera.volume().clip_from_view(),
        }
    }
}

/// A space that a matrix leads into.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PipelineSpace {
    /// Where all objects stand.
    World,
    /// The camera's own axes.
    View,
    /// Where clipping is done: four coordinates.
    Clip,
}

impl PipelineSpace {
    /// In the order in which a vertex goes through them.
    pub const ALL: [Self; 3] = [Self::World, Self::View, Self::Clip];

    /// Rows that have to be worked out: the last one of an affine matrix has not.
    #[must_use]
    pub const fn n_rows(self) -> usize {
        match self {
            Self::World | Self::View => 3,
            Self::Clip => 4,
        }
    }
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum ViewingPipelineEvent {
    /// A row of a matrix times the vertex.
    Row {
        /// The space that the matrix leads into.
        space: PipelineSpace,
        /// From 0.
        row: usize,
        /// What it comes to.
        value: f64,
    },
    /// The vertex in clip space against −w and w.
    Test {
        /// −w ≤ x, y, z ≤ w
        inside: bool,
    },
    /// Divided by w.
    Divide {
        /// Normalised device coordinates.
        ndc: [f64; 3],
    },
    /// On the picture.
    Screen {
        /// In pixels from the top left.
        screen: [f64; 2],
    },
    /// w ≤ 0: not before the eye, and on no screen.
    Behind,
}

/// The answer.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct ViewingPipelineOutput {
    /// In the world.
    pub world: [f64; 3],
    /// In the camera's own axes.
    pub view: [f64; 3],
    /// In clip space.
    pub clip: [f64; 4],
    /// −w ≤ x, y, z ≤ w
    pub inside: bool,
    /// Where w > 0: divided by it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ndc: Option<[f64; 3]>,
    /// And in pixels from the top left.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub screen: Option<[f64; 2]>,
}

impl ViewingPipelineOutput {
    /// The coordinates in a space; before they are worked out they are 0.
    #[must_use]
    pub const fn at(&self, space: PipelineSpace) -> &[f64] {
        match space {
            PipelineSpace::World => &self.world,
            PipelineSpace::View => &self.view,
            PipelineSpace::Clip => &self.clip,
        }
    }

    const fn at_mut(&mut self, space: PipelineSpace) -> &mut [f64] {
        match space {
            PipelineSpace::World => &mut self.world,
            PipelineSpace::View => &mut self.view,
            PipelineSpace::Clip => &mut self.clip,
        }
    }
}

/// A row of a matrix times a point whose fourth coordinate is 1, summed up in this order; not finite only where it is larger than any
/// number, or the point is not finite.
#[inline]
#[must_use]
pub fn row_times<R: Real>(row: [f64; 4], [x, y, z]: [R; 3]) -> R {
    let sum = sum(row, [x, y, z]);
    if is_plain(sum.get()) {
        sum
    } else {
        R::new(wide_sum(row, [x, y, z].map(R::get)))
    }
}

#[inline]
fn sum<R: Real>(row: [f64; 4], [x, y, z]: [R; 3]) -> R {
    let [a, b, c, d] = row.map(R::new);
    a * x + b * y + c * z + d
}

#[cold]
fn wide_sum(row: [f64; 4], from: [f64; 3]) -> f64 {
    sum(row, from.map(Wide::new)).get()
}

impl Method for ViewingPipeline {
    type Input = ViewingPipelineInput;
    type Held = ViewingPipelineOutput;
    type Output = ViewingPipelineOutput;
    type Event = ViewingPipelineEvent;

    #[inline]
    fn begin(_: &Self::Input) -> Self::Held {
        ViewingPipelineOutput::default()
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let mut at = [R::new(0.0); 4];
        let mut from = input.point.map(R::new);
        for space in PipelineSpace::ALL {
            let rows = input.matrix(space).rows();
            for row in 0..space.n_rows() {
                at[row] = row_times(rows[row], from);
                let value = at[row].get();
                held.at_mut(space)[row] = value;
                tell.tell(held, ViewingPipelineEvent::Row { space, row, value })?;
            }
            from = [at[0], at[1], at[2]];
        }
        let [x, y, z, w] = at;
        let inside = [x, y, z].iter().all(|&along| -w <= along && along <= w);
        held.inside = inside;
        tell.tell(held, ViewingPipelineEvent::Test { inside })?;
        if w > R::new(0.0) {
            let divided = [x / w, y / w, z / w];
            let ndc = divided.map(R::get);
            held.ndc = Some(ndc);
            tell.tell(held, ViewingPipelineEvent::Divide { ndc })?;
            let pixels = input.viewport.screen_from_ndc([divided[0], divided[1]]);
            let screen = pixels.map(R::get);
            held.screen = Some(screen);
            tell.tell(held, ViewingPipelineEvent::Screen { screen })
        } else {
            tell.tell(held, ViewingPipelineEvent::Behind)
        }
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    /// Ten rows, the test, the divide and the viewport.
    fn max_events(_: &Self::Input) -> usize {
        13
    }
}
