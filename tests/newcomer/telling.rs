//! The codes of a bounding box's corners, shown.

use clipscope::{
    algo::{
        cull::Containment::{Inside, Outside, Straddles},
        volume::SideCode,
    },
    figure::{BitRow, Bits},
    labs::frustum::prelude::*,
};

use super::corner_codes::{
    CornerCodes, CornerCodesEvent as Event, CornerCodesInput, CornerCodesOutput,
};

const CODES_VIEW: &str = "codes";

impl AnswerAsItIs for CornerCodesOutput {}

impl SpaceTelling for CornerCodes {
    fn input(scene: &Scene) -> CornerCodesInput {
        CornerCodesInput {
            clip_from_box: scene.culler().clip_from_world(),
            bounds: scene.focused().bounds().expect("its vertices are finite"),
        }
    }
}

const CODED: &[&str] = &["~ (x, y, z, w) = {clip}", "code = {code}"];
const ALL: &[&str] = &["AND = {AND}", "OR = {OR}"];

impl Telling for CornerCodes {
    type Scenery = Scenery;

    const ID: &'static str = "corner-codes";
    const NAME_KEY: &'static str = "alg-corner-codes";
    const SOURCE: &'static str = "Newman & Sproull, 1973";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-corners-each", "words-corners-each"),
        code_line(1, "code-ht-codes", "words-ht-codes"),
        code_line(0, "code-corners-and", "words-corners-and"),
        code_line(0, "code-corners-or", "words-corners-or"),
        code_line(0, "code-corners-else", "words-corners-else"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["min", "max"]),
        Watched::Seen(&["AND", "OR"], CODES_VIEW),
        Watched::ListSeen("codes", CODES_VIEW),
    ];
    const OPENING: Row = Row::new(Phase, 0, "corners-opening").so(&["min = {min}", "max = {max}"]);

    table! { |event, step|
        inside: Event::Corner { code, .. } if code.is_inside() =>
            Row::new(Test, 1, "corners-inside").so(CODED).answers("code").keeps("corner");
        beyond: Event::Corner { .. } =>
            Row::new(Test, 1, "corners-beyond").so(CODED).answers("code").drops("corner");
        culled: Event::Done { class: Outside, .. } => Row::new(Reject, 2, "corners-culled")
            .so(ALL).drops("plane").answers_as("class", "option-corners-culled");
        kept: Event::Done { class: Inside, .. } =>
            Row::new(Accept, 3, "corners-kept").so(ALL).answers("class");
        cut: Event::Done { class: Straddles, .. } =>
            Row::new(Accept, 4, "corners-cut").so(ALL).answers("class");
    }

    fn named(at: &At<'_, Self>, name_of: &str) -> Option<Named> {
        let (bounds, codes) = (&at.step.input.bounds, codes(&at.step));
        Some(match (name_of, at.step.event()) {
            ("min", _) => Formula::default().place(bounds.min()).into(),
            ("max", _) => Formula::default().place(bounds.max()).into(),
            ("corners", _) => codes.len().into(),
            ("corner", Some(Event::Corner { corner_idx, .. })) => {
                Named::from(corner_name(corner_idx)).linked(corner_link(corner_idx))
            }
            ("clip", Some(Event::Corner { clip, .. })) => sym("(").list(&clip).sym(")").into(),
            ("code", Some(Event::Corner { code, .. })) => name(code.to_string()).into(),
            ("AND", Some(Event::Done { and, .. })) => name(and.to_string()).into(),
            ("OR", Some(Event::Done { or, .. })) => name(or.to_string()).into(),
            ("plane", Some(Event::Done { and, .. })) => {
                let side = and.lowest()?;
                Named::from(side_name(side)).linked(side_link(side))
            }
            _ => return None,
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let named = |(i, code): (usize, &SideCode)| {
            let code = Named::from(name(code.to_string())).labelled(corner_name(i));
            code.linked(corner_link(i))
        };
        codes(&at.step).iter().enumerate().map(named).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let focus = scenery.scene().focus();
            let fate = |object_idx| match at.step.event() {
                Some(Event::Done { class, .. }) if object_idx == focus => match class {
                    Inside => Fate::Kept,
                    Straddles => Fate::Cut,
                    Outside => Fate::Culled,
                },
                Some(Event::Corner { .. } | Event::Done { .. }) | None => Fate::ToCome,
            };
            views.push(scenery.observer(fate, marks(&at.step, scenery)));
            views.push(scenery.camera(fate, |_, _| FaceLook::Whole, Vec::new()));
        }
        views.push(View::new(CODES_VIEW, Body::Bits(bits(&at.step))));
        views
    }
}

/// Of the corners that have been asked.
fn codes<'a>(step: &Step<'a, CornerCodes>) -> &'a [SideCode] {
    &step.held.codes[..step.past.len().min(8)]
}

fn corner_name(corner_idx: usize) -> Value {
    name(format!("P{}", subscript(corner_idx + 1)))
}

fn corner_link(corner_idx: usize) -> Link {
    Link::nth("corner", corner_idx)
}

fn bits(step: &Step<'_, CornerCodes>) -> Bits {
    let codes = codes(step);
    let digits = |code: SideCode| SideCode::WRITTEN.map(|side| code.has(side)).to_vec();
    let row = |i: usize| BitRow {
        name: corner_name(i),
        bits: codes.get(i).map_or_else(Vec::new, |&code| digits(code)),
        role: match step.event() {
            Some(Event::Corner { corner_idx, .. }) if corner_idx == i => Role::Signal,
            Some(Event::Corner { .. } | Event::Done { .. }) | None => Role::Ink,
        },
        link: Some(corner_link(i)),
    };
    let decides = match step.event() {
        Some(Event::Done { and, or, .. }) if and.is_inside() => Some(("OR", or, None)),
        Some(Event::Done { and, .. }) => Some(("AND", and, and.lowest())),
        Some(Event::Corner { .. }) | None => None,
    };
    let shared = decides.and_then(|(.., side)| side);
    Bits {
        columns: SideCode::WRITTEN.map(side_name).to_vec(),
        links: Vec::new(),
        rows: (0..8).map(row).collect(),
        result: decides.map(|(symbol, code, _)| BitRow {
            name: name(symbol),
            bits: digits(code),
            role: Role::Signal,
            link: None,
        }),
        deciding: SideCode::WRITTEN
            .into_iter()
            .position(|side| shared == Some(side)),
        note: None,
    }
}

/// The box, its corners by their codes, and the plane that all of them lie beyond.
fn marks(step: &Step<'_, CornerCodes>, scenery: &Scenery) -> Vec<Mark3> {
    let bounds = &step.input.bounds;
    let edge = |ends| Mark3::new(Role::Ink, Shape3::Segment(ends)).fine();
    let mut marks: Vec<Mark3> = bounds.edges().map(edge).collect();
    for (i, (at, code)) in bounds.corners().into_iter().zip(codes(step)).enumerate() {
        let mark = if code.is_inside() {
            Mark3::new(Role::Accent, Shape3::Dot(at))
        } else {
            Mark3::new(Role::Signal, Shape3::Ring(at))
        };
        marks.push(mark.labelled(name(code.to_string())).linked(corner_link(i)));
    }
    if let Some(Event::Done { and, .. }) = step.event() {
        let side = and.lowest();
        marks.extend(
            side.into_iter()
                .flat_map(|side| plane_at_work(scenery.scene().culler(), side)),
        );
    }
    marks
}
