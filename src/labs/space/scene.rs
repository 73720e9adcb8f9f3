//! What the labs in three dimensions work on: a camera, and what it may see; and what tells such a lab from the others.

use crate::{
    geom::{Camera, Orbit, SpaceError},
    labs::{self, Lab, MethodEntry, prelude::*},
    text::Diagnostic,
};

use super::{Object, Places, RasterPlan, Subject, TaughtCamera};

/// More objects than this are refused: a frame could not draw them in time.
pub const MAX_OBJECTS: usize = 10_000;

pub type Method = labs::Method<MethodInfo>;

/// What tells such a lab from the others of its kind; all have the same scenes.
pub struct SpaceLab {
    pub lab: Lab,
    /// So many methods have room beside another.
    pub most_beside: usize,
    pub methods: fn() -> &'static [MethodEntry<MethodInfo>],
    /// Its verdict on what the method that runs has none on.
    pub verdict: fn(&Scene, Link, AtStep<'_>) -> Option<Verdict>,
}

impl SpaceLab {
    pub fn all(&self) -> impl ExactSizeIterator<Item = Method> + use<> {
        (self.methods)().iter().map(Method::of)
    }

    /// Any scene in three dimensions, by its first method.
    pub(in crate::labs) fn adopted(&self, scene: &labs::Scene) -> Option<labs::Scene> {
        let mut scene = scene.get::<Scene>()?.clone();
        (scene.method, scene.beside) = (self.all().next()?, Vec::new());
        Some(scene.into())
    }

    pub fn method(&self, id: &str) -> Option<Method> {
        self.all().find(|method| method.card().id == id)
    }
}

pub struct MethodInfo {
    pub lab: &'static SpaceLab,
    /// Its card for a scene that changes its pseudocode.
    pub card_on: fn(&Scene) -> Option<&'static MethodCard>,
    pub subject: Subject,
    /// Can it say what became of a face of the object in focus?
    pub tells_faces: bool,
    /// A scene of more faces is refused.
    pub most_faces: usize,
    pub record: fn(&Scene) -> Box<dyn Run>,
    /// Where the method draws an end of the segment that lies at this place.
    pub drawn: fn(&Scene, [f64; 3]) -> [f64; 3],
    /// What decided the fate of something, in a run of it; none where only the lab knows.
    pub verdict: fn(&Scene, Link, &dyn Run) -> Option<Verdict>,
    /// Which triangle a pixel shows at a step, less than 0 for none; of a method that makes no picture nothing.
    pub shown_at: fn(&Scene, (usize, usize)) -> Option<i32>,
}

/// Always valid: at least one object, the focus is one of them, face and vertex are that object's.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    pub method: Method,
    pub beside: Vec<Method>,
    pub camera: TaughtCamera,
    /// Who culls in its place, so that the camera flies around what this one kept.
    pub frozen: Option<TaughtCamera>,
    pub eye: Orbit,
    pub raster: RasterPlan,
    places: Places,
    objects: Vec<Object>,
    focus: usize,
    face: usize,
    vertex: usize,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneError {
    NoObjects,
    TooManyObjects(usize),
    NoSuchPart {
        part: Part,
        idx: usize,
        count: usize,
    },
}

/// What a person looks at: an object, and of the one in focus a face and a vertex.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    Object,
    Face,
    Vertex,
}

impl From<SceneError> for Diagnostic {
    fn from(error: SceneError) -> Self {
        match error {
            SceneError::NoObjects => Self::new(Message::new("error-no-objects")),
            SceneError::TooManyObjects(count) => {
                let message = Message::new("error-too-many-objects").with("count", count);
                Self::new(message.with("limit", MAX_OBJECTS)).coded("too-large")
            }
            SceneError::NoSuchPart { part, idx, count } => {
                let (key, name) = match part {
                    Part::Object => ("error-no-such-object", "focus"),
                    Part::Face => ("error-no-such-face", "face"),
                    Part::Vertex => ("error-no-such-vertex", "vertex"),
                };
                let message = Message::new(key).with(name, idx.to_string());
                Self::new(message.with("count", count))
            }
        }
    }
}

