//! The reader's own scenes: each lab has one without a name, and as many with a name as are made.

use std::{collections::BTreeSet, iter};

use super::{
    App, Command, Dialog,
    bookmark::FreeScene,
    desk::{Page, SceneAct, Work},
    history::History,
    prelude::*,
};

impl App {
    /// The free scenes of the open lab: the one without a name, and the others by their names.
    pub(super) fn free_scenes(&self) -> Vec<Page> {
        let lab = self.scene().document().lab();
        let is_named = |page: &Page| matches!(page, Page::Named(of, _) if of == lab.id);
        let pages = self.desk.works.keys().cloned().chain(self.bookmark.page());
        let named: BTreeSet<Page> = pages.filter(is_named).collect();
        iter::once(FreeScene::of(lab).page()).chain(named).collect()
    }

    /// The free scene that is open, if it is one, by its name; the one without is called that.
    pub(super) fn scene_name(&self) -> Option<String> {
        let free = self.bookmark.free.as_ref()?;
        let unnamed = || self.catalog().term("free-title");
        Some(free.name.clone().unwrap_or_else(unnamed))
    }

    pub(super) fn next_free(&mut self, forward: bool) {
        let all = self.free_scenes();
        let open = self.bookmark.page();
        let open = open.and_then(|open| all.iter().position(|page| *page == open));
        let by = if forward { 1 } else { all.len() - 1 };
        self.open_page(&all[open.map_or(0, |open| (open + by) % all.len())]);
    }

    pub(super) fn can(&self, act: SceneAct) -> bool {
        let free = self.bookmark.free.as_ref();
        match act {
            SceneAct::New | SceneAct::Copy => true,
            SceneAct::Rename => free.is_some(),
            SceneAct::Delete => free.is_some_and(|free| free.name.is_some()),
        }
    }

    pub(super) fn ask_about_scene(&mut self, act: SceneAct) {
        if !self.can(act) {
            return;
        }
        let name = match act {
            SceneAct::New | SceneAct::Copy => {
                let numbered = |n: usize| {
                    let message = Message::new("scene-numbered").with("n", n);
                    self.catalog().message(&message)
                };
                let numbers = 2..=self.free_scenes().len() + 1;
                numbers
                    .map(numbered)
                    .find(|name| self.takes_name(act, name))
            }
            SceneAct::Rename | SceneAct::Delete => self.scene_name(),
        };
        self.shown.dialog = Some(Dialog::Scene(act, name.unwrap_or_default()));
    }

    /// Can this be done with this name? Two scenes of a lab have two names.
    pub(super) fn takes_name(&self, act: SceneAct, name: &str) -> bool {
        let mut all = self.free_scenes().into_iter();
        let known = all.find(|page| page.name() == Some(name.trim()));
        match act {
            SceneAct::New | SceneAct::Copy => known.is_none(),
            SceneAct::Rename => known.is_none() || known == self.bookmark.page(),
            SceneAct::Delete => true,
        }
    }

    /// Does what the open dialog is about.
    pub(super) fn act_on_scene(&mut self, act: SceneAct, name: &str) {
        if name.trim().is_empty() || !self.takes_name(act, name) {
            self.shown.dialog = Some(Dialog::Scene(act, name.to_owned()));
            return;
        }
        let lab = self.scene().document().lab();
        let name = Some(name.trim().to_owned());
        let free = FreeScene { lab, name };
        match act {
            SceneAct::New => self.make_scene(&free, (lab.smallest_scene)(), 0),
            SceneAct::Copy => self.make_scene(&free, self.scene().clone(), self.position()),
            SceneAct::Rename => {
                self.bookmark.free = Some(free);
                self.note_place();
            }
            SceneAct::Delete => {
                let deleted = self.bookmark.page();
                self.open_page(&FreeScene::of(lab).page());
                self.desk
                    .works
                    .retain(|page, _| Some(page) != deleted.as_ref());
            }
        }
    }

    fn make_scene(&mut self, free: &FreeScene, scene: Scene, position: usize) {
        let work = Work::new(History::new(scene), position, true);
        self.desk.works.insert(free.page(), work);
        self.open_page(&free.page());
    }
}

/// The lab's free scenes, and what can be done about them.
pub fn menu(app: &App, ui: &mut Ui) {
    let look = app.look();
    let open = app.bookmark.page();
    for page in app.free_scenes() {
        let name = page
            .name()
            .map_or_else(|| look.say("free-title"), str::to_owned);
        if ui.radio(open.as_ref() == Some(&page), name).clicked() {
            app.push(Command::OpenPage(page));
            ui.close();
        }
    }
    ui.separator();
    for (act, keys) in SceneAct::ALL {
        let keys = RichText::new(keys).color(look.theme.soft);
        let row = Button::new(look.say(act.key())).right_text(keys);
        if ui.add_enabled(app.can(act), row).clicked() {
            app.push(Command::AskAboutScene(act));
        }
    }
}
