//! From page to page: a step of the course, or a lab's free scene. What was done on one is there again when it is opened.

use crate::{
    labs::Difference,
    lesson::Block,
    widgets::{Album, Medium},
};

use super::{
    App,
    bookmark::{Bookmark, FreeScene},
    desk::{Page, Places, StoredWork, Work},
    history::{History, OnDisk},
    prelude::*,
    room::{CoursePart, Room},
};

/// Larger scenes than so many segments or vertices in all are not kept over a restart: they would be written
/// every half minute.
pub(super) const MOST_STORED: usize = 200_000;

impl App {
    /// Opens another page, where there is one; what was done on this one is put away.
    pub(super) fn turn_to(&mut self, open: impl FnOnce(&mut Bookmark) -> bool) {
        self.check_before_turning();
        let (page, is_changed) = (self.bookmark.page(), self.is_the_readers());
        let is_open = open(&mut self.bookmark);
        if !is_open || self.bookmark.page() == page {
            return;
        }
        let from = self
            .pending
            .as_ref()
            .and_then(|pending| pending.from.clone());
        let from = from.or_else(|| page.clone());
        let before = self.enter();
        if let Some(pending) = &mut self.pending {
            pending.from = from;
        }
        if let (Some(page), Some(work)) = (page, before)
            && (is_changed || work.history.can_undo() || work.history.can_redo())
        {
            self.desk.works.insert(page, Work { is_changed, ..work });
        }
    }

    /// Is the scene the reader's own, or changed by the reader?
    pub(super) fn is_the_readers(&self) -> bool {
        self.bookmark.free.is_some() || !self.is_untouched()
    }

    /// Shows the open page as it was left, else as it is at first; what was shown before.
    pub(super) fn enter(&mut self) -> Option<Work> {
        let is_there = |page: &Page| self.desk.works.contains_key(page);
        if let Some(free) = &mut self.bookmark.free
            && !is_there(&free.page())
        {
            // One with a name that was deleted, in another window say, is not made anew.
            free.name = None;
        }
        let page = self.bookmark.page();
        let work = page.as_ref().and_then(|page| self.desk.works.remove(page));
        let at_first = |(scene, position)| Work::new(History::new(scene), position, false);
        let work = work.or_else(|| self.own().map(at_first));
        let before = work.map(|work| self.show(work));
        (self.shown.lists_lessons, self.shown.is_answered) = (false, false);
        let step = self.bookmark.step();
        let code = step.map_or(CodeView::Full, |step| step.code);
        self.shown.code = if self.composed().is_some() {
            CodeView::Full
        } else {
            code
        };
        if let Some(problem) = step.and_then(LessonStep::problem) {
            self.complain(self.listing(&[problem]));
        }
        self.note_place();
        self.playback.transport.set_speed(self.settings.speed);
        self.ask_of_step(false);
        self.see_step();
        before
    }

    /// Remembers the open page as the one of its lab.
    pub(super) fn note_place(&mut self) {
        if let Some(page) = self.bookmark.page() {
            let lab = self.history.now().document().lab();
            let places = &mut self.desk.places;
            let of_kind = match page {
                Page::Step(..) => &mut places.steps,
                Page::Free(_) | Page::Named(..) => &mut places.free,
            };
            of_kind.insert(lab.id.to_owned(), page.clone());
            places.labs.insert(lab.id.to_owned(), page);
        }
    }

    /// Shows this in the place of what is shown, which it answers.
    fn show(&mut self, work: Work) -> Work {
        let eyes = self.playback.eyes.clone();
        let before = Work {
            position: self.left_at(),
            seen: eyes.map(|eyes| (eyes, self.stage.sight().clone())),
            history: std::mem::replace(&mut self.history, work.history),
            ..work
        };
        self.record_page(work.position);
        if let Some((eyes, sight)) = work.seen.filter(|_| self.pending.is_none()) {
            self.playback.eyes = Some(eyes);
            self.stage.see(sight);
        }
        before
    }

    /// Opens another course, at the place where it was left: the one that is built in, or a folder's.
    pub(super) fn change_course(&mut self, course: Course, folder: Option<String>) {
        self.leave_composed();
        let (page, was_untouched) = (self.bookmark.page(), self.is_untouched());
        self.settings = self.plain_settings();
        self.settings.folder = folder;
        self.desk.places = self.settings.places();
        let Places {
            page: last, steps, ..
        } = &self.desk.places;
        let mut opened = Bookmark {
            course,
            ..Bookmark::default()
        };
        if let Some(last) = last {
            opened.open_page(last, |id| self.kit.lab(id), steps);
        }
        self.turn_to(|bookmark| {
            *bookmark = opened;
            true
        });
        if self.bookmark.page() == page && was_untouched {
            self.enter();
        }
    }

