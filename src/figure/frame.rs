//! Everything that one step shows.

use crate::{
    text::{Formula, Message},
    trace::Counts,
};

use super::{
    mark::Mark,
    role::{Link, Role},
    space::Space,
    view::{Body, View, ViewId},
    watch::Watch,
};

/// One sentence: the decision, then the arithmetic that led to it.
#[derive(Clone, PartialEq, Debug)]
pub struct Caption {
    /// Set semibold.
    pub decision: Message,
    /// Set after it, one after the other.
    pub arithmetic: Vec<Formula>,
}

impl Caption {
    /// A decision without arithmetic yet.
    pub const fn new(decision: Message) -> Self {
        Self {
            decision,
            arithmetic: Vec::new(),
        }
    }

    /// With one more formula.
    pub fn so(mut self, formula: Formula) -> Self {
        self.arithmetic.push(formula);
        self
    }
}

/// The display list of one step.
#[derive(Clone, PartialEq, Debug)]
pub struct Frame {
    /// From left to right, the drawing first; what stands beside it has the same places at every step of a run.
    pub views: Vec<View>,
    /// This step's sentence.
    pub caption: Caption,
    /// Index into the method's pseudocode.
    pub code_line: Option<usize>,
    /// The values that are alive.
    pub watch: Watch,
    /// Operations done so far.
    pub counts: Counts,
}

impl Frame {
    /// The marks of the drawing in the plane; none where there is no such view.
    pub fn marks(&self) -> &[Mark] {
        let plane = self.views.iter().find_map(|view| match &view.body {
            Body::Plane(marks) if view.id == ViewId::PLANE => Some(&marks[..]),
            _ => None,
        });
        plane.unwrap_or_default()
    }

    /// The space that is the drawing, where it is one.
    pub fn space(&self) -> Option<&Space> {
        self.views.first().and_then(|view| match &view.body {
            Body::Space(space) => Some(space),
            Body::Plane(_)
            | Body::Raster(_)
            | Body::Bits(_)
            | Body::Table(_)
            | Body::Lists(_)
            | Body::Products(_)
            | Body::NumberLine(_)
            | Body::Clippers(_)
            | Body::Gauges(_)
            | Body::Ribbon(_)
            | Body::Screens(_)
            | Body::Multiples(_)
            | Body::Matrix(_)
            | Body::Spaces(_)
            | Body::Graph(_)
            | Body::Story(_) => None,
        })
    }

    /// What this step is about, the drawing's first: the links of marks and of values that stand out.
    pub fn focus(&self) -> impl Iterator<Item = Link> {
        let marks = self.marks().iter().map(|mark| (mark.role, mark.link));
        let in_space = self.space().into_iter().flat_map(|space| &space.marks);
        let marks = marks.chain(in_space.map(|mark| (mark.role, mark.link)));
        let marks = marks.filter(|(role, _)| *role == Role::Signal);
        let rows = self.watch.iter().flat_map(|section| &section.rows);
        let rows = rows.filter(|row| row.has_changed());
        let of_marks = marks.filter_map(|(_, link)| link);
        of_marks.chain(rows.filter_map(|row| row.link))
    }
}
