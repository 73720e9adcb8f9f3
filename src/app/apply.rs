//! Doing what was asked for: the only place where the app changes.

use egui::Context;

use crate::{
    labs::{Edit, OutlineKind, Sketch},
    text::{Diagnostic, Message, Value},
};

use super::{
    App, Command,
    history::UndoGroup,
    notice::Notice,
    room::{Room, is_narrow, wants_strip},
};

impl App {
    /// Does one thing.
    pub fn apply(&mut self, ctx: &Context, command: Command) {
        let now = ctx.input(|input| input.time);
        match command {
            Command::Edit(edit, gesture) => self.edit(edit, gesture, now),
            Command::Add => {
                self.edit(Edit::Add(self.stage.chosen()), None, now);
            }
            Command::Remove => {
                self.edit(Edit::Remove(self.stage.chosen()), None, now);
                self.stage.selected = None;
            }
            Command::Type(handle) => self.start_typing(handle, None),
            Command::TypeAt(handle, at) => self.start_typing(Some(handle), Some(at)),
            Command::TypeChosen => self.start_typing(self.stage.chosen(), None),
            Command::CloseOutline if self.stage.sketch.is_none() => {
                if let Some(handle) = self.stage.focused {
                    self.start_typing(Some(handle), None);
                } else {
                    self.go_to_verdict();
                }
            }
            Command::Ask(about) => self.stage.asked = about,
            Command::Verdict => self.go_to_verdict(),
            Command::Typed => self.apply_typed(now),
            Command::Select(handle) => self.stage.selected = Some(handle),
            Command::DrawNth(nth) => {
                let outlines = self.history.now().document().lab().outlines();
                if let Some(outline) = outlines.get(nth) {
                    self.draw(ctx, outline, now);
                }
            }
            Command::Draw(outline) => self.draw(ctx, outline, now),
            Command::Place(_) | Command::TakeBack | Command::CloseOutline => {
                self.sketch(&command, now);
            }
            // Half an outline has a past of its own.
            Command::Undo if self.stage.sketch.is_some() => {
                self.sketch(&Command::TakeBack, now);
            }
            Command::EndGesture => self.history.end_gesture(),
            Command::Undo => self.travel(|app| app.history.undo()),
            Command::Redo => self.travel(|app| app.history.redo()),
            Command::Reset => self.reset(now),
            Command::Lesson { forward } => self.turn_page(ctx, forward),
            Command::Lab(lab) => self.open_lab(lab),
            Command::Adopt(lab) => self.adopt(lab, now),
            Command::Open([lesson, step]) => {
                self.turn_to(|bookmark| bookmark.open(lesson, step));
                self.shown.room = Room::Stage;
            }
            Command::Contents(open) => self.shown.lists_lessons = open,
            Command::Answer(shown) => self.shown.is_answered = shown,
            Command::Free => self.toggle_free(),
            Command::OpenFile
            | Command::Save
            | Command::TypePath(_)
            | Command::Browse
            | Command::Export
            | Command::Show(_)
            | Command::Confirm
            | Command::Help => {
                self.apply_dialog(ctx, command, now);
            }
            Command::Present
            | Command::Projector
            | Command::Cancel
            | Command::Course
            | Command::Inspector
            | Command::Language(_)
            | Command::Theme(_)
            | Command::Code(_)
            | Command::Snap(_)
            | Command::Measure(_)
            | Command::Dismiss => self.apply_shown(ctx, &command),
            Command::View(..) | Command::Turn(..) | Command::FitView | Command::Zoom(_) => {
                self.stage.look(ctx, self.history.now(), &command);
            }
            Command::Step(_)
            | Command::Phase(_)
            | Command::Seek(_)
            | Command::First
            | Command::Last
            | Command::Play
            | Command::Speed(_) => self.apply_transport(&command),
        }
    }

    fn apply_transport(&mut self, command: &Command) {
        if let Command::Phase(by) = *command {
            let to = self.playback.phase(by);
            self.playback.transport_mut().seek(to);
        }
        let transport = self.playback.transport_mut();
        match *command {
            Command::Step(by) => transport.step(by),
            Command::Seek(step) => transport.seek(step),
            Command::First => transport.seek(0),
            Command::Last => transport.seek(usize::MAX),
            Command::Play => transport.toggle(),
            Command::Speed(speed) => {
                transport.set_speed(speed);
                self.settings.speed = speed;
            }
            _ => {}
        }
    }

    /// To the step that decided what was asked about.
    fn go_to_verdict(&mut self) {
        let document = self.history.now().document();
        let run = self.playback.main();
        let verdict = self
            .stage
            .asked
            .and_then(|about| document.verdict(about, run));
        if let Some(step) = verdict.and_then(|verdict| verdict.step) {
            self.apply_transport(&Command::Seek(step));
        }
    }

