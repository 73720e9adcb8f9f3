//! `lesson.toml`: scenes by name, and the steps that show them.

use std::{
    collections::BTreeMap,
    sync::{Arc, OnceLock},
};

use toml::{Spanned, de::DeString};

use crate::{
    figure::{Moment, Run},
    labs::{Lab, Scene},
};

use super::{
    asking::{self, Goal},
    course::Lesson,
    grips::{drags_in, locks},
    likeness,
    names::{Names, is_figure_name, is_kebab},
    prelude::*,
    reference::{Scenes, WrittenText},
    scene_file::{SceneFormat, SceneFormats},
    step::{CodeView, LessonStep},
    stop::{Stop, moment, never_comes},
    toml_errors::with_toml,
    toml_fields::{Node, TomlFields},
    translation::Translation,
};

const LESSON_FIELDS: [&str; 4] = ["lab", "source", "scenes", "step"];
const STEP_FIELDS: [&str; 14] = [
    "id", "was", "scene", "at", "figure", "drawn", "before", "lock", "drag", "code", "ask", "goal",
    "reached", "hint",
];

/// Nobody reads a longer lesson.
const MAX_STEPS: usize = 1_000;

/// A lesson without its texts.
pub(super) struct Skeleton {
    /// The steps' ids, in order; `None` where one of them is not known for sure.
    pub ids: Option<Vec<String>>,
    /// What its texts can lead to; `None` where its lab is not known.
    pub controls: Option<Vec<&'static str>>,
    /// `None` where there is a mistake.
    pub body: Option<Body>,
    /// The scenes that no step shows, each with what is to be said of it where no text speaks of it either.
    pub unshown: Vec<(String, Problem)>,
}

/// What a lesson shows.
pub(super) struct Body {
    lab: &'static str,
    source: String,
    pub steps: Vec<LessonStep>,
    pub scenes: Scenes,
}

impl Skeleton {
    pub fn into_lesson(
        self,
        id: &str,
        english: WrittenText,
        translations: BTreeMap<Lang, Translation>,
    ) -> Option<Lesson> {
        let body = self.body?;
        Some(Lesson {
            id: id.to_owned(),
            lab: body.lab,
            source: body.source,
            steps: body.steps,
            scenes: body.scenes,
            english,
            translations,
        })
    }
}

/// When the moments of steps are looked for, which takes a recorded run for each scene.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Moments {
    Now,
    Later,
}

#[derive(Clone, Copy)]
pub(super) struct Reading {
    pub formats: SceneFormats,
    pub moments: Moments,
}

pub(super) fn read(Reading { formats, moments }: Reading, sink: &Sink<'_>) -> Option<Skeleton> {
    with_toml(sink, |table, sink| {
        let fields = TomlFields::new(table, 0..0, &LESSON_FIELDS, sink);
        let format = fields.require("lab").and_then(|node| {
            let known = formats.lab_ids();
            node.one_of(&known, "problem-unknown-lab", |name| formats.of(name))
        });
        let source = fields.require("source").and_then(Node::text);
        let mut reader = Steps {
            lab: format.map(|format| format.lab),
            scenes: scenes(format, moments, &fields),
            ids: Names::default(),
            figures: Names::default(),
            current: Current::None,
        };
        let (ids, steps) = reader.read(&fields);
        let unshown = reader.scenes.iter().filter(|(_, scene)| !scene.is_used);
        let unshown = unshown.map(|(name, scene)| {
            let place = Some(sink.source.place(scene.span.clone()));
            let what = Message::new("problem-unused-scene").into();
            let (file, severity) = (sink.source.file.clone(), Severity::Warning);
            (
                name.clone(),
                Problem {
                    file,
                    place,
                    severity,
                    what,
                },
            )
        });
        let unshown = unshown.collect();
        let complete = sink.n_errors() == 0;
        let named = reader.scenes.into_iter();
        let scenes = named.filter_map(|(name, named)| Some((name, named.scene?)));
        let body = || {
            Some(Body {
                lab: format?.lab.id,
                source: source?.to_owned(),
                steps: steps?,
                scenes: scenes.collect(),
            })
        };
        Some(Skeleton {
            ids,
            controls: format.map(|format| (format.lab.controls)()),
            unshown,
            body: body().filter(|_| complete),
        })
    })
}

