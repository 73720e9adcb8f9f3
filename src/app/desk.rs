//! What was done where: every step of the course and every lab's free scene keeps its own work.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::labs::Scene;

use super::history::History;

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
pub enum Page {
    /// At a step of the course: the ids of lesson and step.
    Step(String, String),
    /// Beside the course: the free scene of the lab with this id.
    Free(String),
}

/// What was done on a page.
pub struct Work {
    pub history: History<Scene>,
    pub position: usize,
    /// Is it another scene than the page's own? A free scene is always the reader's.
    pub is_changed: bool,
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
}

impl Desk {
    pub fn is_changed(&self, page: &Page) -> bool {
        self.works.get(page).is_some_and(|work| work.is_changed)
    }
}
