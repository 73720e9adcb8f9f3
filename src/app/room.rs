//! What the window shows of itself: a narrow one has room for one place, a low one for less of each.

use crate::{figure::Spacing, text::Catalog, widgets::transport_width};

use super::{App, prelude::*, run_room::OnStage};

/// In windows narrower than this, in points of the light theme, the course and the inspector take the stage's place.
const NARROW: f32 = 880.0;
/// One hand holds a narrower one, in points of the light theme.
const PHONE: f32 = 560.0;
/// A window that is less high than this, in points, is low.
const LOW: f32 = 420.0;
/// Widths of the side panels: they leave the stage 60 % of 1280.
pub const COURSE: f32 = 216.0;
pub const INSPECTOR: f32 = 296.0;
/// Of the window's width the stage keeps three fifths.
const BESIDE: f32 = 0.4;
pub const BESIDE_TRANSPORT: i8 = 4;

pub const INDENT: f32 = 24.0;
const SPACING: Spacing = Spacing {
    margin: 0.0,
    gutter: 0.0,
    inset: INDENT,
    titled: 2.0 * INDENT,
    name: 36.0,
    over_caption: 0.0,
    keeps: 0.75,
    is_fixed: true,
    is_tall: false,
};
/// In one hand.
const TALL: Spacing = Spacing {
    inset: 16.0,
    titled: 32.0,
    keeps: 0.7,
    is_tall: true,
    ..SPACING
};

/// A lesson by its index, or the free scenes of a lab.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Whereabouts {
    Lesson(usize),
    Free(&'static str),
}

/// The one place that a narrow window has room for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Room {
    #[default]
    Stage,
    Course,
    Inspector,
}

impl Room {
    pub fn toggled(self, to: Self) -> Self {
        if self == to { Self::Stage } else { to }
    }
}

/// How much of the course stands beside the stage.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CoursePart {
    Hidden,
    Strip,
    Whole,
}

pub fn transport_has_room(width: f32) -> bool {
    width > transport_width() + 260.0
}

impl App {
    pub(super) fn catalog(&self) -> &'static Catalog {
        Catalog::of(self.settings.lang)
    }

    pub(super) fn look(&self) -> Look<'static> {
        let theme = Theme::sized(self.settings.theme, self.settings.text);
        Look::new(theme, self.catalog())
    }

    /// With the numbers of the step on stage all written alike; while something is asked, without the signal's colour.
    pub(super) fn look_at_step(&self) -> Look<'static> {
        let catalog = self.catalog().alike(self.playback.notation());
        let look = self.look();
        let theme = if self.practice.is_asking() {
            Theme::hushed(self.settings.theme, self.settings.text)
        } else {
            look.theme
        };
        Look {
            theme,
            catalog,
            ..look
        }
    }

    /// With the chips of what is asked, or was just answered.
    pub(super) fn look_on_stage(&self) -> Look<'_> {
        Look {
            chips: self.practice.chips(),
            ..self.look_at_step()
        }
    }

    /// The step's title, or what it shows, where nothing else on the screen says it; in a presentation with the numbers of lesson and step.
    pub(super) fn title_on_stage(&self) -> Option<String> {
        let is_whole = self.course_part() == CoursePart::Whole;
        let is_said = is_whole && !self.is_presenting() && !self.is_narrow();
        let title = self.bookmark.title(self.settings.lang, self.is_open())?;
        let [lesson, step] = self.bookmark.at;
        let (lesson, step) = (self.bookmark.course.number(lesson), step + 1);
        let title = if self.is_presenting() {
            format!("{lesson}.{step}\u{2003}{title}")
        } else {
            title.to_owned()
        };
        let has_room = !self.is_low() && !self.is_phone();
        (!is_said && has_room && self.is_untouched()).then_some(title)
    }

    pub(super) fn on_stage(&self) -> OnStage<'_> {
        (&self.playback, self.look_at_step())
    }

    pub(super) const fn is_presenting(&self) -> bool {
        self.shown.presenting.is_some()
    }

    /// So many times as much room as at first is what larger text takes.
    pub(super) const fn enlarged(&self) -> f32 {
        self.settings.text.max(1.0)
    }

    pub(super) fn is_narrow(&self) -> bool {
        let scale = Theme::of(self.settings.theme).text_scale.sqrt();
        self.shown.size.x < NARROW * scale * self.enlarged()
    }

    /// Does the inspector stand beside the stage?
    pub(super) fn has_inspector_beside(&self) -> bool {
        self.settings.inspector && !self.is_narrow() && !self.is_presenting()
    }

    /// Is all of it within reach of one hand? A frame of another page has its own way to be small.
    pub(super) fn is_phone(&self) -> bool {
        self.shown.size.x < PHONE * self.enlarged() && !self.shown.is_embedded
    }

    pub(super) fn spacing(&self) -> &'static Spacing {
        if self.is_phone() { &TALL } else { &SPACING }
    }

    /// Is it used with fingers, so that what is pressed has to be large?
    pub(super) fn has_fingers(&self) -> bool {
        self.shown.is_touched || self.is_phone()
    }

    pub(super) fn is_low(&self) -> bool {
        self.shown.size.y < LOW * self.enlarged()
    }

    pub(super) fn room(&self) -> Room {
        if self.is_narrow() {
            self.shown.room
        } else {
            Room::Stage
        }
    }

    /// Do the panels, as wide as this theme's text wants them, leave the stage too little?
    pub(super) fn has_strip(&self) -> bool {
        let width = (COURSE + INSPECTOR) * Theme::of(self.settings.theme).text_scale.sqrt();
        width > BESIDE * self.shown.size.x
    }

    pub(super) fn course_part(&self) -> CoursePart {
        let is_strip = self.has_strip() && !self.shown.unfolded;
        match (self.settings.course, is_strip) {
            (false, _) => CoursePart::Hidden,
            (true, true) => CoursePart::Strip,
            (true, false) => CoursePart::Whole,
        }
    }

    /// Does the stage say what the step asks, because its text is folded away?
    pub(super) fn asks_on_stage(&self) -> bool {
        self.shown.asks && self.course_part() == CoursePart::Strip && !self.is_low()
    }

    pub(super) fn whereabouts(&self) -> Whereabouts {
        match self.bookmark.free {
            Some(_) => Whereabouts::Free(self.scene().document().lab().id),
            None => Whereabouts::Lesson(self.bookmark.at[0]),
        }
    }

    pub(super) fn measures(&self) -> bool {
        let scene = self.scene();
        let lab = scene.document().lab();
        let mut panels = self.kit.panels.iter();
        panels.any(|panel| panel.lab() == lab && panel.measures(scene))
    }
}
