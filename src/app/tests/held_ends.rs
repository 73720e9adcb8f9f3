//! What is taken hold of where it is drawn.

use super::*;
use crate::figure::Shape3;

#[test]
fn an_end_is_taken_where_its_method_draws_it() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("32-before-the-divide", "an-image-of-what-is-behind");
    bench.command(Command::Seek(0));
    let handles = bench.document().handles();
    let mut ends = handles.into_iter().filter(|it| it.kind().id == "end");
    let end = ends.nth(1).expect("a segment has two ends");
    let place = |bench: &Bench| bench.document().position(end).expect("it lies somewhere");
    let space = bench.app.playback.frames[0]
        .space()
        .expect("a drawing of space");
    let before = place(&bench);
    let drawn = space.marks.iter().filter_map(|mark| match mark.shape {
        Shape3::Dot(at) | Shape3::Ring(at) => Some(at),
        _ => None,
    });
    // Images of ends are farther from them.
    let apart = |at: &[f64; 3]| (0..3).map(|i| (at[i] - before[i]).abs()).sum::<f64>();
    let drawn = drawn.min_by(|a, b| apart(a).total_cmp(&apart(b)));
    let drawn = drawn.expect("it is drawn");
    assert_ne!(drawn, before, "at its foot in the plane of x and w");
    let at = bench.app.stage.on_screen(drawn).expect("it is in sight");
    bench.drag(at, at + vec2(40.0, 0.0));
    let after = place(&bench);
    assert!(after[0] > before[0], "{before:?} {after:?}");
}
