//! Cohen–Sutherland in space, shown.

use crate::{
    algo::{
        parameter::End,
        volume::{
            CohenSutherland3d, CohenSutherland3dEvent as Event, CohenSutherland3dInput,
            CohenSutherland3dState as State, SideCode,
        },
    },
    figure::{
        BitRow, Bits, Body, Caption, Link, Mark3, Role, Run, Shape3, Tick, View, Watch, WatchRow,
        WatchSection,
    },
    geom::{AlignedBox, VolumeSide},
    labs::{
        CodeLine, Demo, Step, Verdict, code_line,
        crossing_formulas::upright_in_space,
        operator::Operator,
        words::{end_link, end_name, end_name_now, name, subscript},
    },
    text::{Formula, Message},
    trace::Algorithm,
};

use super::{
    super::{
        OnScene, OnSceneInput, Scene, Subject,
        demo::SpaceDemo,
        part::{Fate, Outcome, segment_verdict},
        stage::{cube_view, face_at_work, side_name},
    },
    line::{
        accepted, end_formula, face_equation,
        marks::{segment_marks, shadow},
        unit_box,
    },
    planes::{parameter_row, place},
};

type Input = OnSceneInput<CohenSutherland3dInput>;
type Shown = OnScene<CohenSutherland3d>;

const CODES_VIEW: &str = "codes";

const CODES: usize = 0;
const ACCEPT: usize = 2;
const REJECT: usize = 3;
const CHOOSE: usize = 4;
const CUT: usize = 6;
const RECODE: usize = 7;

const CODE_SYMBOLS: [&str; 2] = ["code₁", "code₂"];
const AXES: [[VolumeSide; 2]; 3] = [
    [VolumeSide::Left, VolumeSide::Right],
    [VolumeSide::Bottom, VolumeSide::Top],
    [VolumeSide::Near, VolumeSide::Far],
];

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::BoxedSegment;

    fn input(scene: &Scene) -> Input {
        let own = CohenSutherland3dInput {
            bounds: unit_box(),
            ends: scene.places.segment(),
        };
        OnSceneInput::of(scene, own)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let input = Self::input(scene).own;
        segment_verdict(scene, (Self::SUBJECT, about), |end| fate(&input, end), run)
    }
}

/// The step that decided what became of an end, or of the whole segment: codes decide, and the first cut.
fn fate(input: &CohenSutherland3dInput, asked: Option<End>) -> Option<Fate> {
    let (mut step, mut fate) = (0, None);
    CohenSutherland3d::run::<f64>(input, |event| {
        step += 1;
        let outcome = match event {
            Event::Code { end, code, .. } if asked == Some(end) && fate.is_none() => {
                let beyond = code.lowest().map(|side| Outcome::Lost(side as usize));
                Some(beyond.unwrap_or(Outcome::Kept))
            }
            Event::Or { or } if asked.is_none() && fate.is_none() && or.is_inside() => {
                Some(Outcome::Kept)
            }
            Event::Cut { side, .. } if asked.is_none() && fate.is_none() => {
                Some(Outcome::Cut(side as usize))
            }
            Event::And { and } if asked.is_none() => {
                and.lowest().map(|side| Outcome::Lost(side as usize))
            }
            Event::Code { .. }
            | Event::Or { .. }
            | Event::And { .. }
            | Event::Choose { .. }
            | Event::Cut { .. }
            | Event::Accept { .. }
            | Event::Reject { .. } => None,
        };
        fate = outcome.map(|outcome| Fate { step, outcome }).or(fate);
    });
    fate
}

impl Demo for Shown {
    const ID: &'static str = "cohen-sutherland-3d";
    const NAME_KEY: &'static str = "alg-cohen-sutherland-3d";
    const SOURCE: &'static str = "Newman & Sproull, 1973";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-cs-codes", "words-cs-codes"),
        code_line(0, "code-cs-loop", "words-cs-loop"),
        code_line(1, "code-cs-accept", "words-cs-accept"),
        code_line(1, "code-cs-reject", "words-cs-reject"),
        code_line(1, "code-cs-choose", "words-cs-choose"),
        code_line(1, "code-cs-end", "words-cs-end"),
        code_line(1, "code-cs-cut", "words-cs-cut"),
        code_line(1, "code-cs-recode", "words-cs-recode"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Code { .. } | Event::Or { .. } | Event::And { .. } => Tick::Test,
            Event::Choose { .. } => Tick::Phase,
            Event::Cut { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Code { .. } if before.cut.is_some() => RECODE,
            Event::Code { .. } => CODES,
            Event::Or { .. } | Event::Accept { .. } => ACCEPT,
            Event::And { .. } | Event::Reject { .. } => REJECT,
            Event::Choose { .. } => CHOOSE,
            Event::Cut { .. } => CUT,
        }
    }

