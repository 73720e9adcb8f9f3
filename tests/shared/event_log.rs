//! The event log of a run as text, compared with the one that was accepted; several tests include this file.

use std::{fs, path::PathBuf};

use clipscope::trace::{Method, Recording};
use serde::Serialize;

/// Holds a run's events and its cost to `tests/snapshots/<name>.ndjson`; `UPDATE_SNAPSHOTS=1` writes what they
/// now are.
pub fn check<M: Method<Event: Serialize>>(name: &str, input: M::Input) {
    let run = Recording::<M>::new(input);
    let (events, counts) = (run.events(), run.counts_at(usize::MAX));
    let mut log = String::new();
    for event in events {
        log += &serde_json::to_string(event).expect("an event is JSON");
        log += "\n";
    }
    log += &serde_json::to_string(&counts).expect("counts are JSON");
    log += "\n";
    let path =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("tests/snapshots/{name}.ndjson"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder is made");
        fs::write(&path, &log).expect("the log is written");
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(
        log,
        expected,
        "the events of {name}, as in {}",
        path.display()
    );
}
