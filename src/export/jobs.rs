//! All figures of a course, drawn on all cores.

use std::{
    io,
    num::NonZero,
    ops::Range,
    path::Path,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
        mpsc,
    },
    thread,
};

use crate::{
    figure::Moment,
    labs::Scene,
    lesson::{Lesson, LessonStep, Link, SceneFile, SceneFormats, Stand},
    paint::ThemeKind,
    text::Lang,
};

use super::{
    animation::animated,
    figure::{Options, Picture, Steps, Studio},
    files::write_whole,
};

#[derive(Clone, Copy, Debug)]
pub enum Source<'a> {
    Step(&'a Lesson, &'a LessonStep),
    File(&'a SceneFile),
}

#[derive(Clone, Debug)]
pub struct Job<'a> {
    pub source: Source<'a>,
    pub position: usize,
    moment: Moment,
    /// Path below the output folder: `03-outcodes/nine-regions.png`.
    pub path: String,
    /// All steps of the run, one after the other, in place of one.
    pub is_loop: bool,
}

impl<'a> Source<'a> {
    pub fn scene(self) -> &'a Scene {
        match self {
            Self::Step(_, step) => &step.drawn().scene,
            Self::File(file) => &file.scene,
        }
    }
}

/// In the order of the course.
pub fn jobs<'a>(lessons: impl IntoIterator<Item = &'a Lesson>, steps: Steps) -> Vec<Job<'a>> {
    let mut jobs = Vec::new();
    for lesson in lessons {
        for step in &lesson.steps {
            if let Some(figure) = &step.figure {
                let stem = format!("{}/{figure}", lesson.id);
                jobs.extend(jobs_of(Source::Step(lesson, step), &stem, steps));
            }
        }
    }
    jobs
}

/// The pictures of one scene, of which the paths begin so.
pub fn jobs_of<'a>(source: Source<'a>, stem: &str, steps: Steps) -> Vec<Job<'a>> {
    let job = |position, moment, path| Job {
        source,
        position,
        moment,
        path,
        is_loop: false,
    };
    match steps {
        Steps::Figures => {
            let (position, moment) = match source {
                Source::Step(_, step) => (step.drawn().position(), &step.drawn().moment),
                Source::File(file) => (Some(file.position), &file.moment),
            };
            let path = format!("{stem}.png");
            let job = position.map(|position| job(position, moment.clone(), path));
            job.into_iter().collect()
        }
        Steps::All => {
            let runs = source.scene().document().record();
            let run = runs.first();
            let path = |step| format!("{stem}-{step:03}.png");
            let at_step = |step| Some(job(step, run?.moment(step), path(step)));
            let n_steps = run.map_or(0, |run| run.n_steps());
            (0..=n_steps).filter_map(at_step).collect()
        }
    }
}

