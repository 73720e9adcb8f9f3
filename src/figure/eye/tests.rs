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
