//! Does a triangle show its front to the viewer? With n = (V1 − V0) × (V2 − V0), which points outside, and e from V0 to the eye (for a
//! parallel projection the way back to the viewer): n·e > 0 is a front, 0 is edge-on. The same number is the determinant of the columns
//! e, V1 − V0, V2 − V0. The sign is that of the exact value on the given coordinates; `dot` and `det` are rounded.
//!
//! *Bound*: four events. *Cost*: nine differences (six where the viewer is a direction), a cross and a dot product, the determinant
//! beside them, and one comparison. *Source*: I. E. Sutherland, R. F. Sproull and R. A. Schumacker, "A characterization of ten
//! hidden-surface algorithms", ACM Computing Surveys 6, 1974, pp. 1–55.
//!
//! ```
//! use clipscope::{algo::cull::{BackFace, BackFaceInput, Viewer}, trace::silent};
//! let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let seen_from = |eye| silent::<BackFace>(&BackFaceInput { triangle, viewer: Viewer::Eye(eye) });
//! assert!(seen_from([5.0, 5.0, 1.0]).front);
//! assert!(!seen_from([5.0, 5.0, 0.0]).front, "edge-on");
//! ```

use std::{marker::PhantomData, ops::Range};

use serde::Serialize;

use crate::{
    algo::ring::Right,
    geom::{Wide, minor_extent, sign_of_four},
    trace::{Method, Real, Tell, Told},
};

use super::CullRules;

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct BackFace<L = Right>(PhantomData<L>);

/// A triangle, and who looks at it. All numbers are finite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BackFaceInput {
    /// V0, V1, V2, counter-clockwise as seen from outside.
    pub triangle: [[f64; 3]; 3],
    /// Who looks.
    pub viewer: Viewer,
}

/// Where a triangle is looked at from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Viewer {
    /// From this point, in perspective.
    Eye([f64; 3]),
    /// From far away, looking this way: not zero.
    Direction([f64; 3]),
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum BackFaceEvent {
    /// n
    Normal {
        /// V1 − V0 and V2 − V0.
        edges: [[f64; 3]; 2],
        /// Their cross product, not normalised.
        normal: [f64; 3],
    },
    /// e, from V0 to the viewer.
    ToViewer {
        /// eye − V0, or the way back along the direction of sight.
        to_viewer: [f64; 3],
    },
    /// Both products.
    Products {
        /// n·e
        dot: f64,
        /// |e, V1 − V0, V2 − V0|
        det: f64,
    },
    /// The answer.
    Done {
        /// Does it show its front?
        front: bool,
    },
}

/// The answer.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct BackFaceOutput {
    /// Does it show its front? Edge-on it does not.
    pub front: bool,
    /// n·e
    pub dot: f64,
    /// |e, V1 − V0, V2 − V0|
    pub det: f64,
}

impl<L: CullRules> Method for BackFace<L> {
    type Input = BackFaceInput;
    type Held = BackFaceOutput;
    type Output = BackFaceOutput;
    type Event = BackFaceEvent;

