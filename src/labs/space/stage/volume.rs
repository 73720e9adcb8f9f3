//! The view volume in the observer's view, and one of its planes at work.

use super::prelude::*;

pub const fn side_key(side: VolumeSide) -> &'static str {
    match side {
        VolumeSide::Near => "plane-near",
        VolumeSide::Far => "plane-far",
        VolumeSide::Left => "plane-left",
        VolumeSide::Right => "plane-right",
        VolumeSide::Bottom => "plane-bottom",
        VolumeSide::Top => "plane-top",
    }
}

pub const fn side_name(side: VolumeSide) -> Value {
    Value::Term(side_key(side))
}

pub const fn side_link(side: VolumeSide) -> Link {
    Link::nth("side", side as usize)
}

/// In a sentence.
pub fn side_named(side: VolumeSide) -> Named {
    Named::from(side_name(side)).linked(side_link(side))
}

fn outline(camera: &Camera, side: VolumeSide) -> Vec<[f64; 3]> {
    let corners = camera.corners_in_world();
    let has = |i: usize| (i >> side.axis() & 1 == 1) == side.is_high();
    let mine: Vec<usize> = (0..8).filter(|&i| has(i)).collect();
    // Numbered by bits: the last two change places.
    [mine[0], mine[1], mine[3], mine[2]]
        .map(|i| corners[i])
        .to_vec()
}

/// Edges and ends of the volume, and its lines of sight.
pub fn volume(camera: &Camera) -> Vec<Mark3> {
    let corners = camera.corners_in_world();
    let mut marks = Vec::new();
    for side in [VolumeSide::Near, VolumeSide::Far] {
        let outline = outline(camera, side);
        let wash = Mark3::new(Role::Accent, Shape3::Wash(outline.clone()));
        marks.push(wash.linked(side_link(side)));
        let outline = Mark3::new(Role::Accent, Shape3::Outline(outline));
        marks.push(outline.fine().linked(side_link(side)));
    }
    for side in VolumeSide::ALL.into_iter().filter(|side| side.axis() < 2) {
        let face = Mark3::new(Role::Faint, Shape3::Wash(outline(camera, side)));
        marks.push(face.fine().linked(side_link(side)));
    }
    for i in 0..4 {
        let edge = Shape3::Segment([corners[i], corners[i + 4]]);
        marks.push(Mark3::new(Role::Accent, edge).fine());
        if camera.volume().sight() == Sight::Perspective {
            let sight = Shape3::Segment([camera.position(), corners[i]]);
            marks.push(Mark3::new(Role::Soft, sight).fine());
        }
    }
    for (side, [a, b]) in [(VolumeSide::Near, [0, 1]), (VolumeSide::Far, [6, 7])] {
        let middle = DVec3::from(corners[a]).midpoint(DVec3::from(corners[b]));
        let name = Mark3::new(Role::Accent, Shape3::Label(middle.into()));
        marks.push(name.labelled(side_name(side)).linked(side_link(side)));
    }
    marks
}

/// What a camera sees that flies while another one culls: none of its planes is asked.
pub fn flying(camera: &Camera) -> Vec<Mark3> {
    let is_drawn = |mark: &Mark3| matches!(mark.shape, Shape3::Outline(_) | Shape3::Segment(_));
    let drawn = volume(camera).into_iter().filter(is_drawn);
    let dashed = |mark| Mark3 {
        role: Role::Soft,
        is_dashed: true,
        link: None,
        ..mark
    };
    drawn.map(dashed).collect()
}

/// Its normal, of length 1, in the middle of what is drawn of it, or the one of whom takes the outside for the inside.
pub fn normal_of(camera: &Camera, side: VolumeSide, is_turned: bool) -> [Mark3; 2] {
    let middle = outline(camera, side).into_iter().map(DVec3::from);
    let middle = middle.sum::<DVec3>() / 4.0;
    let unit = DVec3::from(camera.planes_in_world()[side as usize].unit_normal());
    let tip = middle + if is_turned { -unit } else { unit };
    // Named beside it: what is measured is parallel to it.
    let shapes = [
        Shape3::Arrow([middle.into(), tip.into()]),
        Shape3::Label(tip.into()),
    ];
    let [arrow, at_tip] = shapes.map(|shape| Mark3::new(Role::Ink, shape));
    [arrow, at_tip.labelled(name("n"))]
}

pub fn plane_at_work(camera: &Camera, side: VolumeSide) -> Vec<Mark3> {
    let outline = outline(camera, side);
    vec![
        Mark3::new(Role::Signal, Shape3::Wash(outline.clone())),
        Mark3::new(Role::Signal, Shape3::Sheet(outline))
            .labelled(side_name(side))
            .strong()
            .linked(side_link(side)),
    ]
}
