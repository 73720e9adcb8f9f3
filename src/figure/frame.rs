//! What a step of a run shows, whichever method it is of.

use crate::{
    text::{Catalog, Formula, Message, Value},
    trace::Counts,
};

use super::{
    mark::Mark,
    role::{Link, Role},
    small_pictures::{Raster, SmallDrawing},
    space::Space,
    view::{Body, View, ViewId},
    watch::Watch,
};

#[derive(Clone, PartialEq, Debug)]
pub struct Caption {
    pub decision: Message,
    pub arithmetic: Vec<Formula>,
}

impl Caption {
    pub const fn new(decision: Message) -> Self {
        Self {
            decision,
            arithmetic: Vec::new(),
        }
    }

    /// As one line, for where nothing can be drawn.
    pub fn text(&self, catalog: &Catalog) -> String {
        let decision = catalog.message(&self.decision);
        let formulas = self
            .arithmetic
            .iter()
            .map(|formula| catalog.formula(formula));
        let formulas: Vec<String> = formulas.collect();
        format!("{decision} {}", formulas.join(", "))
            .trim_end()
            .to_owned()
    }

    pub fn so(mut self, formula: Formula) -> Self {
        self.arithmetic.push(formula);
        self
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct Frame {
    /// From left to right, the drawing first; what stands beside it has the same places at every step of a run.
    pub views: Vec<View>,
    pub caption: Caption,
    pub code_line: Option<usize>,
    pub watch: Watch,
    pub counts: Counts,
}

impl Frame {
    pub fn marks(&self) -> &[Mark] {
        let plane = self.views.iter().find_map(|view| match &view.body {
            Body::Plane(marks) if view.id == ViewId::PLANE => Some(&marks[..]),
            _ => None,
        });
        plane.unwrap_or_default()
    }

    pub fn body(&self, id: ViewId) -> Option<&Body> {
        let view = self.views.iter().find(|view| view.id == id);
        view.map(|view| &view.body)
    }

    pub fn space(&self) -> Option<&Space> {
        let Body::Space(space) = &self.views.first()?.body else {
            return None;
        };
        Some(space)
    }

    /// Before what comes is asked, nothing shows that.
    pub fn hide_answer(&mut self) {
        for view in &mut self.views {
            if let Body::Multiples(multiples) = &mut view.body {
                let drawings = multiples.drawings.iter_mut();
                drawings.for_each(SmallDrawing::hide_answer);
            }
        }
    }

    /// What each of several methods costs is not shown.
    pub fn hide_costs(&mut self) {
        self.views
            .retain(|view| !matches!(view.body, Body::Costs(_)));
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

pub trait Shown {
    fn caption(&self) -> Caption;

    /// The same without the number that the step has in this run.
    fn unnumbered(&self) -> Caption {
        self.caption()
    }

    /// The values that are alive: none is marked as changed.
    fn watch(&self) -> Watch;
    fn views(&self) -> Vec<View>;

    fn decision(&self) -> Option<(Decides, Link)> {
        None
    }

    fn question(&self) -> Option<&'static str> {
        None
    }

    /// What might come at this step, and which of these does; none where the step answers no question.
    fn options(&self) -> Option<Choice> {
        None
    }

    /// The value of a name; none where it is not alive.
    fn named(&self, _name: &str) -> Option<Value> {
        None
    }

    fn listed(&self, _list: &str) -> Vec<Value> {
        Vec::new()
    }

    /// All names that the method knows, alive or not.
    fn names(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// All lists that the method knows.
    fn lists(&self) -> Vec<&'static str> {
        Vec::new()
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Decides {
    Nothing,
    Keeps,
    Cuts,
    Drops,
}

/// What is shown of an option before it is known whether it comes.
#[derive(Clone, PartialEq, Debug)]
pub enum Glimpse {
    Nothing,
    /// On the drawing, while the option is pointed at.
    Mark(Mark),
    /// A pixel and those around it, as they would be.
    Pixels(Raster),
}

#[derive(Clone, PartialEq, Debug)]
pub struct Choice {
    pub question: &'static str,
    pub options: Vec<Value>,
    /// What each is about, where that can be pointed at.
    pub links: Vec<Option<Link>>,
    pub glimpses: Vec<Glimpse>,
    pub right: usize,
    /// Do the steps since the last phase began lead to the answer?
    pub is_of_phase: bool,
}

/// An option on the picture: its digit at what it is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Chip {
    /// What it is about; none of an option that is nothing on the screen.
    pub link: Option<Link>,
    /// From 1 to 9.
    pub digit: usize,
    pub fate: ChipFate,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ChipFate {
    Open,
    Right,
    Wrong,
}

impl Choice {
    /// The chips of the first `most` options; once one is chosen, of that one and of the right one.
    pub fn chips(&self, chosen: Option<usize>, most: usize) -> Vec<Chip> {
        let fate = |nth: usize| match chosen {
            None => Some(ChipFate::Open),
            Some(_) if nth == self.right => Some(ChipFate::Right),
            Some(chosen) => (nth == chosen).then_some(ChipFate::Wrong),
        };
        let links = self.links.iter().take(most).enumerate();
        let chip = |(nth, link): (usize, &Option<Link>)| {
            Some(Chip {
                link: *link,
                digit: nth + 1,
                fate: fate(nth)?,
            })
        };
        links.filter_map(chip).collect()
    }

    /// Can more than one thing come?
    pub const fn is_open(&self) -> bool {
        self.options.len() > 1
    }

    /// What comes next, and what might.
    pub fn asked(&self, catalog: &Catalog) -> Message {
        Message::new("what-comes-next").with("options", self.said(catalog).join(" · "))
    }

    /// What might come, without full stops.
    pub fn said(&self, catalog: &Catalog) -> Vec<String> {
        let option = |option: &Value| {
            let option = catalog.value(option);
            option.trim_end_matches(['.', '。']).to_owned()
        };
        self.options.iter().map(option).collect()
    }
}
