//! What a scene shows, and how it is changed.

use std::sync::Arc;

use crate::{
    labs::{self, Answers, Backdrop, Click, Document, Handle, Lab, Own, prelude::*},
    text::{Diagnostic, Message},
};

use super::{
    Method, Part, Scene, SpaceChange, Subject,
    change::beside,
    pixel::pixel_link,
    stage::{face_link, object_link, vertex_link},
};

impl Scene {
    pub(in crate::labs) fn on_stage(&self) -> impl Iterator<Item = Method> {
        std::iter::once(self.method).chain(self.beside.iter().copied())
    }

    fn sibling(&self, id: &str) -> Option<Method> {
        self.method.info().lab.method(id)
    }

    pub fn asks(&self, subject: Subject) -> bool {
        self.on_stage()
            .any(|method| method.info().subject == subject)
    }

    /// What an object is called: by its number, or among surfaces by its letter.
    pub(in crate::labs) fn object_name(&self, object_idx: usize) -> Value {
        let letter = u8::try_from(object_idx)
            .ok()
            .and_then(|i| b'A'.checked_add(i));
        match letter.filter(u8::is_ascii_uppercase) {
            Some(letter) if self.asks(Subject::Surfaces) => {
                Value::Name(char::from(letter).to_string())
            }
            _ => Value::Count(object_idx + 1),
        }
    }

    pub fn shows_objects(&self) -> bool {
        let mut on_stage = self.on_stage();
        on_stage.any(|method| method.info().subject.shows_objects())
    }

    pub(in crate::labs) fn shows_camera(&self) -> bool {
        let mut on_stage = self.on_stage();
        on_stage.any(|method| method.info().subject.shows_camera())
    }
}

impl Backdrop for Scene {
    /// Everything is in the views: what is seen depends on the step.
    fn backdrop(&self, _: usize, _: bool) -> Vec<Mark> {
        Vec::new()
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        [[-1.0; 2], [1.0; 2]]
    }
}

impl Answers for Scene {
    /// In the camera's picture, about the pixel; elsewhere about what is there.
    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        click.picture.map(|at| pixel_link(self, at)).or(click.link)
    }

    fn verdict(&self, about: Link, now: AtStep<'_>) -> Option<Verdict> {
        let info = self.method.info();
        (info.verdict)(self, about, now.0).or_else(|| (info.lab.verdict)(self, about, now))
    }
}

impl Document for Scene {
    fn lab(&self) -> &'static Lab {
        &self.method.info().lab.lab
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        let card = |method: Method| (method.info().card_on)(self).unwrap_or(method.card());
        self.on_stage().map(card).collect()
    }

    fn set_method(&mut self, id: &str) {
        if let Some(method) = self.sibling(id) {
            self.method = method;
            self.beside.retain(|&other| other != method);
        }
    }

    fn set_compare(&mut self, id: Option<&str>) {
        let Some(method) = id.and_then(|id| self.sibling(id)) else {
            self.beside.clear();
            return;
        };
        let n_before = self.beside.len();
        let most = self.method.info().lab.most_beside;
        if most > 1 {
            self.beside.retain(|&other| other != method);
        }
        if self.beside.len() == n_before {
            self.beside.truncate(most - 1);
            self.beside.push(method);
        }
    }

    fn record(&self) -> Vec<Box<dyn Run>> {
        let record = |method: Method| (method.info().record)(self);
        self.on_stage().map(record).collect()
    }

    fn takes(&self, id: &str) -> bool {
        let method = self.sibling(id);
        method.is_some_and(|method| self.size() <= method.info().most_faces)
    }

    fn add(&mut self, _after: Option<Handle>) -> Result<Option<Handle>, Diagnostic> {
        if !self.shows_objects() {
            return Err(Diagnostic::new(Message::new("objects-not-drawn")));
        }
        self.add_object(beside(self)?)?;
        Ok(None)
    }

    fn remove(&mut self, _handle: Option<Handle>) -> Result<(), Diagnostic> {
        self.remove_object(self.focus());
        Ok(())
    }

    fn click(&self, click: &Click<'_>) -> Option<Own> {
        let clicked = click.link?;
        let found = |part, link: fn(usize) -> Link| {
            let idx = (0..self.count(part)).find(|&i| clicked == link(i))?;
            Some((part, idx))
        };
        let vertex = || found(Part::Vertex, vertex_link);
        let face = || found(Part::Face, face_link);
        let (part, idx) = found(Part::Object, object_link)
            .or_else(vertex)
            .or_else(face)?;
        let now = [self.focus(), self.face(), self.vertex()][part as usize];
        (idx != now).then(|| -> Own { Arc::new(SpaceChange::LookAt(part, idx)) })
    }

    fn is_like(&self, other: &labs::Scene) -> bool {
        let Some(other) = other.get::<Self>() else {
            return false;
        };
        let mut on_stage = self.on_stage();
        let depends = on_stage.any(|method| method.info().subject.is_looked_at());
        if depends || self.looked_at() == other.looked_at() {
            self == other
        } else {
            *self == other.looking_as(self)
        }
    }

    fn size(&self) -> usize {
        let faces = |object: &super::Object| object.model().mesh().faces().len();
        self.objects().iter().map(faces).sum()
    }
}
