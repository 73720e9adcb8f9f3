//! The list in, with every distance from the plane at work, and the list out.

use crate::{
    algo::volume::{IntersectionPolygonEvent as Event, SpaceVertex, TrianglePlanes},
    figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists, Role},
    labs::{rings::RingStep, words::name},
    text::{Formula, Value},
};

use super::{
    super::planes::place,
    parts::Parts,
    symbols::{cut_symbol, vertex_symbol},
};

/// Between which vertices of the list in an entry of the list out lies; twice the same one for a vertex that was kept.
type Origin = [usize; 2];

/// Both lists at a step; at the end the triangle and the polygon.
pub fn lists(
    own: &TrianglePlanes,
    parts: &Parts<SpaceVertex>,
    rings: &RingStep<'_, SpaceVertex>,
    (event, at_work): (Option<Event>, bool),
) -> Lists {
    let has_passed = matches!(event, Some(Event::Pass { .. }));
    let is_over = matches!(event, Some(Event::Fan { .. } | Event::Done { .. }));
    let (input, output): (&[SpaceVertex], &[SpaceVertex]) = match (has_passed, is_over) {
        (true, _) => (rings.passed, rings.list),
        (false, true) => (&own.triangle, rings.list),
        (false, false) => (rings.list, rings.output),
    };
    let is_textured = own.triangle[0].uv.is_some();
    let current = rings.current();
    let entry = |(i, v): (usize, &SpaceVertex)| {
        let side = rings.turn.sides.get(i).filter(|_| at_work);
        let mut entry = ListRow::new(name(vertex_symbol(i)));
        entry.role = match side {
            _ if current.contains(&i) && at_work => Role::Signal,
            Some((_, true)) => Role::Ink,
            Some((_, false)) => Role::Discarded,
            None if is_over => Role::Ink,
            None => Role::Soft,
        };
        entry.marker = side.map(|&(_, inside)| marker(inside));
        entry.details = vec![Some(place_of(v, is_textured))];
        if !is_over {
            entry
                .details
                .push(side.map(|&(d, _)| Value::Formula(Formula::decimals().num(d))));
        }
        entry.link = parts.link(v).filter(|_| at_work);
        entry
    };
    let mut columns = vec![name(if is_textured { "(u, v)" } else { "(x, y, z)" })];
    if !is_over {
        columns.push(name("d"));
    }
    let in_list = ListColumn {
        columns,
        is_ring: true,
        focus: current.last().copied().filter(|_| at_work),
        ..ListColumn::new(
            Value::Term(if is_over {
                "tri-list-given"
            } else {
                "tri-list-in"
            }),
            input.iter().enumerate().map(entry).collect(),
        )
    };
    let origins = origins(input, output, rings);
    let out_list = out_list(output, parts, &origins, (is_over, has_passed, is_textured));
    let links = links(&origins, rings, (event, at_work));
    let sides = [(true, "sh-inside"), (false, "sh-outside")];
    Lists {
        lists: vec![in_list, out_list],
        links,
        legend: sides
            .map(|(inside, key)| (marker(inside), Value::Term(key)))
            .to_vec(),
    }
}

const fn marker(inside: bool) -> ItemMarker {
    if inside {
        ItemMarker::Dot
    } else {
        ItemMarker::Ring
    }
}

fn place_of(vertex: &SpaceVertex, is_textured: bool) -> Value {
    match vertex.uv.filter(|_| is_textured) {
        Some(uv) => Value::Point(uv),
        None => place(vertex.at),
    }
}

/// Where the entries of the list out come from; the step's own crossings first.
fn origins(
    input: &[SpaceVertex],
    output: &[SpaceVertex],
    rings: &RingStep<'_, SpaceVertex>,
) -> Vec<Option<(Origin, Option<usize>)>> {
    let origin = |vertex: &SpaceVertex| {
        let crossings = rings.turn.crossings.iter().enumerate();
        let mut crossings = crossings.filter(|(_, (_, crossing))| crossing.at == *vertex);
        if let Some((i, (ends, _))) = crossings.next() {
            return Some((*ends, Some(i)));
        }
        let i = input.iter().position(|other| other == vertex)?;
        Some(([i; 2], None))
    };
    output.iter().map(origin).collect()
}

fn out_list(
    output: &[SpaceVertex],
    parts: &Parts<SpaceVertex>,
    origins: &[Option<(Origin, Option<usize>)>],
    (is_over, has_passed, is_textured): (bool, bool, bool),
) -> ListColumn {
    let entry = |(i, v): (usize, &SpaceVertex)| {
        let (symbol, role) = match origins[i] {
            _ if is_over => (vertex_symbol(i), Role::Accepted),
            Some((_, Some(cut))) => (cut_symbol(cut), Role::Signal),
            Some(([from, _], None)) => (vertex_symbol(from), Role::Accent),
            None => (vertex_symbol(i), Role::Accent),
        };
        let mut entry = ListRow::new(name(symbol));
        entry.role = role;
        entry.marker = Some(ItemMarker::Dot);
        if is_textured || is_over {
            entry.details = vec![Some(place_of(v, is_textured))];
        }
        entry.link = parts.link(v);
        entry
    };
    let columns = if is_textured {
        vec![name("(u, v)")]
    } else if is_over {
        vec![name("(x, y, z)")]
    } else {
        Vec::new()
    };
    ListColumn {
        columns,
        is_ring: is_over || has_passed,
        focus: output.len().checked_sub(1),
        ..ListColumn::new(
            Value::Term(if is_over {
                "tri-list-left"
            } else {
                "tri-list-out"
            }),
            output.iter().enumerate().map(entry).collect(),
        )
    }
}

/// From vertices to themselves, and to crossings from the outer end of their edge.
fn links(
    origins: &[Option<(Origin, Option<usize>)>],
    rings: &RingStep<'_, SpaceVertex>,
    (event, at_work): (Option<Event>, bool),
) -> Vec<ListLink> {
    if !at_work {
        return Vec::new();
    }
    let is_inside = |i: usize| rings.turn.sides.get(i).is_some_and(|&(_, inside)| inside);
    let is_now = matches!(event, Some(Event::Output { .. }));
    let last = origins.len().checked_sub(1);
    let link = |(i, origin): (usize, &Option<(Origin, Option<usize>)>)| {
        let (ends, _) = (*origin)?;
        // The closing edge's crossing stands last: it comes from the last vertex, so that links do not cross.
        let from = match ends {
            [s, p] if is_inside(s) && s < p => p,
            [s, _] => s,
        };
        Some(ListLink {
            from: [0, from],
            to: [1, i],
            role: if is_now && last == Some(i) {
                Role::Signal
            } else {
                Role::Soft
            },
        })
    };
    origins.iter().enumerate().filter_map(link).collect()
}
