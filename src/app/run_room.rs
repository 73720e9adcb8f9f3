//! What is found once for a run and kept until another run asks for more: the room of its captions and its watch tables,
//! what its lines of code are about, what all there is costs, and why what was clicked was kept or dropped.

use egui::Ui;

use crate::{
    figure::{CodeLinks, Link, Run, Watch, sentences, watches},
    labs::{Scene, Verdict},
    paint::ThemeKind,
    text::{Lang, Message},
    widgets::{Look, WatchRoom, height_for_all},
};

use super::playback::Playback;

/// The runs on stage, and how they are shown.
pub type OnStage<'a> = (&'a Playback, Look<'a>);

/// What was found, and for what.
pub struct RunRoom<T> {
    known: Option<(Asked, T)>,
}

impl<T> Default for RunRoom<T> {
    fn default() -> Self {
        Self { known: None }
    }
}

/// What it depends on.
#[derive(Clone, Copy, PartialEq)]
struct Asked {
    recording: u64,
    width: f32,
    lang: Lang,
    theme: ThemeKind,
}

impl<T> RunRoom<T> {
    /// What `find` found for the runs on stage, in lines of `width` points. While a handle is dragged it stays as it was:
    /// nothing changes its scale under the pointer.
    pub fn get(
        &mut self,
        (playback, look): OnStage<'_>,
        ui: &Ui,
        width: f32,
        find: impl FnOnce() -> T,
    ) -> &mut T {
        let asked = Asked {
            recording: playback.recording(),
            width,
            lang: look.catalog.lang(),
            theme: look.theme.kind,
        };
        let is_held = ui.input(|input| input.pointer.any_down());
        let is_good = |known: Asked| {
            let recording = known.recording;
            known == asked || (is_held && Asked { recording, ..asked } == known)
        };
        let known = self.known.take().filter(|(known, _)| is_good(*known));
        let (_, found) = self.known.insert(known.unwrap_or_else(|| (asked, find())));
        found
    }
}

/// The height that the runs' captions take.
#[derive(Default)]
pub struct CaptionRoom(RunRoom<f32>);

impl CaptionRoom {
    /// The height that every caption of the runs on stage fits into, in lines of at most `width` points.
    pub fn height(&mut self, on_stage: OnStage<'_>, ui: &Ui, width: f32) -> f32 {
        let (playback, look) = on_stage;
        *self.0.get(on_stage, ui, width, || {
            let said = playback.runs().flat_map(sentences);
            height_for_all(ui.painter(), look, said, width)
        })
    }
}

/// The room of each method's table.
#[derive(Default)]
pub struct WatchRooms([RunRoom<WatchRoom>; 2]);

impl WatchRooms {
    /// The room for the table of the method in this column at all steps, `now` among them: while a handle is dragged it
    /// grows.
    pub fn of(
        &mut self,
        on_stage: OnStage<'_>,
        ui: &Ui,
        (column, run): (usize, &dyn Run),
        now: &Watch,
    ) -> &WatchRoom {
        // What a table wants does not depend on the width that it has.
        let room = self.0[column].get(on_stage, ui, 0.0, || {
            let mut room = WatchRoom::default();
            for watch in watches(run) {
                room.widen(ui, on_stage.1, &watch);
            }
            room
        });
        room.widen(ui, on_stage.1, now);
        room
    }
}

/// What the lines of each method's pseudocode are about: found when it is first asked for.
#[derive(Default)]
pub struct CodeLinkRooms([RunRoom<CodeLinks>; 2]);

impl CodeLinkRooms {
    /// Of the method in this column.
    pub fn of(
        &mut self,
        on_stage: OnStage<'_>,
        ui: &Ui,
        (column, run): (usize, &dyn Run),
    ) -> &CodeLinks {
        self.0[column].get(on_stage, ui, 0.0, || CodeLinks::of(run))
    }
}

/// Why what was clicked was kept or dropped.
#[derive(Default)]
pub struct Verdicts {
    about: Option<Link>,
    room: RunRoom<Option<Verdict>>,
}

impl Verdicts {
    /// Of what is asked about in the scene on stage.
    pub fn of(
        &mut self,
        on_stage: OnStage<'_>,
        ui: &Ui,
        (scene, about): (&Scene, Link),
    ) -> Option<&Verdict> {
        if self.about.replace(about) != Some(about) {
            self.room = RunRoom::default();
        }
        let verdict = || scene.document().verdict(about, on_stage.0.main());
        self.room.get(on_stage, ui, 0.0, verdict).as_ref()
    }
}

/// What each method does for all that its run is one of.
#[derive(Default)]
pub struct AllCosts([RunRoom<Option<Message>>; 2]);

impl AllCosts {
    /// Of the method in this column, in a sentence; none where the run is of all there is.
    pub fn of(
        &mut self,
        on_stage: OnStage<'_>,
        ui: &Ui,
        (scene, column): (&Scene, usize),
    ) -> Option<&Message> {
        let of_all = || scene.document().cost_of_all(column);
        self.0[column].get(on_stage, ui, 0.0, of_all).as_ref()
    }
}
