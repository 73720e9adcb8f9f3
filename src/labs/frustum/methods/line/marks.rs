//! A segment in space, what is left of it, and where it is cut.

use crate::labs::{
    frustum::prelude::*,
    interval::{ShownCrossing, ShownInterval},
};

/// A crossing farther beyond the ends than this is not drawn.
const BEYOND: f64 = 0.35;

/// P(u), to place a mark: the algorithm itself never computes points that it does not put out.
pub fn on_line<const N: usize>([p1, p2]: &[[f64; N]; 2], u: f64) -> [f64; N] {
    std::array::from_fn(|i| p1[i] + u * (p2[i] - p1[i]))
}

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
        let is_lost = moved || accepted == Some(false);
        let of_given = if is_lost {
            Role::Discarded
        } else {
            Role::Accent
        };
        let ring = Mark3::new(of_given, Shape3::Ring(from));
        marks.push(ring.labelled(end_name(end)).strong().linked(end_link(end)));
        if moved {
            let dot = Mark3::new(role, Shape3::Dot(to));
            let name = end_name_now(end, true);
            marks.push(dot.labelled(name).strong().linked(end_link(end)));
        }
    }
    marks
}

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
    let label = |symbol: String| equal_to(symbol, crossing.quotient);
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

pub fn shadow(ends: &[[f64; 3]; 2], level: f64) -> Vec<Mark3> {
    let foot = |[x, _, z]: [f64; 3]| [x, level, z];
    let mut marks: Vec<Mark3> = ends
        .iter()
        .map(|&at| Mark3::new(Role::Soft, Shape3::Segment([at, foot(at)])).fine())
        .collect();
    marks.push(Mark3::new(Role::Faint, Shape3::Segment(ends.map(foot))));
    marks
}

/// The ends of what is left, to be shown before they are put: on the side that set each, as they will be.
pub fn left_so_far(shown: &LineStep<'_, 4, ClipSpace>) -> [[f64; 4]; 2] {
    End::BOTH.map(|end| {
        let i = end.idx();
        let mut at = on_line(&shown.ends, shown.bounds[i]);
        if let Some(side) = shown.set_by[i] {
            at[side.axis()] = if side.is_high() { at[3] } else { 0.0 - at[3] };
        }
        shown.put[i].unwrap_or(at)
    })
}

pub fn is_rejected(shown: &LineStep<'_, 4, ClipSpace>) -> bool {
    shown.verdict == Some(None) || shown.bounds[0] > shown.bounds[1]
}

/// The ends' images.
pub const DIVIDED: [&str; 2] = ["P₁ / w", "P₂ / w"];

/// Both ends, and what they have become: of the coordinate across the side in hand, else of x.
pub fn points_table(shown: &LineStep<'_, 4, ClipSpace>) -> Table {
    let side = shown.in_hand().unwrap_or(VolumeSide::Right);
    let axis = ["x", "y", "z"][side.axis()];
    let sign = if side.is_high() { "−" } else { "+" };
    let ends = &shown.ends;
    let given = End::BOTH.map(|end| {
        let is_behind = ends[end.idx()][3] < 0.0;
        let role = if is_behind { Role::Signal } else { Role::Ink };
        let is_given = ends[end.idx()] == shown.input.ends[end.idx()];
        let name = if is_given {
            end_name(end)
        } else {
            Value::Name(DIVIDED[end.idx()].into())
        };
        row(name, end, ends, side, role)
    });
    let is_left = !is_rejected(shown);
    let left = left_so_far(shown);
    let moved = End::BOTH.into_iter().filter(|end| {
        let bound = shown.bounds[end.idx()];
        is_left && bound != [0.0, 1.0][end.idx()]
    });
    let moved = moved.map(|end| row(end_name_now(end, true), end, &left, side, Role::Accent));
    Table {
        header: vec![
            Formula::default(),
            sym(axis),
            sym("w"),
            sym(format!("w {sign} {axis}")),
            sym(format!("{axis} / w")),
        ],
        rows: given.into_iter().chain(moved).collect(),
        notes: Vec::new(),
    }
}

fn row(name: Value, end: End, ends: &[[f64; 4]; 2], side: VolumeSide, role: Role) -> TableRow {
    let at = ends[end.idx()];
    let (along, w) = (at[side.axis()], at[3]);
    let [distance, _] = side_distances::<f64>(side, &[at; 2]);
    let image = (w != 0.0).then_some(along / w);
    TableRow {
        name,
        cells: vec![
            Cell::new(Role::Ink, Some(along)),
            Cell::new(role, Some(w)),
            Cell::new(Role::Ink, Some(distance)),
            Cell::new(role, image).strong(),
        ],
        is_current: false,
        link: Some(end_link(end)),
    }
}
