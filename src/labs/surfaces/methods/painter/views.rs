//! The scene, the picture so far, what must come before what, and two lists: the sorted one, the order.

use crate::algo::surface::{Painter, PainterEvent as Event};

use super::super::prelude::*;

use super::{
    graph::{graph, overlaps},
    names::about,
    variant::Variant,
};

const GRAPH_VIEW: &str = "graph";
const LISTS_VIEW: &str = "lists";

pub fn views<L: Variant>(at: &At<'_, Painter<L>>) -> Vec<View> {
    let now = about(at.step.event());
    let marked = [(now[0], Role::Accent), (now[1], Role::Signal)];
    on_raster::views(at, |scenery| {
        let scene = scenery.scene();
        let mut views = vec![
            scenery.observer_with(|_| Fate::ToCome, faces(marked, scene), Vec::new()),
            View::new(RASTER_VIEW, Body::Raster(raster(at))),
        ];
        // Where nobody is asked nothing must come before anything.
        if !L::KEYS_ONLY {
            let graph = graph(at, scene, now);
            views.push(View::new(GRAPH_VIEW, Body::Graph(graph)));
        }
        views.push(View::new(LISTS_VIEW, Body::Lists(lists(at, scene))));
        views
    })
}

fn raster<L: Variant>(at: &At<'_, Painter<L>>) -> Raster {
    let (surfaces, held) = (at.step.input, at.step.held);
    let [own, other] = about(at.step.event());
    let (picture, cycle) = (&held.picture, &held.cycle);
    let is_done = at.step.event() == Some(Event::Done);
    // Before anything is painted, outlines say where everything will be.
    let mut ids = picture.ids().iter();
    let is_empty = ids.all(|&id| id == Picture::BACKGROUND);
    let is_waiting = is_empty && (!is_done || !cycle.is_empty());
    let letters = lettered_or_outlined(surfaces, picture, is_waiting, |id| name_of(at.scenery, id));
    let waiting = surfaces.ids().filter(|_| is_waiting).map(|id| {
        let role = if cycle.contains(&id) {
            Role::Signal
        } else {
            Role::Soft
        };
        (id, role)
    });
    let waiting = waiting.filter(|(id, _)| ![own, other].contains(&Some(*id)));
    let marked = [(other, Role::Signal), (own, Role::Accent)];
    let marked = marked.into_iter();
    let outlined = waiting.chain(marked.filter_map(|(id, role)| Some((id?, role))));
    let over = outlined.flat_map(|(id, role)| outline(surfaces, id, role));
    let mut over: Vec<RasterMark> = over.collect();
    // Where the depths are that give the arrows.
    let dot = |at| mark(Role::Signal, RasterShape::Dot(at));
    over.extend(overlaps(at).into_iter().map(dot));
    let mut raster = raster_so_far(surfaces, pixels(picture, own, letters), over);
    if is_done && cycle.is_empty() {
        let wrong = wrong_pixels(surfaces, picture);
        raster.title = titled(raster.title, wrong.len());
        raster.over.extend(wrong);
    }
    raster
}

fn lists<L: Variant>(at: &At<'_, Painter<L>>, scene: &Scene) -> Lists {
    let held = at.step.held;
    let now = about(at.step.event());
    let role_of = |id: u32| {
        if now.contains(&Some(id)) {
            Role::Signal
        } else if held.placed.contains(&id) {
            Role::Accent
        } else {
            Role::Ink
        }
    };
    let row = |id: u32, detail: Option<Value>| ListRow {
        details: vec![detail],
        role: role_of(id),
        link: surface_link(scene, id),
        ..ListRow::new(name_of(at.scenery, id))
    };
    let known = match held.n_sorted {
        0 => &held.list[..],
        n => &held.list[..n],
    };
    let of_keys: Vec<u32> = known.iter().map(|(it, _)| it.id).collect();
    let range = |id: u32| {
        let (known, _) = held.list.iter().find(|(it, _)| it.id == id)?;
        let [near, far] = known.depths();
        let range = Formula::decimals().num(far).sym(" … ").num(near);
        Some(Value::Formula(range))
    };
    let column = |title, ids: &[u32], detail: &dyn Fn(u32) -> Option<Value>| {
        let focus = ids.iter().position(|&id| now[0] == Some(id));
        let entry = |place: usize| row(ids[place], detail(ids[place]));
        ListColumn::about(Value::Term(title), ids.len(), focus, entry)
    };
    let sorted = ListColumn {
        columns: vec![Value::Name("z".to_owned())],
        ..column("painter-sorted", &of_keys, &range)
    };
    let order = column("painter-order", &held.placed, &|_| None);
    Lists {
        lists: vec![sorted, order],
        links: Vec::new(),
        legend: Vec::new(),
    }
}
