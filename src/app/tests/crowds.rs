//! Very many: vertices that cannot all have a handle, segments of which one is in focus.

use super::*;
use crate::{
    labs::{
        polygons::{PolygonsChange, SceneVertex},
        space::SpaceChange,
    },
    trace::Counts,
};

/// The polygons lab with so many random vertices.
fn crowd(count: usize) -> Bench {
    let mut bench = Bench::polygons();
    bench.change(PolygonsChange::Random { count, seed: 1 });
    bench
}

#[test]
fn of_ten_thousand_vertices_the_near_ones_can_be_taken_hold_of() {
    let mut bench = crowd(10_000);
    assert_eq!(bench.subject().len(), 10_000);
    let vertex = bench.subject()[4321];
    let from = bench.on_screen(vertex);
    bench.frame(0.1, vec![Event::PointerMoved(from)]);
    assert!(bench.app.stage.handle_ids.len() < 100);
    bench.command(Command::Snap(false));
    let to = from + vec2(30.0, 10.0);
    bench.drag(from, to);
    let moved = bench.subject();
    let went_along = |p: &[f64; 2]| (bench.on_screen(*p) - to).length() < 1.0;
    assert!(moved.iter().any(went_along), "the one under the pointer");
    bench.undo();
    assert_eq!(bench.subject()[4321], vertex);
}

#[test]
fn tab_walks_along_a_large_outline() {
    let mut bench = crowd(500);
    let n_others = bench.app.stage.handle_ids.len() - 1;
    for _ in 0..n_others + 3 {
        bench.key(Key::Tab);
    }
    let focused = bench.app.stage.focused.expect("a handle");
    assert_eq!(focused, SceneVertex::Subject(2).handle());
}

#[test]
fn a_long_run_keeps_its_place_without_being_searched() {
    let mut bench = crowd(2000);
    let n_steps = bench.n_steps();
    assert!(n_steps > 4096);
    bench.app.seek(n_steps / 3);
    let tick = bench.app.playback.main().tick(n_steps / 3);
    bench.change(PolygonsChange::Delete(SceneVertex::Subject(7)));
    let position = bench.app.position();
    let part = position as f64 / bench.n_steps() as f64;
    assert!((part - 1.0 / 3.0).abs() < 0.02, "{part}");
    assert_eq!(bench.app.playback.main().tick(position), tick);
}

#[test]
fn the_cost_of_all_segments_stands_under_that_of_the_one() {
    let mut bench = Bench::new(SIZE);
    let said = |bench: &mut Bench| {
        let texts = bench.texts().into_iter().map(|(text, _)| text);
        let of_all = texts.filter(|text| text.starts_with("all "));
        of_all.collect::<Vec<_>>()
    };
    assert!(said(&mut bench).is_empty(), "the one is all there is");
    let &lines::Scene { method, window, .. } = bench.scene();
    let segments = lines::random_segments(&window, 200, 5);
    let scene = |segments| Scene::from(lines::Scene::new(method, window, segments).expect("some"));
    let of_one = |&segment| scene(vec![segment]).document().record();
    let sum: Counts = segments
        .iter()
        .map(|segment| of_one(segment)[0].counts_at(usize::MAX))
        .sum();
    bench.edit(Edit::Replace(scene(segments.clone())));
    let said = said(&mut bench).join(" ");
    for n in [200, sum.div, sum.mul, sum.add, sum.cmp] {
        let n = Catalog::of(Lang::En).value(&Value::Count(n as usize));
        assert!(said.contains(&n), "{n} is not in {said:?}");
    }
}

#[test]
fn undo_of_a_street_shows_the_few_objects_from_where_they_were_seen() {
    let mut bench = Bench::lab("frustum");
    let place = |bench: &Bench| bench.app.stage.on_screen([-6.5, 0.8, 0.5]);
    let before = place(&bench).expect("an object is in sight");
    let street = SpaceChange::Street {
        count: 2000,
        seed: 1,
    };
    bench.edit(Edit::Own(Arc::new(street)));
    assert_ne!(
        place(&bench),
        Some(before),
        "a street is seen from farther away"
    );
    bench.undo();
    bench.settle();
    let after = place(&bench).expect("it is in sight again");
    assert!((after - before).length() < 1.0, "{before:?} {after:?}");
}
