//! The scene, the picture so far, what must come before what, and how far each triangle reaches, in their order, or what is asked of
//! a pair.

use crate::{
    algo::surface::{Painter, PainterEvent as Event},
    figure::Multiples,
    labs::space::Tones,
};

use super::super::{
    asks::asks,
    bars::{Bar, bars},
    glass::{bright, unsorted},
    on_raster::seams,
    prelude::*,
};

use super::{
    graph::{graph, overlaps},
    names::about,
    questions::{plane_asked, questions},
    variant::Variant,
};

const GRAPH_VIEW: &str = "graph";
const DEPTHS_VIEW: &str = "depths";

pub fn views<L: Variant>(at: &At<'_, Painter<L>>) -> Vec<View> {
    let now = about(at.step.event());
    let marked = [(now[0], Role::Accent), (now[1], Role::Signal)];
    let mut views = on_raster::views(at, |scenery| {
        let scene = scenery.scene();
        let raster = if scene.raster.tones == Tones::Counts && scene.beside.len() == 1 {
            pairs(at)
        } else {
            raster(at, scene)
        };
        let mut views = vec![
            scenery.observer_with(
                |_| Fate::ToCome,
                faces(marked, scene),
                plane_asked(at, scene),
            ),
            View::new(RASTER_VIEW, Body::Raster(raster)),
        ];
        // Where nobody is asked nothing must come before anything.
        if !L::KEYS_ONLY {
            let graph = graph(at, scene, now);
            views.push(View::new(GRAPH_VIEW, Body::Graph(graph)));
        }
        let depths = || extents(at).map(Body::Multiples);
        let asked = questions(at).map(Body::Table).or_else(depths);
        views.extend(asked.map(|body| View::new(DEPTHS_VIEW, body)));
        views
    });
    let is_done = at.step.event() == Some(Event::Done);
    let n = at.step.input.triangles().len();
    let said = ["{triangle}, {other}", "watch-pairs"];
    views.extend(asks(at, "asks-painter", said, is_done, || n * n - n));
    let role = if is_done { Role::Signal } else { Role::Ink };
    let cut = at
        .scenery
        .map_or_else(Vec::new, |scenery| seams(scenery.scene(), role));
    for view in &mut views {
        if let Body::Space(space) = &mut view.body {
            space.marks.extend(cut.iter().cloned());
        }
    }
    views
}

/// From its nearest to its farthest vertex each triangle, in their order: where two have no distance in common nothing else is asked.
fn extents<L: Variant>(at: &At<'_, Painter<L>>) -> Option<Multiples> {
    let held = at.step.held;
    let now = about(at.step.event());
    let known = match held.n_sorted {
        0 => &held.list[..],
        n => &held.list[..n],
    };
    let ids: Vec<u32> = known.iter().map(|(it, _)| it.id).collect();
    let reach = |id: u32| {
        let (known, _) = held.list.iter().find(|(it, _)| it.id == id)?;
        Some(known.depths())
    };
    let bar = |&id: &u32| {
        let reach = reach(id)?;
        let role = if now[1] == Some(id) {
            Role::Signal
        } else if now[0] == Some(id) {
            Role::Accent
        } else {
            Role::Soft
        };
        Some(Bar {
            name: name_of(at.scenery, id),
            reach,
            ends: reach.map(|depth| Some(Value::Formula(Formula::decimals().num(depth)))),
            role,
        })
    };
    let rows: Vec<Bar> = ids.iter().filter_map(bar).collect();
    let focus = ids.iter().position(|&id| now[0] == Some(id));
    bars("painter-depths", &rows, focus)
}

/// A row for each triangle, a column for each that may be asked about it, both in the sorted order: which pairs were asked.
fn pairs<L: Variant>(at: &At<'_, Painter<L>>) -> Raster {
    let held = at.step.held;
    let n = at.step.input.triangles().len();
    let place = |id: u32| held.list.iter().position(|(it, _)| it.id == id);
    let mut pixels = vec![Pixel::EMPTY; n * n];
    for event in at.step.past {
        if let Event::Pair { id, other, .. } = *event
            && let (Some(row), Some(column)) = (place(id), place(other))
        {
            pixels[row * n + column].role = Some(Role::Accent);
            pixels[row * n + column].shade = 0.9;
        }
    }
    let title = Message::new("raster-pairs").with("pairs", held.tally.pairs as usize);
    Raster {
        title: Value::Message(title.with("triangles", n)),
        size: [n; 2],
        ..raster_so_far(at.step.input, pixels, Vec::new())
    }
}

fn raster<L: Variant>(at: &At<'_, Painter<L>>, scene: &Scene) -> Raster {
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
    let is_bright = scene.raster.tones == Tones::Brightness && !is_waiting;
    let mut raster = if is_bright {
        bright(surfaces, &held.brightness, over)
    } else {
        raster_so_far(surfaces, pixels(picture, own, letters), over)
    };
    if is_done && cycle.is_empty() {
        raster = if is_bright {
            with_crosses(raster, None, &unsorted(surfaces, &held.brightness))
        } else {
            let name = |id| name_of(at.scenery, id);
            with_crosses(
                raster,
                Some((picture, &name)),
                &wrong_pixels(surfaces, picture),
            )
        };
    }
    raster
}
