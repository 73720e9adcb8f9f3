//! What a lab is, what its scenes can do, and how they are changed: all that lessons, figures and the window ask.
//! A lab joins with one line in [`super::LABS`].

use std::{any::Any, fmt, sync::Arc};

use crate::{
    figure::{Caption, Link, Mark, Run, Shape},
    text::{Diagnostic, Message},
    trace::Counts,
};

use super::{Handle, MethodCard, Motion};

/// A kind of scene, and the methods that work on it.
pub struct Lab {
    /// As lesson files spell it.
    pub id: &'static str,
    pub name_key: &'static str,
    pub about_key: &'static str,
    /// Says that a method is recorded, and on how many of what its scenes are made of.
    pub recording_key: &'static str,
    /// In the order in which they are taught.
    pub methods: fn() -> Vec<&'static MethodCard>,
    /// What it opens on where there is no lesson.
    pub first_scene: fn() -> Scene,
    /// With as little in it as a scene can have.
    pub smallest_scene: fn() -> Scene,
    /// Groups of handles that a lesson can lock.
    pub lock_groups: &'static [&'static str],
    /// What can be set in the inspector, by the ids that a lesson's text leads there with: `section.control`.
    pub controls: fn() -> Vec<&'static str>,
    /// Another lab's scene as one of its own, by its first method, if it can be one.
    pub adopt: fn(&Scene) -> Option<Scene>,
    /// What can be drawn by clicking, in the order of the menu.
    pub outlines: &'static [OutlineKind],
}

impl fmt::Debug for Lab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id)
    }
}

impl PartialEq for Lab {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

pub trait Document: Plain + Backdrop + Draggable + Answers {
    fn lab(&self) -> &'static Lab;
    /// The methods on stage, from left to right: one, or several that are compared.
    fn methods(&self) -> Vec<&'static MethodCard>;
    /// Puts the method of this id first; an unknown one is ignored.
    fn set_method(&mut self, id: &str);
    /// Puts the method of this id beside the first, or none. Where several have room there, one that stands there already
    /// is taken away.
    fn set_compare(&mut self, id: Option<&str>);
    /// Records the runs of [`Document::methods`], in their order.
    fn record(&self) -> Vec<Box<dyn Run>>;
    /// A plainer method to compare costs with, where no other stands beside, and what it costs in all.
    fn baseline(&self) -> Option<(&'static MethodCard, Counts)> {
        None
    }
    /// Where the run is that of one of many: what the method in this column does for all of them, in a sentence.
    fn cost_of_all(&self, _column: usize) -> Option<Message> {
        None
    }
    fn takes(&self, _id: &str) -> bool {
        true
    }
    /// Of a scene that the first method refuses: what it is called that mends it, and the change.
    fn mended(&self) -> Option<(&'static str, Own)> {
        None
    }
    /// One more of what the lab has many of, after this handle's; the handle of the new one, if it has one. Where there is no room
    /// for more the scene is left as it was.
    fn add(&mut self, after: Option<Handle>) -> Result<Option<Handle>, Diagnostic>;
    /// One less: without this handle's. Where none can be spared the scene is left as it was.
    fn remove(&mut self, handle: Option<Handle>) -> Result<(), Diagnostic>;
    /// What a click beside all handles changes, if anything.
    fn click(&self, click: &Click<'_>) -> Option<Own>;
    /// What a click there would pick, to be lit before it.
    fn pointed(&self, _click: &Click<'_>) -> Option<Shape> {
        None
    }
    /// Is it the other scene, except for what is looked at where no run depends on that?
    fn is_like(&self, other: &Scene) -> bool {
        self.is_same(other.document())
    }
    /// How large it is, in segments or vertices.
    fn size(&self) -> usize;
}

pub trait Backdrop {
    /// What lies under the marks of the method in this column, at the end of its run or before.
    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark>;
    /// The world rectangle that holds the scene.
    fn bounds(&self) -> [[f64; 2]; 2];
    /// The one that a view shows at first: the scene, with what around it belongs to the picture.
    fn frame(&self) -> [[f64; 2]; 2] {
        self.bounds()
    }
    /// Where something is visible, in a scene of the plane that has such a place.
    fn region(&self) -> Option<[[f64; 2]; 2]> {
        None
    }
}

pub trait Draggable {
    /// What can be dragged, in the order in which Tab visits it.
    fn handles(&self) -> Vec<Handle>;
    /// What a handle is called here, for who reads and for screen readers.
    fn called(&self, handle: Handle) -> Message {
        handle.name()
    }
    /// Where a handle lies; `None` where the scene has no such handle.
    fn position(&self, handle: Handle) -> Option<[f64; 3]>;
    /// Where it is taken hold of: where it lies, unless what moves with it lies elsewhere.
    fn held_at(&self, handle: Handle) -> Option<[f64; 3]> {
        self.position(handle)
    }
    /// Moves a handle. Where the scene would not be valid it is left as it was.
    fn drag(&mut self, handle: Handle, to: [f64; 3]) -> Result<(), Diagnostic>;
    /// How it may move: as its kind does, unless that depends on the scene.
    fn motion(&self, handle: Handle) -> Motion {
        handle.kind().motion
    }
    /// The handle of what is drawn with this link: a press there takes hold of it, too.
    fn seized(&self, _: Link) -> Option<Handle> {
        None
    }
    /// The one number that a handle stands for, where that is no place: a plane's distance, say.
    fn measure(&self, _: Handle) -> Option<f64> {
        None
    }
    /// Gives it another. Where the scene would not be valid it is left as it was.
    fn set_measure(&mut self, _: Handle, _to: f64) -> Result<(), Diagnostic> {
        Ok(())
    }
}

/// A run, and the step of it that is shown.
pub type AtStep<'a> = (&'a dyn Run, usize);

pub trait Answers {
    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        click.link
    }
    /// What decided the fate of what is asked about, and what would turn it.
    ///
    /// The run is the first of [`Document::record`].
    fn verdict(&self, _about: Link, _now: AtStep<'_>) -> Option<Verdict> {
        None
    }
}

