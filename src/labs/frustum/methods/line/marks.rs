//! A segment in space, what is left of it, and where it is cut.

use crate::{
    algo::parameter::End,
    figure::{Mark3, Role, Shape3},
    labs::{
        interval::{ShownCrossing, ShownInterval},
        words::{end_link, end_name, end_name_now},
    },
    text::Formula,
};

/// A crossing farther beyond the ends than this is not drawn.
const BEYOND: f64 = 0.35;

/// P(u), to place a mark: the algorithm itself never computes points that it does not put out.
pub fn on_line<const N: usize>([p1, p2]: &[[f64; N]; 2], u: f64) -> [f64; N] {
    std::array::from_fn(|i| p1[i] + u * (p2[i] - p1[i]))
}

/// The segment as given, and what is left of it; the answer says whether that is accepted.
pub fn segment_marks(
    given: &[[f64; 3]; 2],
    left: &[[f64; 3]; 2],
    accepted: Option<bool>,
) -> Vec<Mark3> {
    let role = match accepted {
        None => Role::Accent,
        Some(true) => Role::Accepted,
        Some(false) => Role::Discarded,
    };
    let mut marks = Vec::new();
    for end in End::BOTH {
        let (from, to) = (given[end.idx()], left[end.idx()]);
        if from != to {
            let lost = Mark3::new(Role::Discarded, Shape3::Segment([from, to]));
            marks.push(lost.linked("segment"));
        }
    }
    marks.push(Mark3::new(role, Shape3::Segment(*left)).linked("segment"));
    for end in End::BOTH {
        let (from, to) = (given[end.idx()], left[end.idx()]);
        let moved = from != to;
        let role_of_given = if moved || accepted == Some(false) {
            Role::Discarded
        } else {
            Role::Accent
        };
        let ring = Mark3::new(role_of_given, Shape3::Ring(from));
        marks.push(ring.labelled(end_name(end)).strong().linked(end_link(end)));
        if moved {
            let dot = Mark3::new(role, Shape3::Dot(to));
            let name = end_name_now(end, true);
            marks.push(dot.labelled(name).strong().linked(end_link(end)));
        }
    }
    marks
}

/// The segment while its interval shrinks: what is left stands out, with the bounds and the crossing of this step.
pub fn interval_marks(
    ends: &[[f64; 3]; 2],
    shown: &ShownInterval,
    crossing_symbol: &'static str,
    visible: Option<[[f64; 3]; 2]>,
) -> Vec<Mark3> {
    if let Some(visible) = visible {
        return segment_marks(ends, &visible, Some(true));
    }
    let is_empty = shown.is_crossed_over();
    let accepted = (shown.is_rejected || is_empty).then_some(false);
    let mut marks = segment_marks(ends, ends, accepted);
    let between = shown.bounds.map(|u| on_line(ends, u));
    if is_empty {
        marks.push(Mark3::new(Role::Signal, Shape3::Segment(between)));
    } else if accepted.is_none() && shown.bounds != [0.0, 1.0] {
        let given = Mark3::new(Role::Discarded, Shape3::Segment(*ends));
        marks[0] = given.linked("segment");
        let left = Mark3::new(Role::Accent, Shape3::Segment(between));
        marks.insert(1, left.linked("segment"));
    }
    let is_near = |crossing: &&ShownCrossing| (-BEYOND..=1.0 + BEYOND).contains(&crossing.at);
    for crossing in shown.crossings.iter().filter(is_near) {
        marks.extend(crossing_marks(ends, shown, crossing_symbol, crossing));
    }
    marks
}

fn crossing_marks(
    ends: &[[f64; 3]; 2],
    shown: &ShownInterval,
    symbol: &'static str,
    crossing: &ShownCrossing,
) -> Vec<Mark3> {
    let at = on_line(ends, crossing.at);
    let label = |symbol: String| {
        let formula = Formula::default().sym(symbol).sym(" = ");
        formula.ratio(crossing.quotient.num, crossing.quotient.den)
    };
    let role = match (crossing.current, shown.is_crossed_over()) {
        (true, _) => Role::Signal,
        (false, true) => Role::Ink,
        (false, false) => Role::Accent,
    };
    let mark = if crossing.holds {
        let name = label(shown.bound_symbol(crossing.side));
        Mark3::new(role, Shape3::Dot(at)).labelled(name).strong()
    } else if crossing.current {
        let name = label(symbol.to_owned());
        Mark3::new(role, Shape3::Ring(at)).labelled(name).strong()
    } else {
        return Vec::new();
    };
    let mut marks = Vec::new();
    if !(0.0..=1.0).contains(&crossing.at) {
        // The line goes on to where it crosses.
        let from = ends[usize::from(crossing.at > 1.0)];
        marks.push(Mark3::new(Role::Faint, Shape3::Segment([from, at])));
    }
    marks.push(mark.linked(crossing.link));
    marks
}

/// Lines down to the ground, and the segment's shadow on it: where in space it is.
pub fn shadow(ends: &[[f64; 3]; 2], level: f64) -> Vec<Mark3> {
    let foot = |[x, _, z]: [f64; 3]| [x, level, z];
    let mut marks: Vec<Mark3> = ends
        .iter()
        .map(|&at| Mark3::new(Role::Soft, Shape3::Segment([at, foot(at)])).fine())
        .collect();
    marks.push(Mark3::new(Role::Faint, Shape3::Segment(ends.map(foot))));
    marks
}
