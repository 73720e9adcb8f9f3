//! The two views that every method has: the observer's, and what the camera sees.

use std::sync::Arc;

use super::{
    super::{Object, Scene, Subject},
    FaceLook, Fate, Solids,
    crowd::{Crowd, MANY},
    ground::ground,
    prelude::*,
    volume::{flying, volume},
};

pub const OBSERVER_VIEW: &str = "observer";
pub const CAMERA_VIEW: &str = "camera";

/// Beyond so many objects their numbers only cover the picture.
const MOST_NUMBERED: usize = 24;

/// What stays the same through a run: what is drawn, and from where. Inputs carry it, so that a step knows its scene.
pub struct Scenery {
    scene: Scene,
    planes: [Plane; 6],
    crowd: Crowd,
}

impl Scenery {
    pub fn new(scene: &Scene) -> Self {
        Self {
            scene: scene.clone(),
            planes: scene.culler().planes_in_world(),
            crowd: Crowd::default(),
        }
    }

    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Of the camera's volume, in the world.
    pub const fn planes(&self) -> &[Plane; 6] {
        &self.planes
    }

    /// The observer's view: solids by their fates, and the step's own marks over them.
    pub fn observer(&self, fate: impl Fn(usize) -> Fate, own: Vec<Mark3>) -> View {
        self.observer_with(fate, |_, _| FaceLook::Whole, own)
    }

    /// The same with a look of their own for some faces.
    pub fn observer_with(
        &self,
        fate: impl Fn(usize) -> Fate,
        look: impl Fn(usize, usize) -> FaceLook,
        own: Vec<Mark3>,
    ) -> View {
        let mut marks = self.numbers();
        marks.extend(own);
        View::new(OBSERVER_VIEW, Body::Space(self.seen(&fate, &look, marks)))
    }

    /// What the observer sees, objects without their numbers.
    pub fn seen(
        &self,
        fate: &dyn Fn(usize) -> Fate,
        look: &dyn Fn(usize, usize) -> FaceLook,
        own: Vec<Mark3>,
    ) -> Space {
        let (facets, edges) = self.solids(fate, look, true);
        let mut marks = ground(&self.scene);
        let volume = volume(self.scene.culler()).into_iter();
        marks.extend(volume.filter(|mark| !is_named_by(&own, mark)));
        marks.extend(self.who_culls());
        marks.extend(own);
        Space {
            title: Some(self.title("view-observer", "view-observer-frozen")),
            seer: Seer::Eye(self.scene.eye),
            facets,
            edges,
            marks,
        }
    }

    /// What the camera sees of all that is not culled; where another one culls, its volume too, and what that cut off.
    pub fn camera(
        &self,
        fate: impl Fn(usize) -> Fate,
        look: impl Fn(usize, usize) -> FaceLook,
        marks: Vec<Mark3>,
    ) -> View {
        self.seen_by_camera(&fate, &look, marks)
    }

    fn seen_by_camera(
        &self,
        fate: &dyn Fn(usize) -> Fate,
        look: &dyn Fn(usize, usize) -> FaceLook,
        marks: Vec<Mark3>,
    ) -> View {
        let is_frozen = self.scene.frozen.is_some();
        let seen = |i: usize| match fate(i) {
            Fate::Cut if !is_frozen => Fate::Kept,
            other => other,
        };
        let (facets, edges) = self.solids(&seen, look, false);
        let frozen = self.scene.frozen.iter();
        let mut own: Vec<Mark3> = frozen.flat_map(|f| volume(f.camera())).collect();
        own.extend(marks);
        let space = Space {
            title: Some(self.title("view-camera", "view-camera-flying")),
            seer: Seer::Camera(*self.scene.camera.camera()),
            facets,
            edges,
            marks: own,
        };
        View::new(CAMERA_VIEW, Body::Space(space))
    }

    /// While one camera culls and another flies: the other's volume, and what each of them is.
    fn who_culls(&self) -> Vec<Mark3> {
        let (flies, Some(frozen)) = (self.scene.camera.camera(), &self.scene.frozen) else {
            return Vec::new();
        };
        let named = |camera: &Camera, role, key| {
            let name = Mark3::new(role, Shape3::Label(camera.position()));
            name.labelled(Value::Term(key))
        };
        let mut marks = flying(flies);
        marks.push(named(frozen.camera(), Role::Accent, "camera-that-culls"));
        let name = named(flies, Role::Soft, "camera-that-flies");
        marks.push(name.linked(Link::to("camera")));
        marks
    }

    fn title(&self, own: &'static str, frozen: &'static str) -> Value {
        Value::Term(if self.scene.frozen.is_some() {
            frozen
        } else {
            own
        })
    }

