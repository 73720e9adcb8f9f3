//! Doing what was asked for: the only place where the app changes.

use crate::{labs::OutlineKind, paint::text_sizes::text_size};

use super::{
    App, Command, Dialog,
    history::{History, UndoGroup},
    prelude::*,
    recording::Seen,
    room::Room,
    why,
};

impl App {
    pub fn apply(&mut self, ctx: &Context, command: Command) {
        let now = ctx.input(|input| input.time);
        self.is_touched = true;
        if command.is_a_first_step() {
            self.greeted();
        }
        let Some(command) = self.practised(command) else {
            return;
        };
        match command {
            Command::Edit(edit, gesture) => self.edit(edit, gesture, now),
            Command::Add => self.edit(Edit::Add(self.stage.chosen()), None, now),
            Command::Remove => {
                self.edit(Edit::Remove(self.stage.chosen()), None, now);
                self.stage.selected = None;
            }
            Command::EndGesture => {
                if self.history.is_in_gesture() {
                    self.greeted();
                }
                self.history.end_gesture();
                self.see_what_is_refused();
            }
            // Half an outline has a past of its own.
            Command::Undo if self.stage.sketch.is_some() => self.take_back(),
            Command::Undo if self.composed().is_some() => self.undo_composed(now, true),
            Command::Redo if self.composed().is_some() => self.undo_composed(now, false),
            Command::Undo => self.travel(History::undo),
            Command::Redo => self.travel(History::redo),
            Command::Reset => self.reset(now),
            Command::Select(handle) => self.stage.selected = Some(handle),
            Command::Ask(about) => self.stage.ask(about),
            Command::Verdict => self.go_to_verdict(),
            Command::Type(handle, at) => self.start_typing(handle, at),
            Command::TypeChosen => match self.stage.chosen().or(self.stage.clicked) {
                Some(handle) => self.start_typing(Some(handle), None),
                None => self.tell(&Message::new("type-what"), now),
            },
            Command::Typed => self.apply_typed(ctx, now),
            Command::DrawNth(nth) => {
                if let Some(outline) = self.history.now().document().lab().outlines.get(nth) {
                    self.draw(ctx, outline, now);
                }
            }
            Command::Draw(outline) => self.draw(ctx, outline, now),
            Command::Place(at) => {
                if let Some(sketch) = &mut self.stage.sketch {
                    sketch.place(at);
                }
            }
            Command::TakeBack => self.take_back(),
            Command::CloseOutline => self.close_outline(now),
            Command::View(id, to) => self.stage.move_to(id, to),
            Command::Turn(id, eye) => self.stage.turn(id, eye),
            Command::FitView => self.fit(),
            Command::Zoom(factor) => self.stage.zoom(ctx, factor),
            command => self.apply_to_run(ctx, command, now),
        }
    }

    /// Where the run stands on the stage, and how fast it goes.
    fn apply_to_run(&mut self, ctx: &Context, command: Command, now: f64) {
        let transport = &mut self.playback.transport;
        match command {
            Command::Step(by) => transport.step(by),
            Command::Seek(step) => transport.seek(step),
            Command::Phase(by) => {
                let step = self.playback.phase(by);
                self.playback.transport.seek(step);
            }
            Command::Play => transport.toggle(),
            Command::Practise => self.practise(),
            Command::Speed(speed) => {
                transport.set_speed(speed);
                self.settings.speed = speed;
            }
            command => self.apply_to_window(ctx, command, now),
        }
    }

