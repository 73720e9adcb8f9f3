use super::*;
use crate::{
    figure::{Edge3, Edging, Facet, Mark3, Role, Seer, Shape, Shape3},
    geom::Orbit,
};

fn cube() -> Vec<Facet> {
    let face = |axis: usize, side: f64| {
        let corner = |[u, v]: [f64; 2]| {
            let mut at = [0.0; 3];
            at[axis] = side;
            at[(axis + 1) % 3] = u * side;
            at[(axis + 2) % 3] = v;
            at
        };
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        Facet {
            corners: square.map(corner).to_vec(),
            role: Role::Accent,
            link: None,
            skin: None,
            edging: Edging::Lines,
            opacity: 1.0,
        }
    };
    (0..3)
        .flat_map(|axis| [-1.0, 1.0].map(|side| face(axis, side)))
        .collect()
}

pub fn space_of(facets: Vec<Facet>, marks: Vec<Mark3>, lens: &Lens) -> Space {
    let seer = match *lens {
        Lens::Eye(eye) => Seer::Eye(eye),
        Lens::Camera(camera) => Seer::Camera(camera),
        Lens::Plane => panic!("no lens of space"),
    };
    Space {
        title: None,
        seer,
        edges: Edge3::of(&facets).into(),
        facets: facets.into(),
        marks,
    }
}

fn seen(marks: Vec<Mark3>, eye: &Orbit) -> Vec<Mark> {
    let lens = Lens::Eye(*eye);
    project(&space_of(cube(), marks, &lens), &lens)
}

#[test]
fn of_a_cube_nine_edges_are_seen_and_three_hidden() {
    for angles in [[30.0, 20.0], [-50.0, -35.0], [200.0, 10.0]] {
        let eye = Orbit::new([0.0; 3], angles, 8.0, 30.0);
        let marks = seen(Vec::new(), &eye);
        let n = |is: fn(&Mark) -> bool| marks.iter().filter(|mark| is(mark)).count();
        let edges = [
            n(|mark| matches!(mark.shape, Shape::Path(_)) && !mark.is_dashed),
            n(|mark| mark.is_dashed),
        ];
        assert_eq!(edges, [9, 3], "{angles:?}");
    }
}

#[test]
fn a_segment_through_the_cube_is_dashed_inside_and_behind_it() {
    let eye = Orbit::new([0.0; 3], [0.0, 0.0], 10.0, 30.0);
    let ends = [[-3.0, 0.0, 2.0], [3.0, 0.0, -2.0]];
    let marks = seen(vec![Mark3::new(Role::Signal, Shape3::Segment(ends))], &eye);
    let drawn = marks.iter().filter_map(|mark| {
        let ends = match &mark.shape {
            Shape::Segment(ends) => *ends,
            Shape::Path(points) => [points[0], points[1]],
            _ => return None,
        };
        let is_level = ends[0][1] == 0.0 && ends[1][1] == 0.0;
        is_level.then_some((mark.is_dashed, ends))
    });
    let drawn: Vec<(bool, [[f64; 2]; 2])> = drawn.collect();
    // From the left edge of the front, behind which it goes in and comes out, to the right one.
    let [(true, hidden), (false, before), (false, after)] = drawn[..] else {
        panic!("one hidden part between two visible ones, not {drawn:?}");
    };
    assert_eq!([hidden[0], hidden[1]], [before[1], after[0]]);
    for (end, side) in [-1.0, 1.0].into_iter().enumerate() {
        let edge = Lens::Eye(eye).drawing_from_world([side, 0.0, 1.0]);
        let off = hidden[end][0] - edge.expect("before the eye")[0];
        assert!(off.abs() < 1e-9, "{hidden:?}: {off} off {edge:?}");
    }
}

#[test]
fn what_is_behind_the_eye_is_cut_off_before_it_is_divided() {
    let eye = Orbit::new([0.0; 3], [0.0, 0.0], 10.0, 30.0);
    let line = |from: f64, to: f64| {
        let ends = [[2.0, 2.0, from], [2.0, 2.0, to]];
        Mark3::new(Role::Signal, Shape3::Segment(ends))
    };
    let signal = |marks: Vec<Mark>| -> Vec<[[f64; 2]; 2]> {
        let ends = marks.into_iter().filter_map(|mark| match mark.shape {
            Shape::Segment(ends) if mark.role == Role::Signal => Some(ends),
            _ => None,
        });
        ends.collect()
    };
    let [near, far] = [20.0, 30.0].map(|to| signal(seen(vec![line(0.0, to)], &eye)));
    let end = |i: usize| (near[0][1][i] - far[0][1][i]).abs() / near[0][1][i].abs();
    let end_alike = end(0) < 1e-9 && end(1) < 1e-9;
    assert!(end_alike, "both end before the eye: {near:?} {far:?}");
    assert!(near[0][1][0] > near[0][0][0], "{near:?}: not mirrored");
    assert!(signal(seen(vec![line(12.0, 30.0)], &eye)).is_empty());
}

