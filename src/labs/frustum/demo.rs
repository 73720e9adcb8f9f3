//! What a method of this lab has beyond any other that can be shown.

use crate::{
    figure::Run,
    labs::{self, Demo},
};

use super::{Scene, Subject};

/// A method of this lab.
pub trait FrustumDemo: Demo {
    /// What it is about.
    const SUBJECT: Subject = Subject::Object;

    /// Its input, from the scene.
    fn input(scene: &Scene) -> Self::Input;

    /// Records its run.
    fn record(scene: &Scene) -> Box<dyn Run> {
        labs::record::<Self>(Self::input(scene))
    }
}
