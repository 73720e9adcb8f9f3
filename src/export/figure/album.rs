//! What is recorded of the scenes of a lesson, which are drawn alike: views stand in one place, at one scale, over one
//! hairline, seen by one eye, as far as they can.

use std::cell::{OnceCell, RefCell};

use crate::{
    figure::{Eyes, Prospect, View},
    labs::Scene,
    lesson::Lesson,
    paint::ThemeKind,
    text::Lang,
};

use super::recorded::{Column, Recorded};

pub struct Album {
    pub scenes: Vec<Recorded>,
    /// Of each figure of the lesson its scene, and the step that is drawn.
    figures: Vec<(usize, usize)>,
    /// For all figures together.
    eyes: OnceCell<Eyes>,
    pub captions: Heights,
}

/// How high the highest sentence is, in a theme, a language and a width that have been asked for.
#[derive(Default)]
pub struct Heights(RefCell<Vec<(Kind, f32)>>);

type Kind = (ThemeKind, Lang, u32);

impl Heights {
    pub fn once(&self, kind: Kind, measured: impl FnOnce() -> f32) -> f32 {
        let known = self.0.borrow().iter().find(|(it, _)| *it == kind).copied();
        known.map_or_else(
            || {
                let height = measured();
                self.0.borrow_mut().push((kind, height));
                height
            },
            |(_, height)| height,
        )
    }
}

impl Album {
    /// One scene by itself, or all of a lesson.
    pub fn new(scene: &Scene, lesson: Option<&Lesson>) -> Self {
        let scenes = scenes(scene, lesson);
        let of = |scene: &&Scene| {
            let own = || scene.document().bounds();
            Recorded::new(
                scene,
                lesson.map_or_else(own, |lesson| lesson.bounds_of(scene)),
            )
        };
        let mut recorded: Vec<Recorded> = scenes.iter().map(of).collect();
        let wants: Vec<_> = recorded.iter().map(|it| it.needs.clone()).collect();
        for i in 0..recorded.len() {
            for j in (0..recorded.len()).filter(|&j| j != i) {
                if recorded[i].is_like(&recorded[j]) {
                    recorded[i].make_room(&wants[j]);
                }
            }
        }
        let steps = lesson.iter().flat_map(|lesson| &lesson.steps);
        let figures = steps
            .filter(|step| step.figure.is_some())
            .filter_map(|step| {
                let nth = scenes.iter().position(|&scene| *scene == *step.scene)?;
                Some((nth, step.position()?))
            });
        Self {
            figures: figures.collect(),
            scenes: recorded,
            eyes: OnceCell::new(),
            captions: Heights::default(),
        }
    }

    /// Has it what this scene of this lesson is drawn with?
    pub fn holds(&self, scene: &Scene, lesson: Option<&Lesson>) -> bool {
        let known = self.scenes.iter().map(|recorded| &recorded.scene);
        known.eq(scenes(scene, lesson))
    }

    pub fn recorded(&self, scene: &Scene) -> &Recorded {
        let found = self.scenes.iter().find(|it| it.scene == *scene);
        found.unwrap_or(&self.scenes[0])
    }

    /// Those that see all figures of the lesson, for whom they are enough.
    pub fn eyes(&self) -> &Eyes {
        self.eyes.get_or_init(|| {
            let mut prospect = Prospect::default();
            for recorded in &self.scenes {
                prospect.extend(&recorded.prospect);
            }
            let columns = |&(nth, step): &(usize, usize)| self.scenes[nth].columns(step, None);
            let columns: Vec<Column> = self.figures.iter().flat_map(columns).collect();
            let views: Vec<&[View]> = columns.iter().map(|it| &it.frame.views[..]).collect();
            prospect.eyes(&views, 1, None)
        })
    }
}

/// Those that a figure of this scene is drawn beside, in the lesson's order; the scene alone where it is in none.
fn scenes<'a>(scene: &'a Scene, lesson: Option<&'a Lesson>) -> Vec<&'a Scene> {
    let mut scenes: Vec<&Scene> = Vec::new();
    for step in lesson.iter().flat_map(|lesson| &lesson.steps) {
        if step.figure.is_some() && !scenes.contains(&&*step.scene) {
            scenes.push(&step.scene);
        }
    }
    if !scenes.contains(&scene) {
        scenes = vec![scene];
    }
    scenes
}
