//! Sutherland–Hodgman, shown.

use crate::{
    algo::{
        line::Ratio,
        polygon::{
            ClipRegion, EdgeTest, Right, RingOutcome, Rule, SutherlandHodgman,
            SutherlandHodgmanEvent as Event, SutherlandHodgmanInput as Input,
            SutherlandHodgmanState as State, Textured,
        },
    },
    figure::{Caption, Mark, Role, Run, Shape, Tick, View, Watch, WatchRow, WatchSection},
    geom::Point,
    labs::{
        CodeLine, Demo, Step,
        polygons::{PolygonDemo, Refusal, Scene, Texture},
        record, record_wrong,
        words::{name, point_formula},
    },
    text::{Formula, Message, Value},
};

use super::{
    clip_edge::{ClipEdge, Look},
    faulty::Kept,
    lists::{bridges, input_symbol, names, outline, output_symbol, result, rows, vertex_link},
    rules::{side_term, starts_inside, test_caption},
    skin::{Corner, Named, skin},
    variant::{EACH, FIRST, IN_IN, IN_OUT, OUT_IN, OUT_OUT, PASS, Variant},
};

/// The paper.
pub const SOURCE: &str = "Sutherland & Hodgman, 1974";

impl Variant for Right {
    const ID: &'static str = "sutherland-hodgman";
    const NAME_KEY: &'static str = "alg-sutherland-hodgman";
}

impl<L: Variant> PolygonDemo for SutherlandHodgman<Point, L> {
    const CARRIES_TEXTURE: bool = L::DIFFERS_KEY.is_none();

    fn input(scene: &Scene) -> Result<Input, Refusal> {
        input(scene)
    }

    fn record(scene: &Scene) -> Result<Box<dyn Run>, Refusal> {
        if L::DIFFERS_KEY.is_some() {
            return Ok(record_wrong::<Self, SutherlandHodgman>(input(scene)?));
        }
        Ok(match scene.texture {
            Texture::None => record::<Self>(input(scene)?),
            Texture::Interpolated => record::<SutherlandHodgman<Textured, L>>(textured(scene)?),
            Texture::Kept => record::<SutherlandHodgman<Kept, L>>(textured(scene)?),
        })
    }
}

/// The window, or the clip polygon where it is convex.
pub fn region(scene: &Scene) -> Result<ClipRegion, Refusal> {
    match scene.clip {
        None => Ok(scene.window.into()),
        Some(_) => scene.convex_clip().map(ClipRegion::from),
    }
}

pub fn input(scene: &Scene) -> Result<Input, Refusal> {
    Ok(Input::new(region(scene)?, &scene.subject))
}

/// With a place in the texture at every vertex.
fn textured<V: Corner>(scene: &Scene) -> Result<Input<V>, Refusal> {
    let texel = scene.texels();
    let vertices = scene.subject.vertices().iter();
    Ok(Input {
        region: region(scene)?,
        vertices: vertices.map(|&at| V::with_uv(at, texel(at))).collect(),
    })
}

impl<V: Corner, L: Variant> Demo for SutherlandHodgman<V, L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = SOURCE;
    const CODE: &'static [CodeLine] = &L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event<V>) -> Tick {
        match event {
            Event::Edge { .. } => Tick::Phase,
            Event::Cross { .. } => Tick::Cut,
            Event::Done {
                outcome: RingOutcome::Empty | RingOutcome::Degenerate,
            } => Tick::Reject,
            Event::Done { .. } => Tick::Accept,
            Event::First { .. }
            | Event::Test { .. }
            | Event::Output { .. }
            | Event::Pass { .. } => Tick::Test,
        }
    }

    fn code_line(event: &Event<V>, before: &State<V>) -> usize {
        let rule = match event {
            Event::Edge { .. } => return EACH,
            Event::First { .. } => return FIRST,
            Event::Pass { .. } | Event::Done { .. } => return PASS,
            Event::Test { rule, .. } => Some(*rule),
            Event::Cross { .. } | Event::Output { .. } => before.test.map(|test| test.rule),
        };
        match rule {
            None => FIRST,
            Some(Rule::InIn) => IN_IN,
            Some(Rule::InOut) => IN_OUT,
            Some(Rule::OutIn) => OUT_IN,
            Some(Rule::OutOut) => OUT_OUT,
        }
    }

    fn opening(input: &Input<V>) -> Caption {
        let message = Message::new("sh-opening")
            .with("n", input.vertices.len())
            .with("edges", input.region.n_edges());
        Caption::new(message)
    }

    fn caption(event: &Event<V>, before: &State<V>, input: &Input<V>) -> Caption {
        caption(event, before, &input.region, L::LOOK)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let marks = marks(step.input, step.state, step.event, L::LOOK);
        vec![View::plane(marks)]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        watch(step.state)
    }
}

