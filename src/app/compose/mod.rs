//! A lesson of one's own is made: its steps in a list, what the open one says and asks in the inspector's place. What is changed on the
//! stage is the scene of the open step from then on, and where its run stands is its moment. Every change is one to the lesson's
//! files ([`Draft`]); they are checked at once, or where text is written after a pause, and written then.

mod acts;
mod begin;
mod keys;
mod list;
mod panel;
#[cfg(not(target_arch = "wasm32"))]
mod save;
mod written;

use std::collections::BTreeMap;

use crate::{
    figure::Tick,
    lesson::{Draft, Files, Goal, Progress, quoted},
};

use super::{
    App,
    desk::{Page, Work},
    history::{History, UndoGroup},
    prelude::*,
};

pub use acts::Act;
pub use keys::keys;
#[cfg(test)]
pub use list::row_id;
pub use list::{add_here, show as steps, tried};
pub use panel::show as step;

/// Of each step its title and its moment.
type Rows = BTreeMap<String, [String; 2]>;

/// The lesson as it was, and the step that was changed last.
#[derive(Clone, PartialEq, Default)]
struct Version {
    draft: Draft,
    step: String,
}

pub struct Compose {
    lesson: String,
    files: Box<dyn Files>,
    history: History<Version>,
    /// What was read or written last.
    on_disk: Draft,
    /// What another program has made of the files meanwhile: nothing is written until it is decided whose stay.
    theirs: Option<Draft>,
    /// What is wrong with the files as they are now: the last good version stays open.
    pub(super) problems: Vec<Problem>,
    /// When what has changed is to be checked and written.
    due: Option<f64>,
    lang: Lang,
    /// What of the stage the open step has taken over: its id, the scene's revision, and where the run stood.
    taken: Option<(String, u64, usize)>,
    /// The open step's moment, as it was spelt before the run was stepped and nothing else was done: its id, and that.
    left: Option<(String, Option<String>)>,
    /// What the list says of each step, in which version and language.
    rows: (Option<(u64, Lang)>, Rows),
    /// Of each step of the last good version where its run stands, and the sign of that.
    stands: BTreeMap<String, (usize, Option<Tick>)>,
    /// What a goal could ask, of which step and in which version of the lesson.
    offered: (Option<(String, u64)>, Vec<String>),
    /// Work on the lesson's pages from before.
    works: BTreeMap<Page, Work>,
    /// It is tried as a student would: marks from before, which are no student's.
    tried: Option<Progress>,
}

/// What of a lesson is changed: changes of one kind follow each other within a second and are undone together.
#[derive(Clone, Copy)]
enum Kind {
    Once,
    Scene,
    Moment,
    Title,
    Body,
    Lesson,
}

impl Kind {
    const fn group(self) -> Option<UndoGroup> {
        match self {
            Self::Once => None,
            kind => Some(UndoGroup::Number(kind as usize)),
        }
    }

    /// Do others like it follow at once, so that it is checked after a pause?
    const fn waits(self) -> bool {
        !matches!(self, Self::Once)
    }
}

impl Compose {
    fn draft(&self) -> &Draft {
        &self.history.now().draft
    }

    /// Is there nothing to be written? Where nothing was changed files stay as they are, in whatever form.
    fn is_written(&self) -> bool {
        let is_changed = self.history.can_undo() || self.history.can_redo();
        !is_changed || *self.draft() == self.on_disk
    }

    fn is_saved(&self) -> bool {
        self.due.is_none() && self.theirs.is_none() && self.is_written()
    }
}

impl App {
    /// The lesson that is being made, where one of its steps is open and it is neither tried nor presented.
    pub(super) fn composed(&self) -> Option<&Compose> {
        let compose = self.compose.as_deref().filter(|it| it.tried.is_none())?;
        let is_shown = self.has_composed_open() && !self.is_presenting();
        is_shown.then_some(compose)
    }

    fn has_composed_open(&self) -> bool {
        let lesson = self.bookmark.step().and(self.bookmark.lesson());
        let compose = self.compose.as_ref();
        lesson
            .zip(compose)
            .is_some_and(|(lesson, compose)| lesson.id == compose.lesson)
    }

    /// Is the lesson that is being made tried as a student would?
    pub(super) fn tries_lesson(&self) -> bool {
        let is_tried = self.compose.as_ref().is_some_and(|it| it.tried.is_some());
        is_tried && self.has_composed_open()
    }

    /// The marks that are a student's: trying a lesson makes none.
    pub(super) fn marks(&self) -> &Progress {
        let tried = self.compose.as_ref().and_then(|it| it.tried.as_ref());
        tried.unwrap_or(&self.settings.progress)
    }

