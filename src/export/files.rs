//! Files that are written whole or not at all.

use std::{
    fs, io,
    io::Write,
    path::Path,
    process,
    sync::atomic::{AtomicU32, Ordering},
};

// Through a neighbour that is renamed into place: what was there before stays until the new content is safe on the disk,
// and a failure leaves no half of it.
pub fn write_whole(path: &Path, content: &[u8]) -> io::Result<()> {
    static UNIQUE: AtomicU32 = AtomicU32::new(0);
    let folder = path.parent().unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let unique = UNIQUE.fetch_add(1, Ordering::Relaxed);
    let draft = folder.join(format!(".{name}.{}-{unique}.part", process::id()));
    let written = write_and_sync(&draft, content).and_then(|()| fs::rename(&draft, path));
    if written.is_err() {
        // The first error is the one to report; a draft that cannot be removed was never made.
        drop(fs::remove_file(&draft));
    }
    written
}

fn write_and_sync(path: &Path, content: &[u8]) -> io::Result<()> {
    let mut file = fs::File::create(path)?;
    file.write_all(content)?;
    // Errors of a full disk can show up as late as here.
    file.flush()?;
    file.sync_data()
}
