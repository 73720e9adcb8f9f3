//! A triangle before the divide, shown.

use serde_json::{Value as Json, json};

use crate::{
    algo::volume::{ClipPolygon, HomogeneousTriangle, SideCode},
    figure::{Body, Caption, Link, Run, Tick, View, Watch, WatchRow, WatchSection},
    geom::VolumeSide,
    labs::{Answer, CodeLine, Demo, Step, Verdict, record_beside, words::name},
    text::{Formula, Message, Value},
    trace::silent,
};

use super::{
    super::{
        super::{
            OnScene, OnSceneInput, Scene, Subject,
            demo::SpaceDemo,
            stage::{FaceLook, Fate, side_name},
        },
        planes::parameter_row,
    },
    LISTS_VIEW,
    agreement::{agreement_view, is_about_pictures, is_alone},
    clip_space::{Event, State, Uv, Vertex, bound_symbol, in_world, point, triangle},
    code::homogeneous,
    homogeneous_views::{BITS_VIEW, bits, camera_marks, lists, observer_marks},
    marks::vertex_symbol,
    tellings::in_clip_space,
    variant::{Homogeneous, Variant},
};

type Input = OnSceneInput<[Vertex; 3]>;
type Shown<L> = OnScene<HomogeneousTriangle<Uv, L>>;

impl Answer for ClipPolygon<Uv> {
    fn json(&self) -> Json {
        let triangles: Vec<[Vertex; 3]> = self.triangles().collect();
        let places = |piece: &[Vertex; 3]| piece.map(|v| v.at);
        let at: Vec<_> = triangles.iter().map(places).collect();
        let mut json = json!({ "triangles": at });
        if self.first_given().attributes.is_some() {
            let uv: Vec<_> = triangles
                .iter()
                .map(|piece| piece.map(|v| v.attributes))
                .collect();
            json["uv"] = json!(uv);
        }
        json
    }
}

impl<L: Variant<Homogeneous>> SpaceDemo for Shown<L> {
    const SUBJECT: Subject = Subject::Triangle;

    fn input(scene: &Scene) -> Input {
        OnSceneInput::of(scene, triangle(scene))
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let parts = in_clip_space::<L>(&Self::input(scene).own);
        parts.verdict(scene, about, |v| in_world(v, scene), run)
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, OnScene<HomogeneousTriangle<Uv>>>(Self::input(scene))
    }
}

impl<L: Variant<Homogeneous>> Demo for Shown<L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Blinn & Newell, 1978";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Side { .. } | Event::Codes { .. } | Event::Divide { .. } => Tick::Phase,
            Event::Cross { .. } => Tick::Cut,
            Event::Done { n_vertices } if *n_vertices < 3 => Tick::Reject,
            Event::Done { .. } => Tick::Accept,
            Event::First { .. }
            | Event::Test { .. }
            | Event::Output { .. }
            | Event::Pass { .. } => Tick::Test,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Divide { .. } | Event::Codes { .. } => homogeneous::CODES,
            Event::Side { .. } => homogeneous::EACH,
            Event::First { .. } | Event::Test { .. } | Event::Pass { .. } => homogeneous::BOUND,
            Event::Cross { .. } => homogeneous::CROSS,
            Event::Output { at } => match before.crossing {
                Some((crossing, _)) if crossing == *at => homogeneous::CROSS,
                Some(_) | None => homogeneous::BOUND,
            },
            Event::Done { n_vertices: 0 } => homogeneous::DECIDE,
            Event::Done { .. } => homogeneous::FAN,
        }
    }

    fn opening(input: &Input) -> Caption {
        let behind = input.own.iter().filter(|v| v.at[3] <= 0.0).count();
        let message = Message::new("ht-opening").with("n", 3_usize);
        Caption::new(message.with("behind", behind))
    }

    fn caption(event: &Event, before: &State, _: &Input) -> Caption {
        caption(event, before)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let parts = in_clip_space::<L>(&step.input.own);
        let mut views = Vec::new();
        let scenery = step.input.scenery.as_deref();
        let has_more = scenery.is_none_or(is_alone);
        if let Some(scenery) = scenery {
            let marks = observer_marks::<L>(step.state, &parts, step.event, scenery);
            views.push(scenery.observer(|_| Fate::ToCome, marks));
        }
        if let Some(scenery) = scenery.filter(|_| has_more) {
            let marks = camera_marks::<L>(step.state, step.event, scenery);
            views.push(scenery.camera(|_| Fate::ToCome, |_, _| FaceLook::Whole, marks));
        }
        if has_more {
            let codes = bits(step.state, &parts, step.event);
            views.push(View::new(BITS_VIEW, Body::Bits(codes)));
        }
        if !is_about_pictures(scenery) {
            let lists = lists(step.state, &parts, step.event);
            views.push(View::new(LISTS_VIEW, Body::Lists(lists)));
        }
        let own = &step.input.own;
        let left = silent::<HomogeneousTriangle<Uv, L>>(own);
        let found = [parts.n_cuts(), left.triangles().count()];
        views.extend(agreement_view(scenery, found));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let mut rows = Vec::new();
        if let Some((codes, or, and)) = state.codes {
            let code = |(i, code): (usize, &SideCode)| {
                let symbol = format!("code({})", vertex_symbol(i));
                WatchRow::new(name(symbol), Some(name(code.to_string())))
            };
            rows.extend(codes.iter().enumerate().map(code));
            rows.push(WatchRow::new(name("OR"), Some(name(or.to_string()))));
            rows.push(WatchRow::new(name("AND"), Some(name(and.to_string()))));
        }
        rows.extend(state.crossing.map(|(_, t)| parameter_row(Some(t))));
        let list = |polygon: &ClipPolygon<Uv>, prime: &str| {
            let row = |(i, v): (usize, &Vertex)| {
                let symbol = format!("{}{prime}", vertex_symbol(i));
                WatchRow::new(name(symbol), Some(Value::Formula(point(v.at))))
            };
            let rows = WatchSection::list(polygon.vertices().iter().enumerate().map(row).collect());
            if is_about_pictures(step.input.scenery.as_deref()) {
                rows
            } else {
                rows.seen_in(LISTS_VIEW)
            }
        };
        vec![
            if step.input.scenery.as_deref().is_none_or(is_alone) {
                WatchSection::list(rows).seen_in(BITS_VIEW)
            } else {
                WatchSection::list(rows)
            },
            list(&state.input, ""),
            list(&state.output, "′"),
        ]
    }
}

