//! Sutherland–Hodgman as a pipeline, shown.

use crate::algo::polygon::{
    Pipeline, PipelineEvent as Event, PipelineHeld as Held, Rule, SutherlandHodgmanInput as Input,
};

use super::{
    super::handles::corner_link,
    clippers::{CLIPPERS, IN_AND_OUT, Now, edge, in_and_out, row as clippers},
    lists::{names, outline, output_symbol},
    prelude::*,
    result::result,
    sutherland_hodgman::{SOURCE, crossing_of, dropped_by, input},
};

pseudocode! {
    SEND: 0, "code-pipe-send", "words-pipe-send";
    ENTER: 0, "code-pipe-enter", "words-pipe-enter";
    FIRST: 1, "code-pipe-first", "words-pipe-first";
    CROSS: 1, "code-pipe-cross", "words-pipe-cross";
    PASS_ON: 1, "code-pipe-pass-on", "words-pipe-pass-on";
    OUTPUT: 0, "code-pipe-output", "words-pipe-output";
    CLOSE: 0, "code-pipe-close", "words-pipe-close";
}

const N_ROWS: usize = 8;

impl PolygonTelling for Pipeline {
    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        input(scene)
    }

    fn border(step: &Step<'_, Self>) -> Option<usize> {
        Now::of(step.past).stage_idx
    }

    fn asks(event: &Event<Point>) -> Option<Point> {
        asked_vertex(event)
    }

    fn crossing(event: &Event<Point>) -> Option<Point> {
        crossing_of(event)
    }

    fn dropped(step: &Step<'_, Self>) -> Vec<[Point; 2]> {
        dropped_by(step.past)
    }

    fn piece(step: &Step<'_, Self>) -> Option<Vec<Point>> {
        let is_done = matches!(step.event(), Some(Event::Done { .. }));
        is_done.then(|| step.held.output.clone())
    }
}

const fn test(line: usize, key: &'static str) -> Row {
    Row::new(Test, line, key).so(&["{S lies}", "{P lies}"])
}

const fn first(key: &'static str) -> Row {
    Row::new(Test, FIRST, key)
        .so(&["{P lies}"])
        .answers("first")
}

const fn cross(line: usize) -> Row {
    Row::new(Cut, line, "pipe-cross").so(&["{I 1}", "{I 2}", "{I 3}"])
}

fn is_closed(step: &Step<'_, Pipeline>, stage_idx: usize) -> bool {
    step.held.stages[stage_idx].is_closed
}

impl Telling for Pipeline {
    type Scenery = ();

    const ID: &'static str = "sutherland-hodgman-pipeline";
    const NAME_KEY: &'static str = "alg-sutherland-hodgman-pipeline";
    const SOURCE: &'static str = SOURCE;
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[Watched::Names(&["d_S", "d_P"])];

