//! Cases of the lines lab.

use clipscope::{
    case::{CaseLine, Code, Detail, Format, MAX_LINE_BYTES, Solver, Solvers, read},
    text::Lang,
};
use serde_json::{Value as Json, json};

use super::asked::{
    JSON, answer, answers, lines_are_at_most_a_hundred_columns_wide, refusal,
    reports_are_as_they_were, steps_are_all_that_is_left_out, tallied,
};

/// Those that clip a segment in the plane.
fn line_solvers() -> impl Iterator<Item = &'static Solver> {
    let takes = |solver: &Solver, name| solver.fields.iter().any(|field| field.name == name);
    let is_flat = move |solver: &&Solver| takes(solver, "segment") && takes(solver, "window");
    Solvers::standard().iter().filter(is_flat)
}

#[test]
fn the_slides_worked_numbers_come_out_of_every_algorithm() {
    for solver in line_solvers() {
        for (segment, visible) in [
            ("[-2,-1,2,1.5]", json!([-1.0, -0.375, 1.0, 0.875])),
            ("[-2,-1,1,1.5]", json!([-1.0, -1.0 / 6.0, 0.4, 1.0])),
            ("[1,2,3,0]", Json::Null),
            ("[0,2,2,0]", json!([1.0, 1.0, 1.0, 1.0])),
        ] {
            let case = format!(
                r#"{{"algorithm":"{}","window":[-1,-1,1,1],"segment":{segment}}}"#,
                solver.card.id
            );
            let output = &answer(&case)["output"];
            let expected = json!({ "visible": !visible.is_null(), "segment": visible });
            assert_eq!(*output, expected, "{case}");
        }
    }
}

#[test]
fn an_answer_has_the_form_that_was_promised() {
    let case =
        r#"{"id":7,"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-0.5,0,2,0]}"#;
    let (text, tally) = tallied(case.as_bytes(), JSON);
    assert_eq!(
        text,
        concat!(
            r#"{"id":7,"algorithm":"cohen-sutherland","output":{"visible":true,"segment":[-0.5,0.0,1.0,0.0]},"#,
            r#""counts":{"add":4,"mul":2,"div":1,"cmp":15},"events":["#,
            r#"{"event":"code","end":"p1","at":[-0.5,0.0],"code":"0000"},"#,
            r#"{"event":"code","end":"p2","at":[2.0,0.0],"code":"0010"},"#,
            r#"{"event":"or","or":"0010"},{"event":"and","and":"0000"},"#,
            r#"{"event":"choose","end":"p2","edge":"right"},"#,
            r#"{"event":"cut","end":"p2","edge":"right","u":{"num":1.5,"den":2.5},"from":[2.0,0.0],"to":[1.0,0.0]},"#,
            r#"{"event":"code","end":"p2","at":[1.0,0.0],"code":"0000"},"#,
            r#"{"event":"or","or":"0000"},{"event":"accept","segment":[-0.5,0.0,1.0,0.0]}]}"#,
            "\n"
        )
    );
    assert_eq!((tally.answered, tally.refused), (1, 0));
}

#[test]
fn without_events_the_answer_is_the_same() {
    for solver in line_solvers() {
        let case = format!(
            r#"{{"algorithm":"{}","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}}"#,
            solver.card.id
        );
        steps_are_all_that_is_left_out(&case);
    }
}

