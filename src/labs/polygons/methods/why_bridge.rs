//! Why a bridge has no area, shown: what Sutherland–Hodgman leaves, and the strip that each of its edges sweeps.

use crate::{
    algo::{
        polygon::SutherlandHodgman,
        why::{Bridge, BridgeFact as Fact, BridgeInput, Shown, Why},
    },
    labs::why::{fact, mark, segment},
};

use super::{prelude::*, sutherland_hodgman::input};

/// A sum of more strips is not written out.
const MOST_SAID: usize = 12;

impl PolygonTelling for Why<Bridge> {
    fn input(scene: &Scene) -> Result<BridgeInput, UnfitScene> {
        let left = silent::<SutherlandHodgman>(&input(scene)?);
        let ring = left.vertices.iter().map(|at| at.to_array()).collect();
        let corners = scene.clip_outline();
        let across = || corners.vertices().iter().map(|at| at.x());
        let begin = [
            across().fold(f64::INFINITY, f64::min),
            across().fold(f64::NEG_INFINITY, f64::max),
        ];
        Ok(BridgeInput { ring, begin })
    }
}

const NAMES: [(&str, Fact); 2] = [("area", Fact::Area), ("elsewhere", Fact::Elsewhere)];

fn edge_now(step: &Step<'_, Why<Bridge>>) -> Option<usize> {
    match step.event()?.fact {
        Fact::Strip { edge } => Some(edge),
        Fact::Area | Fact::Elsewhere => None,
    }
}

fn edge_name(input: &BridgeInput, edge: usize) -> Value {
    let next = (edge + 1) % input.ring.len();
    name(vertex_symbol(edge) + &vertex_symbol(next))
}

const STRIP: &[&str] = &["{width} · {(height)}{=strip}"];

impl Telling for Why<Bridge> {
    type Scenery = ();

