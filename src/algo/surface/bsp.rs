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
//! 1. Build. Choose a triangle; its plane is the node. All others lie before it, behind it or in it; what lies on both sides is cut
//!    in two. Go on with what is before, then with what is behind.
//! 2. Walk. Whatever lies on the other side of a plane than the eye cannot hide what lies on the eye's own side: so paint the other
//!    side, then what is in the plane, then the eye's side.
//!
//! *Conventions*: before a plane is where its triangle shows its front. Pieces keep their triangle's id. In one plane the lower id is painted later. What is culled is not
//! built in; what has no area neither. *Exact*: on which side a triangle lies is the sign of a determinant of the given coordinates; of a piece, on
//! its rounded vertices. A piece covers those pixels of its triangle where the triangle lies on the piece's side of the planes
//! that cut it, so that pieces leave no gap. *Bound*: each piece is asked by a node at most once, and there are no more nodes than pieces;
//! for each node its choice and its visit, each piece painted once; the phases. An input that would need more than
//! [`BspTooLarge::MOST_PIECES`] pieces or [`BspTooLarge::MOST_QUESTIONS`] questions is refused before. *Cost*: of a vertex against a plane five
//! additions, three multiplications, a comparison; exact signs are not counted, nor is the choice.
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

use crate::trace::{Algorithm, Real};

