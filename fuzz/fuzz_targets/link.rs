//! Bytes as a link, and as the scene that a link packs: what opens is spelt as a link again, which opens the same.
#![no_main]

use std::sync::LazyLock;

use clipscope::{
    lesson::{Course, Link, Opens, SceneFormats, Stand, link_in, said},
    text::{Catalog, Lang},
};
use libfuzzer_sys::fuzz_target;

/// A run on more than this may take longer than a fuzzer's patience.
const MOST: usize = 200;

static COURSE: LazyLock<Course> = LazyLock::new(Course::embedded);

fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    // Marks a hole in a text, so it is not to come from outside.
    if text.contains('⟦') {
        return;
    }
    let _ = link_in(bytes);
    let formats = SceneFormats::standard();
    let packed = Link::to(Opens::Scene(text.to_string(), None));
    for link in [text.parse(), Ok(packed)] {
        let opened = link
            .map_err(said)
            .and_then(|link: Link| COURSE.open_link(&link, formats));
        let opened = match opened {
            Ok(opened) => opened,
            Err(problems) => {
                assert!(!problems.is_empty(), "a refusal says why");
                for problem in problems {
                    let said = problem.render(Catalog::of(Lang::En));
                    assert!(!said.contains('⟦'), "{said}");
                }
                continue;
            }
        };
        let document = opened.scene.document();
        if document.size() > MOST {
            continue;
        }
        let run = &document.record()[0];
        let position = opened.position.min(run.n_steps());
        let page = opened.page.map(|[lesson, step]| {
            let lesson = &COURSE.lessons[lesson];
            (lesson, &lesson.steps[step])
        });
        let stand = Stand {
            scene: &opened.scene,
            position,
            moment: &run.moment(position),
            step: page,
        };
        let link = stand.link(formats).to_string();
        let again = link.parse().map_err(said);
        let again = again.and_then(|link: Link| COURSE.open_link(&link, formats));
        let again = again.unwrap_or_else(|_| panic!("{link} opens again"));
        assert_eq!(again.scene, opened.scene, "{link}");
        assert_eq!(again.page, opened.page, "{link}");
        assert_eq!(again.position.min(run.n_steps()), position, "{link}");
    }
});
