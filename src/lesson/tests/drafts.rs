//! Lessons that are made in the window: what hands wrote stays.

use proptest::prelude::*;

use crate::{figure::Moment, labs::Scene};

use super::*;

/// Lessons of every lab, with goals, questions, scenes that are like others, meshes.
const LESSONS: [&str; 5] = [
    "04-cutting-with-outcodes",
    "09-sutherland-hodgman",
    "16-ear-clipping",
    "22-whole-objects-first",
    "34-the-depth-buffer",
];

fn lessons() -> Vec<String> {
    let course = Course::embedded();
    let ids = course.lessons.iter().map(|lesson| lesson.id.clone());
    let of_number = |id: &String| LESSONS.iter().any(|it| id.starts_with(&it[..3]));
    ids.filter(of_number).collect()
}

fn n_errors(draft: &Draft, id: &str) -> usize {
    let loaded = Course::check(&draft.over(id, &Embedded));
    let problems = loaded.problems.iter();
    problems.filter(|it| it.severity == Severity::Error).count()
}

/// What stands in the files of a step, but for which scene it shows and the white space around it.
fn of_step(draft: &Draft, id: &str) -> Vec<String> {
    let mut all = Vec::new();
    for (name, text) in draft.files() {
        let (start, end): (String, &[&str]) = if name == "lesson.toml" {
            (
                format!("[[step]]\nid = \"{id}\""),
                &["[[step]]", "[scenes."],
            )
        } else {
            (format!("## {id}: "), &["\n## "])
        };
        let Some(at) = text.find(&start) else {
            continue;
        };
        let rest = &text[at + 2..];
        let end = end.iter().filter_map(|end| rest.find(end)).min();
        let lines = rest[..end.unwrap_or(rest.len())].trim().lines();
        let lines = lines.filter(|line| !line.starts_with("scene = "));
        all.push(lines.collect::<Vec<_>>().join("\n"));
    }
    all
}

/// One change to a lesson, by three numbers; the steps that it is about.
fn changed(draft: &Draft, [kind, a, b]: [usize; 3]) -> Option<(Draft, Vec<String>)> {
    let ids = draft.ids();
    let id = ids[a % ids.len()].clone();
    let lang = Lang::ALL[b % 4];
    let new = draft.fresh("made-here");
    let made = match kind {
        0 => {
            let step = NewStep {
                id: new.clone(),
                scene: draft.scene_of(&ids[b % ids.len()])?,
                at: ["start", "end"][a % 2].to_owned(),
                texts: Lang::ALL
                    .map(|lang| (lang, [format!("Title {a}"), "One\n\n> two".to_owned()]))
                    .into(),
            };
            draft.with_step((b % 3 > 0).then_some(&*id), &step)
        }
        1 => draft.without_step(&id),
        2 => draft.with_moved(&id, b % ids.len()),
        3 => draft.with_id(&id, &new),
        4 => draft.with_title(&id, lang, "A *new* title: 2"),
        5 => draft.with_body(
            &id,
            lang,
            "A new text.\n\n- with\n- rows\n\n## not: a heading\n",
        ),
        // Each part of a goal has its line.
        6 if draft.field(&id, "goal").is_some() => return None,
        6 => draft.with_body(&id, lang, "A new text.\n\n- with\n- rows"),
        7 => draft.with_title("", lang, "Another lesson"),
        8 => draft.with_field(&id, "code", Some("\"words\"")),
        _ => draft.with_field(&id, "figure", None),
    };
    Some((made?, vec![id, new]))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn what_is_made_in_a_lesson_leaves_all_else_as_hands_wrote_it(
        lesson in 0..LESSONS.len(),
        changes in prop::collection::vec([0..10_usize, 0..20_usize, 0..20_usize], 1..8),
    ) {
        let id = &lessons()[lesson];
        let mut draft = Draft::read(&Embedded, id).expect("the course is readable");
        for change in changes {
            let scenes = draft.scenes();
            let Some((now, about)) = changed(&draft, change) else {
                continue;
            };
            for (step, scene) in scenes {
                if now.ids().contains(&step) && !about.contains(&step) {
                    prop_assert_eq!(now.scene_of(&step), Some(scene));
                    prop_assert_eq!(of_step(&now, &step), of_step(&draft, &step));
                }
            }
            draft = now;
        }
        prop_assert_eq!(n_errors(&draft, id), 0, "{:?}", draft);
    }
}

