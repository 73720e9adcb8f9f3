//! `clipscope` and `clipscope open`: the app.

use std::{
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use crate::{
    app::{Opening, Settings, is_mesh, run_native},
    lesson::{Folder, SceneFormats},
    text::{Catalog, Diagnostic, Message},
};

use super::{Outcome, say::say_text};

/// Opens the app on a path, or on the embedded course. What goes wrong is said in the system's language.
pub(super) fn open_app(path: Option<PathBuf>) -> ExitCode {
    let catalog = Catalog::of(Settings::of_system().lang);
    let opened = path.map_or_else(|| Ok(Opening::default()), |path| opening(&path, catalog));
    let ran =
        opened.and_then(|opening| run_native(opening).map_err(|message| catalog.message(&message)));
    match ran {
        Ok(()) => Outcome::Done.into(),
        Err(reason) => {
            say_text(&reason);
            Outcome::Unusable.into()
        }
    }
}

/// A folder is a course or a lesson; a file is a scene, or a mesh, which is read when the window is there.
fn opening(path: &Path, catalog: &Catalog) -> Result<Opening, String> {
    if path.is_dir() {
        return Ok(Opening {
            folder: Some(Folder::new(path)),
            ..Opening::default()
        });
    }
    let name = path.display().to_string();
    let unread = |error| {
        let message = Message::new("status-open-failed")
            .with("path", name.clone())
            .with("reason", Diagnostic::from(error));
        catalog.message(&message)
    };
    if is_mesh(path) {
        fs::File::open(path).map_err(unread)?;
        return Ok(Opening {
            mesh: Some(name),
            ..Opening::default()
        });
    }
    let bytes = fs::read(path).map_err(unread)?;
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
        scene: Some((name, scene)),
        ..Opening::default()
    })
}
