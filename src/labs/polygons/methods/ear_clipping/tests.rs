use super::*;
use crate::labs::polygons::methods::shown_lists::{
    FORK, assert_are_short, assert_names, at, at_step, comb, taken,
};

fn run(polygon: &[[f64; 2]]) -> Box<dyn Run> {
    let polygon = SimplePolygon::new(polygon).unwrap();
    Box::new(Recorded::<EarClipping>::new(polygon, None))
}

#[test]
fn what_blocks_stands_out_in_the_ring_and_what_is_cut_off_goes_to_the_triangles() {
    let blocked = at(&*run(&FORK), "blocked");
    let [ring, triangles] = &blocked.lists[..] else {
        panic!("two lists: {blocked:?}");
    };
    assert_names(ring, None, "V₁ V₂ V₃ V₄ V₅ V₆");
    assert_names(ring, Some(Role::Signal), "V₃ V₅");
    assert_names(ring, Some(Role::Accent), "V₂ V₄");
    assert_names(ring, Some(Role::Discarded), "V₁");
    // In the corner's triangle.
    let inside = Some(Value::Term("ear-inside"));
    assert_eq!(ring.entries[4].details, [inside]);
    assert_names(triangles, Some(Role::Accepted), "V₆V₁V₂");
    assert_eq!(triangles.entries.len(), 4, "with a place for each to come");
    let cut = at(&*run(&FORK), "cut");
    assert_eq!(cut.links.len(), 1);
    assert_eq!(taken(&cut), [[[0, 0], [1, 0]]]);
}

#[test]
fn of_a_long_ring_the_step_s_neighbourhood_is_shown_and_what_comes_into_sight_has_not_changed() {
    let run = run(&comb(100));
    let mut in_sight = Vec::new();
    for step in 0..=run.n_steps() {
        assert_are_short(&at_step(&*run, step));
        let frame = run.frame(step);
        let rows = frame.watch.iter().flat_map(|section| &section.rows);
        let vertices =
            rows.filter(|row| matches!(&row.name, Value::Name(name) if name.starts_with('V')));
        for row in vertices {
            assert!(!row.has_changed(), "step {step}: {row:?}");
            if !in_sight.contains(&row.name) {
                in_sight.push(row.name.clone());
            }
        }
    }
    let n_seen = in_sight.len();
    assert!(n_seen > 50, "the list has scrolled: {n_seen}");
}
