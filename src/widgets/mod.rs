//! Parts of the window that know figures and runs, but no lab: each draws one thing and says what was
//! done to it. None keeps state that undo would miss.

mod album;
mod boundary;
mod canvas;
mod caption;
mod composed;
mod cost;
mod fingers;
mod grid;
mod handles;
mod headings;
mod hit;
mod lesson_text;
mod menu;
mod name_tags;
mod pan_zoom;
mod prelude;
mod pseudocode;
mod selecting;
mod taking;
mod timeline;
mod transport;
mod views;
mod watch;
mod whole_rows;

pub use crate::paint::Look;
pub use album::{Album, Column, Medium, Recorded, wanted};
pub use boundary::{BoundaryMoved, boundary};
pub use canvas::{Canvas, CanvasShown, Seized, StageClick, place_at};
pub use caption::{caption, caption_text, explained, height_for_all};
pub use composed::{Composition, rect_of};
pub use cost::{Bars, Cost, cost, most_of_a_kind};
pub use fingers::{TARGET, reach, target};
pub use handles::{Gesture, Moved, Snap, Spot, gripped, snapped, spot_id};
pub use headings::{column_title, focus_ring, quiet_button, rule, section};
pub use hit::link_at;
pub use lesson_text::{TextTold, card, claimed, lesson_text, step_title};
pub use menu::{
    form_button, language_menu, menu_button, menu_style, text_menu, theme_key, theme_menu,
};
pub use pan_zoom::PanZoom;
pub use pseudocode::{CodeStep, CodeText, Pseudocode, code_view_switch};
pub use selecting::select;
pub use timeline::{Timeline, tick_sign};
pub use transport::{
    Icon, Press, icon_button, large_button, speed_menu, transport_buttons, transport_width,
};
pub use views::{
    covered, keep_ahead, picture_viewport, place_inset, projected, space, stage_viewport,
    title_ground, title_of_space, under_title, view,
};
pub use watch::{WatchRoom, WatchShown, WatchTable, watch};
