//! Every view of every figure of the course has room, and says all it has to say.

use crate::{
    export::{Job, jobs},
    lesson::Course,
};

use super::*;

fn lost(
    studio: &mut Studio,
    job: &Job<'_>,
    (theme, lang): (ThemeKind, Lang),
    size_px: [u32; 2],
) -> Vec<ViewId> {
    let picture = Picture {
        title: job.title(lang),
        scene: job.source.scene(),
        step: job.position,
        options: Options {
            size_px,
            theme,
            lang,
            steps: Steps::Figures,
        },
    };
    studio.drawn(&picture).1
}

/// The page is never smaller than at 16 : 9, whatever the size: a higher or wider one has room for more.
#[test]
fn no_figure_of_the_course_loses_a_view() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    // The dark theme's text is as large as the light one's.
    for theme in [ThemeKind::Light, ThemeKind::Projector] {
        let mut studio = Studio::new(theme);
        for lang in Lang::ALL {
            let faults = jobs.iter().filter_map(|job| {
                let lost = lost(&mut studio, job, (theme, lang), [640, 360]);
                (!lost.is_empty()).then(|| format!("{}: {lost:?}", job.path))
            });
            let faults: Vec<String> = faults.collect();
            assert!(faults.is_empty(), "{theme}, {lang:?}: {faults:#?}");
        }
    }
}
