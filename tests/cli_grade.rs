//! `clipscope grade` itself: what it writes where, how it ends, and the examples that come with it.

use std::{
    fs,
    io::Write,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
};

use serde_json::Value as Json;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/grading")
}

fn run(args: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_clipscope"))
        .arg("grade")
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // One that does not read its input may be gone already.
    let _ = child.stdin.take().map(|mut stdin| stdin.write_all(input));
    child.wait_with_output().expect("the program ends")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// What an example program answers to the cases beside it; nothing where its interpreter is not there.
fn answers(interpreter: &str, program: &str) -> Option<Vec<u8>> {
    let cases = fs::File::open(examples().join("cases.ndjson")).unwrap();
    let mut command = Command::new(interpreter);
    let command = command
        .arg(program)
        .current_dir(examples())
        .env("PYTHONDONTWRITEBYTECODE", "1");
    let output = command.stdin(cases).output();
    match output {
        Ok(output) => {
            assert!(
                output.status.success(),
                "{program}: {}",
                String::from_utf8_lossy(&output.stderr)
            );
            Some(output.stdout)
        }
        Err(_) => {
            eprintln!("{interpreter} is not here: {program} has not been run");
            None
        }
    }
}

#[test]
fn the_examples_are_graded_as_they_say() {
    let cases = examples().join("cases.ndjson");
    for (interpreter, ending) in [("python3", "py"), ("node", "js")] {
        for (program, mistake) in [
            ("right", None),
            ("slope_turned_over", Some("slope-turned-over")),
            ("looks_once", Some("looks-once")),
            ("rejects_two_outside", Some("rejects-two-outside")),
        ] {
            let Some(answers) = answers(interpreter, &format!("{program}.{ending}")) else {
                continue;
            };
            let output = run(&[cases.to_str().unwrap(), "-"], &answers);
            let report: Json = serde_json::from_slice(&output.stdout).unwrap();
            let wrong = report["wrong"].as_array().unwrap();
            assert_eq!(
                output.status.code(),
                Some(i32::from(mistake.is_some())),
                "{program}: {report}"
            );
            assert_eq!(wrong.is_empty(), mistake.is_none(), "{program}: {report}");
            let is_known = |wrong: &&Json| wrong["mistake"].as_str() == mistake;
            let n_known = wrong.iter().filter(is_known).count();
            assert!(
                mistake.is_none() || n_known > wrong.len() / 2,
                "{program}: {report}"
            );
        }
    }
    for helper in ["grading.py", "grading.js"] {
        let text = fs::read_to_string(examples().join(helper)).unwrap();
        assert!(text.lines().count() <= 40, "{helper} is to be short");
    }
}

const CASE: &str =
    r#"{"id":1,"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}"#;
const RIGHT: &str = r#"{"id":1,"output":{"visible":true,"segment":[-1,-0.375,1,0.875]}}"#;
const WRONG: &str = r#"{"id":1,"output":{"visible":true,"segment":[-1,0.5,1,0.875]}}"#;

/// A folder with a file of cases in it.
fn folder() -> (tempfile::TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    let cases = dir.path().join("cases.ndjson");
    fs::write(&cases, CASE).unwrap();
    let cases = cases.to_str().unwrap().to_owned();
    (dir, cases)
}

#[test]
fn the_exit_status_is_the_verdict() {
    let (_dir, cases) = folder();
    let rows: [(&[&str], &str, i32); 9] = [
        (&[], RIGHT, 0),
        (&[], WRONG, 1),
        (&[], "", 1),
        (&["--wrong-ok"], WRONG, 0),
        (&["--tolerance", "1"], WRONG, 0),
        (&["--submissions"], "", 0),
        (&["--report", "kattis"], RIGHT, 42),
        (&["--report", "kattis"], WRONG, 43),
        (
            &["--report", "junit"],
            &RIGHT.replace("\"id\"", "\"submission\":1,\"id\""),
            2,
        ),
    ];
    for (options, answers, status) in rows {
        let output = run(&[&[&*cases, "-"], options].concat(), answers.as_bytes());
        assert_eq!(output.status.code(), Some(status), "{options:?} {answers}");
    }
    for usage in [
        &["-", "-"][..],
        &["/no/such/file", "-"],
        &[&cases, "/no/such/file"],
        &[&cases],
        &[&cases, "-", "--tolerance", "-1"],
        &[&cases, "-", "--report", "xml"],
        &["--merge", "/no/such/file"],
        &[&cases, "/no/such/file", "--report", "kattis"],
    ] {
        let output = run(usage, b"");
        assert_eq!(output.status.code(), Some(2), "{usage:?}");
        assert!(
            output.stdout.is_empty() && !output.stderr.is_empty(),
            "{usage:?}"
        );
    }
}

#[test]
fn every_report_has_its_file_and_the_figure_is_a_picture() {
    let (dir, cases) = folder();
    let out = dir.path().join("out");
    let figure = dir.path().join("wrong.png");
    let [out_text, figure_text] = [&out, &figure].map(|path| path.to_str().unwrap());
    for (report, file) in [
        ("text", "report.txt"),
        ("json", "report.ndjson"),
        ("junit", "junit.xml"),
        ("prairielearn", "results.json"),
        ("gradescope", "results.json"),
        ("kattis", "teammessage.txt"),
    ] {
        let args = [
            &cases,
            "-",
            "--report",
            report,
            "--out",
            out_text,
            "--figure",
            figure_text,
        ];
        let output = run(&args, WRONG.as_bytes());
        assert!(output.stdout.is_empty(), "{}", text(&output.stderr));
        let written = fs::read_to_string(out.join(file)).unwrap();
        assert!(written.contains("-0.375"), "{report}: {written}");
        assert!(
            fs::read(&figure).unwrap().starts_with(b"\x89PNG"),
            "{report}"
        );
        let names = fs::read_dir(&out)
            .unwrap()
            .map(|entry| entry.unwrap().file_name());
        assert!(
            names
                .into_iter()
                .all(|name| !name.to_string_lossy().starts_with('.'))
        );
    }
    assert!(
        fs::read(out.join("teamimage.png"))
            .unwrap()
            .starts_with(b"\x89PNG")
    );
    // As the problem package format asks of what a validator leaves: UTF-8 without a mark, whole lines.
    let message = fs::read(out.join("teammessage.txt")).unwrap();
    assert!(std::str::from_utf8(&message).is_ok_and(|text| text.ends_with('\n')));
    assert!(!message.contains(&b'\r') && !message.starts_with(b"\xef\xbb\xbf"));
    let results = run(&[&cases, "-", "--report", "prairielearn"], WRONG.as_bytes()).stdout;
    let results: Json = serde_json::from_slice(&results).unwrap();
    assert!(
        results["images"][0]["url"]
            .as_str()
            .unwrap()
            .starts_with("data:image/png;base64,iVBOR")
    );
    assert!(results.to_string().len() < 1_000_000);
}

#[test]
fn a_report_that_fails_leaves_nothing_behind() {
    let (dir, cases) = folder();
    let out = dir.path().join("out");
    let of_many = RIGHT.replace("\"id\"", "\"submission\":1,\"id\"");
    let args = ["--report", "junit", "--out", out.to_str().unwrap()];
    let output = run(&[&[&*cases, "-"], &args[..]].concat(), of_many.as_bytes());
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert_eq!(fs::read_dir(&out).unwrap().count(), 0);
}

#[test]
fn reports_are_merged() {
    let (_dir, cases) = folder();
    let of = |name: &str, answer: &str| {
        answer.replace("\"id\"", &format!("\"submission\":\"{name}\",\"id\"")) + "\n"
    };
    let reports = run(
        &[&cases, "-"],
        (of("a", RIGHT) + &of("b", WRONG)).as_bytes(),
    )
    .stdout;
    assert_eq!(text(&reports).lines().count(), 2);
    let output = run(&["--merge"], &reports);
    let totals: Json = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&totals["submissions"], &totals["right"]),
        (&2.into(), &1.into())
    );
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(run(&["--merge"], b"nonsense").status.code(), Some(1));
}