pub fn caption<V: Corner>(
    event: &Event<V>,
    before: &State<V>,
    region: &ClipRegion,
    look: Look,
) -> Caption {
    let edge = ClipEdge::new(region, before.edge_idx.unwrap_or(0), look);
    match *event {
        Event::Edge {
            edge_idx,
            normal,
            origin,
        } => {
            let edge = ClipEdge::new(region, edge_idx, look);
            let caption = Caption::new(edge.message());
            match region {
                ClipRegion::Window(_) => caption,
                ClipRegion::Convex(_) => caption
                    .so(Formula::default().sym("n = ").point(normal))
                    .so(point_formula("E", origin)),
            }
        }
        Event::First {
            at,
            distance,
            inside,
        } => {
            let key = if inside {
                "sh-first-inside"
            } else {
                "sh-first-outside"
            };
            let first = (input_symbol(0), at.at());
            Caption::new(Message::new(key).with("vertex", name(first.0.clone())))
                .so(edge.position(&first, distance, inside))
        }
        Event::Test {
            idx,
            ends,
            distances,
            rule,
        } => test_caption(&edge, idx, ends.map(|v| v.at()), distances, rule),
        Event::Cross { at, t } => cross_caption(&edge, before, at, t),
        Event::Output { at } => {
            let symbol = output_symbol(before.output.len());
            let message = Message::new("sh-output")
                .with("vertex", name(put_out_symbol(before, at)))
                .with("place", name(symbol.clone()));
            let point = Formula::default().sym(symbol).sym(" = ");
            Caption::new(message).so(point.point(at.at().to_array()))
        }
        Event::Pass { n_vertices, .. } => {
            let key = if n_vertices == 0 {
                "sh-pass-empty"
            } else {
                "sh-pass"
            };
            let message = Message::new(key).with("n", n_vertices);
            Caption::new(message.with("border", edge.border()))
        }
        Event::Done { outcome } => done(outcome, before.input.len(), region.n_edges()),
    }
}

fn cross_caption<V: Corner>(
    edge: &ClipEdge<'_>,
    before: &State<V>,
    crossing: V,
    t: Ratio,
) -> Caption {
    let at = crossing.at();
    // A crossing follows a test.
    let (idx, distances) = before
        .test
        .map_or(([0; 2], [0.0; 2]), |test| (test.idx, test.distances));
    let ends = idx.map(|i| Named {
        symbol: input_symbol(i),
        vertex: before.input.get(i).copied().unwrap_or(crossing),
    });
    let message = Message::new("sh-cross")
        .with("from", name(ends[0].symbol.clone()))
        .with("to", name(ends[1].symbol.clone()))
        .with("border", edge.border());
    let points = [ends[0].vertex.at(), ends[1].vertex.at()];
    let formulas = edge.crossing(points, distances, t, at);
    formulas
        .into_iter()
        .chain(crossing.uv_formula([&ends[0], &ends[1]], t))
        .fold(Caption::new(message), Caption::so)
}

/// I, or the vertex of the input list that it is.
fn put_out_symbol<V: Corner>(before: &State<V>, vertex: V) -> String {
    match (before.crossing, before.test) {
        (Some((crossing, _)), _) if crossing == vertex => "I".to_owned(),
        (_, Some(test)) => input_symbol(test.idx[1]),
        (_, None) => input_symbol(0),
    }
}

