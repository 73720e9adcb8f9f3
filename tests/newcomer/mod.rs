//! A small method as a newcomer wrote it by CONTRIBUTING.md: a box culled by the outcodes of its corners. The product does not have it.
//! Here it goes through what a method goes through there, by the public API alone, so that a new one stays as small as this one.

mod corner_codes;
mod solver;
mod telling;

use std::{collections::BTreeSet, ops::ControlFlow, sync::Arc};

use clipscope::{
    algo::cull::{BoxCull, BoxCullInput, Containment},
    case::{Detail, Format, Solver, Solvers, Style, trace},
    geom::{AlignedBox, Matrix, Plane, VolumeSide},
    labs::{
        frustum::{first_scene, prelude::*},
        space::Part,
    },
    text::{Catalog, Lang},
    trace::laws,
};
use proptest::prelude::*;

use crate::messages::messages;
use corner_codes::{CornerCodes, CornerCodesInput};

const MOST_LINES: usize = 480;

const OWN: [&str; 7] = [
    include_str!("corner_codes.rs"),
    include_str!("telling.rs"),
    include_str!("solver.rs"),
    source(Lang::En),
    source(Lang::ZhCn),
    source(Lang::Es),
    source(Lang::PtBr),
];

const fn source(lang: Lang) -> &'static str {
    match lang {
        Lang::En => include_str!("en.ftl"),
        Lang::ZhCn => include_str!("zh-CN.ftl"),
        Lang::Es => include_str!("es.ftl"),
        Lang::PtBr => include_str!("pt-BR.ftl"),
    }
}

#[test]
fn a_method_is_small() {
    let n_lines: usize = OWN.iter().map(|text| text.lines().count()).sum();
    assert!(n_lines <= MOST_LINES, "{n_lines} lines");
}

/// A sentence of the method's own, with the values of a step.
fn said(lang: Lang, key: &str, at: &At<'_, CornerCodes>) -> String {
    let head = format!("{key} = ");
    let text = source(lang)
        .lines()
        .find_map(|line| line.strip_prefix(&head));
    let text = text
        .unwrap_or_else(|| panic!("{lang} lacks {key}"))
        .to_owned();
    let (_, names) = messages(source(lang))
        .into_iter()
        .find(|(it, _)| it == key)
        .unwrap();
    names.iter().fold(text, |text, name| {
        let value = at.value(name);
        let value = value.unwrap_or_else(|| panic!("{key} says {name}, which is not alive"));
        text.replace(&format!("{{ ${name} }}"), &Catalog::of(lang).value(&value))
    })
}

/// What the walks over all methods ask of each step of theirs.
fn check_step(at: &At<'_, CornerCodes>) {
    let row = at.row();
    for template in row.so {
        assert!(at.formula(template).is_some(), "{template} of {}", row.key);
    }
    let choice = at.options();
    assert_eq!(choice.is_some(), row.answers.is_some(), "{}", row.key);
    for lang in Lang::ALL {
        assert!(
            !said(lang, row.key, at).contains(['{', '⟦']),
            "{} in {lang}",
            row.key
        );
        let Some(choice) = &choice else { continue };
        let options = choice.options.iter().map(|option| match option {
            Value::Message(option) => said(lang, option.key, at),
            other => panic!("{other:?} is no row"),
        });
        let options: Vec<String> = options.collect();
        assert_eq!(
            options[choice.right],
            said(lang, row.option.unwrap_or(row.key), at)
        );
        let differ: BTreeSet<&String> = options.iter().collect();
        assert!(
            differ.len() == options.len() && options.len() > 1,
            "{options:?}"
        );
    }
}

#[test]
fn every_step_is_told_and_asked() {
    let mut scene = first_scene();
    let mut rows = BTreeSet::new();
    for object_idx in 0..scene.objects().len() {
        scene.look_at(Part::Object, object_idx).unwrap();
        let scenery = Scenery::new(&scene);
        let recording = Recording::<CornerCodes>::new(CornerCodes::input(&scene));
        recording.walk([0, 9], |n, step| {
            let scenery = Some(&scenery);
            let at = At {
                step: *step,
                scenery,
            };
            check_step(&at);
            rows.extend((n > 0).then(|| CornerCodes::row_idx(step)));
            assert_eq!(CornerCodes::views(&at).len(), 3);
            ControlFlow::<()>::Continue(())
        });
        let run = Recorded::<CornerCodes>::new(recording.input().clone(), Some(Arc::new(scenery)));
        let run: &dyn Run = &run;
        assert_eq!(run.n_steps(), recording.events().len());
        let n_lines = CornerCodes::CODE.len();
        assert!((1..=9).all(|step| run.code_line(step).is_some_and(|line| line < n_lines)));
        assert_eq!(run.why(Link::nth("corner", 7)), Some(8));
    }
    assert_eq!(
        rows.len(),
        CornerCodes::ROWS.len(),
        "only rows {rows:?} were seen"
    );
}

