//! What all proofs by picture share: a fact's number by its name, and a drawing that grows by one part with each fact.

use serde::Serialize;

use crate::{
    algo::why::{Facts, Proof, Why},
    figure::{Multiples, SmallDrawing},
    labs::prelude::*,
};

impl<F: Serialize> AnswerAsItIs for Facts<F> {}

/// The number of a fact, by the name that sentences and formulas know it by.
pub fn fact<P: Proof>(
    step: &Step<'_, Why<P>>,
    names: &[(&str, P::Fact)],
    name: &str,
) -> Option<f64> {
    let (_, fact) = names.iter().find(|(of, _)| *of == name)?;
    step.held.get(*fact)
}

/// What is drawn: of each fact its marks, lit at its own step and kept after it.
pub struct Picture<'a, P: Proof> {
    held: &'a Facts<P::Fact>,
    now: Option<P::Fact>,
    marks: Vec<Mark>,
}

impl<'a, P: Proof> Picture<'a, P> {
    /// With what is given before anything is shown.
    pub fn new(step: &Step<'a, Why<P>>, given: Vec<Mark>) -> Self {
        Self {
            held: step.held,
            now: step.event().map(|shown| shown.fact),
            marks: given,
        }
    }

    pub fn is_now(&self, fact: P::Fact) -> bool {
        self.now == Some(fact)
    }

    /// Draws a fact, if it has been shown, in the role of what this step is about, or else in `kept`.
    pub fn once<I: IntoIterator<Item = Mark>>(
        &mut self,
        fact: P::Fact,
        kept: Role,
        draw: impl FnOnce(Role, f64) -> I,
    ) {
        let role = if self.is_now(fact) {
            Role::Signal
        } else {
            kept
        };
        if let Some(number) = self.held.get(fact) {
            self.marks.extend(draw(role, number));
        }
    }

    /// In the drawing of the scene itself.
    pub fn in_scene(self) -> View {
        View::plane(self.marks)
    }

    /// Under a title that says from where it is seen; the bounds are the same at every step.
    pub fn view(self, title: &'static str, bounds: [[f64; 2]; 2]) -> View {
        let drawings = vec![SmallDrawing::new(Value::Term(title), None, self.marks)];
        let multiples = Multiples {
            drawings,
            bounds,
            tiles: Tiles::Large,
        };
        View::new("why", Body::Multiples(multiples))
    }
}

pub const fn mark(role: Role, shape: Shape) -> Mark {
    Mark::new(role, shape)
}

pub fn segment(role: Role, from: [f64; 2], to: [f64; 2]) -> Mark {
    mark(role, Shape::Segment([from, to]))
}

/// What holds all of these places, and a margin.
pub fn around(places: impl IntoIterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    const MARGIN: f64 = 0.14;
    let widened = |[min, max]: [[f64; 2]; 2], at: [f64; 2]| {
        let low = [0, 1].map(|i| min[i].min(at[i]));
        [low, [0, 1].map(|i| max[i].max(at[i]))]
    };
    let places = places.into_iter();
    let [min, max] = places.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], widened);
    let size = (max[0] - min[0])
        .max(max[1] - min[1])
        .max(f64::MIN_POSITIVE);
    [
        min.map(|x| x - MARGIN * size),
        max.map(|x| x + MARGIN * size),
    ]
}
