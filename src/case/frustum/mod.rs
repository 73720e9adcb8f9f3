//! The frustum lab's cases: a point, a sphere or a box against planes, a triangle against whoever looks at it, a segment
//! in a box, against planes or in clip space, a triangle cut by planes, and the way to the screen.

mod line;
mod parts;
mod triangle;

use crate::{
    algo::{
        cull::{
            BackFace, BackFaceInput, BackFaceOutput, BoxCull, BoxCullInput, BoxCullOutput,
            Containment, PointPlanes, PointPlanesInput, PointPlanesOutput, SphereCull,
            SphereCullInput, SphereCullOutput,
        },
        pipeline::{
            BresenhamInput, LineToPixels, LineToPixelsInput, ViewingPipeline, ViewingPipelineInput,
            ViewingPipelineOutput,
        },
        volume::{
            CohenSutherland3d, HomogeneousLine, HomogeneousTriangle, IntersectionPolygon,
            LiangBarsky3d, PlaneAtATime, PlaneLine,
        },
    },
    geom::{Matrix, Plane},
    input::{CAMERA, Dim, FRUSTUM, Fault, Field, SIZE, Shape},
    labs::plane_symbol,
    text::Message,
};

use super::{Code, Fields, Refusal, Solve, Solver};

use parts::{BOX, EYE, FROM, MODEL, PLANES, POINT, SPHERE, TO, TRIANGLE, VIEW_DIR};

/// The lab's methods that have one case each; the funnel and those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 13] = [
    Solver::of::<PointPlanes>(),
    Solver::of::<SphereCull>(),
    Solver::of::<BoxCull>(),
    Solver::of::<BackFace>(),
    Solver::of::<CohenSutherland3d>(),
    Solver::of::<LiangBarsky3d>(),
    Solver::of::<PlaneLine>(),
    Solver::of::<HomogeneousLine>(),
    Solver::of::<PlaneAtATime>(),
    Solver::of::<IntersectionPolygon>(),
    Solver::of::<HomogeneousTriangle<Option<[f64; 2]>>>(),
    Solver::of::<ViewingPipeline>(),
    Solver::of::<LineToPixels>(),
];

const DISTANCES: Field = Field::required("distances", &Shape::Numbers(&[Dim::ANY]));
const CLASS: Field = Field::required("class", &Shape::Word(&["inside", "outside", "straddles"]));

/// `planes`, or those of a `frustum` in view space.
fn planes(fields: &Fields<'_>) -> Result<Vec<Plane>, Refusal> {
    match fields.get(&PLANES)? {
        Some(planes) => Ok(planes),
        None => fields.need(&FRUSTUM).map(|volume| volume.planes().to_vec()),
    }
}

impl Solve for PointPlanes {
    const FIELDS: &'static [Field] = &[PLANES.choice(), FRUSTUM.choice(), POINT.required()];
    const OUTPUT: &'static [Field] = &[Field::required("inside", &Shape::Bool), DISTANCES];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (planes, point) = (planes(fields)?, fields.need(&POINT)?);
        Ok(PointPlanesInput { planes, point })
    }

    fn verdict(output: &PointPlanesOutput) -> Message {
        Message::new(if output.inside {
            "case-point-inside"
        } else {
            "case-point-outside"
        })
    }
}

impl Solve for SphereCull {
    const FIELDS: &'static [Field] = &[PLANES.choice(), FRUSTUM.choice(), SPHERE.required()];
    const OUTPUT: &'static [Field] = &[CLASS, DISTANCES];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (planes, sphere) = (planes(fields)?, fields.need(&SPHERE)?);
        Ok(SphereCullInput { planes, sphere })
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

impl Solve for BoxCull {
    const FIELDS: &'static [Field] = &[PLANES.choice(), FRUSTUM.choice(), BOX.required()];
    const OUTPUT: &'static [Field] = &[CLASS, Field::required("false_positive", &Shape::Bool)];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (planes, bounds) = (planes(fields)?, fields.need(&BOX)?);
        Ok(BoxCullInput { planes, bounds })
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

impl Solve for BackFace {
    const FIELDS: &'static [Field] = &[TRIANGLE.required(), EYE.choice(), VIEW_DIR.choice()];
    const OUTPUT: &'static [Field] = &[
        Field::required("front", &Shape::Bool),
        Field::required("dot", &Shape::Number),
        Field::required("det", &Shape::Number),
    ];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let triangle = fields.need(&TRIANGLE)?;
        let viewer = match fields.get(&EYE)? {
            Some(eye) => eye,
            None => fields.need(&VIEW_DIR)?,
        };
        Ok(BackFaceInput { triangle, viewer })
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

impl Solve for ViewingPipeline {
    const FIELDS: &'static [Field] = &[
        POINT.required(),
        MODEL.optional,
        CAMERA.required(),
        SIZE.required(),
    ];
    const OUTPUT: &'static [Field] = &[
        Field::required("world", &Shape::PLACE),
        Field::required("view", &Shape::PLACE),
        Field::required("clip", &Shape::Numbers(&[Dim::Exactly(4)])),
        Field::required("inside", &Shape::Bool),
        Field::optional("ndc", &Shape::PLACE),
        Field::optional("screen", &Shape::POINT),
    ];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let input = ViewingPipelineInput {
            point: fields.need(&POINT)?,
            world_from_model: fields.get(&MODEL)?.unwrap_or(Matrix::IDENTITY),
            camera: *fields.need(&CAMERA)?.camera(),
            viewport: fields.need(&SIZE)?,
        };
        Ok(input)
    }

    fn verdict(output: &ViewingPipelineOutput) -> Message {
        let key = match (output.inside, output.screen) {
            (_, None) => "case-pipeline-behind",
            (true, Some(_)) => "case-pipeline-inside",
            (false, Some(_)) => "case-pipeline-outside",
        };
        Message::new(key).with("screen", output.screen.unwrap_or_default())
    }
}

impl Solve for LineToPixels {
    const FIELDS: &'static [Field] = &[FROM.required(), TO.required()];
    const OUTPUT: &'static [Field] = &[Field::required(
        "pixels",
        &Shape::Wholes(&[Dim::ANY, Dim::Exactly(2)], i64::MIN, i64::MAX),
    )];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (from, to) = (fields.need(&FROM)?, fields.need(&TO)?);
        let ends = BresenhamInput::new(from, to).map_err(|error| {
            let problem = Message::new("case-too-many-pixels")
                .with("found", error.n_pixels.to_string())
                .with("max", BresenhamInput::MOST_PIXELS.to_string());
            fields.refuse(&TO, Fault::new(Code::TooLarge.id(), problem))
        })?;
        Ok(LineToPixelsInput::Pixels(ends))
    }

    fn verdict(output: &Vec<[i64; 2]>) -> Message {
        Message::new("case-pixels").with("count", output.len())
    }
}
