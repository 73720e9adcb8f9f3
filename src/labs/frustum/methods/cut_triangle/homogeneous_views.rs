//! Codes, lists and pictures of a triangle before the divide.

use crate::{
    algo::volume::{ClipPolygon, SideCode, side_distances},
    figure::{BitRow, Bits, ItemMarker, ListColumn, ListRow, Lists, Mark3, Role, Shape3},
    geom::VolumeSide,
    labs::words::name,
    text::{Formula, Value},
};

use super::{
    super::super::stage::{Scenery, side_name},
    clip_space::{Event, State, Uv, Vertex, bound_symbol, in_world, on_screen, point},
    marks::{given, plane_mark, vertex_symbol},
    parts::Parts,
    variant::{Homogeneous, Variant},
};

/// The view of the outcodes.
pub const BITS_VIEW: &str = "codes";

/// The corners' codes over each other, and what they come to: AND where it rejects, else OR.
pub fn bits(state: &State, parts: &Parts<Vertex>, event: Option<Event>) -> Bits {
    let is_now = matches!(event, Some(Event::Codes { .. }));
    let role = if is_now { Role::Signal } else { Role::Ink };
    let digits = |code: SideCode| SideCode::WRITTEN.map(|side| code.has(side)).to_vec();
    let row = |i: usize| BitRow {
        name: name(vertex_symbol(i)),
        bits: state
            .codes
            .map_or_else(Vec::new, |(codes, ..)| digits(codes[i])),
        role,
        link: parts.link(&parts.corners[i]),
    };
    let result = state.codes.map(|(_, or, and)| {
        let (symbol, code) = if and.is_inside() {
            ("OR", or)
        } else {
            ("AND", and)
        };
        BitRow {
            name: name(symbol),
            bits: digits(code),
            role,
            link: None,
        }
    });
    let deciding = |(_, _, and): ([SideCode; 3], SideCode, SideCode)| {
        let written = SideCode::WRITTEN;
        match state.side {
            Some(side) => written.iter().position(|&other| other == side),
            None => written.iter().position(|&side| and.has(side)),
        }
    };
    Bits {
        columns: SideCode::WRITTEN.map(side_name).to_vec(),
        rows: (0..3).map(row).collect(),
        result,
        deciding: state.codes.and_then(deciding),
        note: None,
    }
}

/// The list in with the bound that is asked, and the list out.
pub fn lists(state: &State, parts: &Parts<Vertex>, event: Option<Event>) -> Lists {
    let has_passed = matches!(event, Some(Event::Pass { .. }));
    let side = state.side.filter(|_| !has_passed);
    let out = side.map(|_| list_out(state, parts, event));
    Lists {
        lists: [list_in(state, parts, side)]
            .into_iter()
            .chain(out)
            .collect(),
        links: Vec::new(),
        legend: Vec::new(),
    }
}

/// With the bound of the side at work.
fn list_in(state: &State, parts: &Parts<Vertex>, side: Option<VolumeSide>) -> ListColumn {
    let current = state.test.map(|(idx, ..)| idx);
    let bounds = bounds(state);
    let entry = |(i, v): (usize, &Vertex)| {
        let d = bounds.get(i).copied().flatten();
        let mut entry = ListRow::new(name(vertex_symbol(i)));
        entry.role = match d {
            _ if current.is_some_and(|idx| idx.contains(&i)) => Role::Signal,
            Some(d) if d < 0.0 => Role::Discarded,
            Some(_) | None => Role::Ink,
        };
        entry.marker = d.map(|d| {
            if d < 0.0 {
                ItemMarker::Ring
            } else {
                ItemMarker::Dot
            }
        });
        entry.details = vec![Some(Value::Formula(point(v.at)))];
        entry
            .details
            .extend(side.map(|_| d.map(|d| Value::Formula(Formula::decimals().num(d)))));
        entry.link = parts.link(v);
        entry
    };
    let symbols = [name("(x, y, z, w)")].into_iter();
    let columns = symbols.chain(side.map(|side| name(bound_symbol(side))));
    let entries = state.input.vertices().iter().enumerate().map(entry);
    let title = if state.is_done {
        "tri-list-left"
    } else {
        "tri-list-in"
    };
    ListColumn {
        columns: columns.collect(),
        is_ring: true,
        focus: current.map(|idx| idx[1]),
        ..ListColumn::new(Value::Term(title), entries.collect())
    }
}

