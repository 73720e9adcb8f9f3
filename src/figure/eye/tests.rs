use super::*;
use crate::figure::{Facets, Mark3, Role, Shape3};

/// A view in which a marked line of length 2 lies in this direction, with its length beside it.
fn drawing(to: [f64; 3], home: Orbit) -> View {
    let line = Mark3::new(Role::Signal, Shape3::Segment([[0.0; 3], to]));
    let space = Space {
        title: None,
        seer: Seer::Eye(home),
        facets: Facets::default(),
        edges: [].into(),
        marks: vec![line.labelled(crate::text::Value::Count(2))],
    };
    View::new("observer", Body::Space(space))
}

fn found(to: [f64; 3], home: Orbit) -> Orbit {
    let mut views = vec![drawing(to, home)];
    let mut prospect = Prospect::default();
    prospect.add(&views);
    let eyes = prospect.eyes(&[&views], 1, None);
    eyes.turn(&mut views);
    let (_, eye, _) = spaces(&views).next().expect("a view of an eye");
    eye
}

#[test]
fn an_eye_goes_round_until_a_length_is_seen_and_no_further() {
    let home = Orbit::new([0.0; 3], [10.0, 20.0], 10.0, 24.0);
    let across = found([2.0, 0.0, 0.0], home);
    assert_eq!(across.angles_deg(), home.angles_deg(), "it is seen already");
    let along = found([0.0, 0.0, 2.0], home);
    assert_ne!(along.angles_deg(), home.angles_deg());
    let judged = judged(
        spaces(&[drawing([0.0, 0.0, 2.0], home)])
            .next()
            .expect("a view")
            .2,
        along,
        200.0,
    );
    assert_eq!(judged.shortfalls, [0.0; 4]);
}

#[test]
fn what_is_marked_just_fits_into_the_frame() {
    for to in [
        [2.0, 0.0, 0.0],
        [0.0, 3.0, 0.5],
        [0.0, 0.0, -40.0],
        [1e-3, 2e-3, 0.0],
    ] {
        let home = Orbit::new([5.0; 3], [-30.0, 25.0], 3.0, 24.0);
        let eye = found(to, home);
        let views = [drawing(to, home)];
        let (.., space) = spaces(&views).next().expect("a view");
        let Judged { framed, marked, .. } = judged(space, eye, 200.0);
        for at in marked {
            let is_framed = |i: usize| framed.iter().any(|end| end[i].abs() >= at[i].abs());
            assert!(is_framed(0) && is_framed(1), "{to:?}: {at:?}");
        }
        let most = |i: usize| framed.iter().map(|at| at[i].abs()).fold(0.0, f64::max);
        let sides = [most(0) / eye.aspect(), most(1)];
        assert!(sides.iter().all(|side| *side <= 1.0), "{to:?}: {sides:?}");
        assert!(sides.iter().any(|side| *side > 0.9), "{to:?}: {sides:?}");
    }
}

#[test]
fn an_inset_stands_in_the_emptiest_corner_and_is_smaller_where_all_are_taken() {
    let drawing = Slot::new([0.0; 2], [400.0, 300.0]);
    let inset = drawing.inset([100.0, 100.0], 10.0);
    let among = |places: Vec<[f32; 2]>| {
        emptiest(drawing, inset, 20.0, |slot| {
            count(places.iter().copied(), slot)
        })
    };
    assert_eq!(among(vec![]), inset, "free");
    let right = among(vec![[350.0, 250.0], [350.0, 50.0]]);
    assert!(right.max[0] < 200.0, "both corners on the right are taken");
    let beside = among(vec![[286.0, 250.0]]);
    assert!(beside.max[0] < 200.0, "a marker would reach into it");
    let around = |at: [f32; 2]| vec![at; 40];
    let corners = [
        [300.0, 200.0],
        [100.0, 200.0],
        [300.0, 120.0],
        [100.0, 150.0],
    ];
    let small = among(corners.into_iter().flat_map(around).collect());
    assert!(small.size()[0] < 90.0, "{small:?}");
    let dense: Vec<[f32; 2]> = (0..400_u16)
        .flat_map(|x| (0..30_u16).map(move |y| [f32::from(x), 10.0 * f32::from(y)]))
        .collect();
    assert_eq!(
        among(dense).size(),
        inset.size(),
        "smaller covers much all the same"
    );
}
