//! The list of triangles in, with the distances of their corners from the plane at work, and the list out.

use std::ops::Range;

use crate::algo::volume::PlaneAtATimeEvent as Event;

use super::list_view::row;
use super::prelude::*;

pub struct AskedTriangle {
    pub triangle_idx: usize,
    pub distances: [f64; 3],
    pub inside: [bool; 3],
    /// Where its edges cross, and between which corners.
    pub crossings: Vec<([usize; 2], Crossing<SpaceVertex>)>,
}

impl AskedTriangle {
    /// A piece of it by the names of its corners: vertices of the triangle, and cuts.
    pub fn corners(&self, given: &[SpaceVertex; 3], piece: &[SpaceVertex; 3]) -> Vec<String> {
        let symbol = |v: &SpaceVertex| {
            let cut = self.crossings.iter().position(|(_, cut)| cut.at == *v);
            let corner = || given.iter().position(|other| other == v);
            cut.map(cut_symbol).or_else(|| corner().map(vertex_symbol))
        };
        piece.iter().filter_map(symbol).collect()
    }
}

pub struct Pieces<'a> {
    /// The list that is cut; after a pass the next one, after the end the answer.
    pub list: &'a [[SpaceVertex; 3]],
    pub next: &'a [[SpaceVertex; 3]],
    /// After a pass, until the next plane's turn: the list that was cut.
    pub passed: &'a [[SpaceVertex; 3]],
    pub plane_idx: Option<usize>,
    /// Those of the list that this plane has been asked about, the last of them now.
    pub asked: Vec<AskedTriangle>,
    /// Which triangle of the list each of the next list comes from.
    pub origins: Vec<usize>,
    pub is_done: bool,
}

impl<'a> Pieces<'a> {
    pub fn of<L: VolumeRules>(step: &Step<'a, PlaneAtATime<L>>) -> Self {
        let (list, other) = (&step.held.left.triangles[..], &step.held.next[..]);
        let is_over = matches!(step.event(), Some(Event::Pass { .. } | Event::Done { .. }));
        let mut now = Self {
            list,
            next: if is_over { &[] } else { other },
            passed: if is_over { other } else { &[] },
            plane_idx: None,
            asked: Vec::new(),
            origins: Vec::new(),
            is_done: false,
        };
        let is_turn = |event: &Event| matches!(event, Event::Plane { .. });
        let start = step.past.iter().rposition(is_turn).unwrap_or_default();
        for event in &step.past[start..] {
            now.hear(*event);
        }
        now
    }

    /// Of the triangle that is asked now.
    pub fn crossings(&self) -> &[([usize; 2], Crossing<SpaceVertex>)] {
        let asked = self.asked.last().filter(|_| self.passed.is_empty());
        asked.map_or(&[], |asked| &asked.crossings)
    }

    fn hear(&mut self, event: Event) {
        match event {
            Event::Plane { plane_idx, .. } => self.plane_idx = Some(plane_idx),
            Event::Triangle {
                triangle_idx,
                distances,
                inside,
            } => {
                self.asked.push(AskedTriangle {
                    triangle_idx,
                    distances,
                    inside,
                    crossings: Vec::new(),
                });
            }
            Event::Cross { idx, at, t } => {
                if let Some(asked) = self.asked.last_mut() {
                    asked.crossings.push((idx, Crossing { at, t }));
                }
            }
            Event::Piece { .. } => {
                let asked = self.asked.last();
                self.origins.extend(asked.map(|asked| asked.triangle_idx));
            }
            Event::Pass { .. } => {}
            Event::Done { .. } => (self.plane_idx, self.is_done) = (None, true),
        }
    }
}

