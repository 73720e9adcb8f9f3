//! Figures through the shipped program, from its start to its end: `target/release/clipscope export`.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::Instant,
};

use crate::harness::{Target, median};

/// Pixels of a figure.
pub const SIZE_PX: [u32; 2] = [1920, 1080];
/// Names the program where it is not the one that `cargo build --release` leaves.
const PROGRAM: &str = "CLIPSCOPE";
const N_SINGLE: usize = 21;
const N_COURSES: usize = 5;

/// Runs everything and prints the section.
pub fn run() {
    let program = program();
    let [width, height] = SIZE_PX;
    let n_threads = std::thread::available_parallelism().map_or(1, usize::from);
    println!("## Export\n");
    println!(
        "{width} × {height}, process start and writing included, {n_threads} threads; medians of {N_SINGLE} runs \
         of one figure and of {N_COURSES} of the course.\n"
    );
    println!("| what | figures | s | figures a second | target | |\n|---|--:|--:|--:|--:|---|");
    let one = concat!(env!("CARGO_MANIFEST_DIR"), "/one-figure");
    let (n, secs) = measure(&program, &[one], N_SINGLE);
    assert_eq!(n, 1, "{one} has one figure");
    let cells = Target::AtMost(0.3).cells(secs);
    println!("| one figure | {n} | {secs:.3} | | {cells} |");
    for (name, args, target) in [
        ("the course", &[][..], Target::AtLeast(15.0)),
        (
            "every step of its runs",
            &["--steps", "all"],
            Target::AtLeast(15.0),
        ),
        ("its windows", &["--window"], Target::None),
        ("in Chinese", &["--lang", "zh-CN"], Target::None),
    ] {
        let (n, secs) = measure(&program, args, N_COURSES);
        let rate = n as f64 / secs;
        println!(
            "| {name} | {n} | {secs:.2} | {rate:.0} | {} |",
            target.cells(rate)
        );
    }
    println!();
}

/// Number of figures, and the median of the seconds that all of them take.
fn measure(program: &Path, args: &[&str], n_runs: usize) -> (usize, f64) {
    let mut n_figures = 0;
    let secs: Vec<f64> = (0..n_runs)
        .map(|_| {
            let out = tempfile::tempdir().expect("a folder for figures");
            let mut command = Command::new(program);
            command
                .arg("export")
                .args(args)
                .arg("--out")
                .arg(out.path())
                .args(["--size", &SIZE_PX.map(|side| side.to_string()).join("x")])
                .stdout(Stdio::null())
                .stderr(Stdio::null());
            let start = Instant::now();
            let status = command.status().expect("a program that starts");
            let secs = start.elapsed().as_secs_f64();
            assert!(status.success(), "{command:?}: {status}");
            n_figures = count(out.path());
            secs
        })
        .collect();
    (n_figures, median(secs))
}

/// Files in the folders of this one.
fn count(out: &Path) -> usize {
    let entries = |folder: &Path| fs::read_dir(folder).expect("a folder").flatten();
    entries(out)
        .map(|folder| entries(&folder.path()).count())
        .sum()
}

fn program() -> PathBuf {
    let built = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/release/clipscope");
    let program = env::var_os(PROGRAM).map_or_else(|| built.into(), PathBuf::from);
    assert!(
        program.is_file(),
        "no {}: run `cargo build --release` first, or name the program in {PROGRAM}",
        program.display()
    );
    program
}
