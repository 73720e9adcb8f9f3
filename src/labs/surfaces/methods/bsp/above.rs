//! From above: the triangles, and where each plane of the tree cuts the height of the eye, as far as the planes over it in the tree
//! let it go.

use crate::{
    algo::{
        surface::{Bsp, BspNode},
        volume::{LineInput, PlaneLine},
    },
    figure::{Multiples, SmallDrawing, Tiles},
    geom::Plane,
    labs::why::around,
};

use super::super::{planes::plane_of, prelude::*};

use super::{
    cut_pieces,
    names::{node_of, piece_name},
    own, shown,
};

/// The eye at 0: across to the right, ahead upwards.
const fn from_above([x, _, z]: [f64; 3]) -> [f64; 2] {
    [x, -z]
}

pub fn above(at: &At<'_, Bsp>) -> Multiples {
    let surfaces = at.step.input.surfaces();
    let corners = surfaces.triangles().iter().flatten();
    let corners = corners.map(|&corner| from_above(corner));
    let bounds = around(corners.chain([[0.0; 2]]));
    let mut marks = triangles(at);
    marks.extend(traces(at, bounds));
    let eye = Mark::new(Role::Ink, Shape::Dot([0.0; 2]));
    marks.push(eye.labelled(Value::Term("bsp-eye")));
    Multiples {
        drawings: vec![SmallDrawing::new(
            Value::Term("why-view-above"),
            None,
            marks,
        )],
        bounds,
        tiles: Tiles::Large,
    }
}

fn triangles(at: &At<'_, Bsp>) -> Vec<Mark> {
    let surfaces = at.step.input.surfaces();
    let own = own(at);
    let outline = |corners: &[[f64; 3]]| {
        let corners = corners.iter().map(|&corner| from_above(corner));
        Shape::Outline(corners.collect())
    };
    let whole = surfaces.ids().zip(surfaces.triangles());
    let whole = whole.map(|(id, corners)| {
        let role = if own == Some(id) {
            Role::Accent
        } else {
            Role::Ink
        };
        let mut mark = Mark::new(role, outline(corners)).labelled(name_of(at.scenery, id));
        mark.link = at
            .scenery
            .and_then(|scenery| surface_link(scenery.scene(), id));
        mark
    });
    let cut = cut_pieces(at).map(|piece| {
        let name = piece_name(at.scenery, piece);
        Mark::new(Role::Ink, outline(&piece.polygon)).labelled(name)
    });
    let pieces = shown(at).into_iter().map(|piece| {
        let piece = &at.step.held.pieces[piece as usize];
        Mark::new(Role::Signal, outline(&piece.polygon))
    });
    whole.chain(cut).chain(pieces).collect()
}

/// Those of the nodes so far; dashed, but for the one at work.
fn traces(at: &At<'_, Bsp>, bounds: [[f64; 2]; 2]) -> Vec<Mark> {
    let (surfaces, nodes) = (at.step.input.surfaces(), &at.step.held.nodes);
    let at_work = at.step.event().and_then(node_of);
    let traces = (0..nodes.len()).filter_map(|nth| {
        let plane = plane_of(surfaces, nodes[nth].id)?;
        let mut region = edges(bounds);
        region.extend(over(nodes, nth, |id| plane_of(surfaces, id)));
        let ends = across(&plane, bounds)?;
        let seen = silent::<PlaneLine>(&LineInput {
            bounds: region,
            ends,
        })?;
        let is_now = at_work == Some(nth as u32);
        let role = if is_now { Role::Accent } else { Role::Soft };
        let mark = Mark::new(role, Shape::Segment(seen.map(from_above)));
        Some(if is_now { mark } else { mark.dashed() })
    });
    traces.collect()
}

/// Of a plane that is not level, where it cuts the height of the eye: beyond these bounds.
fn across(plane: &Plane, [min, max]: [[f64; 2]; 2]) -> Option<[[f64; 3]; 2]> {
    let ([x, _, z], d) = (plane.normal(), plane.d());
    let length = x.hypot(z);
    if length == 0.0 {
        return None;
    }
    let foot = [x, z].map(|part| -d / length * (part / length));
    let middle = [min[0].midpoint(max[0]), -min[1].midpoint(max[1])];
    let size = (max[0] - min[0]).hypot(max[1] - min[1]);
    let reach = size + (foot[0] - middle[0]).hypot(foot[1] - middle[1]);
    let along = [-z / length * reach, x / length * reach];
    let end = |sign: f64| [foot[0] + sign * along[0], 0.0, foot[1] + sign * along[1]];
    Some([end(-1.0), end(1.0)])
}

/// The sides of what is drawn.
fn edges([min, max]: [[f64; 2]; 2]) -> Vec<Plane> {
    let sides = [
        [1.0, 0.0, 0.0, -min[0]],
        [-1.0, 0.0, 0.0, max[0]],
        [0.0, 0.0, -1.0, -min[1]],
        [0.0, 0.0, 1.0, max[1]],
    ];
    sides
        .into_iter()
        .filter_map(|side| Plane::new(side).ok())
        .collect()
}

/// The planes over a node in the tree, each with the node's side as its inside.
fn over(nodes: &[BspNode], nth: usize, plane: impl Fn(u32) -> Option<Plane>) -> Vec<Plane> {
    let mut found = Vec::new();
    let mut below = nth as u32;
    while let Some((up, parent)) = nodes.iter().enumerate().find_map(|(up, parent)| {
        let is_parent = parent.front == Some(below) || parent.back == Some(below);
        is_parent.then_some((up as u32, parent))
    }) {
        let plane = plane(parent.id);
        let is_front = parent.front == Some(below);
        found.extend(plane.map(|plane| if is_front { plane } else { plane.turned() }));
        below = up;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trace_lies_in_its_plane_at_the_height_of_the_eye_and_beyond_the_bounds() {
        let bounds = [[-3.0, -1.0], [4.0, 9.0]];
        for plane in [
            [0.6, 0.3, 0.8, 2.0],
            [1.0, 0.0, 0.0, -2.5],
            [-0.2, 5.0, 0.1, 0.7],
        ] {
            let plane = Plane::new(plane).expect("finite");
            let ends = across(&plane, bounds).expect("not level");
            let [nx, _, nz] = plane.normal();
            for [x, y, z] in ends {
                assert!((nx * x + nz * z + plane.d()).abs() < 1e-9 && y == 0.0);
                let [u, v] = from_above([x, y, z]);
                let is_inside = (bounds[0][0]..bounds[1][0]).contains(&u)
                    && (bounds[0][1]..bounds[1][1]).contains(&v);
                assert!(!is_inside, "{u} {v}");
            }
        }
        let level = Plane::new([0.0, 1.0, 0.0, 1.0]).expect("finite");
        assert_eq!(across(&level, bounds), None);
    }
}
