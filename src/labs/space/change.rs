//! What a person can do to a scene, beyond what every lab knows.

use crate::{
    geom::AlignedBox,
    labs::{ChangeOf, Handle},
    text::Diagnostic,
};

use super::{Model, Object, Opening, Part, RasterPlan, Scene, controls, street::street};

#[derive(Clone, PartialEq, Debug)]
pub enum SpaceChange {
    LookAt(Part, usize),
    /// Gives a control, by its id, in this place another number.
    Set(&'static str, usize, f64),
    /// Goes on culling with the camera as it is now, while the camera itself flies on; or culls with the camera again.
    Freeze(bool),
    Raster(RasterPlan),
    /// Side by side, or through the eye: as much is seen of what the camera looks at.
    Parallel(bool),
    /// One more, in front of the camera, where none is.
    Add(Model),
    Street {
        count: usize,
        seed: u64,
    },
}

impl ChangeOf for SpaceChange {
    type Of = Scene;

    fn make(&self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic> {
        match self {
            &Self::LookAt(part, idx) => scene.look_at(part, idx)?,
            &Self::Set(id, place, to) => controls::set(scene, id, place, to)?,
            &Self::Freeze(is_frozen) => scene.frozen = is_frozen.then_some(scene.camera),
            &Self::Raster(plan) => scene.raster = plan,
            &Self::Parallel(is_parallel) => set_parallel(scene, is_parallel)?,
            Self::Add(model) => {
                let [_, target, _] = scene.camera.places();
                let object = Object::new(model.clone(), target, [0.0; 3], 1.0)?;
                scene.add_object(apart(scene, &object)?)?;
            }
            &Self::Street { count, seed } => scene.set_objects(street(count, seed))?,
        }
        Ok(None)
    }

    fn is_another(&self) -> bool {
        matches!(self, Self::Street { .. })
    }
}

/// At the distance of the target both see as much.
fn set_parallel(scene: &mut Scene, is_parallel: bool) -> Result<(), Diagnostic> {
    let camera = scene.camera;
    let [position, target, _] = camera.places().map(glam::DVec3::from);
    let distance = position.distance(target);
    let opening = match camera.opening() {
        Opening::FovY(degrees) if is_parallel => {
            Opening::Height(2.0 * distance * libm::tan(0.5 * degrees.to_radians()))
        }
        Opening::Height(height) if !is_parallel => {
            Opening::FovY(2.0 * libm::atan(0.5 * height / distance).to_degrees())
        }
        as_it_is => as_it_is,
    };
    scene.camera = camera.with(|it| it.opening = opening)?;
    Ok(())
}

/// One like the object in focus, beside it.
pub fn beside(scene: &Scene) -> Result<Object, Diagnostic> {
    apart(scene, scene.focused())
}

/// Between neighbours: this part of how long the new one is.
const GAP: f64 = 0.25;

/// An object where it is, or, where its box would meet another one's, beside them: to the right or to the left, where it is nearer.
fn apart(scene: &Scene, object: &Object) -> Result<Object, Diagnostic> {
    let others = scene.objects().iter().map(Object::bounds);
    let others = others.collect::<Result<Vec<_>, _>>()?;
    let bounds = object.bounds()?;
    let (min, max) = (bounds.min(), bounds.max());
    let longest = (0..3).map(|i| max[i] - min[i]).fold(0.0, f64::max);
    let gap = GAP * if longest > 0.0 { longest } else { 1.0 };
    // By how far to go: each time past one of them, for good.
    let shift = |to_right: bool| {
        others.iter().fold(0.0, |by, _| {
            let meets = |other: &&AlignedBox| {
                let by = [by, 0.0, 0.0];
                let has_room =
                    |i: usize| min[i] + by[i] > other.max()[i] || max[i] + by[i] < other.min()[i];
                !(0..3).any(has_room)
            };
            match others.iter().find(meets) {
                Some(other) if to_right => other.max()[0] + gap - min[0],
                Some(other) => other.min()[0] - gap - max[0],
                None => by,
            }
        })
    };
    let (right, left) = (shift(true), shift(false));
    let by = if right <= -left { right } else { left };
    let [x, y, z] = object.at();
    // Sums of a few numbers: a file is to say −0.8 and not what rounding made of it.
    let x = ((x + by) * 1e9).round() / 1e9;
    Ok(object.moved([x, y, z])?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{geom::Solid, labs::frustum};

    #[test]
    fn what_is_added_stands_beside_all_that_is_there() {
        let scene = (frustum::LAB.first_scene)();
        let mut scene = scene.get::<Scene>().expect("a scene in space").clone();
        let n_before = scene.objects().len();
        for solid in [Solid::Cube, Solid::Sphere, Solid::Torus].repeat(4) {
            let add = SpaceChange::Add(Model::Solid(solid));
            add.make(&mut scene).expect("there is room");
            let twin = beside(&scene).expect("there is room");
            scene.add_object(twin).expect("there is room");
        }
        let spelt = |object: &Object| object.at()[0].to_string();
        assert!(scene.objects().iter().all(|it| spelt(it).len() < 15));
        let bounds = scene
            .objects()
            .iter()
            .map(|it| it.bounds().expect("finite"));
        let bounds: Vec<AlignedBox> = bounds.collect();
        for (i, new) in bounds.iter().enumerate().skip(n_before) {
            for old in &bounds[..i] {
                let is_apart = |axis: usize| {
                    new.min()[axis] > old.max()[axis] || new.max()[axis] < old.min()[axis]
                };
                assert!((0..3).any(is_apart), "{i}: {new:?} meets {old:?}");
            }
        }
    }
}
