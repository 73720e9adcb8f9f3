//! What the app needs of the place where it runs: the seam to files.

use std::io;

use egui::Context;

#[cfg(not(target_arch = "wasm32"))]
use crate::export;
use crate::{
    labs::Scene,
    lesson::Lesson,
    paint::Image,
    text::{Diagnostic, Lang, SystemError},
};

#[cfg(not(target_arch = "wasm32"))]
use super::chooser::Chooser;
use super::dialog::{Answer, Figures, Question};
#[cfg(not(target_arch = "wasm32"))]
use super::settings::Settings;

#[derive(Clone, Copy, Debug)]
pub struct StageFigure<'a> {
    /// The idea in words, where the scene is a lesson's.
    pub title: Option<&'a str>,
    pub scene: &'a Scene,
    /// The lesson that it was opened in.
    pub lesson: Option<&'a Lesson>,
    pub position: usize,
    pub figures: Figures,
}

/// A place that has no files answers as it stands here.
pub trait Platform {
    /// Where a file of this name would be put, to be shown and changed before it is written.
    fn suggest(&self, name: &str) -> String {
        name.to_owned()
    }

    fn exists(&self, _path: &str) -> bool {
        false
    }

    /// The language in which the app begins where nobody has chosen one.
    fn lang(&self) -> Lang {
        Lang::default()
    }

    /// What a link is put behind: the address of a page; nothing where there is none.
    fn address(&self) -> String {
        String::new()
    }

    fn has_dialogs(&self) -> bool {
        false
    }

    /// Opens one beside the window, and comes back at once; the context is woken when there is an answer.
    fn ask(&mut self, _question: &Question, _ctx: &Context) {}

    /// What came of the one that was opened last: said once.
    fn answer(&mut self) -> Option<Answer> {
        None
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// Why it could not be read.
    fn read(&self, _path: &str) -> Result<Vec<u8>, Diagnostic> {
        Err(NO_FILES.into())
    }

    /// Writes a file whole or not at all; the path it was written to.
    ///
    /// # Errors
    /// Why it could not be written: what stood there before is as it was.
    fn write(&mut self, _path: &str, _bytes: &[u8]) -> Result<String, Diagnostic> {
        Err(NO_FILES.into())
    }

    /// Takes a file away that was made here.
    ///
    /// # Errors
    /// Why it is still there.
    fn remove(&mut self, _path: &str) -> Result<(), Diagnostic> {
        Err(NO_FILES.into())
    }

    /// Draws a figure.
    ///
    /// # Errors
    /// Why it could not be drawn.
    fn draw(&mut self, _picture: StageFigure<'_>) -> Result<Image, Diagnostic> {
        Err(NO_FILES.into())
    }
}

/// A place without files: a page in a browser, a headless table.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

const NO_FILES: SystemError = SystemError::of_kind(io::ErrorKind::Unsupported);

impl Platform for NoFiles {}

#[cfg(not(target_arch = "wasm32"))]
#[derive(Default)]
pub struct Desktop {
    studio: Option<export::Studio>,
    chooser: Option<Chooser>,
}

#[cfg(not(target_arch = "wasm32"))]
impl Desktop {
    pub fn with_dialogs() -> Self {
        Self {
            chooser: Some(Chooser::default()),
            ..Self::default()
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Platform for Desktop {
    fn suggest(&self, name: &str) -> String {
        let folder = std::env::current_dir().unwrap_or_default();
        folder.join(name).display().to_string()
    }

    fn lang(&self) -> Lang {
        Settings::of_system().lang
    }

    fn exists(&self, path: &str) -> bool {
        std::path::Path::new(path).exists()
    }

    fn has_dialogs(&self) -> bool {
        let mut chooser = self.chooser.iter();
        chooser.any(|chooser| !chooser.is_missing())
    }

    fn ask(&mut self, question: &Question, ctx: &Context) {
        if let Some(chooser) = &mut self.chooser {
            chooser.ask(question, ctx);
        }
    }

    fn answer(&mut self) -> Option<Answer> {
        self.chooser.as_mut()?.answer()
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, Diagnostic> {
        use crate::lesson::{MAX_SCENE_BYTES, read_file};
        Ok(read_file(std::path::Path::new(path), MAX_SCENE_BYTES)?)
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, Diagnostic> {
        export::write_whole(std::path::Path::new(path), bytes)?;
        Ok(path.to_owned())
    }

    fn remove(&mut self, path: &str) -> Result<(), Diagnostic> {
        Ok(std::fs::remove_file(path)?)
    }

    fn draw(&mut self, picture: StageFigure<'_>) -> Result<Image, Diagnostic> {
        let Figures {
            size_px,
            theme,
            lang,
            all,
        } = picture.figures;
        let new = || export::Studio::new(theme);
        let studio = self.studio.get_or_insert_with(new);
        let figure = export::Picture {
            title: picture.title,
            scene: picture.scene,
            lesson: picture.lesson,
            step: picture.position,
            before: None,
            foot: None,
            options: export::Options {
                size_px,
                theme,
                lang,
                steps: if all {
                    export::Steps::All
                } else {
                    export::Steps::Figures
                },
                asks: false,
            },
        };
        Ok(studio.draw(&figure))
    }
}