impl Scene {
    /// A scene with these objects, the first in focus.
    ///
    /// # Errors
    /// [`SceneError`] where there is no object, or too many.
    pub fn new(
        method: Method,
        camera: TaughtCamera,
        eye: Orbit,
        objects: Vec<Object>,
    ) -> Result<Self, SceneError> {
        check(&objects)?;
        Ok(Self {
            method,
            beside: Vec::new(),
            camera,
            eye,
            frozen: None,
            places: Places::default(),
            raster: RasterPlan::default(),
            objects,
            focus: 0,
            face: 0,
            vertex: 0,
        })
    }

    /// At least one.
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }

    pub const fn focus(&self) -> usize {
        self.focus
    }

    pub fn focused(&self) -> &Object {
        &self.objects[self.focus]
    }

    pub const fn face(&self) -> usize {
        self.face
    }

    pub const fn vertex(&self) -> usize {
        self.vertex
    }

    pub fn culler(&self) -> &Camera {
        self.frozen.as_ref().unwrap_or(&self.camera).camera()
    }

    /// What is asked about besides objects.
    pub const fn places(&self) -> Places {
        self.places
    }

    /// Asks about other places.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]
    pub fn set_places(&mut self, places: Places) -> Result<(), SpaceError> {
        self.places = places.checked()?;
        Ok(())
    }

    /// So many there are to look at.
    pub fn count(&self, part: Part) -> usize {
        let mesh = self.focused().model().mesh();
        match part {
            Part::Object => self.objects.len(),
            Part::Face => mesh.faces().len(),
            Part::Vertex => mesh.positions().len(),
        }
    }

    /// Looks at another object, at its first face and vertex; or at another face or vertex of the object in focus.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPart`]
    pub fn look_at(&mut self, part: Part, idx: usize) -> Result<(), SceneError> {
        let count = self.count(part);
        if idx >= count {
            return Err(SceneError::NoSuchPart { part, idx, count });
        }
        match part {
            Part::Object => self.focus_on(idx),
            Part::Face => self.face = idx,
            Part::Vertex => self.vertex = idx,
        }
        Ok(())
    }

    pub(super) const fn looked_at(&self) -> [(Part, usize); 3] {
        [
            (Part::Object, self.focus),
            (Part::Face, self.face),
            (Part::Vertex, self.vertex),
        ]
    }

    /// The same scene, looked at as the other is, as far as it has such parts.
    #[must_use]
    pub(super) fn looking_as(&self, other: &Self) -> Self {
        let mut scene = self.clone();
        for (part, idx) in other.looked_at() {
            scene.look_at(part, idx).ok();
        }
        scene
    }

    const fn focus_on(&mut self, focus: usize) {
        (self.focus, self.face, self.vertex) = (focus, 0, 0);
    }

    /// Replaces an object; an index that is none is ignored.
    pub fn set_object(&mut self, object_idx: usize, object: Object) {
        if let Some(old) = self.objects.get_mut(object_idx) {
            let is_same = old.model() == object.model();
            *old = object;
            if object_idx == self.focus && !is_same {
                self.focus_on(object_idx);
            }
        }
    }

    /// Adds an object and puts it in focus.
    ///
    /// # Errors
    /// [`SceneError::TooManyObjects`]
    pub fn add_object(&mut self, object: Object) -> Result<(), SceneError> {
        if self.objects.len() >= MAX_OBJECTS {
            return Err(SceneError::TooManyObjects(self.objects.len() + 1));
        }
        self.objects.push(object);
        self.focus_on(self.objects.len() - 1);
        Ok(())
    }

    /// Takes an object out; the last one stays.
    pub fn remove_object(&mut self, object_idx: usize) {
        if self.objects.len() > 1 && object_idx < self.objects.len() {
            self.objects.remove(object_idx);
            self.focus_on(self.focus.min(self.objects.len() - 1));
        }
    }

    /// With the first of its objects only.
    pub fn alone(mut self) -> Self {
        self.objects.truncate(1);
        self.focus_on(0);
        self
    }

    /// Replaces all objects, the first in focus.
    ///
    /// # Errors
    /// [`SceneError`] where there is none, or too many.
    pub fn set_objects(&mut self, objects: Vec<Object>) -> Result<(), SceneError> {
        check(&objects)?;
        self.objects = objects;
        self.focus_on(0);
        Ok(())
    }
}

const fn check(objects: &[Object]) -> Result<(), SceneError> {
    match objects.len() {
        0 => Err(SceneError::NoObjects),
        1..=MAX_OBJECTS => Ok(()),
        n => Err(SceneError::TooManyObjects(n)),
    }
}
