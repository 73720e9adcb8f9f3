//! All figures of a course, drawn and written on all cores.

use std::{
    io,
    num::NonZero,
    ops::Range,
    path::Path,
    sync::{
        atomic::{AtomicUsize, Ordering},
        mpsc,
    },
    thread,
};

use crate::paint::ThemeKind;

use super::{figure::Studio, files::write_whole, jobs::Job, shapes::Made};

/// What is written of a job.
pub struct Content {
    pub made: Made,
    /// In words, beside it.
    pub alternative: Option<String>,
}

fn write(job: &Job<'_>, content: &Content, out: &Path) -> io::Result<()> {
    let path = out.join(&job.path);
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    if let Some(alternative) = &content.alternative {
        write_whole(&path.with_extension("txt"), alternative.as_bytes())?;
    }
    for (suffix, bytes) in &content.made.beside {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        write_whole(&path.with_file_name(name.into_owned() + suffix), bytes)?;
    }
    write_whole(&path, &content.made.bytes)
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
    // A loop is a run by itself: it takes long, and shares little.
    let share = |a: &Job<'_>, b: &Job<'_>| a.is_beside(b) && !a.is_loop() && !b.is_loop();
    for alike in jobs.chunk_by(share) {
        for lot in alike.chunks(MOST_IN_LOT) {
            lots.push(first..first + lot.len());
            first += lot.len();
        }
    }
    lots
}

/// Pictures that may wait to be written, for each thread that draws.
const MOST_WAITING: usize = 2;

/// Draws all pictures with `draw` on all cores. The calling thread writes them, as the disk is waited for there, and says `done`
/// after each. The failures come in the order of the jobs.
pub fn run(
    jobs: &[Job<'_>],
    theme: ThemeKind,
    out: &Path,
    draw: impl Fn(&Job<'_>, &mut Studio) -> Content + Sync,
    mut done: impl FnMut(),
) -> Vec<Failure> {
    let lots = lots(jobs);
    let next = AtomicUsize::new(0);
    let n_threads = thread::available_parallelism()
        .map_or(1, NonZero::get)
        .min(lots.len());
    let mut failures = Vec::new();
    thread::scope(|scope| {
        let (drawn, each_drawn) = mpsc::sync_channel(MOST_WAITING * n_threads);
        for _ in 0..n_threads {
            let drawn = drawn.clone();
            let (next, lots, draw) = (&next, &lots, &draw);
            scope.spawn(move || {
                let mut studio = Studio::new(theme);
                let take = || lots.get(next.fetch_add(1, Ordering::Relaxed));
                for i in std::iter::from_fn(take).cloned().flatten() {
                    if drawn.send((i, draw(&jobs[i], &mut studio))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(drawn);
        for (i, content) in each_drawn {
            let job = &jobs[i];
            if let Err(error) = write(job, &content, out) {
                let path = out.join(&job.path).display().to_string();
                failures.push((i, Failure { path, error }));
            }
            done();
        }
    });
    failures.sort_by_key(|(i, _)| *i);
    failures.into_iter().map(|(_, failure)| failure).collect()
}
