//! The polygons lab's cases: a polygon against a window or another polygon, or a polygon alone.

use crate::{
    algo::polygon::{
        ClipRegion, ClippedRing, EarClipping, Pipeline, RingOutcome, SutherlandHodgman,
        SutherlandHodgmanInput, Textured, TriangulateAndClip, TriangulateAndClipInput,
        Triangulation, Vertex,
        faulty::{CutsTwice, DropsOnBorder, EndFirst, Faulty, LeavesOpen, WalksClockwise},
        weiler_atherton::{
            Relation, WeilerAtherton, WeilerAthertonEvent, WeilerAthertonInput,
            WeilerAthertonOutput,
        },
    },
    geom::{Point, Polygon, Region, SimplePolygon},
    input::{CLIP, CONVEX_CLIP, HOLES, MOST_VERTICES, POLYGON, WINDOW, outline_told},
    labs::vertex_symbol,
};

use super::{
    Fields, Mistake, Solvable, Solve, Solver,
    prelude::*,
    solve::{Reading, Verdict},
    solver::read_problem,
};

/// The lab's methods, those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 5] = [
    Solver {
        read: read_sutherland_hodgman,
        ..Solver::of::<SutherlandHodgman>().knowing(&[
            Mistake::of::<SutherlandHodgman, Faulty<DropsOnBorder>>(),
            Mistake::of::<SutherlandHodgman, Faulty<LeavesOpen>>(),
            Mistake::of::<SutherlandHodgman, Faulty<WalksClockwise>>(),
            Mistake::of::<SutherlandHodgman, Faulty<CutsTwice>>(),
            Mistake::of::<SutherlandHodgman, Faulty<EndFirst>>(),
        ])
    },
    Solver::of::<Pipeline>(),
    Solver::of::<WeilerAtherton>(),
    Solver::of::<EarClipping>(),
    Solver::of::<TriangulateAndClip>(),
];

/// With texture coordinates at the vertices where they are given.
fn read_sutherland_hodgman(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    if fields.has(&UV) {
        read_problem::<SutherlandHodgman<Textured>>(fields)
    } else {
        read_problem::<SutherlandHodgman>(fields)
    }
}

/// A report is refused of two outlines whose numbers of edges multiply to more: each pair may become several events, of
/// which the JSON answer holds every one. 10,000 vertices against a window are less.
const MOST_PAIRS: usize = 1 << 16;

const UV: Part<Vec<[f64; 2]>> = Part::new(
    "uv",
    &Shape::Numbers(&[Dim::UpTo(MOST_VERTICES), Dim::Exactly(2)]),
    |got| Ok(got.rows().to_vec()),
)
.told(|got| {
    let values = got.rows().iter().map(|&uv: &[f64; 2]| uv.into());
    vec![Given::new("object-uv", values)]
});

const CLIPPED: [Field; 3] = [WINDOW.choice(), CONVEX_CLIP.choice(), POLYGON.required()];
const TEXTURED: [Field; 4] = [CLIPPED[0], CLIPPED[1], CLIPPED[2], UV.optional];
/// Named as the steps of Weiler–Atherton name them.
const WITH_HOLES: [Field; 4] = [
    CLIPPED[0],
    CLIP.choice()
        .told(|got| outline_told("object-clip-polygon", 'C', got)),
    CLIPPED[2].told(|got| outline_told("object-polygon", 'S', got)),
    HOLES,
];

const RINGS: Field = Field::required("polygons", &Shape::List(&Shape::POINTS));
const OUTCOME: Field = Field::required(
    "outcome",
    &Shape::Word(&["empty", "whole", "cut", "degenerate"]),
);
const RING: [Field; 2] = [RINGS, OUTCOME];
const TEXTURED_RING: [Field; 3] = [
    RINGS,
    OUTCOME,
    Field::optional("uv", &Shape::List(&Shape::POINTS)),
];
const RELATION: Field = Field::required(
    "relation",
    &Shape::Word(&[
        "disjoint",
        "touching",
        "subject-inside",
        "clip-inside",
        "equal",
        "crossing",
    ]),
);

/// `window`, or a convex `clip`.
fn convex_region(fields: &Fields<'_>) -> Result<ClipRegion, Refusal> {
    Ok(match fields.get(&WINDOW)? {
        Some(window) => window.into(),
        None => fields.need(&CONVEX_CLIP)?.into(),
    })
}

