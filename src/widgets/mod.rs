//! Parts of the window that know figures and runs, but no lab: each draws one thing and says what was
//! done to it. None keeps state that undo would miss.

mod canvas;
mod caption;
mod composed;
mod cost;
mod grid;
mod handles;
mod hit;
mod icon;
mod lesson_text;
mod menu;
mod pan_zoom;
mod picker;
mod pseudocode;
mod section;
mod tick;
mod timeline;
mod title;
mod transport;
mod views;
mod watch;
mod whole_rows;

pub use canvas::{Canvas, CanvasShown, StageClick, place_at};
pub use caption::{caption, caption_text, height_for_all};
pub use composed::{StepWords, TEXT_PTS, beside_the_drawing, headline, rect_of, slot_of};
pub use cost::{Bars, Cost, cost, most_of_a_kind};
pub use handles::{Gesture, Moved, Snap, Spot, gripped};
pub use hit::link_at;
pub use icon::{Icon, icon_button};
pub use lesson_text::{lesson_text, step_title};
pub use menu::{form_button, menu_button, menu_style};
pub use pan_zoom::PanZoom;
pub use picker::{language_menu, theme_key, theme_menu};
pub use pseudocode::{CodeStep, CodeText, Pseudocode, code_view_switch};
pub use section::{rule, section};
pub use timeline::Timeline;
pub use title::column_title;
pub use transport::{Press, speed_menu, transport_buttons, transport_width};
pub use views::{
    covered, picture_viewport, projected, space, title_ground, title_of_space, under_title, view,
};
pub use watch::{WatchRoom, WatchShown, WatchTable, watch};

use crate::{paint::Theme, text::Catalog};

/// What every widget has to know to draw: the colours and the language.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    /// Colours and sizes.
    pub theme: &'a Theme,
    /// Words and numbers.
    pub catalog: &'a Catalog,
}

impl Look<'_> {
    /// A word or sentence without values.
    #[must_use]
    pub fn say(&self, key: &str) -> String {
        self.catalog.term(key)
    }
}
