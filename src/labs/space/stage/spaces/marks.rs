//! What stands around the object in each space, and the vertex with its way from the origin.

use crate::labs::prelude::*;

use super::{
    super::views::vertex_link,
    picture_space::{Followed, PictureSpace},
    space_places::{SCREEN_DEPTH, SpacePlaces},
};

/// Beyond so many vertices no other one is offered.
const MOST_OFFERED: usize = 64;

/// The sides x = ±w, y = ±w, from the origin to a little beyond the object; where the vertex is tested, what they leave at
/// its w.
pub fn pyramid(places: &SpacePlaces<'_>, vertex: &Followed) -> Vec<Mark3> {
    let depth = |at: [f64; 3]| -places.drawn_from_world(PictureSpace::Clip, at)[2];
    let far = places.focused().points().map(depth).fold(1e-3, f64::max);
    let corner = |i: usize, w: f64| {
        let signed = |bit: usize| if i >> bit & 1 == 1 { w } else { -w };
        [signed(0), signed(1), -w]
    };
    let reach = 1.6 * far;
    let mut marks = Vec::new();
    for i in 0..4 {
        let edge = Shape3::Segment([[0.0; 3], corner(i, reach)]);
        marks.push(Mark3::new(Role::Accent, edge).fine());
    }
    for [a, b] in [[2, 3], [0, 2]] {
        let side = vec![[0.0; 3], corner(a, reach), corner(b, reach)];
        marks.push(Mark3::new(Role::Accent, Shape3::Wash(side)));
    }
    if vertex.is_tested {
        let at_vertex = [0, 1, 3, 2].map(|i| corner(i, vertex.at[3])).to_vec();
        marks.push(Mark3::new(Role::Signal, Shape3::Wash(at_vertex.clone())));
        let outline = Mark3::new(Role::Signal, Shape3::Outline(at_vertex));
        marks.push(if vertex.is_large {
            outline.labelled(name("x = ±w, y = ±w"))
        } else {
            outline
        });
    }
    marks
}

pub fn frame(places: &SpacePlaces<'_>) -> Vec<Mark3> {
    let [x, y] = places.half_screen();
    let corners = [[-x, -y], [x, -y], [x, y], [-x, y]].map(|[x, y]| [x, y, 0.0]);
    let frame = Mark3::new(Role::Accent, Shape3::Outline(corners.to_vec()));
    vec![frame.fine()]
}

/// The axes, the way along them to the vertex as far as it is known, and the vertex.
pub fn vertex_marks(
    places: &SpacePlaces<'_>,
    space: PictureSpace,
    vertex: &Followed,
) -> Vec<Mark3> {
    let mut marks = Vec::new();
    if space != PictureSpace::Screen {
        marks.extend(axes(places, space, vertex.is_large));
    }
    if vertex.is_large {
        marks.extend(others(places, space));
        marks.extend(way(places, space, vertex));
    }
    let role = if vertex.arrives {
        Role::Signal
    } else {
        Role::Accent
    };
    let is_there = vertex
        .current
        .is_none_or(|i| i + 1 == space.n_coordinates());
    let at = places.place(space);
    let shape = if is_there { Shape3::Dot } else { Shape3::Ring };
    if places.is_drawn(space) {
        let mark = Mark3::new(role, shape(at));
        marks.push(if vertex.is_large {
            mark.labelled(name("P")).strong()
        } else {
            mark.fine()
        });
    }
    marks
}

fn others(places: &SpacePlaces<'_>, space: PictureSpace) -> Vec<Mark3> {
    let count = places.focused().model().mesh().positions().len();
    let chosen = places.scenery.scene().vertex();
    let is_offered = count <= MOST_OFFERED
        && matches!(
            space,
            PictureSpace::Model | PictureSpace::World | PictureSpace::View
        );
    (0..count)
        .filter(|&i| is_offered && i != chosen)
        .map(|i| {
            let at = Shape3::Dot(places.place_of(space, i));
            Mark3::new(Role::Soft, at).fine().linked(vertex_link(i))
        })
        .collect()
}

