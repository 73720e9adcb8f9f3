//! A file of the app's own, written whole or not at all.

use std::{
    env,
    fs::{self, File},
    io,
    path::{Path, PathBuf},
};

use crate::{export::write_whole, lesson::read_file};

use super::{super::Settings, super::prelude::*, parsed};

/// More than all work that is kept takes.
const MAX_BYTES: u64 = 512 << 20;

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Shelf {
    path: PathBuf,
}

impl Shelf {
    pub const fn at(path: PathBuf) -> Self {
        Self { path }
    }

    /// Where settings are kept on this system, if it says so.
    pub fn of_system() -> Option<Self> {
        let of = |name| {
            env::var_os(name)
                .filter(|it| !it.is_empty())
                .map(PathBuf::from)
        };
        let home = |rest: &str| Some(of("HOME")?.join(rest));
        let data = if cfg!(target_os = "windows") {
            of("APPDATA")
        } else if cfg!(target_os = "macos") {
            home("Library/Application Support")
        } else {
            of("XDG_DATA_HOME").or_else(|| home(".local/share"))
        };
        Some(Self::at(data?.join("clipscope/settings.json")))
    }

    /// `None` where nothing was kept yet.
    pub fn read(&self) -> Result<Option<Settings>, Diagnostic> {
        let path = &self.path;
        if path
            .symlink_metadata()
            .is_err_and(|error| error.kind() == io::ErrorKind::NotFound)
        {
            return Ok(None);
        }
        parsed(&read_file(path, MAX_BYTES)?).map(Some)
    }

    /// Renames what cannot be read, so that nothing is written over it; its new name.
    pub fn put_aside(&self) -> io::Result<String> {
        let names = (1..).map(|n| match n {
            1 => self.path.with_extension("broken"),
            n => self.path.with_extension(format!("broken-{n}")),
        });
        let mut free = names.filter(|name| name.symlink_metadata().is_err());
        let aside = free.next().ok_or(io::ErrorKind::AlreadyExists)?;
        fs::rename(&self.path, &aside)?;
        Ok(shown(&aside))
    }

    /// Writes what is made of what is there.
    pub fn keep(&self, made: impl FnOnce(Option<Settings>) -> Settings) -> io::Result<()> {
        if let Some(folder) = self.path.parent() {
            fs::create_dir_all(folder)?;
        }
        // Held to the end: two windows that write at once take turns. A system without locks has to do without.
        let lock = File::create(self.path.with_extension("lock"))?;
        let _ = lock.lock();
        let there = self.read().ok().flatten();
        write_whole(&self.path, &serde_json::to_vec(&made(there))?)
    }

    pub fn unkept(&self, reason: Diagnostic) -> Message {
        let said = Message::new("status-memory-unkept").with("path", self.name());
        said.with("reason", reason)
    }

    /// What it is called where that is told.
    pub fn name(&self) -> String {
        shown(&self.path)
    }
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
