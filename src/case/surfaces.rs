//! The surfaces lab's cases: triangles in view space on a raster.

use serde::Serialize;

use crate::{
    algo::surface::{
        Bsp, BspChoice, BspEvent, BspInput, BspTooLarge, DepthBuffer, DepthBufferInput, Hierarchy,
        Occlusion, OcclusionEvent, OcclusionInput, Painter, PainterAnswer, PainterEvent,
        PainterOutput, Picture, RayCasting, RayCastingInput, Surfaces, Tint, Viewport,
        faulty::{
            ClearsToNear, KeysOnly, NearestKeys, StraightDistance, TurnsComparison, WritesAlways,
        },
        is_order,
    },
    geom::{ViewVolume, is_part},
    input::{At, CULL, FRUSTUM, SIZE},
    labs::{surfaces::with_occluders, telling::Each},
    trace::{Real, Told},
};

use super::{
    Fields, Meter, Mistake, Numbers, OverBudget, Solve, Solver,
    prelude::*,
    solve::{Reading, Verdict},
};

/// The lab's methods, those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 5] = [
    Solver::of::<DepthBuffer>().knowing(&[
        Mistake::of::<DepthBuffer, DepthBuffer<ClearsToNear>>(),
        Mistake::of::<DepthBuffer, DepthBuffer<TurnsComparison>>(),
        Mistake::of::<DepthBuffer, DepthBuffer<WritesAlways>>(),
        Mistake::of::<DepthBuffer, DepthBuffer<StraightDistance>>(),
    ]),
    Solver::of::<RayCasting>(),
    Solver::of::<Painter>().knowing(&[
        Mistake::of::<Painter, Painter<NearestKeys>>(),
        Mistake::of::<Painter, Painter<KeysOnly>>(),
    ]),
    Solver::of::<Bsp>(),
    Solver::of::<Occlusion>(),
];

/// Of a longer order only the taught one is taken: each pair of it would be asked about.
const MOST_ORDERED: usize = 2_000;

type Triangle = [[f64; 3]; 3];

const TRIANGLES_SHAPE: Shape = Shape::Numbers(&[Dim::ANY, Dim::Exactly(3), Dim::Exactly(3)]);

/// In view space.
const TRIANGLES: Part<Vec<Triangle>> = Part::new("triangles", &TRIANGLES_SHAPE, |got| {
    Ok(got.rows().as_chunks().0.to_vec())
})
.told(|got| vec![triangles_told("object-triangles", got.rows().as_chunks().0)]);

const OBJECTS: Part<Vec<Vec<Triangle>>> =
    Part::new("objects", &Shape::List(&TRIANGLES_SHAPE), |got| {
        let object = |got: &Got| got.rows().as_chunks().0.to_vec();
        Ok(got.list().iter().map(object).collect())
    })
    .told(|got| {
        let object = |got: &Got| triangles_told("object-object", got.rows().as_chunks().0);
        got.list().iter().map(object).collect()
    });

fn triangles_told(name_key: &'static str, triangles: &[Triangle]) -> Given {
    let triangle = |(id, &[a, b, c]): (usize, &Triangle)| {
        let formula = Formula::default().sym(format!("{id}: "));
        let formula = formula.place(a).sym(" ").place(b).sym(" ").place(c);
        Value::Formula(formula)
    };
    Given::new(name_key, triangles.iter().enumerate().map(triangle))
}

/// How each triangle looks, its opacity and its brightness: then the picture is also told in brightness.
const TINTS: Part<Vec<Tint>> = Part::new("tints", &Shape::POINTS, |got| {
    let tint = |(i, &[opacity, brightness]): (usize, &[f64; 2])| {
        let value = [opacity, brightness].into_iter().find(|&x| !is_part(x));
        let problem = Message::new("problem-out-of-range");
        let problem = problem.with("value", Formula::decimals().num(value.unwrap_or_default()));
        let fault = Fault::new("degenerate", problem).at(At::Entry(i));
        Tint::new(opacity, brightness).ok_or(fault)
    };
    got.rows().iter().enumerate().map(tint).collect()
})
.told(|got| {
    let tint = |(id, &[opacity, brightness]): (usize, &[f64; 2])| {
        let formula = Formula::decimals().sym(format!("{id}: α = ")).num(opacity);
        Value::Formula(formula.sym(", C_s = ").num(brightness))
    };
    let tints = got.rows().iter().enumerate().map(tint);
    vec![Given::new("object-tints", tints)]
});

const ON_RASTER: [Field; 4] = [
    SIZE.required(),
    FRUSTUM.required(),
    TRIANGLES.required(),
    CULL.optional,
];

const TINTED: [Field; 5] = {
    let [size, frustum, triangles, cull] = ON_RASTER;
    [size, frustum, triangles, cull, TINTS.optional]
};

const BRIGHTNESS: Field = Field::optional("brightness", &Shape::List(&Shape::Number));

const IDS: Field = Field::required("ids", &Shape::Wholes(&[Dim::ANY], -1, i64::MAX));
const SEEN: [Field; 2] = [
    IDS,
    Field::required("depth", &Shape::List(&Shape::OrNull(&Shape::Number))),
];

