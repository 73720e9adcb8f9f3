//! The lines lab's cases: a segment against a window, or against a convex polygon.

use crate::{
    algo::line::{
        BruteForce, CohenSutherland, CyrusBeck, LiangBarsky, NichollLeeNicholl,
        faulty::{
            FaultyCohenSutherland, FaultyLiangBarsky, LooksOnce, OutwardCyrusBeck,
            RejectsTwoOutside, TurnsSlope,
        },
    },
    geom::{ConvexPolygon, GeomError, Segment, Window},
    input::{BIT_ORDER, CONVEX_CLIP, WINDOW},
    labs::lines::{LineTelling, Method, Scene},
};

use super::{
    Mistake, Solve, Solver,
    prelude::*,
    solve::{Reading, Verdict},
};

pub(super) static SOLVERS: [Solver; 5] = [
    Solver::of::<BruteForce>(),
    Solver::of::<CohenSutherland>().knowing(&[
        Mistake::called::<CohenSutherland, FaultyCohenSutherland<TurnsSlope>>(
            "slope-turned-over",
            "mistake-slope-turned-over",
        ),
        Mistake::called::<CohenSutherland, FaultyCohenSutherland<LooksOnce>>(
            "looks-once",
            "alg-faulty-looks-once",
        ),
        Mistake::called::<CohenSutherland, FaultyCohenSutherland<RejectsTwoOutside>>(
            "rejects-two-outside",
            "alg-faulty-two-outside",
        ),
    ]),
    Solver::of::<LiangBarsky>().knowing(&[Mistake::of::<LiangBarsky, FaultyLiangBarsky>()]),
    Solver::of::<CyrusBeck>().knowing(&[Mistake::of::<CyrusBeck, OutwardCyrusBeck>()]),
    Solver::of::<NichollLeeNicholl>(),
];

const SEGMENT: Part<Segment> = Part::new("segment", &Shape::Numbers(&[Dim::Exactly(4)]), |got| {
    let [x1, y1, x2, y2] = got.array();
    Ok(Segment::new(x1, y1, x2, y2)?)
})
.told(|got| {
    let [x1, y1, x2, y2] = got.array();
    let ends = [("P₁ = ", [x1, y1]), ("P₂ = ", [x2, y2])];
    let end = |(symbol, at)| Value::Formula(Formula::default().sym(symbol).point(at));
    Given::only("object-segment", ends.map(end))
});

const VISIBLE: [Field; 2] = [
    Field::required("visible", &Shape::Bool),
    Field::required("segment", &Shape::OrNull(SEGMENT.optional.shape)),
];

const IN_WINDOW: [Field; 2] = [WINDOW.required(), SEGMENT.required()];
const CODED: [Field; 3] = [IN_WINDOW[0], IN_WINDOW[1], BIT_ORDER.optional];
const CONVEX: [Field; 3] = [WINDOW.choice(), CONVEX_CLIP.choice(), SEGMENT.required()];

impl<A: LineTelling> Solve for A {
    const FIELDS: &'static [Field] = match (A::TAKES_POLYGON, A::WRITES_CODES) {
        (true, _) => &CONVEX,
        (false, true) => &CODED,
        (false, false) => &IN_WINDOW,
    };
    const OUTPUT: &'static [Field] = &VISIBLE;
    const READ: Reading<Self> = |fields| {
        let (window, clip) = (fields.get(&WINDOW)?, fields.get(&CONVEX_CLIP)?);
        let segment = fields.need(&SEGMENT)?;
        let bit_order = fields.get(&BIT_ORDER)?.unwrap_or_default();
        // A scene has a window even where a polygon takes its place: the one around the polygon.
        let window = match (window, &clip) {
            (Some(window), _) => window,
            (None, Some(clip)) => {
                bounds(clip).map_err(|error| fields.refuse(&CONVEX_CLIP, error))?
            }
            (None, None) => fields.need(&WINDOW)?,
        };
        let method = Method::by_id(A::ID).ok_or_else(impossible)?;
        let mut scene = Scene::new(method, window, vec![segment]).map_err(|_| impossible())?;
        (scene.clip, scene.bit_order) = (clip, bit_order);
        Ok(A::input(&scene, segment))
    };
    const VERDICT: Verdict<Self> = |visible| match *visible {
        None => Message::new("case-invisible"),
        Some(Segment { p1, p2 }) if p1 == p2 => {
            Message::new("case-touch").with("at", p1.to_array())
        }
        Some(Segment { p1, p2 }) => Message::new("case-visible")
            .with("p1", p1.to_array())
            .with("p2", p2.to_array()),
    };
}

fn bounds(clip: &ConvexPolygon) -> Result<Window, GeomError> {
    let mut bounds = [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY];
    for [x, y] in clip.vertices().iter().map(|p| p.to_array()) {
        let [xmin, ymin, xmax, ymax] = bounds;
        bounds = [xmin.min(x), ymin.min(y), xmax.max(x), ymax.max(y)];
    }
    let [xmin, ymin, xmax, ymax] = bounds;
    Window::new(xmin, ymin, xmax, ymax)
}

/// For what the checks before have excluded: refused all the same, not a panic.
fn impossible() -> Refusal {
    Refusal::whole(Code::Degenerate, Message::new("error-degenerate"))
}
