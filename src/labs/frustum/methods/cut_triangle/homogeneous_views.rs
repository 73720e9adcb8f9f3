//! Codes, lists and pictures of a triangle before the divide.

use crate::figure::{BitRow, Bits, Multiples, SmallDrawing};

use super::{
    super::line::w_lens::{SCREENS_VIEW, seen, square},
    clip_space::{Event, Uv, Vertex, bound_symbol, in_world, point},
    list_view::{marker, row},
    prelude::*,
};

pub const BITS_VIEW: &str = "codes";

pub struct Picture<'a> {
    pub rings: RingStep<'a, Vertex>,
    pub parts: Parts<Vertex>,
    pub codes: Option<([SideCode; 3], SideCode, SideCode)>,
    pub side: Option<VolumeSide>,
    pub event: Option<Event>,
}

impl Picture<'_> {
    const fn role(&self) -> Role {
        match self.event {
            Some(Event::Done { .. }) => Role::Accepted,
            _ => Role::Accent,
        }
    }
}

pub fn bits(now: &Picture<'_>) -> Bits {
    let (parts, known) = (&now.parts, now.codes);
    let is_now = matches!(now.event, Some(Event::Codes { .. }));
    let role = if is_now { Role::Signal } else { Role::Ink };
    let digits = |code: SideCode| SideCode::WRITTEN.map(|side| code.has(side)).to_vec();
    let row = |i: usize| BitRow {
        name: name(vertex_symbol(i)),
        bits: known.map_or_else(Vec::new, |(codes, ..)| digits(codes[i])),
        role,
        link: parts.link(&parts.corners[i]),
    };
    let result = known.map(|(_, or, and)| {
        let combined = [("AND", and), ("OR", or)];
        let (symbol, code) = combined[usize::from(and.is_inside())];
        BitRow {
            name: name(symbol),
            bits: digits(code),
            role,
            link: None,
        }
    });
    let deciding = |(_, _, and): ([SideCode; 3], SideCode, SideCode)| {
        let mut written = SideCode::WRITTEN.into_iter();
        match now.side {
            Some(side) => written.position(|other| other == side),
            None => written.position(|side| and.has(side)),
        }
    };
    Bits {
        columns: SideCode::WRITTEN.map(side_name).to_vec(),
        links: Vec::new(),
        rows: (0..3).map(row).collect(),
        result,
        deciding: known.and_then(deciding),
        note: None,
    }
}

pub fn lists(now: &Picture<'_>) -> Lists {
    let has_passed = matches!(now.event, Some(Event::Pass { .. }));
    let side = now.side.filter(|_| !has_passed);
    let out = side.map(|_| list_out(now));
    Lists {
        lists: [list_in(now, side)].into_iter().chain(out).collect(),
        links: Vec::new(),
        legend: Vec::new(),
    }
}

fn list_in(now: &Picture<'_>, side: Option<VolumeSide>) -> ListColumn {
    let current = now.rings.asked.test.map(|test| test.idx);
    let bounds = bounds(now);
    let entry = |(i, v): (usize, &Vertex)| {
        let d = bounds.get(i).copied().flatten();
        let role = match d {
            _ if current.is_some_and(|idx| idx.contains(&i)) => Role::Signal,
            Some(d) if d < 0.0 => Role::Discarded,
            Some(_) | None => Role::Ink,
        };
        let bound = side.map(|_| d.map(|d| Value::Formula(Formula::decimals().num(d))));
        let place = Some(Value::Formula(point(v.at)));
        ListRow {
            details: [place].into_iter().chain(bound).collect(),
            ..row(
                vertex_symbol(i),
                role,
                d.map(|d| marker(d >= 0.0)),
                now.parts.link(v),
            )
        }
    };
    let symbols = [name("(x, y, z, w)")].into_iter();
    let columns = symbols.chain(side.map(|side| name(bound_symbol(side))));
    let entries = now.rings.list.iter().enumerate().map(entry);
    let title = Value::Term(if now.role() == Role::Accepted {
        "tri-list-left"
    } else {
        "tri-list-in"
    });
    ListColumn {
        columns: columns.collect(),
        is_ring: true,
        focus: current.map(|idx| idx[1]),
        ..ListColumn::new(title, entries.collect())
    }
}

fn list_out(now: &Picture<'_>) -> ListColumn {
    let (input, output) = (now.rings.list, now.rings.output);
    let is_output = matches!(now.event, Some(Event::Output { .. }));
    let entry = |(i, v): (usize, &Vertex)| {
        let from = input.iter().position(|other| other == v);
        let is_new = from.is_none() || is_output && i + 1 == output.len();
        let role = if is_new { Role::Signal } else { Role::Accent };
        let symbol = from.map_or_else(|| "I".to_owned(), vertex_symbol);
        row(symbol, role, Some(marker(true)), now.parts.link(v))
    };
    let entries = output.iter().enumerate().map(entry);
    ListColumn::new(Value::Term("tri-list-out"), entries.collect())
}

