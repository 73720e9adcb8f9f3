//! The frustum lab's cases: a point, a sphere or a box against planes, a triangle against whoever looks at it, a segment
//! in a box, against planes or in clip space, a triangle cut by planes, and the way to the screen.

mod parts;

use crate::{
    algo::{
        cull::{
            BackFace, BackFaceInput, BoxCull, BoxCullEvent, BoxCullInput, Containment, PointPlanes,
            PointPlanesInput, SphereCull, SphereCullInput,
        },
        pipeline::{
            BresenhamInput, LineToPixels, LineToPixelsInput, PipelineSpace, ViewingPipeline,
            ViewingPipelineInput,
        },
        ring::Right,
        volume::{
            ClipSpace, ClipVertex, CohenSutherland3d, HomogeneousLine, HomogeneousTriangle,
            IntersectionPolygon, LiangBarsky3d, LineInput, PlaneAtATime, PlaneLine, SpaceVertex,
            TrianglePlanes, VisibleLine,
            faulty::{
                AllSides, DividedLine, DividesFirst, DropsOnPlane, EdgeByEdge, KeepsPlaceInTexture,
                MissesEdge,
            },
        },
    },
    geom::{AlignedBox, Matrix, Plane},
    input::{CAMERA, Dim, FRUSTUM, Fault, Field, SIZE, Shape},
    labs::plane_symbol,
    text::{Formula, Message, Value},
};

use super::{
    Code, Fields, Mistake, Refusal, Solve, Solver,
    solve::{Reading, Verdict},
};

use parts::{
    BOX, CLIP_SEGMENT, CLIP_TRIANGLE, EYE, FROM, MODEL, PLANES, POINT, SEGMENT, SOLID_BOX, SPHERE,
    TO, TRIANGLE, UV, VIEW_DIR,
};

/// With texture coordinates, where they are given.
type Triangle<L = Right> = HomogeneousTriangle<Option<[f64; 2]>, L>;

/// The lab's methods that have one case each; the funnel and those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 13] = [
    Solver::of::<PointPlanes>(),
    Solver::of::<SphereCull>(),
    Solver::of::<BoxCull>(),
    Solver::of::<BackFace>(),
    Solver::of::<CohenSutherland3d>(),
    Solver::of::<LiangBarsky3d>(),
    Solver::of::<PlaneLine>(),
    Solver::of::<HomogeneousLine>().knowing(&[Mistake::of::<HomogeneousLine, DividedLine>()]),
    Solver::of::<PlaneAtATime>()
        .knowing(&[Mistake::of::<PlaneAtATime, PlaneAtATime<MissesEdge>>()]),
    Solver::of::<IntersectionPolygon>().knowing(&[
        Mistake::of::<IntersectionPolygon, IntersectionPolygon<DropsOnPlane>>(),
        Mistake::of::<IntersectionPolygon, IntersectionPolygon<KeepsPlaceInTexture>>(),
        Mistake::of::<IntersectionPolygon, IntersectionPolygon<EdgeByEdge>>(),
    ]),
    Solver::of::<Triangle>().knowing(&[
        Mistake::of::<Triangle, Triangle<AllSides>>(),
        Mistake::of::<Triangle, Triangle<DividesFirst>>(),
    ]),
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
    const READ: Reading<Self> = |fields| {
        let (planes, point) = (planes(fields)?, fields.need(&POINT)?);
        Ok(PointPlanesInput { planes, point })
    };
    const VERDICT: Verdict<Self> = |output| {
        Message::new(if output.inside {
            "point-answer-inside"
        } else {
            "point-answer-outside"
        })
    };
}

impl Solve for SphereCull {
    const FIELDS: &'static [Field] = &[PLANES.choice(), FRUSTUM.choice(), SPHERE.required()];
    const OUTPUT: &'static [Field] = &[CLASS, DISTANCES];
    const READ: Reading<Self> = |fields| {
        let (planes, sphere) = (planes(fields)?, fields.need(&SPHERE)?);
        Ok(SphereCullInput { planes, sphere })
    };
    const VERDICT: Verdict<Self> = |output| match (output.class, output.distances.last()) {
        (Containment::Outside, Some(&distance)) => Message::new("case-cull-outside")
            .with("plane", plane_symbol(output.distances.len() - 1))
            .with("distance", distance),
        (Containment::Inside | Containment::Outside, _) => Message::new("case-cull-inside"),
        (Containment::Straddles, _) => Message::new("case-cull-straddles"),
    };
}

