//! What the lab knows of a method: the same whatever it runs on.

use crate::{
    figure::Run,
    labs::{self, Demo, Listed, MethodCard},
    trace::{Algorithm, Counted, Counts},
};

use super::{METHODS, Scene};

/// What is known of a method without running it.
pub struct MethodInfo {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// Is it about the scene's point?
    pub asks_point: bool,
    record: fn(&Scene) -> Box<dyn Run>,
    cost: fn(&Scene) -> Counts,
}

/// A method of this lab.
pub trait FrustumDemo: Demo {
    /// Is it about the scene's point?
    const ASKS_POINT: bool = false;

    /// Its input, from the scene.
    fn input(scene: &Scene) -> Self::Input;
    /// Records its run.
    fn record(scene: &Scene) -> Box<dyn Run> {
        labs::record::<Self>(Self::input(scene))
    }
}

impl MethodInfo {
    pub(super) const fn of<A: FrustumDemo>() -> Self {
        Self {
            card: MethodCard::of::<A>(),
            asks_point: A::ASKS_POINT,
            record: A::record,
            cost: |scene| {
                let input = A::input(scene);
                Counts::of(|| <A as Algorithm>::run::<Counted>(&input, |_| {})).1
            },
        }
    }

    /// Runs it on a scene.
    #[must_use]
    pub fn record(&self, scene: &Scene) -> Box<dyn Run> {
        (self.record)(scene)
    }

    /// How many operations it takes, without recording the steps.
    #[must_use]
    pub fn cost(&self, scene: &Scene) -> Counts {
        (self.cost)(scene)
    }
}

impl Listed for MethodInfo {
    fn all() -> &'static [Self] {
        &METHODS
    }

    fn card(&self) -> &MethodCard {
        &self.card
    }
}
