//! Event logs of worked examples, one JSON object a line, as `clipscope trace` prints them. After a change
//! that is meant, `UPDATE_SNAPSHOTS=1 cargo test --no-default-features --test all polygon_exactness::` writes them anew.

use clipscope::{
    algo::polygon::{Pipeline, SutherlandHodgman, SutherlandHodgmanInput, Textured},
    geom::ConvexPolygon,
    trace::Method,
};
use serde::Serialize;

use super::{input, points, unit};
use crate::shared::event_log;

fn check<M: Method<Event: Serialize>>(name: &str, input: M::Input) {
    event_log::check::<M>(&format!("polygon/{name}"), input);
}

/// A triangle whose crossings are decimals that terminate.
fn triangle() -> SutherlandHodgmanInput {
    input(&unit(), points(&[[-2.0, -0.5], [0.5, 0.0], [-0.5, 2.0]]))
}

#[test]
fn sutherland_hodgman() {
    check::<SutherlandHodgman>("sutherland_hodgman", triangle());
    let at_uv = triangle()
        .vertices
        .into_iter()
        .zip([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    let textured = at_uv.map(|(at, uv)| Textured { at, uv }).collect();
    check::<SutherlandHodgman<Textured>>("sutherland_hodgman_textured", input(&unit(), textured));
    let region = ConvexPolygon::new(&[[0.0, -1.0], [1.0, 0.0], [-1.0, 1.0]])
        .expect("convex")
        .into();
    check::<SutherlandHodgman>(
        "sutherland_hodgman_oblique",
        input(&region, triangle().vertices),
    );
}

#[test]
fn pipeline() {
    check::<Pipeline>("pipeline", triangle());
}
