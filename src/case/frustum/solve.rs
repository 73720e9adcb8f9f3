//! What each of the lab's algorithms reads, and how its answer is told.

use crate::{
    algo::cull::{
        BackFace, BackFaceInput, BackFaceOutput, BoxCull, BoxCullInput, BoxCullOutput, Containment,
        PointPlanes, PointPlanesInput, PointPlanesOutput, SphereCull, SphereCullInput,
        SphereCullOutput,
    },
    case::{Field, Fields, Refusal, SolveTold, Told},
    labs::plane_symbol,
    text::Message,
};

use super::reader::Reader;

impl SolveTold for PointPlanes {
    const FIELDS: &'static [Field] = &[
        Field::choice("planes"),
        Field::choice("frustum"),
        Field::required("point"),
    ];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (planes, point) = (reader.planes()?, reader.point()?);
        let input = PointPlanesInput { planes, point };
        Ok((input, reader.told()))
    }

    fn verdict(output: &PointPlanesOutput) -> Message {
        Message::new(if output.inside {
            "case-point-inside"
        } else {
            "case-point-outside"
        })
    }
}

impl SolveTold for SphereCull {
    const FIELDS: &'static [Field] = &[
        Field::choice("planes"),
        Field::choice("frustum"),
        Field::required("sphere"),
    ];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (planes, sphere) = (reader.planes()?, reader.sphere()?);
        let input = SphereCullInput { planes, sphere };
        Ok((input, reader.told()))
    }

    fn verdict(output: &SphereCullOutput) -> Message {
        match (output.class, output.distances.last()) {
            (Containment::Outside, Some(&distance)) => Message::new("case-cull-outside")
                .with("plane", plane_symbol(output.distances.len() - 1))
                .with("distance", distance),
            (Containment::Inside | Containment::Outside, _) => Message::new("case-cull-inside"),
            (Containment::Straddles, _) => Message::new("case-cull-straddles"),
        }
    }
}

impl SolveTold for BoxCull {
    const FIELDS: &'static [Field] = &[
        Field::choice("planes"),
        Field::choice("frustum"),
        Field::required("box"),
    ];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (planes, bounds) = (reader.planes()?, reader.bounds()?);
        let input = BoxCullInput { planes, bounds };
        Ok((input, reader.told()))
    }

    fn verdict(output: &BoxCullOutput) -> Message {
        Message::new(match output.class {
            Containment::Inside => "case-cull-inside",
            Containment::Outside => "case-box-outside",
            Containment::Straddles if output.false_positive => "case-cull-in-vain",
            Containment::Straddles => "case-cull-straddles",
        })
    }
}

impl SolveTold for BackFace {
    const FIELDS: &'static [Field] = &[
        Field::required("triangle"),
        Field::choice("eye"),
        Field::choice("view_dir"),
    ];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (triangle, viewer) = (reader.triangle()?, reader.viewer()?);
        let input = BackFaceInput { triangle, viewer };
        Ok((input, reader.told()))
    }

    fn verdict(output: &BackFaceOutput) -> Message {
        let key = if output.front {
            "case-front"
        } else {
            "case-back"
        };
        Message::new(key).with("dot", output.dot)
    }
}
