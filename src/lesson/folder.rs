//! Lessons in a folder on disk. The one place in the pure half that touches files: it lies here, beside the
//! trait it implements, so that `check`, `export` and the app read a folder the same way; a browser has none.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use super::door::read_inside;
use super::files::{FileError, Files, LESSON_FILE, MAX_FILE_BYTES, MAX_LESSONS};

#[derive(Clone, Debug)]
pub struct Folder {
    root: PathBuf,
    /// The lesson's id, where `root` is that lesson's folder.
    single: Option<String>,
}

impl Folder {
    /// A folder that holds a `lesson.toml` is a lesson; any other is a folder of lessons.
    pub fn new(root: impl Into<PathBuf>) -> Self {
        let root = root.into();
        let single = root.join(LESSON_FILE).is_file().then(|| {
            let full = fs::canonicalize(&root).unwrap_or_else(|_| root.clone());
            let name = full.file_name().map(|name| name.to_string_lossy());
            name.map_or_else(|| "lesson".to_owned(), std::borrow::Cow::into_owned)
        });
        Self { root, single }
    }

    /// The folder itself: what to watch for changes.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Where it lies, wherever one looks from.
    pub fn full_path(&self) -> String {
        let full = std::path::absolute(&self.root);
        full.unwrap_or_else(|_| self.root.clone())
            .display()
            .to_string()
    }

    fn path(&self, path: &str) -> PathBuf {
        match (&self.single, path.split_once('/')) {
            (Some(_), Some((_, name))) => self.root.join(name),
            (Some(_), None) => self.root.clone(),
            (None, _) => self.root.join(path),
        }
    }
}

impl Files for Folder {
    fn list(&self) -> Result<Vec<String>, FileError> {
        if let Some(id) = &self.single {
            let names = names(&self.root)?;
            return Ok(names.iter().map(|name| format!("{id}/{name}")).collect());
        }
        let mut paths = Vec::new();
        let mut n_lessons = 0;
        for id in names(&self.root)? {
            let folder = self.root.join(&id);
            // A folder that may not be opened is not a lesson of this person's.
            let Ok(names) = names(&folder) else { continue };
            paths.extend(names.iter().map(|name| format!("{id}/{name}")));
            n_lessons += usize::from(names.iter().any(|name| name == LESSON_FILE));
            // One too many is enough for it to be said.
            if n_lessons > MAX_LESSONS {
                break;
            }
        }
        Ok(paths)
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        read_inside(&self.path(path), MAX_FILE_BYTES as u64)
    }

    fn shown(&self, path: &str) -> String {
        let path = if path.is_empty() {
            self.root.clone()
        } else {
            self.path(path)
        };
        path.display().to_string()
    }
}

/// Sorted names of what could belong to a lesson, or be one; a name that is not Unicode could not.
fn names(folder: &Path) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        if let Ok(name) = entry?.file_name().into_string() {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}
