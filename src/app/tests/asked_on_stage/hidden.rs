//! What is asked is told by nothing else: no picture of a later step, no test that leads to it, no list of earlier answers.

use super::{super::*, asked_at};

fn small_drawings(bench: &Bench) -> &[crate::figure::SmallDrawing] {
    let mut views = bench.app.playback.on_stage()[0].views.iter();
    let found = views.find_map(|view| match &view.body {
        crate::figure::Body::Multiples(it) => Some(&it.drawings[..]),
        _ => None,
    });
    found.expect("it is there")
}

#[test]
fn small_pictures_show_nothing_that_is_asked() {
    let page = Page::Step("10-one-edge-at-a-time".into(), "four-passes".into());
    let mut bench = asked_at(page, Lang::En, SIZE);
    let notes = |bench: &Bench| {
        small_drawings(bench)
            .iter()
            .filter(|it| it.note.is_some())
            .count()
    };
    let marks = |bench: &Bench| {
        small_drawings(bench)
            .iter()
            .map(|it| it.marks.len())
            .sum::<usize>()
    };
    let before = (notes(&bench), marks(&bench));
    assert_eq!(before.0, 3, "of the passes that are done");
    bench.command(Command::ShowMe);
    bench.frame(0.1, Vec::new());
    assert_eq!(notes(&bench), 4);
    assert!(marks(&bench) > before.1);
}

#[test]
fn what_a_phase_leads_to_is_asked_before_its_steps() {
    let mut bench = Bench::lab("frustum");
    bench.edit(Edit::Method("back-face"));
    bench.key(Key::Home);
    bench.key(Key::Q);
    let asked = bench.app.practice.open().expect("it asks");
    assert!(asked.choice.is_of_phase);
    let run = bench.app.playback.main();
    let named = |name: &str, step: usize| run.shown(step, |shown| shown.named(name));
    let stands = bench.app.position();
    assert_eq!(named("n·e", stands), None, "its sign would answer");
    assert!(named("e", stands).is_some());
    assert!(named("n·e", run.n_steps()).is_some());
    // The steps on the way are not stepped through while it asks.
    bench.key(Key::ArrowRight);
    assert_eq!(bench.app.position(), stands);
}

#[test]
fn answers_are_listed_for_their_own_page_and_not_while_they_are_asked() {
    let page = Page::Step("10-one-edge-at-a-time".into(), "four-passes".into());
    let mut bench = asked_at(page, Lang::En, SIZE);
    let listed = |bench: &mut Bench| {
        let right = format!("{}\u{2002}", bench.app.answers_told()[0].step);
        let texts = bench.texts().into_iter();
        texts.filter(|(text, _)| text.starts_with(&right)).count()
    };
    let right = bench.app.practice.open().expect("it asks").choice.right;
    bench.command(Command::Choose(right));
    bench.frame(0.1, Vec::new());
    assert_eq!(listed(&mut bench), 1);
    bench.command(Command::AskAgain);
    bench.frame(0.1, Vec::new());
    assert!(bench.app.practice.is_asking());
    assert_eq!(listed(&mut bench), 0);
    bench.command(Command::Choose(right));
    let [lesson, step] = bench.app.bookmark.at;
    bench.command(Command::Open([lesson, step + 1]));
    bench.settle();
    assert!(bench.app.practice.is_asking());
    assert!(bench.app.answers_told().is_empty(), "of another page");
}