#[test]
fn every_language_says_all_of_it() {
    let rows = CornerCodes::ROWS.iter().chain([&CornerCodes::OPENING]);
    let rows = rows.flat_map(|row| [row.key].into_iter().chain(row.option));
    let lines = CornerCodes::CODE
        .iter()
        .flat_map(|line| [line.code, line.words]);
    let verdict = "case-corners-straddles";
    let used: BTreeSet<&str> = rows
        .chain(lines)
        .chain([CornerCodes::NAME_KEY, verdict])
        .collect();
    let english = messages(source(Lang::En));
    for lang in Lang::ALL {
        assert_eq!(messages(source(lang)), english, "{lang}");
        let own = |key: &str| english.iter().any(|(it, _)| it == key);
        let known = |key: &str| !Catalog::of(lang).term(key).contains('⟦');
        for &key in &used {
            assert!(own(key) != known(key), "{key} in {lang}");
        }
    }
    let unused: Vec<_> = english
        .iter()
        .filter(|(key, _)| !used.contains(&key[..]))
        .collect();
    assert!(unused.is_empty(), "{unused:?}");
}

#[test]
fn cases_are_answered() {
    static TABLES: [&[Solver]; 1] = [&[Solver::of::<CornerCodes>()]];
    for (bounds, expected) in [
        (
            "[5,-1,-4,9,1,-2]",
            r#"{"class":"outside","codes":["000010","000010","#,
        ),
        (
            "[0,-1,-4,1,1,-2]",
            r#"{"class":"inside","codes":["000000","000000","#,
        ),
        (
            "[0,-1,-4,9,1,-2]",
            r#"{"class":"straddles","codes":["000000","000010","#,
        ),
    ] {
        let volume = r#"{"fov_y_deg":90,"aspect":1,"near":1,"far":10}"#;
        let case = format!(r#"{{"algorithm":"corner-codes","frustum":{volume},"box":{bounds}}}"#);
        let style = Style {
            format: Format::Json,
            detail: Detail::Answers,
            lang: Lang::En,
        };
        let mut answer = Vec::new();
        trace(
            Solvers::new(&TABLES),
            case.as_bytes(),
            &mut answer,
            style,
            |_| {},
        )
        .unwrap();
        let answer = String::from_utf8(answer).unwrap();
        assert!(answer.contains(expected), "{bounds}: {answer}");
    }
}

/// w + a ≥ 0 or w − a ≥ 0 of a clip matrix, as the whole numbers of a plane.
fn bound(rows: &[[i64; 4]; 4], side: VolumeSide) -> [i64; 4] {
    let sign = if side.is_high() { -1 } else { 1 };
    std::array::from_fn(|i| rows[3][i] + sign * rows[side.axis()][i])
}

proptest! {
    /// The codes against whole numbers, and the class against the planes' test of the same box.
    #[test]
    fn codes_say_what_planes_say(
        rows in prop::array::uniform4(prop::array::uniform4(-6..7_i64)),
        low in prop::array::uniform3(-5..5_i64),
        size in prop::array::uniform3(0..5_i64),
    ) {
        let high: [i64; 3] = std::array::from_fn(|i| low[i] + size[i]);
        let bounds = [low[0], low[1], low[2], high[0], high[1], high[2]].map(|x| x as f64);
        let bounds = AlignedBox::new(bounds).unwrap();
        let clip_from_box = Matrix::new(rows.map(|row| row.map(|x| x as f64))).unwrap();
        let input = CornerCodesInput { clip_from_box, bounds };
        laws::check::<CornerCodes>(&input);
        let output = silent::<CornerCodes>(&input);
        for (corner, code) in bounds.corners().into_iter().zip(output.codes) {
            let [x, y, z] = corner.map(|x| x as i64);
            for side in VolumeSide::ALL {
                let [a, b, c, d] = bound(&rows, side);
                prop_assert_eq!(code.has(side), a * x + b * y + c * z + d < 0);
            }
            prop_assert!(!code.is_inside() || output.class != Containment::Outside);
        }
        let planes = VolumeSide::ALL.map(|side| Plane::new(bound(&rows, side).map(|x| x as f64)));
        if let Ok(planes) = planes.into_iter().collect() {
            let by_planes = silent::<BoxCull>(&BoxCullInput { planes, bounds });
            prop_assert_eq!(output.class, by_planes.class);
        }
    }
}
