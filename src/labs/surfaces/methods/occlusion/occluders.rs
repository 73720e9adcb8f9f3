//! Which objects of a scene hide the others: the third of those in the picture that cover the most pixels, each alone.

use std::cmp::Reverse;

use crate::{
    algo::surface::{OcclusionObject, Picture, Surfaces},
    labs::space::Scene,
};

/// A longer run cannot be followed.
const MOST_OBJECTS: usize = 300;

pub fn objects_of(scene: &Scene, surfaces: &Surfaces) -> Vec<OcclusionObject> {
    let objects = scene.objects().iter().take(MOST_OBJECTS);
    let counts = objects.map(|object| object.model().mesh().faces().len());
    with_occluders(surfaces, counts)
}

pub fn with_occluders(
    surfaces: &Surfaces,
    counts: impl Iterator<Item = usize>,
) -> Vec<OcclusionObject> {
    let mut first = 0;
    let mut objects: Vec<OcclusionObject> = counts
        .map(|count| {
            let n_triangles = count as u32;
            let object = OcclusionObject {
                first,
                n_triangles,
                is_occluder: false,
            };
            first += n_triangles;
            object
        })
        .collect();
    let mut picture = Picture::empty(surfaces.size());
    let covered = |object: &OcclusionObject| {
        let ids = object.first..object.first + object.n_triangles;
        surfaces.n_covered_by_all(ids, &mut picture)
    };
    let covers = objects.iter().map(covered).enumerate();
    let mut in_picture: Vec<(usize, usize)> = covers.filter(|(_, covers)| *covers > 0).collect();
    // Of two that cover as many the first.
    in_picture.sort_by_key(|(_, covers)| Reverse(*covers));
    in_picture.truncate(in_picture.len().div_ceil(3));
    for (object_idx, _) in in_picture {
        objects[object_idx].is_occluder = true;
    }
    objects
}
