//! What is recorded of a scene once, however many of its steps are drawn.

use crate::{
    figure::{
        Caption, Comparison, Eyes, Frame, Need, Prospect, Run, Stand, View, needs, said, sentences,
    },
    labs::{Difference, MethodCard, Scene, comparison},
    text::{Catalog, Lang, Message, Notation},
};

use super::Medium;

/// A scene with its runs, and what they want of a page.
pub struct Recorded {
    pub scene: Scene,
    pub runs: Vec<Box<dyn Run>>,
    pub needs: Vec<Vec<Need>>,
    /// What it shows of the plane.
    pub bounds: [[f64; 2]; 2],
    /// How the numbers of all its steps are written.
    pub notation: Notation,
    pub comparison: Comparison,
    pub prospect: Prospect,
    pub difference: Option<Difference>,
}

impl Recorded {
    pub fn new(scene: &Scene, bounds: [[f64; 2]; 2], medium: Medium) -> Self {
        let runs = scene.document().record();
        let all: Vec<&dyn Run> = runs.iter().map(|run| &**run).collect();
        let methods = scene.document().methods();
        let comparison = comparison(&methods, &all);
        let mut prospect = Prospect::default();
        let (wanted, notation) = wanted(all.iter().copied(), bounds, Some(&mut prospect));
        Self {
            scene: scene.clone(),
            bounds,
            needs: match medium {
                Medium::Page => comparison.needs_of_page(&wanted, &all),
                Medium::Window => comparison.needs(&wanted, &all),
            },
            notation,
            comparison,
            prospect,
            difference: Difference::between(&methods, &all),
            runs,
        }
    }

    /// All that its runs say, with each method by itself.
    pub fn sentences(&self) -> Vec<Caption> {
        self.runs.iter().flat_map(|run| sentences(&**run)).collect()
    }

    /// Do the same methods show the same place of the plane?
    pub fn is_like(&self, other: &Self) -> bool {
        let is_plane = self.scene.document().region().is_some();
        let [own, others] = [self, other].map(|it| it.scene.document().methods());
        let ids = |methods: Vec<&'static MethodCard>| methods.into_iter().map(|card| card.id);
        is_plane && ids(own).eq(ids(others)) && self.bounds == other.bounds
    }

    /// Each view gets the room that it wants in another scene.
    pub fn make_room(&mut self, wanted: &[Vec<Need>]) {
        for (own, more) in self.needs.iter_mut().zip(wanted) {
            for need in own {
                if let Some(more) = more.iter().find(|more| more.id == need.id) {
                    need.widen(more);
                }
            }
        }
    }

    /// Each method, at the step that stands beside this one of the first; or before the last question that has been answered by then.
    pub fn columns(&self, step_of_first: usize, asked_in: Option<Lang>) -> Vec<Column> {
        let methods = self.scene.document().methods().into_iter();
        let runs = self.runs.iter().map(|run| &**run);
        let columns = methods.zip(runs).enumerate();
        let column = |(i, (method, run)): (usize, (_, &dyn Run))| {
            let step = match i {
                0 => step_of_first,
                _ => run.beside(&*self.runs[0], step_of_first),
            };
            let asked = asked_in.and_then(|lang| Some((run.decision_by(step)?, lang)));
            let Some(((step, choice), lang)) = asked else {
                return Column::new(method, run, step);
            };
            let mut column = Column::new(method, run, run.asked_at(step, &choice));
            column.frame.hide_answer();
            column.frame.caption = Caption::new(choice.asked(Catalog::of(lang)));
            column
        };
        columns.map(column).collect()
    }

    /// What the views of these columns want of a page.
    pub fn needs_at(&self, columns: &[Column]) -> Vec<Vec<Need>> {
        let first = columns.first().map(|column| &column.frame);
        let at = |frame| self.comparison.needs_at(self.needs.clone(), frame);
        first.map_or_else(Vec::new, at)
    }

