//! Spot, the cow that is shipped: by Keenan Crane, in the public domain.

use std::sync::{Arc, LazyLock};

use crate::text::Part;
use crate::{
    figure::Moment,
    geom::{Solid, Texture},
    labs::{
        Scene,
        space::{self, Model, NamedMesh, Picture},
    },
    lesson::{mesh_file::read_texture, read_obj},
};

use super::super::SceneFormats;

pub const ID: &str = "spot";

macro_rules! file {
    ($name:literal) => {{
        #[cfg(feature = "slim")]
        let bytes = Part::Spot.get($name);
        #[cfg(not(feature = "slim"))]
        let bytes: Option<&[u8]> = Some(include_bytes!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/assets/meshes/spot/",
            $name
        )));
        bytes
    }};
}

/// Its shape, and what is painted on it.
fn files() -> Option<[&'static [u8]; 2]> {
    Some([file!("spot.obj")?, file!("spot_texture.png")?])
}

/// Around the origin, between −1 and 1; what stands in for it until it has been fetched.
pub fn model() -> Model {
    static SPOT: LazyLock<Model> = LazyLock::new(|| {
        let read = || {
            let [shape, painted] = files()?;
            named(shape, Some(painted))
        };
        // A test reads it; a cube would be seen.
        read().unwrap_or(Model::Solid(Solid::Cube))
    });
    if Part::Spot.is_here() {
        SPOT.clone()
    } else {
        STAND_IN.clone()
    }
}

fn named(shape: &[u8], painted: Option<&'static [u8]>) -> Option<Model> {
    let mesh = read_obj(ID, shape).ok()?.mesh.fitted();
    Some(Model::Mesh(Arc::new(NamedMesh {
        name: ID.to_owned(),
        mesh,
        picture: painted.map(|file| Picture::later(|| decoded(file), file)),
    })))
}

/// What is painted on it; a test sees that it is no white.
fn decoded(file: &[u8]) -> Texture {
    let white = || Texture::new([1; 2], [[u8::MAX; 3]]).expect("one texel");
    read_texture(file).unwrap_or_else(white)
}

/// An octahedron, of no solid's making.
static STAND_IN: LazyLock<Model> = LazyLock::new(|| {
    const SHAPE: &[u8] = b"v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
        f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    named(SHAPE, None).unwrap_or(Model::Solid(Solid::Octahedron))
});

/// Is this what stands in for it?
pub fn stands_in(model: &Model) -> bool {
    match (model, &*STAND_IN) {
        (Model::Mesh(model), Model::Mesh(stand_in)) => Arc::ptr_eq(model, stand_in),
        (Model::Mesh(_) | Model::Solid(_), _) => false,
    }
}

/// Is there something in this scene that has yet to be fetched?
pub fn has_stand_in(scene: &Scene) -> bool {
    let space: Option<&space::Scene> = scene.get();
    space.is_some_and(|space| space.objects().iter().any(|it| stands_in(it.model())))
}

/// The scene with what has come since, where it has been waited for there.
pub fn without_stand_in(scene: &Scene, formats: SceneFormats) -> Option<Scene> {
    let text = has_stand_in(scene).then(|| formats.write(scene, &Moment::Start))?;
    Some(formats.read(ID, text.as_bytes()).ok()?.scene)
}
