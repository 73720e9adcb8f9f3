//! Cohen–Sutherland in space, shown.

use crate::{
    algo::volume::{
        CohenSutherland3d, CohenSutherland3dEvent as Event, CohenSutherland3dInput as Input,
    },
    labs::{
        crossing_formulas::upright_in_space,
        frustum::prelude::*,
        segments::{
            CodeStep,
            code_step::{CodeKeys, CodeLook, LINES},
        },
    },
};

use super::{
    super::{
        part::{Fate, Outcome, segment_verdict},
        stage::{axis_equation, cube_view, face_at_work},
    },
    line::{
        SpaceLine,
        marks::{segment_marks, shadow},
    },
};

type Shown<'a> = CodeStep<'a, 3, Input>;

const AXES: [[VolumeSide; 2]; 3] = [
    [VolumeSide::Left, VolumeSide::Right],
    [VolumeSide::Bottom, VolumeSide::Top],
    [VolumeSide::Near, VolumeSide::Far],
];

impl SpaceTelling for CohenSutherland3d {
    const SUBJECT: Subject = Subject::BoxedSegment;

    fn input(scene: &Scene) -> Input {
        AlignedBox::input(scene)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let input = Self::input(scene);
        segment_verdict(scene, (Self::SUBJECT, about), |end| fate(&input, end), run)
    }
}

/// The step that decided what became of an end, or of the whole segment: codes decide, and the first cut.
fn fate(input: &Input, asked: Option<End>) -> Option<Fate> {
    let recording = Recording::<CohenSutherland3d>::new(*input);
    let mut fate = None;
    for (i, event) in recording.events().iter().enumerate() {
        let outcome = match *event {
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
            | Event::Cut { .. }
            | Event::Choose { .. }
            | Event::Accept { .. }
            | Event::Reject { .. } => None,
        };
        let step = i + 1;
        fate = outcome.map(|outcome| Fate { step, outcome }).or(fate);
    }
    fate
}

impl LineVariant<3, Input> for Right {
    const ID: &'static str = "cohen-sutherland-3d";
    const NAME_KEY: &'static str = "alg-cohen-sutherland-3d";
    const CODE: &'static [CodeLine] = &LINES;
}

impl CodeLook<3> for Input {
    type Scenery = Scenery;

    const SOURCE: &'static str = "Newman & Sproull, 1973";
    const KEYS: CodeKeys = CodeKeys {
        opening: "space-line-opening-box",
        codes: [
            "space-line-code-inside",
            "space-line-code-one",
            "space-line-code-two",
            "space-line-code-three",
        ],
        or: ["space-line-or-accept", "space-line-or-open"],
        and: ["space-line-and-open", "space-line-and-reject"],
        choose: "space-line-choose",
        reject: "space-line-reject-codes",
        one_point: ["space-line-touch", "space-line-point"],
    };

    fn written(&self) -> Vec<VolumeSide> {
        SideCode::WRITTEN.to_vec()
    }

    fn side(side: VolumeSide) -> Named {
        side_named(side)
    }

    fn column(side: VolumeSide) -> Value {
        side_name(side)
    }

    fn shared(&self, and: SideCode) -> Option<VolumeSide> {
        and.lowest()
    }

    /// The faces that the point lies beyond, from the lowest bit.
    fn named(&self, code: SideCode, name: &str) -> Option<Value> {
        let nth = ["first", "second", "third"]
            .iter()
            .position(|it| *it == name)?;
        let beyond: Vec<VolumeSide> = code.sides().collect();
        beyond.iter().rev().nth(nth).map(|&side| side_name(side))
    }

    /// `x = −2 < −1` beyond a face, `−1 ≤ y = 0 ≤ 1` between both.
    fn position(&self, axis: usize, at: [f64; 3], code: SideCode) -> Formula {
        let [low, high] = AXES[axis];
        let [least, most] = AXES[axis].map(|side| self.bounds.border(side));
        let symbol = ["x = ", "y = ", "z = "][axis];
        let coordinate = |formula: Formula| formula.sym(symbol).num(at[axis]);
        if code.has(low) {
            coordinate(Formula::default()).sym(" < ").num(least)
        } else if code.has(high) {
            coordinate(Formula::default()).sym(" > ").num(most)
        } else {
            let from = Formula::default().num(least).sym(" ≤ ");
            coordinate(from).sym(" ≤ ").num(most)
        }
    }

    fn border(&self, side: VolumeSide) -> Formula {
        axis_equation(side, self.bounds.border(side))
    }

    fn crossing_formulas(&self, side: VolumeSide, at: [f64; 3]) -> Vec<Formula> {
        upright_in_space(&self.ends, side.axis(), self.bounds.border(side), at)
    }

    fn note(&self, _: SideCode, _: bool) -> Option<Value> {
        None
    }

    fn rule(&self, _: Option<SideCode>) -> Message {
        Message::new("space-line-note-code")
    }

    fn drawing(shown: &Shown<'_>, scenery: Option<&Scenery>) -> Option<View> {
        Some(cube_view(scenery?.scene(), marks(shown)))
    }
}

fn marks(shown: &Shown<'_>) -> Vec<Mark3> {
    let given = &shown.input.ends;
    let side = shown.deciding();
    let mut marks: Vec<Mark3> = side.into_iter().flat_map(face_at_work).collect();
    marks.extend(shadow(given, -1.0));
    marks.extend(numbered_cuts(shown));
    let accepted = shown.verdict.map(|visible| visible.is_some());
    marks.extend(segment_marks(given, &shown.ends, accepted));
    match shown.event {
        Some(Event::Code { end, at, code }) => {
            let ring = Mark3::new(Role::Signal, Shape3::Ring(at));
            let code = ring.labelled(name(code.to_string())).strong();
            marks.push(code.linked(end_link(end)));
        }
        Some(Event::Cut { end, u, to, .. }) => {
            let label = sym("t = ").ratio(u.num, u.den);
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

fn numbered_cuts(shown: &Shown<'_>) -> Vec<Mark3> {
    let passed = |(nth, &at): (usize, &[f64; 3])| {
        let label = name(format!("I{}", subscript(nth + 1)));
        let is_end = shown.ends.contains(&at);
        (!is_end).then(|| Mark3::new(Role::Discarded, Shape3::Ring(at)).labelled(label))
    };
    shown.cuts.iter().enumerate().filter_map(passed).collect()
}
