//! Bytes as a scene file: what is read is written and read again as the very same scene, at the same step.
#![no_main]

use clipscope::{
    lesson::SceneFormats,
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
    let formats = SceneFormats::standard();
    let read = match formats.read("a.toml", bytes) {
        Ok(read) => read,
        Err(problems) => {
            assert!(!problems.is_empty(), "a refusal says why");
            for problem in problems {
                let said = problem.render(Catalog::of(lang));
                assert!(!said.contains('⟦'), "{said}");
            }
            return;
        }
    };
    let document = read.scene.document();
    if document.size() > MOST {
        return;
    }
    let runs = document.record();
    let moment = runs[0].moment(read.position.min(runs[0].n_steps()));
    let text = formats.write(&read.scene, &moment);
    let again = formats.read("a.toml", text.as_bytes());
    let again = again.unwrap_or_else(|problems| {
        let said = problems.iter().map(|it| it.render(Catalog::of(lang)));
        panic!("{text}\n{}", said.collect::<Vec<_>>().join("\n"))
    });
    assert_eq!(again.scene, read.scene, "{text}");
    for run in &runs {
        let last = run.n_steps();
        for step in [0, last / 2, last] {
            let said = Catalog::of(lang).message(&run.caption(step).decision);
            assert!(!said.contains('⟦'), "{said}");
        }
    }
});
