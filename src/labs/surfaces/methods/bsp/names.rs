//! What the names stand for at a step, and what pieces are called.

use crate::algo::{
    surface::{Bsp, BspEvent as Event, BspPiece, BspSide},
    volume::signed_distance,
};

use super::super::{planes::plane_of, prelude::*};

pub fn named(at: &At<'_, Bsp>, name: &str) -> Option<Named> {
    let (surfaces, held, event) = (at.step.input.surfaces(), at.step.held, at.step.event());
    let piece = |number: u32| {
        let piece = &held.pieces[number as usize];
        Named {
            value: Some(piece_name(at.scenery, piece)),
            ..triangle(at.scenery, piece.id)
        }
    };
    // A node is called like the piece that it was chosen for.
    let node = |number: u32| piece(held.nodes[number as usize].on[0]);
    let asked = || event.and_then(piece_of);
    let part = |sign: char| {
        let piece = &held.pieces[asked()? as usize];
        let name = text_of(piece_name(at.scenery, piece), piece.id as usize);
        Some(Value::Name(name + &sign.to_string()).into())
    };
    let plane = || {
        let node = &held.nodes[node_of(event?)? as usize];
        plane_of(surfaces, node.id)
    };
    Some(match (name, event) {
        ("piece", _) => piece(asked()?),
        ("triangle", _) => node(node_of(event?)?),
        (
            "parent",
            Some(Event::Node {
                parent: Some((parent, _)),
                ..
            }),
        ) => node(parent),
        ("first", _) => part('+')?,
        ("second", _) => part('−')?,
        ("distances", _) => {
            let (plane, piece) = (plane()?, &held.pieces[asked()? as usize]);
            let distance = |&at: &[f64; 3]| signed_distance::<f64>(&plane, at);
            let distances: Vec<f64> = piece.polygon.iter().map(distance).collect();
            Formula::decimals().sym("d = ").list(&distances).into()
        }
        ("eye", _) if surfaces.eye()[3] == 1.0 => {
            signed_distance::<f64>(&plane()?, [0.0; 3]).into()
        }
        ("place" | "watch-painted", _) => painted(at.step.past).count().into(),
        ("pieces" | "watch-pieces", _) => held.n_pieces.into(),
        ("nodes" | "watch-nodes", _) => held.nodes.len().into(),
        ("watch-visited", _) => visited(at.step.past).count().into(),
        _ => return on_raster::named(surfaces, at.scenery, name),
    })
}

/// `A`, and of a part `A+−`: before the first plane that has cut it, behind the second.
pub fn piece_name(scenery: Option<&Scenery>, piece: &BspPiece) -> Value {
    let name = name_of(scenery, piece.id);
    if piece.cuts.is_empty() {
        return name;
    }
    let sign = |(_, is_before): &(u32, bool)| if *is_before { '+' } else { '−' };
    let signs = piece.cuts.iter().map(sign);
    let name = text_of(name, piece.id as usize);
    Value::Name(name.chars().chain(signs).collect())
}

pub const fn node_of(event: Event) -> Option<u32> {
    match event {
        Event::Node { node, .. }
        | Event::Ask { node, .. }
        | Event::Visit { node, .. }
        | Event::Paint { node, .. } => Some(node),
        Event::Built { .. } | Event::Done => None,
    }
}

const fn piece_of(event: Event) -> Option<u32> {
    match event {
        Event::Node { piece, .. } | Event::Ask { piece, .. } | Event::Paint { piece, .. } => {
            Some(piece)
        }
        Event::Built { .. } | Event::Visit { .. } | Event::Done => None,
    }
}

pub fn is_built(past: &[Event]) -> bool {
    past.iter()
        .any(|event| matches!(event, Event::Built { .. }))
}

pub fn visited(past: &[Event]) -> impl Iterator<Item = (u32, BspSide)> {
    past.iter().filter_map(|event| match *event {
        Event::Visit { node, eye } => Some((node, eye)),
        _ => None,
    })
}

pub fn painted(past: &[Event]) -> impl Iterator<Item = u32> {
    past.iter().filter_map(|event| match *event {
        Event::Paint { piece, .. } => Some(piece),
        _ => None,
    })
}
