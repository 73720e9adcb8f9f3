//! What a press takes hold of is what is lit, and what is dragged stays in sight.

use super::{hands::ends, *};

#[test]
fn what_is_lit_at_a_corner_is_what_a_press_there_takes() {
    let mut bench = Bench::course(ROOMY);
    bench.open_step("41-a-tree-of-planes", "no-cut");
    bench.settle();
    let handles = bench.document().handles();
    let before = bench.app.scene().clone();
    let mut n_taken = 0;
    let all = handles.iter().enumerate();
    for (nth, _) in all.filter(|(_, it)| it.kind().id == "object-corner") {
        let from = bench.handle_at(nth);
        bench.point(from);
        let lit = bench.app.stage.lit.expect("a corner is lit");
        bench.drag(from, from + vec2(15.0, 15.0));
        let moved = crate::labs::moved(&before, bench.app.scene());
        let is_lit = |handle: &Handle| handle.link() == Some(lit);
        assert!(moved.iter().all(is_lit), "{moved:?}, but {lit:?} was lit");
        n_taken += moved.len();
        bench.edit(Edit::Replace(before.clone()));
        bench.settle();
    }
    assert!(n_taken >= 6, "{n_taken}");
}

#[test]
fn a_point_that_is_dragged_does_not_leave_the_picture() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("03-outcodes", "all-ones");
    bench.settle();
    let rect = {
        let id = bench.app.stage.canvas_ids[0];
        bench.ctx.read_response(id).expect("it is drawn").rect
    };
    for corner in [rect.left_top(), rect.right_top(), rect.right_bottom()] {
        let to = corner + 12.0 * (rect.center() - corner).normalized();
        let from = bench.on_screen(ends(&bench)[1]);
        bench.drag(from, to);
        bench.settle();
        let now = bench.on_screen(ends(&bench)[1]);
        assert!(rect.contains(now), "{now:?} is beyond {rect:?}");
        assert!(now.distance(to) < 40.0, "{now:?} is far from {to:?}");
    }
}
