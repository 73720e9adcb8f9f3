//! A pair that is asked: the five questions in turn, each with what was compared and the answer; and the plane that one of them
//! is about.

use std::cmp::Ordering;

use crate::algo::surface::{
    Painter, PainterEvent as Event,
    PairTest::{self, BeforePlane, BehindPlane, DepthExtents, Overlap, ScreenExtents},
};

use super::super::{planes::plane_marks, prelude::*};

use super::variant::Variant;

const QUESTIONS: [(PairTest, &str, &str); 5] = [
    (
        DepthExtents,
        "painter-ask-depths",
        "~ {nearest}{sign}{farthest}",
    ),
    (ScreenExtents, "painter-ask-screen", ""),
    (BehindPlane, "painter-ask-behind", "{behind}"),
    (BeforePlane, "painter-ask-before", "{front}"),
    (Overlap, "painter-ask-overlap", "{hidden}"),
];

/// None where no pair is asked.
pub fn questions<L: Variant>(at: &At<'_, Painter<L>>) -> Option<Table> {
    let Some(Event::Pair { test, may, .. }) = at.step.event() else {
        return None;
    };
    let last = QUESTIONS.iter().position(|(it, ..)| *it == test)?;
    let row = |(i, (_, key, compared)): (usize, &(PairTest, &'static str, &str))| {
        let (role, answer) = match i.cmp(&last) {
            Ordering::Equal if may => (Role::Signal, "painter-yes"),
            Ordering::Equal => (Role::Signal, "painter-no"),
            Ordering::Less => (Role::Ink, "painter-no"),
            Ordering::Greater => (Role::Soft, "painter-not-asked"),
        };
        let compared = at.formula(compared).filter(|_| i <= last);
        let answer = Cell::new(role, Some(Value::Term(answer)));
        TableRow {
            name: at.message(key).into(),
            cells: vec![Cell::new(role, compared), answer.strong()],
            is_current: i == last,
            link: None,
        }
    };
    Some(Table {
        header: vec![
            at.formula("{triangle} → {other}")?,
            Formula::default(),
            Formula::default(),
        ],
        rows: QUESTIONS.iter().enumerate().map(row).collect(),
        notes: Vec::new(),
    })
}

/// The plane that the last question was about.
pub fn plane_asked<L: Variant>(at: &At<'_, Painter<L>>, scene: &Scene) -> Vec<Mark3> {
    let Some(Event::Pair {
        id, other, test, ..
    }) = at.step.event()
    else {
        return Vec::new();
    };
    let (id, role) = match test {
        BehindPlane => (other, Role::Signal),
        BeforePlane => (id, Role::Accent),
        DepthExtents | ScreenExtents | Overlap => return Vec::new(),
    };
    let triangle = &at.step.input.triangles()[id as usize];
    plane_marks(triangle, scene.camera.camera(), role).to_vec()
}
