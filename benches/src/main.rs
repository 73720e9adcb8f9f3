//! Clipscope's speed, measured against its peers and against code written by hand.
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml [--] [NAME...]
//! ```
//!
//! prints one Markdown section for each named benchmark, or for all of them. All figures come from one run
//! with interleaved rounds, so that a busy machine slows every contender alike; the ratios are what counts.

mod hand_written;
mod harness;
mod line;

use std::process::ExitCode;

/// A benchmark: its name on the command line, and what prints its section.
type Benchmark = (&'static str, fn());

const BENCHMARKS: [Benchmark; 1] = [("line", line::run)];

fn main() -> ExitCode {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let is_known = |name: &&String| BENCHMARKS.iter().any(|(known, _)| known == name);
    if let Some(unknown) = names.iter().find(|name| !is_known(name)) {
        let known = BENCHMARKS.map(|(name, _)| name).join(", ");
        eprintln!("no benchmark is called {unknown}: there are {known}");
        return ExitCode::from(2);
    }
    println!("Machine: {}\n", harness::machine());
    for (name, run) in BENCHMARKS {
        if names.is_empty() || names.iter().any(|wanted| wanted == name) {
            run();
        }
    }
    ExitCode::SUCCESS
}
