//! Clipscope's speed, measured against its peers, against code written by hand, and against its targets.
//!
//! ```text
//! cargo build --release                       # what `export` runs
//! cargo run --release --manifest-path benches/Cargo.toml [--features gui] [--] [NAME...]
//! ```
//!
//! prints one Markdown section for each named benchmark, or for all of them. All figures of a table come from
//! one run with interleaved rounds, so that a busy machine slows every contender alike; the ratios are what
//! counts. Each benchmark runs in a process of its own: what one leaves free, the next one's peers need not ask the
//! system for, which can halve their time. What is drawn (feature `gui`) has no peer: there the medians are in
//! milliseconds.

#[cfg(feature = "gui")]
mod answers;
#[cfg(feature = "gui")]
mod desk;
#[cfg(feature = "gui")]
mod export;
#[cfg(feature = "gui")]
mod frame;
mod hand_written;
mod harness;
#[cfg(feature = "gui")]
mod large;
mod line;
#[cfg(feature = "gui")]
mod paint;
mod painter;
mod plot;
mod polygon;
mod rays;
mod space;
mod space_triangles;
mod textured;
#[cfg(feature = "gui")]
mod turning;
mod weiler_atherton;

use std::{
    env, io,
    process::{Command, ExitCode},
};

/// A benchmark: its name on the command line, and what prints its section.
type Benchmark = (&'static str, fn());

const BENCHMARKS: &[Benchmark] = &[
    ("line", line::run),
    ("polygon", polygon::run),
    ("weiler-atherton", weiler_atherton::run),
    ("space", space::run),
    ("textured", textured::run),
    ("space-triangles", space_triangles::run),
    ("painter", painter::run),
    ("rays-growth", rays::growth),
    ("rays", rays::spot),
    #[cfg(feature = "gui")]
    ("frame", frame::run),
    #[cfg(feature = "gui")]
    ("space-frames", frame::run_in_space),
    #[cfg(feature = "gui")]
    ("large-steps", large::run),
    #[cfg(feature = "gui")]
    ("answers", answers::run),
    #[cfg(feature = "gui")]
    ("paint", paint::run),
    #[cfg(feature = "gui")]
    ("turning", turning::run),
    #[cfg(feature = "gui")]
    ("export", export::run),
];

fn main() -> ExitCode {
    let names: Vec<String> = env::args().skip(1).collect();
    let is_known = |name: &&String| BENCHMARKS.iter().any(|(known, _)| known == name);
    if let Some(unknown) = names.iter().find(|name| !is_known(name)) {
        let known: Vec<&str> = BENCHMARKS.iter().map(|(name, _)| *name).collect();
        eprintln!(
            "no benchmark is called {unknown}: there are {} (frame, space-frames, large-steps, answers, paint, turning and export with `--features gui`)",
            known.join(", ")
        );
        return ExitCode::from(2);
    }
    let is_wanted =
        |(name, _): &&Benchmark| names.is_empty() || names.iter().any(|wanted| wanted == name);
    let wanted: Vec<&Benchmark> = BENCHMARKS.iter().filter(is_wanted).collect();
    if let [(_, run)] = wanted[..] {
        println!("Machine: {}\n", harness::machine());
        run();
        return ExitCode::SUCCESS;
    }
    for (name, _) in wanted {
        if let Err(error) = apart(name) {
            eprintln!("{name}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// Runs one benchmark in a process of its own.
fn apart(name: &str) -> io::Result<()> {
    let status = Command::new(env::current_exe()?).arg(name).status()?;
    if status.success() {
        Ok(())
    } else {
        Err(io::Error::other(status.to_string()))
    }
}
