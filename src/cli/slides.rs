//! `clipscope export --slides`: one file for each lesson or scene.

use std::path::Path;

use crate::export::{Failure, Job, Options, Slide, Source, Studio, Way, slides, write_whole};

use super::Progress;

/// Writes the figures of each lesson into one file, and those of each scene. The failures come in that order.
pub(super) fn write(decks: &[&[Job<'_>]], options: Options, out: &Path) -> Vec<Failure> {
    let mut progress = Progress::new(decks.len() as u64);
    let mut studio = Studio::new(options.theme);
    let mut failures = Vec::new();
    for deck in decks {
        let (name, html) = page(deck, &mut studio, options);
        let path = out.join(format!("{name}.html"));
        if let Err(error) = write_whole(&path, html.as_bytes()) {
            let path = path.display().to_string();
            failures.push(Failure { path, error });
        }
        progress.advance(1);
    }
    failures
}

/// Its name, and what is in it: what is asked first, where a step asks, then what it shows.
fn page<'a>(deck: &'a [Job<'_>], studio: &mut Studio, options: Options) -> (&'a str, String) {
    let (name, title) = match deck[0].source {
        Source::Step(lesson, _) => (&*lesson.id, lesson.title(options.lang)),
        Source::File(_) => {
            let name = deck[0].path.trim_end_matches(".png");
            (name, name)
        }
    };
    let mut all = Vec::new();
    for job in deck {
        let is_asked = matches!(job.source, Source::Step(_, step) if step.asks.is_some());
        let ways: &[bool] = if is_asked { &[true, false] } else { &[false] };
        for &asks in ways {
            let options = Options { asks, ..options };
            all.push(Slide {
                alternative: studio.alternative(&job.picture(options)),
                png: job.bytes(studio, Way::of(options)),
            });
        }
    }
    (name, slides(title, &all, options))
}
