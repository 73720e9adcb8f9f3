//! Spot, the cow that is shipped: by Keenan Crane, in the public domain.

use std::sync::{Arc, LazyLock};

use crate::{
    geom::Solid,
    labs::space::{Model, NamedMesh},
    lesson::{read_obj, read_picture},
};

pub const ID: &str = "spot";

/// Around the origin, between −1 and 1.
pub fn model() -> Model {
    static SPOT: LazyLock<Model> = LazyLock::new(|| {
        let bytes = include_bytes!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/assets/meshes/spot/spot.obj"
        ));
        // A test reads it; a cube would be seen.
        read_obj(ID, bytes).map_or(Model::Solid(Solid::Cube), |read| {
            let mesh = read.mesh.fitted();
            let name = ID.to_owned();
            let painted = include_bytes!(concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/assets/meshes/spot/spot_texture.png"
            ));
            Model::Mesh(Arc::new(NamedMesh {
                name,
                mesh,
                picture: read_picture(painted),
            }))
        })
    });
    SPOT.clone()
}
