//! Building a tree of planes: each node cuts what is left in two.

use std::cmp::Ordering;

use serde::Serialize;

use crate::{
    algo::{ring::Right, volume::split},
    geom::{Plane, Point, orientation, sign_of_four},
    trace::Real,
};

use super::{
    BspChoice, BspTooLarge, Rays, Surfaces,
    coverage::{Coverage, Rows, plane},
    screen_triangle::Linear,
};

/// Where a piece lies, as seen from the plane of a node.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BspSide {
    /// Where the triangle of the node shows its front.
    Front,
    /// On the other side.
    Back,
    /// In the plane itself.
    On,
    /// On both sides: it becomes two.
    Cut,
}

/// A triangle, or what planes have left of one.
#[derive(Clone, PartialEq, Debug)]
pub struct BspPiece {
    /// Of the triangle.
    pub id: u32,
    /// In view space; its winding is the triangle's.
    pub polygon: Vec<[f64; 3]>,
    /// Whose planes have cut it, and whether it lies before them.
    pub cuts: Vec<(u32, bool)>,
}

/// A plane, what lies in it, and what lies on either side.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BspNode {
    /// The triangle whose plane it is.
    pub id: u32,
    /// The node above, and on which side of it this one stands.
    pub parent: Option<(u32, BspSide)>,
    /// The pieces in the plane, first the one that it was chosen for.
    pub on: Vec<u32>,
    /// The pieces that lie before the plane.
    pub before: Vec<u32>,
    /// The pieces that lie behind it.
    pub behind: Vec<u32>,
    /// The node below that holds what lies before it.
    pub front: Option<u32>,
    /// The node below that holds what lies behind it.
    pub back: Option<u32>,
}

impl BspNode {
    /// One that nothing has been asked of yet.
    pub(super) fn new(id: u32, piece: u32, parent: Option<(u32, BspSide)>) -> Self {
        Self {
            id,
            parent,
            on: vec![piece],
            before: Vec::new(),
            behind: Vec::new(),
            front: None,
            back: None,
        }
    }

    /// A piece, or its parts, to where they lie.
    pub(super) fn sort(&mut self, piece: u32, side: BspSide, parts: Option<[u32; 2]>) {
        match (side, parts) {
            (BspSide::Front, _) => self.before.push(piece),
            (BspSide::Back, _) => self.behind.push(piece),
            (BspSide::Cut, Some([before, behind])) => {
                self.before.push(before);
                self.behind.push(behind);
            }
            (BspSide::On | BspSide::Cut, _) => self.on.push(piece),
        }
    }
}

/// What the building comes past.
pub(super) enum Built {
    Node {
        node: u32,
        piece: u32,
        id: u32,
        parent: Option<(u32, BspSide)>,
    },
    Ask {
        node: u32,
        piece: u32,
        side: BspSide,
        /// The new pieces before and behind, of one that is cut.
        parts: Option<[u32; 2]>,
    },
}

pub(super) struct Builder<'a> {
    surfaces: &'a Surfaces,
    choice: BspChoice,
    pub nodes: Vec<BspNode>,
    /// Those that are cut stay in the list.
    pub pieces: Vec<BspPiece>,
    /// How many pieces there are, of those that are not cut any more.
    pub n_whole: usize,
    n_asked: usize,
}

impl<'a> Builder<'a> {
    pub fn new(surfaces: &'a Surfaces, choice: BspChoice) -> Self {
        let kept = surfaces.ids().zip(surfaces.triangles()).filter(|(_, t)| {
            let is_left_out = surfaces.culls_backs() && !surfaces.shows(t);
            has_area(t) && !is_left_out
        });
        let pieces: Vec<BspPiece> = kept
            .map(|(id, triangle)| BspPiece {
                id,
                polygon: triangle.to_vec(),
                cuts: Vec::new(),
            })
            .collect();
        Self {
            surfaces,
            choice,
            nodes: Vec::new(),
            n_whole: pieces.len(),
            pieces,
            n_asked: 0,
        }
    }

