//! What is in hand stays under the pointer.

use crate::lesson::Lesson;

use super::*;

/// Title, boards and the rows of a question go when the scene becomes the reader's: none of that may move what is in hand.
#[test]
fn nothing_moves_under_the_pointer_while_a_handle_is_dragged() {
    let course = Course::embedded();
    let first_steps = |lesson: &Lesson| {
        let steps = lesson.steps.iter().take(2);
        let at = steps.map(|step| (lesson.id.clone(), step.id.clone()));
        at.collect::<Vec<_>>()
    };
    let at: Vec<_> = course.lessons.iter().flat_map(first_steps).collect();
    let app = App::new(course, Settings::default());
    let mut bench = Bench::with(app, vec2(1024.0, 720.0));
    let (mut n_dragged, mut n_changed) = (0, 0);
    for (lesson, step) in at {
        bench.open_step(&lesson, &step);
        let Some(&id) = bench.app.stage.handle_ids.first() else {
            continue;
        };
        let handle = bench.ctx.read_response(id).expect("it was drawn").rect;
        let stands = |bench: &Bench| (bench.app.stage.places.clone(), bench.app.stage.seen.clone());
        let before = stands(&bench);
        bench.point(handle.center());
        bench.button(handle.center(), true);
        let by = |i: u8| handle.center() + f32::from(i) * vec2(9.0, 7.0);
        for i in 1..=4 {
            bench.point(by(i));
        }
        n_dragged += usize::from(!bench.app.is_untouched());
        assert_eq!(stands(&bench), before, "{lesson}, {step}");
        let place = |bench: &Bench| {
            let document = bench.app.scene().document();
            let handles = document.handles();
            handles
                .into_iter()
                .map(|it| document.position(it))
                .collect::<Vec<_>>()
        };
        let held = place(&bench);
        bench.button(by(4), false);
        bench.settle();
        assert_eq!(place(&bench), held, "{lesson}, {step}: let go");
        n_changed += usize::from(stands(&bench) != before);
    }
    assert!(n_dragged > 20, "{n_dragged}");
    assert!(n_changed > 0, "something would have moved");
}
