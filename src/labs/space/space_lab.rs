//! A lab in three dimensions.

use crate::{
    figure::{Link, Run},
    labs::{Lab, MethodCard, Verdict},
};

use super::{Method, MethodInfo, Scene};

/// A lab whose scenes are [`Scene`]s: what tells it from the others of its kind.
pub struct SpaceLab {
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
    pub methods: fn() -> &'static [MethodInfo],
    /// What it opens on where there is no lesson.
    pub first_scene: fn() -> Scene,
    /// Its verdict on what the method that runs has none on.
    pub verdict: fn(&Scene, Link, &dyn Run) -> Option<Verdict>,
}

impl SpaceLab {
    /// Its methods, in the order in which they are taught.
    pub fn all(&self) -> impl ExactSizeIterator<Item = Method> + use<> {
        (self.methods)().iter().map(Method::of)
    }

    /// The method with this id.
    #[must_use]
    pub fn method(&self, id: &str) -> Option<Method> {
        self.all().find(|method| method.card().id == id)
    }
}

impl Lab for SpaceLab {
    fn id(&self) -> &'static str {
        self.id
    }

    fn name_key(&self) -> &'static str {
        self.name_key
    }

    fn about_key(&self) -> &'static str {
        self.about_key
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        self.all().map(Method::card).collect()
    }

    fn first_scene(&self) -> crate::labs::Scene {
        (self.first_scene)().into()
    }

    /// Any scene in three dimensions.
    fn adopt(&self, scene: &crate::labs::Scene) -> Option<crate::labs::Scene> {
        let mut scene: Scene = scene.get::<Scene>()?.clone();
        (scene.method, scene.beside) = (self.all().next()?, Vec::new());
        Some(scene.into())
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        self.lock_groups
    }
}