#[test]
fn a_step_is_put_moved_and_taken_and_the_first_bytes_are_back() {
    let toml = LESSON
        .replace("code = ", "# hide it?\ncode   = ")
        .replace('\n', "\r\n");
    let files = with(&toml, &TEXT.replace('\n', "\r\n"));
    let first = Draft::read(&files, "01-a").expect("two steps");
    let step = NewStep {
        id: "third".to_owned(),
        scene: "practice".to_owned(),
        at: "accept".to_owned(),
        texts: BTreeMap::from([(Lang::En, ["Third".to_owned(), "Three".to_owned()])]),
    };
    let put = first.with_step(Some("first"), &step).expect("a new step");
    assert_eq!(put.ids(), ["first", "third", "second"]);
    assert_eq!(put.passage("third", Lang::Es), ["Third", "Three"]);
    assert_eq!(put.without_step("third"), Some(first.clone()));
    assert_eq!(put.with_step(None, &step), None, "its name is taken");
    let moved = first.with_moved("second", 0).expect("two steps");
    assert_eq!(moved.ids(), ["second", "first"]);
    assert_eq!(moved.field("second", "scene"), Some("\"practice\""));
    assert_eq!(moved.field("second", "code"), Some("\"words\""));
    let alone = first.without_step("first").expect("one is left");
    assert_eq!(alone.without_step("second"), None);
    assert_eq!(first.with_id("first", "No id"), None);
    // Another scene between two steps is no other scene for the second.
    let other = put.with_new_scene("other", "method = \"cohen-sutherland\"");
    let other = other.expect("a scene").with_step(
        Some("first"),
        &NewStep {
            id: "fourth".to_owned(),
            scene: "other".to_owned(),
            ..step
        },
    );
    let scenes = other.expect("a step").scenes();
    let scenes: Vec<&str> = scenes.iter().map(|(_, scene)| &**scene).collect();
    assert_eq!(scenes, ["practice", "other", "practice", "practice"]);
}

#[test]
fn a_scene_is_written_where_it_differs() {
    let formats = SceneFormats::standard();
    let write = |scene: &Scene| formats.write(scene, &Moment::Start);
    for id in lessons() {
        let draft = Draft::read(&Embedded, &id).expect("the course is readable");
        let read = |draft: &Draft, name: &str| {
            draft
                .scene(name, (&id, &Embedded), formats)
                .expect("a scene")
        };
        for (_, name) in draft.scenes() {
            let old = read(&draft, &name);
            let mut new = (*old).clone();
            let document = new.document_mut();
            let handle = document.handles()[0];
            let at = document.position(handle).expect("it lies somewhere");
            let moved = document.drag(handle, at.map(|x| x + 0.015_625));
            moved.expect("a little");
            let written = draft.with_scene(&name, [&write(&old), &write(&new)], |it| {
                *read(it, &name) == new
            });
            let written = written.expect("the scene is there");
            assert_eq!(*read(&written, &name), new, "{id}: {name}");
            assert_eq!(
                draft
                    .with_scene(&name, [&write(&new), &write(&new)], |_| true)
                    .as_ref(),
                Some(&draft)
            );
        }
    }
    let draft =
        Draft::read(&lesson(&[("window = ", "# as ever\nwindow = ")]), "01-a").expect("a lesson");
    let old = "window = [-1, -1, 1, 1]\n";
    let wider = draft.with_scene("practice", [old, "window = [-2, -1, 1, 1]\n"], |_| true);
    let toml = wider
        .expect("a scene")
        .files()
        .next()
        .map(|(_, toml)| toml.to_owned());
    assert_eq!(
        toml,
        Some(LESSON.replace("window = [-1", "# as ever\nwindow = [-2"))
    );
}

#[test]
fn a_lesson_begins_with_a_scene() {
    let course = Course::embedded();
    for lesson in &course.lessons {
        let scene = SceneFormats::standard().write(&lesson.steps[0].scene, &Moment::Start);
        let step = NewStep {
            id: "first".to_owned(),
            scene: "scene".to_owned(),
            at: "start".to_owned(),
            texts: BTreeMap::from([(Lang::En, ["A \"title\"".to_owned(), "Text".to_owned()])]),
        };
        let titles = BTreeMap::from([(Lang::En, "Mine".to_owned()), (Lang::Es, "Mía".to_owned())]);
        let draft = Draft::begun([lesson.lab, "me, \"now\"", &scene], titles, &step);
        let loaded = Course::check(&draft.over("a", &Memory::new()));
        let [made] = &loaded.course.lessons[..] else {
            panic!("{:?}", loaded.problems);
        };
        assert_eq!(made.steps[0].scene, lesson.steps[0].scene);
        assert_eq!(
            [Lang::En, Lang::Es].map(|lang| made.title(lang)),
            ["Mine", "Mía"]
        );
        let other = draft.with_source("nobody").expect("a source");
        assert_eq!(other.source(), "nobody");
    }
}