    fn solids(
        &self,
        fate: &dyn Fn(usize) -> Fate,
        look: &dyn Fn(usize, usize) -> FaceLook,
        is_observed: bool,
    ) -> (Facets, Arc<[Edge3]>) {
        let objects = Some(self.scene.objects()).filter(|_| self.scene.shows_objects());
        let objects = objects.unwrap_or_default();
        let fates: Vec<Fate> = (0..objects.len()).map(fate).collect();
        let is_there = |&i: &usize| is_observed || fates[i] != Fate::Culled;
        let n_faces = objects.iter().map(|it| it.model().mesh().faces().len());
        if n_faces.sum::<usize>() > MANY {
            let built = self.crowd.known(is_observed, &fates, || {
                let fate = |i: usize| match fates[i] {
                    Fate::Cut => Fate::Cut,
                    Fate::ToCome | Fate::Kept | Fate::Culled => Fate::ToCome,
                };
                let whole = |_, _| FaceLook::Whole;
                self.built(&mut (0..objects.len()), &fate, &whole, is_observed)
            });
            let fate = |i: usize| Some(i).filter(is_there).map(|i| fates[i]);
            return built.looking(&fate, look);
        }
        let mut shown = (0..objects.len()).filter(is_there);
        let (solids, _) = self.built(&mut shown, &|i| fates[i], look, is_observed);
        (solids.facets.into(), solids.edges.into())
    }

    /// Some of the objects and, for the observer, the cameras; of each facet of an object, which face it is of.
    fn built(
        &self,
        objects: &mut dyn Iterator<Item = usize>,
        fate: &dyn Fn(usize) -> Fate,
        look: &dyn Fn(usize, usize) -> FaceLook,
        is_observed: bool,
    ) -> (Solids, Vec<[usize; 2]>) {
        let mut solids = Solids::default();
        let mut faces = Vec::new();
        for i in objects {
            let object = &self.scene.objects()[i];
            let (look, link) = (|face| look(i, face), |face| self.link(i, face));
            let firsts = solids.object(object, &link, fate(i), &self.planes, &look);
            let there = firsts.iter().enumerate();
            for (face, first) in there.filter_map(|(face, &first)| Some((face, first?))) {
                faces.resize(first as usize, faces.last().copied().unwrap_or_default());
                faces.push([i, face]);
            }
            faces.resize(
                solids.facets.len(),
                faces.last().copied().unwrap_or_default(),
            );
        }
        if is_observed {
            let (size, own) = (self.glyph_size(), Link::to("camera"));
            if let Some(frozen) = &self.scene.frozen {
                solids.camera(frozen.camera(), size, Link::to("frozen camera"));
            }
            solids.camera(self.scene.camera.camera(), size, own);
        }
        (solids.settled(), faces)
    }

    /// What a face is about: itself where a method tells of faces, else its object.
    fn link(&self, object_idx: usize, face_idx: usize) -> Link {
        let mut on_stage = self.scene.on_stage();
        let tells_faces = on_stage.any(|method| method.info().tells_faces);
        if tells_faces && object_idx == self.scene.focus() {
            face_link(face_idx)
        } else {
            object_link(object_idx)
        }
    }

    /// A share of what the observer sees.
    fn glyph_size(&self) -> f64 {
        let eye = DVec3::from(self.scene.eye.position());
        let [position, ..] = self.scene.camera.places();
        0.022 * eye.distance(DVec3::from(position))
    }

    fn numbers(&self) -> Vec<Mark3> {
        let objects = self.scene.objects();
        if objects.len() > MOST_NUMBERED || !self.scene.shows_objects() {
            return Vec::new();
        }
        let number = |(i, object): (usize, &Object)| {
            let mark = Mark3::new(Role::Ink, Shape3::Label(label_place(object)?));
            let mark = mark
                .labelled(self.scene.object_name(i))
                .linked(object_link(i));
            // Among surfaces none is the one that is asked.
            let is_focused = i == self.scene.focus() && !self.scene.asks(Subject::Surfaces);
            Some(if is_focused { mark.strong() } else { mark })
        };
        objects.iter().enumerate().filter_map(number).collect()
    }
}

/// Whether a mark is a mere name, and one of these says it too.
fn is_named_by(own: &[Mark3], mark: &Mark3) -> bool {
    let is_name = matches!(mark.shape, Shape3::Label(_));
    let mut others = own.iter().filter_map(|mark| mark.label.as_ref());
    is_name && others.any(|label| Some(&label.text) == mark.label.as_ref().map(|label| &label.text))
}

