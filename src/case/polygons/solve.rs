//! What each of the lab's algorithms reads, and how its answer is told.

use crate::{
    algo::polygon::{
        EarClipping, Pipeline, SutherlandHodgman, SutherlandHodgmanInput, Textured,
        TriangulateAndClip, TriangulateAndClipInput,
        weiler_atherton::{Clipped, WeilerAtherton, WeilerAthertonInput},
    },
    case::{Field, Refusal},
    geom::SimplePolygon,
    labs::Demo,
    text::Message,
};

use super::{
    Reader,
    verdict::{pieces, polygons, ring, triangles},
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

const TEXTURED: [Field; 4] = [CLIPPED[0], CLIPPED[1], CLIPPED[2], Field::optional("uv")];

impl Solve for SutherlandHodgman {
    const FIELDS: &'static [Field] = &TEXTURED;

    fn read(reader: &mut Reader<'_>) -> Result<SutherlandHodgmanInput, Refusal> {
        let region = reader.convex_region()?;
        Ok(SutherlandHodgmanInput::new(region, &reader.polygon()?))
    }

    fn verdict(output: &Self::Output) -> Message {
        ring(output)
    }
}

impl Solve for SutherlandHodgman<Textured> {
    const FIELDS: &'static [Field] = &TEXTURED;

    fn read(reader: &mut Reader<'_>) -> Result<SutherlandHodgmanInput<Textured>, Refusal> {
        let region = reader.convex_region()?;
        let polygon = reader.polygon()?;
        let uvs = reader.uv(polygon.vertices().len())?;
        let vertices = polygon.vertices().iter().zip(uvs);
        Ok(SutherlandHodgmanInput {
            region,
            vertices: vertices.map(|(&at, uv)| Textured { at, uv }).collect(),
        })
    }

    fn verdict(output: &Self::Output) -> Message {
        ring(output)
    }
}

impl Solve for Pipeline {
    const FIELDS: &'static [Field] = &CLIPPED;

    fn read(reader: &mut Reader<'_>) -> Result<Self::Input, Refusal> {
        <SutherlandHodgman>::read(reader)
    }

    fn verdict(output: &Self::Output) -> Message {
        ring(output)
    }
}

const WITH_HOLES: [Field; 4] = [CLIPPED[0], CLIPPED[1], CLIPPED[2], Field::optional("holes")];

impl Solve for WeilerAtherton {
    const FIELDS: &'static [Field] = &WITH_HOLES;

    fn read(reader: &mut Reader<'_>) -> Result<WeilerAthertonInput, Refusal> {
        let clip = reader.simple_clip()?;
        let subject = reader.region()?;
        Ok(WeilerAthertonInput { subject, clip })
    }

    fn verdict(output: &Clipped) -> Message {
        pieces(output)
    }
}

impl Solve for EarClipping {
    const FIELDS: &'static [Field] = &ALONE;

    fn read(reader: &mut Reader<'_>) -> Result<SimplePolygon, Refusal> {
        reader.simple_polygon()
    }

    fn verdict(output: &Self::Output) -> Message {
        triangles(output)
    }
}

impl Solve for TriangulateAndClip {
    const FIELDS: &'static [Field] = &CLIPPED;

    fn read(reader: &mut Reader<'_>) -> Result<TriangulateAndClipInput, Refusal> {
        let region = reader.convex_region()?;
        let polygon = reader.simple_polygon()?;
        Ok(TriangulateAndClipInput { region, polygon })
    }

    fn verdict(output: &Self::Output) -> Message {
        polygons(output.len(), output.rings().map(|ring| (ring, false)))
    }
}
