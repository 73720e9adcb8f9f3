//! The list in, with every distance from the plane at work, and the list out.

use crate::algo::volume::IntersectionPolygonEvent as Event;

use super::prelude::*;

/// Between which vertices of the list in an entry of the list out lies; twice the same one for a vertex that was kept.
type Origin = [usize; 2];

/// Both lists at a step; at the end the triangle and the polygon.
pub fn lists(
    own: &TrianglePlanes,
    parts: &Parts<SpaceVertex>,
    rings: &RingStep<'_, SpaceVertex>,
    (event, at_work, is_compared): (Option<Event>, bool, bool),
) -> Lists {
    let has_passed = matches!(event, Some(Event::Pass { .. }));
    let is_over = matches!(event, Some(Event::Fan { .. } | Event::Done { .. }));
    let (input, output): (&[SpaceVertex], &[SpaceVertex]) = match (has_passed, is_over) {
        (true, _) => (rings.passed, rings.list),
        (false, true) => (&own.triangle, rings.list),
        (false, false) => (rings.list, rings.output),
    };
    let is_textured = own.triangle[0].uv.is_some();
    let in_list = in_list(input, parts, rings, (is_over, at_work, is_textured));
    let origins = origins(input, output, rings);
    let mut out_list = out_list(output, parts, &origins, (is_over, has_passed, is_textured));
    if is_compared && has_passed {
        out_list.columns.push(name("d"));
        for (entry, origin) in out_list.entries.iter_mut().zip(&origins) {
            let kept = origin.filter(|(_, cut)| cut.is_none());
            let side = kept.and_then(|([from, _], _)| rings.turn.sides.get(from));
            let distance = side.map(|&(d, _)| Value::Formula(Formula::decimals().num(d)));
            entry.details.push(distance);
        }
    }
    let links = links(&origins, rings, (event, at_work));
    let sides = [(true, "sh-inside"), (false, "sh-outside")];
    let legend = sides.map(|(inside, key)| (marker(inside), Value::Term(key)));
    Lists {
        lists: vec![in_list, out_list],
        links,
        legend: legend.to_vec(),
    }
}

fn in_list(
    input: &[SpaceVertex],
    parts: &Parts<SpaceVertex>,
    rings: &RingStep<'_, SpaceVertex>,
    (is_over, at_work, is_textured): (bool, bool, bool),
) -> ListColumn {
    let current = rings.current();
    let n_columns = if is_over { 1 } else { 2 };
    let entry = |(i, v): (usize, &SpaceVertex)| {
        let side = rings.turn.sides.get(i).filter(|_| at_work);
        let role = match side {
            _ if current.contains(&i) && at_work => Role::Signal,
            Some((_, true)) => Role::Ink,
            Some((_, false)) => Role::Discarded,
            None if is_over => Role::Ink,
            None => Role::Soft,
        };
        let marker = side.map(|&(_, inside)| marker(inside));
        let distance = side.map(|&(d, _)| Value::Formula(Formula::decimals().num(d)));
        let details = [Some(place_of(v, is_textured)), distance];
        let details = details.into_iter().take(n_columns).collect();
        let link = parts.link(v).filter(|_| at_work);
        ListRow {
            details,
            ..row(vertex_symbol(i), role, marker, link)
        }
    };
    let symbols = [if is_textured { "(u, v)" } else { "(x, y, z)" }, "d"];
    let title = Value::Term(if is_over {
        "tri-list-given"
    } else {
        "tri-list-in"
    });
    ListColumn {
        columns: symbols.into_iter().take(n_columns).map(name).collect(),
        is_ring: true,
        focus: current.last().copied().filter(|_| at_work),
        ..ListColumn::new(title, input.iter().enumerate().map(entry).collect())
    }
}

/// At the end: the polygon's vertices, and the triangles that its fan has come to.
pub fn fan_lists(
    parts: &Parts<SpaceVertex>,
    ring: &[SpaceVertex],
    fan: &[[SpaceVertex; 3]],
) -> Lists {
    let left = out_list(ring, parts, &vec![None; ring.len()], (true, false, false));
    let corner = |v: &SpaceVertex| ring.iter().position(|other| other == v);
    let entry = |(i, triangle): (usize, &[SpaceVertex; 3])| {
        let corners = triangle.iter().filter_map(corner).map(vertex_symbol);
        ListRow {
            details: vec![Some(name(corners.collect::<Vec<_>>().join(" ")))],
            role: Role::Accent,
            link: Some(triangle_link(i)),
            ..ListRow::new(name(triangle_symbol(i)))
        }
    };
    let title = Message::new("tri-list-fan")
        .with("vertices", ring.len())
        .with("triangles", ring.len().saturating_sub(2));
    let fan = ListColumn::new(title.into(), fan.iter().enumerate().map(entry).collect());
    Lists {
        lists: vec![left, fan],
        links: Vec::new(),
        legend: Vec::new(),
    }
}

/// An entry without details.
pub fn row(symbol: String, role: Role, marker: Option<ItemMarker>, link: Option<Link>) -> ListRow {
    ListRow {
        marker,
        role,
        link,
        ..ListRow::new(name(symbol))
    }
}

pub const fn marker(inside: bool) -> ItemMarker {
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
        let place = (is_textured || is_over).then(|| Some(place_of(v, is_textured)));
        ListRow {
            details: place.into_iter().collect(),
            ..row(symbol, role, Some(ItemMarker::Dot), parts.link(v))
        }
    };
    let places = is_over.then_some("(x, y, z)");
    let column = if is_textured { Some("(u, v)") } else { places };
    let title = Value::Term(if is_over {
        "tri-list-left"
    } else {
        "tri-list-out"
    });
    ListColumn {
        columns: column.into_iter().map(name).collect(),
        is_ring: is_over || has_passed,
        focus: output.len().checked_sub(1),
        ..ListColumn::new(title, output.iter().enumerate().map(entry).collect())
    }
}

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
        let is_new = is_now && last == Some(i);
        Some(ListLink {
            from: [0, from],
            to: [1, i],
            role: if is_new { Role::Signal } else { Role::Soft },
        })
    };
    origins.iter().enumerate().filter_map(link).collect()
}
