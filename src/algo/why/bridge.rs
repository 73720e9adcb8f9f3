//! Why a bridge has no area. Each edge of a ring sweeps a strip from where strips begin to itself: added where the edge goes up, taken away where it
//! goes down. All strips together are the area, wherever they begin. A bridge is walked there and back, so its strip is added once and taken
//! once. *Cost*: two multiplications an edge.

use serde::Serialize;

use crate::{
    geom::pairs_around,
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Bridge;

/// A ring, and two places where strips may begin.
#[derive(Clone, PartialEq, Debug)]
pub struct BridgeInput {
    /// Its vertices, from one to the next and back to the first.
    pub ring: Vec<[f64; 2]>,
    /// The x where strips begin, and another one.
    pub begin: [f64; 2],
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum BridgeFact {
    /// The strip of an edge: how wide it is in its middle, times how far the edge goes up.
    Strip {
        /// From the vertex of this number to the next.
        edge: usize,
    },
    /// All of them.
    Area,
    /// The same where strips begin elsewhere: the end.
    Elsewhere,
}

impl BridgeInput {
    /// From which vertex to which.
    #[must_use]
    pub fn edge(&self, edge: usize) -> [[f64; 2]; 2] {
        [self.ring[edge], self.ring[(edge + 1) % self.ring.len()]]
    }

    /// The edge before this one that it runs over, the other way, and how far: both go straight up or down.
    #[must_use]
    pub fn twin(&self, edge: usize) -> Option<(usize, f64)> {
        let [[x1, y1], [x2, y2]] = self.edge(edge);
        if x1 != x2 {
            return None;
        }
        let common = |&other: &usize| {
            let [[a1, b1], [a2, b2]] = self.edge(other);
            let is_over = a1 == x1 && a2 == x1 && (y2 - y1) * (b2 - b1) < 0.0;
            let [low, high] = [y1.min(y2).max(b1.min(b2)), y1.max(y2).min(b1.max(b2))];
            (is_over && low < high).then_some((other, high - low))
        };
        (0..edge).find_map(|other| common(&other))
    }
}

fn strip<R: Real>([from, to]: [[f64; 2]; 2], begin: f64) -> R {
    let [[x1, y1], [x2, y2]] = [from, to].map(|at| at.map(R::new));
    let width = (x1 + x2) / R::new(2.0) - R::new(begin);
    width * (y2 - y1)
}

impl Proof for Bridge {
    type Input = BridgeInput;
    type Fact = BridgeFact;

    fn prove<R: Real, S>(
        input: &BridgeInput,
        show: &mut impl FnMut(BridgeFact, R) -> Told<S>,
    ) -> Told<S> {
        let [here, elsewhere] = input.begin;
        let mut area = R::new(0.0);
        for edge in 0..input.ring.len() {
            let strip = strip::<R>(input.edge(edge), here);
            area = area + strip;
            show(BridgeFact::Strip { edge }, strip)?;
        }
        show(BridgeFact::Area, area)?;
        let strips = pairs_around(&input.ring).map(|edge| strip::<R>(edge, elsewhere));
        show(
            BridgeFact::Elsewhere,
            strips.fold(R::new(0.0), |sum, it| sum + it),
        )
    }

    fn max_facts(input: &BridgeInput) -> usize {
        input.ring.len() + 2
    }
}
