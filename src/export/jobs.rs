//! All figures of a course, drawn on all cores.

use std::{
    io,
    num::NonZero,
    path::Path,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
        mpsc,
    },
    thread,
};

use crate::{
    labs::Scene,
    lesson::{Lesson, LessonStep, SceneFile},
    paint::ThemeKind,
    text::Lang,
};

use super::{
    figure::{Picture, Steps, Studio},
    files::write_whole,
};

/// How pictures are drawn.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Width and height in pixels.
    pub size_px: [u32; 2],
    /// Colours and weights.
    pub theme: ThemeKind,
    /// The language of captions.
    pub lang: Lang,
    /// Which steps.
    pub steps: Steps,
}

/// Whose scene a picture shows.
#[derive(Clone, Copy, Debug)]
pub enum Source<'a> {
    /// A step's of a lesson.
    Step(&'a Lesson, &'a LessonStep),
    /// A file's.
    File(&'a SceneFile),
}

/// One picture to be drawn.
#[derive(Clone, Debug)]
pub struct Job<'a> {
    /// Whose scene it shows.
    pub source: Source<'a>,
    /// Events folded so far.
    pub position: usize,
    /// Path below the output folder: `03-outcodes/nine-regions.png`.
    pub path: String,
}

/// The pictures of these lessons, in the order of the course.
pub fn jobs<'a>(lessons: impl IntoIterator<Item = &'a Lesson>, steps: Steps) -> Vec<Job<'a>> {
    let mut jobs = Vec::new();
    for lesson in lessons {
        for step in &lesson.steps {
            let Some(figure) = &step.figure else { continue };
            let job = |position, name: String| Job {
                source: Source::Step(lesson, step),
                position,
                path: format!("{}/{name}.png", lesson.id),
            };
            match steps {
                Steps::Figures => {
                    let position = step.position();
                    jobs.extend(position.map(|position| job(position, figure.clone())));
                }
                Steps::All => {
                    let all = 0..=n_steps(&step.scene);
                    jobs.extend(all.map(|k| job(k, format!("{figure}-{k:03}"))));
                }
            }
        }
    }
    jobs
}

/// The pictures of a scene file, under this name.
pub fn jobs_of_file<'a>(name: &str, file: &'a SceneFile, steps: Steps) -> Vec<Job<'a>> {
    let job = |position, path| Job {
        source: Source::File(file),
        position,
        path,
    };
    match steps {
        Steps::Figures => vec![job(file.position, format!("{name}.png"))],
        Steps::All => (0..=n_steps(&file.scene))
            .map(|k| job(k, format!("{name}-{k:03}.png")))
            .collect(),
    }
}

fn n_steps(scene: &Scene) -> usize {
    let runs = scene.document().record();
    runs.first().map_or(0, |run| run.n_steps())
}

impl Job<'_> {
    /// The scene that it shows.
    pub fn scene(&self) -> &Scene {
        match self.source {
            Source::Step(_, step) => &step.scene,
            Source::File(file) => &file.scene,
        }
    }

    /// The idea in words, where a lesson says it.
    pub fn title(&self, lang: Lang) -> Option<&str> {
        match self.source {
            Source::Step(lesson, step) => lesson.step_title(&step.id, lang),
            Source::File(_) => None,
        }
    }

    /// The picture as PNG.
    pub fn png(&self, studio: &mut Studio, options: &Options) -> Vec<u8> {
        let picture = Picture {
            title: self.title(options.lang),
            scene: self.scene(),
            step: self.position,
            lang: options.lang,
            theme: options.theme,
            size_px: options.size_px,
            among: options.steps,
        };
        studio.draw(&picture).to_png()
    }

    fn write(&self, png: &[u8], out: &Path) -> io::Result<()> {
        let path = out.join(&self.path);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        write_whole(&path, png)
    }
}

/// A picture that could not be written.
#[derive(Debug)]
pub struct Failure {
    /// Where it should have been.
    pub path: String,
    /// What the file system said.
    pub error: io::Error,
}

/// Draws with `png` and writes all pictures on all cores; `done` hears of each on the calling thread. The
/// failures come in the order of the jobs.
pub fn run(
    jobs: &[Job<'_>],
    theme: ThemeKind,
    out: &Path,
    png: impl Fn(&Job<'_>, &mut Studio) -> Vec<u8> + Sync,
    mut done: impl FnMut(),
) -> Vec<Failure> {
    let next = AtomicUsize::new(0);
    let failures = Mutex::new(Vec::new());
    let n_threads = thread::available_parallelism()
        .map_or(1, NonZero::get)
        .min(jobs.len());
    thread::scope(|scope| {
        let (finished, each_finished) = mpsc::channel();
        for _ in 0..n_threads {
            let finished = finished.clone();
            let (next, failures, png) = (&next, &failures, &png);
            scope.spawn(move || {
                let mut studio = Studio::new(theme);
                while let Some((i, job)) = take(next, jobs) {
                    if let Err(error) = job.write(&png(job, &mut studio), out) {
                        let path = out.join(&job.path).display().to_string();
                        if let Ok(mut failures) = failures.lock() {
                            failures.push((i, Failure { path, error }));
                        }
                    }
                    if finished.send(()).is_err() {
                        return;
                    }
                }
            });
        }
        drop(finished);
        for () in each_finished {
            done();
        }
    });
    let mut failures = failures.into_inner().unwrap_or_default();
    failures.sort_by_key(|(i, _)| *i);
    failures.into_iter().map(|(_, failure)| failure).collect()
}

fn take<'j, 'a>(next: &AtomicUsize, jobs: &'j [Job<'a>]) -> Option<(usize, &'j Job<'a>)> {
    let i = next.fetch_add(1, Ordering::Relaxed);
    Some((i, jobs.get(i)?))
}
