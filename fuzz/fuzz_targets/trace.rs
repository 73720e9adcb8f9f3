//! Bytes into `clipscope trace`, and what must hold of whatever comes out.
#![no_main]

use clipscope::{
    case::{Case, CaseLine, CaseLines, Detail, Format, Solvers, Style, read, trace},
    text::Lang,
};
use libfuzzer_sys::fuzz_target;
use serde_json::{Value as Json, json};

fuzz_target!(|bytes: &[u8]| {
    // Marks a hole in a text, so it is not to come from outside.
    if String::from_utf8_lossy(bytes).contains('⟦') {
        return;
    }
    let with_steps = answers(bytes, Format::Json, Detail::Steps);
    let without = answers(bytes, Format::Json, Detail::Answers);
    let (with_steps, without) = (parsed(&with_steps), parsed(&without));

    let mut lines = CaseLines::new(bytes);
    let mut n_lines = 0;
    while let Some((_, line)) = lines.next_line().expect("memory can be read") {
        let answer = &with_steps[n_lines];
        let [mut recorded, mut alone] = [answer.clone(), without[n_lines].clone()];
        if let Some(fields) = recorded.as_object_mut() {
            fields.remove("events");
        }
        if answer["algorithm"] == "ray-casting" {
            // Boxes are asked first.
            recorded["counts"].take();
            alone["counts"].take();
        }
        // What is too much to be told, or too large, may still be answered.
        let code = &answer["error"]["code"];
        if code != "too-large" && code != "not-finite" {
            assert_eq!(recorded, alone, "steps change no answer");
        }
        match read(Solvers::standard(), line, Detail::Steps) {
            Ok(case) => check_answer(line, &case, answer),
            Err(refused) => assert_eq!(answer["error"]["code"], refused.refusal.code.id()),
        }
        n_lines += 1;
    }
    assert_eq!(with_steps.len(), n_lines, "one answer a line");

    // A report's length grows with the square of a polygon's.
    if bytes.len() < 1000 {
        let text = answers(bytes, Format::Text, Detail::Steps);
        let markdown = answers(bytes, Format::Markdown, Detail::Steps);
        assert!(!text.contains('⟦') && !markdown.contains('⟦'), "{text}");
    }
});

fn answers(bytes: &[u8], format: Format, detail: Detail) -> String {
    let lang = Lang::ALL[bytes.len() % Lang::ALL.len()];
    let style = Style {
        format,
        detail,
        lang,
    };
    let mut out = Vec::new();
    trace(Solvers::standard(), bytes, &mut out, style, |_| {})
        .expect("memory can be read and written");
    String::from_utf8(out).expect("answers are UTF-8")
}

fn parsed(answers: &str) -> Vec<Json> {
    // An echoed number may be beyond an f64: valid JSON, but not for this reader.
    let parse = |line: &str| match serde_json::from_str(line) {
        Ok(answer) => answer,
        Err(error) if error.to_string().contains("number out of range") => without_id(line),
        Err(error) => panic!("{line}: {error}"),
    };
    answers.lines().map(parse).collect()
}

/// The same answer without its id: what follows the last `"algorithm":` or `"error":` of the outer object.
fn without_id(line: &str) -> Json {
    let starts = [r#","algorithm":""#, r#","error":{""#];
    let tails = starts.iter().flat_map(|start| {
        let places = line.match_indices(start).map(|(i, _)| i + 1);
        places.map(|i| format!("{{{}", &line[i..]))
    });
    tails
        .filter_map(|tail| serde_json::from_str(&tail).ok())
        .next()
        .expect("an answer is JSON after its id")
}

fn check_answer(line: CaseLine<'_>, case: &Case, answer: &Json) {
    assert_eq!(case.problem.output(), answer["output"], "silent and traced");
    let CaseLine::Bytes(bytes) = line else {
        panic!("a line that is too long is refused");
    };
    // Only an id may hold what this reader cannot read.
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let Ok(given) = serde_json::from_slice::<Json>(bytes) else {
        return;
    };
    if given["polygon"].is_array() {
        return check_polygons(&given, answer);
    }
    if answer["output"]["segment"].is_null() && answer["output"]["visible"].is_null() {
        return check_sphere(&given, answer);
    }
    let visible = &answer["output"]["segment"];
    assert_eq!(answer["output"]["visible"], json!(!visible.is_null()));
    let [xmin, ymin, xmax, ymax] = bounds(&given);
    let ends = numbers(visible);
    for end in ends.chunks_exact(2) {
        let inside = (xmin..=xmax).contains(&end[0]) && (ymin..=ymax).contains(&end[1]);
        assert!(inside, "{end:?} lies outside in {answer}");
    }
    check_reversed(given, &ends);
}

/// What is left of a polygon lies in the box of the clip region.
fn check_polygons(given: &Json, answer: &Json) {
    let [xmin, ymin, xmax, ymax] = bounds(given);
    let rings = answer["output"]["polygons"].as_array();
    let vertices = rings
        .into_iter()
        .flatten()
        .filter_map(Json::as_array)
        .flatten();
    for vertex in vertices.map(numbers) {
        let inside = (xmin..=xmax).contains(&vertex[0]) && (ymin..=ymax).contains(&vertex[1]);
        assert!(inside, "{vertex:?} lies outside in {answer}");
    }
}

/// A sphere is outside where one plane says so, and inside where all do; nothing is asked here of a box or a face.
fn check_sphere(given: &Json, answer: &Json) {
    let sphere = numbers(&given["sphere"]);
    let (Some(class), Some(&radius)) = (answer["output"]["class"].as_str(), sphere.last()) else {
        return;
    };
    let distances = numbers(&answer["output"]["distances"]);
    let expected = if distances.iter().any(|&d| d < -radius) {
        "outside"
    } else if distances.iter().all(|&d| d >= radius) {
        "inside"
    } else {
        "straddles"
    };
    assert_eq!(class, expected, "{answer}");
}

/// Clipping the reversed segment gives the mirror image, bit for bit.
fn check_reversed(mut given: Json, ends: &[f64]) {
    let segment = numbers(&given["segment"]);
    given["segment"] = json!([segment[2], segment[3], segment[0], segment[1]]);
    let line = given.to_string();
    let Ok(case) = read(
        Solvers::standard(),
        CaseLine::Bytes(line.as_bytes()),
        Detail::Answers,
    ) else {
        panic!("{line} is refused, its reverse is not");
    };
    let mirrored = numbers(&case.problem.output()["segment"]);
    let expected = match ends {
        [x1, y1, x2, y2] => vec![*x2, *y2, *x1, *y1],
        _ => Vec::new(),
    };
    let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(
        bits(&mirrored),
        bits(&expected),
        "the mirror image of {line}"
    );
}

/// The window, or the box around the clip polygon.
fn bounds(given: &Json) -> [f64; 4] {
    let window = numbers(&given["window"]);
    if let Ok(window) = window.try_into() {
        return window;
    }
    let mut bounds = [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY];
    for vertex in given["clip"].as_array().into_iter().flatten() {
        let vertex = numbers(vertex);
        for axis in 0..2 {
            bounds[axis] = bounds[axis].min(vertex[axis]);
            bounds[axis + 2] = bounds[axis + 2].max(vertex[axis]);
        }
    }
    bounds
}

fn numbers(list: &Json) -> Vec<f64> {
    let elements = list.as_array().into_iter().flatten();
    elements.filter_map(Json::as_f64).collect()
}
