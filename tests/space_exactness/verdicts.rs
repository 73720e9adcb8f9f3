//! The change that a verdict names turns it, and a little less does not.

use clipscope::{
    algo::cull::{Containment, SphereCull, SphereCullInput, sphere_verdict},
    geom::{Camera, Sphere, ViewVolume},
    trace::silent,
};
use proptest::prelude::*;

fn moved(input: &SphereCullInput, plane_idx: usize, by: f64) -> bool {
    let plane = &input.planes[plane_idx];
    let [x, y, z] =
        std::array::from_fn(|i| input.sphere.center()[i] + by * plane.normal()[i] / plane.length());
    let sphere = Sphere::new([x, y, z, input.sphere.radius()]).expect("finite");
    let planes = input.planes.clone();
    silent::<SphereCull>(&SphereCullInput { planes, sphere }).class == Containment::Outside
}

proptest! {
    #[test]
    fn a_sphere_turns_where_it_is_said(
        center in prop::array::uniform3(-12.0..12.0_f64),
        radius in 0.1..3.0_f64,
        fov in 20.0..100.0_f64,
    ) {
        let volume = ViewVolume::perspective(fov, 1.5, 1.0, 12.0).expect("a volume");
        let camera = Camera::new([0.5, 1.0, 6.0], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
        let [x, y, z] = center;
        let sphere = Sphere::new([x, y, z, radius]).expect("a sphere");
        let input = SphereCullInput { planes: camera.planes_in_world().to_vec(), sphere };
        let verdict = sphere_verdict(&input).expect("there are planes");
        let is_culled = verdict.class == Containment::Outside;
        if let Some(turn) = verdict.turn {
            prop_assert_eq!(moved(&input, verdict.plane_idx, turn + turn.signum() * 1e-6), !is_culled);
            prop_assert_eq!(moved(&input, verdict.plane_idx, 0.99 * turn), is_culled);
        } else {
            // No move along this normal: some are tried.
            for step in 0..200 {
                prop_assert!(moved(&input, verdict.plane_idx, f64::from(step) * 0.1));
            }
        }
    }
}
