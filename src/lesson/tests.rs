//! Broken lessons, each with the place and the code of what is wrong; and lessons that are in order.

use std::collections::BTreeMap;

use crate::{
    figure::Moment,
    labs::lines::Scene,
    text::{Catalog, Lang},
};

use super::*;

const LESSON: &str = r#"lab = "lines"
source = "D. Cohen and I. Sutherland, 1967"

[scenes.practice]
method = "cohen-sutherland"
window = [-1, -1, 1, 1]
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]]

[[step]]
id = "first"
scene = "practice"
figure = "one"

[[step]]
id = "second"
at = "end"
lock = ["window"]
code = "words"
"#;

const TEXT: &str = "# Regions

## first: The first step

What is *this*?

> The **answer** is `0000`.

## second: The second step

- one
- two
";

type Memory = BTreeMap<String, Vec<u8>>;

fn with(toml: &str, english: &str) -> Memory {
    let texts = Lang::ALL.map(|lang| (format!("01-a/{lang}.md"), english.into()));
    let mut files: Memory = texts.into_iter().collect();
    files.insert("01-a/lesson.toml".to_owned(), toml.into());
    files
}

/// `line:column code` of each problem of the one lesson, without its folder.
fn found(files: &Memory) -> Vec<String> {
    let problems = Course::load(files).problems;
    problems.iter().map(spot).collect()
}

fn spot(problem: &Problem) -> String {
    let file = problem.file.trim_start_matches("01-a/");
    let place = problem.place.as_ref();
    let place = place.map_or(String::new(), |p| format!(":{}:{}", p.line, p.column));
    format!("{file}{place} {}", problem.code())
}

/// The lesson with each replacement made once.
fn lesson(replacements: &[(&str, &str)]) -> Memory {
    let mut toml = LESSON.to_owned();
    for (old, new) in replacements {
        assert!(toml.contains(old), "the lesson has no {old:?}");
        toml = toml.replacen(old, new, 1);
    }
    with(&toml, TEXT)
}

#[test]
fn a_lesson_in_order_loads() {
    let loaded = Course::load(&lesson(&[]));
    assert_eq!(loaded.problems, []);
    let lesson = loaded.course.lesson("01-a").expect("the lesson loads");
    assert_eq!(lesson.source, "D. Cohen and I. Sutherland, 1967");
    let [first, second] = &lesson.steps[..] else {
        panic!("two steps, not {}", lesson.steps.len());
    };
    assert_eq!((first.moment.clone(), first.position), (Moment::Start, 0));
    assert_eq!(first.figure.as_deref(), Some("one"));
    assert_eq!(second.scene, first.scene, "a step keeps the scene");
    assert!(second.position > 0, "the end comes after the start");
    assert_eq!(second.code, CodeView::Words);
    assert_eq!(second.locks.len(), 1);
    let text = lesson.text(Lang::En);
    assert_eq!(text.title, "Regions");
    assert_eq!(text.steps[0].title, "The first step");
    let [Block::Paragraph(question), Block::Answer(answer)] = &text.steps[0].body[..] else {
        panic!("a question and its answer, not {:?}", text.steps[0].body);
    };
    assert!(question[1].emphasis && question[1].text == "this");
    assert_eq!(answer.len(), 1);
    assert_eq!(text.steps[1].body.len(), 2);
}

