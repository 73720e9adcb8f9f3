//! What is said at each step, and what pieces are called.

use crate::{
    algo::{
        surface::{BspEvent as Event, BspInput, BspNode, BspPiece, BspSide, BspState as State},
        volume::signed_distance,
    },
    figure::Caption,
    labs::{
        space::OnSceneInput,
        surfaces::methods::on_raster::{name_of, plane_of},
    },
    text::{Formula, Message, Value},
};

pub type Input = OnSceneInput<BspInput>;

/// `A`, and of a part `A+−`: before the first plane that has cut it, behind the second.
pub fn piece_name(input: &Input, piece: &BspPiece) -> Value {
    let signs: String = piece
        .cuts
        .iter()
        .map(|(_, is_before)| if *is_before { '+' } else { '−' })
        .collect();
    let name = name_of(input, piece.id);
    if signs.is_empty() {
        return name;
    }
    match name {
        Value::Name(name) => Value::Name(name + &signs),
        Value::Count(number) => Value::Name(number.to_string() + &signs),
        other => other,
    }
}

fn name_of_piece(input: &Input, state: &State, number: u32) -> Value {
    let piece = state.piece(number);
    piece.map_or(Value::Count(number as usize), |piece| {
        piece_name(input, piece)
    })
}

/// The piece that it was chosen for.
fn name_of_node(input: &Input, state: &State, node: &BspNode) -> Value {
    let chosen = node.on.first();
    chosen.map_or_else(
        || name_of(input, node.id),
        |&piece| name_of_piece(input, state, piece),
    )
}

pub fn caption(event: &Event, before: &State, input: &Input) -> Caption {
    match *event {
        Event::Node { piece, parent, .. } => {
            let above = parent.and_then(|(node, _)| before.nodes.get(node as usize));
            let key = match parent {
                None => "bsp-node-root",
                Some((_, BspSide::Back)) => "bsp-node-back",
                Some((_, BspSide::Front | BspSide::On | BspSide::Cut)) => "bsp-node-front",
            };
            let message = Message::new(key).with("triangle", name_of_piece(input, before, piece));
            Caption::new(match above {
                Some(above) => message.with("parent", name_of_node(input, before, above)),
                None => message,
            })
        }
        Event::Ask {
            node,
            piece,
            side,
            parts,
            ..
        } => ask(before, input, [node, piece], (side, parts)),
        Event::Built { n_pieces } => {
            let triangles = input.own.surfaces().triangles().len();
            let message = Message::new("bsp-built").with("pieces", n_pieces);
            let message = message.with("triangles", triangles);
            Caption::new(message.with("nodes", before.nodes.len()))
        }
        Event::Visit { node, eye } => {
            let key = match eye {
                BspSide::Front => "bsp-visit-front",
                BspSide::Back => "bsp-visit-back",
                BspSide::On | BspSide::Cut => "bsp-visit-on",
            };
            let node = &before.nodes[node as usize];
            let triangle = name_of_node(input, before, node);
            let caption = Caption::new(Message::new(key).with("triangle", triangle));
            match plane_of(input.own.surfaces(), node.id) {
                Some(plane) if input.own.surfaces().eye()[3] == 1.0 => {
                    let d: f64 = signed_distance(&plane, [0.0; 3]);
                    caption.so(Formula::decimals().sym("d = ").num(d))
                }
                Some(_) | None => caption,
            }
        }
        Event::Paint { piece, .. } => {
            let message = Message::new("bsp-paint")
                .with("piece", name_of_piece(input, before, piece))
                .with("place", before.painted.len() + 1)
                .with("pieces", before.so_far.n_pieces);
            Caption::new(message)
        }
        Event::Done => {
            let message = Message::new("bsp-done").with("pieces", before.painted.len());
            Caption::new(message.with("nodes", before.nodes.len()))
        }
    }
}

/// Where a piece lies, with the distances of its vertices.
fn ask(
    state: &State,
    input: &Input,
    [node, number]: [u32; 2],
    (side, parts): (BspSide, Option<[u32; 2]>),
) -> Caption {
    let key = match side {
        BspSide::Front => "bsp-ask-front",
        BspSide::Back => "bsp-ask-back",
        BspSide::On => "bsp-ask-on",
        BspSide::Cut => "bsp-ask-cut",
    };
    let node = &state.nodes[node as usize];
    let name = name_of_piece(input, state, number);
    let part = |sign: char| match &name {
        Value::Name(name) => Value::Name(format!("{name}{sign}")),
        Value::Count(number) => Value::Name(format!("{number}{sign}")),
        other => other.clone(),
    };
    let message = Message::new(key)
        .with("piece", name.clone())
        .with("triangle", name_of_node(input, state, node));
    let message = match parts {
        Some(_) => message.with("first", part('+')).with("second", part('−')),
        None => message,
    };
    let caption = Caption::new(message);
    let (Some(plane), Some(piece)) = (plane_of(input.own.surfaces(), node.id), state.piece(number))
    else {
        return caption;
    };
    let distance = |&at: &[f64; 3]| signed_distance::<f64>(&plane, at);
    let distances: Vec<f64> = piece.polygon.iter().map(distance).collect();
    caption.so(Formula::decimals().sym("d = ").list(&distances))
}
