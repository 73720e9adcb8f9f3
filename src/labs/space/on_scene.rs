//! An algorithm that runs on something of a scene, together with the scene that it is drawn in.

use std::{marker::PhantomData, sync::Arc};

use crate::trace::{Algorithm, Real};

use super::stage::Scenery;

/// The algorithm `A`, shown in its scene.
#[derive(Clone, Copy, Debug)]
pub struct OnScene<A>(PhantomData<A>);

/// What `A` reads, and where it is drawn.
#[derive(Clone, Debug)]
pub struct OnSceneInput<I> {
    /// What the algorithm reads.
    pub own: I,
    /// What is drawn; none where a case gives numbers alone.
    pub scenery: Option<Arc<Scenery>>,
}

impl<I> From<I> for OnSceneInput<I> {
    /// Of numbers alone.
    fn from(own: I) -> Self {
        let scenery = None;
        Self { own, scenery }
    }
}

impl<I> OnSceneInput<I> {
    /// Of a scene.
    pub fn of(scene: &super::Scene, own: I) -> Self {
        let scenery = Some(Arc::new(Scenery::new(scene)));
        Self { own, scenery }
    }
}

impl<A: Algorithm> Algorithm for OnScene<A> {
    type Input = OnSceneInput<A::Input>;
    type Output = A::Output;
    type Event = A::Event;
    type State = A::State;

    fn run<R: Real>(input: &Self::Input, emit: impl FnMut(Self::Event)) -> Self::Output {
        A::run::<R>(&input.own, emit)
    }

    fn start(input: &Self::Input) -> Self::State {
        A::start(&input.own)
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        A::apply(state, event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        A::finish(state)
    }

    fn max_events(input: &Self::Input) -> usize {
        A::max_events(&input.own)
    }
}
