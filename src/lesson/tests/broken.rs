//! Broken lessons, each with the place and the code of what is wrong.

use crate::text::{Catalog, Lang};

use super::*;

const BROKEN: &str = r#"
lab = => lba = => 1:1 unknown-field
lab = "lines"\n =>  => 1:1 missing-field
"lines" => "line" => 1:7 unknown-lab
"lines" => 7 => 1:7 wrong-type
source = "D. Cohen and I. Sutherland, 1967"\n =>  => 1:1 missing-field
"D. Cohen and I. Sutherland, 1967" => " " => 2:10 empty-text
"cohen-sutherland" => "cohen-suterland" => 5:10 unknown-method
method = "cohen-sutherland"\n =>  => 4:1 missing-field
window = [-1, -1, 1, 1] => windw = [-1, -1, 1, 1] => 6:1 unknown-field
window = [-1, -1, 1, 1] => window = [-1, -1, 1] => 6:10 wrong-length
window = [-1, -1, 1, 1] => window = [-1, -1, 1, inf] => 6:22 not-finite
window = [-1, -1, 1, 1] => window = [-1, -1, 1, 1e999] => 6:22 not-finite
window = [-1, -1, 1, 1] => window = [-1, nan, 1, 1] => 6:15 not-finite
window = [-1, -1, 1, 1] => window = [-1, "a", 1, 1] => 6:15 wrong-type
window = [-1, -1, 1, 1] => window = [1, -1, -1, 1] => 6:11 empty-window
window = [-1, -1, 1, 1] => window = [-1, 1, 1, 1] => 6:15 empty-window
window = [-1, -1, 1, 1] => window = [-1, -1, 1, 1]\nclip = [[0, 0], [2, 0]] => 7:8 degenerate
window = [-1, -1, 1, 1] => window = [-1, -1, 1, 1]\nclip = [[0, 0], [1, 0], [1, 0], [0, 1]] => 7:25 degenerate
window = [-1, -1, 1, 1] => window = [-1, -1, 1, 1]\nclip = [[0, 0], [4, 0], [1, 1], [0, 4]] => 7:25 not-convex
window = [-1, -1, 1, 1] => window = [-1, -1, 1, 1]\nclip = [[0, 0], [4, 0], [1]] => 7:25 wrong-length
window = [-1, -1, 1, 1] => window = [-1, -1, 1, 1]\nclip = [[0, 3], [2, -3], [-3, 1], [3, 1], [-2, -3]] => 7:35 self-intersecting
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [] => 7:12 no-segments
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [-2, -1, 2, 1.5] => 7:13 wrong-type
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [[-2, -1, 2]] => 7:13 wrong-length
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] =>  => 4:1 missing-field
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => random = { count = 0, seed = 7 } => 7:20 out-of-range
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => random = { count = 2000000, seed = 7 } => 7:20 out-of-range
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => random = { count = 5 } => 7:10 missing-field
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => random = { count = 5, seed = -1 } => 7:30 out-of-range
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [[0, 0, 1, 1]]\nrandom = { count = 5, seed = 1 } => 8:10 two-kinds-of-segments
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [[0, 0, 1, 1]]\nfocus = 1 => 8:9 no-such-focus
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [[0, 0, 1, 1]]\nfocus = 0.5 => 8:9 wrong-type
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [[0, 0, 1, 1]]\nbit_order = "tblr" => 8:13 unknown-value
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]] => segments = [[0, 0, 1, 1]]\ncompare = "brute" => 8:11 unknown-method
id = "second" => id = "first" => 15:6 duplicate-step
id = "second" => id = "Second step" => 15:6 bad-step-id
id = "second"\n =>  => 14:1 missing-field
scene = "practice" => scene = "practise" => 11:9 unknown-scene
scene = "practice" =>  => 9:1 missing-field
figure = "one" => figure = "../one" => 12:10 bad-figure
at = "end" => at = "cut top" => 16:6 moment-never-happens
at = "end" => at = "cut #0" => 16:6 bad-moment
at = "end" => figure = "one" => 16:10 duplicate-figure
["window"] => ["p1", "windows"] => 17:15 unknown-lock
["window"] => "window" => 17:8 wrong-type
lock = ["window"] => drag = ["p1", "p3"] => 17:15 unknown-lock
lock = ["window"] => drag = "p1" => 17:8 wrong-type
"words" => "none" => 18:8 unknown-value
lab = "lines" => lab =  => 1:7 toml-value
"lines" => "lines"\nlab = "lines" => 2:1 toml-duplicate
[scenes.practice] => [scenes.practice => 4:17 toml-unclosed
"#;

const BROKEN_TEXTS: &str = r"
# Regions\n =>  => 1:1 missing-title
# Regions => Regions => 1:1 missing-title
# Regions => #  => 1:1 empty-text
# Regions\n => # Regions\n\nWelcome.\n => 3:1 text-outside
## first:  => ##  => 3:1 bad-heading
## first: => ## frist: => 3:1 unknown-step
## second: => ## first: => 9:1 duplicate-section
## second: The second step\n\n- one\n- two\n =>  => 3:1 missing-section
- one\n- two\n =>  => 9:1 empty-section
- one => - one\n\n# Two => 13:1 second-title
- one => ### Deeper => 11:1 unsupported-markdown
- one => - <b>one</b> => 11:3 unsupported-markdown
- one => - see [this](that) => 11:7 unsupported-markdown
- one => - see [this](control:raster.rows) => 11:7 unknown-control
- one => - **甲。**乙 => 11:3 stray-emphasis
- one => !> Wait\nand see => 11:1 stray-note
- one => - !> Wait => 11:1 stray-note
- one => !>Wait => 11:1 stray-note
- one => - one\n\n=> It goes. => 13:1 stray-claim
- one\n- two\n => \n=> It goes.\n\n=> It goes on.\n\nText.\n => 14:1 stray-claim
- one\n- two\n => \n=> It goes.\n=| One\n\nText.\n => 12:1 stray-sides
- one\n- two\n => \n=> It goes.\n=| One | two\n\nText.\n => 1:1 stray-sides
- two => - two\n\n## card\n\n- rule: Go on. => 14:1 bad-card
- two => - two\n\n## card\n\nRules. => 16:1 bad-card
";

#[test]
fn every_mistake_in_a_lesson_file_has_its_place() {
    let mut wrong = Vec::new();
    for [old, new, expected] in cases(BROKEN) {
        let files = lesson(&[(&old, &new)]);
        let mut spots = found(&files);
        // A step without an id, or with a bad one, leaves the texts unchecked; a scene that is not found
        // is not used.
        spots.retain(|spot| !spot.ends_with("unused-scene"));
        if spots != [format!("lesson.toml:{expected}")] {
            wrong.push(format!("{new}: expected {expected}, found {spots:?}"));
        }
        assert_eq!(Course::check(&files).course.lessons, [], "{new}: left out");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_mistake_in_a_text_has_its_place() {
    for [old, new, expected] in cases(BROKEN_TEXTS) {
        assert!(TEXT.contains(&old), "the text has no {old:?}");
        let mut files = with(LESSON, TEXT);
        files.insert("01-a/es.md".to_owned(), TEXT.replacen(&old, &new, 1).into());
        let spots = found(&files);
        let at = format!("es.md:{expected}");
        assert!(spots.contains(&at), "{new}: expected {at}, found {spots:?}");
        assert!(
            spots.iter().all(|spot| spot.starts_with("es.md")),
            "{spots:?}"
        );
        assert_eq!(Course::check(&files).course.lessons, [], "{new}: left out");
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
    let other = with(LESSON, TEXT).into_iter();
    files.extend(other.map(|(path, bytes)| (path.replace("01-a", "02-b"), bytes)));
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
    let course = Course::check(&files).course;
    assert_eq!(course.lessons.len(), 1, "the other lesson stays");
    assert_eq!(course.lessons[0].id, "02-b");
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
        let text = TEXT.replace('\n', "\r\n");
        let text = format!("\u{feff}{text}## third：T\r\nt\r\n");
        files.insert(format!("01-a/{lang}.md"), text.into());
    }
    let warning = ["lesson.toml:18:9 unused-scene"];
    assert_eq!(found(&files), warning, "marks and CRLF are fine");
    assert_eq!(Course::check(&files).course.lessons.len(), 1);
    let files = lesson(&[("\"lines\"", &"[".repeat(100_000))]);
    let found_first = &found(&files)[0];
    assert_eq!(
        found_first, "lesson.toml:1:87 toml-deep",
        "nesting has a bound"
    );
    let files = lesson(&[("[0, 0, 1, 1]]", &(r#"["x"],"#.repeat(1_000) + "]"))]);
    let problems = Course::check(&files).problems;
    let n = problems.len();
    assert_eq!(n, 101, "a hundred, and how many more there are");
    assert_eq!(problems[100].code(), "more");
    let last = problems[99].render(Catalog::of(Lang::En));
    assert!(last.lines().all(|line| line.chars().count() < 140));
}

#[test]
fn a_problem_is_rendered_as_a_compiler_would() {
    let toml = LESSON.replace("window = [", "\"窗口\"\t= 1\nwindow = [9, -1, -1, 1] # [");
    let problems = Course::check(&with(&toml, TEXT)).problems;
    let rendered = problems.iter().map(|p| p.render(Catalog::of(Lang::En)));
    let rendered: Vec<String> = rendered.collect();
    let expected = "\
01-a/lesson.toml:6:1: error: There is no field “窗口” here.
  6 | \"窗口\"  = 1
    | ^^^^^^
    = Expected: one of method, compare, window, clip, bit_order, segments, mistaken, random, focus.
01-a/lesson.toml:7:11: error: The window is empty: xmin = 9 must be less than xmax = −1.
  7 | window = [9, -1, -1, 1] # [-1, -1, 1, 1]
    |           ^
    = Expected: [xmin, ymin, xmax, ymax], with xmin < xmax and ymin < ymax.";
    assert_eq!(rendered.join("\n"), expected);
    let chinese = problems[1].render(Catalog::of(Lang::ZhCn));
    assert!(chinese.contains("错误: 窗口为空"), "{chinese}");
    for (at, meant) in [("acept", "accept"), ("cut lfet", "cut left")] {
        let files = lesson(&[("at = \"end\"", &format!("at = \"{at}\""))]);
        let rendered = Course::check(&files).problems[0].render(Catalog::of(Lang::En));
        let question = format!("Did you mean “{meant}”?");
        assert!(rendered.contains(&question), "{rendered}");
        assert!(rendered.contains("one of start, "), "{rendered}");
    }
}

#[test]
fn a_file_that_is_not_toml_is_explained() {
    for (toml, code) in [
        ("a = ", "toml-value"),
        ("a = hello", "toml-value"),
        ("a = “x”", "toml-value"),
        ("a = [1 2]", "toml-value"),
        ("a = [1,, 2]", "toml-extra"),
        ("a = 1__2", "toml-number"),
        ("a = 0123", "toml-number"),
        ("a = \"\\q\"", "toml-escape"),
        ("a = [1, 2", "toml-unclosed"),
        ("a = \"x", "toml-unclosed"),
        ("[a", "toml-unclosed"),
        ("a", "toml-no-value"),
        ("é = 1", "toml-name"),
    ] {
        let problems = SceneFormats::standard()
            .read("a.toml", toml.as_bytes())
            .expect_err(toml);
        assert_eq!(problems[0].code(), code, "{toml}");
        for lang in Lang::ALL {
            let text = problems[0].render(Catalog::of(lang));
            assert!(!text.contains('⟦'), "{text}");
        }
    }
}

#[test]
fn what_a_file_holds_cannot_upset_the_terminal() {
    let long = "x".repeat(1_000);
    let toml = format!("\"\\u001b[2J{long}\" = \"\u{7f}\"");
    let read = SceneFormats::standard().read("a\u{1b}.toml", toml.as_bytes());
    for problem in read.expect_err("no scene") {
        let text = problem.render(Catalog::of(Lang::En));
        let is_control = |c: char| c.is_control() && c != '\n';
        assert!(!text.contains(is_control), "{text:?}");
        let mut lines = text.lines();
        assert!(lines.all(|line| line.chars().count() < 180), "{text}");
    }
}

proptest::proptest! {
    /// Whatever is typed into a file, it is read or refused.
    #[test]
    fn no_edit_makes_it_panic(at in 0..1_000_usize, cut in 0..40_usize, put in "[\\PC\n]{0,12}|[\\[\\]{}=\",.0-9\n#>*`:-]{0,12}") {
        let edit = |text: &str| {
            let from = text.floor_char_boundary(at % text.len());
            let to = text.floor_char_boundary((from + cut).min(text.len()));
            format!("{}{put}{}", &text[..from], &text[to..])
        };
        let loaded = Course::check(&with(&edit(LESSON), &edit(TEXT)));
        let is_refused = loaded.problems.iter().any(|p| p.severity == Severity::Error);
        proptest::prop_assert_eq!(loaded.course.lessons.is_empty(), is_refused);
        for problem in loaded.problems {
            proptest::prop_assert!(!problem.render(Catalog::of(Lang::En)).is_empty());
        }
    }
}

#[test]
fn a_moment_that_never_comes_is_found_when_its_step_is_opened() {
    let files = lesson(&[("at = \"end\"", "at = \"cut lfet\"")]);
    let loaded = Course::load(&files);
    assert_eq!(loaded.problems, []);
    let steps = &loaded.course.lessons[0].steps;
    assert_eq!([steps[0].position(), steps[1].position()], [Some(0), None]);
    assert_eq!(steps[0].problem(), None);
    // What is said then is what `check` says.
    let checked = Course::check(&files).problems;
    assert_eq!(Vec::from_iter(steps[1].problem()), checked);
    let all_found = Course::check(&lesson(&[])).course;
    assert_eq!(Course::load(&lesson(&[])).course, all_found);
}
