//! Links: what is copied here opens the same elsewhere.

use super::*;
use crate::{
    export::{Options, Steps, Studio, Way, jobs},
    lesson::{Opens, link_in},
};

/// Another window with the course, where this link is opened.
fn opened(link: &str) -> Bench {
    let mut bench = Bench::course(SIZE);
    bench.frame(0.1, vec![Event::Paste(link.to_owned())]);
    bench.settle();
    bench
}

/// The link that the keys put on the clipboard.
fn copied(bench: &mut Bench) -> String {
    bench.press(Key::L, ctrl() | Modifiers::SHIFT);
    bench.app.link().to_string()
}

#[test]
fn every_step_of_the_course_opens_by_a_short_link() {
    let course = Course::embedded();
    let mut bench = Bench::course(SIZE);
    for (lesson_idx, lesson) in course.lessons.iter().enumerate() {
        let step_idx = lesson.steps.len() - 1;
        bench
            .app
            .open_link(&format!("#{}/{}", lesson.id, lesson.steps[step_idx].id));
        bench.settle();
        assert_eq!(bench.app.bookmark.at, [lesson_idx, step_idx]);
        let link = bench.app.link().to_string();
        assert_eq!(
            link,
            format!("#{}/{}", lesson.id, lesson.steps[step_idx].id)
        );
    }
}

#[test]
fn what_was_changed_opens_on_the_same_page_with_its_moment() {
    let mut bench = Bench::course(SIZE);
    bench.app.open_link("#05-intervals/entering");
    bench.settle();
    bench.apply(Command::Step(1));
    let link = copied(&mut bench);
    assert!(link.starts_with("#05-intervals/entering&at="), "{link}");
    let there = opened(&link);
    assert_eq!(there.app.link(), bench.app.link());
    let position = there.app.position();
    assert_eq!(position, bench.app.position());

    let handle = bench.app.scene().document().handles()[0];
    let at = bench
        .app
        .scene()
        .document()
        .position(handle)
        .expect("a handle");
    bench.apply(Command::Edit(
        Edit::Drag(handle, [at[0] + 0.25, at[1], 0.0]),
        None,
    ));
    let link = copied(&mut bench);
    assert!(link.starts_with("#v1="), "{link}");
    assert!(link.contains("&step=05-intervals/entering"), "{link}");
    let mut there = opened(&link);
    assert_eq!(there.app.scene(), bench.app.scene());
    assert_eq!(there.app.position(), bench.app.position());
    assert_eq!(there.app.bookmark.page(), bench.app.bookmark.page());
    there.undo();
    assert!(
        there.app.is_untouched(),
        "what was there before is one step back"
    );
}

#[test]
fn a_method_beside_needs_no_scene() {
    let mut bench = Bench::course(SIZE);
    bench.app.open_link("#05-intervals/entering");
    bench.apply(Command::Edit(Edit::Compare(Some("cohen-sutherland")), None));
    let link = copied(&mut bench);
    assert!(link.starts_with("#05-intervals/entering"), "{link}");
    assert!(link.ends_with("&beside=cohen-sutherland"), "{link}");
    assert_eq!(opened(&link).app.scene(), bench.app.scene());
}

#[test]
fn an_eye_that_was_turned_a_language_and_a_theme_go_with_the_link() {
    let mut bench = Bench::course(SIZE);
    bench.app.open_link("#19-the-view-volume");
    bench.settle();
    bench.apply(Command::Zoom(1.25));
    bench.apply(Command::Language(Lang::PtBr));
    let link = copied(&mut bench);
    assert!(link.contains("&eye="), "{link}");
    assert!(link.ends_with("&lang=pt-BR"), "{link}");
    let there = opened(&(link.clone() + "&theme=projector"));
    let settings = &there.app.settings;
    assert_eq!(
        (settings.lang, settings.theme),
        (Lang::PtBr, ThemeKind::Projector)
    );
    assert_eq!(there.app.link().to_string(), link);
}

#[test]
fn a_link_that_leads_nowhere_is_explained_and_changes_nothing() {
    let million = format!("polygons = [[{}]]", "[0, 0],".repeat(200_000));
    let million = crate::lesson::Link::to(Opens::Scene(million, None)).to_string();
    let mut bench = Bench::course(SIZE);
    let before = bench.app.link();
    for link in [
        "#v1=AAAA",
        "#v7=AAAA",
        "#99-nowhere/step",
        "#05-intervals/nowhere",
        "#05-intervals/entering&at=never",
        "#05-intervals/entering&beside=nobody",
        "#05-intervals/entering&theme=pink",
        "#05-intervals/entering&eye=NaN,0,0,0,0,1,30",
        &million,
    ] {
        bench.frame(0.1, vec![Event::Paste(link.to_owned())]);
        assert!(!bench.app.notices.is_empty(), "{link:.40} is explained");
        assert_eq!(bench.app.link(), before, "{link:.40}");
        bench.key(Key::Escape);
    }
    // Other text that is pasted means nothing.
    bench.frame(0.1, vec![Event::Paste("# a heading\nand text".to_owned())]);
    assert!(bench.app.notices.is_empty());
}

#[test]
fn an_exported_figure_opens_what_it_shows() {
    let course = Course::embedded();
    let lessons = course.lessons.iter().filter(|it| it.id.starts_with("05"));
    let options = Options {
        size_px: [480, 270],
        theme: ThemeKind::Light,
        lang: Lang::Es,
        steps: Steps::Figures,
        asks: false,
    };
    let jobs = jobs(lessons, options.steps);
    let bytes = jobs[0].bytes(&mut Studio::new(options.theme), Way::of(options));
    let link = link_in(&bytes).expect("a picture of ours carries its link");
    assert!(link.ends_with("&lang=es"), "{link}");
    let mut bench = Bench::course(SIZE);
    bench.app.open_link("#30-one-polygon");
    bench.drop_file("figure.png", Some(&bytes));
    bench.settle();
    assert_eq!(bench.app.link().to_string(), link);
    assert_eq!(bench.app.scene(), jobs[0].source.scene());
    // Another picture says nothing.
    let plain = crate::paint::Image {
        size: [1, 1],
        rgba: vec![255; 4],
    };
    bench.drop_file("plain.png", Some(&plain.to_png()));
    assert!(!bench.app.notices.is_empty());
    assert_eq!(bench.app.link().to_string(), link);
}

#[test]
fn a_step_that_asks_does_so_when_a_link_opens_it_but_not_at_a_moment_of_its_own() {
    let app = App::new(Course::embedded(), Settings::default());
    let mut bench = Bench::with(app, SIZE);
    let course = Course::embedded();
    let mut steps = course.lessons.iter().flat_map(|lesson| {
        let asks = lesson.steps.iter().filter(|step| step.asks.is_some());
        asks.map(move |step| format!("#{}/{}", lesson.id, step.id))
    });
    let link = steps.next().expect("some step asks");
    bench.app.open_link(&link);
    bench.settle();
    assert!(bench.app.practice.asks_for_a_step(), "{link}");
    assert_eq!(bench.app.link().to_string(), link);
    bench.app.open_link(&format!("{link}&at=end"));
    bench.settle();
    assert!(!bench.app.practice.asks_for_a_step(), "{link}");
    let n_steps = bench.app.playback.transport.n_steps();
    assert_eq!(bench.app.position(), n_steps);
}
