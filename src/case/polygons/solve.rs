//! What each of the lab's algorithms reads, and how its answer is told.

use crate::{
    algo::polygon::{
        EarClipping, Pipeline, SutherlandHodgman, SutherlandHodgmanInput, Textured,
        TriangulateAndClip, TriangulateAndClipInput,
        weiler_atherton::{WeilerAtherton, WeilerAthertonInput, WeilerAthertonOutput},
    },
    case::{Field, Fields, Refusal, Solve, SolveTold, Told},
    geom::SimplePolygon,
    text::Message,
};

use super::{
    reader::Reader,
    verdict::{pieces, polygons, ring, triangles},
};

const ALONE: [Field; 1] = [Field::required("polygon")];
const CLIPPED: [Field; 3] = [
    Field::choice("window"),
    Field::choice("clip"),
    Field::required("polygon"),
];

const TEXTURED: [Field; 4] = [CLIPPED[0], CLIPPED[1], CLIPPED[2], Field::optional("uv")];

impl Solve for SutherlandHodgman {
    const FIELDS: &'static [Field] = &TEXTURED;

    fn read(fields: &Fields<'_>) -> Result<(SutherlandHodgmanInput, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let region = reader.convex_region()?;
        let input = SutherlandHodgmanInput::new(region, &reader.polygon()?);
        Ok((input, reader.told()))
    }

    fn verdict(output: &Self::Output) -> Message {
        ring(output)
    }
}

impl Solve for SutherlandHodgman<Textured> {
    const FIELDS: &'static [Field] = &TEXTURED;

    fn read(fields: &Fields<'_>) -> Result<(SutherlandHodgmanInput<Textured>, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let region = reader.convex_region()?;
        let polygon = reader.polygon()?;
        let uvs = reader.uv(polygon.vertices().len())?;
        let vertices = polygon.vertices().iter().zip(uvs);
        let input = SutherlandHodgmanInput {
            region,
            vertices: vertices.map(|(&at, uv)| Textured { at, uv }).collect(),
        };
        Ok((input, reader.told()))
    }

    fn verdict(output: &Self::Output) -> Message {
        ring(output)
    }
}

impl Solve for Pipeline {
    const FIELDS: &'static [Field] = &CLIPPED;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        <SutherlandHodgman>::read(fields)
    }

    fn verdict(output: &Self::Output) -> Message {
        ring(output)
    }
}

const WITH_HOLES: [Field; 4] = [CLIPPED[0], CLIPPED[1], CLIPPED[2], Field::optional("holes")];

impl SolveTold for WeilerAtherton {
    const FIELDS: &'static [Field] = &WITH_HOLES;

    fn read(fields: &Fields<'_>) -> Result<(WeilerAthertonInput, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let clip = reader.simple_clip()?;
        let subject = reader.region()?;
        Ok((WeilerAthertonInput { subject, clip }, reader.told()))
    }

    fn verdict(output: &WeilerAthertonOutput) -> Message {
        pieces(output)
    }
}

impl SolveTold for EarClipping {
    const FIELDS: &'static [Field] = &ALONE;

    fn read(fields: &Fields<'_>) -> Result<(SimplePolygon, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let polygon = reader.simple_polygon()?;
        Ok((polygon, reader.told()))
    }

    fn verdict(output: &Self::Output) -> Message {
        triangles(output)
    }
}

impl Solve for TriangulateAndClip {
    const FIELDS: &'static [Field] = &CLIPPED;

    fn read(fields: &Fields<'_>) -> Result<(TriangulateAndClipInput, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let region = reader.convex_region()?;
        let polygon = reader.simple_polygon()?;
        let input = TriangulateAndClipInput { region, polygon };
        Ok((input, reader.told()))
    }

    fn verdict(output: &Self::Output) -> Message {
        polygons(output.len(), output.rings().map(|ring| (ring, false)))
    }
}
