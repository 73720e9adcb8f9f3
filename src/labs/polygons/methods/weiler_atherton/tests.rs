use super::*;
use crate::{
    figure::{ListLink, Lists, Role, Run},
    labs::{
        polygons::methods::shown_lists::{FORK, assert_are_short, at, at_step, comb, names_of},
        recorded::Recorded,
    },
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

fn taken(lists: &Lists) -> Vec<ListLink> {
    let links = lists.links.iter();
    links
        .filter(|link| link.role == Role::Signal)
        .copied()
        .collect()
}

#[test]
fn both_lists_grow_where_their_entries_will_be() {
    let run = run(&FORK, &[]);
    let start = at(&*run, "start");
    assert_eq!(
        names_of(&start.lists[0], Some(Role::Faint)),
        "S₁ S₂ S₃ S₄ S₅ S₆"
    );
    let found = at(&*run, "found");
    assert_eq!(names_of(&found.lists[0], None), "S₁ S₂ S₃ I₁ S₄ S₅ S₆");
    assert_eq!(names_of(&found.lists[0], Some(Role::Signal)), "I₁");
    assert_eq!(names_of(&found.lists[0], Some(Role::Faint)), "S₄ S₅ S₆");
    let inserted = at(&*run, "inserted #2");
    assert_eq!(names_of(&inserted.lists[1], None), "C₁ C₂ I₄ I₃ C₃ C₄");
    let [link] = taken(&inserted)[..] else {
        panic!("one link is new: {inserted:?}");
    };
    assert_eq!((link.from, link.to), ([0, 7], [1, 3]));
}

#[test]
fn the_walk_is_in_both_lists() {
    let run = run(&FORK, &[]);
    let switch = at(&*run, "switch clip");
    assert_eq!(
        names_of(&switch.lists[0], None),
        "S₁ S₂ S₃ I₁ S₄ I₂ S₅ I₃ S₆ I₄"
    );
    assert_eq!(names_of(&switch.lists[1], None), "C₁ C₂ I₄ I₃ I₂ I₁ C₃ C₄");
    assert_eq!(names_of(&switch.lists[0], Some(Role::Accent)), "I₁ S₄");
    assert_eq!(
        names_of(&switch.lists[1], Some(Role::Accent)),
        "",
        "not there yet"
    );
    for list in [0, 1] {
        assert_eq!(names_of(&switch.lists[list], Some(Role::Signal)), "I₂");
    }
    let [link] = taken(&switch)[..] else {
        panic!("one link is taken: {switch:?}");
    };
    assert_eq!((link.from, link.to), ([0, 5], [1, 4]));
    let closed = at(&*run, "closed");
    let [link] = taken(&closed)[..] else {
        panic!("the walk comes back by a link: {closed:?}");
    };
    assert_eq!((link.from, link.to), ([1, 5], [0, 3]));
    let end = at(&*run, "end");
    assert_eq!(
        names_of(&end.lists[0], Some(Role::Accepted)),
        "I₁ S₄ I₂ I₃ S₆ I₄"
    );
    assert_eq!(names_of(&end.lists[1], Some(Role::Accepted)), "I₄ I₃ I₂ I₁");
    assert_eq!(
        names_of(&end.lists[0], Some(Role::Discarded)),
        "S₁ S₂ S₃ S₅"
    );
}

#[test]
fn each_hole_is_a_ring_of_its_own() {
    let around = [[-3.0, -2.0], [7.0, -2.0], [7.0, 2.0], [-3.0, 2.0]];
    let hole = [[2.0, 0.0], [6.0, 1.0], [6.0, -1.0]];
    let lists = at(&*run(&around, &[&hole]), "end");
    let [subject, clip] = &lists.lists[..] else {
        panic!("two lists: {lists:?}");
    };
    assert_eq!(
        names_of(&lists.lists[0], None),
        "S₁ I₁ S₂ S₃ I₂ S₄ S₅ I₃ S₆ S₇ I₄"
    );
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
