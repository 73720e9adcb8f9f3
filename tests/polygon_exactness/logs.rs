//! Event logs of worked examples, one JSON object a line, as `clipscope trace` prints them. After a change
//! that is meant, `UPDATE_SNAPSHOTS=1 cargo test --no-default-features --test polygon_exactness` writes them anew.

use std::{fs, path::PathBuf};

use clipscope::{
    algo::polygon::{Pipeline, SutherlandHodgman, SutherlandHodgmanInput, Textured},
    geom::ConvexPolygon,
    trace::{Algorithm, Trace},
};
use serde::Serialize;

use super::{input, points, unit};

fn check<A: Algorithm<Event: Serialize>>(name: &str, input: A::Input) {
    let trace = Trace::<A>::record(input);
    let mut log = String::new();
    for event in trace.events() {
        log += &serde_json::to_string(event).expect("an event is JSON");
        log += "\n";
    }
    let counts = trace.counts_at(trace.events().len());
    log += &serde_json::to_string(&counts).expect("counts are JSON");
    log += "\n";
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join(format!("tests/snapshots/polygon/{name}.ndjson"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder is made");
        fs::write(&path, &log).expect("the log is written");
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(
        log,
        expected,
        "the events of {name}, as in {}",
        path.display()
    );
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