    fn opening(input: &Input) -> Caption {
        let [p1, p2] = &input.own.ends;
        Caption::new(Message::new("space-line-opening-box"))
            .so(end_formula("P₁", p1))
            .so(end_formula("P₂", p2))
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        let own = &input.own;
        match *event {
            Event::Code { end, at, code } => code_caption(end, at, code, &own.bounds),
            Event::Or { or } => {
                let key = if or.is_inside() {
                    "space-line-or-accept"
                } else {
                    "space-line-or-open"
                };
                combined(Message::new(key), "OR", or, before)
            }
            Event::And { and } => match and.lowest() {
                Some(side) => {
                    let message = Message::new("space-line-and-reject");
                    combined(message.with("plane", side_name(side)), "AND", and, before)
                }
                None => combined(Message::new("space-line-and-open"), "AND", and, before),
            },
            Event::Choose { end, side } => {
                let message = Message::new("space-line-choose")
                    .with("plane", side_name(side))
                    .with("end", end_name(end));
                let or = before.or.unwrap_or_default().to_string();
                Caption::new(message).so(Formula::default().sym("code₁ OR code₂ = ").sym(or))
            }
            Event::Cut { end, side, to, .. } => {
                let message = Message::new("cs-cut")
                    .with("end", end_name(end))
                    .with("border", face_equation(&own.bounds, side));
                let border = own.bounds.border(side);
                let formulas = upright_in_space(&own.ends, side.axis(), border, to);
                formulas
                    .into_iter()
                    .fold(Caption::new(message), Caption::so)
            }
            Event::Accept { ends } => accepted(&own.ends, &ends),
            Event::Reject { and } => {
                let message = Message::new("space-line-reject-codes");
                let plane = and.lowest().map_or_else(|| name("—"), side_name);
                let message = message.with("plane", plane);
                Caption::new(message.with("and", name(and.to_string())))
            }
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let scenery = step.input.scenery.as_deref();
        let drawing = scenery.map(|scenery| cube_view(scenery.scene(), marks(step)));
        let codes = View::new(CODES_VIEW, Body::Bits(codes(step)));
        drawing.into_iter().chain([codes]).collect()
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let ends = End::BOTH.into_iter().map(|end| {
            let at = place(step.state.ends[end.idx()]);
            WatchRow::new(end_name(end), Some(at)).linked(end_link(end))
        });
        let mut rows: Vec<WatchRow> = ends.collect();
        let t = match step.event {
            Some(Event::Cut { u, .. }) => Some(u),
            Some(
                Event::Code { .. }
                | Event::Or { .. }
                | Event::And { .. }
                | Event::Choose { .. }
                | Event::Accept { .. }
                | Event::Reject { .. },
            )
            | None => None,
        };
        rows.push(parameter_row(t));
        vec![
            WatchSection::list(rows),
            WatchSection::list(code_rows(step.state)).seen_in(CODES_VIEW),
        ]
    }
}

/// "P₁ is beyond left and far: code₁ = 100001", and the comparisons that say so.
fn code_caption(end: End, at: [f64; 3], code: SideCode, bounds: &AlignedBox) -> Caption {
    let beyond: Vec<VolumeSide> = code.sides().collect();
    let key = match beyond[..] {
        [] => "space-line-code-inside",
        [_] => "space-line-code-one",
        [_, _] => "space-line-code-two",
        [_, _, _, ..] => "space-line-code-three",
    };
    let message = Message::new(key)
        .with("end", end_name(end))
        .with("code", name(CODE_SYMBOLS[end.idx()]))
        .with("bits", name(code.to_string()));
    let names = ["first", "second", "third"]
        .into_iter()
        .zip(beyond.iter().rev());
    let message = names.fold(message, |message, (arg, &side)| {
        message.with(arg, side_name(side))
    });
    let formulas = AXES.iter().map(|sides| position(at, code, bounds, *sides));
    formulas.fold(Caption::new(message), Caption::so)
}

/// `x = −2 < −1` beyond a face, `−1 ≤ y = 0 ≤ 1` between both.
fn position(
    at: [f64; 3],
    code: SideCode,
    bounds: &AlignedBox,
    [low, high]: [VolumeSide; 2],
) -> Formula {
    let (symbol, value) = (["x = ", "y = ", "z = "][low.axis()], at[low.axis()]);
    let coordinate = |formula: Formula| formula.sym(symbol).num(value);
    if code.has(low) {
        coordinate(Formula::default())
            .sym(" < ")
            .num(bounds.border(low))
    } else if code.has(high) {
        coordinate(Formula::default())
            .sym(" > ")
            .num(bounds.border(high))
    } else {
        let from = Formula::default().num(bounds.border(low)).sym(" ≤ ");
        coordinate(from).sym(" ≤ ").num(bounds.border(high))
    }
}

/// The decision on a combination of both codes, worked out: `000001 OR 100010 = 100011`.
fn combined(message: Message, operator: &'static str, result: SideCode, before: &State) -> Caption {
    let [code1, code2] = before.codes.map(Option::unwrap_or_default);
    Caption::new(message.with("bits", name(result.to_string())))
        .so(Formula::default().sym(format!("{code1} {operator} {code2} = {result}")))
}

/// Both codes, and what OR and AND make of them.
fn code_rows(state: &State) -> Vec<WatchRow> {
    let code = |symbol: &'static str, code: Option<SideCode>| {
        WatchRow::new(name(symbol), code.map(|code| name(code.to_string())))
    };
    let of_ends = CODE_SYMBOLS.into_iter().zip(state.codes);
    let both = [("OR", state.or), ("AND", state.and)].into_iter();
    let rows = of_ends.chain(both);
    rows.map(|(symbol, found)| code(symbol, found)).collect()
}