/// One scene by its name, whatever is wrong with the others and the steps.
pub(super) fn scene(formats: SceneFormats, name: &str, sink: &Sink<'_>) -> Option<Arc<Scene>> {
    with_toml(sink, |table, sink| {
        let fields = TomlFields::new(table, 0..0, &LESSON_FIELDS, sink);
        let format = formats.of(fields.get("lab")?.text()?)?;
        let mut all = scenes(Some(format), Moments::Later, &fields);
        all.remove(name)?.scene
    })
}

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
    format: Option<&SceneFormat>,
    moments: Moments,
    fields: &TomlFields<'_>,
) -> BTreeMap<String, NamedScene> {
    let mut room = format.map_or(0, |format| format.room);
    let named = fields.get("scenes").and_then(Node::named);
    let all = fields.get("scenes").and_then(Node::table);
    let read = |(key, node): (&Spanned<DeString<'_>>, Node<'_>)| {
        let scene = format.zip(all).and_then(|(format, all)| {
            let table = likeness::fields(all, key.get_ref(), node)?;
            let fields = TomlFields::new(&table, node.span(), format.fields, node.sink);
            (format.read)(&fields, &mut room)
        });
        let recorded = scene.as_ref().filter(|_| moments == Moments::Now);
        let scene = NamedScene {
            span: key.span(),
            run: recorded.and_then(|scene| scene.document().record().into_iter().next()),
            scene: scene.map(Arc::new),
            is_used: false,
        };
        (key.get_ref().to_string(), scene)
    };
    named.into_iter().flatten().map(read).collect()
}

/// The scene that a step without one keeps.
enum Current {
    None,
    /// Named, but not there or not valid: reported already.
    Broken,
    Scene(String),
}

struct Steps {
    lab: Option<&'static Lab>,
    scenes: BTreeMap<String, NamedScene>,
    ids: Names,
    figures: Names,
    current: Current,
}

