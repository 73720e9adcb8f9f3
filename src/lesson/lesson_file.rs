//! `lesson.toml`: scenes by name, and the steps that show them.

use std::{collections::BTreeMap, ops::Range, sync::Arc};

use crate::{
    figure::{Moment, Run},
    labs::{Lab, Lock, Scene},
    text::{Lang, Message},
};

use super::{
    course::{Lesson, LessonText},
    scene_file::{SceneFormat, SceneFormats},
    sink::{Sink, clipped},
    step::{CodeView, LessonStep, Stop, moment, never_comes},
    toml_errors::with_toml,
    toml_fields::{Item, TomlFields, list, named, one_of, text},
};

const LESSON_FIELDS: [&str; 4] = ["lab", "source", "scenes", "step"];
const STEP_FIELDS: [&str; 6] = ["id", "scene", "at", "figure", "lock", "code"];

/// A lesson without its texts.
pub(super) struct Skeleton {
    /// The steps' ids, in order; `None` where one of them is not known for sure.
    pub ids: Option<Vec<String>>,
    /// `None` where there is a mistake.
    lesson: Option<(&'static str, String, Vec<LessonStep>)>,
}

impl Skeleton {
    /// Adds the texts; `None` where something is missing.
    pub fn into_lesson(self, id: &str, mut texts: BTreeMap<Lang, LessonText>) -> Option<Lesson> {
        let (lab, source, steps) = self.lesson?;
        Some(Lesson {
            id: id.to_owned(),
            lab,
            source,
            steps,
            english: texts.remove(&Lang::En)?,
            translations: texts,
        })
    }
}

/// When the moments of steps are looked for, which takes a recorded run for each scene.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Moments {
    /// While the file is read: one that never comes is among its mistakes.
    Now,
    /// When they are needed.
    Later,
}

/// How a `lesson.toml` is read.
#[derive(Clone, Copy)]
pub(super) struct Reading {
    pub formats: SceneFormats,
    pub moments: Moments,
}

/// Reads a `lesson.toml`, reporting all its mistakes.
pub(super) fn read(Reading { formats, moments }: Reading, sink: &mut Sink<'_>) -> Option<Skeleton> {
    with_toml(sink, |table, sink| {
        let fields = TomlFields::of_file(table, &LESSON_FIELDS, sink);
        let format = fields.require("lab", sink).and_then(|item| {
            let known = formats.lab_ids();
            one_of(item, &known, "problem-unknown-lab", sink, |name| {
                formats.of(name)
            })
        });
        let source = fields
            .require("source", sink)
            .and_then(|item| text(item, sink));
        let mut reader = Steps {
            lab: format.map(SceneFormat::lab),
            scenes: scenes(format, moments, &fields, sink),
            ids: Names::default(),
            figures: Names::default(),
            current: Current::None,
        };
        let (ids, steps) = reader.read(&fields, sink);
        for scene in reader.scenes.values().filter(|scene| !scene.is_used) {
            sink.warning(scene.span.clone(), Message::new("problem-unused-scene"), []);
        }
        let complete = sink.n_errors() == 0;
        Some(Skeleton {
            ids,
            lesson: (|| Some((format?.lab().id(), source?.to_owned(), steps?)))()
                .filter(|_| complete),
        })
    })
}

/// A scene of the lesson.
struct NamedScene {
    span: Range<usize>,
    /// `None` where it has a mistake.
    scene: Option<Arc<Scene>>,
    /// Its first method's, where moments are looked for now.
    run: Option<Box<dyn Run>>,
    is_used: bool,
}

/// Scenes of an unknown lab have names, but cannot be read.
fn scenes(
    format: Option<&dyn SceneFormat>,
    moments: Moments,
    fields: &TomlFields<'_>,
    sink: &mut Sink<'_>,
) -> BTreeMap<String, NamedScene> {
    let mut room = format.map_or(0, SceneFormat::room);
    let mut scenes = BTreeMap::new();
    let Some(table) = fields.get("scenes").and_then(|item| named(item, sink)) else {
        return scenes;
    };
    for (key, item) in table {
        let scene = format.and_then(|format| {
            let fields = TomlFields::of(item, format.fields(), sink)?;
            format.read(&fields, &mut room, sink)
        });
        let is_recorded = moments == Moments::Now;
        let recorded = scene.as_ref().filter(|_| is_recorded);
        let scene = NamedScene {
            span: key.span(),
            run: recorded.and_then(|scene| scene.document().record().into_iter().next()),
            scene: scene.map(Arc::new),
            is_used: false,
        };
        scenes.insert(key.get_ref().to_string(), scene);
    }
    scenes
}

/// Names that must not come twice, and the line of each.
#[derive(Default)]
struct Names(BTreeMap<String, usize>);

