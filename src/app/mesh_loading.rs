//! A mesh that is read in a thread of its own, where there are threads: the window stays alive meanwhile, and Escape gives it up.

use std::{
    io,
    path::Path,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use web_time::Duration;

use crate::{
    labs::space::Picture,
    lesson::{FileError, ObjFile, picture_of, read_obj_while, read_picture},
};

use super::{
    App,
    errand::{Errand, Lost},
    notice::Notice,
    platform::Reader,
    prelude::*,
};

enum Unread {
    File(Diagnostic),
    Mesh(Vec<Problem>),
}

struct ReadMesh {
    obj: ObjFile,
    /// What it is painted with.
    picture: Option<Picture>,
    /// That picture's file, where no material names it.
    found: Option<String>,
}

/// A mesh on its way. Dropped, it is given up.
pub struct MeshLoading {
    path: String,
    read: Errand<Result<ReadMesh, Unread>>,
    is_wanted: Arc<AtomicBool>,
}

impl MeshLoading {
    fn start(path: &str, reader: Reader, ctx: &Context) -> Self {
        let is_wanted = Arc::new(AtomicBool::new(true));
        let (of, asked) = (path.to_owned(), Arc::clone(&is_wanted));
        let read = move || read_mesh(&of, &reader, &|| asked.load(Ordering::Relaxed));
        Self {
            path: path.to_owned(),
            read: Errand::start(ctx, read),
            is_wanted,
        }
    }

    fn answer(&mut self) -> Option<Result<ReadMesh, Unread>> {
        let answer = self.read.answer(Duration::ZERO);
        answer.unwrap_or_else(|Lost| {
            let reason = FileError::from(io::Error::from(io::ErrorKind::Other));
            Some(Err(Unread::File(reason.into())))
        })
    }
}

impl Drop for MeshLoading {
    fn drop(&mut self) {
        self.is_wanted.store(false, Ordering::Relaxed);
    }
}

fn read_mesh(
    path: &str,
    reader: &Reader,
    is_wanted: &dyn Fn() -> bool,
) -> Result<ReadMesh, Unread> {
    let path_of = |name: &str| Path::new(path).with_file_name(name);
    let read = |path: &Path| reader(path, is_wanted);
    let bytes = read(Path::new(path)).map_err(|error| Unread::File(error.into()))?;
    let obj = read_obj_while(path, &bytes, is_wanted).map_err(Unread::Mesh)?;
    let beside = |name: &str| read(&path_of(name));
    let material = obj.material.as_ref();
    // What is missing is said by its library's name.
    let named = material.map(|it| picture_of(it, &beside, &|_| None));
    let (picture, found) = match named {
        Some(Ok(named)) => (named.map(|(_, picture)| picture), None),
        Some(Err(_)) | None if !obj.mesh.uvs().is_empty() => picture_beside(path, &beside).unzip(),
        Some(Err(_)) | None => (None, None),
    };
    let mesh = obj.mesh.fitted();
    let obj = ObjFile { mesh, ..obj };
    Ok(ReadMesh {
        obj,
        picture,
        found,
    })
}

/// `cow.png`, or `cow_texture.jpg`, for `cow.obj` and `cow_triangulated.obj`; and its name.
fn picture_beside(
    path: &str,
    read: &dyn Fn(&str) -> Result<Vec<u8>, FileError>,
) -> Option<(Picture, String)> {
    let stem = Path::new(path).file_stem()?.to_str()?;
    let of_family = stem.rsplit_once('_').map(|(family, _)| family);
    let stems = [stem].into_iter().chain(of_family);
    let names = stems.flat_map(|stem| ["", "_texture"].map(|part| format!("{stem}{part}")));
    let mut names = names.flat_map(|name| PICTURES.map(|it| format!("{name}.{it}")));
    names.find_map(|name| Some((read_picture(&read(&name).ok()?)?, name)))
}

const PICTURES: [&str; 3] = ["png", "jpg", "jpeg"];

pub fn is_mesh(path: &Path) -> bool {
    let ending = path.extension();
    ending.is_some_and(|ending| ending.eq_ignore_ascii_case("obj"))
}

pub fn is_of_a_mesh(path: &Path) -> bool {
    let ending = path.extension();
    let is_it = |known: &&str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(known));
    PICTURES.iter().chain(&["mtl"]).any(is_it)
}

impl App {
    pub(super) fn load_mesh(&mut self, path: &str, ctx: &Context) {
        let reader = self.platform.reader();
        self.loading.push(MeshLoading::start(path, reader, ctx));
        self.notices.clear();
        self.say_what_is_loading();
    }

    fn say_what_is_loading(&mut self) {
        let paths: Vec<&str> = self.loading.iter().map(|mesh| mesh.path.as_str()).collect();
        if !paths.is_empty() {
            let message = Message::new("status-mesh-reading").with("path", paths.join(", "));
            self.notify(Notice {
                text: self.catalog().message(&message),
                is_problem: false,
                until: None,
            });
        }
    }

    /// Was there one to give up?
    pub(super) fn give_meshes_up(&mut self, now: f64) -> bool {
        let meshes = std::mem::take(&mut self.loading);
        if meshes.is_empty() {
            return false;
        }
        let paths: Vec<&str> = meshes.iter().map(|mesh| mesh.path.as_str()).collect();
        let message = Message::new("status-mesh-given-up").with("path", paths.join(", "));
        self.notices.clear();
        self.tell(&message, now);
        true
    }

    pub(super) fn take_meshes(&mut self, now: f64) {
        let mut found = Vec::new();
        self.loading.retain_mut(|mesh| {
            let answer = mesh.answer();
            let is_waiting = answer.is_none();
            found.extend(answer.map(|answer| (mesh.path.clone(), answer)));
            is_waiting
        });
        if found.is_empty() {
            return;
        }
        self.notices.clear();
        for (path, read) in found {
            match read {
                Ok(read) => self.add_mesh(&path, read, now),
                Err(Unread::File(reason)) => self.report_unread(&path, reason),
                Err(Unread::Mesh(problems)) => self.report_unfit(&problems),
            }
        }
        self.say_what_is_loading();
    }

    fn add_mesh(&mut self, path: &str, read: ReadMesh, now: f64) {
        let ReadMesh {
            obj: read,
            picture,
            found: beside,
        } = read;
        let name = Path::new(path).file_stem().unwrap_or_default();
        let name = name.display().to_string();
        // Into the open lab's scene, if that shows meshes.
        let open = self.scene().document().lab();
        let (here, elsewhere): (Vec<_>, Vec<_>) =
            (self.kit.panels.iter()).partition(|panel| panel.lab() == open);
        let mut panels = here.into_iter().chain(elsewhere);
        let found = panels.find_map(|panel| {
            let edit = panel.add_mesh(&name, &read.mesh, picture.as_ref())?;
            Some((panel.lab(), edit))
        });
        let Some((lab, edit)) = found else {
            return;
        };
        self.open_free(lab);
        let added = self.change(edit, None, now);
        let mut said = vec![match added {
            Ok(()) => Message::new("status-mesh-added")
                .with("name", name)
                .with("count", read.mesh.faces().len()),
            Err(refused) => refused.message,
        }];
        if let Some(picture) = beside {
            said.push(Message::new("status-mesh-picture").with("name", picture));
        }
        if let (Some([library, _]), None) = (&read.material, picture) {
            said.push(Message::new("status-mesh-plain").with("library", library.clone()));
        }
        if !read.warnings.is_empty() {
            self.complain(self.listing(&read.warnings));
        }
        for message in said {
            self.tell(&message, now);
        }
    }
}