impl Steps {
    /// The ids where all are known, and the steps where all are valid.
    fn read(&mut self, fields: &TomlFields<'_>) -> (Option<Vec<String>>, Option<Vec<LessonStep>>) {
        let nodes: Vec<Node<'_>> = match fields.get("step") {
            Some(node) => match node.list("expect-steps") {
                Some(nodes) => nodes.collect(),
                None => return (None, None),
            },
            None if fields.is_misspelt("step") => return (None, None),
            None => Vec::new(),
        };
        if nodes.is_empty() {
            let (message, expected) = ("problem-no-steps", Message::new("expect-steps"));
            let span = fields.span.clone();
            fields.sink.error(span, Message::new(message), [expected]);
            return (None, None);
        }
        if let Some(node) = nodes.get(MAX_STEPS) {
            let message = Message::new("problem-too-many-steps").with("count", nodes.len());
            node.error(message.with("limit", MAX_STEPS), []);
            return (None, None);
        }
        let read = nodes.into_iter().map(|node| self.step(node));
        let (ids, steps): (Vec<_>, Vec<_>) = read.unzip();
        (ids.into_iter().collect(), steps.into_iter().collect())
    }

    fn step(&mut self, node: Node<'_>) -> (Option<String>, Option<LessonStep>) {
        const ID: [&str; 3] = [
            "problem-bad-step-id",
            "expect-kebab",
            "problem-duplicate-step",
        ];
        const FIGURE: [&str; 3] = [
            "problem-bad-figure",
            "expect-figure",
            "problem-duplicate-figure",
        ];
        let Some(fields) = node.fields(&STEP_FIELDS) else {
            return (None, None);
        };
        let id = fields.require("id");
        let id = id.and_then(|node| self.ids.take(node, is_kebab, ID));
        let was = fields.get("was").and_then(Node::text);
        self.choose_scene(&fields);
        let stop = self.stop(&fields);
        let [drawn, before] = ["drawn", "before"].map(|name| self.other(fields.get(name)?));
        let figure = fields.get("figure");
        let figure = figure.and_then(|node| self.figures.take(node, is_figure_name, FIGURE));
        let locks = fields.get("lock").map(|node| locks(self.lab, node));
        let drags = fields.get("drag").zip(stop.as_ref());
        let drags = drags.map(|(node, stop)| drags_in(&stop.scene, node));
        let code = fields.get("code");
        let code = code.and_then(|node| node.value(CodeView::ALL, CodeView::id));
        let asks = fields.get("ask").and_then(|node| {
            let run = stop.as_ref().and_then(|_| self.run());
            let position = stop.as_ref().and_then(|stop| *stop.found.get()?);
            asking::asks(node, run.zip(position))
        });
        let goal = self.goal(&fields, stop.as_ref());
        let step = id.clone().zip(stop);
        let step = step.map(|(id, stop)| LessonStep {
            id,
            was: was.map(str::to_owned),
            stop,
            figure,
            drawn,
            before,
            locks: locks.unwrap_or_default(),
            drags: drags.unwrap_or_default(),
            code: code.unwrap_or_default(),
            asks,
            goal,
        });
        (id, step)
    }

    fn goal(&mut self, fields: &TomlFields<'_>, stop: Option<&Stop>) -> Option<Goal> {
        let node = fields.get("goal")?;
        let conditions = asking::conditions(node);
        let reached = self.named(fields.require("reached")?)?;
        let reached = self.scenes.get(&reached)?.scene.clone()?;
        let run = stop.and_then(|_| self.run());
        let hint = |node: Node<'_>| {
            let hint = moment(node)?;
            if let Some(run) = run.filter(|run| run.find(&hint).is_none()) {
                node.error(never_comes(&hint, run), []);
            }
            Some(hint)
        };
        let hints = fields.get("hint").and_then(|it| it.list("expect-moments"));
        let goal = Goal {
            conditions: conditions?,
            reached,
            hints: hints.into_iter().flatten().filter_map(hint).collect(),
        };
        if let Some(stop) = stop.filter(|_| run.is_some()) {
            goal.check(node, &stop.scene);
        }
        Some(goal)
    }

    /// The run of the scene that is shown, where moments are looked for now.
    fn run(&self) -> Option<&dyn Run> {
        let Current::Scene(name) = &self.current else {
            return None;
        };
        self.scenes.get(name)?.run.as_deref()
    }

    fn choose_scene(&mut self, fields: &TomlFields<'_>) {
        let Some(node) = fields.get("scene") else {
            if matches!(self.current, Current::None) {
                if !fields.is_misspelt("scene") {
                    fields.missing("scene", [Message::new("expect-first-scene")]);
                }
                self.current = Current::Broken;
            }
            return;
        };
        self.current = self.named(node).map_or(Current::Broken, Current::Scene);
    }

    /// The name of one of the lesson's scenes, which is used by it.
    fn named(&mut self, node: Node<'_>) -> Option<String> {
        let known: Vec<&str> = self.scenes.keys().map(String::as_str).collect();
        let name = node.one_of(&known, "problem-unknown-scene", |name| {
            known.contains(&name).then(|| name.to_owned())
        })?;
        if let Some(scene) = self.scenes.get_mut(&name) {
            scene.is_used = true;
        }
        Some(name)
    }

    /// A stop that is not the one that the step begins with.
    fn other(&mut self, node: Node<'_>) -> Option<Stop> {
        let fields = node.fields(&["scene", "at"])?;
        let name = match (fields.get("scene"), &self.current) {
            (Some(node), _) => self.named(node)?,
            (None, Current::Scene(name)) => name.clone(),
            (None, Current::None | Current::Broken) => return None,
        };
        self.stop_in(&name, &fields)
    }

    fn stop(&self, fields: &TomlFields<'_>) -> Option<Stop> {
        let Current::Scene(name) = &self.current else {
            // The moment is read for its mistakes.
            fields.get("at").and_then(moment);
            return None;
        };
        self.stop_in(name, fields)
    }

    /// A scene, and where in its run the lesson stops.
    fn stop_in(&self, name: &str, fields: &TomlFields<'_>) -> Option<Stop> {
        let at = fields.get("at");
        let moment = at.map_or(Some(Moment::Start), moment);
        let NamedScene { scene, run, .. } = self.scenes.get(name)?;
        let (scene, moment) = (Arc::clone(scene.as_ref()?), moment?);
        let source = fields.sink.source;
        let stop = Stop {
            scene,
            moment,
            file: source.file.clone(),
            place: at.map(|node| source.place(node.span())),
            found: OnceLock::new(),
        };
        if let Some(run) = run {
            let position = run.find(&stop.moment);
            if let (None, Some(node)) = (position, at) {
                node.error(never_comes(&stop.moment, &**run), []);
            }
            stop.found.set(Some(position?)).ok();
        }
        Some(stop)
    }
}