impl Names {
    /// Takes a well-formed name that is new.
    fn take(
        &mut self,
        item: &Item<'_>,
        is_valid: fn(&str) -> bool,
        [invalid, expect, duplicate]: [&'static str; 3],
        sink: &mut Sink<'_>,
    ) -> Option<String> {
        let name = text(item, sink)?;
        let about = |key| Message::new(key).with("name", clipped(name));
        if !is_valid(name) {
            sink.error(item.span(), about(invalid), [Message::new(expect)]);
            return None;
        }
        if let Some(line) = self.0.get(name) {
            let first = Message::new("expect-first-here").with("line", line.to_string());
            sink.error(item.span(), about(duplicate), [first]);
            return None;
        }
        let line = sink.source().line(item.span().start);
        self.0.insert(name.to_owned(), line);
        Some(name.to_owned())
    }
}

/// The scene that a step without one keeps.
enum Current {
    None,
    /// Named, but not there or not valid: reported already.
    Broken,
    Scene(String),
}

struct Steps {
    /// `None` where it is not known.
    lab: Option<&'static dyn Lab>,
    scenes: BTreeMap<String, NamedScene>,
    ids: Names,
    figures: Names,
    current: Current,
}

impl Steps {
    /// The ids where all are known, and the steps where all are valid.
    fn read(
        &mut self,
        fields: &TomlFields<'_>,
        sink: &mut Sink<'_>,
    ) -> (Option<Vec<String>>, Option<Vec<LessonStep>>) {
        let items = match fields.get("step") {
            Some(item) => match list(item, "expect-steps", sink) {
                Some(items) => items,
                None => return (None, None),
            },
            None if fields.is_misspelt("step") => return (None, None),
            None => &[],
        };
        if items.is_empty() {
            let expected = [Message::new("expect-steps")];
            sink.error(fields.span(), Message::new("problem-no-steps"), expected);
            return (None, None);
        }
        let (mut ids, mut steps) = (Some(Vec::new()), Some(Vec::new()));
        for item in items {
            let (id, step) = self.step(item, sink);
            ids = ids.zip(id).map(|(mut ids, id)| {
                ids.push(id);
                ids
            });
            steps = steps.zip(step).map(|(mut steps, step)| {
                steps.push(step);
                steps
            });
        }
        (ids, steps)
    }

    fn step(
        &mut self,
        item: &Item<'_>,
        sink: &mut Sink<'_>,
    ) -> (Option<String>, Option<LessonStep>) {
        let Some(fields) = TomlFields::of(item, &STEP_FIELDS, sink) else {
            return (None, None);
        };
        let id = fields.require("id", sink).and_then(|item| {
            let keys = [
                "problem-bad-step-id",
                "expect-kebab",
                "problem-duplicate-step",
            ];
            self.ids.take(item, is_kebab, keys, sink)
        });
        self.choose_scene(&fields, sink);
        let stop = self.stop(&fields, sink);
        let figure = fields.get("figure").and_then(|item| {
            let keys = [
                "problem-bad-figure",
                "expect-figure",
                "problem-duplicate-figure",
            ];
            self.figures.take(item, is_figure_name, keys, sink)
        });
        let locks = fields.get("lock").map(|item| locks(self.lab, item, sink));
        let code = fields.get("code").and_then(|item| {
            let known = CodeView::ALL.map(CodeView::id);
            one_of(item, &known, "problem-unknown-value", sink, |name| {
                CodeView::ALL.into_iter().find(|view| view.id() == name)
            })
        });
        let step = id
            .clone()
            .zip(stop)
            .map(|(id, (scene, moment, stop))| LessonStep {
                id,
                scene,
                moment,
                stop,
                figure,
                locks: locks.unwrap_or_default(),
                code: code.unwrap_or_default(),
            });
        (id, step)
    }

    fn choose_scene(&mut self, fields: &TomlFields<'_>, sink: &mut Sink<'_>) {
        let Some(item) = fields.get("scene") else {
            if matches!(self.current, Current::None) && !fields.is_misspelt("scene") {
                let message =
                    Message::new("problem-missing-field").with("name", "scene".to_owned());
                sink.error(fields.span(), message, [Message::new("expect-first-scene")]);
            }
            if matches!(self.current, Current::None) {
                self.current = Current::Broken;
            }
            return;
        };
        let known: Vec<&str> = self.scenes.keys().map(String::as_str).collect();
        let name = one_of(item, &known, "problem-unknown-scene", sink, |name| {
            known.contains(&name).then(|| name.to_owned())
        });
        self.current = name.map_or(Current::Broken, Current::Scene);
        if let Current::Scene(name) = &self.current
            && let Some(scene) = self.scenes.get_mut(name)
        {
            scene.is_used = true;
        }
    }

    /// The step's scene, and where in its run the lesson stops.
    fn stop(
        &self,
        fields: &TomlFields<'_>,
        sink: &mut Sink<'_>,
    ) -> Option<(Arc<Scene>, Moment, Stop)> {
        let at = fields.get("at");
        let moment = match at {
            None => Some(Moment::Start),
            Some(item) => moment(item, sink),
        };
        let Current::Scene(name) = &self.current else {
            return None;
        };
        let NamedScene { scene, run, .. } = self.scenes.get(name)?;
        let (scene, moment) = (Arc::clone(scene.as_ref()?), moment?);
        let stop = Stop {
            file: sink.source().file.clone(),
            place: at.map(|item| sink.source().place(item.span())),
            ..Stop::default()
        };
        if let Some(run) = run {
            let position = run.find(&moment);
            if let (None, Some(item)) = (position, at) {
                sink.refuse(item.span(), never_comes(&moment, &**run), []);
            }
            stop.found.set(Some(position?)).ok();
        }
        Some((scene, moment, stop))
    }
}

/// Those of an unknown lab cannot be known.
fn locks(lab: Option<&dyn Lab>, item: &Item<'_>, sink: &mut Sink<'_>) -> Vec<Lock> {
    let items = list(item, "expect-locks", sink).unwrap_or_default();
    let Some(lab) = lab else {
        return Vec::new();
    };
    items
        .iter()
        .filter_map(|item| {
            one_of(
                item,
                lab.lock_groups(),
                "problem-unknown-lock",
                sink,
                |name| Lock::of(lab, name),
            )
        })
        .collect()
}

fn is_kebab(id: &str) -> bool {
    is_figure_name(id) && id.split('-').all(|part| !part.is_empty())
}

/// Nothing that a path could be made of.
fn is_figure_name(name: &str) -> bool {
    name.len() <= 64
        && name
            .bytes()
            .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
}
