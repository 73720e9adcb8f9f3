//! Before every decision it is asked what comes.

use super::*;
use crate::lesson::{Asks, Told};

/// The steps of the run on stage that answer a question.
fn decisions(bench: &Bench) -> Vec<usize> {
    let run = bench.app.playback.main();
    let mut steps = Vec::new();
    run.visit([1, run.n_steps()], &mut |step, shown| {
        let choice = shown.options().filter(crate::figure::Choice::is_open);
        // What a phase leads to is known once its steps have been asked.
        let choice = choice.filter(|it| !it.is_of_phase);
        steps.extend(choice.map(|_| step));
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

/// Answers the first question of a run with another option than the right one: the steps that ask, the choice, and the answer.
fn answer_wrongly(bench: &mut Bench) -> (Vec<usize>, crate::figure::Choice, usize) {
    bench.key(Key::Home);
    bench.key(Key::Q);
    let steps = decisions(bench);
    let asked = choice(bench, steps[0]);
    let wrong = (asked.right + 1) % asked.options.len();
    bench.key(digit(wrong));
    (steps, asked, wrong)
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
    let (steps, asked, wrong) = answer_wrongly(&mut bench);
    let said = asked.said(Catalog::of(Lang::En));
    let told = format!("× {}. Right: {}.", said[wrong], said[asked.right]);
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
    bench.command(Command::Code(CodeView::Full));
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
    assert_eq!(bench.app.n_steps_told() % 24, 0, "no tick tells it either");
    // What is asked about is not told why, by click or by key.
    let links = bench
        .app
        .practice
        .open()
        .map(|asked| asked.choice.links.clone());
    for link in links.into_iter().flatten().flatten() {
        bench.command(Command::Ask(Some((link, 0))));
        bench.command(Command::Verdict);
        assert_eq!(bench.app.stage.asked, None);
        assert!(bench.app.practice.is_asking());
    }
    // Pseudocode keeps its rule to itself, and so does its name for a screen reader.
    bench.frame(0.1, Vec::new());
    let method = bench.app.scene().document().methods()[0];
    let rules = method
        .code
        .iter()
        .map(|line| bench.app.look().say(line.code));
    let rules: Vec<String> = rules.filter(|text| text.contains('\u{2190}')).collect();
    for rule in rules.iter().filter(|rule| !rule.ends_with('\u{2190}')) {
        let is_told = |(name, _): &(String, Rect)| name == rule;
        assert!(!bench.names.iter().any(is_told), "{rule}");
    }
    bench.key(Key::Escape);
    assert!(!bench.app.practice.is_on, "Escape asks no more");
    bench.frame(0.1, Vec::new());
    let are_told = |rule: &String| bench.names.iter().any(|(name, _)| name == rule);
    assert!(rules.iter().any(are_told), "{rules:?}");
}

#[test]
fn where_a_mistake_differs_is_told_after_the_answer() {
    let mut bench = Bench::lab("polygons");
    bench.edit(Edit::Method("faulty-open"));
    bench.edit(Edit::Compare(Some("sutherland-hodgman")));
    bench.key(Key::Home);
    assert!(bench.app.difference_told().is_some());
    bench.key(Key::Q);
    assert!(bench.app.practice.is_asking());
    assert_eq!(bench.app.difference_told(), None);
    bench.key(digit(0));
    assert!(bench.app.difference_told().is_some());
}

#[test]
fn a_wrong_answer_stays_beside_the_right_one() {
    let mut bench = Bench::lab("lines");
    bench.ctx.enable_accesskit();
    let (steps, asked, wrong) = answer_wrongly(&mut bench);
    bench.settle();
    let said = asked.said(Catalog::of(Lang::En));
    let kept = format!(
        "Step {}: {}, not: {}.",
        steps[0], said[asked.right], said[wrong]
    );
    let is_kept = |(name, _): &(String, Rect)| *name == kept;
    assert!(bench.names.iter().any(is_kept), "{kept}");
}

#[test]
fn marks_at_the_end_wait_for_the_end() {
    let mut bench = Bench::lab("lines");
    bench.ctx.enable_accesskit();
    bench.command(Command::MarkAtEnd(true));
    bench.key(Key::Home);
    bench.key(Key::Q);
    let steps = decisions(&bench);
    for step in &steps {
        assert!(bench.app.practice.is_asking(), "one after the other");
        assert!(bench.app.answers_told().is_empty());
        let asked = choice(&bench, *step);
        bench.key(digit((asked.right + 1) % asked.options.len()));
    }
    assert!(!bench.app.practice.is_asking());
    let told = bench.app.answers_told();
    assert_eq!(told.iter().map(|it| it.step).collect::<Vec<_>>(), steps);
    assert_eq!(bench.app.practice.told, [0, steps.len()]);
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

/// A step of the course that asks, opened as a student opens it.
fn asked_of(lesson: &str, step: &str) -> Bench {
    let settings = Settings {
        places: Places {
            page: Some(Page::Step(lesson.to_owned(), step.to_owned())),
            ..Places::default()
        },
        ..Settings::default()
    };
    let mut bench = Bench::with(App::new(Course::embedded(), settings), SIZE);
    bench.ctx.enable_accesskit();
    bench.frame(0.1, Vec::new());
    bench
}

fn told(bench: &Bench) -> Told {
    bench.app.told_of_step()
}

#[test]
fn a_step_that_asks_waits_before_what_it_shows() {
    let (lesson, step) = ("04-cutting-with-outcodes", "four-cuts");
    let mut bench = asked_of(lesson, step);
    let step = bench.app.bookmark.step().expect("it is there").clone();
    assert!(step.asks.is_some() && bench.app.practice.asks_for_a_step());
    let (decision, choice) = bench
        .app
        .playback
        .main()
        .decision_by(step.position().unwrap())
        .unwrap();
    assert_eq!(bench.app.position(), decision - 1);
    for key in [Key::ArrowRight, Key::End, Key::Space] {
        bench.key(key);
        assert_eq!(bench.app.position(), decision - 1, "{key:?}");
    }
    let claim = bench.app.bookmark.title(Lang::En, true).unwrap().to_owned();
    let is_told = |bench: &Bench| bench.names.iter().any(|(name, _)| name.contains(&claim));
    assert!(!is_told(&bench), "the claim waits");
    bench.key(digit((choice.right + 1) % choice.options.len()));
    assert_eq!(
        (bench.app.position(), told(&bench)),
        (decision, Told::Missed)
    );
    bench.key(Key::Enter);
    assert_eq!(bench.app.position(), step.position().unwrap());
    // Asked again, the numbers have been seen.
    bench.command(Command::AskAgain);
    assert_eq!(bench.app.position(), decision - 1);
    bench.key(digit(choice.right));
    assert_eq!(told(&bench), Told::AfterTheNumbers);
    // It stays so over a restart.
    let settings = bench.app.settings();
    let written = settings.progress.written();
    let read = crate::lesson::Progress::read(written.as_bytes()).expect("its own file");
    assert_eq!(
        read.mark(lesson, "four-cuts").map(|mark| mark.told),
        Some(Told::AfterTheNumbers)
    );
}

#[test]
fn what_might_come_is_answered_on_the_picture_too() {
    let bench = asked_of("04-cutting-with-outcodes", "four-cuts");
    let open = bench.app.practice.open().expect("it asks");
    let links: Vec<_> = open.choice.links.iter().flatten().copied().collect();
    assert_eq!(links.len(), 4, "each side can be pointed at");
    for (nth, link) in links.into_iter().enumerate() {
        assert_eq!(bench.app.practice.option_of(link), Some(nth));
    }
}

#[test]
fn whoever_pages_on_is_shown_what_comes_and_gets_no_mark() {
    let mut bench = asked_of("04-cutting-with-outcodes", "four-cuts");
    let at = bench.app.bookmark.at;
    bench.key(Key::PageDown);
    assert_eq!(bench.app.bookmark.at, at);
    assert!(!bench.app.practice.is_asking());
    assert_eq!(told(&bench), Told::Open);
    bench.command(Command::AskAgain);
    bench.key(Key::Escape);
    assert!(!bench.app.practice.is_asking());
    bench.command(Command::AskInLessons(false));
    bench.key(Key::PageDown);
    assert!(!bench.app.practice.is_asking(), "nothing asks any more");
}

#[test]
fn every_step_that_asks_has_something_to_ask() {
    let course = Course::embedded();
    let mut n_asked = 0;
    for lesson in &course.lessons {
        let asks = |step: &&LessonStep| step.asks == Some(Asks::Decision);
        for step in lesson.steps.iter().filter(asks) {
            n_asked += 1;
            let runs = step.scene.document().record();
            let position = step.position().expect("its moment comes");
            let decision = runs[0].decision_by(position);
            let (at, choice) = decision.unwrap_or_else(|| panic!("{} {}", lesson.id, step.id));
            assert!(choice.options.len() > 1, "{} {}", lesson.id, step.id);
            assert!(
                position - at <= 3,
                "{} {}: {at} is long before {position}",
                lesson.id,
                step.id
            );
        }
    }
    assert!(n_asked >= 120, "{n_asked}");
}

#[test]
fn a_whole_run_is_asked_and_marked_at_its_end() {
    let course = Course::embedded();
    let all = course.lessons.iter().enumerate().flat_map(|(i, lesson)| {
        let steps = lesson.steps.iter().enumerate();
        let asked = steps.filter(|(_, step)| step.asks == Some(Asks::Run));
        asked.map(move |(step, _)| [i, step])
    });
    let at = all.min().expect("a lesson has one");
    let mut bench = asked_of("04-cutting-with-outcodes", "four-cuts");
    bench.command(Command::Open(at));
    assert!(bench.app.practice.asks_for_a_step());
    let mut n_answers = 0;
    while let Some(right) = bench.app.practice.open().map(|asked| asked.choice.right) {
        bench.command(Command::Choose(right));
        assert!(bench.app.practice.asks_for_a_step(), "its text waits");
        bench.command(Command::Play);
        n_answers += 1;
        assert!(n_answers < 1_000, "it ends");
    }
    assert!(n_answers > 1);
    assert!(!bench.app.practice.asks_for_a_step());
    assert_eq!(told(&bench), Told::Beforehand);
    assert!(!bench.app.practice.is_on, "its text and its claim open");
    let sum = Message::new("practice-told").with("right", Value::Count(n_answers));
    let sum = sum.with("count", Value::Count(n_answers));
    let sum = Catalog::of(Lang::En).message(&sum);
    let texts = bench.texts();
    assert!(
        texts.iter().any(|(text, _)| *text == sum),
        "{sum}: {texts:?}"
    );
}

#[test]
fn backspace_takes_a_decision_back_and_its_mark_stays() {
    let mut bench = Bench::lab("lines");
    bench.ctx.enable_accesskit();
    let (steps, asked, _) = answer_wrongly(&mut bench);
    bench.key(Key::Enter);
    let next = bench.app.position();
    assert!(next >= steps[0] && bench.app.practice.is_asking());
    bench.key(Key::Backspace);
    assert_eq!(bench.app.position(), steps[0] - 1);
    assert!(bench.app.practice.is_asking());
    assert_eq!(bench.app.practice.told, [0, 1], "the first try counts");
    bench.key(digit(asked.right));
    assert_eq!(bench.app.practice.told, [1, 2], "and so does the second");
    let answered: Vec<usize> = bench.app.answers_told().iter().map(|it| it.step).collect();
    assert_eq!(answered, [steps[0]; 2]);
    // One after the other, to the first, and no further.
    bench.key(Key::Enter);
    bench.key(digit(choice(&bench, steps[1]).right));
    for step in [steps[1], steps[0], steps[0]] {
        bench.frame(0.1, Vec::new());
        bench.key(Key::Backspace);
        assert_eq!(bench.app.position(), step - 1);
    }
    bench.frame(0.1, Vec::new());
    let words = Catalog::of(Lang::En).term("practice-take-back");
    let is_offered = |bench: &Bench| bench.names.iter().any(|(name, _)| *name == words);
    assert!(!is_offered(&bench), "there is nothing to take back");
    bench.key(digit(asked.right));
    bench.frame(0.1, Vec::new());
    assert!(is_offered(&bench));
}