/// What the side at work has been asked of each vertex: the first, and those up to the last one tested.
fn bounds(now: &Picture<'_>) -> Vec<Option<f64>> {
    let Some((side, test)) = now.side.zip(now.rings.asked.test) else {
        return Vec::new();
    };
    let closes = test.idx[1] == 0;
    let n_known = if closes { usize::MAX } else { test.idx[1] + 1 };
    let bound = |(i, v): (usize, &Vertex)| {
        let [d, _] = side_distances::<f64>(side, &[v.at; 2]);
        (i < n_known).then_some(d)
    };
    now.rings.list.iter().enumerate().map(bound).collect()
}

pub fn observer_marks(now: &Picture<'_>, scenery: &Scenery) -> Vec<Mark3> {
    let corners = scenery.scene().places().triangle;
    let mut marks = given(&corners);
    if let Some(side) = now.side {
        marks.extend(plane_mark(scenery, side as usize));
    }
    let place = |v: &Vertex| in_world(v, scenery.scene());
    let list = now.rings.list;
    marks.extend(area(list.iter().map(&place).collect(), now.role()));
    let bounds = bounds(now);
    for (i, v) in list.iter().enumerate() {
        let at = place(v);
        let shape = match bounds.get(i).copied().flatten() {
            Some(d) if d < 0.0 => Shape3::Ring(at),
            Some(_) | None => Shape3::Dot(at),
        };
        let mark = Mark3::new(now.role(), shape).labelled(name(vertex_symbol(i)));
        marks.push(now.parts.linked(mark, v));
    }
    if let (Some(Crossing { at: v, .. }), Some(Event::Cross { .. } | Event::Output { .. })) =
        (now.rings.asked.crossing, now.event)
    {
        let mark = Mark3::new(Role::Signal, Shape3::Dot(place(&v))).labelled(name("I"));
        marks.push(now.parts.linked(mark.strong(), &v));
    }
    marks
}

/// The list as it stands.
pub fn camera_marks(now: &Picture<'_>, scenery: &Scenery) -> Vec<Mark3> {
    let list = now.rings.list.iter();
    area(
        list.map(|v| in_world(v, scenery.scene())).collect(),
        now.role(),
    )
}

/// What is divided first lands on the screen as another triangle, over the outline of what is seen; beside it what is clipped
/// first, and divided then.
pub fn screens(now: &Picture<'_>, given: &[Vertex; 3]) -> View {
    let on_screen = |v: &Vertex| [v.at[0] / v.at[3], v.at[1] / v.at[3]];
    let right = silent::<HomogeneousTriangle<Uv>>(given);
    let right: Vec<[f64; 2]> = right.vertices().iter().map(on_screen).collect();
    let corners = now.parts.corners.each_ref().map(on_screen);
    let mut wrong = square();
    let is_divided = now.event.is_some();
    if is_divided {
        let left = now.rings.list.iter().map(on_screen).collect();
        wrong.push(Mark::new(Role::Signal, Shape::Area(vec![left])));
        wrong.push(Mark::new(Role::Signal, Shape::Outline(corners.to_vec())).dashed());
        wrong.push(Mark::new(Role::Accent, Shape::Outline(right.clone())).dashed());
        wrong.extend(corners.into_iter().enumerate().map(|(i, at)| {
            let is_behind = given[i].at[3] < 0.0;
            let role = if is_behind { Role::Signal } else { Role::Ink };
            let label = sym(vertex_symbol(i)).sym(" / w");
            let label = if is_behind {
                label.sym(" ").point(at)
            } else {
                label
            };
            Mark::new(role, Shape::Ring(at)).labelled(Value::Formula(label))
        }));
    }
    let mut clipped = square();
    let dots = right
        .iter()
        .map(|&at| Mark::new(Role::Accent, Shape::Vertex(at)));
    clipped.extend(dots);
    clipped.push(Mark::new(Role::Accent, Shape::Area(vec![right.clone()])));
    let drawing = |title, (role, note), marks| {
        let note = Some((role, Value::Term(note)));
        SmallDrawing::new(Value::Term(title), note, marks)
    };
    let seen = seen(if is_divided { corners } else { [[0.0; 2]; 3] }.into_iter());
    View::new(
        SCREENS_VIEW,
        Body::Multiples(Multiples {
            drawings: vec![
                drawing("screen-divide-first", (Role::Signal, "screen-wrong"), wrong),
                drawing("screen-clip-first", (Role::Accent, "screen-right"), clipped),
            ],
            bounds: seen,
            tiles: Tiles::Large,
        }),
    )
}

fn area(outline: Vec<[f64; 3]>, role: Role) -> Vec<Mark3> {
    if outline.is_empty() {
        return Vec::new();
    }
    kept(outline, role)
}