#[test]
fn what_is_kept_of_the_last_space_is_what_would_be_found_anew() {
    let lens = |yaw: f64| Lens::Eye(Orbit::new([0.0; 3], [yaw, 20.0], 8.0, 30.0));
    let line = |role, x: f64| Mark3::new(role, Shape3::Segment([[x, 0.0, -4.0], [x, 0.5, 4.0]]));
    let corners = vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 0.0, 3.0]];
    let wash = Mark3::new(Role::Accent, Shape3::Wash(corners));
    let mut lit = cube();
    lit[2].role = Role::Signal;
    let some = vec![line(Role::Ink, 0.2), wash.clone(), line(Role::Signal, 2.0)];
    let changed = vec![line(Role::Ink, 0.2), line(Role::Signal, 0.5)];
    let longer = [changed.clone(), some.clone()].concat();
    let first = space_of(cube(), some.clone(), &lens(30.0));
    let mut known = Projected::new(&first, &lens(30.0));
    for (facets, marks, yaw) in [
        (cube(), some.clone(), 30.0),
        (cube(), changed.clone(), 30.0),
        (cube(), longer, 30.0),
        (cube(), Vec::new(), 30.0),
        (cube(), some.clone(), 30.0),
        (lit.clone(), some.clone(), 30.0),
        (lit.clone(), changed, 50.0),
        (Vec::new(), some, 50.0),
    ] {
        let solids = known.marks().iter().find_map(faces);
        let is_alike = solids.is_some_and(|solids| *solids.facets == facets[..]);
        let kept = solids.map(|solids| solids.facets.clone());
        let (space, lens) = (space_of(facets, marks, &lens(yaw)), lens(yaw));
        known = known.again(&space, &lens);
        assert_eq!(known.marks()[..], project(&space, &lens)[..]);
        let now = known.marks().iter().find_map(faces);
        if let (Some(kept), Some(now)) = (kept.filter(|_| is_alike && yaw == 30.0), now) {
            let is_kept = kept.are_shared_with(&now.facets);
            assert!(is_kept, "what is alike is drawn once");
        }
    }
}

fn faces(mark: &Mark) -> Option<&crate::figure::Solids> {
    match &mark.shape {
        Shape::Solids(solids) => Some(solids),
        _ => None,
    }
}

/// Of a cube's faces some are not there, and one stands out.
#[test]
fn where_facets_only_look_different_what_is_known_of_them_is_kept() {
    let lens = Lens::Eye(Orbit::new([0.0; 3], [30.0, 20.0], 8.0, 30.0));
    let behind = Mark3::new(
        Role::Ink,
        Shape3::Segment([[-2.0, -2.0, -2.0], [2.0, 2.0, 2.0]]),
    );
    let whole = space_of(cube(), vec![behind], &lens);
    let all = Facets::from(cube());
    let looking = |role: &dyn Fn(usize) -> Option<Role>| Space {
        facets: all.looking((0..all.len()).map(role).collect()),
        ..whole.clone()
    };
    let n_hidden = |marks: &[Mark]| marks.iter().filter(|mark| mark.is_dashed).count();
    let mut known = Projected::new(&looking(&|_| Some(Role::Soft)), &lens);
    for role in [
        &(|i: usize| Some([Role::Soft, Role::Signal][usize::from(i == 2)])) as &dyn Fn(usize) -> _,
        &|i| (i % 2 == 0).then_some(Role::Soft),
        &|i| (i == 0).then_some(Role::Soft),
        &|_| None,
        &|_| Some(Role::Soft),
    ] {
        let space = looking(role);
        known = known.again(&space, &lens);
        assert_eq!(known.marks()[..], project(&space, &lens)[..]);
        if (0..all.len()).all(|i| role(i).is_none()) {
            assert_eq!(
                n_hidden(known.marks()),
                0,
                "what is not there hides nothing"
            );
        }
    }
}
