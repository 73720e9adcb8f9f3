//! The program itself: what it writes where, and how it ends.

use std::{
    fs,
    io::{BufRead, BufReader, Read, Write},
    process::{Command, Output, Stdio},
};

use serde_json::Value as Json;

const GOOD: &str =
    r#"{"id":7,"algorithm":"liang-barsky","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}"#;
const BAD: &str =
    r#"{"id":8,"algorithm":"liang-barsky","window":[-1,-1,1,1],"segment":[-2,-1,1e999,1.5]}"#;

fn clipscope(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_clipscope"));
    command.args(args);
    command
}

fn run(args: &[&str], input: &str) -> Output {
    let mut child = clipscope(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // One that does not read its input may be gone already.
    let _ = child
        .stdin
        .take()
        .map(|mut stdin| stdin.write_all(input.as_bytes()));
    child.wait_with_output().expect("the program ends")
}

fn status(output: &Output) -> Option<i32> {
    output.status.code()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

#[test]
fn the_schema_is_one_object() {
    let output = run(&["trace", "--schema"], "");
    assert_eq!(status(&output), Some(0));
    let schema: Json = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(schema["version"], 2);
    assert!(schema["algorithms"]["occlusion"]["case"].is_object());
    assert_eq!(status(&run(&["trace", "--schema", "-"], "")), Some(2));
}

#[test]
fn cases_are_answered_in_order_and_the_refused_are_named() {
    let output = run(&["trace"], &format!("{GOOD}\n\n{BAD}\n{GOOD}"));
    let lines: Vec<Json> = text(&output.stdout)
        .lines()
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect();
    let ids: Vec<&Json> = lines.iter().map(|line| &line["id"]).collect();
    assert_eq!(ids, [7, 8, 7]);
    assert_eq!(lines[1]["error"]["code"], "not-finite");
    assert_eq!(lines[1]["error"]["field"], "segment[2]");
    assert_eq!(lines[0]["events"].as_array().map(Vec::len), Some(16));
    let said = text(&output.stderr);
    assert!(
        said.contains("line 3, case 2 (8): segment[2]: 1e999"),
        "{said}"
    );
    assert!(said.contains("1 input was refused"), "{said}");
    assert_eq!(status(&output), Some(1));
}

#[test]
fn without_events_an_answer_is_one_short_line() {
    let output = run(&["trace", "-", "--events", "false"], GOOD);
    let expected = concat!(
        r#"{"id":7,"algorithm":"liang-barsky","output":{"visible":true,"#,
        r#""segment":[-1.0,-0.375,1.0,0.875]},"counts":{"#
    );
    assert!(text(&output.stdout).starts_with(expected));
    assert!(!text(&output.stdout).contains("events"));
    assert_eq!((status(&output), text(&output.stderr)), (Some(0), ""));
}

#[test]
fn a_file_is_read_like_standard_input() {
    let dir = tempfile::tempdir().expect("a folder");
    let path = dir.path().join("cases.ndjson");
    fs::write(&path, GOOD).expect("a file can be written");
    let path = path.to_str().expect("a path of Unicode");
    let output = run(&["trace", path], "");
    assert_eq!(output.stdout, run(&["trace"], GOOD).stdout);
    assert_eq!(status(&output), Some(0));
}

#[test]
fn the_other_formats_speak_four_languages() {
    let page = run(&["trace", "--format", "markdown", "--lang", "pt-BR"], GOOD);
    assert!(text(&page.stdout).starts_with("# Gabarito\n\n## Caso 1 (7) · Liang–Barsky\n"));
    let table = run(&["trace", "--format", "text", "--lang", "zh-CN"], GOOD);
    assert!(text(&table.stdout).starts_with("第 1 题（7） · "));
    let short = run(&["trace", "--format", "text", "--events", "false"], GOOD);
    assert!(!text(&short.stdout).contains("step"));
}

#[test]
fn what_cannot_be_read_ends_with_2() {
    for args in [
        &["trace", "/no/such/file"][..],
        &["trace", "/"],
        &["trace", "--format", "xml"],
        &["trace", "--lang", "fr"],
        &["trace", "--events", "maybe"],
        &["juggle"],
        &["export"],
        &["export", "--out", "x", "--size", "0x0"],
        &["export", "--out", "x", "--scale", "nan"],
        &["check", "/no/such/lesson"],
    ] {
        let output = run(args, "");
        assert_eq!(status(&output), Some(2), "{args:?}");
        assert!(output.stdout.is_empty(), "{args:?}");
        assert!(!output.stderr.is_empty(), "{args:?}");
    }
    for nothing in ["", "\n \n"] {
        let output = run(&["trace"], nothing);
        assert_eq!((status(&output), text(&output.stdout)), (Some(0), ""));
    }
}

#[test]
fn every_command_has_help_with_an_example() {
    for args in [
        &["--help"][..],
        &["open", "--help"],
        &["export", "--help"],
        &["trace", "--help"],
        &["grade", "--help"],
        &["check", "--help"],
        &["list", "--help"],
    ] {
        let output = run(args, "");
        assert_eq!(status(&output), Some(0), "{args:?}");
        assert!(text(&output.stdout).contains("Example"), "{args:?}");
    }
}

#[test]
fn a_reader_that_leaves_is_no_mistake() {
    let mut child = clipscope(&["trace"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("piped");
    let feed = std::thread::spawn(move || {
        for _ in 0..10_000 {
            if writeln!(stdin, "{GOOD}").is_err() {
                break;
            }
        }
    });
    let mut first = String::new();
    let stdout = child.stdout.take().expect("piped");
    BufReader::with_capacity(64, stdout)
        .read_line(&mut first)
        .expect("an answer");
    // The reader is gone here.
    let mut said = String::new();
    let mut stderr = child.stderr.take().expect("piped");
    stderr.read_to_string(&mut said).expect("UTF-8");
    feed.join().expect("the feeding thread ends");
    assert_eq!(child.wait().expect("the program ends").code(), Some(0));
    assert_eq!(said, "");
}

#[test]
fn an_answer_comes_before_the_next_case_is_sent() {
    let mut child = clipscope(&["trace", "--events", "false"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("piped");
    let mut answers = BufReader::new(child.stdout.take().expect("piped"));
    for _ in 0..3 {
        writeln!(stdin, "{GOOD}").expect("the program reads");
        let mut answer = String::new();
        answers.read_line(&mut answer).expect("an answer");
        assert!(answer.starts_with(r#"{"id":7,"#));
    }
    drop(stdin);
    assert_eq!(child.wait().expect("the program ends").code(), Some(0));
}

#[test]
fn the_course_and_the_algorithms_are_listed() {
    let output = run(&["list", "--format", "json"], "");
    assert_eq!(status(&output), Some(0));
    let list: Json = serde_json::from_slice(&output.stdout).expect("JSON");
    let ids: Vec<&str> = list["algorithms"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|a| a["id"].as_str())
        .collect();
    for id in [
        "brute-force",
        "cohen-sutherland",
        "liang-barsky",
        "cyrus-beck",
        "nicholl-lee-nicholl",
    ] {
        assert!(ids.contains(&id), "{id} is listed");
    }
    let lessons = list["lessons"].as_array().expect("a list");
    assert!(
        lessons
            .iter()
            .all(|lesson| !lesson["steps"].as_array().expect("a list").is_empty())
    );
    assert!(text(&run(&["list"], "").stdout).contains("window | clip, segment"));
}

#[test]
fn languages_that_are_not_there_are_said_once() {
    let dir = tempfile::tempdir().expect("a folder");
    let toml = concat!(
        "lab = \"lines\"\nsource = \"Liang and Barsky\"\n\n[scenes.a]\nmethod = \"liang-barsky\"\nwindow = [-1, -1, 1, 1]\n",
        "segments = [[-2, 0, 2, 0]]\n\n[[step]]\nid = \"one\"\nscene = \"a\"\n"
    );
    let english = "# A line\n\n## one: It is cut\n\nWhere?\n\n> Twice.\n";
    for name in ["01-one", "02-two"] {
        let lesson = dir.path().join(name);
        fs::create_dir(&lesson).expect("a folder");
        fs::write(lesson.join("lesson.toml"), toml).expect("a file");
        fs::write(lesson.join("en.md"), english).expect("a file");
    }
    fs::write(dir.path().join("01-one/es.md"), english).expect("a file");
    let output = run(&["check", dir.path().to_str().expect("Unicode")], "");
    let said = text(&output.stderr);
    assert_eq!(
        (status(&output), said.lines().count()),
        (Some(0), 1),
        "{said}"
    );
    assert!(said.starts_with("hint: 2 lessons show English"), "{said}");
    assert!(said.contains("Español"), "of the second one: {said}");
}

#[test]
fn a_broken_lesson_is_refused_and_the_others_are_counted() {
    assert_eq!(status(&run(&["check"], "")), Some(0));
    let dir = tempfile::tempdir().expect("a folder");
    let output = run(&["check", dir.path().to_str().expect("Unicode")], "");
    assert_eq!(status(&output), Some(2), "a folder without lessons");
    let lesson = dir.path().join("01-broken");
    fs::create_dir(&lesson).expect("a folder");
    fs::write(lesson.join("lesson.toml"), "lab = \"lines\"\ncolour = 1\n").expect("a file");
    let output = run(&["check", dir.path().to_str().expect("Unicode")], "");
    assert_eq!(status(&output), Some(1));
    assert!(
        text(&output.stderr).contains("lesson.toml:2:1: error"),
        "{}",
        text(&output.stderr)
    );
}

#[test]
fn a_class_has_one_table_and_each_file_that_is_none_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let steps = r#"{"04-cutting-with-outcodes/four-cuts": {"told": "beforehand"},
        "04-cutting-with-outcodes/a-new-code": {"told": "after-the-numbers"}, "gone/step": {}}"#;
    let ana = file(
        "ana.json",
        &format!(r#"{{"version": 1, "begun": 3, "steps": {steps}}}"#),
    );
    let formula = file("=1+1.json", r#"{"version": 1}"#);
    let broken = file("broken.json", "{");
    let output = clipscope(&["progress", &ana, &formula, &broken])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("broken.json"), "{said}");
    let table = String::from_utf8(output.stdout).unwrap();
    let rows: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[1][..4], ["ana", "2", "1", "1"]);
    assert_eq!(rows[2][0], "'=1+1", "no formula for a spreadsheet");
    let lesson = rows[0]
        .iter()
        .position(|name| *name == "04-cutting-with-outcodes");
    assert!(rows[1][lesson.unwrap()].starts_with("2/"), "{table}");
    let markdown = ["progress", "--format", "markdown", &ana];
    let output = clipscope(&markdown).output().unwrap();
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(
        output.status.success() && table.starts_with("| file | seen |"),
        "{table}"
    );
    assert_eq!(
        clipscope(&["progress", &broken])
            .output()
            .unwrap()
            .status
            .code(),
        Some(2)
    );
}