fn list_out(state: &State, parts: &Parts<Vertex>, event: Option<Event>) -> ListColumn {
    let (input, output) = (state.input.vertices(), state.output.vertices());
    let is_output = matches!(event, Some(Event::Output { .. }));
    let entry = |(i, v): (usize, &Vertex)| {
        let from = input.iter().position(|other| other == v);
        let is_new = is_output && i + 1 == output.len();
        let mut entry = ListRow::new(name(from.map_or_else(|| "I".to_owned(), vertex_symbol)));
        entry.role = if is_new || from.is_none() {
            Role::Signal
        } else {
            Role::Accent
        };
        entry.marker = Some(ItemMarker::Dot);
        entry.link = parts.link(v);
        entry
    };
    let entries = output.iter().enumerate().map(entry);
    ListColumn::new(Value::Term("tri-list-out"), entries.collect())
}

/// What the side at work has been asked of each vertex: the first, and those up to the last one tested.
fn bounds(state: &State) -> Vec<Option<f64>> {
    let Some((side, (idx, ..))) = state.side.zip(state.test) else {
        return Vec::new();
    };
    let n_known = if idx[1] == 0 { usize::MAX } else { idx[1] + 1 };
    let bound = |(i, v): (usize, &Vertex)| {
        let [d, _] = side_distances::<f64>(side, &[v.at; 2]);
        (i < n_known).then_some(d)
    };
    state
        .input
        .vertices()
        .iter()
        .enumerate()
        .map(bound)
        .collect()
}

fn ring(polygon: &ClipPolygon<Uv>, place: impl Fn(&Vertex) -> [f64; 3]) -> Vec<[f64; 3]> {
    polygon.vertices().iter().map(place).collect()
}

/// Where a vertex is drawn: in the world, or once it has been divided before it is clipped, where it lands on the screen.
fn place_of<L: Variant<Homogeneous>>(
    event: Option<Event>,
    scenery: &Scenery,
) -> impl Fn(&Vertex) -> [f64; 3] {
    let is_divided = L::DIVIDES_FIRST && event.is_some();
    move |v| {
        if is_divided {
            on_screen(scenery.scene().culler(), v.at)
        } else {
            in_world(v, scenery.scene())
        }
    }
}

/// The triangle, what is left of it, and the side at work.
pub fn observer_marks<L: Variant<Homogeneous>>(
    state: &State,
    parts: &Parts<Vertex>,
    event: Option<Event>,
    scenery: &Scenery,
) -> Vec<Mark3> {
    let corners = scenery.scene().places.triangle();
    let mut marks = given(&corners);
    if let Some(side) = state.side {
        marks.extend(plane_mark(scenery, side as usize));
    }
    let place = place_of::<L>(event, scenery);
    let list = ring(&state.input, &place);
    let role = if state.is_done {
        Role::Accepted
    } else {
        Role::Accent
    };
    if !list.is_empty() {
        marks.push(Mark3::new(role, Shape3::Wash(list.clone())));
        marks.push(Mark3::new(role, Shape3::Outline(list)));
    }
    let bounds = bounds(state);
    for (i, v) in state.input.vertices().iter().enumerate() {
        let at = place(v);
        let shape = match bounds.get(i).copied().flatten() {
            Some(d) if d < 0.0 => Shape3::Ring(at),
            Some(_) | None => Shape3::Dot(at),
        };
        let mark = Mark3::new(role, shape).labelled(name(vertex_symbol(i)));
        marks.push(parts.linked(mark, v));
    }
    if let (Some((crossing, _)), Some(Event::Cross { .. } | Event::Output { .. })) =
        (state.crossing, event)
    {
        let at = place(&crossing);
        let mark = Mark3::new(Role::Signal, Shape3::Dot(at)).labelled(name("I"));
        marks.push(parts.linked(mark.strong(), &crossing));
    }
    marks
}

/// What the camera sees: the list as it stands. What has been divided first is drawn where it lands on the screen, beside the right
/// outline.
pub fn camera_marks<L: Variant<Homogeneous>>(
    state: &State,
    event: Option<Event>,
    scenery: &Scenery,
) -> Vec<Mark3> {
    let list = ring(&state.input, place_of::<L>(event, scenery));
    if !L::DIVIDES_FIRST {
        let role = if state.is_done {
            Role::Accepted
        } else {
            Role::Accent
        };
        return area(list, role);
    }
    let corners = scenery.scene().places.triangle();
    let right = Mark3::new(Role::Accent, Shape3::Outline(corners.to_vec()));
    let mut marks = area(list, Role::Signal);
    marks.push(right);
    marks
}

fn area(outline: Vec<[f64; 3]>, role: Role) -> Vec<Mark3> {
    if outline.is_empty() {
        return Vec::new();
    }
    vec![
        Mark3::new(role, Shape3::Wash(outline.clone())),
        Mark3::new(role, Shape3::Outline(outline)),
    ]
}