    /// Changes the scene, and records its run again.
    ///
    /// # Errors
    /// Why the scene would not be valid: it is as it was.
    pub(super) fn change(
        &mut self,
        edit: Edit,
        gesture: Option<UndoGroup>,
        now: f64,
    ) -> Result<(), Diagnostic> {
        let size = self.history.now().document().size();
        let is_drag = matches!(edit, Edit::Drag(..));
        let fits = edit.brings_another();
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
            self.playback.follow(self.history.now());
        } else {
            self.playback.rerecord(self.history.now());
        }
        if fits {
            self.stage.fit(self.history.now());
        }
        Ok(())
    }

    /// The same; what is wrong is shown. A handle that cannot go there stays where it is: that is answer enough.
    pub(super) fn edit(&mut self, edit: Edit, gesture: Option<UndoGroup>, now: f64) {
        let is_drag = matches!(edit, Edit::Drag(..));
        if let Err(Diagnostic { message, .. }) = self.change(edit, gesture, now)
            && !is_drag
        {
            let text = self.catalog().message(&message);
            self.notices.push(Notice::passing(text, now));
        }
    }

    /// Begins an outline, if a method on stage can use it.
    fn draw(&mut self, ctx: &Context, outline: &'static OutlineKind, now: f64) {
        if !(outline.is_of_use)(self.history.now()) {
            let message = Message::new("draw-no-use").with("part", Value::Term(outline.part_key));
            let text = self.catalog().message(&message);
            self.notices.push(Notice::passing(text, now));
            return;
        }
        self.stage.sketch = Some(Sketch::new(outline));
        self.stage.selected = None;
        self.shown.room = Room::Stage;
        self.playback.transport_mut().pause();
        // Enter closes the outline: it must not press a button.
        ctx.memory_mut(egui::Memory::stop_text_input);
    }

    /// Goes on with an outline: the scene changes when it is closed.
    fn sketch(&mut self, command: &Command, now: f64) {
        let Some(sketch) = &mut self.stage.sketch else {
            return;
        };
        match *command {
            Command::Place(at) => sketch.place(at),
            Command::TakeBack if !sketch.take_back() => self.stage.sketch = None,
            Command::CloseOutline => {
                if let Some(change) = sketch.change() {
                    self.stage.sketch = None;
                    self.edit(Edit::Own(change), None, now);
                }
            }
            _ => {}
        }
    }

    /// Undo or redo.
    fn travel(&mut self, step: impl FnOnce(&mut Self)) {
        let before = self.history.revision();
        step(self);
        if self.history.revision() != before {
            self.playback.rerecord(self.history.now());
            self.stage.refit(self.history.now());
        }
    }

    /// The scene, the moment and the view as the page has them at first; undo brings back what was there.
    fn reset(&mut self, now: f64) {
        if let Some((scene, position)) = self.own() {
            self.edit(Edit::Replace(scene), None, now);
            self.playback.transport_mut().seek(position);
        }
        self.stage.fit(self.history.now());
    }

    fn apply_shown(&mut self, ctx: &Context, command: &Command) {
        let size = ctx.content_rect().size();
        let is_narrow = is_narrow(size);
        let has_strip = wants_strip(self.look().theme, size.x);
        match *command {
            Command::Present => self.present(ctx),
            Command::Projector => self.toggle_projector(),
            Command::Cancel => self.cancel(ctx),
            Command::Course if is_narrow => self.shown.room = self.shown.room.toggled(Room::Course),
            Command::Inspector if is_narrow => {
                self.shown.room = self.shown.room.toggled(Room::Inspector);
            }
            Command::Course if self.settings.course && has_strip => self.shown.unfolded ^= true,
            Command::Course => self.settings.course ^= true,
            Command::Inspector => self.settings.inspector ^= true,
            Command::Language(lang) => self.settings.lang = lang,
            Command::Theme(theme) => self.settings.theme = theme,
            Command::Code(code) => self.shown.code = code,
            Command::Snap(snap) => self.settings.snap = snap,
            Command::Measure(open) => {
                // Only the lines lab has methods that give the same answer to compare.
                self.shown.is_measuring = open && self.measures();
            }
            Command::Dismiss => self.notices.clear(),
            _ => {}
        }
    }

    fn cancel(&mut self, ctx: &Context) {
        if self.leave_presentation(ctx) {
            // Whatever else was on the screen; half an outline is still there to be gone on with.
            (self.stage.typing, self.shown.dialog) = (None, None);
            self.shown.is_measuring = false;
            self.notices.clear();
            return;
        }
        #[cfg(not(target_arch = "wasm32"))]
        if self.give_meshes_up(ctx.input(|input| input.time)) {
            return;
        }
        if self.exporting.take().is_some()
            || self.stage.typing.take().is_some()
            || self.shown.dialog.take().is_some()
            || self.stage.sketch.take().is_some()
        {
            return;
        }
        if std::mem::take(&mut self.shown.is_measuring) {
            return;
        }
        if !self.notices.is_empty() {
            self.notices.clear();
            return;
        }
        self.shown.room = Room::Stage;
        (self.stage.selected, self.stage.asked) = (None, None);
    }

    /// Does the stage show the lesson's own scene?
    pub(super) fn is_untouched(&self) -> bool {
        self.bookmark
            .step()
            .is_none_or(|step| *step.scene == *self.history.now())
    }
}