    /// What differs between this scene and another one, each with its first method: what it makes, or what it begins with where
    /// that is another, and the first other view that is not the same in the end.
    pub fn needs_beside(&self, other: &Self) -> Vec<Vec<Need>> {
        let ends = [self, other].map(|it| it.runs[0].frame(it.runs[0].n_steps()));
        let begins = [self, other].map(|it| it.runs[0].frame(0));
        let is_drawing = |need: &&Need| need.stand == Stand::Drawing;
        let is_another = |need: &&Need| {
            let [was, is] = begins.each_ref().map(|frame| frame.body(need.id));
            is_drawing(need) && was != is
        };
        let differs = |need: &&Need| {
            let [was, is] = ends.each_ref().map(|end| end.body(need.id));
            !need.is_drawing() && was != is
        };
        let needs = |it: &Self| {
            let needs = &it.needs[0];
            let made = needs.iter().find(is_another);
            let made = made.or_else(|| needs.iter().rfind(is_drawing));
            let shown = made.into_iter().chain(needs.iter().find(differs));
            shown.copied().collect()
        };
        vec![needs(self), needs(other)]
    }

    /// The columns that are drawn: one of all methods, where they show the same.
    pub fn drawn(&self, mut columns: Vec<Column>) -> Vec<Column> {
        let frames: Vec<Frame> = columns.iter().map(|column| column.frame.clone()).collect();
        let names: Vec<_> = columns.iter().map(|column| column.method.name()).collect();
        if let Some(frame) =
            (self.comparison).together(&frames, &names, columns.iter().all(Column::at_end))
        {
            columns.truncate(1);
            columns[0].frame = frame;
        }
        columns
    }

    /// Lets all columns be seen by the eyes that are found for their steps; of pictures that follow each other, by the same.
    pub fn turned(&self, columns: &mut [Column], of_all: bool, shared: &Eyes) -> Eyes {
        let shown = columns
            .iter()
            .map(|column| if of_all { &[] } else { &column.frame.views[..] });
        let shown: Vec<&[View]> = shown.collect();
        let eyes = self.prospect.eyes(&shown, shown.len(), Some(shared));
        for column in columns {
            eyes.turn(&mut column.frame.views);
        }
        eyes
    }
}

/// What the views of runs want that stand beside each other, and how the numbers of all of them are written; a prospect sees
/// them, too.
pub fn wanted<'r>(
    runs: impl Iterator<Item = &'r dyn Run>,
    bounds: [[f64; 2]; 2],
    mut prospect: Option<&mut Prospect>,
) -> (Vec<Vec<Need>>, Notation) {
    let mut notation = Notation::Own;
    let mut look = |views: &[View], caption: &Caption| {
        notation = notation.max(Notation::of(said(views, caption)));
        if let Some(prospect) = &mut prospect {
            prospect.add(views);
        }
    };
    let wanted = runs.map(|run| needs(run, bounds, &mut look)).collect();
    (wanted, notation)
}

pub struct Column {
    pub method: &'static MethodCard,
    pub frame: Frame,
    /// The step that is shown, and how many there are.
    step: [usize; 2],
    /// Could the method take the scene? What it has not done has no cost.
    pub has_run: bool,
}

impl Column {
    fn new(method: &'static MethodCard, run: &dyn Run, step: usize) -> Self {
        Self {
            method,
            frame: run.frame(step.min(run.n_steps())),
            step: [step.min(run.n_steps()), run.n_steps()],
            has_run: run.n_steps() > 0,
        }
    }

    pub const fn at_end(&self) -> bool {
        let [step, n_steps] = self.step;
        step >= n_steps
    }

    /// `step 9 of 21`: where it is not the end, two methods are not at the same of their steps.
    pub fn moment(&self, catalog: &Catalog) -> Option<String> {
        let [step, total] = self.step;
        let message = Message::new("transport-step").with("step", step);
        (!self.at_end()).then(|| catalog.message(&message.with("total", total)))
    }
}