/// What is left, in words.
pub fn done(outcome: RingOutcome, n_vertices: usize, n_edges: usize) -> Caption {
    let key = match outcome {
        RingOutcome::Empty => "sh-done-empty",
        RingOutcome::Whole => "sh-done-whole",
        RingOutcome::Cut => "sh-done-cut",
        RingOutcome::Degenerate => "sh-done-degenerate",
    };
    let message = Message::new(key).with("n", n_vertices);
    Caption::new(message.with("edges", n_edges))
}

pub fn marks<V: Corner>(
    input: &Input<V>,
    state: &State<V>,
    event: Option<Event<V>>,
    look: Look,
) -> Vec<Mark> {
    let mut marks = Vec::from_iter(skin(&state.input));
    if let Some(outcome) = state.outcome {
        marks.extend(result(
            &state.input,
            outcome,
            &input.region,
            &input.vertices,
        ));
        return marks;
    }
    if let Some(edge_idx) = state.edge_idx {
        let is_new = matches!(event, Some(Event::Edge { .. }));
        let role = if is_new { Role::Signal } else { Role::Soft };
        marks.push(ClipEdge::new(&input.region, edge_idx, look).mark(role));
    }
    marks.push(Mark::new(Role::Ink, Shape::Outline(outline(&state.input))).linked("input"));
    marks.push(Mark::new(Role::Accent, Shape::Path(outline(&state.output))).linked("output"));
    let shown = match (state.test, state.first) {
        (Some(test), _) => test.idx.to_vec(),
        (None, Some(_)) => vec![0],
        (None, None) => Vec::new(),
    };
    marks.extend(names(&state.input, &shown));
    if let Some(Event::Pass { .. }) = event {
        marks.extend(bridges(&state.input, &input.region));
    }
    marks.extend(moment(state, event));
    marks
}

/// What happens at this step: the edge, its ends, its crossing, the vertex put out.
fn moment<V: Corner>(state: &State<V>, event: Option<Event<V>>) -> Vec<Mark> {
    let mut marks = Vec::new();
    let vertex = |i: usize, is_inside: bool| {
        let at = state.input[i].at().to_array();
        let shape = if is_inside {
            Shape::Dot(at)
        } else {
            Shape::Ring(at)
        };
        Mark::new(Role::Signal, shape)
            .labelled(name(input_symbol(i)))
            .strong()
            .linked(vertex_link(i))
    };
    match (state.test, state.first) {
        (Some(EdgeTest { idx, rule, .. }), _) => {
            let ends = idx.map(|i| state.input[i].at().to_array());
            marks.push(Mark::new(Role::Signal, Shape::Arrow(ends)));
            marks.push(vertex(idx[0], starts_inside(rule)));
            marks.push(vertex(idx[1], rule.ends_inside()));
        }
        (None, Some((_, is_inside))) => marks.push(vertex(0, is_inside)),
        (None, None) => {}
    }
    if let Some((crossing, t)) = state.crossing {
        let label = Formula::default().sym("I: t = ").ratio(t.num, t.den);
        let dot = Shape::Dot(crossing.at().to_array());
        marks.push(Mark::new(Role::Signal, dot).labelled(label).strong());
    }
    if let Some(Event::Output { at }) = event {
        let last = output_symbol(state.output.len().saturating_sub(1));
        let dot = Shape::Dot(at.at().to_array());
        marks.push(Mark::new(Role::Accent, dot).labelled(name(last)).strong());
    }
    marks
}

pub fn watch<V: Corner>(state: &State<V>) -> Watch {
    let current = state.test.map_or(0, |test| test.idx[1]);
    let mut watch = Vec::new();
    if let Some(test) = state.test {
        let distance = |i: usize| {
            let side = [starts_inside(test.rule), test.rule.ends_inside()][i];
            let symbol = ["d_S", "d_P"][i];
            WatchRow::new(name(symbol), Some(Value::Number(test.distances[i])))
                .noted(Value::Term(side_term(side)))
        };
        let mut list = vec![distance(0), distance(1)];
        if let Some((_, t)) = state.crossing {
            let (num, den) = (t.num, t.den);
            list.push(WatchRow::new(name("t"), Some(Value::Ratio { num, den })));
        }
        watch.push(WatchSection::list(list));
    }
    watch.extend(rows(&state.input, &state.output, current));
    watch
}
