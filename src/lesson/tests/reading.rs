//! Lessons and scenes in order: what is read is what was written.

use crate::{
    figure::Moment,
    geom::Segment,
    labs::Scene,
    text::{Catalog, Lang},
};

use super::*;

#[test]
fn a_lesson_in_order_loads() {
    let loaded = Course::check(&lesson(&[]));
    assert_eq!(loaded.problems, []);
    let lesson = loaded.course.lesson("01-a").expect("the lesson loads");
    assert_eq!(lesson.source, "D. Cohen and I. Sutherland, 1967");
    let [first, second] = &lesson.steps[..] else {
        panic!("two steps, not {}", lesson.steps.len());
    };
    assert_eq!(first.moment, Moment::Start);
    assert_eq!(first.position(), Some(0));
    assert_eq!(first.figure.as_deref(), Some("one"));
    assert_eq!(second.scene, first.scene, "a step keeps the scene");
    assert!(second.position() > Some(0), "the end comes after the start");
    assert_eq!(second.code, CodeView::Words);
    assert_eq!(second.locks.len(), 1);
    let text = |step| &lesson.step_text(step, Lang::En).expect("its text").body[..];
    assert_eq!(lesson.title(Lang::En), "Regions");
    assert_eq!(lesson.step_title(0, Lang::En), Some("The first step"));
    let [Block::Paragraph(question), Block::Answer(answer)] = text(0) else {
        panic!("a question and its answer, not {:?}", text(0));
    };
    assert!(question[1].emphasis && question[1].text == "this");
    assert_eq!(answer.len(), 1);
    assert_eq!(text(1).len(), 2);
}

#[test]
fn a_missing_translation_is_read_in_english() {
    let mut files = lesson(&[]);
    files.remove("01-a/es.md");
    assert_eq!(found(&files), ["es.md missing-language"]);
    let course = Course::check(&files).course;
    assert!(!course.lessons[0].speaks(Lang::Es));
    assert_eq!(course.lessons[0].title(Lang::Es), "Regions");
    files.remove("01-a/en.md");
    let both = ["en.md missing-file", "es.md missing-language"];
    assert_eq!(found(&files), both);
    assert_eq!(Course::check(&files).course.lessons, []);
}

#[test]
fn text_is_parsed_into_blocks() {
    let body = "Line\nbreak **bold *both*** end.\n\n甲\n乙 `a\u{3b1}`\n\n3. c\n   - d\n\n     e\n4. f\n\n```text\nx = 1\n```\n\n> q\n>\n> - r\n";
    let text = TEXT.replace("- one\n- two\n", body);
    let loaded = Course::check(&with(LESSON, &text));
    assert_eq!(loaded.problems, []);
    let plain = |text: &str| Inline {
        text: text.to_owned(),
        ..Inline::default()
    };
    let item = |depth, marker, text| Block::ListItem {
        depth,
        marker,
        text: vec![plain(text)],
    };
    let bold = |emphasis, text| Inline {
        strong: true,
        emphasis,
        ..plain(text)
    };
    let expected = [
        Block::Paragraph(vec![
            plain("Line break "),
            bold(false, "bold "),
            bold(true, "both"),
            plain(" end."),
        ]),
        Block::Paragraph(vec![
            plain("甲乙 "),
            Inline {
                code: true,
                ..plain("aα")
            },
        ]),
        item(0, BlockMarker::Number(3), "c"),
        item(1, BlockMarker::Bullet, "d"),
        item(1, BlockMarker::Continued, "e"),
        item(0, BlockMarker::Number(4), "f"),
        Block::Code("x = 1\n".to_owned()),
        Block::Answer(vec![
            Block::Paragraph(vec![plain("q")]),
            item(0, BlockMarker::Bullet, "r"),
        ]),
    ];
    let text = loaded.course.lessons[0].step_text(1, Lang::En);
    assert_eq!(text.expect("its text").body, expected);
}

fn segments_of(scene: &Scene) -> &[Segment] {
    let scene = scene.get::<crate::labs::lines::Scene>();
    scene.expect("of the lines lab").segments()
}