#[derive(Clone, Debug)]
pub struct Verdict {
    /// The test that decided it, with its numbers.
    pub why: Caption,
    /// What else is to be said of it; last, the least change that would turn it.
    pub notes: Vec<Message>,
    /// The step of the first run that says so, if one does.
    pub step: Option<usize>,
    /// A change of the scene that goes on from there, and what is said of it.
    pub offer: Option<(&'static str, Own)>,
}

/// What any document can do besides: it is copied, compared and printed. Nobody writes this by hand.
pub trait Plain: Any + fmt::Debug + Send + Sync {
    fn boxed(&self) -> Box<dyn Document>;
    fn is_same(&self, other: &dyn Document) -> bool;
}

impl<D: Document + Clone + PartialEq> Plain for D {
    fn boxed(&self) -> Box<dyn Document> {
        Box::new(self.clone())
    }

    fn is_same(&self, other: &dyn Document) -> bool {
        let other: &dyn Any = other;
        other.downcast_ref::<D>() == Some(self)
    }
}

pub struct Scene(Box<dyn Document>);

impl Scene {
    pub fn document(&self) -> &dyn Document {
        &*self.0
    }

    pub fn document_mut(&mut self) -> &mut dyn Document {
        &mut *self.0
    }

    /// What there is one of for each method, by the methods' ids.
    pub fn by_method<T>(&self, all: impl IntoIterator<Item = T>) -> Vec<(&'static str, T)> {
        let ids = self.document().methods().into_iter().map(|card| card.id);
        ids.zip(all).collect()
    }

    /// The document of a lab, if it is that lab's: for the lab's own rooms.
    pub fn get<D: Document>(&self) -> Option<&D> {
        let any: &dyn Any = &*self.0;
        any.downcast_ref()
    }

    pub fn get_mut<D: Document>(&mut self) -> Option<&mut D> {
        let any: &mut dyn Any = &mut *self.0;
        any.downcast_mut()
    }
}

impl<D: Document> From<D> for Scene {
    fn from(document: D) -> Self {
        Self(Box::new(document))
    }
}

impl Clone for Scene {
    fn clone(&self) -> Self {
        Self(self.0.boxed())
    }
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.0.is_same(other.document())
    }
}

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Click<'a> {
    pub at: [f64; 3],
    /// The point that it stands for: on the grid where handles keep to it.
    pub place: [f64; 3],
    /// What lies within this distance, in world units, is meant.
    pub reach: f64,
    /// The second of two, or with Ctrl held: puts something in.
    pub inserts: bool,
    /// Where in a camera's picture it is, if in one: x and y from −1 to 1, y up.
    pub picture: Option<[f64; 2]>,
    /// What is there is about this: the nearest mark, or the face of a solid.
    pub link: Option<Link>,
    pub locks: &'a [Lock],
}

/// A group of handles that a lesson step locks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lock(&'static str);

impl Lock {
    pub fn of(lab: &Lab, name: &str) -> Option<Self> {
        let mut groups = lab.lock_groups.iter();
        groups.find(|&&known| known == name).copied().map(Self)
    }

    pub fn holds(self, group: &str) -> bool {
        self.0 == group
    }

    pub fn any_holds(locks: &[Self], handle: Handle) -> bool {
        locks.iter().any(|lock| lock.holds(handle.group()))
    }
}

pub type Own = Arc<dyn Change>;

/// A change to a scene; [`ChangeOf`] is what a lab implements.
pub trait Change: fmt::Debug + Send + Sync {
    /// Makes it; the handle to select next, if any. On another lab's scene it changes nothing. Where the scene would not be
    /// valid it is left as it was.
    fn apply(&self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic>;
    /// Does it bring a scene that should be seen whole?
    fn brings_another(&self) -> bool;
}

pub trait ChangeOf: fmt::Debug + Send + Sync + 'static {
    type Of: Document;

    /// Makes it; the handle to select next, if any. Where the document would not be valid it is left as it was.
    fn make(&self, document: &mut Self::Of) -> Result<Option<Handle>, Diagnostic>;

    fn is_another(&self) -> bool {
        false
    }
}

impl<C: ChangeOf> Change for C {
    fn apply(&self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic> {
        scene
            .get_mut::<C::Of>()
            .map_or(Ok(None), |document| self.make(document))
    }

    fn brings_another(&self) -> bool {
        self.is_another()
    }
}

#[derive(Debug)]
pub struct OutlineKind {
    /// Catalogue key of what draws it: `action-draw-…`.
    pub name_key: &'static str,
    /// Catalogue key of what to do until it can be closed.
    pub hint_key: &'static str,
    /// Catalogue key of what it is.
    pub part_key: &'static str,
    /// Can a method on stage use it?
    pub is_of_use: fn(&Scene) -> bool,
    /// What it comes to once it encloses something.
    pub close: fn(&[[f64; 2]]) -> Option<Own>,
}

impl PartialEq for OutlineKind {
    fn eq(&self, other: &Self) -> bool {
        self.name_key == other.name_key
    }
}