fn axes(places: &SpacePlaces<'_>, space: PictureSpace, is_large: bool) -> Vec<Mark3> {
    let object = places.focused();
    let size = match space {
        PictureSpace::Ndc | PictureSpace::Screen => 1.35,
        PictureSpace::Model => {
            let far = object.model().mesh().positions().iter().flatten();
            1.5 * f64::from(far.fold(0.0_f32, |far, x| far.max(x.abs())))
        }
        PictureSpace::World | PictureSpace::View | PictureSpace::Clip => 1.2 * object.size(),
    };
    let third = match space {
        PictureSpace::Clip if !places.is_parallel() => ("w", -1.0),
        PictureSpace::Clip | PictureSpace::Ndc => ("z", -1.0),
        PictureSpace::Model | PictureSpace::World | PictureSpace::View | PictureSpace::Screen => {
            ("z", 1.0)
        }
    };
    [("x", 0, 1.0), ("y", 1, 1.0), (third.0, 2, third.1)]
        .map(|(symbol, axis, sign)| {
            let mut tip = [0.0; 3];
            tip[axis] = sign * size;
            let arrow = Mark3::new(Role::Soft, Shape3::Arrow([[0.0; 3], tip])).fine();
            if is_large {
                arrow.labelled(name(symbol))
            } else {
                arrow
            }
        })
        .to_vec()
}

/// From the origin along one axis after the other, as far as coordinates are known; on the screen from its corner.
fn way(places: &SpacePlaces<'_>, space: PictureSpace, vertex: &Followed) -> Vec<Mark3> {
    if space == PictureSpace::Screen {
        return way_on_screen(places, vertex);
    }
    let axes: &[usize] = match space {
        PictureSpace::Clip if !places.is_parallel() => &[0, 1, 3],
        _ => &[0, 1, 2],
    };
    // What has been divided is not divided again.
    let is_divided = space == PictureSpace::Ndc;
    let mut at = [0.0, 0.0, 0.0, f64::from(is_divided)];
    let mut marks = Vec::new();
    for &axis in axes.iter().filter(|&&axis| axis < vertex.n_known) {
        let from = places.drawn(space, at);
        at[axis] = vertex.at[axis];
        if at[axis] == 0.0 {
            continue;
        }
        let is_current = vertex.current == Some(axis);
        let role = if is_current { Role::Signal } else { Role::Soft };
        let mark = Mark3::new(role, Shape3::Segment([from, places.drawn(space, at)]));
        let symbol = ["x", "y", "z", "w"][axis];
        let formula = Formula::decimals().sym(symbol).equals(at[axis]);
        marks.push(if is_current {
            mark.labelled(Value::Formula(formula)).strong()
        } else {
            mark.fine()
        });
    }
    marks
}

fn way_on_screen(places: &SpacePlaces<'_>, vertex: &Followed) -> Vec<Mark3> {
    if vertex.n_known < 2 || !places.is_drawn(PictureSpace::Screen) {
        return Vec::new();
    }
    let [width, height] = places.half_screen();
    let [x, y, _] = places.place(PictureSpace::Screen);
    let [column, row, ..] = vertex.at;
    let line = |ends: [[f64; 2]; 2], symbol: &'static str, value: f64| {
        let ends = ends.map(|[x, y]| [x, y, 2.0 * SCREEN_DEPTH]);
        let formula = Formula::decimals().sym(symbol).equals(value);
        Mark3::new(Role::Signal, Shape3::Segment(ends))
            .labelled(Value::Formula(formula))
            .strong()
    };
    vec![
        line([[-width, height], [x, height]], "x", column),
        line([[x, height], [x, y]], "y", row),
    ]
}

/// −1 ≤ x, y, z ≤ 1
pub fn cube() -> Vec<Mark3> {
    let corner = |i: usize| [0, 1, 2].map(|bit| if i >> bit & 1 == 1 { 1.0 } else { -1.0 });
    let mut marks = Vec::new();
    for i in 0..8 {
        for bit in [1, 2, 4] {
            if i & bit == 0 {
                let edge = Shape3::Segment([corner(i), corner(i | bit)]);
                marks.push(Mark3::new(Role::Accent, edge).fine());
            }
        }
    }
    let front = [4, 5, 7, 6].map(corner).to_vec();
    marks.push(Mark3::new(Role::Accent, Shape3::Wash(front)));
    marks
}
