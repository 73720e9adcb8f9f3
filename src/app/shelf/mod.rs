//! Where the app remembers: a file of its own on a desktop, the browser's storage in a page.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod file;

#[cfg(target_arch = "wasm32")]
pub use browser::Shelf;
#[cfg(not(target_arch = "wasm32"))]
pub use file::Shelf;

use super::{Settings, prelude::*};

fn parsed(bytes: &[u8]) -> Result<Settings, Diagnostic> {
    let settings = serde_json::from_slice(bytes);
    settings.map_err(|_| Message::new("memory-broken").into())
}
