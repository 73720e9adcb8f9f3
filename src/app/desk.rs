//! What was done where: every step of the course and every lab's free scene keeps its own work.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::labs::Scene;

use super::history::History;

/// Where a scene stands.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
pub enum Page {
    /// At a step of the course: the ids of lesson and step.
    Step(String, String),
    /// Beside the course: the free scene of the lab with this id.
    Free(String),
}

/// What was done on a page.
#[derive(Clone, Debug)]
pub struct Work {
    /// The scene and its past.
    pub history: History<Scene>,
    /// Where its run stood.
    pub position: usize,
    /// The file that the scene was read from or written to.
    pub file: Option<String>,
    /// Is it another scene than the page's own? A free scene is always the reader's.
    pub is_changed: bool,
}

/// Work as it outlives the window: its past does not.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct StoredWork {
    /// Where.
    pub page: Page,
    /// As a scene file spells it.
    pub scene: String,
    /// Where its run stood.
    pub position: usize,
    /// The file that it belongs to.
    pub file: Option<String>,
}

/// The work on all pages but the open one.
#[derive(Clone, Debug, Default)]
pub struct Desk {
    works: BTreeMap<Page, Work>,
    /// The page of each lab that was open last, by the lab's id.
    last: BTreeMap<String, Page>,
}

impl Desk {
    /// A desk on which these pages were open last.
    pub const fn new(last: BTreeMap<String, Page>) -> Self {
        Self {
            works: BTreeMap::new(),
            last,
        }
    }

    /// Puts work away.
    pub fn put(&mut self, page: Page, work: Work) {
        self.works.insert(page, work);
    }

    /// Takes the work on a page up again.
    pub fn take(&mut self, page: &Page) -> Option<Work> {
        self.works.remove(page)
    }

    /// Is the scene that was put away there another than the page's own?
    pub fn is_changed(&self, page: &Page) -> bool {
        self.works.get(page).is_some_and(|work| work.is_changed)
    }

    /// All that was put away.
    pub fn works(&self) -> impl Iterator<Item = (&Page, &Work)> {
        self.works.iter()
    }

    /// This page of the lab is open.
    pub fn opened(&mut self, lab_id: &str, page: Page) {
        self.last.insert(lab_id.to_owned(), page);
    }

    /// The page of the lab that was open last.
    pub fn last(&self, lab_id: &str) -> Option<&Page> {
        self.last.get(lab_id)
    }

    /// The pages that were open last, by their labs' ids.
    pub const fn all_last(&self) -> &BTreeMap<String, Page> {
        &self.last
    }
}
