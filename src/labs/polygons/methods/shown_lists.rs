//! What the tests of methods with lists ask of the view beside the drawing.

use crate::{
    figure::{Body, ListColumn, Lists, Role, Run},
    text::{Catalog, Lang},
};

/// Six vertices with two prongs to the left, the upper one longer.
pub const FORK: [[f64; 2]; 6] = [
    [6.0, -3.0],
    [7.0, 0.0],
    [6.0, 3.0],
    [-2.0, 2.0],
    [6.0, 1.0],
    [2.0, -2.0],
];

pub fn comb(n: u32) -> Vec<[f64; 2]> {
    let teeth = (0..n).map(|i| {
        let x = if i % 2 == 0 { 3.0 } else { 5.0 };
        [x, 2.0 - 4.0 * f64::from(i) / f64::from(n)]
    });
    [[7.0, -2.5], [7.0, 2.5]].into_iter().chain(teeth).collect()
}

pub fn at(run: &dyn Run, moment: &str) -> Lists {
    let step = run.find(&moment.parse().unwrap()).unwrap();
    at_step(run, step)
}

pub fn at_step(run: &dyn Run, step: usize) -> Lists {
    let views = run.frame(step).views;
    match views.into_iter().map(|view| view.body).nth(1) {
        Some(Body::Lists(lists)) => lists,
        other => panic!("no lists beside the drawing at step {step}: {other:?}"),
    }
}

/// The names of a list's entries, of those in this role.
#[track_caller]
pub fn assert_names(list: &ListColumn, role: Option<Role>, expected: &str) {
    let catalog = Catalog::of(Lang::En);
    let entries = list.entries.iter();
    let entries = entries.filter(|entry| role.is_none_or(|role| role == entry.role));
    let names: Vec<String> = entries.map(|entry| catalog.value(&entry.name)).collect();
    assert_eq!(names.join(" "), expected);
}

/// The links that are this step's: where from, where to.
pub fn taken(lists: &Lists) -> Vec<[[usize; 2]; 2]> {
    let taken = lists.links.iter().filter(|link| link.role == Role::Signal);
    taken.map(|link| [link.from, link.to]).collect()
}

pub fn assert_are_short(lists: &Lists) {
    for list in &lists.lists {
        assert!(list.entries.len() <= 40, "{} entries", list.entries.len());
        assert!(list.focus.is_none_or(|focus| focus < list.entries.len()));
    }
}
