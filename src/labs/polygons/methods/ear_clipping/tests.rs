use super::*;
use crate::{
    figure::{ListColumn, Lists, Role, Run},
    text::{Catalog, Lang},
};

const FORK: [[f64; 2]; 6] = [
    [6.0, -3.0],
    [7.0, 0.0],
    [6.0, 3.0],
    [-2.0, 2.0],
    [6.0, 1.0],
    [2.0, -2.0],
];

fn run(polygon: &[[f64; 2]]) -> Box<dyn Run> {
    crate::labs::record::<EarClipping>(SimplePolygon::new(polygon).unwrap())
}

fn at(run: &dyn Run, moment: &str) -> Lists {
    let step = run.find(&moment.parse().unwrap()).unwrap();
    let views = run.frame(step).views;
    match views.into_iter().map(|view| view.body).nth(1) {
        Some(Body::Lists(lists)) => lists,
        other => panic!("no ring beside the drawing: {other:?}"),
    }
}

/// Names of the entries of a list that have a role, or of all.
fn names_of(list: &ListColumn, role: Option<Role>) -> String {
    let catalog = Catalog::of(Lang::En);
    let entries = list.entries.iter();
    let entries = entries.filter(|entry| role.is_none_or(|role| role == entry.role));
    let names: Vec<String> = entries.map(|entry| catalog.value(&entry.name)).collect();
    names.join(" ")
}

#[test]
fn what_blocks_stands_out_in_the_ring_and_what_is_cut_off_goes_to_the_triangles() {
    let blocked = at(&*run(&FORK), "blocked");
    let [ring, triangles] = &blocked.lists[..] else {
        panic!("two lists: {blocked:?}");
    };
    assert_eq!(names_of(ring, None), "V₁ V₂ V₃ V₄ V₅ V₆");
    assert_eq!(names_of(ring, Some(Role::Signal)), "V₃ V₅");
    assert_eq!(names_of(ring, Some(Role::Accent)), "V₂ V₄");
    assert_eq!(names_of(ring, Some(Role::Discarded)), "V₁");
    let inside = Some(Value::Term("ear-inside"));
    assert_eq!(
        ring.entries[4].details,
        [inside],
        "in the corner's triangle"
    );
    assert_eq!(names_of(triangles, Some(Role::Accepted)), "V₆V₁V₂");
    assert_eq!(triangles.entries.len(), 4, "with a place for each to come");
    let cut = at(&*run(&FORK), "cut");
    let [link] = cut.links[..] else {
        panic!("one link: {cut:?}");
    };
    assert_eq!((link.from, link.to), ([0, 0], [1, 0]));
}

#[test]
fn of_a_long_ring_the_step_s_neighbourhood_is_shown() {
    let teeth = (0..100).map(|i| {
        [
            if i % 2 == 0 { 3.0 } else { 5.0 },
            2.0 - f64::from(i) / 25.0,
        ]
    });
    let comb: Vec<[f64; 2]> = [[7.0, -2.5], [7.0, 2.5]].into_iter().chain(teeth).collect();
    let run = run(&comb);
    for step in 0..=run.n_steps() {
        let frame = run.frame(step);
        let Some(Body::Lists(lists)) = frame.views.get(1).map(|view| &view.body) else {
            panic!("no ring at step {step}");
        };
        for list in &lists.lists {
            assert!(list.entries.len() <= 40, "step {step}");
            assert!(list.focus.is_none_or(|focus| focus < list.entries.len()));
        }
    }
}
