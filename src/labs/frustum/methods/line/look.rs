//! What is particular to lines in space beside what is said of them: where they come from, and how they are written.

use crate::{
    algo::{
        parameter::End,
        segment::{Bounds, Given},
    },
    labs::{
        crossing_formulas::Weights,
        segments::{LineLook, LineStep},
    },
    text::Formula,
};

use super::super::super::{Scene, Subject, stage::Scenery};

/// Bounds in space that can be shown.
pub trait SpaceLine<const N: usize>: LineLook<N, Scenery = Scenery> {
    /// What the method is about.
    const SUBJECT: Subject;

    /// Its input, from the scene.
    fn input(scene: &Scene) -> Self::Input;

    /// A plane's number among the six of a volume.
    fn idx(plane: Self::Plane) -> usize;
}

/// The crossing as a mean of both ends, all coordinates at once.
pub fn mean_formula<const N: usize, B: LineLook<N>>(
    shown: &LineStep<'_, N, B>,
    end: End,
    plane: <B as Bounds<N>>::Plane,
    at: [f64; N],
) -> Formula {
    let symbol = match end {
        End::P1 => "P₁′",
        End::P2 => "P₂′",
    };
    let distances = shown.input.bounds().distances(plane, &shown.ends);
    Weights::across(distances).mean_of_places(symbol, &shown.ends, at)
}
