//! The two lists beside each other, the same intersections linked: of long ones what lies about the step.

use std::ops::Range;

use crate::{
    algo::{
        line::Ratio,
        polygon::weiler_atherton::{
            Entry, IntersectionLabel, List, WeilerAtherton, WeilerAthertonEvent as Event,
        },
    },
    figure::{self, ItemMarker, ListLink, Lists, Role},
    labs::words::name,
    text::Value,
    trace::Step,
};

use super::{
    named::label as label_value,
    names,
    standing::{self, BOTH, Standing},
};

/// The view's name.
pub const VIEW: &str = "lists";

pub fn lists(step: &Step<'_, WeilerAtherton>) -> Lists {
    let focus = BOTH.map(|list| focus(step, list));
    let ranges =
        BOTH.map(|list| figure::ListColumn::reach(standing::len(step, list), focus[list.idx()]));
    let standing = Standing::of(step, ranges.clone());
    Lists {
        legend: legend(step),
        links: links(step, &ranges),
        lists: BOTH
            .into_iter()
            .zip(ranges)
            .zip(focus)
            .map(|((list, range), focus)| shown(step, &standing, list, range, focus))
            .collect(),
    }
}

const fn marker(label: IntersectionLabel) -> ItemMarker {
    match label {
        IntersectionLabel::Entering => ItemMarker::Dot,
        IntersectionLabel::Leaving => ItemMarker::Ring,
        IntersectionLabel::Pinching => ItemMarker::CrossedRing,
        IntersectionLabel::Touching => ItemMarker::Cross,
    }
}

/// Entering and leaving always, the others where there are any.
fn legend(step: &Step<'_, WeilerAtherton>) -> Vec<(ItemMarker, Value)> {
    let has = |label: IntersectionLabel| step.held.labels.iter().any(|known| known.label == label);
    let said = |label: IntersectionLabel| (marker(label), label_value(label));
    let rare = [IntersectionLabel::Touching, IntersectionLabel::Pinching]
        .into_iter()
        .filter(|&label| has(label));
    let always = [IntersectionLabel::Entering, IntersectionLabel::Leaving];
    always.into_iter().chain(rare).map(said).collect()
}

fn shown(
    step: &Step<'_, WeilerAtherton>,
    standing: &Standing,
    list: List,
    range: Range<usize>,
    focus: Option<usize>,
) -> figure::ListColumn {
    let title = Value::Term(match list {
        List::Subject => "wa-list-subject",
        List::Clip => "wa-list-clip",
    });
    let rings = names::border(step.input, list);
    let begins_a_hole = |&place: &usize| {
        let vertex = vertex_at(step, list, place)?;
        let ring_idx = rings.ring_of(vertex);
        (ring_idx > 0 && rings.bounds(ring_idx)[0] == vertex).then_some(place - range.start)
    };
    figure::ListColumn {
        columns: vec![column(step, list)],
        n_before: range.start,
        n_after: standing::len(step, list) - range.end,
        is_ring: true,
        breaks: range
            .clone()
            .filter_map(|place| begins_a_hole(&place))
            .collect(),
        focus: focus.and_then(|place| place.checked_sub(range.start)),
        ..figure::ListColumn::new(
            title,
            range
                .clone()
                .map(|place| entry(step, standing, list, place))
                .collect(),
        )
    }
}

fn entry(
    step: &Step<'_, WeilerAtherton>,
    standing: &Standing,
    list: List,
    place: usize,
) -> figure::ListRow {
    let (held, input) = (step.held, step.input);
    let role = standing.role(list, place).unwrap_or(Role::Soft);
    let own = vertex_at(step, list, place);
    let Some(known) = held.lists.entries[list.idx()].get(place) else {
        let own = own.map_or_else(String::new, |own| names::vertex(input, list, own));
        return figure::ListRow {
            role,
            ..figure::ListRow::new(name(own))
        };
    };
    let link = match (known.node(), own) {
        (Some(node), _) => Some(names::node_link(node)),
        (None, own) => own.map(|own| names::vertex_link(list, own)),
    };
    figure::ListRow {
        details: vec![detail(step, list, known)],
        marker: known.node().map(|node| {
            let label = standing::label(held, node);
            label.map_or(ItemMarker::Cross, marker)
        }),
        role,
        link,
        ..figure::ListRow::new(name(names::entry(input, list, known)))
    }
}

