//! Polygons with more vertices than can all have a handle.

use egui::{Event, Key, vec2};

use super::{Bench, ctrl};
use crate::{
    app::Command,
    labs::polygons::{PolygonsChange, SceneVertex},
};

#[test]
fn of_ten_thousand_vertices_the_near_ones_can_be_taken_hold_of() {
    let mut bench = Bench::polygons();
    bench.edit(PolygonsChange::Random {
        count: 10_000,
        seed: 1,
    });
    assert_eq!(bench.subject().len(), 10_000);
    let vertex = bench.subject()[4321];
    let from = bench.on_screen(vertex);
    bench.frame(0.1, vec![Event::PointerMoved(from)]);
    assert!(bench.app.stage.handle_ids.len() < 100);
    bench.command(Command::Snap(false));
    bench.drag(from, from + vec2(30.0, 10.0));
    let moved = bench.subject();
    let n_moved = moved
        .iter()
        .filter(|p| (bench.on_screen(**p) - from - vec2(30.0, 10.0)).length() < 1.0);
    assert!(
        n_moved.count() >= 1,
        "the vertex under the pointer went along"
    );
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.subject()[4321], vertex);
}

#[test]
fn tab_walks_along_a_large_outline() {
    let mut bench = Bench::polygons();
    bench.edit(PolygonsChange::Random {
        count: 500,
        seed: 1,
    });
    let n_others = bench.app.stage.handle_ids.len() - 1;
    for _ in 0..n_others + 3 {
        bench.key(Key::Tab);
    }
    let focused = bench.app.stage.focused.expect("a handle");
    assert_eq!(focused, SceneVertex::Subject(2).handle());
}

#[test]
fn a_long_run_keeps_its_place_without_being_searched() {
    let mut bench = Bench::polygons();
    bench.edit(PolygonsChange::Random {
        count: 2000,
        seed: 1,
    });
    let n_steps = bench.app.playback.transport().n_steps();
    assert!(n_steps > 4096);
    bench.app.seek(n_steps / 3);
    let tick = bench.app.playback.main().tick(n_steps / 3);
    bench.edit(PolygonsChange::Delete(SceneVertex::Subject(7)));
    let now = bench.app.playback.transport();
    let part = now.position() as f64 / now.n_steps() as f64;
    assert!((part - 1.0 / 3.0).abs() < 0.02, "{part}");
    assert_eq!(bench.app.playback.main().tick(now.position()), tick);
}
