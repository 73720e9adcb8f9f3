//! What panels may read.

use crate::{labs::Scene, lesson::CodeView, paint::Theme, text::Catalog, widgets::Look};

use super::{App, Settings, place::Place, playback::Playback};

/// The app as its panels see it.
#[derive(Clone, Copy)]
pub struct Model<'a> {
    /// Colours and words.
    pub look: Look<'a>,
    /// What is remembered.
    pub settings: &'a Settings,
    /// Where in the course.
    pub place: &'a Place,
    /// The document.
    pub scene: &'a Scene,
    /// Another number after every change of it.
    pub revision: u64,
    /// Runs and cursor.
    pub playback: &'a Playback,
    /// How the pseudocode is shown.
    pub code: CodeView,
    /// Can costs be measured in its lab?
    pub measures: bool,
    /// Is it still the lesson's own scene?
    pub is_untouched: bool,
    /// Is there something to undo, and to redo?
    pub can_travel: [bool; 2],
    /// A narrow window, where only one place is shown.
    pub is_narrow: bool,
    /// Not high enough for comfort.
    pub is_low: bool,
}

impl App {
    /// Colours and words of the present settings.
    pub(super) fn look(&self) -> Look<'static> {
        Look {
            theme: Theme::of(self.settings.theme),
            catalog: Catalog::of(self.settings.lang),
        }
    }

    /// What panels may read, in a window of this size.
    pub(super) fn model(&self, size: egui::Vec2) -> Model<'_> {
        Model {
            look: self.look(),
            settings: &self.settings,
            place: &self.place,
            scene: self.document.now(),
            revision: self.document.revision(),
            playback: &self.playback,
            code: self.shown.code,
            measures: self.measures(),
            is_untouched: self.is_untouched(),
            can_travel: [self.document.can_undo(), self.document.can_redo()],
            is_narrow: super::layout::is_narrow(size),
            is_low: size.y < 420.0,
        }
    }

    /// Has the open lab methods whose costs can be measured?
    pub(super) fn measures(&self) -> bool {
        let lab = self.document.now().document().lab();
        let mut panels = self.kit.panels.iter();
        panels.any(|panel| panel.lab() == lab && panel.measures())
    }
}