    table! { |event, step|
        send: Event::Enter { vertex_idx: Some(_), .. } => Row::new(Phase, SEND, "pipe-send");
        enter: Event::Enter { .. } => Row::new(Test, ENTER, "pipe-enter");
        first_inside: Event::First { inside: true, .. } => first("pipe-first-inside").keeps("P");
        first_outside: Event::First { .. } => first("pipe-first-outside").drops("P");
        // The edge that closes the ring lets a crossing through at most: its end has been asked before.
        closes_in_out: Event::Test { stage_idx, rule: Rule::InOut, distances, .. }
            if is_closed(step, stage_idx) && is_crossed(distances) =>
            puts_crossing(test(CLOSE, "pipe-closing-cross")).about("P");
        closes_out_in: Event::Test { stage_idx, rule: Rule::OutIn, distances, .. }
            if is_closed(step, stage_idx) && is_crossed(distances) =>
            puts_crossing(test(CLOSE, "pipe-closing-cross")).keeps("P");
        closes_inside: Event::Test { stage_idx, rule: Rule::InIn | Rule::OutIn, .. }
            if is_closed(step, stage_idx) => puts_nothing(test(CLOSE, "pipe-closing")).keeps("P");
        closes_outside: Event::Test { stage_idx, .. } if is_closed(step, stage_idx) =>
            puts_nothing(test(CLOSE, "pipe-closing")).about("P");
        in_in: Event::Test { rule: Rule::InIn, .. } => puts_end(test(PASS_ON, "pipe-vertex")).keeps("P");
        out_out: Event::Test { rule: Rule::OutOut, .. } => puts_nothing(test(PASS_ON, "pipe-nothing")).drops("P");
        in_out: Event::Test { rule: Rule::InOut, distances, .. } if is_crossed(distances) =>
            puts_crossing(test(CROSS, "pipe-crossing")).drops("P");
        leaves: Event::Test { rule: Rule::InOut, .. } => puts_nothing(test(CROSS, "pipe-nothing")).drops("P");
        out_in: Event::Test { rule: Rule::OutIn, distances, .. } if is_crossed(distances) =>
            puts_both(test(CROSS, "pipe-both")).keeps("P");
        comes: Event::Test { rule: Rule::OutIn, .. } => puts_end(test(CROSS, "pipe-vertex")).keeps("P");
        cuts_closing: Event::Cross { stage_idx, .. } if is_closed(step, stage_idx) => cross(CLOSE);
        cuts: Event::Cross { .. } => cross(CROSS);
        output: Event::Output { .. } => Row::new(Test, OUTPUT, "pipe-output");
        close_empty: Event::Close { stage_idx } if step.held.stages[stage_idx].first().is_none() =>
            Row::new(Phase, CLOSE, "pipe-close-empty");
        close: Event::Close { .. } => Row::new(Phase, CLOSE, "pipe-close");
        empty: Event::Done { outcome: RingOutcome::Empty } => Row::new(Reject, CLOSE, "sh-done-empty");
        degenerate: Event::Done { outcome: RingOutcome::Degenerate } =>
            Row::new(Reject, CLOSE, "sh-done-degenerate");
        whole: Event::Done { outcome: RingOutcome::Whole } => Row::new(Accept, CLOSE, "sh-done-whole");
        cut: Event::Done { outcome: RingOutcome::Cut } => Row::new(Accept, CLOSE, "sh-done-cut");
    }

    const OPENING: Row = Row::new(Phase, SEND, "pipe-opening");

    fn named(at: &At<'_, Self>, name_of: &str) -> Option<Named> {
        let Step { input, held, past } = at.step;
        let event = at.step.event();
        Some(match (name_of, event) {
            ("n", None) => input.vertices.len().into(),
            ("n", Some(_)) => held.output.len().into(),
            ("edges", _) => input.region.n_edges().into(),
            ("vertex", Some(Event::Enter { vertex_idx, .. })) => {
                name(vertex_idx.map_or_else(|| "P".to_owned(), vertex_symbol)).into()
            }
            ("vertex", _) => name(output_symbol(held.output.len().checked_sub(1)?)).into(),
            ("at", Some(Event::Enter { at, .. } | Event::Output { at })) => at.to_array().into(),
            ("border", _) => edge(input, Now::of(past).stage_idx?).border().into(),
            ("P", Some(event)) => {
                let asked = Self::asks(&event)?;
                let place = input.vertices.iter().position(|&given| given == asked);
                Named::from(name("P")).linked(corner_link(place?))
            }
            _ => {
                let now = Now::of(past);
                let symbol = |i: usize| match (i, now.moving) {
                    (0, _) => "S".to_owned(),
                    (_, Some(_)) if now.asked.test.is_some() => "P".to_owned(),
                    (..) => "F".to_owned(),
                };
                let formula = || {
                    let symbols = [0, 1].map(symbol);
                    edge(input, now.stage_idx?).asked(name_of, &event?, (&now.asked, symbols))
                };
                let of_test = match name_of {
                    // Clippers know no numbers of vertices: what comes in is P, what came before it S.
                    "from" => Some(name(symbol(0)).into()),
                    "to" => Some(name(symbol(1)).into()),
                    _ => now.asked.named(name_of, vertex_symbol),
                };
                return of_test.or_else(|| formula().map(Named::from));
            }
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(&at.step)),
            View::new(IN_AND_OUT, Body::Lists(in_and_out(&at.step))),
            View::new(CLIPPERS, Body::Clippers(clippers(&at.step))),
        ]
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let Step { input, held, past } = at.step;
        let now = Now::of(past);
        let point = |p: Option<Point>| p.map(|p| Value::Point(p.to_array()));
        let stages = held.stages.iter().enumerate().map(|(i, stage)| {
            let edge = edge(input, i);
            let cells = vec![point(stage.first()), point(stage.previous())];
            let row = WatchRow::table(edge.name(), cells).linked(edge.link());
            match (now.stage_idx == Some(i), stage.is_closed) {
                (true, _) => row.noted(name("←")),
                (false, true) => row.noted(Value::Term("pipe-closed")),
                (false, false) => row,
            }
        });
        let stages = WatchSection::table(vec!["F", "S"], stages.collect());
        let mut watch = vec![stages.seen_in(CLIPPERS)];
        watch.extend(now.asked.test.map(|_| at.section(&Self::WATCH[0])));
        let n = held.output.len();
        let start = n.saturating_sub(N_ROWS);
        let ring = held.output.iter().enumerate().skip(start);
        let ring = ring.map(|(i, &p)| WatchRow::new(name(output_symbol(i)), point(Some(p))));
        let ring = WatchSection::list(ring.collect()).part(start, n);
        watch.push(ring.seen_in(IN_AND_OUT));
        watch
    }
}