    /// Of the open step's scene the steps that show it: each one's number, and where its run stands.
    pub(super) fn steps_on_timeline(&self) -> Vec<(usize, usize)> {
        let lesson = self.composed().zip(self.bookmark.lesson());
        let Some(((compose, lesson), open)) = lesson.zip(self.bookmark.step()) else {
            return Vec::new();
        };
        let steps = lesson.steps.iter().enumerate();
        let shown = steps.filter(|(_, step)| step.scene == open.scene);
        let stands = shown.filter_map(|(i, step)| Some((i + 1, compose.stands.get(&step.id)?.0)));
        stands.collect()
    }

    /// Can a change be undone, and can one be done again?
    pub(super) fn can_travel(&self) -> [bool; 2] {
        let of_scene = [self.history.can_undo(), self.history.can_redo()];
        let history = self.composed().map(|compose| &compose.history);
        history.map_or(of_scene, |it| [it.can_undo(), it.can_redo()])
    }

    /// The id of the open step.
    fn open_id(&self) -> String {
        let step = self.bookmark.step();
        step.map(|step| step.id.clone()).unwrap_or_default()
    }

    /// Changes the lesson, where that can be done.
    fn compose(
        &mut self,
        kind: Kind,
        now: f64,
        change: impl FnOnce(&Draft, &str) -> Option<Draft>,
    ) -> bool {
        let id = self.open_id();
        let Some(compose) = &mut self.compose else {
            return false;
        };
        if !matches!(kind, Kind::Moment) {
            compose.left = None;
        }
        let Some(draft) = change(compose.draft(), &id) else {
            self.tell(&Message::new("compose-refused"), now);
            return false;
        };
        if draft == *compose.draft() {
            return false;
        }
        let size = draft.files().map(|(_, text)| text.len() / 100).sum();
        let changed: Result<_, std::convert::Infallible> =
            compose.history.edit(kind.group(), now, size, |version| {
                *version = Version { draft, step: id };
                Ok(())
            });
        compose.due = Some(now + PAUSE_SECS);
        if changed.is_ok() && !kind.waits() {
            self.check_composed();
        }
        true
    }

    /// One version back or on, and to the step that it is about.
    pub(super) fn undo_composed(&mut self, now: f64, is_back: bool) {
        let Some(compose) = &mut self.compose else {
            return;
        };
        let before = compose.history.now().step.clone();
        if is_back {
            compose.history.undo(0);
        } else {
            compose.history.redo(0);
        }
        let after = compose.history.now().step.clone();
        compose.due = Some(now + PAUSE_SECS);
        self.check_composed();
        let order = if is_back {
            [before, after]
        } else {
            [after, before]
        };
        let mut ids = order.into_iter();
        let is_there = |id: &String| {
            self.bookmark
                .lesson()
                .is_some_and(|it| it.step_index(id).is_some())
        };
        if let Some(id) = ids.find(is_there) {
            self.open_composed(&id);
        }
    }

    /// Opens a step as the lesson has it now.
    fn open_composed(&mut self, id: &str) {
        self.clear_composed_works();
        if let Some(compose) = &mut self.compose {
            (compose.taken, compose.left) = (None, None);
            let lesson = compose.lesson.clone();
            self.bookmark.open_ids(&lesson, id);
        }
        self.enter();
    }

    /// Nothing that was done on a page of the lesson stands beside the lesson itself.
    fn clear_composed_works(&mut self) -> BTreeMap<Page, Work> {
        let Some(compose) = &self.compose else {
            return BTreeMap::new();
        };
        let works = std::mem::take(&mut self.desk.works).into_iter();
        let is_its =
            |page: &Page| matches!(page, Page::Step(lesson, _) if *lesson == compose.lesson);
        let (own, others) = works.partition(|(page, _)| is_its(page));
        self.desk.works = others;
        own
    }

    /// Once a frame: takes over what was changed on the stage, and writes what has changed after a pause; seconds until then.
    pub(super) fn pass_composed(&mut self, ctx: &Context, now: f64) -> Option<f32> {
        if self.composed().is_some() {
            self.clear_composed_works();
            self.take_stage(ctx, now);
            self.offer_goal();
            self.list_rows();
        } else if let Some(compose) = &mut self.compose {
            // What is done on the stage of a student is not the lesson's.
            compose.taken = None;
        }
        let due = self.compose.as_ref()?.due?;
        if due > now {
            return Some((due - now) as f32);
        }
        self.check_composed();
        self.write_composed(false);
        None
    }