/// `window`, or `clip`, which must be simple; and how many edges are given.
fn simple_clip(fields: &Fields<'_>) -> Result<(SimplePolygon, usize), Refusal> {
    if let Some(window) = fields.get(&WINDOW)? {
        return Ok((window.into(), 4));
    }
    let clip = fields.need(&CLIP)?;
    let simple = SimplePolygon::try_from(&clip).map_err(|error| fields.refuse(&CLIP, error))?;
    Ok((simple, clip.vertices().len()))
}

/// `polygon`, of any shape, against a clip polygon of so many edges.
fn polygon(fields: &Fields<'_>, n_clip_edges: usize) -> Result<Polygon, Refusal> {
    let polygon = fields.need(&POLYGON)?;
    check_pairs(fields, polygon.vertices().len(), n_clip_edges)
        .map_err(|fault| fields.refuse(&POLYGON, fault))?;
    Ok(polygon)
}

/// `polygon`, which must be simple.
fn simple_polygon(fields: &Fields<'_>, n_clip_edges: usize) -> Result<SimplePolygon, Refusal> {
    let polygon = polygon(fields, n_clip_edges)?;
    SimplePolygon::try_from(&polygon).map_err(|error| fields.refuse(&POLYGON, error))
}

/// `polygon`, less `holes` where there are any.
fn region(fields: &Fields<'_>, n_clip_edges: usize) -> Result<Region, Refusal> {
    let outer = simple_polygon(fields, n_clip_edges)?;
    let Some(outlines) = fields.each(HOLES.name, &POLYGON)? else {
        return Ok(outer.into());
    };
    let place = Path::Field(HOLES.name);
    let n_edges: usize = outlines.iter().map(|hole| hole.vertices().len()).sum();
    check_pairs(fields, outer.vertices().len() + n_edges, n_clip_edges)
        .map_err(|fault| Refusal::of(&place, fault))?;
    let simple = |(i, hole): (usize, &Polygon)| {
        let hole = SimplePolygon::try_from(hole);
        hole.map_err(|error| Refusal::of(&Path::Index(&place, i), error.into()))
    };
    let holes = outlines.iter().enumerate().map(simple);
    let holes = holes.collect::<Result<Vec<_>, _>>()?;
    Region::new(outer, holes).map_err(|error| Refusal::of(&place, error.into()))
}

fn check_pairs(fields: &Fields<'_>, n_edges: usize, n_clip_edges: usize) -> Result<(), Fault> {
    let found = n_edges.saturating_mul(n_clip_edges);
    if found <= fields.detail().limit(MOST_PAIRS) {
        return Ok(());
    }
    let problem = Message::new("case-too-many-pairs")
        .with("found", found)
        .with("max", MOST_PAIRS);
    Err(Fault::new(Code::TooLarge.id(), problem))
}

fn to_clip(fields: &Fields<'_>) -> Result<SutherlandHodgmanInput, Refusal> {
    let region = convex_region(fields)?;
    let polygon = polygon(fields, region.n_edges())?;
    Ok(SutherlandHodgmanInput::new(region, &polygon))
}

impl Solve for SutherlandHodgman {
    const FIELDS: &'static [Field] = &TEXTURED;
    const OUTPUT: &'static [Field] = &TEXTURED_RING;
    const BUDGET: u64 = 300_000_000;
    const READ: Reading<Self> = to_clip;
    const VERDICT: Verdict<Self> = ring;
}

impl Solve for SutherlandHodgman<Textured> {
    const FIELDS: &'static [Field] = &TEXTURED;
    const OUTPUT: &'static [Field] = &TEXTURED_RING;
    const BUDGET: u64 = 300_000_000;
    const READ: Reading<Self> = |fields| {
        let plain = to_clip(fields)?;
        let (uvs, n_vertices) = (fields.need(&UV)?, plain.vertices.len());
        if uvs.len() != n_vertices {
            let problem = Message::new("case-uv-length")
                .with("expected", n_vertices)
                .with("found", uvs.len());
            return Err(fields.refuse(&UV, Fault::new(Code::WrongLength.id(), problem)));
        }
        let vertices = plain.vertices.into_iter().zip(uvs);
        Ok(SutherlandHodgmanInput {
            region: plain.region,
            vertices: vertices.map(|(at, uv)| Textured { at, uv }).collect(),
        })
    };
    const VERDICT: Verdict<Self> = ring;
}

impl Solve for Pipeline {
    const FIELDS: &'static [Field] = &CLIPPED;
    const OUTPUT: &'static [Field] = &RING;
    const READ: Reading<Self> = to_clip;
    const VERDICT: Verdict<Self> = ring;
}

