//! `clipscope` and `clipscope open`: the app.

use std::{
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use crate::{
    app::{Opening, run_native},
    lesson::{Folder, SceneFormats},
    text::{Catalog, Lang, Message},
};

use super::{Outcome, say::say_text};

/// Opens the app on a path, or on the embedded course.
pub(super) fn open_app(path: Option<PathBuf>) -> ExitCode {
    let opened = path.map_or_else(|| Ok(Opening::default()), |path| opening(&path));
    match opened.and_then(run_native) {
        Ok(()) => Outcome::Done.into(),
        Err(reason) => {
            say_text(&reason);
            Outcome::Unusable.into()
        }
    }
}

/// A folder is a course or a lesson; a file is a scene.
fn opening(path: &Path) -> Result<Opening, String> {
    if path.is_dir() {
        return Ok(Opening {
            folder: Some(Folder::new(path)),
            ..Opening::default()
        });
    }
    let catalog = Catalog::of(Lang::En);
    let name = path.display().to_string();
    let bytes = fs::read(path).map_err(|error| {
        let message = Message::new("status-open-failed")
            .with("path", name.clone())
            .with("reason", error.to_string());
        catalog.message(&message)
    })?;
    let scene = SceneFormats::standard()
        .read(&name, &bytes)
        .map_err(|problems| {
            let lines: Vec<String> = problems
                .iter()
                .map(|problem| problem.render(catalog))
                .collect();
            lines.join("\n")
        })?;
    Ok(Opening {
        scene: Some(scene),
        ..Opening::default()
    })
}
