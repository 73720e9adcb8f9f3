//! Where a run stands, as a link; and a link, as where that is.

use crate::{
    figure::Moment,
    labs::Scene,
    lesson::{Course, Lesson, LessonStep, Problem, SceneFormats, Severity, stop::moment_in},
    text::{Diagnostic, Message},
};

use super::{
    address::{Link, Opens, StepName},
    error::LinkError,
};

/// A scene, and where its run stands.
#[derive(Clone, Copy, Debug)]
pub struct Stand<'a> {
    pub scene: &'a Scene,
    pub position: usize,
    pub moment: &'a Moment,
    /// On the page of which step of the course, if of one.
    pub step: Option<(&'a Lesson, &'a LessonStep)>,
}

/// What a link opens.
#[derive(Clone, PartialEq, Debug)]
pub struct Opened {
    /// The indices of lesson and step; none for a free scene.
    pub page: Option<[usize; 2]>,
    pub scene: Scene,
    pub position: usize,
}

impl Stand<'_> {
    /// To a step of the course by its name, where the scene is that step's, but perhaps for the method beside.
    pub fn link(&self, formats: SceneFormats) -> Link {
        let scene = |step| {
            let text = formats.write(self.scene, self.moment);
            Link::to(Opens::Scene(text, step))
        };
        let Some((lesson, step)) = self.step else {
            return scene(None);
        };
        let name = StepName {
            lesson: lesson.id.clone(),
            step: Some(step.id.clone()),
        };
        let is_there = step.position() == Some(self.position)
            || (*self.moment == Moment::End && step.moment == Moment::End);
        let to_step = Link {
            at: (!is_there).then(|| self.moment.clone()),
            ..Link::to(Opens::Step(name.clone()))
        };
        if *step.scene == *self.scene {
            return to_step;
        }
        let methods = self.scene.document().methods();
        let beside = methods.get(1).map(|card| card.id);
        let mut compared = (*step.scene).clone();
        compared.document_mut().set_compare(beside);
        if compared == *self.scene {
            let beside = Some(beside.unwrap_or_default().to_owned());
            return Link { beside, ..to_step };
        }
        scene(Some(name))
    }
}

impl Course {
    /// # Errors
    /// What of the link means nothing here.
    pub fn open_link(&self, link: &Link, formats: SceneFormats) -> Result<Opened, Vec<Problem>> {
        let mut opened = match &link.opens {
            Opens::Step(name) => self.opened_step(name).map_err(said)?,
            Opens::Scene(text, of) => {
                let file = formats.read(NAME, text.as_bytes())?;
                let page = of.as_ref().and_then(|name| self.page_named(name).ok());
                let lab = file.scene.document().lab();
                Opened {
                    // A scene of a course that is not here is a free one.
                    page: page.filter(|&[lesson, _]| self.lessons[lesson].lab == lab.id),
                    scene: file.scene,
                    position: file.position,
                }
            }
        };
        if let Some(id) = &link.beside {
            let lab = opened.scene.document().lab();
            let is_known = (lab.methods)().iter().any(|card| card.id == id);
            if !is_known && !id.is_empty() {
                let (key, value) = ("beside", id.clone());
                return Err(said(LinkError::Value { key, value }));
            }
            let beside = Some(&**id).filter(|id| !id.is_empty());
            opened.scene.document_mut().set_compare(beside);
        }
        if let Some(at) = &link.at {
            opened.position = moment_in(&opened.scene, at).map_err(said)?;
        }
        Ok(opened)
    }

    fn page_named(&self, name: &StepName) -> Result<[usize; 2], Message> {
        let missing = |key| Message::new(key).with("name", name.to_string());
        let lesson_idx = self.lesson_index(&name.lesson);
        let lesson_idx = lesson_idx.ok_or_else(|| missing("problem-link-no-lesson"))?;
        let step_idx = match &name.step {
            None => Some(0),
            Some(step) => self.lessons[lesson_idx].step_index(step),
        };
        let step_idx = step_idx.ok_or_else(|| missing("problem-link-no-step"))?;
        Ok([lesson_idx, step_idx])
    }

    fn opened_step(&self, name: &StepName) -> Result<Opened, Message> {
        let page = self.page_named(name)?;
        let step = &self.lessons[page[0]].steps[page[1]];
        Ok(Opened {
            page: Some(page),
            scene: (*step.scene).clone(),
            position: step.opens_at(),
        })
    }
}

/// How mistakes name a link.
const NAME: &str = "#";

/// What is wrong with a link, as what is wrong with a file.
pub fn said(what: impl Into<Diagnostic>) -> Vec<Problem> {
    vec![Problem {
        file: NAME.to_owned(),
        place: None,
        severity: Severity::Error,
        what: what.into(),
    }]
}
