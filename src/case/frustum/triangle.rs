//! Triangles cut by planes and by the clip volume.

use crate::{
    algo::volume::{
        ClipPolygon, ClipVertex, CutTriangles, HomogeneousTriangle, IntersectionPolygon,
        PlaneAtATime, SpaceVertex, TrianglePlanes,
    },
    case::{Fields, Refusal, Solve},
    input::{FRUSTUM, Field, Shape},
    text::Message,
};

use super::{
    parts::{CLIP_TRIANGLE, PLANES, TRIANGLE, UV},
    planes,
};

/// What both methods that ask planes take.
const CUT: [Field; 4] = [
    PLANES.choice(),
    FRUSTUM.choice(),
    TRIANGLE.required(),
    UV.optional,
];

const LEFT: [Field; 2] = [
    Field::required("triangles", &Shape::List(TRIANGLE.optional.shape)),
    UVS,
];
const UVS: Field = Field::optional("uv", &Shape::List(UV.optional.shape));

fn read_planes(fields: &Fields<'_>) -> Result<TrianglePlanes, Refusal> {
    let (planes, corners) = (planes(fields)?, fields.need(&TRIANGLE)?);
    let uv = fields.get(&UV)?;
    let triangle = std::array::from_fn(|i| SpaceVertex {
        at: corners[i],
        uv: uv.map(|uv| uv[i]),
    });
    Ok(TrianglePlanes { planes, triangle })
}

fn left(n_triangles: usize) -> Message {
    let key = if n_triangles == 0 {
        "case-triangles-none"
    } else {
        "case-triangles-left"
    };
    Message::new(key).with("triangles", n_triangles)
}

impl Solve for PlaneAtATime {
    const FIELDS: &'static [Field] = &CUT;
    const OUTPUT: &'static [Field] = &LEFT;

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        read_planes(fields)
    }

    fn verdict(output: &CutTriangles) -> Message {
        left(output.triangles.len())
    }
}

impl Solve for IntersectionPolygon {
    const FIELDS: &'static [Field] = &CUT;
    const OUTPUT: &'static [Field] = &LEFT;

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        read_planes(fields)
    }

    fn verdict(output: &CutTriangles) -> Message {
        left(output.triangles.len())
    }
}

impl Solve for HomogeneousTriangle<Option<[f64; 2]>> {
    const FIELDS: &'static [Field] = &[CLIP_TRIANGLE.required(), UV.optional];
    const OUTPUT: &'static [Field] = &[
        Field::required("triangles", &Shape::List(CLIP_TRIANGLE.optional.shape)),
        UVS,
    ];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (corners, uv) = (fields.need(&CLIP_TRIANGLE)?, fields.get(&UV)?);
        let own: [_; 3] = std::array::from_fn(|i| ClipVertex {
            at: corners[i],
            attributes: uv.map(|uv| uv[i]),
        });
        Ok(own)
    }

    fn verdict(output: &ClipPolygon<Option<[f64; 2]>>) -> Message {
        left(output.triangles().count())
    }
}
