//! The scene, the picture so far, what must come before what, and two lists: the sorted one, the order.

use crate::{
    algo::surface::{PainterEvent as Event, Picture},
    figure::{Body, Link, ListColumn, ListRow, Lists, Raster, RasterMark, RasterShape, Role, View},
    labs::{
        Step,
        space::{Scene, soup::surface_link, stage::Fate},
        surfaces::methods::on_raster::{
            faces, fitting, lettered_or_outlined, name_of, outline, pixels, titled, wrong_pixels,
        },
    },
    text::{Formula, Value},
};

use super::{
    Shown,
    graph::{graph, overlaps},
    variant::Variant,
};

const RASTER_VIEW: &str = "raster";
const GRAPH_VIEW: &str = "graph";
const LISTS_VIEW: &str = "lists";

/// The triangle that the step is about.
fn own<L: Variant>(step: &Step<'_, Shown<L>>) -> Option<u32> {
    match step.event? {
        Event::Key { id, .. }
        | Event::Sort { id }
        | Event::Pair { id, .. }
        | Event::Place { id }
        | Event::Cycle { id }
        | Event::Paint { id } => Some(id),
        Event::Constraint { before, .. } => Some(before),
        Event::Done => None,
    }
}

/// The one that is asked beside it.
fn other<L: Variant>(step: &Step<'_, Shown<L>>) -> Option<u32> {
    match step.event? {
        Event::Pair { other, .. } => Some(other),
        Event::Constraint { after, .. } => Some(after),
        Event::Key { .. }
        | Event::Sort { .. }
        | Event::Place { .. }
        | Event::Cycle { .. }
        | Event::Paint { .. }
        | Event::Done => None,
    }
}

pub fn views<L: Variant>(step: &Step<'_, Shown<L>>) -> Vec<View> {
    let Some(scenery) = step.input.scenery.as_deref() else {
        return Vec::new();
    };
    let scene = scenery.scene();
    let now = [own(step), other(step)];
    let marked = [(now[0], Role::Accent), (now[1], Role::Signal)];
    let mut views = vec![
        scenery.observer_with(|_| Fate::ToCome, faces(marked, scene), Vec::new()),
        View::new(RASTER_VIEW, Body::Raster(raster(step))),
    ];
    // Where nobody is asked nothing must come before anything.
    if !L::KEYS_ONLY {
        let graph = graph(step, scene, now);
        views.push(View::new(GRAPH_VIEW, Body::Graph(graph)));
    }
    views.push(View::new(LISTS_VIEW, Body::Lists(lists(step, scene))));
    fitting(scenery, views)
}

fn raster<L: Variant>(step: &Step<'_, Shown<L>>) -> Raster {
    let surfaces = &step.input.own;
    let [columns, rows] = surfaces.size().map(|side| side as usize);
    let (own, other) = (own(step), other(step));
    // Before anything is painted, outlines say where everything will be.
    let is_empty = step
        .state
        .picture
        .ids()
        .iter()
        .all(|&id| id == Picture::BACKGROUND);
    let (picture, cycle) = (&step.state.picture, &step.state.cycle);
    let is_waiting = is_empty && (!step.state.is_done || !cycle.is_empty());
    let letters = lettered_or_outlined(surfaces, picture, is_waiting, |id| name_of(step.input, id));
    let mut over: Vec<_> = surfaces
        .ids()
        .filter(|id| is_waiting && Some(*id) != own && Some(*id) != other)
        .flat_map(|id| {
            let role = if cycle.contains(&id) {
                Role::Signal
            } else {
                Role::Soft
            };
            outline(surfaces, id, role)
        })
        .collect();
    over.extend(
        other
            .into_iter()
            .flat_map(|id| outline(surfaces, id, Role::Signal)),
    );
    over.extend(
        own.into_iter()
            .flat_map(|id| outline(surfaces, id, Role::Accent)),
    );
    // Where the depths are that give the arrows.
    let dots = overlaps(step).into_iter().map(|at| RasterMark {
        role: Role::Signal,
        shape: RasterShape::Dot(at),
    });
    over.extend(dots);
    let mut title = Value::Term("raster-so-far");
    if step.state.is_done && step.state.cycle.is_empty() {
        let wrong = wrong_pixels(surfaces, &step.state.picture);
        title = titled(title, wrong.len());
        over.extend(wrong);
    }
    Raster {
        title,
        size: [columns, rows],
        pixels: pixels(picture, own, letters),
        scale: None,
        current: None,
        over,
    }
}

fn lists<L: Variant>(step: &Step<'_, Shown<L>>, scene: &Scene) -> Lists {
    let state = step.state;
    let (own, other) = (own(step), other(step));
    let link = |id: u32| -> Option<Link> { surface_link(scene, id) };
    let role_of = |id: u32| {
        if own == Some(id) || other == Some(id) {
            Role::Signal
        } else if state.placed.contains(&id) {
            Role::Accepted
        } else {
            Role::Ink
        }
    };
    let row = |id: u32, detail: Option<Value>| ListRow {
        details: vec![detail],
        role: role_of(id),
        link: link(id),
        ..ListRow::new(name_of(step.input, id))
    };
    let of_keys = if state.sorted.is_empty() {
        state.keys.iter().map(|(id, ..)| *id).collect()
    } else {
        state.sorted.clone()
    };
    let range = |id: u32| {
        let known = state.keys.iter().find(|(of, ..)| *of == id);
        let [near, far] = known?.2;
        Some(Value::Formula(
            Formula::decimals().num(far).sym(" … ").num(near),
        ))
    };
    let focus = |ids: &[u32]| ids.iter().position(|&id| own == Some(id));
    let column = |title, ids: &[u32], detail: &dyn Fn(u32) -> Option<Value>| {
        let at = focus(ids);
        let reach = ListColumn::reach(ids.len(), at);
        let (first, last) = (reach.start, reach.end);
        let entries = ids[reach].iter().map(|&id| row(id, detail(id))).collect();
        ListColumn {
            n_before: first,
            n_after: ids.len() - last,
            focus: at.map(|at| at - first),
            ..ListColumn::new(Value::Term(title), entries)
        }
    };
    let sorted = ListColumn {
        columns: vec![Value::Name("z".to_owned())],
        ..column("painter-sorted", &of_keys, &range)
    };
    let order = column("painter-order", &state.placed, &|_| None);
    Lists {
        lists: vec![sorted, order],
        links: Vec::new(),
        legend: Vec::new(),
    }
}