    /// What is about pages, files and the window, and not about the scene on stage.
    fn apply_to_window(&mut self, ctx: &Context, command: Command, now: f64) {
        self.shown.size = ctx.content_rect().size();
        let shown = &mut self.shown;
        match command {
            Command::Lesson { forward } => self.turn_page(forward),
            Command::Lab(lab) => self.open_lab(lab),
            Command::Adopt(lab) => self.adopt(lab, now),
            Command::Open(at) => {
                self.turn_to(|bookmark| bookmark.open(at));
                self.shown.room = Room::Stage;
            }
            Command::Contents(open) => shown.lists_lessons = open,
            Command::OpenCourse(folder) => self.open_course(folder, ctx),
            Command::Answer(is_answered) => shown.is_answered = is_answered,
            Command::Question => shown.asks ^= true,
            Command::Free => self.toggle_free(),
            Command::OpenPage(page) => self.open_page(&page),
            Command::NextFree(forward) => self.next_free(forward),
            Command::AskAboutScene(act) => self.ask_about_scene(act),
            Command::OpenRecent(path) => self.open_recent(&path),
            Command::CopyFigure => self.copy_figure(ctx, now),
            Command::CopySvg => self.copy_svg(ctx, now),
            Command::CopyLink => self.copy_link(ctx, now),
            Command::Help if shown.dialog == Some(Dialog::Help) => shown.dialog = None,
            Command::Help => shown.dialog = Some(Dialog::Help),
            Command::OpenFile => self.ask(ctx, self.opened()),
            Command::Save => self.ask(ctx, self.saved()),
            // How figures look is asked first, and in the window.
            Command::Export => self.shown.dialog = Some(self.exported_to()),
            Command::Browse => {
                if let Some(dialog) = shown.dialog.take() {
                    self.ask(ctx, dialog);
                }
            }
            Command::Show(dialog) => shown.dialog = dialog,
            Command::Confirm => self.confirm(ctx, now),
            Command::Smaller => self.make_smaller(ctx, now),
            Command::Compose(act) => self.act_on_lesson(ctx, act, now),
            Command::Hint => self.show_hint(),
            Command::Present => self.present(ctx),
            // A page in a browser is one window, which all look at.
            Command::Notes => shown.has_notes = !cfg!(target_arch = "wasm32") && !shown.has_notes,
            Command::Projector => self.toggle_projector(),
            Command::OpenWhole => self.open_whole(ctx),
            Command::Cancel => self.cancel(ctx),
            Command::Code(code) => shown.code = code,
            Command::Picture => self.turn_picture(now),
            Command::Section(id) => self.open_section(id),
            Command::Control(id) => self.lead_to(id, now),
            Command::Measure(open) => self.shown.is_measuring = open && self.measures(),
            Command::Dismiss => self.notices.clear(),
            command => self.apply_to_settings(&command),
        }
    }

    /// How the window looks from now on.
    fn apply_to_settings(&mut self, command: &Command) {
        let (is_narrow, has_strip) = (self.is_narrow(), self.has_strip());
        let (shown, settings) = (&mut self.shown, &mut self.settings);
        match *command {
            Command::Course if is_narrow => shown.room = shown.room.toggled(Room::Course),
            Command::Inspector if is_narrow => shown.room = shown.room.toggled(Room::Inspector),
            Command::Course if settings.course && has_strip => shown.unfolded ^= true,
            Command::Course => settings.course ^= true,
            Command::Inspector => settings.inspector ^= true,
            Command::Language(lang) => self.speak(lang),
            Command::Theme(theme) => settings.theme = theme,
            Command::TextSize(text) => settings.text = text,
            Command::TextStep(0) => settings.text = 1.0,
            Command::TextStep(by) => settings.text = text_size(settings.text, by),
            Command::Snap(snap) => settings.snap = snap,
            Command::AskInLessons(asks) => {
                settings.asks = asks;
                self.ask_of_step(false);
            }
            Command::MarkAtEnd(is_at_end) => settings.marks_at_end = is_at_end,
            Command::AskAgain => self.ask_of_step(true),
            Command::Afresh => self.begin_afresh(),
            Command::Board(board) => {
                settings.board = board;
                *settings = std::mem::take(settings).in_range();
            }
            _ => {}
        }
    }

    fn go_to_verdict(&mut self) {
        let asked = self.stage.asked;
        let verdict = asked.and_then(|about| why::verdict(&self.playback, self.scene(), about));
        if let Some(step) = verdict.and_then(|verdict| verdict.step) {
            self.playback.transport.seek(step);
        }
    }

    pub(super) fn change(
        &mut self,
        edit: Edit,
        gesture: Option<UndoGroup>,
        now: f64,
    ) -> Result<(), Diagnostic> {
        let size = self.history.now().document().size();
        let is_drag = matches!(edit, Edit::Drag(..) | Edit::Measure(..));
        let fits = edit.brings_another();
        // To undo a change is to see what was seen before it.
        self.history.leave(self.position());
        let mut selected = None;
        let changed = self.history.edit(gesture, now, size, |scene| {
            selected = edit.apply(scene)?;
            Ok::<(), Diagnostic>(())
        });
        self.stage.selected = selected.or(self.stage.selected);
        if !changed? {
            return Ok(());
        }
        if is_drag && self.history.is_in_gesture() {
            self.follow();
        } else {
            self.rerecord();
            self.see_what_is_refused();
        }
        if fits {
            self.fit();
        }
        Ok(())
    }

    /// What is wrong is all to be seen: there is no run that shows it, and its lists leave their room to it.
    fn see_what_is_refused(&mut self) {
        if self.playback.main().is_refused() {
            self.see(Seen::Refitted);
        }
    }

