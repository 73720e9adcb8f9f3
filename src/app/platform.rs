//! What the app needs of the place where it runs: the seam to files.

use crate::{labs::lines::Scene, paint::ThemeKind, text::Lang};

/// A figure to be exported: what the stage shows.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What is clipped.
    pub scene: &'a Scene,
    /// Where its run stands.
    pub position: usize,
    /// How it looks.
    pub theme: ThemeKind,
    /// What is spoken.
    pub lang: Lang,
}

/// Files, as far as there are any. Errors are in the words of the system.
pub trait Platform {
    /// Where a file of this name would be put, to be shown and changed before it is written.
    fn suggest(&self, name: &str) -> String;

    /// Writes a file whole or not at all; the path it was written to.
    ///
    /// # Errors
    /// Why it could not be written: what stood there before is as it was.
    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, String>;

    /// Draws a figure as a file's bytes.
    ///
    /// # Errors
    /// Why it could not be drawn.
    fn draw(&mut self, picture: Picture<'_>) -> Result<Vec<u8>, String>;
}

/// A place without files.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Platform for NoFiles {
    fn suggest(&self, name: &str) -> String {
        name.to_owned()
    }

    fn write(&mut self, _path: &str, _bytes: &[u8]) -> Result<String, String> {
        Err("there are no files here".to_owned())
    }

    fn draw(&mut self, picture: Picture<'_>) -> Result<Vec<u8>, String> {
        Ok(super::figure_png::draw(picture))
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

    fn write(&mut self, path: &str, bytes: &[u8]) -> Result<String, String> {
        let path = std::path::Path::new(path);
        write_whole(path, bytes).map_err(|error| error.to_string())?;
        Ok(path.display().to_string())
    }

    fn draw(&mut self, picture: Picture<'_>) -> Result<Vec<u8>, String> {
        Ok(super::figure_png::draw(picture))
    }
}

/// Writes beside the file and renames, so that nobody ever sees half of it.
#[cfg(not(target_arch = "wasm32"))]
fn write_whole(path: &std::path::Path, bytes: &[u8]) -> std::io::Result<()> {
    use std::{fs, io::Write as _};

    let mut name = path.file_name().unwrap_or_default().to_owned();
    if name.is_empty() {
        return Err(std::io::ErrorKind::InvalidFilename.into());
    }
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let written = fs::File::create(&part).and_then(|mut file| {
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&part, path)
    });
    if written.is_err() {
        // Best effort: the first error is the one that matters.
        let _ = fs::remove_file(&part);
    }
    written
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_written_whole_or_not_at_all() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("scene.toml");
        let text = path.display().to_string();
        assert_eq!(Desktop.write(&text, b"one"), Ok(text.clone()));
        assert_eq!(Desktop.write(&text, b"two"), Ok(text));
        assert_eq!(std::fs::read(&path).expect("written"), b"two");
        let nowhere = folder.path().join("no/such/folder.toml");
        assert!(Desktop.write(&nowhere.display().to_string(), b"x").is_err());
        assert!(Desktop.write("", b"x").is_err());
        let left = std::fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(left, 1, "no partial files are left behind");
    }
}
