//! Nicholl–Lee–Nicholl, shown.

use crate::{
    algo::line::{
        CornerLine, NichollLeeNicholl, NichollLeeNichollEvent as Event, Question, Turn,
        WindowRegion,
    },
    labs::{
        segments::{ENDS, end_named, left_in},
        words::position_formula,
    },
};

use super::{
    prelude::*,
    sectors::{self, turn_key},
    shared::{
        border_mark, corner_formula, corner_name, crossing_mark, end_now, ends, put_formulas,
        region_key, segment_marks, side,
    },
};

const CORNERS_VIEW: &str = "corners";

pseudocode! {
    REGIONS: 0, "code-nln-regions", "words-nln-regions";
    SHARED: 0, "code-nln-shared", "words-nln-shared";
    ENTERS: 0, "code-nln-enters", "words-nln-enters";
    MEETS: 0, "code-nln-meets", "words-nln-meets";
    LEAVES: 0, "code-nln-leaves", "words-nln-leaves";
    CUT: 0, "code-nln-cut", "words-nln-cut";
}

impl LineTelling for NichollLeeNicholl {
    fn input(scene: &Scene, segment: Segment) -> WindowInput {
        scene.with(segment)
    }

    fn cuts(event: &Event, segment: &Segment) -> Option<(End, f64)> {
        if let Event::Cut { end, to, .. } = *event {
            Some((end, nearest_along(segment, to.to_array())))
        } else {
            None
        }
    }
}

const fn side_row(line: usize, key: &'static str) -> Row {
    Row::new(Test, line, key)
        .so(&["a₁·b₂ = {a₁·b₂} {relation} b₁·a₂ = {b₁·a₂}"])
        .picks_as("turn", "turns", "nln-option-side")
}

fn is_through(line: &CornerLine) -> bool {
    line.turn == Turn::Through
}

/// Is a side that P₂ lies beyond crossed before the one by which the segment would come in?
fn is_miss(step: &Step<'_, NichollLeeNicholl>, line: &CornerLine) -> bool {
    let [_, region] = step.held.regions;
    region.is_some_and(|region| region.edges().any(|edge| line.first == Some(edge)))
}

impl Telling for NichollLeeNicholl {
    type Scenery = ();