fn surfaces(fields: &Fields<'_>) -> Result<Surfaces, Refusal> {
    let raster = raster(fields)?;
    let triangles = fields.need(&TRIANGLES)?;
    let culls_backs = fields.get(&CULL)?.unwrap_or(false);
    on_raster(fields, raster, &TRIANGLES, (triangles, culls_backs))
}

fn tinted(fields: &Fields<'_>) -> Result<Surfaces, Refusal> {
    let surfaces = surfaces(fields)?;
    let Some(tints) = fields.get(&TINTS)? else {
        return Ok(surfaces);
    };
    let problem = Message::new("case-tints-length")
        .with("expected", surfaces.triangles().len())
        .with("found", tints.len());
    let tinted = surfaces.with_tints(tints);
    tinted.ok_or_else(|| fields.refuse(&TINTS, Fault::new(Code::WrongLength.id(), problem)))
}

fn too_large<T>(fields: &Fields<'_>, part: &Part<T>, problem: Message) -> Refusal {
    fields.refuse(part, Fault::new(Code::TooLarge.id(), problem))
}

/// The raster and the volume that triangles are put on.
fn raster(fields: &Fields<'_>) -> Result<(Viewport, ViewVolume), Refusal> {
    let viewport = fields.need(&SIZE)?;
    let n_pixels: usize = viewport.size().map(|side| side as usize).iter().product();
    if n_pixels > fields.detail().limit(Detail::MOST_STEPS) {
        let problem = Message::new("case-too-many-raster-pixels")
            .with("found", n_pixels)
            .with("max", Detail::MOST_STEPS);
        return Err(too_large(fields, &SIZE, problem));
    }
    Ok((viewport, fields.need(&FRUSTUM)?))
}

/// Sides and numbers have been looked at: what makes no surfaces can only be too many triangles, more than a line holds.
fn on_raster<T>(
    fields: &Fields<'_>,
    (viewport, volume): (Viewport, ViewVolume),
    part: &Part<T>,
    (triangles, culls_backs): (Vec<Triangle>, bool),
) -> Result<Surfaces, Refusal> {
    let surfaces = Surfaces::new(viewport.size(), volume, triangles, culls_backs);
    surfaces.ok_or_else(|| {
        let problem = Message::new("case-too-many-steps")
            .with("found", Surfaces::MOST_TRIANGLES)
            .with("max", Detail::MOST_STEPS);
        too_large(fields, part, problem)
    })
}

impl Solve for DepthBuffer {
    const FIELDS: &'static [Field] = &TINTED;
    const OUTPUT: &'static [Field] = &[SEEN[0], SEEN[1], BRIGHTNESS];
    const LONG_BY: Option<&'static str> = Some(TRIANGLES.name());
    const NUMBERS: Numbers = Numbers::OrInfinite;
    const BUDGET: u64 = 2_000_000_000;
    const READ: Reading<Self> = |fields| Ok(DepthBufferInput::new(tinted(fields)?));
    const VERDICT: Verdict<Self> = |output| seen(&output.picture);
}

impl Solve for RayCasting {
    const FIELDS: &'static [Field] = &ON_RASTER;
    const OUTPUT: &'static [Field] = &SEEN;
    const LONG_BY: Option<&'static str> = Some(TRIANGLES.name());
    const NUMBERS: Numbers = Numbers::OrInfinite;
    const READ: Reading<Self> = |fields| {
        let (surfaces, pixel) = (surfaces(fields)?, None);
        Ok(RayCastingInput { surfaces, pixel })
    };
    const VERDICT: Verdict<Self> = |output| seen(&output.picture);

    fn answer_alone<R: Real>(
        input: &Self::Input,
        meter: &mut Meter,
    ) -> Told<OverBudget, Self::Output> {
        let surfaces = &input.surfaces;
        Hierarchy::new(surfaces).picture_while::<R, _>(surfaces, |n_asked| meter.add(1 + n_asked))
    }
}

impl Solve for Painter {
    const FIELDS: &'static [Field] = &TINTED;
    const OUTPUT: &'static [Field] = &[
        Field::optional("ids", IDS.shape),
        Field::choice("order", &Shape::COUNTS),
        Field::choice("cycle", &Shape::COUNTS),
        BRIGHTNESS,
    ];
    const LONG_BY: Option<&'static str> = Some(TRIANGLES.name());
    const BUDGET: u64 = 8_000_000_000;
    const READ: Reading<Self> = tinted;
    const VERDICT: Verdict<Self> = |output| match &output.answer {
        PainterAnswer::Order { order, .. } => {
            Message::new("case-painted").with("ids", listed(order))
        }
        PainterAnswer::Cycle { cycle } => {
            Message::new("case-painter-cycle").with("ids", listed(cycle))
        }
    };

    /// Any order in which nothing is painted before what it hides.
    fn admits(surfaces: &Surfaces, output: &PainterOutput, field: &str, said: &Json) -> bool {
        let PainterAnswer::Order { order, .. } = &output.answer else {
            return false;
        };
        let said = serde_json::from_value::<Vec<u32>>(said.clone());
        let Some(said) = said.ok().filter(|_| field == "order") else {
            return false;
        };
        let sorted = |ids: &[u32]| {
            let mut ids = ids.to_vec();
            ids.sort_unstable();
            ids
        };
        said.len() <= MOST_ORDERED && sorted(&said) == sorted(order) && is_order(surfaces, &said)
    }

    fn cost(surfaces: &Self::Input, _: &Self::Held, event: &Self::Event) -> u64 {
        match *event {
            PainterEvent::Paint { id } => 1 + surfaces.n_covered(id),
            _ => 1,
        }
    }
}

