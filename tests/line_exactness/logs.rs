//! Event logs of worked examples, one JSON object a line, as `clipscope trace` prints them. After a change
//! that is meant, `UPDATE_SNAPSHOTS=1 cargo test --no-default-features --test all line_exactness::` writes them anew.

use clipscope::{
    algo::line::{
        BitOrder, BruteForce, CohenSutherland, CohenSutherlandInput, CyrusBeck, CyrusBeckInput,
        LiangBarsky, NichollLeeNicholl, WindowInput,
    },
    geom::{ConvexPolygon, Segment, Window},
    trace::Method,
};
use serde::Serialize;

use crate::shared::event_log;

fn check<M: Method<Event: Serialize>>(name: &str, input: M::Input) {
    event_log::check::<M>(&format!("line/{name}"), input);
}

/// The slides' practice example.
fn practice() -> WindowInput {
    WindowInput {
        window: Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window"),
        segment: Segment::new(-2.0, -1.0, 2.0, 1.5).expect("finite"),
    }
}

fn across(x1: f64, y1: f64, x2: f64, y2: f64) -> WindowInput {
    let segment = Segment::new(x1, y1, x2, y2).expect("finite");
    WindowInput {
        segment,
        ..practice()
    }
}

fn coded(WindowInput { window, segment }: WindowInput) -> CohenSutherlandInput {
    let bit_order = BitOrder::Tbrl;
    CohenSutherlandInput {
        window,
        segment,
        bit_order,
    }
}

#[test]
fn brute_force() {
    check::<BruteForce>("brute-force-practice", practice());
    check::<BruteForce>("brute-force-parallel", across(0.5, 2.0, 0.5, -3.0));
}

#[test]
fn cohen_sutherland() {
    check::<CohenSutherland>("cohen-sutherland-practice", coded(practice()));
    check::<CohenSutherland>(
        "cohen-sutherland-four-cuts",
        coded(across(-1.5, -3.0, 1.5, 3.0)),
    );
    check::<CohenSutherland>(
        "cohen-sutherland-reject",
        coded(across(2.0, 2.0, -2.0, 3.0)),
    );
}

#[test]
fn liang_barsky() {
    check::<LiangBarsky>("liang-barsky-practice", practice());
    check::<LiangBarsky>("liang-barsky-touch", across(-2.0, 0.0, 0.0, 2.0));
    check::<LiangBarsky>("liang-barsky-parallel-reject", across(0.5, 2.0, 0.5, 3.0));
}

#[test]
fn cyrus_beck() {
    let diamond = [[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]];
    let segment = Segment::new(-3.0, 1.0, 1.0, 1.0).expect("finite");
    let clip = ConvexPolygon::new(&diamond).expect("convex");
    check::<CyrusBeck>("cyrus-beck-diamond", CyrusBeckInput { clip, segment });
    let WindowInput { window, segment } = practice();
    let clip = window.into();
    check::<CyrusBeck>("cyrus-beck-practice", CyrusBeckInput { clip, segment });
}

#[test]
fn nicholl_lee_nicholl() {
    check::<NichollLeeNicholl>("nicholl-lee-nicholl-practice", practice());
    check::<NichollLeeNicholl>(
        "nicholl-lee-nicholl-three-corners",
        across(-3.0, -2.0, 3.0, 2.5),
    );
    check::<NichollLeeNicholl>("nicholl-lee-nicholl-miss", across(-2.0, 0.0, 0.0, 3.0));
}
