//! Very many: vertices that cannot all have a handle, segments of which one is in focus.

use egui::{Event, Key, vec2};

use super::{Bench, SIZE, ctrl};
use crate::{
    app::Command,
    labs::{
        Edit, Scene, lines,
        polygons::{PolygonsChange, SceneVertex},
    },
    text::{Catalog, Lang, Value},
    trace::Counts,
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

#[test]
fn the_cost_of_all_segments_stands_under_that_of_the_one() {
    let mut bench = Bench::new(SIZE);
    let said = |bench: &mut Bench| {
        let texts = bench.texts().into_iter().map(|(text, _)| text);
        texts
            .filter(|text| text.starts_with("all "))
            .collect::<Vec<_>>()
    };
    assert!(said(&mut bench).is_empty(), "the one is all there is");
    let scene = bench.app.scene().get::<lines::Scene>();
    let scene = scene.expect("the first lab");
    let segments = lines::random_segments(&scene.window, 200, 5);
    let scene = lines::Scene::new(scene.method, scene.window, segments.clone());
    let scene = scene.expect("segments");
    let of_one = |&segment| {
        let alone = lines::Scene::new(scene.method, scene.window, vec![segment]);
        Scene::from(alone.expect("a segment")).document().record()
    };
    let sum: Counts = segments
        .iter()
        .map(|segment| of_one(segment)[0].counts_at(usize::MAX))
        .sum();
    bench.command(Command::Edit(Edit::Replace(scene.into()), None));
    let said = said(&mut bench).join(" ");
    for n in [200, sum.div, sum.mul, sum.add, sum.cmp] {
        let n = Catalog::of(Lang::En).value(&Value::Count(n as usize));
        assert!(said.contains(&n), "{n} is not in {said:?}");
    }
}
