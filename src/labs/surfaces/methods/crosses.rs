//! Pixels that are wrong, crossed and counted.

use crate::{
    algo::surface::{DepthBuffer, DepthBufferInput, Picture, Surfaces},
    labs::space::prelude::*,
};

use super::on_raster::{mark, middle_at};

/// What is painted, and what a triangle is called.
pub type Names<'a> = (&'a Picture, &'a dyn Fn(u32) -> Value);

/// With crosses on the pixels that are wrong, counted in the title. Where triangles have their `names`, these give way, and beside
/// each cross stands which triangle is seen there.
pub fn with_crosses(mut raster: Raster, names: Option<Names<'_>>, wrong: &[usize]) -> Raster {
    if wrong.is_empty() {
        return raster;
    }
    if let Some((picture, name)) = names {
        clear_of_names(&mut raster, picture, wrong);
        for &place in wrong {
            let seen = u32::try_from(picture.ids()[place]).ok();
            raster.pixels[place].value = seen.map(name);
        }
    }
    raster.title = Value::Message(Message::new("raster-wrong").with("count", wrong.len()));
    raster.bare = None;
    for &place in wrong {
        let at = middle_at(place, raster.size[0]);
        raster.over.push(mark(Role::Signal, RasterShape::Cross(at)));
        raster.pixels[place].role = raster.pixels[place].role.and(Some(Role::Signal));
    }
    raster
}

/// Names on these places and around them go to the nearest pixel of the same triangle that is free of them, where there is one.
fn clear_of_names(raster: &mut Raster, picture: &Picture, places: &[usize]) {
    let (ids, width) = (picture.ids(), raster.size[0]);
    let mut is_taken = vec![false; ids.len()];
    for &place in places {
        let (column, row) = (place % width, place / width);
        for row in row.saturating_sub(1)..=(row + 1).min(raster.size[1] - 1) {
            let [first, last] = [column.saturating_sub(1), (column + 1).min(width - 1)];
            is_taken[row * width + first..=row * width + last].fill(true);
        }
    }
    for place in (0..ids.len()).filter(|&place| is_taken[place]) {
        let Some(name) = raster.pixels[place].value.take() else {
            continue;
        };
        let square = |a: usize, b: usize| a.abs_diff(b).pow(2);
        let far = |other: &usize| {
            square(place % width, other % width) + square(place / width, other / width)
        };
        let is_free = |other: &usize| {
            let is_alike = ids[*other] == ids[place] && raster.pixels[*other].value.is_none();
            is_alike && !is_taken[*other]
        };
        let nearest = (0..ids.len()).filter(is_free).min_by_key(far);
        raster.pixels[nearest.unwrap_or(place)].value = Some(name);
    }
}

/// The pixels that show another surface than the one in front, by a depth buffer that rounds nothing.
pub fn wrong_pixels(surfaces: &Surfaces, picture: &Picture) -> Vec<usize> {
    let truth = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    differing(picture.ids(), truth.picture.ids())
}

/// Where what is shown is not the truth, in order.
pub fn differing<T: PartialEq>(shown: &[T], truth: &[T]) -> Vec<usize> {
    let is_wrong = |&place: &usize| shown[place] != truth[place];
    (0..shown.len()).filter(is_wrong).collect()
}
