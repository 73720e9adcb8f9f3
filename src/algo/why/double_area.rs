//! Why a₁·b₂ and b₁·a₂ tell on which side of the line from P₁ through a corner P₂ lies. The lines of the corner's edges divide the rectangle from P₁ to P₂ into
//! four; the products are the two of them that the corner parts from both ends. The way over the corner halves the other two, so what is to its left differs from
//! what is to its right by the products alone. The straight way halves all four together. Between both ways lies the triangle P₁CP₂: to the left of the way over the
//! corner there is as much more than half as there is less to its right. So b₁·a₂ − a₁·b₂ is twice the triangle, with a sign: positive where P₂ lies to the left.
//! *Cost*: five multiplications and as many sums.
//!
//! *Source*: that both rectangles are equal where the corner lies on the straight way is Euclid's Elements, I.43.

use serde::Serialize;

use crate::{
    algo::line::{CornerLine, NichollLeeNicholl, NichollLeeNichollEvent, WindowInput},
    geom::{Point, Segment},
    trace::{Real, Recording, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct DoubleArea;

/// A segment, and the line through a corner beside which it ends.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DoubleAreaInput {
    given: WindowInput,
    line: Option<CornerLine>,
}

impl From<WindowInput> for DoubleAreaInput {
    /// With the first line that Nicholl–Lee–Nicholl tests, whose corner lies in the rectangle from P₁ to P₂.
    fn from(given: WindowInput) -> Self {
        let run = Recording::<NichollLeeNicholl>::new(given);
        let line = run.events().iter().find_map(|event| match *event {
            NichollLeeNichollEvent::Side { line, .. } => Some(line),
            _ => None,
        });
        Self { given, line }
    }
}

impl DoubleAreaInput {
    /// The segment from P₁ to P₂, and whose corner it is.
    #[must_use]
    pub const fn given(&self) -> &WindowInput {
        &self.given
    }

    /// The line from P₁ through the corner; none where no corner is tested.
    #[must_use]
    pub const fn line(&self) -> Option<CornerLine> {
        self.line
    }

    /// From the corner, `(a₁, b₁)` and `(a₂, b₂)`.
    #[must_use]
    pub fn measured(&self) -> Option<[[f64; 2]; 2]> {
        let corner = self.line?.corner;
        let from_corner = |at: Point| [at.x() - corner.x(), at.y() - corner.y()];
        let Segment { p1, p2 } = self.given.segment;
        Some([p1, p2].map(from_corner))
    }

    /// On the way from P₁ over the corner: is the rectangle of a₁ and b₂ to the left, and that of b₁ and a₂ to the right?
    #[must_use]
    pub fn is_first_left(&self) -> bool {
        let Segment { p1, p2 } = self.given.segment;
        (p1.x() <= p2.x()) == (p1.y() <= p2.y())
    }
}

/// What is shown, in order: all areas are positive up to the triangle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum DoubleAreaFact {
    /// No corner is tested. The end.
    Nothing,
    /// The rectangle |a₁| wide and |b₂| high.
    First,
    /// The rectangle |a₂| wide and |b₁| high.
    Second,
    /// Half of what else there is, on each side of the way over the corner.
    Ends,
    /// Half of all, on each side of the straight way.
    Half,
    /// By how much there is more than half to the left of the way over the corner.
    Triangle,
    /// The left rectangle less the right one, as b₁·a₂ − a₁·b₂. The end.
    Twice,
}

fn size<R: Real>(x: R) -> R {
    if x < R::new(0.0) { -x } else { x }
}

impl Proof for DoubleArea {
    type Input = DoubleAreaInput;
    type Fact = DoubleAreaFact;

    fn prove<R: Real, S>(
        input: &DoubleAreaInput,
        show: &mut impl FnMut(DoubleAreaFact, R) -> Told<S>,
    ) -> Told<S> {
        let Some(ends) = input.measured() else {
            return show(DoubleAreaFact::Nothing, R::new(0.0));
        };
        let [[a1, b1], [a2, b2]] = ends.map(|at| at.map(R::new));
        let two = R::new(2.0);
        let [first, second] = [size(a1 * b2), size(b1 * a2)];
        show(DoubleAreaFact::First, first)?;
        show(DoubleAreaFact::Second, second)?;
        let ends = (size(a1 * b1) + size(a2 * b2)) / two;
        show(DoubleAreaFact::Ends, ends)?;
        let half = size((a2 - a1) * (b2 - b1)) / two;
        show(DoubleAreaFact::Half, half)?;
        let left = if input.is_first_left() { first } else { second };
        show(DoubleAreaFact::Triangle, left + ends - half)?;
        show(DoubleAreaFact::Twice, b1 * a2 - a1 * b2)
    }

    fn max_facts(_: &DoubleAreaInput) -> usize {
        6
    }
}
