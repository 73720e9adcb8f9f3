//! A lab's document, whichever lab it is.

use std::{
    fmt,
    ops::{Deref, DerefMut},
};

use crate::{
    figure::{Mark, Run},
    geom::GeomError,
    trace::Counts,
};

use super::{Handle, MethodCard, lines, polygons};

/// A lab: a kind of document, and the methods that work on it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Lab {
    /// Segments against a window.
    Lines,
    /// A polygon against a window or another polygon.
    Polygons,
}

impl Lab {
    /// Every lab, in the order in which they are taught.
    pub const ALL: [Self; 2] = [Self::Lines, Self::Polygons];

    /// As lesson files spell it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Lines => "lines",
            Self::Polygons => "polygons",
        }
    }

    /// Catalogue key of its name.
    #[must_use]
    pub const fn name_key(self) -> &'static str {
        match self {
            Self::Lines => "lab-lines",
            Self::Polygons => "lab-polygons",
        }
    }

    /// Catalogue key of what it is about.
    #[must_use]
    pub const fn about_key(self) -> &'static str {
        match self {
            Self::Lines => "lab-lines-about",
            Self::Polygons => "lab-polygons-about",
        }
    }

    /// Its methods, in the order in which they are taught.
    #[must_use]
    pub fn methods(self) -> Vec<&'static MethodCard> {
        match self {
            Self::Lines => lines::Method::all().map(lines::Method::card).collect(),
            Self::Polygons => polygons::Method::all()
                .map(polygons::Method::card)
                .collect(),
        }
    }

    /// What it opens on where there is no lesson.
    #[must_use]
    pub fn first_scene(self) -> Scene {
        match self {
            Self::Lines => Scene::Lines(lines::Scene::first()),
            Self::Polygons => Scene::Polygons(polygons::Scene::first()),
        }
    }
}

impl fmt::Display for Lab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.id())
    }
}

/// What figures, lessons and the window ask of a scene.
pub trait Document {
    /// Its lab.
    fn lab(&self) -> Lab;
    /// The methods on stage, from left to right: one, or two that are compared.
    fn methods(&self) -> Vec<&'static MethodCard>;
    /// Puts the method of this id first; an unknown one is ignored.
    fn set_method(&mut self, id: &str);
    /// Puts the method of this id beside the first, or none.
    fn set_compare(&mut self, id: Option<&str>);
    /// Records the runs of [`Document::methods`], in their order.
    fn record(&self) -> Vec<Box<dyn Run>>;
    /// A plainer method to compare costs with, where no other stands beside, and what it costs in all.
    fn baseline(&self) -> Option<(&'static MethodCard, Counts)> {
        None
    }
    /// What lies under the marks of the method in this column, at the end of its run or before.
    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark>;
    /// The world rectangle that a view shows at first.
    fn bounds(&self) -> [[f64; 2]; 2];
    /// What can be dragged, in the order in which Tab visits it.
    fn handles(&self) -> Vec<Handle>;
    /// Where a handle lies; `None` where the scene has no such handle.
    fn position(&self, handle: Handle) -> Option<[f64; 2]>;
    /// Moves a handle, as far as the scene stays valid.
    ///
    /// # Errors
    /// [`GeomError`] where it would not: the scene is left as it was.
    fn drag(&mut self, handle: Handle, to: [f64; 2]) -> Result<(), GeomError>;
    /// How large it is, in segments or vertices.
    fn size(&self) -> usize;
}

/// A lab's scene. What it can do whichever lab it is of, it does as a [`Document`].
#[derive(Clone, PartialEq, Debug)]
pub enum Scene {
    /// Segments against a window.
    Lines(lines::Scene),
    /// A polygon against a window or another polygon.
    Polygons(polygons::Scene),
}

impl Scene {
    /// The lines lab's scene, if it is one.
    #[must_use]
    pub const fn as_lines(&self) -> Option<&lines::Scene> {
        match self {
            Self::Lines(scene) => Some(scene),
            Self::Polygons(_) => None,
        }
    }

    /// The polygons lab's scene, if it is one.
    #[must_use]
    pub const fn as_polygons(&self) -> Option<&polygons::Scene> {
        match self {
            Self::Polygons(scene) => Some(scene),
            Self::Lines(_) => None,
        }
    }
}

impl Deref for Scene {
    type Target = dyn Document;
    fn deref(&self) -> &Self::Target {
        match self {
            Self::Lines(scene) => scene,
            Self::Polygons(scene) => scene,
        }
    }
}

impl DerefMut for Scene {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Self::Lines(scene) => scene,
            Self::Polygons(scene) => scene,
        }
    }
}

impl From<lines::Scene> for Scene {
    fn from(scene: lines::Scene) -> Self {
        Self::Lines(scene)
    }
}

impl From<polygons::Scene> for Scene {
    fn from(scene: polygons::Scene) -> Self {
        Self::Polygons(scene)
    }
}