#[test]
fn scenes_come_back_bit_for_bit() {
    let toml = "method = \"cohen-sutherland\"
compare = \"cohen-sutherland\"
window = [-1, -1, 1, 1e300]
clip = [[0, 0], [1, 2], [2, 0]]
bit_order = \"lrbt\"
focus = 1
segments = [[-0.0, 0.1, 5e-324, 0.30000000000000004], [1e15, 9007199254740993, 0xff, 1_000.5]]
";
    let formats = SceneFormats::standard();
    let read = |text: &str| formats.read("a.toml", text.as_bytes());
    let scene = read(toml).expect("a scene in order").scene;
    let text = formats.write(&scene, &Moment::Start);
    let again = read(&text).expect("a scene as it was written").scene;
    let bits = |scene: &Scene| -> Vec<u64> {
        let numbers = segments_of(scene).iter().flat_map(|s| s.to_array());
        numbers.map(f64::to_bits).collect()
    };
    assert_eq!((&again, bits(&again)), (&scene, bits(&scene)), "{text}");
    assert_eq!(formats.write(&again, &Moment::Start), text);
    for line in [
        "    [-0.0, 0.1, 5e-324, 0.30000000000000004],\n",
        "window = [-1, -1, 1, 1e300]\n",
    ] {
        assert!(text.contains(line), "{text}");
    }
    let problems = read("method = 1\nwindow = [0]").expect_err("a broken scene");
    let spots: Vec<String> = problems.iter().map(spot).collect();
    let expected = ["1:1 missing-field", "1:10 wrong-type", "2:10 wrong-length"];
    assert_eq!(spots, expected.map(|spot| format!("a.toml:{spot}")));
}

#[test]
fn the_embedded_course_is_in_order_and_complete() {
    let loaded = Course::check(&Embedded);
    let render = |problem: &Problem| problem.render(Catalog::of(Lang::En));
    let problems: Vec<String> = loaded.problems.iter().map(render).collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    for lesson in &loaded.course.lessons {
        for lang in Lang::ALL {
            assert!(lesson.speaks(lang), "{} has no {lang}.md", lesson.id);
        }
    }
}

#[test]
fn a_folder_is_read_like_the_embedded_course() {
    let root = tempfile::tempdir().expect("a folder");
    for (path, bytes) in lesson(&[("at = \"end\"", "at = \"never\"")]) {
        let path = root.path().join(path);
        std::fs::create_dir_all(path.parent().expect("a parent")).expect("a lesson's folder");
        std::fs::write(path, bytes).expect("a file");
    }
    std::fs::write(root.path().join("README.md"), "Mine.").expect("a file");
    for folder in [root.path().to_owned(), root.path().join("01-a")] {
        let problems = Course::check(&Folder::new(&folder)).problems;
        let file = root.path().join("01-a").join("lesson.toml");
        assert_eq!(problems.len(), 1, "{problems:?}");
        assert_eq!(problems[0].file, file.display().to_string());
    }
    let problems = |path| Course::check(&Folder::new(root.path().join(path))).problems;
    assert_eq!(problems("gone")[0].code(), "unreadable");
    assert_eq!(problems("01-a/..").len(), 1);
}

#[test]
fn large_files_are_read_in_no_time() {
    let segments = "[-2, -1, 2, 1.5],\n".repeat(100_000);
    let files = lesson(&[("[0, 0, 1, 1]]", &format!("{segments}]"))]);
    let loaded = Course::check(&files);
    assert_eq!(loaded.problems, []);
    let scene = &loaded.course.lessons[0].steps[0].scene;
    assert_eq!(segments_of(scene).len(), 100_001);
    let written = SceneFormats::standard().write(scene, &Moment::Start);
    let again = SceneFormats::standard().read("a.toml", written.as_bytes());
    assert!(again.is_ok());
    let sections = (0..100_000).map(|i| format!("## s{i}: T\n\nt\n\n"));
    let sections = sections.collect::<Vec<_>>().concat();
    let problems = Course::check(&with(LESSON, &format!("{TEXT}{sections}"))).problems;
    assert_eq!(problems.len(), 4 * 101);
}

