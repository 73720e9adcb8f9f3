//! Bytes as the folder of a lesson: files one after the other, each after a line `=== name`. Whatever is wrong is told with its place, and
//! what is in order is shown without a hole.
#![no_main]

use std::collections::BTreeMap;

use clipscope::{
    lesson::{Course, Severity},
    text::{Catalog, Lang},
};
use libfuzzer_sys::fuzz_target;

/// A run on more than this may take longer than a fuzzer's patience.
const MOST: usize = 200;

fuzz_target!(|bytes: &[u8]| {
    // Marks a hole in a text, so it is not to come from outside.
    if String::from_utf8_lossy(bytes).contains('⟦') {
        return;
    }
    let lang = Lang::ALL[bytes.len() % Lang::ALL.len()];
    let files = files(bytes);
    // Read, not run: moments and references are asked below, where scenes are small.
    let loaded = Course::load(&files);
    for problem in &loaded.problems {
        let said = problem.render(Catalog::of(lang));
        assert!(!said.contains('⟦'), "{said}");
        assert!(!said.contains(|c: char| c.is_control() && c != '\n'), "{said:?}");
    }
    let size = |scene: &clipscope::labs::Scene| scene.document().size();
    let lessons = &loaded.course.lessons;
    let mut scenes = lessons.iter().flat_map(|lesson| &lesson.steps).map(|step| &*step.scene);
    if scenes.any(|scene| size(scene) > MOST) {
        return;
    }
    let checked = Course::check(&files);
    let is_error = |problem: &&clipscope::lesson::Problem| problem.severity == Severity::Error;
    for problem in &checked.problems {
        assert!(!problem.render(Catalog::of(lang)).contains('⟦'));
    }
    if checked.problems.iter().any(|problem| is_error(&problem)) {
        return;
    }
    for lesson in &checked.course.lessons {
        for step in 0..lesson.steps.len() {
            let text = lesson.step_text(step, lang).expect("each step has a text");
            assert!(!format!("{text:?}").contains("⟦no-value⟧"), "{text:?}");
            assert!(lesson.step_title(step, lang).is_some());
        }
    }
});

fn files(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut open: Option<String> = None;
    for line in bytes.split_inclusive(|byte| *byte == b'\n') {
        if let Some(name) = line.strip_prefix(b"=== ") {
            let name = String::from_utf8_lossy(name).trim().to_owned();
            files.insert(format!("a/{name}"), Vec::new());
            open = Some(name);
        } else if let Some(name) = &open {
            let file: &mut Vec<u8> = files.entry(format!("a/{name}")).or_default();
            file.extend_from_slice(line);
        }
    }
    files
}
