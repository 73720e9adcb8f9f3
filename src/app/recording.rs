//! A scene whose run takes longer than a frame: the one before stays on the stage until it is recorded, and comes back where
//! that is stopped.

use egui::Frame;
use web_time::Duration;

use super::{
    App, Command,
    desk::Page,
    errand::{Errand, Lost},
    found::Found,
    history::History,
    playback::Playback,
    prelude::*,
    stage_state::StageState,
};
use crate::widgets::keep_ahead;

/// A scene of at most this size is recorded within a frame.
const LONG: usize = 10_000;
/// A recording that comes within this time is shown as if it had been there at once.
const AT_ONCE: Duration = Duration::from_millis(16);

/// What is to be seen of a scene once it is recorded.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Seen {
    #[default]
    AsBefore,
    /// All of it, if it does not lie well in what was to be seen.
    Refitted,
    Fitted,
    /// It is another page's.
    Anew,
}

/// A scene that is to be recorded.
#[derive(Default)]
pub struct Pending {
    errand: Option<Errand<Found>>,
    /// Where its run is to stand, if not at the same moment.
    pub position: Option<usize>,
    pub seen: Seen,
    /// The page of what is on the stage meanwhile, where that is another.
    pub from: Option<Page>,
}

impl App {
    /// Is a scene being recorded?
    pub fn is_recording(&self) -> bool {
        let is_begun = |pending: &Pending| pending.errand.is_some() || !self.playback.is_late;
        self.pending.as_ref().is_some_and(is_begun)
    }

    /// Is an earlier scene on the stage meanwhile? One that was dragged stays as it was let go.
    pub(super) const fn shows_another(&self) -> bool {
        self.pending.is_some() && !self.playback.is_late
    }

    /// Records the changed scene: now, or in the next frames where it is large.
    pub(super) fn rerecord(&mut self) {
        let was = self.drop_pending();
        let scene = self.history.now();
        if scene == self.playback.scene() {
            self.playback.keep();
        } else if scene.document().size() <= LONG {
            self.playback.rerecord(scene);
        } else {
            self.pending = Some(was.unwrap_or_default());
        }
    }

    /// The same while a handle is dragged.
    pub(super) fn follow(&mut self) {
        self.pending = self.drop_pending();
        if self.pending.is_some() {
            self.playback.is_late = self.is_alike();
        } else {
            self.playback.follow(self.history.now());
        }
    }

    /// Gives up what is being recorded. Its thread goes on to its end, and the next one waits for that.
    pub(super) fn drop_pending(&mut self) -> Option<Pending> {
        let mut pending = self.pending.take()?;
        self.given_up = pending.errand.take().or(self.given_up.take());
        Some(pending)
    }

    /// Shows the open page's scene, and its run at this step.
    pub(super) fn record_page(&mut self, position: usize) {
        let was = self.drop_pending();
        let scene = self.history.now();
        let was_another = was.is_some_and(|was| was.seen == Seen::Anew);
        if was_another && scene == self.playback.scene() {
            // It has been on the stage all the time.
        } else if scene.document().size() <= LONG {
            self.playback = Playback::record(scene, position).in_place_of(&self.playback);
            self.stage = StageState::new(self.bookmark.bounds_of(scene));
        } else {
            self.pending = Some(Pending {
                position: Some(position),
                seen: Seen::Anew,
                ..Pending::default()
            });
        }
    }

    /// Where the run of the open page's scene stands, or is to stand.
    pub(super) fn left_at(&self) -> usize {
        let pending = self.pending.as_ref();
        let position = pending.and_then(|pending| pending.position);
        position.unwrap_or_else(|| self.position())
    }

    /// Another number for every scene on the stage.
    pub(super) fn stage_revision(&self) -> u64 {
        2 * self.history.revision() + u64::from(self.shows_another())
    }

    /// Changes what is to be seen of the scene; if that is being recorded, then.
    pub(super) fn see(&mut self, seen: Seen) {
        if let Some(pending) = &mut self.pending {
            pending.seen = pending.seen.max(seen);
            return;
        }
        let bounds = self.bounds_when(seen);
        if seen == Seen::Fitted || bounds != self.stage.bounds() {
            self.stage.fit(bounds);
        }
        if seen == Seen::Fitted {
            self.playback.look_anew();
        }
    }

    /// Can what is on the stage stand for the scene? It is of the same methods.
    fn is_alike(&self) -> bool {
        let ids = |scene: &Scene| {
            let methods = scene.document().methods().into_iter();
            methods.map(|card| card.id).collect::<Vec<_>>()
        };
        ids(self.history.now()) == ids(self.playback.scene())
    }

