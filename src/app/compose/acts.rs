//! What can be done to a lesson that is made, and how it is done.

use crate::{
    lesson::{Draft, Goal, NewStep},
    text::{Catalog, as_markdown},
};

use super::{
    super::{App, Dialog, dialog::Target, prelude::*},
    AT, Kind, Version,
};

#[derive(Clone, Debug)]
pub enum Act {
    /// Makes the open lesson, or no more.
    Compose,
    /// Asks for a folder to be the open scene's or lesson's own.
    Save,
    /// Tries it as a student, or no more.
    Try,
    /// A step where the run stands, after the one with this index; after the open one.
    Add(Option<usize>),
    Delete(usize),
    Move(usize, isize),
    /// The open step has a scene of its own from now on.
    OwnScene,
    Lesson(String),
    Source(String),
    Lang(Lang),
    Title(String),
    Body(String),
    Name(String),
    /// A field of the open step, as TOML spells it, or none.
    Set(&'static str, Option<String>),
    /// Locks a group of handles, or no more.
    Lock(&'static str),
    /// The same of the handle that has the focus.
    LockFocused,
    /// The scene as it stands is to be reached, or nothing is.
    Goal(bool),
    /// One of what could be asked of it, or no more.
    Condition(String),
    /// Of files that another program has changed: theirs stay, or ours.
    Settle(bool),
}

impl App {
    pub(in super::super) fn act_on_lesson(&mut self, ctx: &Context, act: Act, now: f64) {
        match act {
            Act::Compose if self.compose.is_some() => self.end_composing(now),
            Act::Compose => self.begin_composing(now),
            Act::Save => {
                let path = self.platform.suggest("my-lesson");
                self.ask(ctx, Dialog::Lesson(Target::new(path)));
            }
            Act::Try => self.try_lesson(),
            act if self.composed().is_some() => self.act_on_step(act, now),
            _ => {}
        }
    }

    fn act_on_step(&mut self, act: Act, now: f64) {
        let lang = self.compose.as_ref().map_or(Lang::En, |it| it.lang);
        match act {
            Act::Add(after) => self.add_step(after, now),
            Act::Delete(nth) => self.delete_step(nth, now),
            Act::Move(nth, by) => self.move_step(nth, by, now),
            Act::OwnScene => self.own_scene(now),
            Act::Lesson(title) => {
                self.write_in(Kind::Lesson, now, |draft, _| {
                    draft.with_title("", lang, &title)
                });
            }
            Act::Source(source) => {
                self.write_in(Kind::Lesson, now, |draft, _| draft.with_source(&source));
            }
            Act::Lang(lang) => {
                if let Some(compose) = &mut self.compose {
                    compose.lang = lang;
                }
            }
            Act::Title(title) => {
                self.write_in(Kind::Title, now, |draft, id| {
                    draft.with_title(id, lang, &title)
                });
            }
            Act::Body(body) => {
                self.write_in(Kind::Body, now, |draft, id| {
                    draft.with_body(id, lang, &body)
                });
            }
            Act::Settle(takes_theirs) => self.settle_outside(takes_theirs, now),
            act => self.set_field(act, now),
        }
    }

    fn set_field(&mut self, act: Act, now: f64) {
        match act {
            Act::Name(name) => {
                let is_done = self.compose(Kind::Once, now, |draft, id| draft.with_id(id, &name));
                if is_done {
                    self.open_composed(&name);
                }
            }
            Act::Lock(group) => self.write_in(Kind::Once, now, |draft, id| {
                draft.with_list(id, "lock", &toggled(draft.list(id, "lock"), group))
            }),
            Act::LockFocused => {
                let lab = self.scene().document().lab();
                let group = self.stage.focused.map(Handle::group);
                if let Some(group) = group.filter(|group| Lock::of(lab, group).is_some()) {
                    self.set_field(Act::Lock(group), now);
                }
            }
            Act::Set(key, value) => self.write_in(Kind::Once, now, |draft, id| {
                draft.with_field(id, key, value.as_deref())
            }),
            Act::Goal(is_set) => self.set_goal(is_set, now),
            Act::Condition(part) => self.write_in(Kind::Once, now, |draft, id| {
                draft.with_goal(id, &toggled(draft.list(id, "goal"), &part))
            }),
            _ => {}
        }
    }

    fn write_in(
        &mut self,
        kind: Kind,
        now: f64,
        change: impl FnOnce(&Draft, &str) -> Option<Draft>,
    ) {
        self.compose(kind, now, change);
    }

    /// May steps come and go? What the list shows is the last good version.
    fn is_whole(&mut self, now: f64) -> bool {
        self.check_composed();
        let is_whole = self
            .compose
            .as_ref()
            .is_some_and(|it| it.problems.is_empty());
        if !is_whole {
            self.tell(&Message::new("compose-mend-first"), now);
        }
        is_whole
    }

    fn id_at(&self, nth: usize) -> Option<String> {
        let steps = &self.bookmark.lesson()?.steps;
        Some(steps.get(nth)?.id.clone())
    }

    fn add_step(&mut self, after: Option<usize>, now: f64) {
        let Some(draft) = self.compose.as_ref().map(|it| it.draft().clone()) else {
            return;
        };
        let open = self.open_id();
        let after = after.and_then(|nth| self.id_at(nth));
        let after = after.unwrap_or_else(|| open.clone());
        let step = self.step_here(&draft, draft.scene_of(&open).unwrap_or_default());
        // Whoever has stepped on to where the new one stands has not moved the open one.
        let left = self.compose.as_mut().and_then(|it| it.left.take());
        let left = left.filter(|(id, _)| *id == open);
        self.change_steps([&step.id; 2], now, |draft| {
            let draft = match &left {
                Some((id, at)) => draft.with_field(id, AT, at.as_deref())?,
                None => draft.clone(),
            };
            draft.with_step(Some(&after), &step)
        });
    }

    /// Changes which steps there are: this one, and this one is open afterwards.
    fn change_steps(
        &mut self,
        [id, next]: [&str; 2],
        now: f64,
        change: impl FnOnce(&Draft) -> Option<Draft>,
    ) {
        if !self.is_whole(now) || !self.compose(Kind::Once, now, |draft, _| change(draft)) {
            return;
        }
        if let Some(compose) = &mut self.compose {
            // Undone and done again, it is the one to be shown.
            let named = |version: &mut Version| id.clone_into(&mut version.step);
            compose.history.amend(named);
        }
        self.open_composed(next);
    }

    /// A step that shows where the run stands, and says the sentence that is said there.
    pub(super) fn step_here(&self, draft: &Draft, scene: String) -> NewStep {
        let (run, position) = (self.playback.main(), self.position());
        let at = run.shortest_moment(position.min(run.n_steps())).to_string();
        let caption = run.caption(position.min(run.n_steps()));
        let text = |lang| {
            let catalog = Catalog::of(lang);
            let said = caption_text(catalog, &caption);
            // A brace would begin a reference.
            let said = as_markdown(&said.replace(['{', '}'], ""));
            (lang, [catalog.term("compose-new-title"), said])
        };
        let stem: Vec<&str> = at
            .split(|c: char| !c.is_ascii_alphanumeric())
            .filter(|it| !it.is_empty())
            .collect();
        NewStep {
            id: draft.fresh(&stem.join("-").to_ascii_lowercase()),
            scene,
            at,
            texts: Lang::ALL.map(text).into(),
        }
    }

    fn delete_step(&mut self, nth: usize, now: f64) {
        let open = self.open_id();
        let beside = [nth.checked_add(1), nth.checked_sub(1)];
        let next = beside.into_iter().flatten().find_map(|nth| self.id_at(nth));
        if let Some((id, next)) = self.id_at(nth).zip(next) {
            let next = if id == open { next } else { open };
            self.change_steps([&id, &next], now, |draft| draft.without_step(&id));
        }
    }

    fn move_step(&mut self, nth: usize, by: isize, now: f64) {
        let to = nth
            .checked_add_signed(by)
            .filter(|&to| self.id_at(to).is_some());
        if let Some((id, to)) = self.id_at(nth).zip(to) {
            self.change_steps([&id; 2], now, |draft| draft.with_moved(&id, to));
        }
    }

    fn own_scene(&mut self, now: f64) {
        let scene = self.history.now().clone();
        let written = self.kit.formats.write(&scene, &Moment::Start);
        let method = scene
            .document()
            .methods()
            .first()
            .map_or("", |card| card.id);
        self.compose(Kind::Once, now, |draft, id| {
            draft.with_own_scene(id, &draft.fresh(method), &written)
        });
    }

    fn set_goal(&mut self, is_set: bool, now: f64) {
        let scene = self.history.now().clone();
        let written = self.kit.formats.write(&scene, &Moment::Start);
        let offered = Goal::offered(&scene);
        self.write_in(Kind::Once, now, |draft, id| {
            if is_set {
                // Where students begin is dragged anew, and no other step is to follow.
                let own = draft.shares_scene(id).then(|| draft.fresh(id));
                let own = own.and_then(|name| draft.with_own_scene(id, &name, &written));
                let draft = own.as_ref().unwrap_or(draft);
                draft.with_reached(id, offered.get(..1)?, &written)
            } else {
                draft.with_goal(id, &[])
            }
        });
    }
}

/// With an entry of a list, or without it.
fn toggled(mut entries: Vec<String>, entry: &str) -> Vec<String> {
    let n = entries.len();
    entries.retain(|known| known != entry);
    if entries.len() == n {
        entries.push(entry.to_owned());
    }
    entries
}