#[test]
fn every_mistake_in_a_lesson_file_has_its_place() {
    let window = "window = [-1, -1, 1, 1]";
    let segments = "segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]]";
    let clip = |clip: &str| format!("{window}\nclip = {clip}");
    let mut wrong = Vec::new();
    for (old, new, expected) in [
        ("lab =", "lba =", "1:1 unknown-field"),
        ("lab = \"lines\"\n", "", "1:1 missing-field"),
        ("\"lines\"", "\"line\"", "1:7 unknown-lab"),
        ("\"lines\"", "7", "1:7 wrong-type"),
        (
            "source = \"D. Cohen and I. Sutherland, 1967\"\n",
            "",
            "1:1 missing-field",
        ),
        (
            "\"D. Cohen and I. Sutherland, 1967\"",
            "\" \"",
            "2:10 empty-text",
        ),
        (
            "\"cohen-sutherland\"",
            "\"cohen-suterland\"",
            "5:10 unknown-method",
        ),
        ("method = \"cohen-sutherland\"\n", "", "4:1 missing-field"),
        (window, "windw = [-1, -1, 1, 1]", "6:1 unknown-field"),
        (window, "window = [-1, -1, 1]", "6:10 wrong-length"),
        (window, "window = [-1, -1, 1, inf]", "6:22 not-finite"),
        (window, "window = [-1, -1, 1, 1e999]", "6:22 not-finite"),
        (window, "window = [-1, nan, 1, 1]", "6:15 not-finite"),
        (window, "window = [-1, \"a\", 1, 1]", "6:15 wrong-type"),
        (window, "window = [1, -1, -1, 1]", "6:11 empty-window-x"),
        (window, "window = [-1, 1, 1, 1]", "6:15 empty-window-y"),
        (window, &clip("[[0, 0], [2, 0]]"), "7:8 degenerate"),
        (
            window,
            &clip("[[0, 0], [1, 0], [1, 0], [0, 1]]"),
            "7:25 degenerate",
        ),
        (
            window,
            &clip("[[0, 0], [4, 0], [1, 1], [0, 4]]"),
            "7:25 not-convex",
        ),
        (window, &clip("[[0, 0], [4, 0], [1]]"), "7:25 wrong-length"),
        (
            window,
            &clip("[[0, 3], [2, -3], [-3, 1], [3, 1], [-2, -3]]"),
            "7:35 self-intersecting",
        ),
        (segments, "segments = []", "7:12 no-segments"),
        (segments, "segments = [-2, -1, 2, 1.5]", "7:13 wrong-type"),
        (segments, "segments = [[-2, -1, 2]]", "7:13 wrong-length"),
        (segments, "", "4:1 missing-field"),
        (
            segments,
            "random = { count = 0, seed = 7 }",
            "7:20 out-of-range",
        ),
        (
            segments,
            "random = { count = 2000000, seed = 7 }",
            "7:20 out-of-range",
        ),
        (segments, "random = { count = 5 }", "7:10 missing-field"),
        (
            segments,
            "random = { count = 5, seed = -1 }",
            "7:30 out-of-range",
        ),
        (
            segments,
            "segments = [[0, 0, 1, 1]]\nrandom = { count = 5, seed = 1 }",
            "8:10 two-kinds-of-segments",
        ),
        (
            segments,
            "segments = [[0, 0, 1, 1]]\nfocus = 1",
            "8:9 no-such-focus",
        ),
        (
            segments,
            "segments = [[0, 0, 1, 1]]\nfocus = 0.5",
            "8:9 wrong-type",
        ),
        (
            segments,
            "segments = [[0, 0, 1, 1]]\nbit_order = \"tblr\"",
            "8:13 unknown-value",
        ),
        (
            segments,
            "segments = [[0, 0, 1, 1]]\ncompare = \"brute\"",
            "8:11 unknown-method",
        ),
        ("id = \"second\"", "id = \"first\"", "15:6 duplicate-step"),
        (
            "id = \"second\"",
            "id = \"Second step\"",
            "15:6 bad-step-id",
        ),
        ("id = \"second\"\n", "", "14:1 missing-field"),
        (
            "scene = \"practice\"",
            "scene = \"practise\"",
            "11:9 unknown-scene",
        ),
        ("scene = \"practice\"", "", "9:1 missing-field"),
        (
            "figure = \"one\"",
            "figure = \"../one\"",
            "12:10 bad-figure",
        ),
        (
            "at = \"end\"",
            "at = \"cut top\"",
            "16:6 moment-never-happens",
        ),
        ("at = \"end\"", "at = \"cut #0\"", "16:6 bad-moment"),
        ("at = \"end\"", "figure = \"one\"", "16:10 duplicate-figure"),
        (
            "[\"window\"]",
            "[\"p1\", \"windows\"]",
            "17:15 unknown-lock",
        ),
        ("[\"window\"]", "\"window\"", "17:8 wrong-type"),
        ("\"words\"", "\"none\"", "18:8 unknown-value"),
        ("lab = \"lines\"", "lab = ", "1:7 toml"),
        ("\"lines\"", "\"lines\"\nlab = \"lines\"", "2:1 toml"),
        ("[scenes.practice]", "[scenes.practice", "4:17 toml"),
    ] {
        let files = lesson(&[(old, new)]);
        let mut spots = found(&files);
        // A step without an id, or with a bad one, leaves the texts unchecked; a scene that is not found
        // is not used.
        spots.retain(|spot| !spot.ends_with("unused-scene"));
        if spots != [format!("lesson.toml:{expected}")] {
            wrong.push(format!("{new}: expected {expected}, found {spots:?}"));
        }
        assert_eq!(Course::load(&files).course.lessons, [], "{new}: left out");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_mistake_in_a_text_has_its_place() {
    for (old, new, expected) in [
        ("# Regions\n", "", "1:1 missing-title"),
        ("# Regions", "Regions", "1:1 missing-title"),
        ("# Regions", "# ", "1:1 empty-text"),
        ("# Regions\n", "# Regions\n\nWelcome.\n", "3:1 text-outside"),
        ("## first: ", "## ", "3:1 bad-heading"),
        ("## first:", "## frist:", "3:1 unknown-step"),
        ("## second:", "## first:", "9:1 duplicate-section"),
        (
            "## second: The second step\n\n- one\n- two\n",
            "",
            "3:1 missing-section",
        ),
        ("- one\n- two\n", "", "9:1 empty-section"),
        ("- one", "- one\n\n# Two", "13:1 second-title"),
        ("- one", "### Deeper", "11:1 unsupported-markdown"),
        ("- one", "- <b>one</b>", "11:3 unsupported-markdown"),
        ("- one", "- see [this](that)", "11:7 unsupported-markdown"),
        ("- one", "- **甲。**乙", "11:3 stray-emphasis"),
    ] {
        assert!(TEXT.contains(old), "the text has no {old:?}");
        let mut files = with(LESSON, TEXT);
        files.insert("01-a/es.md".to_owned(), TEXT.replacen(old, new, 1).into());
        let spots = found(&files);
        let at = format!("es.md:{expected}");
        assert!(spots.contains(&at), "{new}: expected {at}, found {spots:?}");
        assert!(
            spots.iter().all(|spot| spot.starts_with("es.md")),
            "{spots:?}"
        );
        assert_eq!(Course::load(&files).course.lessons, [], "{new}: left out");
    }
}

#[test]
fn several_mistakes_of_several_files_are_all_reported() {
    let mut files = lesson(&[
        (
            "window = [-1, -1, 1, 1]",
            "window = [-1, nan, 1, inf]\ncolour = 3",
        ),
        ("\"cohen-sutherland\"", "\"sutherland\""),
        ("id = \"second\"", "id = \"first\""),
        ("\"end\"", "\"#x\""),
    ]);
    files.insert("01-a/zh-CN.md".to_owned(), b"# \xff".to_vec());
    files.insert("01-a/fr.md".to_owned(), b"# A".to_vec());
    files.remove("01-a/pt-BR.md");
    files.extend(
        with(LESSON, TEXT)
            .into_iter()
            .map(|(path, bytes)| (path.replace("01-a", "02-b"), bytes)),
    );
    assert_eq!(
        found(&files),
        [
            "lesson.toml:5:10 unknown-method",
            "lesson.toml:6:15 not-finite",
            "lesson.toml:6:23 not-finite",
            "lesson.toml:7:1 unknown-field",
            "lesson.toml:16:6 duplicate-step",
            "lesson.toml:17:6 bad-moment",
            "fr.md unknown-language",
            "zh-CN.md:1:3 not-utf8",
            "pt-BR.md missing-language",
        ]
    );
    let course = Course::load(&files).course;
    assert_eq!(course.lessons.len(), 1, "the other lesson stays");
    assert_eq!(course.lessons[0].id, "02-b");
}

#[test]
fn a_missing_translation_is_read_in_english() {
    let mut files = lesson(&[]);
    files.remove("01-a/es.md");
    assert_eq!(found(&files), ["es.md missing-language"]);
    let course = Course::load(&files).course;
    assert!(!course.lessons[0].speaks(Lang::Es));
    assert_eq!(course.lessons[0].text(Lang::Es).title, "Regions");
    files.remove("01-a/en.md");
    assert_eq!(
        found(&files),
        ["en.md missing-file", "es.md missing-language"]
    );
    assert_eq!(Course::load(&files).course.lessons, []);
}

#[test]
fn odd_files_are_named() {
    let mut files = lesson(&[]);
    files.insert("01-a/es.md".to_owned(), vec![b'a'; MAX_FILE_BYTES + 1]);
    assert_eq!(found(&files), ["es.md file-too-large"]);
    assert_eq!(found(&Memory::new()), [" no-lessons"]);
    let mut files = lesson(&[(
        "\"end\"",
        "\"end\"\n\n[scenes.spare]\nmethod = \"cohen-sutherland\"\nwindow = [0, 0, 1, 1]\nsegments = [[0, 0, 1, 1]]\n\n[[step]]\nid = \"third\"",
    )]);
    for lang in Lang::ALL {
        let text = format!(
            "\u{feff}{}",
            TEXT.replace('\n', "\r\n") + "## third：T\r\nt\r\n"
        );
        files.insert(format!("01-a/{lang}.md"), text.into());
    }
    assert_eq!(
        found(&files),
        ["lesson.toml:18:9 unused-scene"],
        "a warning; marks and CRLF are fine"
    );
    assert_eq!(Course::load(&files).course.lessons.len(), 1);
    let files = lesson(&[("\"lines\"", &"[".repeat(100_000))]);
    assert_eq!(
        found(&files)[0],
        "lesson.toml:1:87 toml",
        "nesting has a bound"
    );
    let files = lesson(&[("[0, 0, 1, 1]]", &(r#"["x"],"#.repeat(1_000) + "]"))]);
    let problems = Course::load(&files).problems;
    assert_eq!(
        problems.len(),
        101,
        "a hundred, and how many more there are"
    );
    assert_eq!(problems[100].code(), "more");
    assert!(
        problems[99]
            .render(Catalog::of(Lang::En))
            .lines()
            .all(|line| line.chars().count() < 140)
    );
}

#[test]
fn a_problem_is_rendered_as_a_compiler_would() {
    let toml = LESSON.replace("window = [", "\"窗口\"\t= 1\nwindow = [9, -1, -1, 1] # [");
    let problems = Course::load(&with(&toml, TEXT)).problems;
    let rendered: Vec<String> = problems
        .iter()
        .map(|p| p.render(Catalog::of(Lang::En)))
        .collect();
    let expected = "\
01-a/lesson.toml:6:1: error: There is no field “窗口” here.
  6 | \"窗口\"  = 1
    | ^^^^^^
    = Expected: one of method, compare, window, clip, bit_order, segments, random, focus.
01-a/lesson.toml:7:11: error: The window is empty: xmin = 9 is not below xmax = −1.
  7 | window = [9, -1, -1, 1] # [-1, -1, 1, 1]
    |           ^
    = Expected: [xmin, ymin, xmax, ymax], with xmin < xmax and ymin < ymax.";
    assert_eq!(rendered.join("\n"), expected);
    let chinese = problems[1].render(Catalog::of(Lang::ZhCn));
    assert!(chinese.contains("错误: 窗口是空的"), "{chinese}");
    let files = lesson(&[("\"end\"", "\"acept\"")]);
    let rendered = Course::load(&files).problems[0].render(Catalog::of(Lang::En));
    assert!(rendered.contains("Did you mean “accept"), "{rendered}");
    assert!(rendered.contains("one of start, "), "{rendered}");
}

#[test]
fn text_is_parsed_into_blocks() {
    let body = "Line\nbreak **bold *both*** end.\n\n甲\n乙 `a\u{3b1}`\n\n3. c\n   - d\n\n     e\n4. f\n\n```text\nx = 1\n```\n\n> q\n>\n> - r\n";
    let text = TEXT.replace("- one\n- two\n", body);
    let loaded = Course::load(&with(LESSON, &text));
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
        item(0, Marker::Number(3), "c"),
        item(1, Marker::Bullet, "d"),
        item(1, Marker::Continued, "e"),
        item(0, Marker::Number(4), "f"),
        Block::Code("x = 1\n".to_owned()),
        Block::Answer(vec![
            Block::Paragraph(vec![plain("q")]),
            item(0, Marker::Bullet, "r"),
        ]),
    ];
    assert_eq!(
        loaded.course.lessons[0].text(Lang::En).steps[1].body,
        expected
    );
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
    let scene = scene_from_toml("a.toml", toml.as_bytes()).expect("a scene in order");
    let text = scene_to_toml(&scene);
    let again = scene_from_toml("a.toml", text.as_bytes()).expect("a scene as it was written");
    let bits = |scene: &Scene| -> Vec<u64> {
        let numbers = scene.segments().iter().flat_map(|s| s.to_array());
        numbers.map(f64::to_bits).collect()
    };
    assert_eq!((&again, bits(&again)), (&scene, bits(&scene)), "{text}");
    assert_eq!(scene_to_toml(&again), text);
    assert!(
        text.contains("    [-0.0, 0.1, 5e-324, 0.30000000000000004],\n"),
        "{text}"
    );
    assert!(text.contains("window = [-1, -1, 1, 1e300]\n"), "{text}");
    let problems =
        scene_from_toml("a.toml", b"method = 1\nwindow = [0]").expect_err("a broken scene");
    let spots: Vec<String> = problems.iter().map(spot).collect();
    assert_eq!(
        spots,
        [
            "a.toml:1:1 missing-field",
            "a.toml:1:10 wrong-type",
            "a.toml:2:10 wrong-length"
        ]
    );
}

#[test]
fn random_segments_are_the_same_every_time() {
    use crate::geom::Window;
    let window = Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window");
    let segments = random_segments(&window, 1_000, 7);
    assert_eq!(segments, random_segments(&window, 1_000, 7));
    assert_ne!(segments, random_segments(&window, 1_000, 8));
    assert_eq!(segments[0].to_array(), [-0.44, -1.93, 1.6, 0.33]);
    let numbers = segments.iter().flat_map(|s| s.to_array());
    assert!(numbers.clone().all(|x| (-2.0..=2.0).contains(&x)));
    assert!(numbers.clone().any(|x| x > 1.9) && numbers.clone().any(|x| x < -1.9));
    for [a, b] in [
        [-1e308, 1e308],
        [1.0, 1.0 + f64::EPSILON],
        [-f64::MAX, f64::MAX],
        [0.0, 5e-324],
    ] {
        let window = Window::new(a, a, b, b).expect("a window");
        assert_eq!(
            random_segments(&window, 100, 1).len(),
            100,
            "[{a}, {b}]: finite"
        );
    }
}

#[test]
fn the_embedded_course_is_in_order_and_complete() {
    let loaded = Course::load(&Embedded);
    if Embedded
        .list()
        .is_ok_and(|paths| !paths.iter().any(|path| path.contains('/')))
    {
        return; // The course has not been written yet.
    }
    let problems: Vec<String> = loaded
        .problems
        .iter()
        .map(|problem| problem.render(Catalog::of(Lang::En)))
        .collect();
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
        let problems = Course::load(&Folder::new(&folder)).problems;
        let file = root.path().join("01-a").join("lesson.toml");
        assert_eq!(problems.len(), 1, "{problems:?}");
        assert_eq!(problems[0].file, file.display().to_string());
    }
    let gone = Course::load(&Folder::new(root.path().join("gone")));
    assert_eq!(gone.problems[0].code(), "unreadable");
    assert_eq!(
        Course::load(&Folder::new(root.path().join("01-a/..")))
            .problems
            .len(),
        1
    );
}
