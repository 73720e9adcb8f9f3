//! `clipscope export --slides`: one file for each lesson or scene.

use std::{io, path::Path};

use crate::{
    export::{Job, Options, Slide, Source, Steps, Studio, jobs, jobs_of, slides, write_whole},
    lesson::SceneFile,
};

use super::{Progress, lessons::Chosen};

/// What one file is made of: its name and title, and its figures.
struct Deck<'a> {
    name: &'a str,
    title: &'a str,
    jobs: Vec<Job<'a>>,
}

impl<'a> Deck<'a> {
    fn all(chosen: &'a Chosen, options: Options) -> Vec<Self> {
        let lessons = chosen.lessons.iter().map(|lesson| Self {
            name: &lesson.id,
            title: lesson.title(options.lang),
            jobs: jobs([lesson], Steps::Figures),
        });
        let scenes = chosen
            .scenes
            .iter()
            .map(|(name, scene): &(String, SceneFile)| Self {
                name,
                title: name,
                jobs: jobs_of(Source::File(scene), name, Steps::Figures),
            });
        lessons.chain(scenes).collect()
    }

    /// What is asked first, where the step asks, then what it shows.
    fn html(&self, studio: &mut Studio, options: Options) -> String {
        let mut all = Vec::new();
        for job in &self.jobs {
            let asks = match job.source {
                Source::Step(_, step) => step.asks.is_some(),
                Source::File(_) => false,
            };
            for asks in [Some(true).filter(|_| asks), Some(false)]
                .into_iter()
                .flatten()
            {
                let options = Options { asks, ..options };
                all.push(Slide {
                    alternative: studio.alternative(&job.picture(options)),
                    png: job.png(studio, options, None),
                });
            }
        }
        slides(self.title, &all, options)
    }
}

/// How many files were written; of the others the path and why not.
pub(super) fn write(
    chosen: &Chosen,
    options: Options,
    out: &Path,
) -> (usize, Vec<(String, io::Error)>) {
    let decks = Deck::all(chosen, options);
    let mut progress = Progress::new(decks.len() as u64);
    let mut studio = Studio::new(options.theme);
    let mut failures = Vec::new();
    for deck in &decks {
        let path = out.join(deck.name).with_extension("html");
        if let Err(error) = write_whole(&path, deck.html(&mut studio, options).as_bytes()) {
            failures.push((path.display().to_string(), error));
        }
        progress.advance(1);
    }
    (decks.len() - failures.len(), failures)
}
