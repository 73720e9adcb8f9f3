//! The list of triangles in, with the distances of their corners from the plane at work, and the list out.

use std::ops::Range;

use crate::{
    algo::{
        ring::Crossing,
        volume::{PlaneAtATime, PlaneAtATimeEvent as Event, SpaceVertex, VolumeRules},
    },
    figure::{ItemMarker, Link, ListColumn, ListLink, ListRow, Lists, Role},
    labs::words::{name, subscript},
    text::{Formula, Value},
    trace::Step,
};

use super::symbols::triangle_symbol;

/// A triangle of the list against the plane.
pub struct AskedTriangle {
    /// In the list.
    pub triangle_idx: usize,
    /// Its corners' signed distances from the plane.
    pub distances: [f64; 3],
    /// Are they inside?
    pub inside: [bool; 3],
}

/// A step: both lists, and what has been told of the plane at work.
pub struct Pieces<'a> {
    /// The list that is cut; after a pass the next one, after the end the answer.
    pub list: &'a [[SpaceVertex; 3]],
    /// The list that grows.
    pub next: &'a [[SpaceVertex; 3]],
    /// After a pass, until the next plane's turn: the list that was cut.
    pub passed: &'a [[SpaceVertex; 3]],
    /// The plane whose turn it is.
    pub plane_idx: Option<usize>,
    /// Those of the list that this plane has been asked about, the last of them now.
    pub asked: Vec<AskedTriangle>,
    /// Which triangle of the list each of the next list comes from.
    pub origins: Vec<usize>,
    /// The crossings of the last of them, and between which corners they lie.
    pub crossings: Vec<([usize; 2], Crossing<SpaceVertex>)>,
    /// Is there nothing left to do?
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
            crossings: Vec::new(),
            is_done: false,
        };
        let is_turn = |event: &Event| matches!(event, Event::Plane { .. });
        let start = step.past.iter().rposition(is_turn).unwrap_or_default();
        for event in &step.past[start..] {
            now.hear(*event);
        }
        now
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
                });
                self.crossings.clear();
            }
            Event::Cross { idx, at, t } => self.crossings.push((idx, Crossing { at, t })),
            Event::Piece { .. } => {
                let asked = self.asked.last();
                self.origins.extend(asked.map(|asked| asked.triangle_idx));
            }
            Event::Pass { .. } => self.crossings.clear(),
            Event::Done { .. } => (self.plane_idx, self.is_done) = (None, true),
        }
    }
}

/// What marks and rows about a triangle of the list have in common.
pub const fn triangle_link(idx: usize) -> Link {
    Link::nth("triangle", idx)
}

/// `T₂′`: in the list out.
fn out_symbol(idx: usize) -> String {
    format!("{}′", triangle_symbol(idx))
}

/// Both lists at a step; at the end what is left.
pub fn pieces(now: &Pieces<'_>, event: Option<Event>) -> Lists {
    let has_passed = matches!(event, Some(Event::Pass { .. }));
    let (n_in, n_out) = if has_passed {
        (now.passed.len(), now.list.len())
    } else {
        (now.list.len(), now.next.len())
    };
    if now.is_done {
        return Lists {
            lists: vec![left(n_in)],
            links: Vec::new(),
            legend: Vec::new(),
        };
    }
    let current = now.asked.last().filter(|_| !has_passed);
    let current = current.map(|asked| asked.triangle_idx);
    let reach = ListColumn::reach(n_in, current);
    let out_reach = ListColumn::reach(n_out, n_out.checked_sub(1));
    let is_new = |i: usize| matches!(event, Some(Event::Piece { .. })) && i + 1 == n_out;
    let links = match now.plane_idx {
        Some(_) => links(&now.origins, [&reach, &out_reach], is_new),
        None => Vec::new(),
    };
    let out_list = out_list((n_out, out_reach), has_passed, is_new);
    Lists {
        lists: vec![in_list(now, (n_in, reach), current, has_passed), out_list],
        links,
        legend: Vec::new(),
    }
}

fn in_list(
    now: &Pieces<'_>,
    (n_in, reach): (usize, Range<usize>),
    current: Option<usize>,
    has_passed: bool,
) -> ListColumn {
    let entry = |i: usize| {
        let asked = now.asked.iter().find(|asked| asked.triangle_idx == i);
        let mut entry = ListRow::new(name(triangle_symbol(i)));
        entry.role = match asked {
            _ if current == Some(i) => Role::Signal,
            Some(asked) if asked.inside.contains(&true) => Role::Ink,
            Some(_) => Role::Discarded,
            None => Role::Soft,
        };
        entry.marker = asked.map(marker);
        entry.details = (0..3)
            .map(|corner| {
                asked.map(|asked| Value::Formula(Formula::decimals().num(asked.distances[corner])))
            })
            .collect();
        entry.link = Some(triangle_link(i)).filter(|_| !has_passed);
        entry
    };
    let columns = (0..3).map(|i| name(format!("d{}", subscript(i))));
    ListColumn {
        columns: columns.collect(),
        n_before: reach.start,
        n_after: n_in - reach.end,
        focus: current.map(|current| current - reach.start),
        ..ListColumn::new(
            Value::Term("tri-list-in"),
            reach.clone().map(entry).collect(),
        )
    }
}

fn out_list(
    (n_out, reach): (usize, Range<usize>),
    has_passed: bool,
    is_new: impl Fn(usize) -> bool,
) -> ListColumn {
    let out = |i: usize| {
        let mut entry = ListRow::new(name(out_symbol(i)));
        entry.role = if is_new(i) {
            Role::Signal
        } else {
            Role::Accent
        };
        entry.marker = Some(ItemMarker::Dot);
        // Once the plane is done with, the new triangles stand on the stage.
        entry.link = Some(triangle_link(i)).filter(|_| has_passed);
        entry
    };
    ListColumn {
        n_before: reach.start,
        n_after: n_out - reach.end,
        focus: n_out.checked_sub(1).map(|last| last - reach.start),
        ..ListColumn::new(
            Value::Term("tri-list-out"),
            reach.clone().map(out).collect(),
        )
    }
}

/// From each triangle of the list in to those that came of it, as far as both stand in the view.
fn links(
    origins: &[usize],
    [reach, out_reach]: [&Range<usize>; 2],
    is_new: impl Fn(usize) -> bool,
) -> Vec<ListLink> {
    let place = |reach: &Range<usize>, i: usize| reach.contains(&i).then(|| i - reach.start);
    let link = |(i, &origin): (usize, &usize)| {
        Some(ListLink {
            from: [0, place(reach, origin)?],
            to: [1, place(out_reach, i)?],
            role: if is_new(i) { Role::Signal } else { Role::Soft },
        })
    };
    origins.iter().enumerate().filter_map(link).collect()
}

/// Whole, in part, or not at all inside.
fn marker(asked: &AskedTriangle) -> ItemMarker {
    match asked.inside.iter().filter(|&&inside| inside).count() {
        3 => ItemMarker::Dot,
        0 => ItemMarker::Ring,
        1 | 2 | 4.. => ItemMarker::Cross,
    }
}

fn left(n: usize) -> ListColumn {
    let reach = ListColumn::reach(n, None);
    let entry = |i: usize| {
        let mut entry = ListRow::new(name(triangle_symbol(i)));
        entry.role = Role::Accepted;
        entry.marker = Some(ItemMarker::Dot);
        entry.link = Some(triangle_link(i));
        entry
    };
    ListColumn {
        n_after: n - reach.end,
        ..ListColumn::new(Value::Term("tri-list-left"), reach.map(entry).collect())
    }
}