/// The lists; of a method that is compared, the distances stand on the stage, and each new triangle has its corners' names.
pub fn pieces(now: &Pieces<'_>, event: Option<Event>, is_compared: bool) -> Lists {
    let has_passed = matches!(event, Some(Event::Pass { .. }));
    let [list_in, list_out] = if has_passed {
        [now.passed, now.list]
    } else {
        [now.list, now.next]
    };
    let (n_in, n_out) = (list_in.len(), list_out.len());
    let dot = Some(ItemMarker::Dot);
    let link = |i: usize| Some(triangle_link(i));
    let legend = Vec::new();
    if now.is_done {
        let entry = |i| row(triangle_symbol(i), Role::Accepted, dot, link(i));
        let left = ListColumn::about(Value::Term("tri-list-left"), n_in, None, entry);
        let (lists, links) = (vec![left], Vec::new());
        return Lists {
            lists,
            links,
            legend,
        };
    }
    let current = now.asked.last().filter(|_| !has_passed);
    let current = current.map(|asked| asked.triangle_idx);
    let (title, last) = (Value::Term("tri-list-out"), n_out.checked_sub(1));
    let is_new = |i: usize| matches!(event, Some(Event::Piece { .. })) && Some(i) == last;
    let reaches = [(n_in, current), (n_out, last)].map(|(n, at)| ListColumn::reach(n, at));
    let links = match now.plane_idx {
        Some(_) => links(&now.origins, reaches, is_new),
        None => Vec::new(),
    };
    let out = |i: usize| {
        let role = if is_new(i) {
            Role::Signal
        } else {
            Role::Accent
        };
        // Once the plane is done with, the new triangles stand on the stage.
        let link = link(i).filter(|_| has_passed);
        let origin = now.origins[i];
        let mut asked = now.asked.iter().filter(|_| is_compared);
        let asked = asked.find(|asked| asked.triangle_idx == origin);
        let corners = asked.map(|asked| asked.corners(&list_in[origin], &list_out[i]));
        let corners = corners.map(|corners| Some(name(corners.join(" "))));
        ListRow {
            details: corners.into_iter().collect(),
            ..row(format!("{}′", triangle_symbol(i)), role, dot, link)
        }
    };
    let columns = is_compared.then_some(Value::Term("tri-corners"));
    let out = ListColumn {
        columns: columns.into_iter().collect(),
        ..ListColumn::about(title, n_out, last, out)
    };
    let lists = vec![in_list(now, n_in, (current, has_passed, is_compared)), out];
    Lists {
        lists,
        links,
        legend,
    }
}

fn in_list(
    now: &Pieces<'_>,
    n_in: usize,
    (current, has_passed, is_compared): (Option<usize>, bool, bool),
) -> ListColumn {
    let n_columns = if is_compared { 0 } else { 3 };
    let entry = |i: usize| {
        let asked = now.asked.iter().find(|asked| asked.triangle_idx == i);
        let role = match asked {
            _ if current == Some(i) => Role::Signal,
            Some(asked) if asked.inside.contains(&true) => Role::Ink,
            Some(_) => Role::Discarded,
            None => Role::Soft,
        };
        let link = Some(triangle_link(i)).filter(|_| !has_passed);
        let distance = |d: f64| Value::Formula(Formula::decimals().num(d));
        let detail = |corner: usize| asked.map(|asked| distance(asked.distances[corner]));
        let details = (0..n_columns).map(detail).collect();
        ListRow {
            details,
            ..row(triangle_symbol(i), role, asked.map(marker), link)
        }
    };
    let symbol = |i| name(format!("d{}", subscript(i)));
    let columns = (0..n_columns).map(symbol).collect();
    let list = ListColumn::about(Value::Term("tri-list-in"), n_in, current, entry);
    ListColumn { columns, ..list }
}

/// From each triangle of the list in to those that came of it, as far as both stand in the view.
fn links(
    origins: &[usize],
    [reach, out_reach]: [Range<usize>; 2],
    is_new: impl Fn(usize) -> bool,
) -> Vec<ListLink> {
    let place = |reach: &Range<usize>, i: usize| reach.contains(&i).then(|| i - reach.start);
    let link = |(i, &origin): (usize, &usize)| {
        Some(ListLink {
            from: [0, place(&reach, origin)?],
            to: [1, place(&out_reach, i)?],
            role: if is_new(i) { Role::Signal } else { Role::Soft },
        })
    };
    origins.iter().enumerate().filter_map(link).collect()
}

fn marker(asked: &AskedTriangle) -> ItemMarker {
    match asked.inside {
        [true, true, true] => ItemMarker::Dot,
        [false, false, false] => ItemMarker::Ring,
        _ => ItemMarker::HalfDot,
    }
}
