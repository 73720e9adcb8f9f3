//! Building a tree of planes: each node cuts what is left in two.

use std::cmp::Ordering;

use serde::Serialize;

use crate::{
    algo::{ring::Right, volume::split},
    geom::{Plane, Point, minor_extent, orientation, sign_of_four},
    trace::Real,
};

use super::{
    Rays, Surfaces,
    coverage::{Coverage, Rows, TrianglePlane, plane},
    screen_triangle::Linear,
};

/// Whose plane is taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum BspChoice {
    /// That of the first in the list.
    #[default]
    First,
    /// Of the first few, that which cuts the fewest.
    FewestCuts,
}

impl BspChoice {
    /// So many are compared.
    pub const MOST_CANDIDATES: usize = 8;
}

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

pub(super) fn whole_pieces(surfaces: &Surfaces) -> Vec<BspPiece> {
    let kept = surfaces.ids().zip(surfaces.triangles()).filter(|(_, t)| {
        let is_left_out = surfaces.culls_backs() && !surfaces.shows(t);
        has_area(t) && !is_left_out
    });
    kept.map(|(id, triangle)| BspPiece {
        id,
        polygon: triangle.to_vec(),
        cuts: Vec::new(),
    })
    .collect()
}

pub(super) fn chosen(
    surfaces: &Surfaces,
    choice: BspChoice,
    pieces: &[BspPiece],
    list: &[u32],
) -> Option<usize> {
    let n_candidates = match choice {
        BspChoice::First => return (!list.is_empty()).then_some(0),
        BspChoice::FewestCuts => BspChoice::MOST_CANDIDATES,
    };
    let piece = |number: u32| &pieces[number as usize];
    let n_cut = |&candidate: &usize| {
        let id = piece(list[candidate]).id;
        let sides = list
            .iter()
            .map(|&other| piece(other).side::<f64>(surfaces, id));
        sides.filter(|side| *side == BspSide::Cut).count()
    };
    (0..list.len().min(n_candidates)).min_by_key(n_cut)
}

/// On which side of a triangle's plane a piece lies. One that is cut becomes two more pieces.
pub(super) fn sorted<R: Real>(
    surfaces: &Surfaces,
    pieces: &mut Vec<BspPiece>,
    id: u32,
    piece: u32,
) -> (BspSide, Option<[u32; 2]>) {
    let cut = &pieces[piece as usize];
    let side = cut.side::<R>(surfaces, id);
    if side != BspSide::Cut {
        return (side, None);
    }
    let [before, behind] = match cut.halves(surfaces, id) {
        Ok(halves) => halves,
        Err(side) => return (side, None),
    };
    let first = pieces.len() as u32;
    pieces.extend([before, behind]);
    (BspSide::Cut, Some([first, first + 1]))
}

impl BspPiece {
    /// Before and behind a plane. Where rounding leaves nothing on one side the other has it all: what is missing is thinner than a cut is exact.
    fn halves(&self, surfaces: &Surfaces, id: u32) -> Result<[Self; 2], BspSide> {
        let TrianglePlane { n, d, .. } = TrianglePlane::of(corners(surfaces, id));
        let [x, y, z] = n;
        // A plane of a triangle too small for its own normal cuts nothing.
        let plane = Plane::new([x, y, z, d]).map_err(|_| BspSide::Back)?;
        let [before, behind] = split(&self.polygon, &plane);
        if before.is_empty() || behind.is_empty() {
            return Err(if before.is_empty() {
                BspSide::Back
            } else {
                BspSide::Front
            });
        }
        let half = |polygon: Vec<[f64; 3]>, is_before| {
            let mut cuts = self.cuts.clone();
            cuts.push((id, is_before));
            Self {
                id: self.id,
                polygon,
                cuts,
            }
        };
        Ok([half(before, true), half(behind, false)])
    }

    /// By its vertices; but its triangle's own corners, where they are all on one side, know better than what is rounded.
    fn side<R: Real>(&self, surfaces: &Surfaces, id: u32) -> BspSide {
        let plane = corners(surfaces, id);
        let whole = side_of::<R>(plane, corners(surfaces, self.id));
        if whole == BspSide::Cut && !self.cuts.is_empty() {
            return match side_of::<R>(plane, &self.polygon) {
                // It crosses the plane, so nothing of it but an edge lies there.
                BspSide::On => BspSide::Back,
                side => side,
            };
        }
        whole
    }

    /// The pixels of its triangle that lie on its side of every plane that cut it: pieces share none, and leave none out.
    pub(super) fn rows(&self, surfaces: &Surfaces) -> Rows {
        let own = corners(surfaces, self.id);
        let (rays, plane) = (Rays::of(surfaces), TrianglePlane::of(own));
        let mut rows = Rows::default();
        let Some(coverage) = Coverage::of::<Right>(surfaces, own) else {
            return rows;
        };
        let sides: Vec<(Linear<f64>, bool)> = self
            .cuts
            .iter()
            .map(|&(id, is_before)| {
                let other = TrianglePlane::of(corners(surfaces, id));
                let side = rays.side_of_plane((plane.n, plane.d), (other.n, other.d));
                (side, is_before)
            })
            .collect();
        coverage.for_each_span(surfaces.viewport(), |span| {
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

fn side_of<R: Real>(triangle: &[[f64; 3]; 3], vertices: &[[f64; 3]]) -> BspSide {
    let (mut is_before, mut is_behind) = (false, false);
    for &v in vertices {
        let side = vertex_side::<R>(triangle, v);
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
fn vertex_side<R: Real>(corners: &[[f64; 3]; 3], v: [f64; 3]) -> Ordering {
    let [v0, v1, v2] = corners;
    let (n, _) = plane::<f64>(corners);
    let [e, f]: [[f64; 3]; 2] = [v1, v2].map(|v| std::array::from_fn(|i| v[i] - v0[i]));
    let to = [0, 1, 2].map(|i| R::new(v[i]) - R::new(v0[i]));
    let n_counted = n.map(R::new);
    let sum = n_counted[0] * to[0] + n_counted[1] * to[1] + n_counted[2] * to[2];
    let size = (0..3).map(|i| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        minor_extent([e[j] * f[k], e[k] * f[j]]) * to[i].get().abs()
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

/// On which side of a triangle's plane the eye is; `On` where it lies in the plane.
pub(super) fn eye_side(surfaces: &Surfaces, id: u32) -> BspSide {
    match front_side(corners(surfaces, id), surfaces.eye()) {
        Ordering::Greater => BspSide::Front,
        Ordering::Less => BspSide::Back,
        Ordering::Equal => BspSide::On,
    }
}

fn corners(surfaces: &Surfaces, id: u32) -> &[[f64; 3]; 3] {
    &surfaces.triangles()[id as usize]
}

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