#[test]
fn every_mistake_is_named_with_its_place() {
    let line = |fields: &str| format!(r#"{{"algorithm":"cyrus-beck",{fields}}}"#);
    let clip = |outline: &str| line(&format!(r#""segment":[0,0,1,1],"clip":{outline}"#));
    let window = |window: &str| line(&format!(r#""segment":[0,0,1,1],"window":{window}"#));
    let segment = |segment: &str| line(&format!(r#""window":[0,0,1,1],"segment":{segment}"#));
    for (case, code, field) in [
        ("{".to_owned(), "bad-json", ""),
        (r#"{"id":NaN}"#.to_owned(), "bad-json", ""),
        (r#"{"id":"\ud800"}"#.to_owned(), "bad-json", "id"),
        (r#"{"id":1,"id":2}"#.to_owned(), "bad-json", "id"),
        ("[1]".to_owned(), "wrong-type", ""),
        ("[1".to_owned(), "bad-json", ""),
        ("{}".to_owned(), "missing-field", "algorithm"),
        (r#"{"algorithm":1}"#.to_owned(), "wrong-type", "algorithm"),
        (
            r#"{"algorithm":"x"}"#.to_owned(),
            "unknown-algorithm",
            "algorithm",
        ),
        (line(r#""segment":[0,0,1,1]"#), "missing-field", "window"),
        (line(r#""window":[0,0,1,1]"#), "missing-field", "segment"),
        (line(r#""windwo":[0,0,1,1]"#), "unknown-field", "windwo"),
        (line(r#""bit_order":"tbrl""#), "unknown-field", "bit_order"),
        (
            line(r#""segment":[0,0,1,1],"clip":[],"window":[0,0,1,1]"#),
            "unknown-field",
            "clip",
        ),
        (segment("[0,0,1]"), "wrong-length", "segment"),
        (segment("[0,0,1,1,1]"), "wrong-length", "segment"),
        (segment("null"), "wrong-type", "segment"),
        (segment("[0,0,null,1]"), "wrong-type", "segment[2]"),
        (segment(r#"[0,"1",1,1]"#), "wrong-type", "segment[1]"),
        (segment("[0,0,1e999,1]"), "not-finite", "segment[2]"),
        (segment("[0,0,1,-1e999]"), "not-finite", "segment[3]"),
        (window("[1,0,-1,1]"), "empty-window", "window"),
        (window("[0,0,1,0]"), "empty-window", "window"),
        (window("[0,-1e400,1,1]"), "not-finite", "window[1]"),
        (clip("[[0,0],[1e999,0],[0,1]]"), "not-finite", "clip[1][0]"),
        (clip("[[0,0],[1],[0,1]]"), "wrong-length", "clip[1]"),
        (clip("[[0,0],7,[0,1]]"), "wrong-type", "clip[1]"),
        (clip("[[0,0],[1,0]]"), "degenerate", "clip"),
        (clip("[]"), "degenerate", "clip"),
        (clip("[[0,0],[1,0],[1,0],[0,1]]"), "degenerate", "clip[2]"),
        (clip("[[0,0],[1,0],[2,0]]"), "degenerate", "clip[0]"),
        (clip("[[0,0],[4,0],[1,1],[0,4]]"), "not-convex", "clip[2]"),
        (
            clip("[[0,3],[-2,-3],[3,1],[-3,1],[2,-3]]"),
            "self-intersecting",
            "clip[3]",
        ),
        (
            clip(&format!("[{}[0,0]]", "[0,0],".repeat(1024))),
            "too-large",
            "clip",
        ),
    ] {
        let found = refusal(&case);
        assert_eq!(found, [code, field], "{case:.200}");
    }
}

#[test]
fn a_bit_order_is_one_of_two_words() {
    let case = |order: &str| {
        format!(
            r#"{{"algorithm":"cohen-sutherland","bit_order":{order},"window":[-1,-1,1,1],"segment":[-2,0,0,0]}}"#
        )
    };
    let code = |order| answer(&case(order))["events"][0]["code"].clone();
    assert_eq!([code(r#""tbrl""#), code(r#""lrbt""#)], ["0001", "1000"]);
    assert_eq!(refusal(&case(r#""TBRL""#)), ["wrong-type", "bit_order"]);
    assert_eq!(refusal(&case("1")), ["wrong-type", "bit_order"]);
}

#[test]
fn of_several_mistakes_the_first_in_the_stated_order_is_told() {
    for (case, code, field) in [
        (r#"{"algorithm":"x","zoom":1,"zoom":2}"#, "bad-json", "zoom"),
        (
            r#"{"zoom":1,"algorithm":"x"}"#,
            "unknown-algorithm",
            "algorithm",
        ),
        (
            r#"{"zoom":1,"algorithm":"liang-barsky"}"#,
            "unknown-field",
            "zoom",
        ),
        (
            r#"{"segment":1,"algorithm":"liang-barsky"}"#,
            "missing-field",
            "window",
        ),
        (
            r#"{"segment":1,"window":[1,1,0],"algorithm":"liang-barsky"}"#,
            "wrong-length",
            "window",
        ),
        (
            r#"{"segment":1,"window":[1,1,0,1e999],"algorithm":"liang-barsky"}"#,
            "not-finite",
            "window[3]",
        ),
    ] {
        assert_eq!(refusal(case), [code, field], "{case}");
    }
}

#[test]
fn any_id_is_echoed_digit_for_digit() {
    for (id, echo) in [
        ("null", "null"),
        ("12345678901234567890123", "12345678901234567890123"),
        ("1.50", "1.50"),
        ("1e999", "1e999"),
        (r#""S2 \u00e9\n""#, r#""S2 é\n""#),
        (r#"{ "b": [1, true], "a": {} }"#, r#"{"b":[1,true],"a":{}}"#),
        ("[ ]", "[]"),
    ] {
        let text = answers(&format!(r#"{{"id": {id}}}"#), JSON);
        assert!(
            text.starts_with(&format!(r#"{{"id":{echo},"line":1,"error""#)),
            "{text}"
        );
    }
    let text = answers(r#"{"algorithm":"x"}"#, JSON);
    assert!(text.starts_with(r#"{"id":null,"#), "{text}");
}

#[test]
fn deep_nesting_is_refused_and_does_not_overflow_the_stack() {
    let deep = "[".repeat(1_000_000) + &"]".repeat(1_000_000);
    assert_eq!(refusal(&deep), ["wrong-type", ""]);
    let case = format!(r#"{{"id":{deep}}}"#);
    assert_eq!(refusal(&case), ["bad-json", "id"]);
    let case = format!(r#"{{"algorithm":"liang-barsky","window":{deep},"segment":[0,0,1,1]}}"#);
    assert_eq!(refusal(&case), ["wrong-length", "window"]);
    assert_eq!(refusal(&"[".repeat(1_000_000)), ["bad-json", ""]);
}

#[test]
fn a_bad_line_does_not_stop_the_rest() {
    let good = r#"{"id":1,"algorithm":"liang-barsky","window":[-1,-1,1,1],"segment":[0,0,1,1]}"#;
    let mut cases = Vec::new();
    cases.extend_from_slice("\u{feff}".as_bytes());
    cases.extend_from_slice(good.as_bytes());
    cases.extend_from_slice(b"\r\n\n  \t\n\xff\xfe\n");
    cases.resize(cases.len() + MAX_LINE_BYTES + 1, b' ');
    cases.extend_from_slice(b"\n");
    cases.extend_from_slice(good.as_bytes());
    let (text, tally) = tallied(&cases, JSON);
    let lines: Vec<Json> = text
        .lines()
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect();
    assert_eq!(lines.len(), 4);
    assert_eq!(lines[0], lines[3]);
    assert_eq!(lines[0]["output"]["visible"], json!(true));
    assert_eq!(lines[1]["error"]["code"], json!("bad-json"));
    assert_eq!(lines[2]["error"]["code"], json!("too-large"));
    assert_eq!((tally.answered, tally.refused), (2, 2));
}

#[test]
fn a_line_of_the_largest_size_is_still_read() {
    let case = r#"{"algorithm":"liang-barsky","window":[-1,-1,1,1],"segment":[0,0,1,1]}"#;
    let mut line = case.as_bytes().to_vec();
    line.resize(MAX_LINE_BYTES, b' ');
    for end in ["", "\n", "\n\n"] {
        let cases = [&line, end.as_bytes()].concat();
        assert_eq!(tallied(&cases, JSON).1.answered, 1);
    }
    let too_long = [&line[..], b" "].concat();
    assert_eq!(tallied(&too_long, JSON).1.refused, 1);
    let Err(refused) = read(Solvers::standard(), CaseLine::TooLong, Detail::Answers) else {
        panic!("a line that is too long is refused");
    };
    assert_eq!(refused.refusal.code, Code::TooLarge);
}

#[test]
fn a_polygon_may_wind_either_way() {
    let visible = |clip: &str| {
        let case = format!(r#"{{"algorithm":"cyrus-beck","clip":{clip},"segment":[-3,1,1,1]}}"#);
        answer(&case)["output"]["segment"].clone()
    };
    let expected = json!([-1.0, 1.0, 1.0, 1.0]);
    assert_eq!(visible("[[0,-2],[2,0],[0,2],[-2,0]]"), expected);
    assert_eq!(visible("[[0,-2],[-2,0],[0,2],[2,0]]"), expected);
}

const REPORTED: &str = concat!(
    r#"{"id":"a|b","algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,0,0.5,0]}"#,
    "\n",
    r#"{"id":2,"algorithm":"cohen-sutherland","window":[1,-1,-1,1],"segment":[-2,0,0.5,0]}"#,
    "\n"
);

#[test]
fn reports_on_lines_are_as_they_were() {
    let files = [
        ("en.md", Format::Markdown, Lang::En),
        ("zh-CN.md", Format::Markdown, Lang::ZhCn),
        ("es.md", Format::Markdown, Lang::Es),
        ("pt-BR.md", Format::Markdown, Lang::PtBr),
        ("worksheet-es.md", Format::Worksheet, Lang::Es),
        ("en.txt", Format::Text, Lang::En),
        ("zh-CN.txt", Format::Text, Lang::ZhCn),
    ];
    reports_are_as_they_were(REPORTED, &files);
}

#[test]
fn a_terminals_lines_fit_it() {
    for solver in line_solvers() {
        let case = format!(
            r#"{{"algorithm":"{}","window":[-1.125,-1.1,1.01,1],"segment":[-2.123,-1.456,2.789,1.5432]}}"#,
            solver.card.id
        );
        lines_are_at_most_a_hundred_columns_wide(&case);
    }
}

#[test]
fn a_case_can_name_only_the_solvers_that_are_handed_in() {
    static TABLE: [Solver; 1] = [Solver::of::<clipscope::algo::line::LiangBarsky>()];
    static TABLES: [&[Solver]; 1] = [&TABLE];
    let solvers = Solvers::new(&TABLES);
    let case = |algorithm: &str| {
        format!(r#"{{"algorithm": "{algorithm}", "window": [-1,-1,1,1], "segment": [0,0,2,0]}}"#)
    };
    let answer = |algorithm: &str| {
        read(
            solvers,
            CaseLine::Bytes(case(algorithm).as_bytes()),
            Detail::Steps,
        )
    };
    assert!(answer("liang-barsky").is_ok());
    let refused = answer("cyrus-beck").err().expect("an unknown algorithm");
    assert_eq!(refused.refusal.code, Code::UnknownAlgorithm);
    assert!(refused.refusal.message().ends_with("Known: liang-barsky."));
}
