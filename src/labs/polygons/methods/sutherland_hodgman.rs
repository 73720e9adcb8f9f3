//! Sutherland–Hodgman, shown.

use crate::{
    algo::polygon::{
        ClipRegion, Right, RingOutcome, Rule, SutherlandHodgman, SutherlandHodgmanEvent as Event,
        SutherlandHodgmanInput as Input, SutherlandHodgmanState as State, Textured,
    },
    figure::{Body, Caption, Run, Tick, View, Watch, WatchRow, WatchSection},
    geom::Point,
    labs::{
        CodeLine, Demo, Step,
        polygons::{GivenSubject, PolygonDemo, Scene, Texture, UnfitScene},
        record, record_beside,
        words::{name, point_formula, vertex_symbol},
    },
    text::{Formula, Message, Value},
};

use super::{
    clip_edge::{ClipEdge, EdgeLook},
    drawing::marks,
    faulty::Kept,
    list_view::lists,
    lists::{LISTS, output_symbol, rows},
    rules::{side_term, starts_inside, test_caption},
    skin::{LabVertex, Named},
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
    const GIVEN: GivenSubject = GivenSubject::CutOff;

    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        input(scene)
    }

    fn border(event: &Event<Point>) -> Option<usize> {
        match *event {
            Event::Edge { edge_idx, .. } => Some(edge_idx),
            Event::First { .. }
            | Event::Test { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Done { .. } => None,
        }
    }

    fn tells(event: &Event<Point>, vertex: Point) -> Option<bool> {
        match *event {
            Event::First { at, inside, .. } => (at == vertex).then_some(inside),
            Event::Test { ends, rule, .. } => (ends[1] == vertex).then_some(rule.ends_inside()),
            Event::Edge { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Done { .. } => None,
        }
    }

    fn crossing(event: &Event<Point>) -> Option<Point> {
        match *event {
            Event::Cross { at, .. } => Some(at),
            Event::Edge { .. }
            | Event::First { .. }
            | Event::Test { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Done { .. } => None,
        }
    }

    fn piece(event: &Event<Point>, after: &State<Point>) -> Option<Vec<Point>> {
        match event {
            Event::Done { .. } => Some(after.input.clone()),
            Event::Edge { .. }
            | Event::First { .. }
            | Event::Test { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Pass { .. } => None,
        }
    }

    fn record(scene: &Scene) -> Result<Box<dyn Run>, UnfitScene> {
        let texture = match L::DIFFERS_KEY {
            Some(_) => Texture::None,
            None => scene.texture,
        };
        Ok(match texture {
            Texture::None => record_beside::<Self, SutherlandHodgman>(input(scene)?),
            Texture::Interpolated => record::<SutherlandHodgman<Textured, L>>(textured(scene)?),
            Texture::Kept => record::<SutherlandHodgman<Kept, L>>(textured(scene)?),
        })
    }
}

/// The window, or the clip polygon where it is convex.
pub fn region(scene: &Scene) -> Result<ClipRegion, UnfitScene> {
    match scene.clip {
        None => Ok(scene.window.into()),
        Some(_) => scene.convex_clip().map(ClipRegion::from),
    }
}

pub fn input(scene: &Scene) -> Result<Input, UnfitScene> {
    Ok(Input::new(region(scene)?, &scene.subject))
}

/// With a place in the texture at every vertex.
fn textured<V: LabVertex>(scene: &Scene) -> Result<Input<V>, UnfitScene> {
    let texel = scene.texels();
    let vertices = scene.subject.vertices().iter();
    Ok(Input {
        region: region(scene)?,
        vertices: vertices.map(|&at| V::with_uv(at, texel(at))).collect(),
    })
}

impl<V: LabVertex, L: Variant> Demo for SutherlandHodgman<V, L> {
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
        let (input, state, event) = (step.input, step.state, step.event);
        vec![
            View::plane(marks(input, state, event, L::LOOK)),
            View::new(LISTS, Body::Lists(lists(input, state, event))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let lists = lists_watched(step.state);
        let lists = lists.into_iter().map(|section| section.seen_in(LISTS));
        scalars(step.state).into_iter().chain(lists).collect()
    }
}

pub fn caption<V: LabVertex>(
    event: &Event<V>,
    before: &State<V>,
    region: &ClipRegion,
    look: EdgeLook,
) -> Caption {
    let edge = ClipEdge::new(region, before.edge_idx.unwrap_or(0), look);
    match *event {
        Event::Edge {
            edge_idx,
            normal,
            origin,
        } => {
            let caption = Caption::new(ClipEdge::new(region, edge_idx, look).message());
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
            let first = (vertex_symbol(0), at.at());
            Caption::new(Message::new(key).with("vertex", name(first.0.clone())))
                .so(edge.position(&first, distance, inside))
        }
        Event::Test {
            idx,
            ends,
            distances,
            rule,
        } => test_caption(&edge, idx, ends.map(|v| v.at()), distances, rule),
        Event::Cross { at, .. } => cross_caption(&edge, before, at),
        Event::Output { at } => output_caption(before, at),
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

fn output_caption<V: LabVertex>(before: &State<V>, at: V) -> Caption {
    let symbol = output_symbol(before.output.len());
    let message = Message::new("sh-output")
        .with("vertex", name(put_out_symbol(before, at)))
        .with("place", name(symbol.clone()));
    let point = Formula::default().sym(symbol).sym(" = ");
    Caption::new(message).so(point.point(at.at().to_array()))
}

fn cross_caption<V: LabVertex>(edge: &ClipEdge<'_>, before: &State<V>, crossing: V) -> Caption {
    let at = crossing.at();
    // A crossing follows a test.
    let (idx, distances) = before
        .test
        .map_or(([0; 2], [0.0; 2]), |test| (test.idx, test.distances));
    let ends = idx.map(|i| Named {
        symbol: vertex_symbol(i),
        vertex: before.input.get(i).copied().unwrap_or(crossing),
    });
    let message = Message::new("sh-cross")
        .with("from", name(ends[0].symbol.clone()))
        .with("to", name(ends[1].symbol.clone()))
        .with("border", edge.border());
    let points = [ends[0].vertex.at(), ends[1].vertex.at()];
    let formulas = edge.crossing(points, distances, at);
    formulas
        .into_iter()
        .chain(crossing.uv_formula([&ends[0], &ends[1]], &edge.weights(points, distances)))
        .fold(Caption::new(message), Caption::so)
}

/// I, or the vertex of the input list that it is.
fn put_out_symbol<V: LabVertex>(before: &State<V>, vertex: V) -> String {
    match (before.crossing, before.test) {
        (Some((crossing, _)), _) if crossing == vertex => "I".to_owned(),
        (_, Some(test)) => vertex_symbol(test.idx[1]),
        (_, None) => vertex_symbol(0),
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

/// The distances of S and P from the clip edge, and where between them it is crossed.
pub fn scalars<V: LabVertex>(state: &State<V>) -> Option<WatchSection> {
    let test = state.test?;
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
    Some(WatchSection::list(list))
}

/// Both lists.
pub fn lists_watched<V: LabVertex>(state: &State<V>) -> Vec<WatchSection> {
    let current = state.test.map_or(0, |test| test.idx[1]);
    rows(&state.input, &state.output, current)
}
