//! Why 1/depth is what is linear on the screen. A fence of posts 1 high has a straight top, and a straight line looks straight. On the screen
//! a post is 1/depth high. So from post to post, at equal steps on the screen, 1/depth changes by equal amounts; the depth itself does not: where a
//! sight line meets the fence is found by where two straight lines meet. *Cost*: three divisions, and one a post.

use serde::Serialize;

use crate::trace::{Real, Told};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Fence;

/// Both ends of the fence as the eye has them: across and ahead, in front of the eye and not in one line of sight.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FenceInput {
    ends: Option<[[f64; 2]; 2]>,
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum FenceFact {
    /// There is no fence that can be seen from aside: the end.
    Nothing,
    /// The depth of the first end.
    First,
    /// The depth of the last end.
    Last,
    /// The depth of a post between them, at an equal step on the screen.
    Post {
        /// From 1.
        nth: usize,
    },
    /// The height of the first post on the screen: 1/depth.
    Height,
    /// By how much less high the last post is.
    Drop,
    /// The same for each step: the end.
    Step,
}

impl FenceInput {
    /// Equal steps on the screen.
    pub const STEPS: usize = 5;

    /// A fence between two places, the nearer one first, if it can be seen from aside.
    #[must_use]
    pub fn new(mut ends: [[f64; 2]; 2]) -> Self {
        if ends[1][1] < ends[0][1] {
            ends.reverse();
        }
        let [from, to] = ends.map(|[across, ahead]| across / ahead);
        let is_seen = ends.iter().all(|[_, ahead]| *ahead > 0.0) && (to - from).abs() > 1e-9;
        Self {
            ends: is_seen.then_some(ends),
        }
    }

    /// None of them.
    pub const NONE: Self = Self { ends: None };

    /// Both ends, if they can be seen.
    #[must_use]
    pub const fn ends(&self) -> Option<[[f64; 2]; 2]> {
        self.ends
    }
}

/// How deep the fence is after so many steps on the screen: where the sight line meets it.
fn depth<R: Real>(ends: [[f64; 2]; 2], nth: usize) -> R {
    let [[x1, d1], [x2, d2]] = ends.map(|at| at.map(R::new));
    let part = R::new(nth as f64) / R::new(FenceInput::STEPS as f64);
    let sight = x1 / d1 + part * (x2 / d2 - x1 / d1);
    let (dx, dd) = (x2 - x1, d2 - d1);
    let t = (sight * d1 - x1) / (dx - sight * dd);
    d1 + t * dd
}

impl Proof for Fence {
    type Input = FenceInput;
    type Fact = FenceFact;

    fn prove<R: Real, S>(
        input: &FenceInput,
        show: &mut impl FnMut(FenceFact, R) -> Told<S>,
    ) -> Told<S> {
        let Some(ends) = input.ends else {
            return show(FenceFact::Nothing, R::new(0.0));
        };
        let [first, last] = ends.map(|[_, ahead]| R::new(ahead));
        show(FenceFact::First, first)?;
        show(FenceFact::Last, last)?;
        for nth in 1..FenceInput::STEPS {
            show(FenceFact::Post { nth }, depth(ends, nth))?;
        }
        let one = R::new(1.0);
        show(FenceFact::Height, one / first)?;
        let drop = one / first - one / last;
        show(FenceFact::Drop, drop)?;
        show(FenceFact::Step, drop / R::new(FenceInput::STEPS as f64))
    }

    fn max_facts(_: &FenceInput) -> usize {
        FenceInput::STEPS + 4
    }
}