use super::{
    BspChoice, BspNode, BspPiece, BspSide, BspTooLarge, Picture, Surfaces,
    bsp_tree::{Builder, Built, attach},
    coverage::Rows,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Bsp;

/// Surfaces whose tree is not too large.
#[derive(Clone, PartialEq, Debug)]
pub struct BspInput {
    surfaces: Surfaces,
    choice: BspChoice,
    n_pieces: usize,
}

impl BspInput {
    /// Builds the tree once, to see how large it is.
    ///
    /// # Errors
    /// [`BspTooLarge`]
    pub fn new(surfaces: Surfaces, choice: BspChoice) -> Result<Self, BspTooLarge> {
        let mut builder = Builder::new(&surfaces, choice);
        builder.build::<f64>(&mut |_| {})?;
        let n_pieces = builder.n_whole;
        Ok(Self {
            surfaces,
            choice,
            n_pieces,
        })
    }

    /// What is to be seen.
    #[must_use]
    pub const fn surfaces(&self) -> &Surfaces {
        &self.surfaces
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
        /// How many pieces there are now, those counted that have been cut.
        #[serde(skip)]
        n_known: usize,
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
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BspOutput {
    /// How many pieces the triangles have become.
    pub n_pieces: usize,
    /// Whose each pixel is.
    pub picture: Picture,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct BspState {
    /// Nodes so far.
    pub nodes: Vec<BspNode>,
    /// The node that is built or visited.
    pub node: Option<u32>,
    /// The piece that has been asked, where it lies, and its parts.
    pub asked: Option<(u32, BspSide, Option<[u32; 2]>)>,
    /// Is the tree built?
    pub is_built: bool,
    /// Where the eye is, as seen from the nodes visited so far, in order.
    pub visited: Vec<(u32, BspSide)>,
    /// Pieces painted so far, in order.
    pub painted: Vec<u32>,
    /// How many pieces the tree holds, once it is built; and the picture so far.
    pub so_far: BspOutput,
    /// Is nothing left to do?
    pub is_done: bool,
    /// How many of the pieces are known by now.
    n_known: usize,
    /// All that there will be, and what each covers.
    pieces: Arc<[(BspPiece, Rows)]>,
    /// All that there will be.
    whole: Arc<[BspNode]>,
}

impl BspState {
    /// The pieces so far, those that have been cut among them: a piece's number is its place.
    pub fn pieces(&self) -> impl Iterator<Item = &BspPiece> {
        self.pieces[..self.n_known].iter().map(|(piece, _)| piece)
    }

    /// The nodes that there will be: so that each has its place from the start.
    #[must_use]
    pub fn whole_tree(&self) -> &[BspNode] {
        &self.whole
    }

    /// How many of the pieces so far have been cut, and are none any more.
    #[must_use]
    pub fn n_cut(&self) -> usize {
        let n_parts = self.pieces().filter(|piece| !piece.cuts.is_empty()).count();
        n_parts / 2
    }

    /// One of them.
    #[must_use]
    pub fn piece(&self, number: u32) -> Option<&BspPiece> {
        let known = &self.pieces[..self.n_known];
        known.get(number as usize).map(|(piece, _)| piece)
    }
}

impl Algorithm for Bsp {
    type Input = BspInput;
    type Output = BspOutput;
    type Event = BspEvent;
    type State = BspState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use BspEvent as Event;
        let mut builder = Builder::new(&input.surfaces, input.choice);
        let mut n_known = builder.pieces.len();
        // It has been built before, and was not too large.
        let _ = builder.build::<R>(&mut |built| match built {
            Built::Node {
                node,
                piece,
                id,
                parent,
            } => emit(Event::Node {
                node,
                piece,
                id,
                parent,
            }),
            Built::Ask {
                node,
                piece,
                side,
                parts,
            } => {
                n_known += parts.map_or(0, |parts| parts.len());
                emit(Event::Ask {
                    node,
                    piece,
                    side,
                    parts,
                    n_known,
                });
            }
        });
        let n_pieces = builder.n_whole;
        emit(Event::Built { n_pieces });
        let mut picture = Picture::empty(input.surfaces.size());
        walk(&builder, &mut picture, &mut emit);
        emit(Event::Done);
        BspOutput { n_pieces, picture }
    }

    fn start(input: &Self::Input) -> Self::State {
        let mut builder = Builder::new(&input.surfaces, input.choice);
        let n_known = builder.pieces.len();
        let _ = builder.build::<f64>(&mut |_| {});
        let numbered = (0..).zip(&builder.pieces);
        let pieces = numbered.map(|(number, piece)| (piece.clone(), builder.rows(number)));
        BspState {
            nodes: Vec::new(),
            node: None,
            asked: None,
            is_built: false,
            visited: Vec::new(),
            painted: Vec::new(),
            so_far: BspOutput {
                n_pieces: 0,
                picture: Picture::empty(input.surfaces.size()),
            },
            is_done: false,
            n_known,
            pieces: pieces.collect(),
            whole: builder.nodes.into(),
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        state.so_far.clone()
    }

    /// Each of the pieces, and of those that were cut, by each node; for each node its choice and its visit; each piece painted; the
    /// phases.
    fn max_events(input: &Self::Input) -> usize {
        let n = input.n_pieces;
        2 + 3 * n + n * 2 * n
    }
}

impl BspState {
    fn apply(&mut self, event: BspEvent) {
        use BspEvent as Event;
        match event {
            Event::Node {
                node,
                piece,
                id,
                parent,
            } => {
                attach(&mut self.nodes, node, parent);
                self.nodes.push(BspNode::new(id, piece, parent));
                (self.node, self.asked) = (Some(node), None);
            }
            Event::Ask {
                node,
                piece,
                side,
                parts,
                n_known,
            } => {
                if let Some(node) = self.nodes.get_mut(node as usize) {
                    node.sort(piece, side, parts);
                }
                self.asked = Some((piece, side, parts));
                self.n_known = n_known;
            }
            Event::Built { n_pieces } => {
                (self.node, self.asked) = (None, None);
                self.so_far.n_pieces = n_pieces;
                self.is_built = true;
            }
            Event::Visit { node, eye } => {
                self.node = Some(node);
                self.visited.push((node, eye));
            }
            Event::Paint { node, piece, id } => {
                self.node = Some(node);
                self.painted.push(piece);
                if let Some((_, rows)) = self.pieces.get(piece as usize) {
                    rows.paint(&mut self.so_far.picture, id);
                }
            }
            Event::Done => {
                self.node = None;
                self.is_done = true;
            }
        }
    }
}

/// Back to front, without recursion: a tree may be as deep as it has nodes.
fn walk(builder: &Builder<'_>, picture: &mut Picture, emit: &mut impl FnMut(BspEvent)) {
    enum Next {
        Visit(u32),
        Paint(u32),
    }
    let mut open: Vec<Next> = Vec::new();
    if !builder.nodes.is_empty() {
        open.push(Next::Visit(0));
    }
    while let Some(next) = open.pop() {
        match next {
            Next::Visit(node) => {
                let (eye, BspNode { front, back, .. }) =
                    (builder.eye_side(node), &builder.nodes[node as usize]);
                emit(BspEvent::Visit { node, eye });
                let (own, other) = match eye {
                    BspSide::Back => (back, front),
                    BspSide::Front | BspSide::On | BspSide::Cut => (front, back),
                };
                // What is done last is put down first.
                open.extend(own.map(Next::Visit));
                open.push(Next::Paint(node));
                open.extend(other.map(Next::Visit));
            }
            Next::Paint(node) => {
                let mut pieces = builder.nodes[node as usize].on.clone();
                let id_of = |piece: u32| builder.pieces[piece as usize].id;
                pieces.sort_by_key(|&piece| std::cmp::Reverse(id_of(piece)));
                for piece in pieces {
                    let id = id_of(piece);
                    builder.rows(piece).paint(picture, id);
                    emit(BspEvent::Paint { node, piece, id });
                }
            }
        }
    }
}
