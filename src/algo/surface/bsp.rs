//! A tree of planes, built once, that gives an order for every eye.
//!
//! ```text
//!        from above                 the tree            walking it
//!             │ b                      A
//!     c ╱     │                      ╱   ╲              at each node: which side is the eye on?
//!   ───────A──┼────────        front       back         first what lies on the other side,
//!             │ b'              b  c        b'          then the node itself, then the eye's own side
//!          ● eye
//! ```
//!
//! 1. Build. A triangle's plane is the node. All others lie before it, behind it or in it; what lies on both sides is cut in two.
//! 2. Walk. What lies on the other side than the eye cannot hide what lies on the eye's: paint it first, then what is in the plane.
//!
//! *Conventions*: before a plane is where its triangle shows its front. In one plane the lower id is painted later. What is culled or
//! without area is not built in. *Exact*: a triangle's side is the sign of a determinant of given coordinates, a piece's that of its
//! rounded vertices; pieces leave no gap. *Bound*: a node asks each piece at most once, and there are no more nodes than pieces; for each
//! its choice, its visit and its painting; the phases. More than [`BspTooLarge::MOST_PIECES`] pieces or [`BspTooLarge::MOST_QUESTIONS`]
//! questions are refused. *Cost* of a vertex against a plane: 5 +, 3 × and 1 comparison; exact signs and choices are not counted.
//!
//! *Source*: H. Fuchs, Z. M. Kedem and B. F. Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980,
//! pp. 124–133.
//!
//! ```
//! use clipscope::{
//!     algo::surface::{Bsp, BspChoice, BspInput, Surfaces},
//!     geom::ViewVolume,
//!     trace::silent,
//! };
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?;
//! // Two that pierce each other: no order of whole triangles is right.
//! let one = [[-2.0, -1.0, -4.0], [2.0, -1.0, -6.0], [0.0, 2.0, -5.0]];
//! let other = [[-2.0, -1.0, -6.0], [2.0, -1.0, -4.0], [0.0, 2.0, -5.0]];
//! let surfaces = Surfaces::new([8, 8], volume, [one, other], false).expect("finite");
//! let input = BspInput::new(surfaces, BspChoice::First).expect("small");
//! assert_eq!(silent::<Bsp>(&input).n_pieces, 3);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::sync::Arc;

use serde::Serialize;

use crate::trace::{Listening, Method, Real, Tell, Told};

use super::{
    BspChoice, BspNode, BspPiece, BspSide, Picture, Surfaces,
    bsp_tree::{attach, chosen, eye_side, sorted, whole_pieces},
};

/// A run can go on from where so many pieces have been asked since it last could: that is less than a millisecond.
const REST_EVERY: usize = 4096;
/// To paint a piece takes as long as to ask so many.
const PAINTING: usize = 16;

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Bsp;

/// It would come to too many pieces, or to too many questions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BspTooLarge;

impl BspTooLarge {
    /// So many pieces are taken.
    pub const MOST_PIECES: usize = 65_536;
    /// So many pieces are asked on which side of a plane they lie.
    pub const MOST_QUESTIONS: usize = 4_000_000;
}

/// Surfaces whose tree is not too large.
#[derive(Clone, PartialEq, Debug)]
pub struct BspInput {
    surfaces: Surfaces,
    choice: BspChoice,
    nodes: Arc<[BspNode]>,
    n_pieces: usize,
}

