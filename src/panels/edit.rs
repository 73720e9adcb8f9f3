//! What a person can do to a scene, whichever lab it is of.

use std::fmt;

use crate::{
    geom::GeomError,
    labs::{Handle, Scene, lines, polygons},
    text::{Diagnostic, Message},
};

use super::{lines::LinesEdit, polygons::PolygonsEdit};

/// One change to the scene.
#[derive(Clone, PartialEq, Debug)]
pub enum Edit {
    /// Use another method.
    Method(&'static str),
    /// Put another method beside it, or none.
    Compare(Option<&'static str>),
    /// Move a handle.
    Drag(Handle, [f64; 2]),
    /// One more of what the lab has many of: a segment, a vertex after this handle's.
    Add(Option<Handle>),
    /// One less.
    Remove(Option<Handle>),
    /// Another scene altogether.
    Replace(Box<Scene>),
    /// What only the lines lab knows.
    Lines(LinesEdit),
    /// What only the polygons lab knows.
    Polygons(PolygonsEdit),
}

/// Why a change is not made: the scene is as it was.
#[derive(Clone, Debug)]
pub enum EditError {
    /// The shapes would not be valid.
    Geom(GeomError),
    /// The lines lab's document would not be valid.
    Lines(lines::SceneError),
    /// The polygons lab's document would not be valid.
    Polygons(polygons::SceneError),
}

impl fmt::Display for EditError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Geom(error) => error.fmt(f),
            Self::Lines(error) => error.fmt(f),
            Self::Polygons(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for EditError {}

impl EditError {
    /// For people.
    #[must_use]
    pub fn message(&self) -> Message {
        let diagnostic = match self {
            Self::Geom(error) => Diagnostic::from(*error),
            Self::Lines(error) => Diagnostic::from(*error),
            Self::Polygons(error) => Diagnostic::from(*error),
        };
        diagnostic.message
    }
}

impl From<GeomError> for EditError {
    fn from(error: GeomError) -> Self {
        Self::Geom(error)
    }
}

impl From<lines::SceneError> for EditError {
    fn from(error: lines::SceneError) -> Self {
        Self::Lines(error)
    }
}

impl From<polygons::SceneError> for EditError {
    fn from(error: polygons::SceneError) -> Self {
        Self::Polygons(error)
    }
}

impl Edit {
    /// Does the change bring a scene that should be seen whole?
    #[must_use]
    pub const fn brings_another(&self) -> bool {
        match self {
            Self::Replace(_) => true,
            Self::Lines(edit) => edit.brings_another(),
            Self::Polygons(edit) => edit.brings_another(),
            _ => false,
        }
    }

    /// Makes the change. One for another lab changes nothing.
    ///
    /// # Errors
    /// [`EditError`] where the scene would not be valid: it is left as it was.
    pub fn apply(self, scene: &mut Scene) -> Result<(), EditError> {
        match (self, scene) {
            (Self::Method(id), scene) => scene.set_method(id),
            (Self::Compare(id), scene) => scene.set_compare(id),
            (Self::Drag(handle, to), scene) => scene.drag(handle, to)?,
            (Self::Replace(other), scene) => *scene = *other,
            (Self::Add(_), Scene::Lines(scene)) => LinesEdit::Add.apply(scene)?,
            (Self::Remove(_), Scene::Lines(scene)) => LinesEdit::Remove.apply(scene)?,
            (Self::Lines(edit), Scene::Lines(scene)) => edit.apply(scene)?,
            (Self::Add(handle), Scene::Polygons(scene)) => {
                PolygonsEdit::Insert(handle, None).apply(scene)?;
            }
            (Self::Remove(handle), Scene::Polygons(scene)) => {
                PolygonsEdit::Delete(handle).apply(scene)?;
            }
            (Self::Polygons(edit), Scene::Polygons(scene)) => edit.apply(scene)?,
            (Self::Lines(_), Scene::Polygons(_)) | (Self::Polygons(_), Scene::Lines(_)) => {}
        }
        Ok(())
    }
}
