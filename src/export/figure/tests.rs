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
