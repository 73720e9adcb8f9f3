//! Many submissions in one stream, and their totals.

use clipscope::{
    case::Detail,
    grade::{Options, Totals, merge},
};
use serde_json::{Value as Json, json};

use super::{reports_of, traced};

fn case(i: usize, submission: Option<&str>) -> String {
    let own = submission.map_or_else(String::new, |name| format!(r#""submission":"{name}","#));
    let x = i as f64 / 8.0;
    format!(
        r#"{{"id":{i},{own}"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,-1,2,{x}]}}"#
    )
}

fn lines(cases: impl Iterator<Item = String>) -> String {
    cases.map(|case| case + "\n").collect()
}

/// The answers of a submission, `n` of which are given, the last one wrong.
fn answers(cases: &str, submission: &str, n: usize) -> String {
    let answers = traced(cases, Detail::Answers);
    let mut all: Vec<Json> = answers
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    all.truncate(n);
    for answer in &mut all {
        answer["submission"] = json!(submission);
    }
    if let Some(last) = all.last_mut() {
        last["output"] = json!({"visible": false, "segment": null});
    }
    lines(all.iter().map(Json::to_string))
}

fn reports(cases: &str, answers: &str) -> String {
    let many = Options {
        of_many: true,
        ..Options::default()
    };
    reports_of(cases.as_bytes(), answers.as_bytes(), many)
}

#[test]
fn each_submission_has_a_line_and_shards_are_the_whole() {
    let cases = lines((1..=12).map(|i| case(i, None)));
    let own: Vec<String> = (0..9)
        .map(|i| answers(&cases, &format!("s{i}"), 12 - i))
        .collect();
    let whole = reports(&cases, &own.concat());
    let lines: Vec<Json> = whole
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let names: Vec<&str> = lines
        .iter()
        .map(|line| line["submission"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        ["s0", "s1", "s2", "s3", "s4", "s5", "s6", "s7", "s8"]
    );
    assert!((0..9).all(|i| lines[i]["cases"] == 12 && lines[i]["right"] == 11 - i));
    for at in 0..=9 {
        let [first, second] = [&own[..at], &own[at..]].map(|own| reports(&cases, &own.concat()));
        assert_eq!(first + &second, whole, "cut before {at}");
    }
    // Without being told, the answers say themselves that they are of many.
    assert_eq!(
        reports_of(
            cases.as_bytes(),
            own.concat().as_bytes(),
            Options::default()
        ),
        whole
    );
}

#[test]
fn cases_may_be_a_submissions_own() {
    let own = |name: &str, n: usize| lines((1..=n).map(|i| case(i, Some(name))));
    let groups = [own("a", 3), own("b", 2), own("c", 4)];
    let given = [answers(&groups[0], "a", 3), answers(&groups[2], "c", 4)];
    let whole = reports(&groups.concat(), &given.concat());
    let lines: Vec<Json> = whole
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let counts = |line: &Json| [line["cases"].as_u64(), line["right"].as_u64()].map(Option::unwrap);
    assert_eq!(
        lines.iter().map(counts).collect::<Vec<_>>(),
        [[3, 2], [2, 0], [4, 3]]
    );
    assert_eq!(
        lines[2]["wrong"][0]["line"], 4,
        "lines are counted within a submission"
    );
    let shards = [
        reports(&groups[0], &given[0]),
        reports(&groups[1], ""),
        reports(&groups[2], &given[1]),
    ];
    assert_eq!(shards.concat(), whole);
    let unknown = reports(&groups.concat(), &answers(&groups[0], "z", 1));
    assert_eq!(unknown.lines().count(), 4);
    assert!(unknown.contains("extra"));
}

#[test]
fn totals_of_totals_are_totals() {
    let cases = lines((1..=5).map(|i| case(i, None)));
    let own: Vec<String> = (0..4)
        .map(|i| answers(&cases, &format!("s{i}"), 5 - i))
        .collect();
    let right = traced(&cases, Detail::Answers).replace("{\"id\"", "{\"submission\":\"r\",\"id\"");
    let whole = reports(&cases, &(own.concat() + &right));
    let sum = |texts: &[&str]| {
        let (mut totals, mut n_refused) = (Totals::new(), 0);
        for text in texts {
            merge(&mut totals, text.as_bytes(), |_| n_refused += 1).unwrap();
        }
        (totals, n_refused)
    };
    let (totals, _) = sum(&[&whole]);
    assert_eq!(
        [
            totals.submissions,
            totals.all_right,
            totals.cases,
            totals.right
        ],
        [5, 1, 25, 15]
    );
    assert_eq!(totals.kinds["missing"], 6);
    let middle = whole.lines().take(2).map(str::len).sum::<usize>() + 2;
    let halves = [&whole[..middle], &whole[middle..]];
    let halves = halves.map(|half| serde_json::to_string(&sum(&[half]).0).unwrap());
    assert_eq!(sum(&[&halves[0], &halves[1]]), (totals.clone(), 0));
    let (with_noise, n_refused) = sum(&[&whole, "{}\nnonsense\n{\"version\":9}"]);
    assert_eq!((with_noise, n_refused), (totals, 3));
}