impl Solve for WeilerAtherton {
    const FIELDS: &'static [Field] = &WITH_HOLES;
    const OUTPUT: &'static [Field] = &[RINGS, RELATION];
    const SYMBOLS_KEY: Option<&'static str> = Some("case-symbols-weiler-atherton");
    /// A crossing takes 170 bytes.
    const BUDGET: u64 = 45_000_000;
    const READ: Reading<Self> = |fields| {
        let (clip, n_clip_edges) = simple_clip(fields)?;
        let subject = region(fields, n_clip_edges)?;
        Ok(WeilerAthertonInput { subject, clip })
    };
    const VERDICT: Verdict<Self> = pieces;

    /// All crossings are found before the first is inserted, labelled and walked past: what comes is counted with what is found.
    fn cost(_: &Self::Input, _: &Self::Held, event: &Self::Event) -> u64 {
        match event {
            WeilerAthertonEvent::Found { .. } => 5,
            _ => 1,
        }
    }
}

impl Solve for EarClipping {
    const FIELDS: &'static [Field] = &[POLYGON.required()];
    const OUTPUT: &'static [Field] = &[
        Field::required(
            "triangles",
            &Shape::Numbers(&[Dim::ANY, Dim::Exactly(3), Dim::Exactly(2)]),
        ),
        Field::required(
            "vertices",
            &Shape::Wholes(&[Dim::ANY, Dim::Exactly(3)], 0, i64::MAX),
        ),
    ];
    const READ: Reading<Self> = |fields| simple_polygon(fields, 1);
    const VERDICT: Verdict<Self> = triangles;
}

impl Solve for TriangulateAndClip {
    const FIELDS: &'static [Field] = &CLIPPED;
    const OUTPUT: &'static [Field] = &[RINGS];
    const BUDGET: u64 = 250_000_000;
    const READ: Reading<Self> = |fields| {
        let region = convex_region(fields)?;
        let polygon = simple_polygon(fields, region.n_edges())?;
        Ok(TriangulateAndClipInput { region, polygon })
    };
    const VERDICT: Verdict<Self> =
        |output| polygons(output.len(), output.rings().map(|ring| (ring, false)));
}

/// Points, or triangles, beyond these are left out.
const MAX_SHOWN: usize = 16;

/// How many there are, and of each ring its vertices; a minus sign stands before a hole.
fn polygons<'a>(n: usize, rings: impl Iterator<Item = (&'a [Point], bool)>) -> Message {
    if n == 0 {
        return Message::new("case-nothing-left");
    }
    let mut shown = Formula::default();
    let mut n_points = 0;
    for (i, (ring, is_hole)) in rings.enumerate() {
        if i > 0 {
            shown = shown.sym(if is_hole { " − " } else { "; " });
        }
        for (k, p) in ring.iter().take(MAX_SHOWN - n_points).enumerate() {
            let gap = if k > 0 { " " } else { "" };
            shown = shown.sym(gap).point(p.to_array());
        }
        n_points += ring.len();
        if n_points > MAX_SHOWN {
            shown = shown.sym(" …");
            break;
        }
    }
    Message::new("case-polygons")
        .with("n", n)
        .with("rings", shown)
}

fn pieces(clipped: &WeilerAthertonOutput) -> Message {
    if clipped.relation == Relation::Touching {
        return Message::new("case-no-area");
    }
    let rings = clipped.pieces.iter().flat_map(|piece| {
        let holes = piece.holes.iter().map(|hole| (&hole[..], true));
        std::iter::once((&piece.outer[..], false)).chain(holes)
    });
    polygons(clipped.pieces.len(), rings)
}

/// The one ring of Sutherland–Hodgman, where there is something to fill.
fn ring<V: Vertex>(ring: &ClippedRing<V>) -> Message {
    if ring.outcome == RingOutcome::Degenerate {
        return Message::new("case-no-area");
    }
    let polygon = ring.polygon();
    let rings = polygon.iter().map(|polygon| (polygon.vertices(), false));
    polygons(rings.len(), rings)
}

/// `V₁V₂V₃, V₁V₃V₄`.
fn triangles(whole: &Triangulation) -> Message {
    let triangles = whole.triangles();
    let shown = triangles.iter().take(MAX_SHOWN);
    let mut names: Vec<String> = shown.map(|it| it.map(vertex_symbol).concat()).collect();
    if triangles.len() > MAX_SHOWN {
        names.push("…".to_owned());
    }
    Message::new("case-triangles")
        .with("n", triangles.len())
        .with("triangles", names.join(", "))
}
