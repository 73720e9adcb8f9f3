//! The two lists beside each other, the same intersections linked: of long ones what lies about the step.

use crate::labs::interval::value_of;

use super::{
    named::label as label_value,
    names,
    prelude::*,
    standing::{self, BOTH, Standing, vertex_at},
};

pub const VIEW: &str = "lists";

pub fn lists(step: &Step<'_, WeilerAtherton>) -> Lists {
    let focus = BOTH.map(|list| focus(step, list));
    let reach = |list: List| ListColumn::reach(standing::len(step, list), focus[list.idx()]);
    let standing = Standing::of(step, BOTH.map(reach));
    let lists = BOTH.map(|list| shown(step, &standing, list, focus[list.idx()]));
    Lists {
        legend: legend(step),
        links: links(step, &lists),
        lists: lists.into(),
    }
}

fn legend(step: &Step<'_, WeilerAtherton>) -> Vec<(ItemMarker, Value)> {
    let labels = &step.held.labels;
    let has = |label: IntersectionLabel| labels.iter().any(|known| known.label == label);
    let rare = [Touching, Pinching].into_iter().filter(|&label| has(label));
    let said = |label| (standing::marker(Some(label)), label_value(label));
    let labelled = [Entering, Leaving].into_iter().chain(rare).map(said);
    // One that touches has the same mark.
    let unlabelled = (standing::marker(None), Value::Term("wa-intersection"));
    let unlabelled = (!has(Touching)).then_some(unlabelled);
    labelled.chain(unlabelled).collect()
}

fn shown(
    step: &Step<'_, WeilerAtherton>,
    standing: &Standing,
    list: List,
    focus: Option<usize>,
) -> ListColumn {
    let title = Value::Term(match list {
        List::Subject => "wa-list-subject",
        List::Clip => "wa-list-clip",
    });
    let entry = |place| entry(step, standing, list, place);
    let shown = ListColumn::about(title, standing::len(step, list), focus, entry);
    let rings = names::border(step.input, list);
    let begins_a_hole = |&nth: &usize| {
        vertex_at(step, list, shown.n_before + nth).is_some_and(|vertex| {
            let ring_idx = rings.ring_of(vertex);
            ring_idx > 0 && rings.bounds(ring_idx)[0] == vertex
        })
    };
    ListColumn {
        columns: vec![column(step, list)],
        is_ring: true,
        breaks: (0..shown.entries.len()).filter(begins_a_hole).collect(),
        ..shown
    }
}

fn entry(
    step: &Step<'_, WeilerAtherton>,
    standing: &Standing,
    list: List,
    place: usize,
) -> ListRow {
    let (held, input) = (step.held, step.input);
    let role = standing.role(list, place).unwrap_or(Role::Soft);
    let own = vertex_at(step, list, place);
    let Some(known) = held.lists.entries[list.idx()].get(place) else {
        let own = own.map_or_else(String::new, |own| names::vertex(input, list, own));
        return ListRow {
            role,
            ..ListRow::new(name(own))
        };
    };
    let node = known.node();
    let own_link = || own.map(|own| names::vertex_link(list, own));
    ListRow {
        details: vec![detail(step, list, known)],
        marker: node.map(|node| standing::marker(standing::label(held, node))),
        role,
        link: node.map(names::node_link).or_else(own_link),
        ..ListRow::new(name(names::entry(input, list, known)))
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
        Some(label @ (Entering | Leaving)) => return Some(Value::Term(names::label_key(label))),
        // The marker says so, and the name is long: it is also a vertex's.
        Some(Touching | Pinching) => return None,
        None => {}
    }
    let is_on_edge = entry.vertex().is_none() && step.held.labels.is_empty();
    let node = step.held.lists.nodes.get(node_idx as usize);
    let meeting = node.filter(|_| is_on_edge)?.meeting;
    Some(value_of([meeting.t, meeting.u][list.idx()]))
}

/// Between the same intersections, in the direction in which the lists are changed.
fn links(step: &Step<'_, WeilerAtherton>, [subject, clip]: &[ListColumn; 2]) -> Vec<ListLink> {
    let taken = standing::taken(step);
    let link = |nth: usize| {
        let entry = step.held.lists.entries[List::Clip.idx()].get(clip.n_before + nth)?;
        let node = entry.node()?;
        let twin = standing::place_of(step.held, List::Subject, node)?;
        let link = ListLink::between(subject.entry_of(twin)?, nth, Role::Soft);
        let signal = Role::Signal;
        Some(match taken.filter(|&(taken, _)| taken == node) {
            Some((_, List::Clip)) => ListLink {
                from: link.to,
                to: link.from,
                role: signal,
            },
            Some((_, List::Subject)) => ListLink {
                role: signal,
                ..link
            },
            None => link,
        })
    };
    (0..clip.entries.len()).filter_map(link).collect()
}

fn focus(step: &Step<'_, WeilerAtherton>, list: List) -> Option<usize> {
    let here = |list: List| {
        let mut current = standing::current(step).into_iter();
        let current = current.find(|&(at, _)| at == list).map(|(_, place)| place);
        let whole = match step.event() {
            Some(Event::Whole { list, places, .. }) => Some((list, places[0])),
            _ => None,
        };
        let here = |it: Option<(List, u32)>| it.filter(|&(at, _)| at == list);
        let walk = here(whole).or(here(step.held.walk.position));
        current.or(walk.map(|(_, place)| place as usize))
    };
    here(list).or_else(|| beside(step, list, here(list.other())?))
}

/// The place of the intersection that comes next after a place of the other list, or came last.
fn beside(step: &Step<'_, WeilerAtherton>, list: List, other: usize) -> Option<usize> {
    let entries = &step.held.lists.entries[list.other().idx()];
    let reach = ListColumn::reach(entries.len(), Some(other));
    let node = |place: usize| entries.get(place)?.node();
    let ahead = (other..reach.end).find_map(node);
    let node = ahead.or_else(|| (reach.start..other).rev().find_map(node))?;
    standing::place_of(step.held, list, node)
}
