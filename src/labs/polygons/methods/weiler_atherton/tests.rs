use super::*;
use crate::geom::SimplePolygon;
use crate::labs::polygons::methods::shown_lists::{
    FORK, assert_are_short, assert_names, at, at_step, comb, taken,
};

const WINDOW: [[f64; 2]; 4] = [[-4.0, -3.0], [4.0, -3.0], [4.0, 3.0], [-4.0, 3.0]];

fn run(subject: &[[f64; 2]], holes: &[&[[f64; 2]]]) -> Box<dyn Run> {
    let simple = |points: &[[f64; 2]]| SimplePolygon::new(points).unwrap();
    let holes = holes.iter().map(|hole| simple(hole)).collect();
    let input = Input {
        subject: Region::new(simple(subject), holes).unwrap(),
        clip: simple(&WINDOW),
    };
    Box::new(Recorded::<WeilerAtherton>::new(input, None))
}

#[test]
fn both_lists_grow_where_their_entries_will_be() {
    let run = run(&FORK, &[]);
    let start = at(&*run, "start");
    assert_names(&start.lists[0], Some(Role::Faint), "S₁ S₂ S₃ S₄ S₅ S₆");
    let found = at(&*run, "found");
    assert_names(&found.lists[0], None, "S₁ S₂ S₃ I₁ S₄ S₅ S₆");
    assert_names(&found.lists[0], Some(Role::Signal), "I₁");
    assert_names(&found.lists[0], Some(Role::Faint), "S₄ S₅ S₆");
    let inserted = at(&*run, "inserted #2");
    assert_names(&inserted.lists[1], None, "C₁ C₂ I₄ I₃ C₃ C₄");
    assert_eq!(taken(&inserted), [[[0, 7], [1, 3]]], "one link is new");
}

#[test]
fn the_walk_is_in_both_lists() {
    let run = run(&FORK, &[]);
    let switch = at(&*run, "switch clip");
    let [subject, clip] = &switch.lists[..] else {
        panic!("two lists: {switch:?}");
    };
    assert_names(subject, None, "S₁ S₂ S₃ I₁ S₄ I₂ S₅ I₃ S₆ I₄");
    assert_names(clip, None, "C₁ C₂ I₄ I₃ I₂ I₁ C₃ C₄");
    assert_names(subject, Some(Role::Accent), "I₁ S₄");
    // The walk has not been there yet.
    assert_names(clip, Some(Role::Accent), "");
    assert_names(subject, Some(Role::Signal), "I₂");
    assert_names(clip, Some(Role::Signal), "I₂");
    assert_eq!(taken(&switch), [[[0, 5], [1, 4]]], "one link is taken");
    let closed = at(&*run, "closed");
    assert_eq!(taken(&closed), [[[1, 5], [0, 3]]], "the walk comes back");
    let end = at(&*run, "end");
    assert_names(&end.lists[0], Some(Role::Accepted), "I₁ S₄ I₂ I₃ S₆ I₄");
    assert_names(&end.lists[1], Some(Role::Accepted), "I₄ I₃ I₂ I₁");
    assert_names(&end.lists[0], Some(Role::Discarded), "S₁ S₂ S₃ S₅");
}

#[test]
fn each_hole_is_a_ring_of_its_own() {
    let around = [[-3.0, -2.0], [7.0, -2.0], [7.0, 2.0], [-3.0, 2.0]];
    let hole = [[2.0, 0.0], [6.0, 1.0], [6.0, -1.0]];
    let lists = at(&*run(&around, &[&hole]), "end");
    let [subject, clip] = &lists.lists[..] else {
        panic!("two lists: {lists:?}");
    };
    assert_names(subject, None, "S₁ I₁ S₂ S₃ I₂ S₄ S₅ I₃ S₆ S₇ I₄");
    assert_eq!((&subject.breaks[..], &clip.breaks[..]), (&[6][..], &[][..]));
}

#[test]
fn of_long_lists_the_step_s_neighbourhood_is_shown() {
    let run = run(&comb(400), &[]);
    for step in (0..=run.n_steps()).step_by(37) {
        assert_are_short(&at_step(&*run, step));
    }
    let switch = at(&*run, "switch clip #30");
    assert_eq!(taken(&switch).len(), 1, "its ends are both in sight");
    assert!(switch.lists.iter().all(|list| list.n_before > 0));
}