    const ID: &'static str = "nicholl-lee-nicholl";
    const NAME_KEY: &'static str = "alg-nicholl-lee-nicholl";
    const SOURCE: &'static str = "Nicholl, Lee & Nicholl, 1987";
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "P₁",
        "P₂",
        "region₁",
        "region₂",
        "in by",
        "out by",
        "crossings",
    ])];
    const OPENING: Row = Row::new(Phase, REGIONS, "line-opening").so(ENDS);

    table! { |event, step|
        region: Event::Region { .. } =>
            Row::new(Test, REGIONS, "nln-region").so(&["{x}", "{y}"])
                .about("end").picks_as("region", "regions", "nln-option-region");
        through_enters: Event::Side { question: Question::Enters, line } if is_through(&line) =>
            side_row(ENTERS, "nln-side-through");
        through_meets: Event::Side { question: Question::Meets, line } if is_through(&line) =>
            side_row(MEETS, "nln-side-through");
        through_leaves: Event::Side { question: Question::Leaves, line } if is_through(&line) =>
            side_row(LEAVES, "nln-side-through");
        enters: Event::Side { question: Question::Enters, .. } => side_row(ENTERS, "nln-side-enters");
        misses: Event::Side { question: Question::Meets, line } if is_miss(step, &line) =>
            side_row(MEETS, "nln-side-meets").drops("segment");
        meets: Event::Side { question: Question::Meets, .. } => side_row(MEETS, "nln-side-meets");
        leaves: Event::Side { question: Question::Leaves, .. } => side_row(LEAVES, "nln-side-leaves");
        inside: Event::Sector { enters: None, leaves: None } =>
            Row::new(Phase, LEAVES, "nln-sector-inside").so(ENDS).keeps("segment");
        in_by: Event::Sector { leaves: None, .. } =>
            Row::new(Phase, LEAVES, "nln-sector-enters").keeps("segment");
        out_by: Event::Sector { enters: None, .. } =>
            Row::new(Phase, LEAVES, "nln-sector-leaves").keeps("segment");
        across: Event::Sector { .. } => Row::new(Phase, LEAVES, "nln-sector-both").keeps("segment");
        cut: Event::Cut { .. } =>
            Row::new(Cut, CUT, "cs-cut").so(&["{1st}", "{2nd}", "{3rd}"]).cuts("end");
        point: Event::Accept { .. } if step.input.segment.is_point() =>
            Row::new(Accept, CUT, "line-point");
        touch: Event::Accept { segment } if segment.is_point() => Row::new(Accept, CUT, "line-touch");
        accept: Event::Accept { .. } => Row::new(Accept, CUT, "line-accept");
        beyond: Event::Reject { corner: None, .. } =>
            Row::new(Reject, SHARED, "line-reject-edge").drops("segment");
        miss: Event::Reject { .. } => Row::new(Reject, MEETS, "nln-miss");
    }

    fn named(At { step, .. }: &At<'_, Self>, of: &str) -> Option<Named> {
        let by = |i: usize, key| {
            let by = sector(step).map(|sector| sector[i].map_or_else(|| name("–"), edge_name));
            Some(Named::maybe(by).labelled(Value::Term(key)))
        };
        let region = |end: End, key| {
            let region = step.held.regions[end.idx()].map(|region| Value::Term(key_of(region)));
            let named = Named::maybe(region).labelled(Value::Term(key));
            Some(named.linked(end_link(end)))
        };
        match of {
            "P₁" => Some(end_now(End::P1, step.held.ends[0])),
            "P₂" => Some(end_now(End::P2, step.held.ends[1])),
            "region₁" => region(End::P1, "watch-region-1"),
            "region₂" => region(End::P2, "watch-region-2"),
            "in by" => by(0, "watch-enters"),
            "out by" => by(1, "watch-leaves"),
            "crossings" => {
                let is_cut = |event: &&Event| matches!(event, Event::Cut { .. });
                let n = step.past.iter().filter(is_cut).count();
                Some(Named::from(n).labelled(Value::Term("watch-crossings")))
            }
            _ => of_event(step, step.event()?, of)
                .or_else(|| left_in(step.held.visible.map(ends), of)),
        }
    }

    fn listed(_: &At<'_, Self>, list: &str) -> Vec<Named> {
        if list == "turns" {
            let turns = [Turn::Left, Turn::Through, Turn::Right];
            return turns
                .map(|turn| Value::Term(turn_key(turn)).into())
                .to_vec();
        }
        let columns = [Some(Edge::Left), None, Some(Edge::Right)].into_iter();
        let rows = [Some(Edge::Top), None, Some(Edge::Bottom)];
        let regions = columns.flat_map(|x| rows.map(|y| WindowRegion { x, y }));
        regions.map(|it| Value::Term(key_of(it)).into()).collect()
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let asked = lines(&at.step).map(|(question, line)| {
            let cells = line.products.map(|p| Some(Value::Number(p))).to_vec();
            WatchRow::table(Value::Term(question_key(question)), cells)
                .noted(Value::Term(turn_key(line.turn)))
        });
        let table = WatchSection::table(vec!["a₁·b₂", "b₁·a₂"], asked.collect());
        let names = Self::WATCH.iter().map(|watched| at.section(watched));
        names.chain([table.seen_in(CORNERS_VIEW)]).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(&at.step)),
            View::new(CORNERS_VIEW, Body::Table(corner_table(&at.step))),
        ]
    }
}

fn of_event(step: &Step<'_, NichollLeeNicholl>, event: Event, of: &str) -> Option<Named> {
    let WindowInput { window, segment } = step.input;
    Some(match (of, event) {
        ("end", Event::Region { end, .. } | Event::Cut { end, .. }) => end_named(end),
        ("region", Event::Region { region, .. }) => Value::Term(key_of(region)).into(),
        ("x", Event::Region { end, region }) => position(Axis::X, end, region, step.input).into(),
        ("y", Event::Region { end, region }) => position(Axis::Y, end, region, step.input).into(),
        ("corner", Event::Side { line, .. }) => corner_formula(window, line.corner).into(),
        ("corner", Event::Reject { corner, .. }) => corner_formula(window, corner?).into(),
        ("turn", Event::Side { line, .. }) => Value::Term(turn_key(line.turn)).into(),
        ("relation", Event::Side { line, .. }) => name(relation(line.turn)).into(),
        ("a₁·b₂", Event::Side { line, .. }) => line.products[0].into(),
        ("b₁·a₂", Event::Side { line, .. }) => line.products[1].into(),
        ("first" | "rejects", Event::Side { line, .. }) => {
            side(line.first.unwrap_or(line.edges[0]))
        }
        ("edge" | "rejects", Event::Reject { edge, .. }) => side(edge),
        ("enters", Event::Sector { enters, .. }) => side(enters?),
        ("leaves", Event::Sector { leaves, .. }) => side(leaves?),
        ("border", Event::Cut { edge, .. }) => border_equation(window, edge).into(),
        ("1st" | "2nd" | "3rd", Event::Cut { edge, to, .. }) => {
            let mut formulas = put_formulas(segment, window, edge, to, crossed(step)).into_iter();
            let nth = ["1st", "2nd", "3rd"].iter().position(|it| *it == of)?;
            formulas.nth(nth)?.into()
        }
        _ => return None,
    })
}