    const ID: &'static str = "why-bridge";
    const NAME_KEY: &'static str = "why-bridge";
    const SOURCE: &'static str = "Meister, 1769";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-edges", "why-words-edges"),
        code_line(1, "why-code-swept", "why-words-swept"),
        code_line(0, "why-code-area", "why-words-area"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::ListSeen("strips", "why"),
        Watched::Names(&["area"]),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-bridge-opening").so(&["x = {begin}"]);

    table! { |event, step|
        back: Shown { fact: Fact::Strip { edge }, .. } if step.input.twin(edge).is_some() =>
            Row::new(Test, 1, "why-bridge-back").so(&["{width} · {(height)}{=strip}", "{width} · {common}{=both}"]);
        up: Shown { fact: Fact::Strip { .. }, number } if number > 0.0 =>
            Row::new(Test, 1, "why-bridge-up").so(STRIP);
        down: Shown { fact: Fact::Strip { .. }, number } if number < 0.0 =>
            Row::new(Test, 1, "why-bridge-down").so(STRIP);
        none: Shown { fact: Fact::Strip { .. }, .. } => Row::new(Test, 1, "why-bridge-none").so(STRIP);
        area: Shown { fact: Fact::Area, .. } => Row::new(Accept, 2, "why-bridge-area").so(&["{sum}{=area}"]);
        elsewhere: Shown { fact: Fact::Elsewhere, .. } =>
            Row::new(Accept, 2, "why-bridge-elsewhere").so(&["x = {other begin}", "{elsewhere}"]);
    }

    fn named(at: &At<'_, Self>, of: &str) -> Option<Named> {
        let input = at.step.input;
        let edge = || edge_now(&at.step);
        Some(match of {
            "begin" => input.begin[0].into(),
            "other begin" => input.begin[1].into(),
            "edge" => edge_name(input, edge()?).into(),
            "other" => edge_name(input, input.twin(edge()?)?.0).into(),
            "common" => input.twin(edge()?)?.1.into(),
            "both" => {
                let (edge, common) = edge().and_then(|edge| Some((edge, input.twin(edge)?.1)))?;
                (measured(input, edge)[0] * common).into()
            }
            "width" => measured(input, edge()?)[0].into(),
            "height" => measured(input, edge()?)[1].into(),
            "strip" => at.step.event()?.number.into(),
            "sum" => {
                let strips = (0..input.ring.len()).filter_map(|edge| strip(at, edge));
                let strips: Vec<f64> = strips.filter(|strip| *strip != 0.0).collect();
                if strips.len() > MOST_SAID {
                    return None;
                }
                let terms = strips.into_iter().map(|strip| (strip, ()));
                sum_of(Formula::default(), terms, |it, ()| it).into()
            }
            _ => fact(&at.step, &NAMES, of)?.into(),
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let edges = 0..at.step.input.ring.len();
        let named =
            |edge| Some(Named::from(strip(at, edge)?).labelled(edge_name(at.step.input, edge)));
        edges.filter_map(named).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let table = View::new("why", Body::Table(strips(at)));
        vec![View::plane(marks(at)), table]
    }
}

fn strip(at: &At<'_, Why<Bridge>>, edge: usize) -> Option<f64> {
    at.step.held.get(Fact::Strip { edge })
}

/// How wide a strip is in its middle, and how far up its edge goes.
fn measured(input: &BridgeInput, edge: usize) -> [f64; 2] {
    let [[x1, y1], [x2, y2]] = input.edge(edge);
    [x1.midpoint(x2) - input.begin[0], y2 - y1]
}

fn marks(at: &At<'_, Why<Bridge>>) -> Vec<Mark> {
    let input = at.step.input;
    let (ring, begin) = (&input.ring, input.begin[0]);
    if ring.is_empty() {
        return Vec::new();
    }
    let mut marks = vec![mark(Role::Accent, Shape::Area(vec![ring.clone()]))];
    if let Some(edge) = edge_now(&at.step) {
        let [from, to] = input.edge(edge);
        let corners = vec![[begin, from[1]], from, to, [begin, to[1]]];
        marks.push(mark(Role::Signal, Shape::Fill(vec![corners])));
        marks.push(segment(Role::Signal, from, to));
        marks.push(mark(Role::Signal, Shape::Heading([from, to])));
        if let Some((other, _)) = input.twin(edge) {
            let [from, to] = input.edge(other);
            let corners = vec![vec![[begin, from[1]], from, to, [begin, to[1]]]];
            marks.push(mark(Role::Ink, Shape::Hatch(corners)));
        }
    }
    let corner = |(i, &at): (usize, &[f64; 2])| {
        mark(Role::Accent, Shape::Vertex(at)).labelled(vertex_name(i))
    };
    marks.extend(ring.iter().enumerate().map(corner));
    marks
}

fn strips(at: &At<'_, Why<Bridge>>) -> Table {
    let input = at.step.input;
    let row = |edge: usize| {
        let (strip, is_current) = (strip(at, edge), edge_now(&at.step) == Some(edge));
        let role = if is_current { Role::Signal } else { Role::Ink };
        let numbers = measured(input, edge).map(|x| Cell::new(role, strip.map(|_| x)));
        TableRow {
            name: edge_name(input, edge),
            cells: numbers
                .into_iter()
                .chain([Cell::new(role, strip).strong()])
                .collect(),
            is_current,
            link: None,
        }
    };
    let header = ["why-edge", "why-width", "why-height", "why-strip"];
    Table {
        header: header.map(|key| Formula::default().term(key)).to_vec(),
        rows: (0..input.ring.len()).map(row).chain([total(at)]).collect(),
        notes: Vec::new(),
    }
}

/// What the strips so far add up to.
fn total(at: &At<'_, Why<Bridge>>) -> TableRow {
    let edges = 0..at.step.input.ring.len();
    let so_far = edges
        .filter_map(|edge| strip(at, edge))
        .reduce(|sum, it| sum + it);
    let is_current = matches!(
        at.step.event(),
        Some(Shown {
            fact: Fact::Area,
            ..
        })
    );
    let role = if is_current { Role::Signal } else { Role::Ink };
    let empty = || Cell::new(role, None::<Value>);
    TableRow {
        name: Value::Term("why-sum"),
        cells: vec![empty(), empty(), Cell::new(role, so_far).strong()],
        is_current,
        link: None,
    }
}
