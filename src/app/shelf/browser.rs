//! The storage that a browser has for a page and for whatever else comes from the same host, shared by all its tabs.

use std::io;

use web_sys::{Storage, window};

use super::{super::Settings, super::prelude::*, parsed};

const NAME: &str = "clipscope";
const ASIDE: &str = "clipscope-broken";

/// The storage is asked for anew each time: it belongs to the thread of the page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Shelf;

fn storage() -> io::Result<Storage> {
    let storage = window().and_then(|window| window.local_storage().ok().flatten());
    storage.ok_or(io::ErrorKind::PermissionDenied.into())
}

impl Shelf {
    /// None where the reader, or the browser, lets pages keep nothing.
    pub fn of_system() -> Option<Self> {
        storage().is_ok().then_some(Self)
    }

    /// `None` where nothing was kept yet.
    pub fn read(&self) -> Result<Option<Settings>, Diagnostic> {
        let kept = storage()?.get_item(NAME).ok().flatten();
        kept.map(|kept| parsed(kept.as_bytes())).transpose()
    }

    /// Keeps what cannot be read under another name.
    pub fn put_aside(&self) -> io::Result<String> {
        let storage = storage()?;
        let broken = storage.get_item(NAME).ok().flatten().unwrap_or_default();
        let full = |_| io::Error::from(io::ErrorKind::StorageFull);
        storage.set_item(ASIDE, &broken).map_err(full)?;
        storage.remove_item(NAME).map_err(full)?;
        Ok(ASIDE.to_owned())
    }

    /// Writes what is made of what is there.
    pub fn keep(&self, made: impl FnOnce(Option<Settings>) -> Settings) -> io::Result<()> {
        let there = self.read().ok().flatten();
        let written = serde_json::to_string(&made(there))?;
        let full = |_| io::Error::from(io::ErrorKind::StorageFull);
        storage()?.set_item(NAME, &written).map_err(full)
    }

    pub fn unkept(&self, reason: Diagnostic) -> Message {
        Message::new("status-memory-full").with("reason", reason)
    }

    /// What it is called where that is told.
    pub fn name(&self) -> String {
        NAME.to_owned()
    }
}
