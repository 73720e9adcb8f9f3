//! What was done where: every step of the course and every lab's free scene keeps its own work.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{figure::Eyes, labs::Scene};

use super::{history::History, sight::Sight};

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
pub enum Page {
    /// At a step of the course: the ids of lesson and step.
    Step(String, String),
    /// Beside the course: the free scene of the lab with this id.
    Free(String),
    /// Another free scene of that lab, by the name that the reader gave it.
    Named(String, String),
}

impl Page {
    /// The name that the reader gave it, if any.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Step(..) | Self::Free(_) => None,
            Self::Named(_, name) => Some(name),
        }
    }
}

/// What can be done about a whole scene, once it has been asked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneAct {
    /// A new one, with as little in it as a scene can have.
    New,
    /// A new one that is what stands on the stage.
    Copy,
    Rename,
    Delete,
}

impl SceneAct {
    /// Each with its key, as menus write it.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::New, "Ctrl+N"),
        (Self::Copy, "Ctrl+D"),
        (Self::Rename, "Shift+F2"),
        (Self::Delete, "Ctrl+Delete"),
    ];

    pub const fn button_key(self) -> &'static str {
        match self {
            Self::New | Self::Copy => "scene-make",
            Self::Rename => "scene-rename-it",
            Self::Delete => "scene-delete-it",
        }
    }

    pub const fn key(self) -> &'static str {
        match self {
            Self::New => "scene-new",
            Self::Copy => "scene-copy",
            Self::Rename => "scene-rename",
            Self::Delete => "scene-delete",
        }
    }
}

/// What was done on a page.
pub struct Work {
    pub history: History<Scene>,
    pub position: usize,
    /// How it was seen; none where that is to be found.
    pub seen: Option<(Eyes, Sight)>,
    /// Is it another scene than the page's own? A free scene is always the reader's.
    pub is_changed: bool,
}

impl Work {
    pub const fn new(history: History<Scene>, position: usize, is_changed: bool) -> Self {
        Self {
            history,
            position,
            seen: None,
            is_changed,
        }
    }
}

/// Work as it outlives the window: its past does not.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct StoredWork {
    pub page: Page,
    /// As a scene file spells it.
    pub scene: String,
    pub position: usize,
    pub file: Option<String>,
    /// Does the file hold another scene than this?
    #[serde(default)]
    pub is_unsaved: bool,
    /// What another window had made of the page before.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub before: Option<String>,
}

#[derive(Default)]
pub struct Desk {
    /// The work on all pages but the open one.
    pub works: BTreeMap<Page, Work>,
    pub places: Places,
}

/// Where a reader of a course was last.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Places {
    pub page: Option<Page>,
    /// The page of each lab, by the lab's id.
    pub labs: BTreeMap<String, Page>,
    /// The step of the course in each lab.
    pub steps: BTreeMap<String, Page>,
    /// The free scene of each lab that was open last.
    pub free: BTreeMap<String, Page>,
}

impl Desk {
    pub fn is_changed(&self, page: &Page) -> bool {
        self.works.get(page).is_some_and(|work| work.is_changed)
    }
}