/// The face whose bit decides at this step: that both ends lie beyond, or that is cut at.
fn deciding(step: &Step<'_, Shown>) -> Option<VolumeSide> {
    match step.event? {
        Event::And { and } | Event::Reject { and } => and.lowest(),
        Event::Choose { side, .. } | Event::Cut { side, .. } => Some(side),
        Event::Code { .. } | Event::Or { .. } | Event::Accept { .. } => None,
    }
}

fn marks(step: &Step<'_, Shown>) -> Vec<Mark3> {
    let (given, state) = (&step.input.own.ends, step.state);
    let mut marks: Vec<Mark3> = deciding(step).into_iter().flat_map(face_at_work).collect();
    marks.extend(shadow(given, -1.0));
    // A bit in common rejects as soon as it is seen.
    let is_rejected = matches!(step.event, Some(Event::And { and }) if !and.is_inside());
    let accepted = match state.verdict {
        Some(visible) => Some(visible.is_some()),
        None => is_rejected.then_some(false),
    };
    marks.extend(numbered_cuts(state));
    marks.extend(segment_marks(given, &state.ends, accepted));
    match step.event {
        Some(Event::Code { end, at, code }) => {
            let ring = Mark3::new(Role::Signal, Shape3::Ring(at));
            let code = ring.labelled(name(code.to_string())).strong();
            marks.push(code.linked(end_link(end)));
        }
        Some(Event::Cut { end, u, to, .. }) => {
            let label = Formula::default().sym("t = ").ratio(u.num, u.den);
            let dot = Mark3::new(Role::Signal, Shape3::Dot(to));
            marks.push(dot.labelled(label).strong().linked(end_link(end)));
        }
        Some(
            Event::Or { .. }
            | Event::And { .. }
            | Event::Choose { .. }
            | Event::Accept { .. }
            | Event::Reject { .. },
        )
        | None => {}
    }
    marks
}

/// Several cuts have numbers, in the order in which they were made.
fn numbered_cuts(state: &State) -> Vec<Mark3> {
    let cuts: Vec<[f64; 3]> = state.cuts.into_iter().flatten().collect();
    let passed = |(nth, at): (usize, [f64; 3])| {
        let label = name(format!("I{}", subscript(nth + 1)));
        let is_end = state.ends.contains(&at);
        (!is_end).then(|| Mark3::new(Role::Discarded, Shape3::Ring(at)).labelled(label))
    };
    cuts.into_iter().enumerate().filter_map(passed).collect()
}

/// Both codes as bits, and what an operator makes of them once it is asked.
fn codes(step: &Step<'_, Shown>) -> Bits {
    let bits = |code: SideCode| SideCode::WRITTEN.map(|side| code.has(side)).to_vec();
    let combined = combined_now(step);
    let row = |end: End| {
        let moved = step.state.ends[end.idx()] != step.input.own.ends[end.idx()];
        let found_now = matches!(step.event, Some(Event::Code { end: e, .. }) if e == end);
        BitRow {
            name: end_name_now(end, moved),
            bits: step.state.codes[end.idx()].map_or_else(Vec::new, bits),
            role: if found_now { Role::Signal } else { Role::Ink },
            link: Some(end_link(end)),
        }
    };
    let is_now = matches!(step.event, Some(Event::Or { .. } | Event::And { .. }));
    let column = |side| SideCode::WRITTEN.iter().position(|&of| of == side);
    Bits {
        columns: SideCode::WRITTEN.map(side_name).to_vec(),
        rows: End::BOTH.map(row).to_vec(),
        note: Some(match combined {
            None => Message::new("space-line-note-code"),
            Some((operator, _)) => operator.note(),
        }),
        result: combined.map(|(operator, code)| operator.row(bits(code), is_now)),
        deciding: deciding(step).and_then(column),
    }
}

/// The operator that the step is about, and what it gives.
fn combined_now(step: &Step<'_, Shown>) -> Option<(Operator, SideCode)> {
    let operator = match step.event? {
        Event::Code { .. } | Event::Cut { .. } => return None,
        Event::Or { .. } | Event::Accept { .. } | Event::Choose { .. } => Operator::Or,
        Event::And { .. } | Event::Reject { .. } => Operator::And,
    };
    operator.of([step.state.or, step.state.and])
}
