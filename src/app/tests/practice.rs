//! Before every decision it is asked what comes.

use super::*;

/// The steps of the run on stage that answer a question.
fn decisions(bench: &Bench) -> Vec<usize> {
    let run = bench.app.playback.main();
    let mut steps = Vec::new();
    run.visit([1, run.n_steps()], &mut |step, shown| {
        steps.extend(shown.options().map(|_| step));
        std::ops::ControlFlow::Continue(())
    });
    steps
}

/// What the decision at this step might be, and which of it comes.
fn choice(bench: &Bench, step: usize) -> crate::figure::Choice {
    let run = bench.app.playback.main();
    let choice = run.shown(step, |shown| shown.options());
    choice.expect("a decision has options")
}

fn digit(nth: usize) -> Key {
    Key::from_name(&(nth + 1).to_string()).expect("a digit")
}

#[test]
fn every_decision_is_asked_before_it_is_shown() {
    for lab in ["lines", "polygons", "frustum", "surfaces"] {
        let mut bench = Bench::lab(lab);
        bench.key(Key::Home);
        bench.key(Key::Q);
        let steps = decisions(&bench);
        assert!(steps.len() > 1, "{lab}: {steps:?}");
        for &step in steps.iter().take(12) {
            assert!(bench.app.practice.is_asking(), "{lab}: before step {step}");
            assert_eq!(bench.app.position(), step - 1, "{lab}");
            for key in [Key::ArrowRight, Key::End, Key::Space] {
                bench.key(key);
                assert_eq!(
                    bench.app.position(),
                    step - 1,
                    "{lab}: {key:?} skips nothing"
                );
            }
            let right = choice(&bench, step).right;
            if right < 9 {
                bench.key(digit(right));
            } else {
                bench.command(Command::Choose(right));
            }
            assert_eq!(bench.app.position(), step, "{lab}: what comes is shown");
            assert!(!bench.app.practice.is_asking());
            bench.key(Key::Enter);
        }
    }
}

#[test]
fn a_wrong_answer_is_told_what_comes_and_one_that_is_shown_counts_for_nothing() {
    let mut bench = Bench::lab("lines");
    bench.ctx.enable_accesskit();
    bench.key(Key::Home);
    bench.key(Key::Q);
    let steps = decisions(&bench);
    let asked = choice(&bench, steps[0]);
    let wrong = (asked.right + 1) % asked.options.len();
    bench.key(digit(wrong));
    let said = asked.said(Catalog::of(Lang::En));
    let told = format!("× {}, not: {}.", said[asked.right], said[wrong]);
    bench.frame(0.1, Vec::new());
    let names: Vec<&String> = bench.names.iter().map(|(name, _)| name).collect();
    assert!(names.contains(&&told), "{told}: {names:?}");
    assert!(names.contains(&&"0 of 1 told before they were shown".to_owned()));
    bench.key(Key::Enter);
    bench.key(Key::S);
    assert_eq!(bench.app.position(), steps[1]);
    bench.frame(0.1, Vec::new());
    let is_same = |(name, _): &(String, Rect)| name == "0 of 1 told before they were shown";
    assert!(bench.names.iter().any(is_same));
    // Stepping back over what was answered asks it no more.
    bench.key(Key::Home);
    bench.key(Key::ArrowRight);
    assert!(bench.app.position() > 0 || bench.app.practice.is_asking());
}

#[test]
fn nothing_on_the_screen_tells_what_comes() {
    let mut bench = Bench::course(SIZE);
    bench.ctx.enable_accesskit();
    bench.key(Key::Home);
    bench.key(Key::Q);
    assert!(bench.app.practice.is_asking());
    bench.frame(0.1, Vec::new());
    let n_steps = bench.app.playback.transport.n_steps();
    for (name, _) in &bench.names {
        assert!(
            !name.contains(&format!("of {n_steps}")),
            "{name} tells how long the run is"
        );
    }
    bench.key(Key::Escape);
    assert!(!bench.app.practice.is_on, "Escape asks no more");
}

#[test]
fn a_drag_asks_anew_and_no_answer_is_undone() {
    let mut bench = Bench::lab("lines");
    bench.key(Key::Home);
    bench.key(Key::Q);
    let steps = decisions(&bench);
    bench.key(digit(choice(&bench, steps[0]).right));
    bench.key(Key::Enter);
    assert!(bench.app.practice.is_asking());
    bench.edit(Edit::Add(None));
    bench.frame(0.1, Vec::new());
    assert!(bench.app.practice.is_asking());
    let [right, all] = bench.app.practice.told;
    assert_eq!([right, all], [1, 1]);
    bench.command(Command::Undo);
    bench.frame(0.1, Vec::new());
    assert_eq!(bench.app.practice.told, [1, 1]);
}
