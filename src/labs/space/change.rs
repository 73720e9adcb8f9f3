//! What a person can do to a scene, beyond what every lab knows.

use crate::{
    labs::{ChangeOf, Handle},
    text::Diagnostic,
};

use super::{Model, Object, Opening, Part, RasterPlan, Scene, street::street};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CameraNumber {
    /// The angle from bottom to top in degrees, or of a parallel camera the height.
    Opening,
    /// Width over height.
    Aspect,
    Near,
    Far,
}

#[derive(Clone, PartialEq, Debug)]
pub enum SpaceChange {
    LookAt(Part, usize),
    Camera(CameraNumber, f64),
    /// Goes on culling with the camera as it is now, while the camera itself flies on; or culls with the camera again.
    Freeze(bool),
    Raster(RasterPlan),
    /// Side by side, or through the eye: as much is seen of what the camera looks at.
    Parallel(bool),
    /// One more, in front of the camera.
    Add(Model),
    /// Turns the object in focus, in degrees.
    Turn([f64; 3]),
    /// Makes the object in focus so much larger than its model.
    Size(f64),
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
            &Self::Camera(number, value) => set_number(scene, number, value)?,
            &Self::Freeze(is_frozen) => scene.frozen = is_frozen.then_some(scene.camera),
            &Self::Raster(plan) => scene.raster = plan,
            &Self::Parallel(is_parallel) => set_parallel(scene, is_parallel)?,
            Self::Add(model) => {
                let [_, target, _] = scene.camera.places();
                scene.add_object(Object::new(model.clone(), target, [0.0; 3], 1.0)?)?;
            }
            &Self::Turn(turn_deg) => reshape(scene, turn_deg, scene.focused().size())?,
            &Self::Size(size) => reshape(scene, scene.focused().turn_deg(), size)?,
            &Self::Street { count, seed } => scene.set_objects(street(count, seed))?,
        }
        Ok(None)
    }

    fn is_another(&self) -> bool {
        matches!(self, Self::Street { .. })
    }
}

fn reshape(scene: &mut Scene, turn_deg: [f64; 3], size: f64) -> Result<(), Diagnostic> {
    let old = scene.focused();
    let object = Object::new(old.model().clone(), old.at(), turn_deg, size)?;
    scene.set_object(scene.focus(), object);
    Ok(())
}

fn set_number(scene: &mut Scene, number: CameraNumber, value: f64) -> Result<(), Diagnostic> {
    scene.camera = scene.camera.with(|it| match (number, it.opening) {
        (CameraNumber::Opening, Opening::FovY(_)) => it.opening = Opening::FovY(value),
        (CameraNumber::Opening, Opening::Height(_)) => it.opening = Opening::Height(value),
        (CameraNumber::Aspect, _) => it.aspect = value,
        (CameraNumber::Near, _) => it.depths[0] = value,
        (CameraNumber::Far, _) => it.depths[1] = value,
    })?;
    Ok(())
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

/// One like the object in focus, a little to its right.
pub fn beside(scene: &Scene) -> Result<Object, Diagnostic> {
    let focused = scene.focused();
    let [x, y, z] = focused.at();
    Ok(focused.moved([x + 2.5 * focused.size(), y, z])?)
}