fn sector(step: &Step<'_, NichollLeeNicholl>) -> Option<[Option<Edge>; 2]> {
    step.past.iter().find_map(|event| match *event {
        Event::Sector { enters, leaves } => Some([enters, leaves]),
        _ => None,
    })
}

fn crossed(step: &Step<'_, NichollLeeNicholl>) -> Option<[Edge; 2]> {
    let [enters, leaves] = sector(step)?;
    enters.zip(leaves).map(Into::into)
}

fn lines(step: &Step<'_, NichollLeeNicholl>) -> impl Iterator<Item = (Question, CornerLine)> {
    step.past.iter().filter_map(|event| match *event {
        Event::Side { question, line } => Some((question, line)),
        _ => None,
    })
}

fn corner_table(step: &Step<'_, NichollLeeNicholl>) -> Table {
    let n_asked = lines(step).count();
    let is_asking = matches!(step.event(), Some(Event::Side { .. }));
    let rows = lines(step).enumerate();
    let rows = rows.map(|(i, (question, line))| {
        let is_current = is_asking && i + 1 == n_asked;
        let role = if is_current { Role::Signal } else { Role::Ink };
        let [p, q] = line.products.map(Value::Number);
        let cells = [
            Value::Term(question_key(question)),
            p,
            name(relation(line.turn)),
            q,
            Value::Term(turn_key(line.turn)),
        ];
        TableRow {
            name: corner_name(&step.input.window, line.corner),
            cells: cells.map(|value| Cell::new(role, Some(value))).to_vec(),
            is_current,
            link: None,
        }
    });
    Table {
        header: vec![
            Formula::default().term("table-corner"),
            Formula::default(),
            sym("a₁·b₂"),
            Formula::default(),
            sym("b₁·a₂"),
            sym("P₂"),
        ],
        rows: rows.collect(),
        notes: vec![TableNote {
            text: Message::new("nln-note-products"),
            applies: is_asking,
        }],
    }
}

const fn relation(turn: Turn) -> &'static str {
    match turn {
        Turn::Left => "<",
        Turn::Through => "=",
        Turn::Right => ">",
    }
}

fn marks(step: &Step<'_, NichollLeeNicholl>) -> Vec<Mark> {
    let WindowInput { window, segment } = step.input;
    let event = step.event();
    let is_accepted = matches!(event, Some(Event::Accept { .. }));
    let is_over = is_accepted || matches!(event, Some(Event::Reject { .. }));
    let is_visible = is_over.then_some(is_accepted);
    let p1 = segment.p1;
    let mut marks: Vec<Mark> = Vec::new();
    if step.held.regions[0].is_some() {
        marks.extend(sectors::marks(p1, window));
    }
    let current = match event {
        Some(Event::Side { line, .. }) => Some(line.corner),
        Some(Event::Reject { corner, .. }) => corner,
        Some(
            Event::Region { .. } | Event::Sector { .. } | Event::Cut { .. } | Event::Accept { .. },
        )
        | None => None,
    };
    let asked = lines(step).map(|(_, line)| line.corner);
    let asked: Vec<Point> = asked.filter(|&corner| corner != p1).collect();
    for corner in window.corners() {
        let is_now = current == Some(corner);
        let role = if is_now { Role::Signal } else { Role::Soft };
        if asked.contains(&corner) {
            let ray = Shape::Ray([p1.to_array(), corner.to_array()]);
            marks.push(Mark::new(role, ray));
        }
        let label = corner_name(window, corner);
        marks.push(Mark::new(role, Shape::Dot(corner.to_array())).labelled(label));
    }
    if let Some(Event::Cut { edge, .. }) = event {
        marks.push(border_mark(window, edge));
    }
    marks.extend(segment_marks(segment, step.held.ends, is_visible));
    match event {
        Some(Event::Region { end, .. }) => {
            let at = end.of(segment).to_array();
            marks.push(Mark::new(Role::Signal, Shape::Ring(at)).linked(end_link(end)));
        }
        Some(Event::Cut { end, u, to, .. }) => {
            marks.push(crossing_mark(to, "t", u).linked(end_link(end)));
        }
        Some(
            Event::Side { .. } | Event::Sector { .. } | Event::Accept { .. } | Event::Reject { .. },
        )
        | None => {}
    }
    marks
}

fn key_of(region: WindowRegion) -> &'static str {
    region_key(|edge| region.edges().any(|e| e == edge))
}

const fn question_key(question: Question) -> &'static str {
    match question {
        Question::Enters => "nln-question-enters",
        Question::Meets => "nln-question-meets",
        Question::Leaves => "nln-question-leaves",
    }
}

fn position(axis: Axis, end: End, region: WindowRegion, input: &WindowInput) -> Formula {
    let beyond = |edge| region.edges().any(|e| e == edge);
    position_formula(axis, end.of(&input.segment), &input.window, beyond)
}