    /// Node by node, what lies before a plane first.
    pub fn build<R: Real>(&mut self, tell: &mut impl FnMut(Built)) -> Result<(), BspTooLarge> {
        let all: Vec<u32> = (0..).take(self.pieces.len()).collect();
        let mut open = vec![(all, None)];
        while let Some((mut list, parent)) = open.pop() {
            let Some(chosen) = self.chosen(&list) else {
                continue;
            };
            let piece = list.remove(chosen);
            let (node, id) = (self.nodes.len() as u32, self.pieces[piece as usize].id);
            self.attach(node, parent);
            self.nodes.push(BspNode::new(id, piece, parent));
            tell(Built::Node {
                node,
                piece,
                id,
                parent,
            });
            for piece in list {
                self.n_asked += 1;
                if self.n_asked > BspTooLarge::MOST_QUESTIONS
                    || self.n_whole > BspTooLarge::MOST_PIECES
                {
                    return Err(BspTooLarge);
                }
                let (side, parts) = self.sorted::<R>(id, piece);
                self.nodes[node as usize].sort(piece, side, parts);
                tell(Built::Ask {
                    node,
                    piece,
                    side,
                    parts,
                });
            }
            let BspNode { before, behind, .. } = &self.nodes[node as usize];
            open.push((behind.clone(), Some((node, BspSide::Back))));
            open.push((before.clone(), Some((node, BspSide::Front))));
        }
        Ok(())
    }

    fn attach(&mut self, node: u32, parent: Option<(u32, BspSide)>) {
        attach(&mut self.nodes, node, parent);
    }

    /// Which of a list its plane is taken of.
    fn chosen(&self, list: &[u32]) -> Option<usize> {
        let n_candidates = match self.choice {
            BspChoice::First => return (!list.is_empty()).then_some(0),
            BspChoice::FewestCuts => BspChoice::MOST_CANDIDATES,
        };
        let n_cut = |&candidate: &usize| {
            let id = self.pieces[list[candidate] as usize].id;
            let sides = list.iter().map(|&piece| self.side::<f64>(id, piece));
            sides.filter(|side| *side == BspSide::Cut).count()
        };
        (0..list.len().min(n_candidates)).min_by_key(n_cut)
    }

    /// On which side of a triangle's plane a piece lies; one that is cut becomes two.
    fn sorted<R: Real>(&mut self, id: u32, piece: u32) -> (BspSide, Option<[u32; 2]>) {
        let side = self.side::<R>(id, piece);
        if side != BspSide::Cut {
            return (side, None);
        }
        let cut = &self.pieces[piece as usize];
        let [before, behind] = match self.halves(id, cut) {
            Ok(halves) => halves,
            Err(side) => return (side, None),
        };
        let first = self.pieces.len() as u32;
        self.pieces.extend([before, behind]);
        self.n_whole += 1;
        (BspSide::Cut, Some([first, first + 1]))
    }

    /// What lies before a plane and what lies behind it. Where rounding leaves nothing on one of the sides, the other has it all:
    /// what should lie there is thinner than a cut is exact.
    fn halves(&self, id: u32, cut: &BspPiece) -> Result<[BspPiece; 2], BspSide> {
        let ([x, y, z], d) = plane(self.corners(id));
        // A plane of a triangle too small for its own normal cuts nothing.
        let plane = Plane::new([x, y, z, d]).map_err(|_| BspSide::Back)?;
        let [before, behind] = split(&cut.polygon, &plane);
        if before.is_empty() || behind.is_empty() {
            return Err(if before.is_empty() {
                BspSide::Back
            } else {
                BspSide::Front
            });
        }
        let half = |polygon: Vec<[f64; 3]>, is_before| {
            let mut cuts = cut.cuts.clone();
            cuts.push((id, is_before));
            BspPiece {
                id: cut.id,
                polygon,
                cuts,
            }
        };
        Ok([half(before, true), half(behind, false)])
    }

    /// By its vertices; but its triangle's own corners, where they are all on one side, know better than what is rounded.
    fn side<R: Real>(&self, id: u32, piece: u32) -> BspSide {
        let piece = &self.pieces[piece as usize];
        let whole = self.side_of::<R>(id, self.corners(piece.id));
        if whole == BspSide::Cut && !piece.cuts.is_empty() {
            return match self.side_of::<R>(id, &piece.polygon) {
                // It crosses the plane, so nothing of it but an edge lies there.
                BspSide::On => BspSide::Back,
                side => side,
            };
        }
        whole
    }

    fn side_of<R: Real>(&self, id: u32, vertices: &[[f64; 3]]) -> BspSide {
        let (mut is_before, mut is_behind) = (false, false);
        for &v in vertices {
            let side = self.vertex_side::<R>(id, v);
            is_before |= side == Ordering::Greater;
            is_behind |= side == Ordering::Less;
        }
        match (is_before, is_behind) {
            (true, true) => BspSide::Cut,
            (true, false) => BspSide::Front,
            (false, true) => BspSide::Back,
            (false, false) => BspSide::On,
        }
    }

