//! Where one triangle hides another, and by how much.

use crate::algo::surface::{DepthBuffer, DepthBufferInput, DepthSteps};

use super::super::prelude::*;

/// Of more triangles the reasons are not looked for: their names only are seen.
const MOST_WITH_REASONS: usize = 26;

pub struct Overlap {
    pub at: [f64; 2],
    /// How far both are there, the farther first.
    pub depths: [f64; 2],
}

/// Of the pixels at which the first is farther than the second, the one in their middle; none where no pixel shows it.
pub fn overlap(surfaces: &Surfaces, ends: [u32; 2]) -> Option<Overlap> {
    let n = surfaces.triangles().len();
    if n > MOST_WITH_REASONS {
        return None;
    }
    let depths = ends.map(|id| {
        let alone = surfaces.part(id as usize..id as usize + 1);
        silent::<DepthBuffer>(&DepthBufferInput {
            steps: DepthSteps::Triangles,
            ..DepthBufferInput::new(alone)
        })
        .depth
    });
    let pixels = depths[0].iter().zip(&depths[1]).enumerate();
    let hidden = pixels.filter(|(_, (far, near))| far.is_finite() && far > near);
    let hidden: Vec<usize> = hidden.map(|(place, _)| place).collect();
    let width = surfaces.size()[0] as usize;
    let place = middle(&hidden, width)?;
    let rays = Rays::of(surfaces);
    Some(Overlap {
        at: [place % width, place / width].map(|x| x as f64 + 0.5),
        depths: depths.map(|depths| rays.distance(rays.t_at(depths[place]))),
    })
}
