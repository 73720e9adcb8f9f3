//! A lab in three dimensions, and what it knows of its methods.

use crate::{
    figure::{Link, Run},
    labs::{Carded, Method, MethodCard, Verdict},
};

use super::Subject;

/// What tells such a lab from the others of its kind; all have the same scenes, `S`.
pub struct SpaceLab<S: 'static> {
    /// As lesson files spell it.
    pub id: &'static str,
    /// Catalogue key of its name.
    pub name_key: &'static str,
    /// Catalogue key of what it is about.
    pub about_key: &'static str,
    /// Groups of handles that a lesson can lock.
    pub lock_groups: &'static [&'static str],
    /// So many methods have room beside another.
    pub most_beside: usize,
    /// Its methods, in the order in which they are taught.
    pub methods: fn() -> &'static [MethodInfo<S>],
    /// What it opens on where there is no lesson.
    pub first_scene: fn() -> S,
    /// Its verdict on what the method that runs has none on.
    pub verdict: fn(&S, Link, &dyn Run) -> Option<Verdict>,
}

impl<S> SpaceLab<S> {
    /// Its methods, in the order in which they are taught.
    pub fn all(&self) -> impl ExactSizeIterator<Item = Method<MethodInfo<S>>> + use<S> {
        (self.methods)().iter().map(Method::of)
    }

    /// The method with this id.
    #[must_use]
    pub fn method(&self, id: &str) -> Option<Method<MethodInfo<S>>> {
        self.all().find(|method| method.card().id == id)
    }
}

/// What is known of a method without running it.
pub struct MethodInfo<S: 'static> {
    /// Whose it is.
    pub lab: &'static SpaceLab<S>,
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// The same for a scene that changes its pseudocode.
    pub card_on: fn(&S) -> Option<&'static MethodCard>,
    /// What it is about.
    pub subject: Subject,
    /// Can it say what became of a face of the object in focus?
    pub tells_faces: bool,
    /// Runs it on a scene.
    pub record: fn(&S) -> Box<dyn Run>,
    /// What decided the fate of something, in a run of it; none where only the lab knows.
    pub verdict: fn(&S, Link, &dyn Run) -> Option<Verdict>,
}

impl<S> Carded for MethodInfo<S> {
    fn card(&self) -> &MethodCard {
        &self.card
    }
}
