//! What a polygon clipper that can be shown has beyond any other algorithm.

use crate::{geom::Point, labs::prelude::*};

use super::{GivenSubject, Scene, UnfitScene};

pub trait PolygonTelling: Telling {
    const CLIPS: bool = true;
    const CARRIES_TEXTURE: bool = false;
    const GIVEN: GivenSubject = GivenSubject::Whole;
    const KNOWS_HOLES: bool = false;
    /// What its drawing calls the subject's vertices.
    const SUBJECT: char = 'V';

    /// Its input, or what in the scene it cannot take.
    fn input(scene: &Scene) -> Result<Self::Input, UnfitScene>;

    /// The vertex that an event asks whether it stays: where a row keeps or drops what it is about, that is this vertex.
    fn asks(_: &Self::Event) -> Option<Point> {
        None
    }

    /// The clip edge at work, where one is asked at a time.
    fn border(_: &Step<'_, Self>) -> Option<usize> {
        None
    }

    /// What an event says of a vertex of the subject that lies there, where that is not what its row decides.
    fn tells(_: &Self::Event, _at: Point) -> Option<bool> {
        None
    }

    fn crossing(_: &Self::Event) -> Option<Point> {
        None
    }

    /// The outline of the piece that a step finishes.
    fn piece(_: &Step<'_, Self>) -> Option<Vec<Point>> {
        None
    }

    /// Parts of the subject's border that a step has dropped: where that is by a crossing, the step before has decided it.
    fn dropped(_: &Step<'_, Self>) -> Vec<[Point; 2]> {
        Vec::new()
    }

    fn record(scene: &Scene) -> Result<Box<dyn Run>, UnfitScene> {
        let input = Self::input(scene)?;
        Ok(Box::new(Recorded::<Self>::new(input, None)))
    }
}
