//! Every view of every figure of the course has room, and says all it has to say.

use crate::{export::jobs, lesson::Course};

use super::*;

/// The page is never smaller than at 16 : 9, whatever the size: a higher or wider one has room for more.
#[test]
fn no_figure_of_the_course_loses_a_view() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    // The dark theme's text is as large as the light one's.
    for theme in [ThemeKind::Light, ThemeKind::Projector] {
        let mut studio = Studio::new(theme);
        for lang in Lang::ALL {
            let options = Options {
                size_px: [640, 360],
                theme,
                lang,
                steps: Steps::Figures,
                asks: false,
            };
            let faults = jobs.iter().filter_map(|job| {
                let (_, lost) = studio.drawn(&job.picture(options));
                (!lost.is_empty()).then(|| format!("{}: {lost:?}", job.path))
            });
            let faults: Vec<String> = faults.collect();
            assert!(faults.is_empty(), "{theme}, {lang:?}: {faults:#?}");
        }
    }
}

#[test]
fn every_figure_is_said_in_words_and_what_it_answers_is_asked() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    let mut studio = Studio::new(ThemeKind::Light);
    let (mut n_asked, n_figures) = (0, jobs.len());
    for job in jobs {
        for lang in Lang::ALL {
            let options = |asks: bool| Options {
                size_px: [640, 360],
                theme: ThemeKind::Light,
                lang,
                steps: Steps::Figures,
                asks,
            };
            let [told, asked] = [false, true].map(|asks| {
                let said = studio.alternative(&job.picture(options(asks)));
                assert!(!said.contains('⟦'), "{}: {said}", job.path);
                said
            });
            let title = job.title(options(false)).expect("each step has a title");
            assert!(
                told.starts_with(title) && told.lines().count() > 1,
                "{told}"
            );
            assert_ne!(told, asked, "{}", job.path);
            let question = Catalog::of(lang)
                .message(&Message::new("what-comes-next").with("options", String::new()));
            n_asked += usize::from(asked.contains(question.trim()));
        }
    }
    // Some show the beginning, before anything is asked.
    assert!(
        n_asked > 3 * n_figures,
        "{n_asked} of {n_figures} in each language"
    );
}
