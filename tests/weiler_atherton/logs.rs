//! Event logs of worked examples, one JSON object a line, as `clipscope trace` prints them. After a change that is
//! meant, `UPDATE_SNAPSHOTS=1 cargo test --no-default-features --test all weiler_atherton::` writes them anew.

use clipscope::algo::polygon::weiler_atherton::{WeilerAtherton, WeilerAthertonInput};

use super::shapes;
use crate::shared::event_log;

type Outline<'a> = &'a [[i64; 2]];

fn check(name: &str, subject: Outline, holes: &[Outline], clip: Outline) {
    let holes: Vec<shapes::Outline> = holes.iter().map(|hole| hole.to_vec()).collect();
    let input = WeilerAthertonInput {
        subject: shapes::region(subject, &holes).expect("a region"),
        clip: shapes::simple(clip).expect("simple"),
    };
    event_log::check::<WeilerAtherton>(&format!("weiler_atherton/{name}"), input);
}

#[test]
fn worked_examples() {
    let slope: Outline = &[[-2, -1], [3, 0], [0, 3]];
    let square: Outline = &[[0, 0], [4, 0], [4, 4], [0, 4]];
    let diamond: Outline = &[[4, 2], [6, 4], [4, 6], [2, 4]];
    let large: Outline = &[[0, 0], [8, 0], [8, 8], [0, 8]];
    check("two-crossings", slope, &[], square);
    check("identical", square, &[], square);
    check(
        "edge-in-common",
        square,
        &[],
        &[[4, 1], [6, 0], [6, 9], [4, 3]],
    );
    check(
        "pinched",
        large,
        &[diamond],
        &[[2, 1], [6, 1], [6, 7], [2, 7]],
    );
}
