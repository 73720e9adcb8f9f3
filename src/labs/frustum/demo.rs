//! What a method of this lab has beyond any other that can be shown.

use crate::{
    figure::Run,
    labs::{self, Demo},
};

use super::Scene;

/// A method of this lab.
pub trait FrustumDemo: Demo {
    /// Is it about the scene's point?
    const ASKS_POINT: bool = false;

    /// Is it about a face of the object in focus?
    const ASKS_FACE: bool = false;

    /// Its input, from the scene.
    fn input(scene: &Scene) -> Self::Input;

    /// Records its run.
    fn record(scene: &Scene) -> Box<dyn Run> {
        labs::record::<Self>(Self::input(scene))
    }
}
