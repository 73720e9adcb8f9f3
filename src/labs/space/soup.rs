//! All faces of a scene as triangles in view space, and what they are called.

use std::{iter::repeat_n, ops::Range};

use crate::{
    algo::surface::{Picture, Surfaces, Tint},
    labs::{prelude::*, split_mix::SplitMix64},
};

use super::{Object, Scene, Tones, stage::object_link};

/// More faces than these are not drawn: the rest is left out.
const MOST_FACES: usize = 1_000_000;
/// Of more faces not each can be asked about each pixel.
pub const MOST_ASKED: usize = 20_000;

/// The faces of a scene, object after object, as its camera sees them with so many pixels.
///
/// # Panics
/// Never: a valid scene has finite vertices; sides are from 1 to [`Viewport::MAX_SIDE`](crate::algo::surface::Viewport::MAX_SIDE).
pub fn surfaces_of(scene: &Scene, size: [u32; 2]) -> Surfaces {
    let camera = scene.camera.camera();
    let view_from_world = camera.view_from_world();
    let faces = scene.objects().iter().flat_map(|object| {
        let points: Vec<[f64; 3]> = object
            .points()
            .map(|at| view_from_world.point(at))
            .collect();
        let faces = object.model().mesh().faces().iter();
        faces.map(move |face| face.map(|i| points[i as usize]))
    });
    let triangles: Vec<[[f64; 3]; 3]> = faces.take(MOST_FACES).collect();
    let culls_backs = scene.raster.culls_backs;
    let tints = tints(scene, triangles.len());
    let surfaces = Surfaces::new(size, *camera.volume(), triangles, culls_backs);
    let surfaces = surfaces.expect("finite vertices, and pixels");
    if tints.is_empty() {
        return surfaces;
    }
    surfaces.with_tints(tints).expect("one for each face")
}

/// Neighbours differ.
const BRIGHTNESS: [f64; 4] = [0.25, 0.75, 0.0, 0.5];

/// Of each of the first so many faces; none where all are opaque and nobody asks.
fn tints(scene: &Scene, n_faces: usize) -> Vec<Tint> {
    let objects = scene.objects().iter();
    let is_asked = scene.raster.tones == Tones::Brightness;
    if !is_asked && objects.clone().all(|object| object.opacity() == 1.0) {
        return Vec::new();
    }
    let of_object = |(object, brightness): (&Object, f64)| {
        let n_faces = object.model().mesh().faces().len();
        Tint::new(object.opacity(), brightness).map(|tint| repeat_n(tint, n_faces))
    };
    let tints = objects.zip(BRIGHTNESS.into_iter().cycle());
    tints
        .filter_map(of_object)
        .flatten()
        .take(n_faces)
        .collect()
}

pub fn surfaces_on_raster(scene: &Scene) -> Surfaces {
    surfaces_of(scene, scene.raster.size(scene.camera.aspect()))
}

/// At how many pixels some of the triangles are seen, if there are no others.
pub fn pixels_covered(surfaces: &Surfaces, ids: Range<usize>) -> usize {
    let ids = ids.start as u32..ids.end as u32;
    surfaces.n_covered_by_all(ids, &mut Picture::empty(surfaces.size()))
}

pub fn order(n_triangles: usize, shuffle: Option<u64>) -> Vec<u32> {
    let mut order: Vec<u32> = (0..).take(n_triangles).collect();
    if let Some(seed) = shuffle {
        let mut random = SplitMix64(seed);
        for i in (1..order.len()).rev() {
            order.swap(i, (random.unit() * (i + 1) as f64) as usize);
        }
    }
    order
}

/// The object that a triangle is a face of, and which of its faces it is.
pub fn place_of(scene: &Scene, id: u32) -> Option<[usize; 2]> {
    let mut face_idx = id as usize;
    for (object_idx, object) in scene.objects().iter().enumerate() {
        let n_faces = object.model().mesh().faces().len();
        if face_idx < n_faces {
            return Some([object_idx, face_idx]);
        }
        face_idx -= n_faces;
    }
    None
}

/// `A`, or of an object of several faces `A₇`; without a scene, its number.
pub fn surface_name(scene: Option<&Scene>, id: u32) -> Value {
    let Some((scene, [object_idx, face_idx])) =
        scene.and_then(|scene| Some((scene, place_of(scene, id)?)))
    else {
        return Value::Count(id as usize);
    };
    let object = scene.object_name(object_idx);
    if scene.objects()[object_idx].model().mesh().faces().len() == 1 {
        return object;
    }
    let face = subscript(face_idx + 1);
    Value::Name(match object {
        Value::Name(letter) => letter + &face,
        _ => format!("{}.{}", object_idx + 1, face_idx + 1),
    })
}

pub fn surface_link(scene: &Scene, id: u32) -> Option<Link> {
    let [object_idx, _] = place_of(scene, id)?;
    Some(object_link(object_idx))
}
