//! Of every algorithm the first answer that is wrong has a picture, and the numbers of the true step.

use clipscope::{
    case::{Detail, Solvers},
    figure::{Body, RasterShape, Shape, Shape3},
    grade::{Options, Scenery, Wrong, grade},
};
use serde_json::{Value as Json, json};

use super::traced;

/// A case of each algorithm.
const CASES: &str = r#"{"algorithm":"brute-force","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}
{"algorithm":"cyrus-beck","clip":[[0,-2],[2,0],[0,2],[-2,0]],"segment":[-3,1,1,1]}
{"algorithm":"sutherland-hodgman","window":[-1,-1,1,1],"polygon":[[0,0],[2,0],[0,2]]}
{"algorithm":"ear-clipping","polygon":[[0,0],[2,1],[4,0],[2,4]]}
{"algorithm":"cohen-sutherland-3d","box":[-1,-1,-1,1,1,1],"segment":[-2,-1,0,2,1.5,0.5]}
{"algorithm":"liang-barsky-3d","box":[-1,-1,-1,1,1,1],"segment":[-2,-1,0,2,1.5,0.5]}
{"algorithm":"plane-line","planes":[[1,0,0,1],[-1,0,0,1]],"segment":[-2,-1,0,2,1.5,0.5]}
{"algorithm":"homogeneous-line","segment":[0,0,0,1,3,0,3,2]}
{"algorithm":"homogeneous-triangle","triangle":[[0,0,0,1],[3,0,0,1],[0,3,0,1]]}
{"algorithm":"plane-at-a-time","planes":[[1,0,0,0],[0,1,0,0]],"triangle":[[-1,1,0],[2,1,0],[1,-1,0]]}
{"algorithm":"intersection-polygon","frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangle":[[0,1,-3],[6,1,-4],[1,-1,-2]]}
{"algorithm":"sphere-cull","frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"sphere":[2,0.5,-4,1]}
{"algorithm":"box-cull","frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"box":[1,0,-6,3,2,-4]}
{"algorithm":"back-face","triangle":[[0,0,0],[2,0,0],[0,2,0]],"eye":[1,1,4]}
{"algorithm":"viewing-pipeline","point":[1,1,0],"camera":{"position":[0,2,5],"target":[0,0,0],"up":[0,1,0],"fov_y_deg":60,"aspect":1.5,"near":1,"far":20},"size":[300,200]}
{"algorithm":"depth-buffer","size":[6,6],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-3,-3,-3],[3,-3,-3],[0,3,-3]],[[-3,-3,-5],[3,-3,-4],[0,3,-5]]]}
{"algorithm":"ray-casting","size":[6,6],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-3,-3,-3],[3,-3,-3],[0,3,-3]],[[-3,-3,-5],[3,-3,-4],[0,3,-5]]]}
{"algorithm":"painter","size":[6,6],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-3,-3,-3],[3,-3,-3],[0,3,-3]],[[-3,-3,-5],[3,-3,-4],[0,3,-5]]]}
{"algorithm":"bsp","size":[6,6],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-3,-3,-3],[3,-3,-3],[0,3,-3]],[[-3,-3,-5],[3,-3,-4],[0,3,-5]]]}
{"algorithm":"occlusion","size":[6,6],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"objects":[[[[-3,-3,-3],[3,-3,-3],[0,3,-3]]],[[[-1,-1,-5],[1,-1,-5],[0,1,-5]]]]}
{"algorithm":"bresenham","from":[0,0],"to":[9,4]}"#;

/// A depth buffer of this size.
fn buffer(size: &str) -> String {
    let mut cases = CASES.lines();
    let case = cases.find(|case| case.contains("depth-buffer"));
    case.unwrap().replace("[6,6]", size)
}

/// The first number or word of a value, the next one, and so on: each by itself something else than it was.
fn spoilt(value: &Json) -> Vec<Json> {
    match value {
        Json::Null => Vec::new(),
        Json::Bool(is_so) => vec![json!(!is_so)],
        Json::Number(number) if number.is_f64() => vec![json!(number.as_f64().unwrap() + 0.25)],
        Json::Number(number) => vec![json!(number.as_i64().unwrap() + 1)],
        Json::String(_) => vec![json!("something-else")],
        Json::Array(entries) => {
            let with = |(i, entry): (usize, Json)| {
                let mut all = entries.clone();
                all[i] = entry;
                Json::from(all)
            };
            let each = entries.iter().enumerate().take(4);
            let each = each.flat_map(|(i, entry)| spoilt(entry).into_iter().map(move |it| (i, it)));
            each.map(with).collect()
        }
        Json::Object(fields) => {
            let with = |(name, entry): (String, Json)| {
                let mut all = fields.clone();
                all.insert(name, entry);
                Json::from(all)
            };
            let each = fields.iter().filter(|(name, _)| *name != "event");
            let each = each.flat_map(|(name, entry)| {
                spoilt(entry).into_iter().map(move |it| (name.clone(), it))
            });
            each.map(with).collect()
        }
    }
}

fn first_wrong<T>(case: &str, answer: &Json, look: impl Fn(&Wrong) -> T) -> Option<T> {
    let (mut seen, solvers) = (None, Solvers::standard());
    let answer = answer.to_string();
    let done = grade(
        solvers,
        case.as_bytes(),
        answer.as_bytes(),
        Options::default(),
        |report| {
            seen = report.wrong.first().map(&look);
            Ok(())
        },
    );
    done.unwrap();
    seen
}