impl Solve for Bsp {
    const FIELDS: &'static [Field] = &ON_RASTER;
    const OUTPUT: &'static [Field] = &[IDS, Field::required("n_pieces", &Shape::COUNT)];
    const LONG_BY: Option<&'static str> = Some(TRIANGLES.name());
    const BUDGET: u64 = 8_000_000_000;
    const READ: Reading<Self> = |fields| {
        let input = BspInput::new(surfaces(fields)?, BspChoice::First);
        input.map_err(|BspTooLarge| {
            let problem = Message::new("case-bsp-too-large")
                .with("pieces", BspTooLarge::MOST_PIECES)
                .with("questions", BspTooLarge::MOST_QUESTIONS);
            too_large(fields, &TRIANGLES, problem)
        })
    };
    const VERDICT: Verdict<Self> = |output| {
        with_seen(Message::new("case-bsp-pieces"), &output.picture).with("pieces", output.n_pieces)
    };

    /// Each pixel of a piece's triangle is asked for its side of every plane that cut it.
    fn cost(input: &Self::Input, held: &Self::Held, event: &Self::Event) -> u64 {
        match *event {
            BspEvent::Paint { piece, id, .. } => {
                let n_cuts = held.pieces[piece as usize].cuts.len() as u64;
                1 + (1 + n_cuts) * input.surfaces().n_covered(id)
            }
            _ => 1,
        }
    }
}

impl Solve for Occlusion {
    const FIELDS: &'static [Field] = &[SIZE.required(), FRUSTUM.required(), OBJECTS.required()];
    const OUTPUT: &'static [Field] = &[IDS, Field::required("skipped", &Shape::COUNTS)];
    const LONG_BY: Option<&'static str> = Some(OBJECTS.name());
    const READ: Reading<Self> = |fields| {
        let raster = raster(fields)?;
        let objects = fields.need(&OBJECTS)?;
        let counts: Vec<usize> = objects.iter().map(Vec::len).collect();
        let surfaces = on_raster(fields, raster, &OBJECTS, (objects.concat(), false))?;
        let n_covered: u64 = surfaces.ids().map(|id| surfaces.n_covered(id)).sum();
        if n_covered > Self::BUDGET {
            let problem = Message::new("case-too-many-fragments")
                .with("found", n_covered as usize)
                .with("max", Self::BUDGET as usize);
            return Err(too_large(fields, &OBJECTS, problem));
        }
        let objects = with_occluders(&surfaces, counts.into_iter());
        Ok(OcclusionInput { surfaces, objects })
    };
    const VERDICT: Verdict<Self> = |output| {
        with_seen(Message::new("case-occlusion"), &output.picture)
            .with("skipped", output.skipped.len())
            .with("objects", output.drawn.len() + output.skipped.len())
    };

    /// What is asked is counted here, what is drawn before the run.
    fn cost(_: &Self::Input, _: &Self::Held, event: &Self::Event) -> u64 {
        match event {
            OcclusionEvent::Query { result, .. } => 1 + result.asked,
            _ => 1,
        }
    }

    /// The objects seen instead of their triangles, and those that were skipped.
    fn told(input: &Self::Input, output: &Self::Output) -> impl Serialize {
        #[derive(Serialize)]
        struct Told<'a, I> {
            ids: I,
            skipped: &'a [usize],
        }
        let object_of = |id: &i32| {
            let id = u32::try_from(*id).ok()?;
            let n_begun = input.objects.partition_point(|object| object.first <= id);
            Some(n_begun as i64 - 1)
        };
        let ids = move || {
            output
                .picture
                .ids()
                .iter()
                .map(move |id| object_of(id).unwrap_or(-1))
        };
        Told {
            ids: Each(ids),
            skipped: &output.skipped,
        }
    }
}

fn seen(picture: &Picture) -> Message {
    with_seen(Message::new("case-surfaces-seen"), picture)
}

fn with_seen(message: Message, picture: &Picture) -> Message {
    let ids = picture.ids();
    let n_seen = ids.iter().filter(|id| **id != Picture::BACKGROUND);
    message
        .with("seen", n_seen.count())
        .with("pixels", ids.len())
}

fn listed(ids: &[u32]) -> String {
    let ids: Vec<String> = ids.iter().map(u32::to_string).collect();
    ids.join(", ")
}