/// What heads the intersections' details: as long as none is labelled, t or u, which decide the order along an edge.
fn column(step: &Step<'_, WeilerAtherton>, list: List) -> Value {
    let is_labelled = !step.held.labels.is_empty();
    match list {
        List::Subject | List::Clip if is_labelled => name(""),
        List::Subject => name("t"),
        List::Clip => name("u"),
    }
}

/// Of an intersection whether the subject comes in or goes out, where it does; as long as none is labelled, where on
/// its edge it lies.
fn detail(step: &Step<'_, WeilerAtherton>, list: List, entry: &Entry) -> Option<Value> {
    let node_idx = entry.node()?;
    match standing::label(step.held, node_idx) {
        Some(label @ (IntersectionLabel::Entering | IntersectionLabel::Leaving)) => {
            return Some(Value::Term(names::label_key(label)));
        }
        // The marker says so, and the name is long: it is also a vertex's.
        Some(IntersectionLabel::Touching | IntersectionLabel::Pinching) => return None,
        None => {}
    }
    let is_on_edge = entry.vertex().is_none() && step.held.labels.is_empty();
    let node = step.held.lists.nodes.get(node_idx as usize);
    let Ratio { num, den } = node.filter(|_| is_on_edge).map(|node| match list {
        List::Subject => node.meeting.t,
        List::Clip => node.meeting.u,
    })?;
    Some(Value::Ratio { num, den })
}

/// The polygon's own vertex at a place, also where it is still to come.
fn vertex_at(step: &Step<'_, WeilerAtherton>, list: List, place: usize) -> Option<usize> {
    let entries = &step.held.lists.entries[list.idx()];
    match entries.get(place) {
        Some(entry) => entry.vertex().map(|vertex| vertex as usize),
        None => Some(standing::n_vertices(step.held, list) + place - entries.len()),
    }
}

/// Between the same intersections, in the direction in which the lists are changed.
fn links(step: &Step<'_, WeilerAtherton>, ranges: &[Range<usize>; 2]) -> Vec<ListLink> {
    let taken = standing::taken(step);
    let [subject, clip] = ranges;
    let link = |place: usize| {
        let node = step.held.lists.entries[List::Clip.idx()]
            .get(place)?
            .node()?;
        let twin = standing::place_of(step.held, List::Subject, node)?;
        let twin = subject.contains(&twin).then(|| twin - subject.start)?;
        let ends = [
            [List::Subject.idx(), twin],
            [List::Clip.idx(), place - clip.start],
        ];
        let (is_taken, [from, to]) = match taken {
            Some((taken, List::Clip)) if taken == node => (true, [ends[1], ends[0]]),
            Some((taken, List::Subject)) if taken == node => (true, ends),
            Some((_, List::Subject | List::Clip)) | None => (false, ends),
        };
        let role = if is_taken { Role::Signal } else { Role::Soft };
        Some(ListLink { from, to, role })
    };
    clip.clone().filter_map(link).collect()
}

/// The place of a list that must be seen.
fn focus(step: &Step<'_, WeilerAtherton>, list: List) -> Option<usize> {
    let here = |list: List| {
        let mut current = standing::current(step).into_iter();
        let current = current.find(|&(at, _)| at == list).map(|(_, place)| place);
        let whole = if let Some(Event::Whole {
            list: whole,
            places: [start, _],
            ..
        }) = step.event()
        {
            (whole == list).then_some(start as usize)
        } else {
            None
        };
        let walk = step.held.walk.position.filter(|&(at, _)| at == list);
        current.or(whole).or(walk.map(|(_, place)| place as usize))
    };
    here(list).or_else(|| beside(step, list, here(list.other())?))
}

/// The place of the intersection that comes next after a place of the other list, or came last.
fn beside(step: &Step<'_, WeilerAtherton>, list: List, other: usize) -> Option<usize> {
    let entries = &step.held.lists.entries[list.other().idx()];
    let reach = figure::ListColumn::reach(entries.len(), Some(other));
    let node = |place: usize| entries.get(place)?.node();
    let ahead = (other..reach.end).find_map(node);
    let node = ahead.or_else(|| (reach.start..other).rev().find_map(node))?;
    standing::place_of(step.held, list, node)
}
