//! What is recorded of the scenes of a lesson, which are drawn alike: views stand in one place, at one scale, over one
//! hairline, seen by one eye, as far as they can.

mod recorded;

use std::cell::{OnceCell, RefCell};

use egui::Painter;

use crate::{
    figure::{Eyes, Prospect, View},
    labs::Scene,
    lesson::{Lesson, LessonStep},
    paint::{Look, ThemeKind},
    text::Lang,
};

use super::caption::height_for_all;

pub use recorded::{Column, Recorded, wanted};

/// What scenes are recorded for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Medium {
    Page,
    Window,
}

pub struct Album {
    pub scenes: Vec<Recorded>,
    /// Of each figure of the lesson its scene, and the step that is drawn.
    figures: Vec<(usize, usize)>,
    /// For all figures together.
    eyes: OnceCell<Eyes>,
    captions: Heights,
}

/// How high the highest sentence is, in a theme, a language, a width and a size of text that have been asked for.
#[derive(Default)]
struct Heights(RefCell<Vec<(Kind, f32)>>);

type Kind = (ThemeKind, Lang, [u32; 2]);

impl Heights {
    fn once(&self, kind: Kind, measured: impl FnOnce() -> f32) -> f32 {
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
    pub fn new(scene: &Scene, lesson: Option<&Lesson>, medium: Medium) -> Self {
        let scenes = scenes(scene, lesson);
        let of = |scene: &&Scene| {
            let own = || scene.document().frame();
            let bounds = lesson.map_or_else(own, |lesson| lesson.bounds_of(scene));
            Recorded::new(scene, bounds, medium)
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
            .flat_map(LessonStep::shown)
            .filter_map(|stop| {
                let nth = scenes.iter().position(|&scene| *scene == *stop.scene)?;
                Some((nth, stop.position()?))
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

    pub fn find(&self, scene: &Scene) -> Option<&Recorded> {
        self.scenes.iter().find(|it| it.scene == *scene)
    }

    /// Of this scene, which is one of them.
    pub fn recorded(&self, scene: &Scene) -> &Recorded {
        self.find(scene).unwrap_or(&self.scenes[0])
    }

    /// How high a sentence is, in lines of this width, with room for each of the lesson's.
    pub fn caption_height(&self, painter: &Painter, look: Look<'_>, width: f32) -> f32 {
        let sizes = [width, look.theme.text_scale].map(f32::to_bits);
        let kind = (look.theme.kind, look.catalog.lang(), sizes);
        let height = |recorded: &Recorded| {
            let catalog = look.catalog.alike(recorded.notation);
            let look = Look { catalog, ..look };
            height_for_all(painter, look, recorded.sentences(), width)
        };
        let highest = || self.scenes.iter().map(height).fold(0.0, f32::max);
        self.captions.once(kind, highest)
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
        let shown = step.shown().map(|stop| &*stop.scene);
        for scene in [&*step.scene].into_iter().chain(shown) {
            if step.figure.is_some() && !scenes.contains(&scene) {
                scenes.push(scene);
            }
        }
    }
    if !scenes.contains(&scene) {
        scenes = vec![scene];
    }
    scenes
}