    #[inline]
    fn begin(_: &Self::Input) -> Self::Held {
        BackFaceOutput::default()
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let input = &BackFaceInput {
            triangle: taken(input.triangle, L::CLOCKWISE),
            ..*input
        };
        let (edges, e) = vectors::<R>(input);
        let normal = cross(edges);
        let perpendicular = BackFaceEvent::Normal {
            edges: edges.map(|edge| edge.map(R::get)),
            normal: normal.map(R::get),
        };
        tell.tell(held, perpendicular)?;
        let to_viewer = e.map(R::get);
        tell.tell(held, BackFaceEvent::ToViewer { to_viewer })?;
        let dot = product(normal, e);
        let det = determinant([e, edges[0], edges[1]]);
        let size = size(edges, e);
        [held.dot, held.det] = in_range(input, size, [dot, det].map(R::get));
        let products = BackFaceEvent::Products {
            dot: held.dot,
            det: held.det,
        };
        tell.tell(held, products)?;
        held.front = is_front(input, size, e, dot);
        let front = held.front;
        tell.tell(held, BackFaceEvent::Done { front })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    fn max_events(_: &Self::Input) -> usize {
        4
    }
}

/// The corners as they are taken to run counter-clockwise.
const fn taken([v0, v1, v2]: [[f64; 3]; 3], clockwise: bool) -> [[f64; 3]; 3] {
    if clockwise {
        [v0, v2, v1]
    } else {
        [v0, v1, v2]
    }
}

/// V1 − V0 and V2 − V0; and e, from V0 to the viewer.
#[inline]
fn vectors<R: Real>(input: &BackFaceInput) -> ([[R; 3]; 2], [R; 3]) {
    let [v0, v1, v2] = input.triangle.map(|v| v.map(R::new));
    let e = match input.viewer {
        Viewer::Eye(eye) => minus(eye.map(R::new), v0),
        Viewer::Direction(view) => view.map(|x| -R::new(x)),
    };
    ([minus(v1, v0), minus(v2, v0)], e)
}

/// n and e.
pub(in crate::algo) fn normal_and_viewer<R: Real>(input: &BackFaceInput) -> [[R; 3]; 2] {
    let (edges, e) = vectors(input);
    [cross(edges), e]
}

fn minus<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross<R: Real>([a, b]: [[R; 3]; 2]) -> [R; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn product<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Of three columns, by the rule of Sarrus.
fn determinant<R: Real>([a, b, c]: [[R; 3]; 3]) -> R {
    let down = a[0] * b[1] * c[2] + b[0] * c[1] * a[2] + c[0] * a[1] * b[2];
    let up = a[2] * b[1] * c[0] + b[2] * c[1] * a[0] + c[2] * a[1] * b[0];
    down - up
}

/// Sizes of n·e in this range have neither overflown nor lost bits.
const PLAIN: Range<f64> = 1e-250..1e250;

/// How large the products of n·e are, all taken together.
fn size<R: Real>(edges: [[R; 3]; 2], e: [R; 3]) -> f64 {
    let [a, b] = edges.map(|edge| edge.map(|x| x.get().abs()));
    let sizes = (0..3).map(|i| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        (a[j] * b[k] + a[k] * b[j]) * e[i].get().abs()
    });
    sizes.sum()
}

/// n·e and the determinant as they were computed; where they are farther apart than by rounding, products have left the range of f64.
fn in_range(input: &BackFaceInput, size: f64, [dot, det]: [f64; 2]) -> [f64; 2] {
    if PLAIN.contains(&size) && (dot - det).abs() <= 64.0 * f64::EPSILON * size {
        [dot, det]
    } else {
        wide_products(input)
    }
}

#[cold]
fn wide_products(input: &BackFaceInput) -> [f64; 2] {
    let (edges, e) = vectors::<Wide>(input);
    let det = determinant([e, edges[0], edges[1]]);
    [product(cross(edges), e), det].map(Wide::get)
}

/// Is n·e > 0? The rounded product tells where rounding cannot have turned its sign; else the exact determinant.
fn is_front<R: Real>(input: &BackFaceInput, size: f64, e: [R; 3], dot: R) -> bool {
    let is_positive = dot > R::new(0.0);
    // A term has nine roundings at most: three differences, two products and four sums; and small products may vanish.
    let vanishing: f64 = e
        .iter()
        .map(|e| minor_extent([0.0; 2]) * e.get().abs())
        .sum();
    let bound = 16.0 * f64::EPSILON * (size + vanishing);
    if PLAIN.contains(&bound) && dot.get().abs() > bound {
        return is_positive;
    }
    let [v0, v1, v2] = input.triangle.map(|[x, y, z]| [x, y, z, 1.0]);
    let viewer = match input.viewer {
        Viewer::Eye([x, y, z]) => [x, y, z, 1.0],
        Viewer::Direction([x, y, z]) => [-x, -y, -z, 0.0],
    };
    // With the viewer in the last row the determinant is that of the columns, negated: erratum E1 of S0.
    sign_of_four([v0, v1, v2, viewer]).is_lt()
}