    /// `Greater` where the triangle shows its front. As computed, n·(v − V0) decides where it is larger than its rounding.
    fn vertex_side<R: Real>(&self, id: u32, v: [f64; 3]) -> Ordering {
        let corners = self.corners(id);
        let [v0, v1, v2] = corners;
        let (n, _) = plane(corners);
        let [e, f]: [[f64; 3]; 2] = [v1, v2].map(|v| std::array::from_fn(|i| (v[i] - v0[i]).abs()));
        let to = [0, 1, 2].map(|i| R::new(v[i]) - R::new(v0[i]));
        let n_counted = n.map(R::new);
        let sum = n_counted[0] * to[0] + n_counted[1] * to[1] + n_counted[2] * to[2];
        let size = (0..3).map(|i| {
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            (e[j] * f[k] + e[k] * f[j]) * to[i].get().abs()
        });
        // A term has two differences, two products, a difference, a difference and a product, and two sums.
        let bound = 16.0 * f64::EPSILON * size.sum::<f64>();
        if (1e-250..1e250).contains(&bound) && sum.get().abs() > bound {
            return if sum > R::new(0.0) {
                Ordering::Greater
            } else {
                Ordering::Less
            };
        }
        front_side(corners, [v[0], v[1], v[2], 1.0])
    }

    /// On which side of a node the eye is; `On` where it lies in the plane.
    pub fn eye_side(&self, node: u32) -> BspSide {
        let corners = self.corners(self.nodes[node as usize].id);
        match front_side(corners, self.surfaces.eye()) {
            Ordering::Greater => BspSide::Front,
            Ordering::Less => BspSide::Back,
            Ordering::Equal => BspSide::On,
        }
    }

    fn corners(&self, id: u32) -> &'a [[f64; 3]; 3] {
        &self.surfaces.triangles()[id as usize]
    }

    /// What a piece covers: those pixels of its triangle at which it lies on the right side of every plane that has cut it. So two
    /// pieces share no pixel's middle, and leave none out between them.
    pub fn rows(&self, piece: u32) -> Rows {
        let piece = &self.pieces[piece as usize];
        let (rays, (n, d)) = (Rays::of(self.surfaces), plane(self.corners(piece.id)));
        let mut rows = Rows::default();
        let Some(coverage) = Coverage::of::<Right>(self.surfaces, self.corners(piece.id)) else {
            return rows;
        };
        let sides: Vec<(Linear<f64>, bool)> = piece
            .cuts
            .iter()
            .map(|&(id, is_before)| {
                let side = rays.side_of_plane((n, d), plane(self.corners(id)));
                (side, is_before)
            })
            .collect();
        let [_, height] = self.surfaces.size();
        coverage.for_each_span(self.surfaces.viewport(), &(0..height), |span| {
            let [first, end] = span.columns;
            let is_inside = |column: u32| {
                let mut sides = sides.iter();
                sides.all(|(side, is_before)| {
                    (side.of::<f64>(column, span.row) >= 0.0) == *is_before
                })
            };
            let mut begun = None;
            for column in first..end {
                match (begun, is_inside(column)) {
                    (None, true) => begun = Some(column),
                    (Some(from), false) => {
                        rows.0.push((span.row, [from, column]));
                        begun = None;
                    }
                    (None, false) | (Some(_), true) => {}
                }
            }
            rows.0.extend(begun.map(|from| (span.row, [from, end])));
        });
        rows
    }
}

/// Makes a node known to the one above it.
pub(super) fn attach(nodes: &mut [BspNode], node: u32, parent: Option<(u32, BspSide)>) {
    let Some((parent, side)) = parent else {
        return;
    };
    let Some(parent) = nodes.get_mut(parent as usize) else {
        return;
    };
    match side {
        BspSide::Front => parent.front = Some(node),
        BspSide::Back => parent.back = Some(node),
        BspSide::On | BspSide::Cut => {}
    }
}

/// `Greater` on the side from which the corners run counter-clockwise. Exact.
fn front_side(&[a, b, c]: &[[f64; 3]; 3], v: [f64; 4]) -> Ordering {
    let [a, b, c] = [a, b, c].map(|[x, y, z]| [x, y, z, 1.0]);
    sign_of_four([a, b, c, v]).reverse()
}

/// Has it an area, in any of the three directions along the axes? Exact.
fn has_area(corners: &[[f64; 3]; 3]) -> bool {
    [[0, 1], [1, 2], [2, 0]].into_iter().any(|[i, j]| {
        let [a, b, c] = corners.map(|v| Point::new(v[i], v[j]).ok());
        match (a, b, c) {
            (Some(a), Some(b), Some(c)) => orientation(a, b, c) != Ordering::Equal,
            _ => false,
        }
    })
}
