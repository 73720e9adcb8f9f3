//! How things look: the theme, the fonts, and a painter that needs no display.

mod cpu;
pub mod fonts;
mod headless;
mod image;
mod texture;
pub mod theme;
mod triangle;

pub use cpu::CpuPainter;
pub use headless::Headless;
pub use image::Image;
pub use theme::{Theme, ThemeKind};
