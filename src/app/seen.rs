//! What the panels of the window ask of the app.

use crate::{paint::Theme, text::Catalog, widgets::Look};

use super::{
    App,
    room::{self, CoursePart, Room},
    run_room::OnStage,
};

/// A window that is less high than this, in points, is low.
const LOW: f32 = 420.0;

impl App {
    /// Colours and words of the present settings.
    pub(super) fn look(&self) -> Look<'static> {
        Look {
            theme: Theme::of(self.settings.theme),
            catalog: Catalog::of(self.settings.lang),
        }
    }

    /// The runs on stage, and how they are shown.
    pub(super) fn on_stage(&self) -> OnStage<'_> {
        (&self.playback, self.look())
    }

    /// Is there something to undo, and to redo?
    pub(super) fn can_travel(&self) -> [bool; 2] {
        [self.history.can_undo(), self.history.can_redo()]
    }

    /// Are there stage, caption and a small transport alone?
    pub(super) const fn is_presenting(&self) -> bool {
        self.shown.presenting.is_some()
    }

    /// Is the window narrow, so that only one place is shown?
    pub(super) fn is_narrow(&self) -> bool {
        room::is_narrow(self.shown.size)
    }

    /// Is the window not high enough for comfort?
    pub(super) fn is_low(&self) -> bool {
        self.shown.size.y < LOW
    }

    /// What a narrow window shows; else the stage.
    pub(super) fn room(&self) -> Room {
        if self.is_narrow() {
            self.shown.room
        } else {
            Room::Stage
        }
    }

    /// Is the course a strip until it is asked for?
    pub(super) fn has_strip(&self) -> bool {
        room::wants_strip(self.look().theme, self.shown.size.x)
    }

    /// What of the course stands beside the stage.
    pub(super) fn course_part(&self) -> CoursePart {
        match (
            self.settings.course,
            self.has_strip() && !self.shown.unfolded,
        ) {
            (false, _) => CoursePart::Hidden,
            (true, true) => CoursePart::Strip,
            (true, false) => CoursePart::Whole,
        }
    }

    /// Has the open lab methods whose costs can be measured?
    pub(super) fn measures(&self) -> bool {
        let lab = self.history.now().document().lab();
        let mut panels = self.kit.panels.iter();
        panels.any(|panel| panel.lab() == lab && panel.measures())
    }
}