    /// The same; what is wrong is shown. A handle that cannot go there stays where it is: that is answer enough.
    pub(super) fn edit(&mut self, edit: Edit, gesture: Option<UndoGroup>, now: f64) {
        let is_drag = matches!(edit, Edit::Drag(..) | Edit::Measure(..));
        if let Err(Diagnostic { message, .. }) = self.change(edit, gesture, now)
            && !is_drag
        {
            self.tell(&message, now);
        }
    }

    /// Begins an outline, if a method on stage can use it.
    fn draw(&mut self, ctx: &Context, outline: &'static OutlineKind, now: f64) {
        if !(outline.is_of_use)(self.history.now()) {
            let message = Message::new("draw-no-use").with("part", Value::Term(outline.part_key));
            self.tell(&message, now);
            return;
        }
        self.stage.sketch = Some(Sketch::new(outline));
        self.stage.selected = None;
        self.shown.room = Room::Stage;
        self.playback.transport.pause();
        // Enter closes the outline: it must not press a button.
        ctx.memory_mut(egui::Memory::stop_text_input);
    }

    fn take_back(&mut self) {
        if let Some(sketch) = &mut self.stage.sketch
            && !sketch.take_back()
        {
            self.stage.sketch = None;
        }
    }

    /// Closes the outline; where none is drawn, Enter is about the handle in focus, or about what was asked.
    fn close_outline(&mut self, now: f64) {
        match (&self.stage.sketch, self.stage.focused) {
            (Some(sketch), _) => {
                if let Some(change) = sketch.change() {
                    self.stage.sketch = None;
                    self.edit(Edit::Own(change), None, now);
                }
            }
            (None, Some(handle)) => self.start_typing(Some(handle), None),
            (None, None) => self.go_to_verdict(),
        }
    }

    pub(super) fn travel(&mut self, step: fn(&mut History<Scene>, usize) -> Option<usize>) {
        const MANY: usize = 8;
        let size = |app: &Self| app.history.now().document().size().max(1);
        let before = (self.history.revision(), size(self));
        let position = self.position();
        let position = step(&mut self.history, position);
        if self.history.revision() != before.0 {
            self.rerecord();
            // A street and the few objects that were there before are not seen from one place.
            let is_another = size(self).abs_diff(before.1) > MANY * size(self).min(before.1);
            self.see(if is_another {
                Seen::Fitted
            } else {
                Seen::Refitted
            });
        }
        if let Some(position) = position {
            self.seek(position);
        }
    }

    /// A step of the course as it was; a free scene is the reader's, and only shown from its first step.
    fn reset(&mut self, now: f64) {
        match self.own().filter(|_| self.bookmark.free.is_none()) {
            Some((scene, position)) => {
                self.edit(Edit::Replace(scene), None, now);
                self.seek(position);
                self.ask_of_step(false);
            }
            None => self.seek(0),
        }
        self.fit();
    }

    /// Shows what is to be seen now, from where it is seen best.
    pub(super) fn fit(&mut self) {
        self.see(Seen::Fitted);
    }

    fn cancel(&mut self, ctx: &Context) {
        if self.is_recording() {
            self.stop_recording();
            return;
        }
        if self.stop_search() {
            return;
        }
        let is_told = !self.has_inspector_beside() && why::may_tell(self);
        if is_told && self.stage.asked.take().is_some() {
            return;
        }
        if self.leave_presentation(ctx) {
            // Whatever else was on the screen; half an outline is still there to be gone on with.
            (self.stage.typing, self.shown.dialog) = (None, None);
            self.shown.is_measuring = false;
            self.notices.clear();
            return;
        }
        if self.give_meshes_up(ctx.input(|input| input.time)) {
            return;
        }
        if self.end_export()
            || self.stage.typing.take().is_some()
            || self.shown.dialog.take().is_some()
            || self.stage.sketch.take().is_some()
            || std::mem::take(&mut self.shown.is_measuring)
            || std::mem::take(&mut self.shown.lists_lessons)
            || !std::mem::take(&mut self.notices).is_empty()
        {
            return;
        }
        self.shown.room = Room::Stage;
        (self.stage.selected, self.stage.clicked) = (None, None);
        self.stage.asked = None;
    }

    /// Is there something that Escape closes before it leaves a question?
    pub(super) fn is_covered(&self) -> bool {
        self.stage.typing.is_some()
            || self.stage.sketch.is_some()
            || self.shown.dialog.is_some()
            || self.shown.is_measuring
            || self.shown.lists_lessons
    }

    pub(super) fn is_untouched(&self) -> bool {
        let step = self.bookmark.step();
        step.is_none_or(|step| self.history.now().document().is_like(&step.scene))
    }
}