    /// The courses that can be opened in place of this one: the built-in one is no folder's.
    pub(super) fn other_courses(&self) -> Vec<Option<&str>> {
        let open = self.settings.folder.as_deref();
        let lately = self
            .settings
            .folders
            .iter()
            .map(|(folder, _)| Some(&**folder));
        let all = std::iter::once(None).chain(lately);
        all.filter(|folder| *folder != open).collect()
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn open_course(&mut self, folder: Option<String>, ctx: &Context) {
        match folder {
            Some(folder) => self.open_folder(std::path::Path::new(&folder), ctx),
            None => {
                self.reload = None;
                self.notices.clear();
                self.change_course(Course::embedded(), None);
            }
        }
    }

    #[cfg(target_arch = "wasm32")]
    pub(super) fn open_course(&mut self, _: Option<String>, _: &Context) {
        self.change_course(Course::embedded(), None);
    }

    /// Records the scenes of the open lesson, when one of its steps is opened.
    pub(super) fn take_up_lesson(&mut self) {
        if !self.playback.needs.is_empty() {
            return;
        }
        let opened = self.bookmark.step().zip(self.bookmark.lesson());
        let Some((step, lesson)) = opened else {
            self.album = None;
            return;
        };
        let known = self.album.take();
        let known = known.filter(|album| album.holds(&step.scene, Some(lesson)));
        let new = || Album::new(&step.scene, Some(lesson), Medium::Window);
        self.album = Some(known.unwrap_or_else(new));
    }

    /// The open page's own scene, and where its run stands at first.
    pub(super) fn own(&self) -> Option<(Scene, usize)> {
        if let Some(free) = &self.bookmark.free {
            return Some(((free.lab.first_scene)(), 0));
        }
        let step = self.bookmark.step()?;
        Some(((*step.scene).clone(), step.opens_at()))
    }

    /// Has the text of the open step an answer?
    /// Is there nothing that the open step's claim would give away?
    pub(super) fn is_open(&self) -> bool {
        (self.shown.is_answered || !self.has_answer())
            && !self.practice.is_on
            && !self.practice.is_asking()
    }

    /// The name of a method on the stage; of a mistake, only once it may be told.
    pub(super) fn name_of(&self, method: &MethodCard) -> String {
        self.look().say(method.name_asked(self.hides_mistakes()))
    }

    /// Would the name of a mistake answer what is asked?
    pub(super) fn hides_mistakes(&self) -> bool {
        let is_shown = self.composed().is_some();
        !is_shown && self.asks_now()
    }

    fn asks_now(&self) -> bool {
        self.shown.code == CodeView::Hidden || (self.bookmark.step().is_some() && !self.is_open())
    }

    /// Where a mistake first differs from what is right, unless that would answer what is asked.
    pub(super) fn difference_told(&self) -> Option<Difference> {
        let is_asking = self.practice.is_asking() || self.hides_mistakes();
        self.playback.difference.filter(|_| !is_asking)
    }

    /// What the open step locks among these handles of the scene.
    pub(super) fn locks(&self, handles: &[Handle]) -> &[Lock] {
        let step = self.bookmark.step();
        step.map_or(&[], |step| step.locks_in(self.scene(), handles))
    }

    /// Is a scene looked for in which two programs differ? What each of them costs would tell that they do.
    pub(super) fn is_hunting(&self) -> bool {
        let has_goal = !self.met().is_empty();
        let methods = self.scene().document().methods();
        let is_against_mistake = methods.len() > 1 && methods.iter().any(|it| it.is_faulty);
        has_goal && is_against_mistake && self.hides_mistakes() && !self.is_reached()
    }

    pub(super) fn has_answer(&self) -> bool {
        let [_, step_idx] = self.bookmark.at;
        let step = self.bookmark.step().and(self.bookmark.lesson());
        let text = step.and_then(|lesson| lesson.step_text(step_idx, self.settings.lang));
        let mut blocks = text.iter().flat_map(|step| &step.body);
        blocks.any(|block| matches!(block, Block::Answer(_)))
    }

    /// The next step of the lesson, or the one before; where a question is to be read, first its answer. From a free scene back to
    /// the course.
    pub(super) fn turn_page(&mut self, forward: bool) {
        if self.bookmark.free.is_some() {
            // Whoever presents a scene of their own stays there, and comes on in its run.
            if self.is_presenting() {
                self.playback.transport.step(if forward { 1 } else { -1 });
            } else {
                self.toggle_free();
            }
            return;
        }
        let is_read = self.is_presenting()
            || match self.room() {
                Room::Course => true,
                Room::Stage => {
                    let is_beside = self.course_part() == CoursePart::Whole && !self.is_narrow();
                    is_beside || self.asks_on_stage()
                }
                Room::Inspector => false,
            };
        let is_asked = self.has_answer() && (!self.is_presenting() || self.is_untouched());
        let is_hidden = is_asked && !self.shown.is_answered && self.composed().is_none();
        if forward && is_read && is_hidden {
            self.shown.is_answered = true;
        } else {
            self.turn_to(|bookmark| bookmark.go(forward));
        }
    }

    /// A lab where it was left; at first its first lesson, or its free scene where the course has none.
    pub(super) fn open_lab(&mut self, id: &str) {
        let Some(lab) = self.kit.lab(id) else { return };
        let Places { labs, steps, .. } = self.desk.places.clone();
        self.turn_to(|bookmark| {
            let last = labs.get(id);
            last.is_some_and(|page| bookmark.open_page(page, |_| Some(lab), &steps))
                || bookmark.open_lab(id)
                || bookmark.open_free(FreeScene::of(lab), None)
        });
    }

    /// Opens the scene as another lab's own, on the page of its free scene.
    pub(super) fn adopt(&mut self, id: &str, now: f64) {
        let lab = self.kit.lab(id);
        let adopted = lab.and_then(|lab| Some((lab, (lab.adopt)(self.history.now())?)));
        if let Some((lab, scene)) = adopted {
            self.open_free(lab);
            self.edit(Edit::Replace(scene), None, now);
        }
    }

    /// From the course to the lab's free scene, or back.
    pub(super) fn toggle_free(&mut self) {
        if self.bookmark.free.is_some() {
            self.turn_to(|bookmark| bookmark.open(bookmark.at));
            return;
        }
        let lab = self.history.now().document().lab();
        let last = self.desk.places.free.get(lab.id).cloned();
        self.open_page(&last.unwrap_or_else(|| FreeScene::of(lab).page()));
    }

    pub(super) fn open_page(&mut self, page: &Page) {
        let steps = self.desk.places.steps.clone();
        let labs: Vec<_> = self.kit.panels.iter().map(|panel| panel.lab()).collect();
        let lab_of = |id: &str| labs.into_iter().find(|lab| lab.id == id);
        self.turn_to(|bookmark| bookmark.open_page(page, lab_of, &steps));
    }

    pub(super) fn open_free(&mut self, lab: &'static Lab) {
        let last = self.desk.places.steps.get(lab.id).cloned();
        self.turn_to(|bookmark| bookmark.open_free(FreeScene::of(lab), last.as_ref()));
    }

    /// The scene and its moment, as a file spells them.
    pub(super) fn as_file(&self) -> String {
        self.kit.formats.write(self.history.now(), &self.moment())
    }

    /// Where the run of the scene stands.
    pub(super) fn moment(&self) -> Moment {
        if self.pending.is_some() {
            Moment::Start
        } else {
            self.playback.main().moment(self.position())
        }
    }

    /// What is kept over a restart, and the scenes that are to be spelt for it.
    pub(super) fn kept_works(&self) -> Vec<(StoredWork, Scene)> {
        let page = self.bookmark.page().filter(|_| self.is_the_readers());
        let open = (page.iter()).map(|page| (page, &self.history, self.left_at()));
        let changed = self.desk.works.iter().filter(|(_, work)| work.is_changed);
        let changed = changed.map(|(page, work)| (page, &work.history, work.position));
        let mut room = MOST_STORED;
        let stored = open.chain(changed).filter_map(|(page, history, position)| {
            let scene = history.now();
            room = room.checked_sub(scene.document().size())?;
            let work = StoredWork {
                page: page.clone(),
                scene: String::new(),
                position,
                file: history.file().map(str::to_owned),
                is_unsaved: history.is_unsaved(),
                before: None,
            };
            Some((work, scene.clone()))
        });
        stored.collect()
    }

    /// Lays out what was kept from the last time: one step of undo away from each page's own scene. What cannot be read
    /// any more, of a lesson that is gone, say, is left out.
    pub(super) fn lay_out(&mut self, stored: Vec<StoredWork>) {
        for work in stored {
            let Ok(read) = self.kit.formats.read("", work.scene.as_bytes()) else {
                continue;
            };
            let scene = read.scene;
            let own = match &work.page {
                Page::Free(id) => self.kit.lab(id).map(|lab| (lab.first_scene)()),
                Page::Named(id, _) => self.kit.lab(id).map(|lab| (lab.smallest_scene)()),
                Page::Step(lesson, step) => {
                    let step = self.bookmark.step_of(lesson, step);
                    step.map(|step| (*step.scene).clone())
                }
            };
            let Some(own) = own.filter(|own| own.document().lab() == scene.document().lab()) else {
                continue;
            };
            let is_changed = !matches!(work.page, Page::Step(..)) || own != scene;
            let lab = own.document().lab();
            let mut history = History::new(own);
            let before = work
                .before
                .map(|text| self.kit.formats.read("", text.as_bytes()));
            if let Some(Ok(before)) = before
                && before.scene.document().lab() == lab
            {
                history.replace(before.scene);
            }
            let file = work.file.map(|path| OnDisk {
                path,
                document: (!work.is_unsaved).then(|| scene.clone()),
            });
            history.restore(scene, file);
            let laid_out = Work::new(history, work.position, is_changed);
            self.desk.works.insert(work.page, laid_out);
        }
    }
}
