//! The bytes of rendered spaces, as one number.

use clipscope::{
    figure::{Body, Lens, Seer, SolidMesh, SolidPicture, SolidScreen, Space, project},
    labs::{Document, frustum, space},
};

/// Of the FNV-1a hash.
const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

/// Both views of the frustum lab's first scene and of a street, at the end of the funnel: which facet is seen at each
/// sample and how far away, and every line as it is projected, hashed.
pub fn digest() -> u64 {
    let mut street = frustum::first_scene();
    street
        .set_objects(space::street(60, 3))
        .expect("not too many");
    let mut hash = OFFSET;
    for scene in [frustum::first_scene(), street] {
        let runs = scene.record();
        let run = runs.first().expect("a method is on stage");
        for view in run.frame(run.n_steps()).views {
            if let Body::Space(space) = view.body {
                add_space(&mut hash, &space);
            }
        }
    }
    hash
}

fn add_space(hash: &mut u64, space: &Space) {
    const SIZE: [u32; 2] = [320, 200];
    let lens = match space.seer {
        Seer::Eye(orbit) | Seer::Apart(orbit) => Lens::Eye(orbit),
        Seer::Camera(camera) => Lens::Camera(camera),
    };
    let mesh = SolidMesh::of(&space.facets);
    let part = [[-1.6, -1.0], [1.6, 1.0]];
    let screen = SolidScreen::new(&mesh, &lens, part, SIZE).expect("there is something to see");
    let picture = SolidPicture::new(&mesh, &screen);
    let n = (SIZE[0] * SIZE[1]) as usize;
    let (mut depths, mut facets) = (vec![1.0; n], vec![u32::MAX; n]);
    picture.draw_rows(0..SIZE[1], &mut depths, &mut facets, &mut []);
    add(hash, facets.iter().flat_map(|facet| facet.to_le_bytes()));
    add(hash, depths.iter().flat_map(|depth| depth.to_le_bytes()));
    // What a number prints is its every bit.
    add(hash, format!("{:?}", project(space, &lens)).into_bytes());
}

fn add(hash: &mut u64, bytes: impl IntoIterator<Item = u8>) {
    for byte in bytes {
        *hash = (*hash ^ u64::from(byte)).wrapping_mul(PRIME);
    }
}
