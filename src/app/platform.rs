//! What the app needs of the place where it runs: the seam to files.

use std::{io, path::Path};

use egui::{Context, DroppedFileHandle};

use crate::{
    export,
    labs::Scene,
    lesson::{FileError, Lesson},
    paint::Image,
    text::{Diagnostic, Lang, Part, SystemError},
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

/// Reads a file for as long as that is wanted, in whatever thread it is called.
pub type Reader = Box<dyn Fn(&Path, &dyn Fn() -> bool) -> Result<Vec<u8>, FileError> + Send>;

/// Draws in a studio, which is kept for the next figure.
pub fn drawn(studio: &mut Option<export::Studio>, picture: StageFigure<'_>) -> Image {
    let studio = studio.get_or_insert_with(|| export::Studio::new(picture.figures.theme));
    studio.draw(&as_exported(picture))
}

fn as_exported(picture: StageFigure<'_>) -> export::Picture<'_> {
    let Figures {
        size_px,
        theme,
        lang,
        all,
    } = picture.figures;
    export::Picture {
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
    }
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

    /// Is it pressed with fingers, as far as is known before one of them has?
    fn has_fingers(&self) -> bool {
        false
    }

    /// Does whoever sits there wish that nothing moves by itself?
    fn wants_stillness(&self) -> bool {
        false
    }

    /// Has this part fetched, unless that is on its way; is it now? What comes of it is told once.
    fn fetch(&mut self, _part: Part) -> bool {
        false
    }

    /// What has been fetched since, and whether it has come.
    fn fetched(&mut self) -> Vec<(Part, bool)> {
        Vec::new()
    }

    fn has_dialogs(&self) -> bool {
        false
    }

    /// Where whoever wants the same finds it, and what a link is put behind: a page's address.
    fn address(&self) -> Option<String> {
        None
    }

    /// Can files be named by where they lie? Else they are chosen to be opened, and written under a name alone.
    fn has_paths(&self) -> bool {
        true
    }

    /// Opens one beside the window, and comes back at once; the context is woken when there is an answer.
    fn ask(&mut self, _question: &Question, _ctx: &Context) {}

    /// What came of the one that was opened last: said once.
    fn answer(&mut self) -> Option<Answer> {
        None
    }

    /// Of files that are dropped, now or before, those that can be read now.
    fn arrived(
        &mut self,
        dropped: Vec<DroppedFileHandle>,
        _ctx: &Context,
    ) -> Vec<DroppedFileHandle> {
        dropped
    }

    fn reader(&self) -> Reader {
        Box::new(|_, _| Err(FileError::Unreadable(NO_FILES)))
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// Why it could not be read.
    fn read(&self, path: &str) -> Result<Vec<u8>, Diagnostic> {
        Ok((self.reader())(Path::new(path), &|| true)?)
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
    fn draw(&mut self, _picture: StageFigure<'_>, _ctx: &Context) -> Result<Image, Diagnostic> {
        Err(NO_FILES.into())
    }

    /// The formats of figures, by the endings of their files.
    fn formats(&self) -> &'static [&'static str] {
        &["png"]
    }

    /// A figure's file, in the format of this ending; in pixels where there is none such. It carries the link.
    ///
    /// # Errors
    /// Why it could not be drawn.
    fn figure_file(
        &mut self,
        picture: StageFigure<'_>,
        _ending: &str,
        link: Option<&str>,
        ctx: &Context,
    ) -> Result<Vec<u8>, Diagnostic> {
        Ok(self.draw(picture, ctx)?.to_linked_png(link))
    }
}

/// A place without files: a headless table.
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
        Path::new(path).exists()
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

    fn reader(&self) -> Reader {
        use crate::lesson::{MAX_SCENE_BYTES, read_file_while};
        Box::new(|path, is_wanted| read_file_while(path, MAX_SCENE_BYTES, is_wanted))
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, Diagnostic> {
        export::write_whole(Path::new(path), bytes)?;
        Ok(path.to_owned())
    }

    fn remove(&mut self, path: &str) -> Result<(), Diagnostic> {
        Ok(std::fs::remove_file(path)?)
    }

    fn draw(&mut self, picture: StageFigure<'_>, _: &Context) -> Result<Image, Diagnostic> {
        Ok(drawn(&mut self.studio, picture))
    }

    fn formats(&self) -> &'static [&'static str] {
        &["png", "svg", "pdf"]
    }

    fn figure_file(
        &mut self,
        picture: StageFigure<'_>,
        ending: &str,
        link: Option<&str>,
        ctx: &Context,
    ) -> Result<Vec<u8>, Diagnostic> {
        let shapes = match ending {
            "svg" => export::Shapes::Svg(export::Letters::default()),
            "pdf" => export::Shapes::Pdf,
            _ => return Ok(self.draw(picture, ctx)?.to_linked_png(link)),
        };
        let new = || export::Studio::new(picture.figures.theme);
        let studio = self.studio.get_or_insert_with(new);
        Ok(export::shapes(studio, &as_exported(picture), shapes, link).bytes)
    }
}