fn marks(step: &Step<'_, Pipeline>) -> Vec<Mark> {
    let Step { input, held, past } = *step;
    if let Some(Event::Done { outcome }) = step.event() {
        let ring = names(&held.output, output_symbol, Role::Accepted, &[], &[]);
        let end = (outcome, Role::Accepted);
        let left = result(&held.output, end, &input.region, &input.vertices);
        return left.into_iter().chain(ring).collect();
    }
    let now = Now::of(past);
    let mut marks = Vec::new();
    if let Some(stage_idx) = now.stage_idx {
        let is_asked = step
            .event()
            .is_some_and(|event| event.happening().is_some());
        let role = if is_asked { Role::Signal } else { Role::Soft };
        marks.push(edge(input, stage_idx).mark(role));
    }
    marks.push(Mark::new(Role::Accent, Shape::Path(outline(&held.output))).linked("output"));
    marks.extend(names(&input.vertices, vertex_symbol, Role::Soft, &[], &[]));
    marks.extend(memory(held, &now));
    marks.extend(moment(held, &now));
    marks
}

fn memory(held: &Held<Point>, now: &Now) -> Vec<Mark> {
    let Some(stage) = now.stage_idx.map(|i| held.stages[i]) else {
        return Vec::new();
    };
    let mark = |p: Point, symbol: &'static str| {
        Mark::new(Role::Ink, Shape::Ring(p.to_array())).labelled(name(symbol))
    };
    let first = stage.first().map(|p| mark(p, "F"));
    let previous = match now.asked.test {
        Some(_) => None,
        None => stage.previous().map(|p| mark(p, "S")),
    };
    first.into_iter().chain(previous).collect()
}

fn moment(held: &Held<Point>, now: &Now) -> Vec<Mark> {
    let mut marks = Vec::new();
    let signal =
        |shape: Shape, label: Value| Mark::new(Role::Signal, shape).labelled(label).strong();
    let vertex = |p: Point, is_inside: bool, symbol: &'static str| {
        signal(Shape::dot_or_ring(is_inside, p.to_array()), name(symbol))
    };
    match (now.asked.test, now.moving) {
        (Some(test), moving) => {
            let arrow = Shape::Arrow(test.ends.map(Point::to_array));
            marks.push(Mark::new(Role::Signal, arrow));
            // Nothing comes in while the ring is closed: then the edge ends at F.
            let symbols = ["S", if moving.is_some() { "P" } else { "F" }];
            marks.extend((0..2).map(|i| vertex(test.ends[i], test.inside()[i], symbols[i])));
        }
        (None, Some(at)) if now.stage_idx.is_some() => marks.push(vertex(at, true, "P")),
        (None, Some(at)) => {
            let symbol = output_symbol(held.output.len().saturating_sub(1));
            marks.push(signal(Shape::Dot(at.to_array()), name(symbol)));
        }
        (None, None) => {}
    }
    if let Some(Crossing { at, t }) = now.asked.crossing {
        let label = Formula::default().sym("I: t = ").ratio(t.num, t.den);
        marks.push(signal(Shape::Dot(at.to_array()), label.into()));
    }
    marks
}
