//! Known mistakes are found at the step where they first differ, and called by their names.

use clipscope::case::{CaseLine, Detail, Solvers, read};
use serde_json::{Value as Json, json};

use super::graded;

/// For each algorithm that has known mistakes cases on which they show.
const CASES: [&str; 8] = [
    r#"{"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}"#,
    r#"{"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-1.75,1.5,0.5,-0.25]}"#,
    r#"{"algorithm":"cyrus-beck","clip":[[0,-2],[-2,0],[0,2],[2,0]],"segment":[-3,1,1,1]}"#,
    r#"{"algorithm":"sutherland-hodgman","window":[-1,-1,1,1],"polygon":[[0,0],[-1,0.5],[0,2],[2,0]]}"#,
    r#"{"algorithm":"homogeneous-line","segment":[0,0,0,1,0,0,3,-1]}"#,
    r#"{"algorithm":"intersection-polygon","planes":[[1,0,0,0],[0,1,0,0]],"triangle":[[0,1,0],[2,1,0],[1,-1,0]],"uv":[[0,0],[1,0],[0,1]]}"#,
    r#"{"algorithm":"plane-at-a-time","planes":[[1,0,0,0]],"triangle":[[0,0,0],[1,1,0],[-1,1,0]]}"#,
    r#"{"algorithm":"depth-buffer","size":[6,6],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-3,-3,-3],[3,-3,-3],[0,3,-3]],[[-3,-3,-5],[3,-3,-2],[0,3,-5]]]}"#,
];

fn mistaken(case: &str) -> Vec<clipscope::case::Mistaken> {
    let case = read(
        Solvers::standard(),
        CaseLine::Bytes(case.as_bytes()),
        Detail::Steps,
    );
    let case = case.ok().unwrap();
    let mistakes = case.solver.mistakes.iter();
    mistakes
        .filter_map(|mistake| mistake.answer(case.problem.input()))
        .collect()
}

fn true_events(case: &str) -> Vec<Json> {
    let case = read(
        Solvers::standard(),
        CaseLine::Bytes(case.as_bytes()),
        Detail::Steps,
    );
    let run = case.ok().unwrap().problem.run();
    (1..=run.n_steps())
        .map(|step| run.event_json(step))
        .collect()
}

#[test]
fn each_is_found_where_it_first_differs() {
    for case in CASES {
        let truth = true_events(case);
        let mut n_found = 0;
        for mistaken in mistaken(case) {
            let answer = json!({"output": mistaken.output, "events": mistaken.events});
            let report = graded(case, &answer.to_string());
            let n = truth.len().max(mistaken.events.len());
            let first = (0..n).find(|&i| truth.get(i) != mistaken.events.get(i));
            let Some(first) = first else {
                continue;
            };
            let wrong = &report["wrong"][0];
            // A kind that it does not tell at all is not compared.
            if report["right"] == 1 {
                continue;
            }
            n_found += 1;
            assert_eq!(wrong["kind"], "event", "{}", mistaken.id);
            assert!(
                wrong["step"].as_u64() > Some(first as u64),
                "{}",
                mistaken.id
            );
            assert!(wrong["mistake"].is_string(), "{}", mistaken.id);
            let said = wrong["message"].as_str().unwrap();
            assert!(
                said.contains("Exactly this comes out with a known mistake"),
                "{said}"
            );
        }
        assert!(n_found > 0, "no mistake shows on {case}");
    }
}

/// The prototype's own case: the answer alone tells which mistake it was.
#[test]
fn a_slope_turned_over_is_called_so() {
    let case = CASES[1];
    let answer = mistaken(case)
        .into_iter()
        .find(|one| one.id == "slope-turned-over")
        .unwrap();
    let cut = answer
        .events
        .iter()
        .find(|event| event["event"] == "cut")
        .unwrap();
    let y = cut["to"][1].as_f64().unwrap();
    assert!((y - 15.0 / 28.0).abs() < 1e-12, "{y}");
    let alone = json!({"output": answer.output}).to_string();
    let report = graded(case, &alone);
    assert_eq!(report["wrong"][0]["mistake"], "slope-turned-over");
    let other = r#"{"output":{"visible":true,"segment":[-1,0.5,0.5,-0.25]}}"#;
    assert_eq!(graded(case, other)["wrong"][0]["mistake"], Json::Null);
}