impl BspInput {
    /// Builds the tree once, to see how large it is.
    ///
    /// # Errors
    /// [`BspTooLarge`]
    pub fn new(surfaces: Surfaces, choice: BspChoice) -> Result<Self, BspTooLarge> {
        let input = Self {
            surfaces,
            choice,
            nodes: Arc::new([]),
            n_pieces: 0,
        };
        let mut held = Bsp::begin(&input);
        let (mut n_asked, mut n_before) = (0, held.n_pieces);
        let mut measuring = Listening(|held: &BspHeld, event| match event {
            BspEvent::Ask { .. } => {
                n_asked += 1;
                let is_large =
                    n_asked > BspTooLarge::MOST_QUESTIONS || n_before > BspTooLarge::MOST_PIECES;
                n_before = held.n_pieces;
                if is_large {
                    return Told::Break(Err(BspTooLarge));
                }
                Told::Continue(())
            }
            BspEvent::Built { .. } => Told::Break(Ok(())),
            BspEvent::Node { .. }
            | BspEvent::Visit { .. }
            | BspEvent::Paint { .. }
            | BspEvent::Done => Told::Continue(()),
        });
        if let Told::Break(measured) = Bsp::run::<f64, _>(&input, &mut held, &mut measuring) {
            measured?;
        }
        Ok(Self {
            nodes: held.nodes.into(),
            n_pieces: held.n_pieces,
            ..input
        })
    }

    /// What is to be seen.
    #[must_use]
    pub const fn surfaces(&self) -> &Surfaces {
        &self.surfaces
    }