impl Solve for BoxCull {
    const FIELDS: &'static [Field] = &[PLANES.choice(), FRUSTUM.choice(), BOX.required()];
    const OUTPUT: &'static [Field] = &[CLASS, Field::required("false_positive", &Shape::Bool)];
    const READ: Reading<Self> = |fields| {
        let (planes, bounds) = (planes(fields)?, fields.need(&BOX)?);
        Ok(BoxCullInput { planes, bounds })
    };
    const VERDICT: Verdict<Self> = |output| {
        Message::new(match output.class {
            Containment::Inside => "case-cull-inside",
            Containment::Outside => "case-box-outside",
            Containment::Straddles if output.false_positive => "case-cull-in-vain",
            Containment::Straddles => "case-cull-straddles",
        })
    };

    /// After the last plane that does not reject the box come the signs by which is found whether anything of it is inside.
    fn cost(input: &Self::Input, held: &Self::Held, event: &Self::Event) -> u64 {
        let n = input.planes.len() as u64 + 6;
        match *event {
            BoxCullEvent::Plane { plane_idx, .. }
                if plane_idx + 1 == input.planes.len() && held.class == Containment::Straddles =>
            {
                1 + 2 * n * n * n
            }
            _ => 1,
        }
    }
}

impl Solve for BackFace {
    const FIELDS: &'static [Field] = &[TRIANGLE.required(), EYE.choice(), VIEW_DIR.choice()];
    const OUTPUT: &'static [Field] = &[
        Field::required("front", &Shape::Bool),
        Field::required("dot", &Shape::Number),
        Field::required("det", &Shape::Number),
    ];
    const READ: Reading<Self> = |fields| {
        let triangle = fields.need(&TRIANGLE)?;
        let viewer = match fields.get(&EYE)? {
            Some(eye) => eye,
            None => fields.need(&VIEW_DIR)?,
        };
        Ok(BackFaceInput { triangle, viewer })
    };
    const VERDICT: Verdict<Self> = |output| {
        let key = if output.front {
            "case-front"
        } else {
            "case-back"
        };
        Message::new(key).with("dot", output.dot)
    };
}

const IN_BOX: [Field; 2] = [SOLID_BOX.required(), SEGMENT.required()];

fn read_in_box(fields: &Fields<'_>) -> Result<LineInput<3, AlignedBox>, Refusal> {
    let (bounds, ends) = (fields.need(&SOLID_BOX)?, fields.need(&SEGMENT)?);
    Ok(LineInput { bounds, ends })
}

const IS_VISIBLE: Field = Field::required("visible", &Shape::Bool);
const VISIBLE: [Field; 2] = [
    IS_VISIBLE,
    Field::required("segment", &Shape::OrNull(SEGMENT.optional.shape)),
];

fn visible<const N: usize>(output: &VisibleLine<N>) -> Message {
    let place = |at: &[f64; N]| {
        let formula = Formula::default().sym("(").list(at).sym(")");
        Value::Formula(formula)
    };
    match output {
        None => Message::new("case-invisible"),
        Some([p1, p2]) if p1 == p2 => Message::new("case-touch").with("at", place(p1)),
        Some([p1, p2]) => Message::new("case-visible")
            .with("p1", place(p1))
            .with("p2", place(p2)),
    }
}

impl Solve for CohenSutherland3d {
    const FIELDS: &'static [Field] = &IN_BOX;
    const OUTPUT: &'static [Field] = &VISIBLE;
    const READ: Reading<Self> = read_in_box;
    const VERDICT: Verdict<Self> = visible;
}

impl Solve for LiangBarsky3d {
    const FIELDS: &'static [Field] = &IN_BOX;
    const OUTPUT: &'static [Field] = &VISIBLE;
    const READ: Reading<Self> = read_in_box;
    const VERDICT: Verdict<Self> = visible;
}

