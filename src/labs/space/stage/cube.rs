//! The box from −1 to 1 in the observer's view: its edges go on, and so part space into 27 regions.

use super::{
    super::Scene,
    prelude::*,
    views::OBSERVER_VIEW,
    volume::{side_link, side_name},
};

/// So far edges go on, and axes and what lies beyond a face are drawn.
const REACH: f64 = 2.0;
const TIP: f64 = 2.5;

pub fn cube_view(scene: &Scene, own: Vec<Mark3>) -> View {
    let mut marks = cube();
    marks.extend(own);
    let space = Space {
        title: None,
        seer: Seer::Eye(scene.eye),
        facets: Facets::default(),
        edges: [].into(),
        marks,
    };
    View::new(OBSERVER_VIEW, Body::Space(space))
}

/// The corners of a face, going round it, `reach` away from the middle of it.
fn outline(side: VolumeSide, reach: f64) -> Vec<[f64; 3]> {
    let height = if side.is_high() { 1.0 } else { -1.0 };
    let corner = |[a, b]: [f64; 2]| {
        let mut at = [0.0; 3];
        at[side.axis()] = height;
        at[(side.axis() + 1) % 3] = a;
        at[(side.axis() + 2) % 3] = b;
        at
    };
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    corners.map(|at| corner(at.map(|x| reach * x))).to_vec()
}

fn cube() -> Vec<Mark3> {
    let mut marks = Vec::new();
    for side in [VolumeSide::Near, VolumeSide::Far] {
        let face = Mark3::new(Role::Accent, Shape3::Outline(outline(side, 1.0)));
        marks.push(face.fine().linked(side_link(side)));
    }
    for side in VolumeSide::ALL {
        marks.push(Mark3::new(Role::Accent, Shape3::Wash(outline(side, 1.0))));
    }
    let corners = outline(VolumeSide::Near, 1.0);
    for &[x, y, _] in &corners {
        let edge = Shape3::Segment([[x, y, -1.0], [x, y, 1.0]]);
        marks.push(Mark3::new(Role::Accent, edge).fine());
    }
    for axis in 0..3 {
        let side = [VolumeSide::Left, VolumeSide::Bottom, VolumeSide::Near][axis];
        for corner in outline(side, 1.0) {
            for sign in [-1.0, 1.0] {
                let mut ends = [corner; 2];
                (ends[0][axis], ends[1][axis]) = (sign, sign * REACH);
                marks.push(Mark3::new(Role::Faint, Shape3::Segment(ends)).fine());
            }
        }
        let (mut from, mut tip) = ([0.0; 3], [0.0; 3]);
        (from[axis], tip[axis]) = (REACH, TIP);
        let arrow = Mark3::new(Role::Soft, Shape3::Arrow([from, tip])).fine();
        marks.push(arrow.labelled(name(["x", "y", "z"][axis])));
    }
    marks
}

/// `x = −1`
pub fn axis_equation(side: VolumeSide, at: f64) -> Formula {
    let axis = ["x", "y", "z"][side.axis()];
    sym(axis).sym(" = ").num(at)
}

pub fn face_at_work(side: VolumeSide) -> Vec<Mark3> {
    let height = if side.is_high() { 1.0 } else { -1.0 };
    let corners = outline(side, REACH);
    let mut marks = vec![
        Mark3::new(Role::Signal, Shape3::Wash(corners.clone())),
        Mark3::new(Role::Signal, Shape3::Sheet(corners.clone())).fine(),
        Mark3::new(Role::Signal, Shape3::Sheet(outline(side, 1.0)))
            .labelled(side_name(side))
            .strong()
            .linked(side_link(side)),
    ];
    let corner = corners[if side.is_high() { 2 } else { 3 }];
    marks.push(
        Mark3::new(Role::Signal, Shape3::Label(corner)).labelled(axis_equation(side, height)),
    );
    marks
}