    /// Before another page is open the lesson is what was made of it on this one.
    pub(super) fn check_before_turning(&mut self) {
        if self.compose.as_ref().is_some_and(|it| it.due.is_some()) {
            self.check_composed();
        }
    }

    /// Reads what the list says, once a version.
    fn list_rows(&mut self) {
        let Some(compose) = &mut self.compose else {
            return;
        };
        let of = Some((compose.history.revision(), compose.lang));
        if compose.rows.0 != of {
            let draft = &compose.history.now().draft;
            let row = |id: String| {
                let [title, _] = draft.passage(&id, compose.lang);
                let at = draft.word_of(&id, AT);
                let at = at.unwrap_or_else(|| Moment::Start.to_string());
                (id, [title, at])
            };
            let rows = draft.ids().into_iter().map(row).collect();
            compose.rows = (of, rows);
        }
    }

    fn offer_goal(&mut self) {
        let (id, formats) = (self.open_id(), self.kit.formats);
        let Some(compose) = &mut self.compose else {
            return;
        };
        let of = Some((id.clone(), compose.history.revision()));
        if compose.offered.0 != of {
            let draft = &compose.history.now().draft;
            let reached = draft.word_of(&id, "reached");
            let files = (&*compose.lesson, &*compose.files);
            let reached = reached.and_then(|name| draft.scene(&name, files, formats));
            let offered = reached.map(|scene| Goal::offered(&scene));
            compose.offered = (of, offered.unwrap_or_default());
        }
    }

    /// Makes what stands on the stage the open step's.
    fn take_stage(&mut self, ctx: &Context, now: f64) {
        let is_held = ctx.input(|input| input.pointer.any_down());
        let is_moving =
            is_held || self.history.is_in_gesture() || self.playback.transport.is_playing();
        if is_moving || self.pending.is_some() || self.playback.is_late {
            return;
        }
        let stands = (self.open_id(), self.history.revision(), self.position());
        let Some(compose) = &mut self.compose else {
            return;
        };
        let before = compose.taken.replace(stands.clone());
        let Some((_, revision, position)) =
            before.filter(|before| before.0 == stands.0 && *before != stands)
        else {
            return;
        };
        if revision != stands.1 {
            self.take_scene(now);
            self.take_moment(Kind::Scene, now);
        } else if position != stands.2 {
            self.take_moment(Kind::Moment, now);
        }
    }

    fn take_scene(&mut self, now: f64) {
        let (scene, formats) = (self.history.now().clone(), self.kit.formats);
        let Some(compose) = &self.compose else {
            return;
        };
        let (lesson, draft) = (compose.lesson.clone(), compose.draft());
        let name = draft.scene_of(&self.open_id());
        let read = |draft: &Draft| draft.scene(name.as_ref()?, (&lesson, &*compose.files), formats);
        let old = read(draft);
        if old.as_deref() == Some(&scene) {
            return;
        }
        let [old, new] = [old.as_deref(), Some(&scene)]
            .map(|it| it.map_or(String::new(), |it| formats.write(it, &Moment::Start)));
        let changed = name.as_ref().and_then(|name| {
            draft.with_scene(name, [&old, &new], |draft| {
                read(draft).as_deref() == Some(&scene)
            })
        });
        self.compose(Kind::Scene, now, |_, _| changed);
    }

    fn take_moment(&mut self, kind: Kind, now: f64) {
        let (run, position) = (self.playback.main(), self.position());
        let position = position.min(run.n_steps());
        let moment = run.shortest_moment(position);
        let at = |draft: &Draft, id: &str| {
            draft
                .word_of(id, AT)
                .unwrap_or_else(|| Moment::Start.to_string())
        };
        let stands = |text: &str| run.find(&text.parse().ok()?);
        let id = self.open_id();
        let Some(compose) = &mut self.compose else {
            return;
        };
        if stands(&at(compose.draft(), &id)) == Some(position) {
            return;
        }
        if matches!(kind, Kind::Moment) && compose.left.as_ref().is_none_or(|it| it.0 != id) {
            let spelt = compose.draft().field(&id, AT).map(str::to_owned);
            compose.left = Some((id, spelt));
        }
        let spelt = (moment != Moment::Start).then(|| quoted(&moment.to_string()));
        self.compose(kind, now, |draft, id| {
            draft.with_field(id, AT, spelt.as_deref())
        });
    }
}

/// So long nothing is changed before it is written.
const PAUSE_SECS: f64 = 1.0;
/// The field of a step that says where its run stands.
const AT: &str = "at";
