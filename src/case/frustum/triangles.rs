//! Triangles cut by planes and by the clip volume: what a case gives, and how the answer is told.

use crate::{
    algo::volume::{
        ClipPolygon, ClipVertex, CutTriangles, HomogeneousTriangle, IntersectionPolygon,
        PlaneAtATime, SpaceVertex, TrianglePlanes,
    },
    case::{Field, Fields, Given, Refusal, SolveTold, Told},
    text::{Formula, Message, Value},
};

use super::reader::Reader;

/// What both methods that ask planes take.
const FIELDS: &[Field] = &[
    Field::choice("planes"),
    Field::choice("frustum"),
    Field::required("triangle"),
    Field::optional("uv"),
];

impl Reader<'_> {
    /// `triangle` in clip space.
    fn clip_triangle(&mut self) -> Result<[[f64; 4]; 3], Refusal> {
        let triangle: [[f64; 4]; 3] = self.need("triangle")?.rows()?;
        let corner = |(name, at): (&'static str, [f64; 4])| {
            let formula = Formula::default().sym(name).sym("(").list(&at);
            Value::Formula(formula.sym(")"))
        };
        let corners = ["V₀ = ", "V₁ = ", "V₂ = "].into_iter().zip(triangle);
        self.tell(Given::new("object-triangle", corners.map(corner)));
        Ok(triangle)
    }

    /// `uv`, where it is given.
    fn uv(&mut self) -> Result<[Option<[f64; 2]>; 3], Refusal> {
        let Some(node) = self.get("uv") else {
            return Ok([None; 3]);
        };
        let uv: [[f64; 2]; 3] = node.rows()?;
        self.tell(Given::new(
            "object-triangle-uv",
            uv.into_iter().map(Value::Point),
        ));
        Ok(uv.map(Some))
    }
}

fn read_planes(fields: &Fields<'_>) -> Result<(TrianglePlanes, Told), Refusal> {
    let mut reader = Reader::new(fields);
    let (planes, corners, uv) = (reader.planes()?, reader.triangle()?, reader.uv()?);
    let triangle = std::array::from_fn(|i| SpaceVertex {
        at: corners[i],
        uv: uv[i],
    });
    Ok((TrianglePlanes { planes, triangle }, reader.told()))
}

fn left(n_triangles: usize) -> Message {
    let key = if n_triangles == 0 {
        "case-triangles-none"
    } else {
        "case-triangles-left"
    };
    Message::new(key).with("triangles", n_triangles)
}

impl SolveTold for PlaneAtATime {
    const FIELDS: &'static [Field] = FIELDS;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        read_planes(fields)
    }

    fn verdict(output: &CutTriangles) -> Message {
        left(output.triangles.len())
    }
}

impl SolveTold for IntersectionPolygon {
    const FIELDS: &'static [Field] = FIELDS;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        read_planes(fields)
    }

    fn verdict(output: &CutTriangles) -> Message {
        left(output.triangles.len())
    }
}

impl SolveTold for HomogeneousTriangle<Option<[f64; 2]>> {
    const FIELDS: &'static [Field] = &[Field::required("triangle"), Field::optional("uv")];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (corners, uv) = (reader.clip_triangle()?, reader.uv()?);
        let own: [_; 3] = std::array::from_fn(|i| ClipVertex {
            at: corners[i],
            attributes: uv[i],
        });
        Ok((own, reader.told()))
    }

    fn verdict(output: &ClipPolygon<Option<[f64; 2]>>) -> Message {
        left(output.triangles().count())
    }
}
