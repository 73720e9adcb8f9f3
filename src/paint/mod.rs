//! How things look: the theme, the fonts, and a painter that needs no display.

mod area;
mod checker;
mod chips;
mod cpu;
mod cut;
pub mod fonts;
mod hatch;
mod headless;
mod labels;
mod layers;
mod line;
pub mod notes;
mod overlap;
mod parts;
mod pen;
mod solid_outlines;
mod solid_samples;
mod solids;
mod stage;
pub mod text_sizes;
mod texture;
pub mod theme;
mod triangle;
mod typeset;
mod viewport;

#[cfg(test)]
mod tests;

pub use cpu::{CpuPainter, Image};
pub use cut::crosses;
pub use hatch::hatched;
pub use headless::{Drawing, Headless};
pub use labels::{Around, Obstacle, Placed};
pub use parts::{Part, parts};
pub use pen::{stroke_colour, text_colour};
pub use theme::{Look, Theme, ThemeKind};
pub use typeset::{Span, Typeset};
pub use viewport::{Viewport, round_step};