/// Over an object; of one triangle, at its highest corner: its middle may lie behind another.
fn label_place(object: &Object) -> Option<[f64; 3]> {
    if let (1, Some(corners)) = (object.model().mesh().faces().len(), object.face(0)) {
        return corners.into_iter().max_by(|a, b| a[1].total_cmp(&b[1]));
    }
    let bounds = object.bounds().ok()?;
    let [min, max] = [bounds.min(), bounds.max()];
    Some([0.5 * (min[0] + max[0]), max[1], 0.5 * (min[2] + max[2])])
}

pub const fn face_link(face_idx: usize) -> Link {
    Link::nth("face", face_idx)
}

pub const fn vertex_link(vertex_idx: usize) -> Link {
    Link::nth("vertex", vertex_idx)
}

pub fn object_link(object_idx: usize) -> Link {
    Link::nth("object", object_idx)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        figure::Edging,
        labs::{frustum::first_scene, space::street},
    };

    type Shown = (Vec<[f64; 3]>, Role);

    fn shown(facets: &Facets) -> Vec<Shown> {
        let shown = facets.shown();
        shown.map(|(it, role)| (it.corners.clone(), role)).collect()
    }

    #[test]
    fn the_edges_of_an_object_are_drawn_whatever_stands_beside_it() {
        let mut scene = first_scene();
        let few = scene.objects()[3].clone();
        let mut objects = street(300, 1);
        objects.push(few);
        scene.set_objects(objects).expect("not too many");
        let scenery = Scenery::new(&scene);
        let (facets, edges) = scenery.solids(&|_| Fate::Culled, &|_, _| FaceLook::Whole, true);
        assert_eq!(edges.len(), 6, "of the tetrahedron");
        assert!(edges.iter().all(|edge| edge.role == Role::Discarded));
        let by_lines = facets.iter().filter(|it| it.edging == Edging::Lines);
        assert_eq!(
            by_lines.count(),
            4 + 6,
            "its facets and those of the camera"
        );
    }

    #[test]
    fn who_culls_and_who_flies_is_said() {
        let mut scene = first_scene();
        let names = |scene: &Scene| {
            let seen =
                Scenery::new(scene).seen(&|_| Fate::Kept, &|_, _| FaceLook::Whole, Vec::new());
            let labels = seen.marks.iter().filter_map(|mark| mark.label.as_ref());
            let names: Vec<Value> = labels.map(|label| label.text.clone()).collect();
            (seen.title, names)
        };
        let [culls, flies] = ["camera-that-culls", "camera-that-flies"].map(Value::Term);
        let (title, said) = names(&scene);
        assert_eq!(title, Some(Value::Term("view-observer")));
        assert!(!said.contains(&culls) && !said.contains(&flies));
        scene.frozen = Some(scene.camera);
        let (title, said) = names(&scene);
        assert_eq!(title, Some(Value::Term("view-observer-frozen")));
        assert!(said.contains(&culls) && said.contains(&flies));
    }

    #[test]
    fn very_many_faces_are_built_once_and_look_as_if_built_anew() {
        const FATES: [Fate; 4] = [Fate::ToCome, Fate::Kept, Fate::Cut, Fate::Culled];
        let mut scene = first_scene();
        let objects = street(MANY / 12 + 1, 1);
        scene.set_objects(objects).expect("not too many");
        let scenery = Scenery::new(&scene);
        let of_step = |step: usize| {
            let fate = move |i: usize| FATES[if i % 4 == 2 { 2 } else { (i + step) % 2 * 3 }];
            let look = move |i: usize, face: usize| match (i + 5 * face + step) % 7 {
                0 => FaceLook::Hidden,
                1 => FaceLook::Own(Role::Signal),
                _ => FaceLook::Whole,
            };
            (fate, look)
        };
        for is_observed in [true, false] {
            let mut before: Option<Facets> = None;
            for step in 0..3 {
                let (fate, look) = of_step(step);
                let (facets, edges) = scenery.solids(&fate, &look, is_observed);
                let there = |i: &usize| is_observed || fate(*i) != Fate::Culled;
                let mut there = (0..scene.objects().len()).filter(there);
                let (anew, _) = scenery.built(&mut there, &fate, &look, is_observed);
                assert_eq!(shown(&facets), shown(&anew.facets.into()));
                let lines = |edges: &[Edge3]| -> Vec<_> {
                    edges.iter().map(|edge| (edge.ends, edge.role)).collect()
                };
                assert_eq!(lines(&edges), lines(&anew.edges));
                let again = scenery.solids(&fate, &look, is_observed);
                assert_eq!(edges, again.1);
                let is_kept = |before: &Facets| before.are_shared_with(&facets);
                assert!(before.as_ref().is_none_or(is_kept), "step {step}");
                before = Some(facets);
            }
        }
    }
}