/// Each picture as the loop of its whole run: `03-outcodes/nine-regions.apng`.
pub fn loops(mut jobs: Vec<Job<'_>>) -> Vec<Job<'_>> {
    for job in &mut jobs {
        let path = Path::new(&job.path).with_extension("apng");
        job.path = path.to_string_lossy().into_owned();
        job.is_loop = true;
    }
    jobs
}

impl Job<'_> {
    /// What the step's figure shows; of a picture that asks, and of each of all moments, the step's title.
    pub fn title(&self, options: Options) -> Option<&str> {
        let lang = options.lang;
        match self.source {
            Source::Step(lesson, step) => {
                let is_shown = !options.asks && options.steps == Steps::Figures;
                lesson.step_heading(lesson.step_index(&step.id)?, lang, is_shown)
            }
            Source::File(_) => None,
        }
    }

    pub fn picture(&self, options: Options) -> Picture<'_> {
        Picture {
            title: self.title(options),
            scene: self.source.scene(),
            lesson: match self.source {
                Source::Step(lesson, _) => Some(lesson),
                Source::File(_) => None,
            },
            step: self.position,
            before: match self.source {
                Source::Step(_, step) => step.before.as_ref(),
                Source::File(_) => None,
            },
            foot: None,
            options,
        }
    }

    /// To what the picture shows.
    pub fn link(&self, options: Options) -> Option<String> {
        let stand = Stand {
            scene: self.source.scene(),
            position: self.position,
            moment: &self.moment,
            step: match self.source {
                Source::Step(lesson, step) => Some((lesson, step)),
                Source::File(_) => None,
            },
        };
        let lang = Some(options.lang).filter(|lang| *lang != Lang::default());
        let link = stand.link(SceneFormats::standard());
        Link { lang, ..link }.fitting()
    }

    fn link_on(&self, page: Option<&str>, options: Options) -> Option<String> {
        let link = self.link(options)?;
        Some(page.unwrap_or_default().to_owned() + &link)
    }

    /// Are both pictures of one lesson?
    pub fn is_beside(&self, other: &Self) -> bool {
        match (self.source, other.source) {
            (Source::Step(a, _), Source::Step(b, _)) => a.id == b.id,
            _ => false,
        }
    }

    /// With its link, behind the address of a page where there is one: then it is printed in the picture's foot, too.
    pub fn png(&self, studio: &mut Studio, options: Options, page: Option<&str>) -> Vec<u8> {
        let link = self.link_on(page, options);
        let picture = Picture {
            foot: link.as_deref().filter(|_| page.is_some()),
            ..self.picture(options)
        };
        studio.draw(&picture).to_linked_png(link.as_deref())
    }

    /// Its run as a loop, with the link to what the step's own picture shows.
    pub fn animation(&self, studio: &mut Studio, options: Options, page: Option<&str>) -> Vec<u8> {
        let options = Options {
            steps: Steps::All,
            ..options
        };
        let link = self.link_on(page, options);
        let runs = self.source.scene().document().record();
        let n_steps = runs.first().map_or(0, |run| run.n_steps());
        let pictures = (0..=n_steps).map(|step| {
            studio.draw(&Picture {
                step,
                foot: link.as_deref().filter(|_| page.is_some()),
                ..self.picture(options)
            })
        });
        animated(n_steps + 1, pictures, link.as_deref())
    }

    fn write(&self, content: &Content, out: &Path) -> io::Result<()> {
        let path = out.join(&self.path);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        if let Some(alternative) = &content.alternative {
            write_whole(&path.with_extension("txt"), alternative.as_bytes())?;
        }
        write_whole(&path, &content.picture)
    }
}

/// What is written of a job.
#[derive(Debug)]
pub struct Content {
    /// The file's bytes.
    pub picture: Vec<u8>,
    /// In words, beside it.
    pub alternative: Option<String>,
}

#[derive(Debug)]
pub struct Failure {
    pub path: String,
    pub error: io::Error,
}

/// Figures of a lesson that one thread draws, as its runs are recorded once for all of them.
const MOST_IN_LOT: usize = 16;

/// What threads take from the jobs: those that follow each other in a lesson.
fn lots(jobs: &[Job<'_>]) -> Vec<Range<usize>> {
    let mut lots = Vec::new();
    let mut first = 0;
    for alike in jobs.chunk_by(Job::is_beside) {
        for lot in alike.chunks(MOST_IN_LOT) {
            lots.push(first..first + lot.len());
            first += lot.len();
        }
    }
    lots
}

/// Draws with `draw` and writes all pictures on all cores; `done` hears of each on the calling thread. The
/// failures come in the order of the jobs.
pub fn run(
    jobs: &[Job<'_>],
    theme: ThemeKind,
    out: &Path,
    draw: impl Fn(&Job<'_>, &mut Studio) -> Content + Sync,
    mut done: impl FnMut(),
) -> Vec<Failure> {
    let lots = lots(jobs);
    let next = AtomicUsize::new(0);
    let failures = Mutex::new(Vec::new());
    let n_threads = thread::available_parallelism()
        .map_or(1, NonZero::get)
        .min(lots.len());
    thread::scope(|scope| {
        let (finished, each_finished) = mpsc::channel();
        for _ in 0..n_threads {
            let finished = finished.clone();
            let (next, lots, failures, draw) = (&next, &lots, &failures, &draw);
            scope.spawn(move || {
                let mut studio = Studio::new(theme);
                let take = || lots.get(next.fetch_add(1, Ordering::Relaxed));
                let lots = std::iter::from_fn(take);
                for (i, job) in lots.flat_map(|lot| lot.clone().zip(&jobs[lot.clone()])) {
                    if let Err(error) = job.write(&draw(job, &mut studio), out) {
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