/// Nobody but the speaker sees it: it is no part of the text, and its references are filled in all the same.
#[test]
fn a_note_is_for_the_speaker() {
    let body = "A {scene.window[0]}.\n\n!> Wait for **{scene.window[2]}**\n!> answers.\n\n!> Then go on.\n\nB {scene.window[3]}.\n";
    let text = TEXT.replace("- one\n- two\n", body);
    let loaded = Course::check(&with(LESSON, &text));
    assert_eq!(loaded.problems, []);
    let text = loaded.course.lessons[0].step_text(1, Lang::En);
    let text = text.expect("its text");
    let said = |blocks: &[Block]| -> Vec<String> {
        let of_block = |block: &Block| match block {
            Block::Paragraph(parts) | Block::Note(parts) => {
                parts.iter().map(|it| &*it.text).collect()
            }
            other => panic!("{other:?}"),
        };
        blocks.iter().map(of_block).collect()
    };
    let [note, more] = &said(&text.note)[..] else {
        panic!("two notes, not {:?}", text.note);
    };
    let body = said(&text.body);
    assert_eq!(body.len(), 2);
    assert!(
        note.starts_with("Wait for ") && note.ends_with(" answers."),
        "{note}"
    );
    assert_eq!(more, "Then go on.");
    assert!(body.iter().all(|text| !text.contains('⟦')), "{body:?}");
}

const CARD: &str = "
## card

- rule: Go **on**.
- formula: `x ≥ 1`
- cost: One comparison.
- pitfall: The border.
- pitfall: The sign.
- can: tell which.
";

#[test]
fn a_step_says_what_it_shows_and_a_lesson_what_is_to_be_kept() {
    let claim = "## second: The second step\n\n=> From {scene.window[0]}\n";
    let text = TEXT.replace("## second: The second step\n", claim) + CARD;
    let loaded = Course::check(&with(LESSON, &text));
    assert_eq!(loaded.problems, []);
    let lesson = &loaded.course.lessons[0];
    let claims = [0, 1].map(|idx| lesson.step_claim(idx, Lang::En));
    assert_eq!(claims, [Some("The first step"), Some("From −1")]);
    let card = lesson.card(Lang::Es).expect("a card");
    let rows = card.rows.iter().map(|(row, _)| row.id());
    let rows: Vec<_> = rows.collect();
    let expected = ["rule", "formula", "cost", "pitfall", "pitfall", "can"];
    assert_eq!(rows, expected);
    let said = |i: usize| card.rows[i].1.iter().map(|part| &*part.text);
    assert_eq!(said(0).collect::<String>(), "Go on.");
    assert!(card.rows[1].1[0].code, "{:?}", card.rows[1]);
    assert_eq!(lesson.steps.len(), 2, "a card is no step");
}

#[test]
fn a_lesson_that_has_moved_is_found_by_its_name() {
    let course = Course::check(&lesson(&[])).course;
    for id in ["01-a", "07-a", "a"] {
        assert_eq!(course.lesson_index(id), Some(0), "{id}");
    }
    assert_eq!(course.lesson_index("01-b"), None);
}

#[test]
fn a_translation_is_stale_once_its_english_has_changed() {
    let mut files = lesson(&[]);
    let langs = [Lang::ZhCn, Lang::Es, Lang::PtBr];
    let known = translated(TEXT, &langs);
    files.insert(format!("01-a/{TRANSLATED_FILE}"), known.into());
    assert_eq!(found(&files), [""; 0]);
    let changed = TEXT.replace("- two", "- two\n- three");
    files.insert("01-a/en.md".to_owned(), changed.into());
    let stale = ["es", "pt-BR", "zh-CN"].map(|lang| format!("{lang}.md:9:1 stale-translation"));
    assert_eq!(found(&files), stale);
    // White space is no word.
    let spaced = TEXT.replace("- two", "-  two\n\n");
    files.insert("01-a/en.md".to_owned(), spaced.into());
    assert_eq!(found(&files), [""; 0]);
    files.insert(format!("01-a/{TRANSLATED_FILE}"), b"[es".to_vec());
    assert_eq!(
        found(&files).len(),
        6,
        "what cannot be read says of nothing that it is fresh"
    );
}
