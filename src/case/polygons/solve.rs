//! What each of the lab's algorithms reads, and how its answer is told.

use crate::{
    algo::polygon::{EarClipping, TriangulateAndClip, TriangulateAndClipInput},
    case::{Field, Refusal},
    geom::SimplePolygon,
    labs::Demo,
    text::Message,
};

use super::{
    Reader,
    verdict::{polygons, triangles},
};

/// A method that a case can name.
pub trait Solve: Demo {
    /// In the order in which they are read.
    const FIELDS: &'static [Field];
    /// Its input, from checked fields.
    fn read(reader: &mut Reader<'_>) -> Result<Self::Input, Refusal>;
    /// Its answer in one sentence.
    fn verdict(output: &Self::Output) -> Message;
}

const ALONE: [Field; 1] = [Field::required("polygon")];
const CLIPPED: [Field; 3] = [
    Field::choice("window"),
    Field::choice("clip"),
    Field::required("polygon"),
];

impl Solve for EarClipping {
    const FIELDS: &'static [Field] = &ALONE;

    fn read(reader: &mut Reader<'_>) -> Result<SimplePolygon, Refusal> {
        reader.simple_polygon()
    }

    fn verdict(output: &Self::Output) -> Message {
        triangles(output)
    }
}
