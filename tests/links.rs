//! Links that were made once: each later version opens them, on the same page, at the same step.

use clipscope::{
    lesson::{Course, LONG_LINK, Link, Opens, SceneFormats, StepName, said},
    text::{Catalog, Lang},
};

/// A link a line, and what it opens. No line is ever taken out, and none is changed.
const CORPUS: &str = include_str!("links/corpus.txt");

fn opens(course: &Course, link: &str) -> String {
    let read = link.parse().map_err(said);
    let opened = read.and_then(|link: Link| course.open_link(&link, SceneFormats::standard()));
    let opened = opened.unwrap_or_else(|problems| {
        let said = problems.iter().map(|it| it.render(Catalog::of(Lang::En)));
        panic!("{link}: {}", said.collect::<String>())
    });
    let document = opened.scene.document();
    let ids: Vec<&str> = document.methods().iter().map(|card| card.id).collect();
    let n_steps = document.record()[0].n_steps();
    let page = match opened.page {
        Some([lesson, step]) => {
            let lesson = &course.lessons[lesson];
            // Lessons and steps go by name: their numbers may change.
            let name = lesson.id.trim_start_matches(|c: char| c.is_ascii_digit());
            format!("{}/{}", &name[1..], lesson.steps[step].id)
        }
        None => "free".to_owned(),
    };
    format!(
        "{page} {} {} of {n_steps}",
        ids.join("+"),
        opened.position.min(n_steps)
    )
}

#[test]
fn every_link_that_was_ever_made_opens_as_it_did() {
    let course = Course::embedded();
    let links = CORPUS.lines().filter_map(|line| line.split_once('\t'));
    let opened = links.map(|(link, _)| format!("{link}\t{}\n", opens(&course, link)));
    let opened: String = opened.collect();
    assert_eq!(opened, CORPUS);
    assert!(opened.lines().count() >= 20);
}

#[test]
fn a_link_to_any_scene_of_the_course_is_short_enough_to_be_sent() {
    let course = Course::embedded();
    let mut lengths = Vec::new();
    for lesson in &course.lessons {
        for step in &lesson.steps {
            let text = SceneFormats::standard().write(&step.scene, &step.moment);
            let of = StepName {
                lesson: lesson.id.clone(),
                step: Some(step.id.clone()),
            };
            let link = Link::to(Opens::Scene(text, Some(of))).to_string();
            lengths.push((link.len(), format!("{}/{}", lesson.id, step.id)));
        }
    }
    lengths.sort();
    let (median, _) = lengths[lengths.len() / 2];
    let (longest, of) = &lengths[lengths.len() - 1];
    let n_long = lengths.iter().filter(|(n, _)| *n > LONG_LINK).count();
    println!(
        "median {median}, longest {longest} ({of}), {n_long} of {}",
        lengths.len()
    );
    assert!(median <= 500, "{median}");
    // Of two hundred segments drawn by lot, as they stand after a change.
    assert!(n_long <= 3, "{n_long} links are long");
}