impl Solve for PlaneLine {
    const FIELDS: &'static [Field] = &[PLANES.required(), SEGMENT.required()];
    const OUTPUT: &'static [Field] = &VISIBLE;
    const READ: Reading<Self> = |fields| {
        let (bounds, ends) = (fields.need(&PLANES)?, fields.need(&SEGMENT)?);
        Ok(LineInput { bounds, ends })
    };
    const VERDICT: Verdict<Self> = visible;
}

impl Solve for HomogeneousLine {
    const FIELDS: &'static [Field] = &[CLIP_SEGMENT.required()];
    const OUTPUT: &'static [Field] = &[
        IS_VISIBLE,
        Field::required("segment", &Shape::OrNull(CLIP_SEGMENT.optional.shape)),
    ];
    const READ: Reading<Self> = |fields| {
        let (bounds, ends) = (ClipSpace, fields.need(&CLIP_SEGMENT)?);
        Ok(LineInput { bounds, ends })
    };
    const VERDICT: Verdict<Self> = visible;
}

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
    const BUDGET: u64 = 100_000_000;
    const READ: Reading<Self> = read_planes;
    const VERDICT: Verdict<Self> = |output| left(output.triangles.len());
}

impl Solve for IntersectionPolygon {
    const FIELDS: &'static [Field] = &CUT;
    const OUTPUT: &'static [Field] = &LEFT;
    const READ: Reading<Self> = read_planes;
    const VERDICT: Verdict<Self> = |output| left(output.triangles.len());
}

impl Solve for Triangle {
    const FIELDS: &'static [Field] = &[CLIP_TRIANGLE.required(), UV.optional];
    const OUTPUT: &'static [Field] = &[
        Field::required("triangles", &Shape::List(CLIP_TRIANGLE.optional.shape)),
        UVS,
    ];
    const READ: Reading<Self> = |fields| {
        let (corners, uv) = (fields.need(&CLIP_TRIANGLE)?, fields.get(&UV)?);
        let own: [_; 3] = std::array::from_fn(|i| ClipVertex {
            at: corners[i],
            attributes: uv.map(|uv| uv[i]),
        });
        Ok(own)
    };
    const VERDICT: Verdict<Self> = |output| left(output.triangles().count());
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
    const READ: Reading<Self> = |fields| {
        let input = ViewingPipelineInput {
            point: fields.need(&POINT)?,
            world_from_model: fields.get(&MODEL)?.unwrap_or(Matrix::IDENTITY),
            camera: *fields.need(&CAMERA)?.camera(),
            viewport: fields.need(&SIZE)?,
        };
        let matrices = PipelineSpace::ALL.map(|into| input.matrix(into).rows());
        let numbers = matrices.as_flattened().as_flattened();
        if numbers.iter().all(|x| x.is_finite()) {
            Ok(input)
        } else {
            Err(fields.beyond_range("case-beyond-range"))
        }
    };
    const VERDICT: Verdict<Self> = |output| {
        let key = match (output.inside, output.screen) {
            (_, None) => "case-pipeline-behind",
            (true, Some(_)) => "case-pipeline-inside",
            (false, Some(_)) => "case-pipeline-outside",
        };
        Message::new(key).with("screen", output.screen.unwrap_or_default())
    };
}

impl Solve for LineToPixels {
    const FIELDS: &'static [Field] = &[FROM.required(), TO.required()];
    const OUTPUT: &'static [Field] = &[Field::required(
        "pixels",
        &Shape::Wholes(&[Dim::ANY, Dim::Exactly(2)], i64::MIN, i64::MAX),
    )];
    const READ: Reading<Self> = |fields| {
        let (from, to) = (fields.need(&FROM)?, fields.need(&TO)?);
        let ends = BresenhamInput::new(from, to).map_err(|error| {
            let problem = Message::new("case-too-many-pixels")
                .with("found", error.n_pixels.to_string())
                .with("max", BresenhamInput::MOST_PIXELS.to_string());
            fields.refuse(&TO, Fault::new(Code::TooLarge.id(), problem))
        })?;
        Ok(LineToPixelsInput::Pixels(ends))
    };
    const VERDICT: Verdict<Self> = |output| Message::new("case-pixels").with("count", output.len());
}
