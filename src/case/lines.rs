//! The lines lab's cases: a segment against a window, or against a convex polygon.

use crate::{
    algo::line::{
        BitOrder, BruteForce, CohenSutherland, CyrusBeck, LiangBarsky, NichollLeeNicholl, Visible,
    },
    geom::{ConvexPolygon, Edge, Point, Segment, Window},
    labs::lines::{LineTelling, Method, Scene},
    text::{Formula, Message, Value},
};

use super::{
    Code, Field, Fields, Given, Node, Path, Refusal, SolveTold, Solver, Told,
    fields::missing,
    parts::{given_clip, given_window, read_clip, read_window},
};

/// The lab's methods.
pub(super) static SOLVERS: [Solver; 5] = [
    Solver::told::<BruteForce>(),
    Solver::told::<CohenSutherland>(),
    Solver::told::<LiangBarsky>(),
    Solver::told::<CyrusBeck>(),
    Solver::told::<NichollLeeNicholl>(),
];

const WINDOW: [Field; 2] = [Field::required("window"), Field::required("segment")];
const CODED: [Field; 3] = [WINDOW[0], WINDOW[1], Field::optional("bit_order")];
const CONVEX: [Field; 3] = [
    Field::choice("window"),
    Field::choice("clip"),
    Field::required("segment"),
];

impl<A: LineTelling> SolveTold for A {
    const FIELDS: &'static [Field] = match (A::TAKES_POLYGON, A::WRITES_CODES) {
        (true, _) => &CONVEX,
        (false, true) => &CODED,
        (false, false) => &WINDOW,
    };

    fn read(fields: &Fields<'_>) -> Result<(A::Input, Told), Refusal> {
        let window = fields.get("window").map(|node| read_window(&node));
        let clip = fields
            .get("clip")
            .map(|node| read_clip(&node, fields.detail()));
        let (window, clip) = (window.transpose()?, clip.transpose()?);
        let segment = read_segment(&fields.need("segment")?)?;
        let choices = [("tbrl", BitOrder::Tbrl), ("lrbt", BitOrder::Lrbt)];
        let bit_order = fields
            .get("bit_order")
            .map(|node| node.choice(&choices))
            .transpose()?;
        // A scene has a window even where a polygon takes its place: the one around the polygon.
        let window = match (window, &clip) {
            (Some(window), _) => window,
            (None, Some(clip)) => bounds(clip)?,
            (None, None) => return Err(missing(&Path::Field("window"))),
        };
        let method = Method::by_id(A::ID).ok_or_else(impossible)?;
        let mut scene = Scene::new(method, window, vec![segment]).map_err(|_| impossible())?;
        scene.clip = clip;
        scene.bit_order = bit_order.unwrap_or_default();
        let input = A::input(&scene, segment);
        Ok((input, Box::new(move || given(&scene, A::WRITES_CODES))))
    }

    fn verdict(visible: &Visible) -> Message {
        match *visible {
            None => Message::new("case-invisible"),
            Some(Segment { p1, p2 }) if p1 == p2 => {
                Message::new("case-touch").with("at", p1.to_array())
            }
            Some(Segment { p1, p2 }) => Message::new("case-visible")
                .with("p1", p1.to_array())
                .with("p2", p2.to_array()),
        }
    }
}

fn read_segment(node: &Node<'_>) -> Result<Segment, Refusal> {
    let [x1, y1, x2, y2] = node.numbers()?;
    Segment::new(x1, y1, x2, y2).map_err(|error| Refusal::geometry(&node.path, error))
}

fn bounds(clip: &ConvexPolygon) -> Result<Window, Refusal> {
    let mut bounds = [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY];
    for p in clip.vertices() {
        bounds[0] = bounds[0].min(p.x());
        bounds[1] = bounds[1].min(p.y());
        bounds[2] = bounds[2].max(p.x());
        bounds[3] = bounds[3].max(p.y());
    }
    let [xmin, ymin, xmax, ymax] = bounds;
    Window::new(xmin, ymin, xmax, ymax)
        .map_err(|error| Refusal::geometry(&Path::Field("clip"), error))
}

/// For what the checks before have excluded: refused all the same, not a panic.
fn impossible() -> Refusal {
    Refusal::whole(Code::Degenerate, Message::new("error-degenerate"))
}

/// What the scene gives, in the order in which it is read.
fn given(scene: &Scene, writes_codes: bool) -> Vec<Given> {
    let clip_or_window = match &scene.clip {
        Some(clip) => given_clip(clip.vertices()),
        None => given_window(&scene.window),
    };
    let Segment { p1, p2 } = scene.focused();
    let end = |symbol, p: Point| {
        let formula = Formula::default().sym(symbol).sym(" = ");
        Value::Formula(formula.point(p.to_array()))
    };
    let ends = [end("P₁", p1), end("P₂", p2)];
    let segment = Given::new("object-segment", ends.into_iter());
    let mut given = vec![clip_or_window, segment];
    if writes_codes {
        let side = |edge| match edge {
            Edge::Left => Value::Term("side-left"),
            Edge::Right => Value::Term("side-right"),
            Edge::Bottom => Value::Term("side-bottom"),
            Edge::Top => Value::Term("side-top"),
        };
        let sides = scene.bit_order.written().map(side);
        given.push(Given::new("object-outcode", sides.into_iter()));
    }
    given
}