/// What of a picture is the program's, and what is true.
fn signs(scenery: &Scenery) -> [usize; 2] {
    let mut signs = [0; 2];
    match scenery {
        Scenery::Plane { marks, .. } => {
            for mark in marks {
                signs[0] += usize::from(matches!(mark.shape, Shape::Cross(_)));
                signs[1] += usize::from(matches!(mark.shape, Shape::Ring(_)));
            }
        }
        Scenery::Views(views) => {
            for view in views {
                if let Body::Space(space) = &view.body {
                    for mark in &space.marks {
                        signs[0] += usize::from(matches!(mark.shape, Shape3::Cross(_)));
                        signs[1] += usize::from(matches!(mark.shape, Shape3::Ring(_)));
                    }
                }
                if let Body::Raster(raster) = &view.body {
                    for mark in &raster.over {
                        signs[0] += usize::from(matches!(mark.shape, RasterShape::Cross(_)));
                        signs[1] += usize::from(matches!(mark.shape, RasterShape::Ring(_)));
                    }
                }
            }
        }
    }
    signs
}

#[test]
fn whatever_of_an_answer_is_wrong_is_drawn_with_the_numbers() {
    let solvers = Solvers::standard();
    for case in CASES.lines() {
        let traced: Json = serde_json::from_str(&traced(case, Detail::Steps)).unwrap();
        assert!(traced.get("output").is_some(), "{traced}");
        let (mut n_drawn, mut n_signed) = (0, 0);
        for output in spoilt(&traced["output"]) {
            let answer = json!({ "output": output });
            let drawn = first_wrong(case, &answer, |wrong| {
                (wrong.scenery(solvers), wrong.numbers(solvers))
            });
            let Some((scenery, numbers)) = drawn else {
                continue;
            };
            assert!(numbers.is_some(), "{case}: {output}");
            let scenery = scenery.unwrap_or_else(|| panic!("{case}: {output}"));
            n_drawn += 1;
            n_signed += usize::from(signs(&scenery).iter().all(|n| *n > 0));
        }
        assert!(
            n_drawn > 0 && 2 * n_signed >= n_drawn,
            "{case}: {n_signed} of {n_drawn}"
        );
    }
}

#[test]
fn whichever_step_is_wrong_is_drawn_with_its_numbers() {
    let solvers = Solvers::standard();
    for case in CASES.lines() {
        let traced: Json = serde_json::from_str(&traced(case, Detail::Steps)).unwrap();
        let events = traced["events"].as_array().unwrap();
        let mut kinds = std::collections::BTreeSet::new();
        let (mut n_wrong, mut n_drawn) = (0, 0);
        for (i, event) in events.iter().enumerate() {
            if !kinds.insert(event["event"].to_string()) {
                continue;
            }
            for spoilt in spoilt(event) {
                let mut events = events.clone();
                events[i] = spoilt;
                let answer = json!({ "output": traced["output"], "events": events });
                let drawn = first_wrong(case, &answer, |wrong| {
                    let numbers = wrong.numbers(solvers).expect("a step says something");
                    assert_eq!(wrong.step, Some(i + 1), "{case}");
                    (numbers, wrong.scenery(solvers).is_some())
                });
                let Some((numbers, is_drawn)) = drawn else {
                    continue;
                };
                let read = clipscope::case::read(
                    solvers,
                    clipscope::case::CaseLine::Bytes(case.as_bytes()),
                    Detail::Steps,
                );
                let run = read.ok().unwrap().problem.run();
                assert_eq!(numbers, run.caption(i + 1), "{case}: step {}", i + 1);
                n_wrong += 1;
                n_drawn += usize::from(is_drawn);
            }
        }
        assert!(
            3 * n_drawn >= 2 * n_wrong && n_drawn > 0,
            "{case}: {n_drawn} of {n_wrong}"
        );
    }
}

#[test]
fn of_pixels_each_one_that_differs_has_its_sign() {
    let case = buffer("[6,6]");
    let traced: Json = serde_json::from_str(&traced(&case, Detail::Answers)).unwrap();
    let mut output = traced["output"].clone();
    let ids = output["ids"].as_array_mut().unwrap();
    let seen: Vec<usize> = (0..ids.len()).filter(|&i| ids[i] == 0).collect();
    for &place in &seen {
        ids[place] = json!(1);
    }
    let solvers = Solvers::standard();
    let scenery = first_wrong(&case, &json!({ "output": output }), |wrong| {
        wrong.scenery(solvers)
    });
    let Some(Some(Scenery::Views(views))) = scenery else {
        panic!("two rasters");
    };
    assert_eq!(views.len(), 2);
    assert_eq!(signs(&Scenery::Views(views)), [seen.len(); 2]);
}

#[test]
fn of_a_large_raster_the_pixels_around_the_first_difference_are_drawn() {
    let case = buffer("[300,200]");
    let traced: Json = serde_json::from_str(&traced(&case, Detail::Answers)).unwrap();
    let mut output = traced["output"].clone();
    output["ids"][150 * 300 + 290] = json!(7);
    let solvers = Solvers::standard();
    let scenery = first_wrong(&case, &json!({ "output": output }), |wrong| {
        wrong.scenery(solvers)
    });
    let Some(Some(Scenery::Views(views))) = scenery else {
        panic!("two rasters");
    };
    for view in &views {
        let Body::Raster(raster) = &view.body else {
            panic!("a raster");
        };
        assert!(raster.size.iter().all(|side| (1..=32).contains(side)));
    }
    assert_eq!(signs(&Scenery::Views(views)), [1, 1]);
}