    /// The nodes that there will be.
    #[must_use]
    pub fn whole_tree(&self) -> &[BspNode] {
        &self.nodes
    }
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum BspEvent {
    /// A piece is chosen: its plane is a new node.
    Node {
        /// Its number.
        node: u32,
        /// The piece.
        piece: u32,
        /// Its triangle.
        id: u32,
        /// The node above, and the side of it.
        parent: Option<(u32, BspSide)>,
    },
    /// A piece is sorted to one side of the node, or cut.
    Ask {
        /// The node.
        node: u32,
        /// The piece.
        piece: u32,
        /// Where it lies.
        side: BspSide,
        /// Of one that is cut: the new pieces before and behind.
        parts: Option<[u32; 2]>,
    },
    /// The tree is built.
    Built {
        /// How many pieces it holds.
        n_pieces: usize,
    },
    /// The walk comes to a node.
    Visit {
        /// Which.
        node: u32,
        /// Where the eye is, as seen from its plane.
        eye: BspSide,
    },
    /// A piece is painted over everything.
    Paint {
        /// The node that it lies in.
        node: u32,
        /// Which.
        piece: u32,
        /// Its triangle.
        id: u32,
    },
    /// The whole tree has been walked.
    Done,
}

/// The answer.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct BspOutput {
    /// Whose each pixel is.
    #[serde(rename = "ids")]
    pub picture: Picture,
    /// How many pieces the triangles have become.
    pub n_pieces: usize,
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct BspHeld {
    /// Nodes so far.
    pub nodes: Vec<BspNode>,
    /// The pieces so far, those that have been cut among them: a piece's number is its place.
    pub pieces: Vec<BspPiece>,
    /// How many pieces there are, those that have been cut not counted.
    pub n_pieces: usize,
    /// What has been painted so far.
    pub picture: Picture,
    /// Sides of nodes for which nodes are to be built, or all triangles; the last is the next.
    open: Vec<Option<(u32, BspSide)>>,
    /// Once the tree is built: where the walk is to go, the last is the next.
    walk: Option<Vec<Next>>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Next {
    Visit(u32),
    Paint(u32),
}

impl Method for Bsp {
    type Input = BspInput;
    type Held = BspHeld;
    type Output = BspOutput;
    type Event = BspEvent;

    fn begin(input: &Self::Input) -> Self::Held {
        let pieces = whole_pieces(&input.surfaces);
        BspHeld {
            nodes: Vec::new(),
            n_pieces: pieces.len(),
            pieces,
            picture: Picture::empty(input.surfaces.size()),
            open: vec![None],
            walk: None,
        }
    }

    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let mut n_worked = 0;
        while let Some(&parent) = held.open.last() {
            if n_worked >= REST_EVERY {
                n_worked = 0;
                tell.rest(held);
            }
            held.open.pop();
            build::<R, T>(input, held, parent, tell)?;
            let node = held.nodes.last();
            n_worked += node.map_or(0, |node| node.before.len() + node.behind.len());
        }
        if held.walk.is_none() {
            let root = (!held.nodes.is_empty()).then_some(Next::Visit(0));
            held.walk = Some(root.into_iter().collect());
            let n_pieces = held.n_pieces;
            tell.tell(held, BspEvent::Built { n_pieces })?;
        }
        while let Some(&next) = held.walk.as_deref().and_then(<[Next]>::last) {
            if n_worked >= REST_EVERY {
                n_worked = 0;
                tell.rest(held);
            }
            held.walk.as_mut().and_then(Vec::pop);
            walk(input, held, next, tell)?;
            n_worked += PAINTING;
        }
        tell.tell(held, BspEvent::Done)
    }

    fn output(held: Self::Held) -> Self::Output {
        BspOutput {
            n_pieces: held.n_pieces,
            picture: held.picture,
        }
    }

    fn max_events(input: &Self::Input) -> usize {
        let n = input.n_pieces;
        2 + 3 * n + n * 2 * n
    }
}

/// A node for what lies on one side of its parent; what lies before a plane comes first.
#[inline]
fn build<R: Real, T: Tell<Bsp>>(
    input: &BspInput,
    held: &mut BspHeld,
    parent: Option<(u32, BspSide)>,
    tell: &mut T,
) -> Told<T::Stop> {
    let surfaces = &input.surfaces;
    let mut list = match parent {
        None => (0..).take(held.pieces.len()).collect(),
        Some((node, BspSide::Back)) => held.nodes[node as usize].behind.clone(),
        Some((node, _)) => held.nodes[node as usize].before.clone(),
    };
    let Some(chosen) = chosen(surfaces, input.choice, &held.pieces, &list) else {
        return Told::Continue(());
    };
    let piece = list.remove(chosen);
    let (node, id) = (held.nodes.len() as u32, held.pieces[piece as usize].id);
    attach(&mut held.nodes, node, parent);
    held.nodes.push(BspNode::new(id, piece, parent));
    let event = BspEvent::Node {
        node,
        piece,
        id,
        parent,
    };
    tell.tell(held, event)?;
    for piece in list {
        let (side, parts) = sorted::<R>(surfaces, &mut held.pieces, id, piece);
        held.n_pieces += usize::from(parts.is_some());
        held.nodes[node as usize].sort(piece, side, parts);
        let event = BspEvent::Ask {
            node,
            piece,
            side,
            parts,
        };
        tell.tell(held, event)?;
    }
    let sides = [BspSide::Back, BspSide::Front];
    held.open.extend(sides.map(|side| Some((node, side))));
    Told::Continue(())
}

/// Back to front, without recursion: a tree may be as deep as it has nodes.
fn walk<T: Tell<Bsp>>(
    input: &BspInput,
    held: &mut BspHeld,
    next: Next,
    tell: &mut T,
) -> Told<T::Stop> {
    match next {
        Next::Visit(node) => {
            let &BspNode {
                id, front, back, ..
            } = &held.nodes[node as usize];
            let eye = eye_side(&input.surfaces, id);
            let (own, other) = match eye {
                BspSide::Back => (back, front),
                BspSide::Front | BspSide::On | BspSide::Cut => (front, back),
            };
            // What is done last is put down first.
            let order = [
                own.map(Next::Visit),
                Some(Next::Paint(node)),
                other.map(Next::Visit),
            ];
            if let Some(walk) = &mut held.walk {
                walk.extend(order.into_iter().flatten());
            }
            tell.tell(held, BspEvent::Visit { node, eye })?;
        }
        Next::Paint(node) => {
            let mut pieces = held.nodes[node as usize].on.clone();
            pieces.sort_by_key(|&piece| std::cmp::Reverse(held.pieces[piece as usize].id));
            for piece in pieces {
                let own = &held.pieces[piece as usize];
                let id = own.id;
                own.rows(&input.surfaces).paint(&mut held.picture, id);
                tell.tell(held, BspEvent::Paint { node, piece, id })?;
            }
        }
    }
    Told::Continue(())
}