    /// Goes on with what is to be recorded, and shows it once it is.
    pub(super) fn take_recorded(&mut self, ctx: &Context) {
        let is_over =
            |errand: &mut Errand<Found>| !matches!(errand.answer(Duration::ZERO), Ok(None));
        if self.given_up.as_mut().is_some_and(is_over) {
            self.given_up = None;
        }
        if self.history.is_in_gesture() {
            return;
        }
        if self.playback.is_late && self.pending.is_none() {
            self.pending = Some(Pending::default());
        }
        let Some(pending) = &self.pending else { return };
        let mut within = Duration::ZERO;
        if pending.errand.is_none() {
            // A number that is dragged is let go first.
            let is_held = ctx.input(|input| input.pointer.any_down());
            let is_dragged = is_held || self.playback.is_late;
            self.playback.is_late = is_dragged && pending.seen != Seen::Anew && self.is_alike();
            if is_held && self.playback.is_late || self.given_up.is_some() {
                return;
            }
            let (scene, bounds) = (self.history.now().clone(), self.bounds_when(pending.seen));
            let (known, [step, of]) = (pending.position, self.playback.steps()[0]);
            let first = move |n_steps| known.unwrap_or(step * n_steps / of.max(1));
            let is_kept = !matches!(pending.seen, Seen::Fitted | Seen::Anew);
            let eyes = self.playback.eyes.clone().filter(|_| is_kept);
            let record = move || {
                let found = Found::of(&scene).with_wanted(bounds);
                found.with_pictures(first, eyes)
            };
            let errand = Some(Errand::start(ctx, record));
            if let Some(pending) = &mut self.pending {
                pending.errand = errand;
            }
            within = AT_ONCE;
        }
        let errand = self.pending.as_mut().and_then(|it| it.errand.as_mut());
        match errand.map(|errand| errand.answer(within)) {
            Some(Ok(Some(mut found))) => {
                keep_ahead(ctx, std::mem::take(&mut found.ahead));
                self.show_recorded(found, within == AT_ONCE);
            }
            Some(Err(Lost)) => self.stop_recording(),
            Some(Ok(None)) | None => {}
        }
    }

    /// What is to be seen of the scene.
    fn bounds_when(&self, seen: Seen) -> [[f64; 2]; 2] {
        let scene = self.history.now();
        match seen {
            Seen::AsBefore => self.stage.bounds(),
            Seen::Refitted => self.stage.refitted(scene),
            Seen::Fitted | Seen::Anew => self.bookmark.bounds_of(scene),
        }
    }

    fn show_recorded(&mut self, found: Found, is_at_once: bool) {
        let Some(Pending { position, seen, .. }) = self.pending.take() else {
            return;
        };
        if seen == Seen::Anew {
            self.playback = Playback::of(found, 0).in_place_of(&self.playback);
            self.playback.transport.set_speed(self.settings.speed);
            self.stage = StageState::new(self.bounds_when(seen));
        } else {
            self.see(seen);
            self.playback.take(found);
        }
        if !is_at_once {
            self.playback.is_slow();
        }
        if let Some(position) = position {
            self.seek(position);
        }
    }

    /// Takes back what brought the scene that is being recorded: what is on the stage stays there.
    pub(super) fn stop_recording(&mut self) {
        if let Some(page) = self
            .pending
            .as_ref()
            .and_then(|pending| pending.from.clone())
        {
            self.open_page(&page);
        }
        while self.pending.is_some() && self.history.can_undo() {
            self.travel(History::undo);
        }
        while self.pending.is_some() && self.history.can_redo() {
            self.travel(History::redo);
        }
    }
}

/// What is being recorded, over the stage, and what stops it.
pub fn show(app: &App, ui: &mut Ui, stage: Rect) {
    if !app.is_recording() {
        return;
    }
    let (look, document) = (app.look(), app.history.now().document());
    let method = document.methods()[0].name_key;
    let said = Message::new(document.lab().recording_key)
        .with("method", Value::Term(method))
        .with("count", document.size());
    let top = stage.with_max_y(stage.top() + 48.0 * look.theme.text_scale.sqrt());
    ui.scope_builder(UiBuilder::new().max_rect(top), |ui| {
        let frame = Frame::new().fill(look.theme.accent_wash);
        frame.inner_margin(12).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(look.catalog.message(&said)).color(look.theme.ink));
                let stop = Button::new(accent(look, "recording-stop"));
                if ui.add(stop.fill(look.theme.background)).clicked() {
                    app.push(Command::Cancel);
                }
            });
        });
    });
}
