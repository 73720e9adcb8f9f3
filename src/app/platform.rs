//! What the app needs of the place where it runs: the seam to files.

use std::io;

#[cfg(not(target_arch = "wasm32"))]
use crate::{export, paint::Headless};
use crate::{
    labs::Scene,
    text::{Diagnostic, SystemError},
};

use super::dialog::Figures;

/// A figure to be exported: what the stage shows.
#[derive(Clone, Copy, Debug)]
pub struct StageFigure<'a> {
    /// The idea in words, where the scene is a lesson's.
    pub title: Option<&'a str>,
    /// What is clipped.
    pub scene: &'a Scene,
    /// Where its run stands.
    pub position: usize,
    /// How it looks.
    pub figures: Figures,
}

/// Files, as far as there are any.
pub trait Platform {
    /// Where a file of this name would be put, to be shown and changed before it is written.
    fn suggest(&self, name: &str) -> String;

    /// Is there a file at this path?
    fn exists(&self, path: &str) -> bool;

    /// Writes a file whole or not at all; the path it was written to.
    ///
    /// # Errors
    /// Why it could not be written: what stood there before is as it was.
    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, Diagnostic>;

    /// Draws a figure as a file's bytes.
    ///
    /// # Errors
    /// Why it could not be drawn.
    fn draw(&mut self, picture: StageFigure<'_>) -> Result<Vec<u8>, Diagnostic>;
}

/// A place without files: a page in a browser, a headless table.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

/// Why nothing can be written there.
const NO_FILES: SystemError = SystemError::of_kind(io::ErrorKind::Unsupported);

impl Platform for NoFiles {
    fn suggest(&self, name: &str) -> String {
        name.to_owned()
    }

    fn exists(&self, _path: &str) -> bool {
        false
    }

    fn write(&mut self, _path: &str, _bytes: &[u8]) -> Result<String, Diagnostic> {
        Err(NO_FILES.into())
    }

    fn draw(&mut self, _picture: StageFigure<'_>) -> Result<Vec<u8>, Diagnostic> {
        Err(NO_FILES.into())
    }
}

/// A desktop with files.
#[cfg(not(target_arch = "wasm32"))]
#[derive(Clone, Copy, Debug, Default)]
pub struct Desktop;

#[cfg(not(target_arch = "wasm32"))]
impl Platform for Desktop {
    fn suggest(&self, name: &str) -> String {
        let folder = std::env::current_dir().unwrap_or_default();
        folder.join(name).display().to_string()
    }

    fn exists(&self, path: &str) -> bool {
        std::path::Path::new(path).exists()
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, Diagnostic> {
        export::write_whole(std::path::Path::new(path), bytes)?;
        Ok(path.to_owned())
    }

    fn draw(&mut self, picture: StageFigure<'_>) -> Result<Vec<u8>, Diagnostic> {
        let Figures {
            size_px,
            theme,
            lang,
            all,
        } = picture.figures;
        let mut table = Headless::new(theme);
        let figure = export::Picture {
            title: picture.title,
            scene: picture.scene,
            step: picture.position,
            lang,
            theme,
            size_px,
            among: if all {
                export::Steps::All
            } else {
                export::Steps::Figures
            },
        };
        Ok(export::draw(&mut table, &figure).to_png())
    }
}