/// `w − x = 3 − 5 = −2 < 0`
fn bound(side: VolumeSide, at: [f64; 4], d: f64) -> Formula {
    let sign = if side.is_high() { " − " } else { " + " };
    let formula = Formula::default().sym(format!("{} = ", bound_symbol(side)));
    let formula = formula
        .num(at[3])
        .sym(sign)
        .operand(at[side.axis()])
        .equals(d);
    formula.sym(if d < 0.0 { " < 0" } else { " ≥ 0" })
}

fn with_side(key: &'static str, side: Option<VolumeSide>) -> Message {
    let message = Message::new(key);
    match side {
        Some(side) => message.with("side", side_name(side)),
        None => message,
    }
}

/// On which side of its bound a vertex lies.
fn tested(side: Option<VolumeSide>, idx: usize, (v, d): (Vertex, f64), inside: bool) -> Caption {
    let key = if inside { "ht-inside" } else { "ht-outside" };
    let message = with_side(key, side).with("vertex", name(vertex_symbol(idx)));
    let formula = side.map(|side| bound(side, v.at, d));
    formula.into_iter().fold(Caption::new(message), Caption::so)
}

fn caption(event: &Event, before: &State) -> Caption {
    let side = before.side;
    match *event {
        Event::Divide { triangle } => divided_caption(&triangle),
        Event::Codes { or, and, .. } => codes_caption(or, and),
        Event::Side { side } => {
            let message = Message::new("ht-side").with("side", side_name(side));
            let message = message.with("n", before.input.vertices().len());
            let inside = format!("{} ≥ 0", bound_symbol(side));
            Caption::new(message).so(Formula::default().sym(inside))
        }
        Event::First {
            at,
            distance,
            inside,
        } => tested(side, 0, (at, distance), inside),
        Event::Test {
            idx,
            ends,
            distances,
            rule,
        } => tested(side, idx[1], (ends[1], distances[1]), rule.ends_inside()),
        Event::Cross { at, t } => {
            let idx = before.test.map_or([0; 2], |(idx, ..)| idx);
            let message = with_side("ht-cross", side)
                .with("from", name(vertex_symbol(idx[0])))
                .with("to", name(vertex_symbol(idx[1])));
            let parameter = Formula::default().sym("t").equals(t.num / t.den);
            let place = Formula::default().sym("I = ");
            let place = Formula([place.0, point(at.at).0].concat());
            Caption::new(message).so(parameter).so(place)
        }
        Event::Output { at } => output_caption(before, at),
        Event::Pass { n_vertices, .. } => {
            let message = with_side("ht-pass", side).with("n", n_vertices);
            Caption::new(message.with("before", before.input.vertices().len()))
        }
        Event::Done { n_vertices } => {
            let key = if n_vertices < 3 {
                "ht-done-empty"
            } else {
                "ht-done"
            };
            let message = Message::new(key).with("n", n_vertices);
            Caption::new(message.with("triangles", n_vertices.saturating_sub(2)))
        }
    }
}

fn divided_caption(triangle: &[Vertex; 3]) -> Caption {
    let message = Message::new("ht-divide").with("n", triangle.len());
    let formulas = triangle.iter().enumerate().map(|(i, v)| {
        let symbol = format!("{}/w = ", vertex_symbol(i));
        Formula::default()
            .sym(symbol)
            .place([v.at[0], v.at[1], v.at[2]])
    });
    formulas.fold(Caption::new(message), Caption::so)
}

fn codes_caption(or: SideCode, and: SideCode) -> Caption {
    let key = match (and.is_inside(), or.is_inside()) {
        (false, _) => "ht-codes-outside",
        (true, true) => "ht-codes-inside",
        (true, false) => "ht-codes-cut",
    };
    let sides = SideCode::WRITTEN
        .into_iter()
        .filter(|&side| or.has(side))
        .count();
    let caption = Caption::new(Message::new(key).with("sides", sides));
    caption
        .so(Formula::default().sym(format!("OR = {or}")))
        .so(Formula::default().sym(format!("AND = {and}")))
}

fn output_caption(before: &State, at: Vertex) -> Caption {
    let symbol = match (before.crossing, before.test) {
        (Some((crossing, _)), _) if crossing == at => "I".to_owned(),
        (_, Some((idx, ..))) => vertex_symbol(idx[1]),
        (_, None) => vertex_symbol(0),
    };
    let message = Message::new("ip-output").with("vertex", name(symbol));
    Caption::new(message.with("n", before.output.vertices().len() + 1))
}
