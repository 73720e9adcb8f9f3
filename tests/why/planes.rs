//! A plane, a point's distance from it, and where a segment meets it.

use clipscope::{
    algo::{
        volume::{LineInput, PlaneLine, signed_distance},
        why::{Shadow, ShadowFact, ShadowInput, Similar, SimilarFact, SimilarInput},
    },
    geom::Plane,
    trace::silent,
};
use proptest::prelude::*;

use super::{near, shown};

fn places() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3((-20..20_i32).prop_map(f64::from))
}

fn planes() -> impl Strategy<Value = Plane> {
    (places(), -20..20_i32).prop_filter_map("a normal", |([x, y, z], d)| {
        Plane::new([x, y, z, f64::from(d)]).ok()
    })
}

/// The same plane with a normal of length 1.
fn unit(plane: &Plane) -> Plane {
    let [x, y, z] = plane.unit_normal();
    Plane::new([x, y, z, plane.d() / plane.length()]).expect("as finite as it was")
}

proptest! {
    /// From any point of the plane the shadows add up to the distance, though each of them is another one.
    #[test]
    fn shadows_add_up_to_the_distance(plane in planes(), point in places(), from in [places(), places()]) {
        let onto = |at: [f64; 3]| {
            let d = signed_distance::<f64>(&plane, at);
            let n = plane.unit_normal();
            std::array::from_fn(|i| at[i] - d * n[i])
        };
        let input = ShadowInput { plane: unit(&plane), point, from: from.map(onto) };
        let number = shown::<Shadow>(&input);
        let distance = signed_distance::<f64>(&plane, point);
        for fact in [ShadowFact::Sum, ShadowFact::Distance, ShadowFact::Elsewhere] {
            let number = number(fact).expect("shown");
            prop_assert!(near(number, distance), "{fact:?}: {number} is {distance}");
        }
        let pieces = ShadowFact::STEPS.map(|step| number(step).is_some());
        prop_assert_eq!(pieces, plane.normal().map(|n| n != 0.0));
    }

    /// The ring on the segment and the plane's tick on the ruler divide both alike, and the clipper cuts there, too.
    #[test]
    fn the_plane_divides_segment_and_ruler_alike(plane in planes(), ends in [places(), places()]) {
        let input = SimilarInput { plane, ends };
        let number = shown::<Similar>(&input);
        let [d1, d2] = [SimilarFact::D1, SimilarFact::D2].map(|fact| number(fact).expect("shown"));
        let Some(t) = number(SimilarFact::T) else {
            prop_assert_eq!(d1, d2);
            prop_assert_eq!(number(SimilarFact::Parallel), Some(d1));
            return Ok(());
        };
        prop_assert!(near(t * (d2 - d1), -d1));
        prop_assert!(near(number(SimilarFact::Piece).unwrap() * -d1, t));
        let cut = std::array::from_fn(|i| ends[0][i] + t * (ends[1][i] - ends[0][i]));
        prop_assert!(signed_distance::<f64>(&plane, cut).abs() < 1e-9);
        if d1 < 0.0 && d2 >= 0.0 {
            let left = silent::<PlaneLine>(&LineInput { bounds: vec![plane], ends }).expect("an end inside");
            prop_assert!((0..3).all(|i| near(left[0][i], cut[i])), "{:?} is {:?}", left[0], cut);
        }
    }
}
