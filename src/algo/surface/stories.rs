//! What comes to pixels, asked of the depth buffer: every fragment in order, how many there are, and what they are when they are sorted.

use std::convert::Infallible;

use crate::{
    algo::ring::Right,
    trace::{Listening, Method, Told},
};

use super::{
    DepthBuffer, DepthBufferEvent, DepthBufferHeld, DepthBufferInput, DepthSteps, Fragment,
    SurfaceRules, Surfaces,
};

/// Every fragment that reaches a pixel, in order: one run, at this pixel only.
#[must_use]
pub fn pixel_story<L: SurfaceRules>(input: &DepthBufferInput, pixel: [u32; 2]) -> Vec<Fragment> {
    let mut story = Vec::new();
    each_fragment::<L>(input, Some(pixel), |fragment| story.push(fragment));
    story
}

/// How often each pixel is computed, row by row, by the first so many fragments of a run at all pixels.
#[must_use]
pub fn times_computed<L: SurfaceRules>(input: &DepthBufferInput, n_fragments: u64) -> Vec<u32> {
    let mut times = vec![0; input.surfaces.n_pixels()];
    let [width, _] = input.surfaces.size();
    let mut n_left = n_fragments;
    each_fragment::<L>(input, None, |fragment| {
        let [column, row] = fragment.pixel;
        if n_left > 0 {
            n_left -= 1;
            times[(row * width + column) as usize] += 1;
        }
    });
    times
}

fn each_fragment<L: SurfaceRules>(
    input: &DepthBufferInput,
    pixel: Option<[u32; 2]>,
    mut look: impl FnMut(Fragment),
) {
    let input = DepthBufferInput {
        pixel,
        steps: DepthSteps::Fragments,
        ..input.clone()
    };
    let mut listening = Listening(|_: &DepthBufferHeld, event| {
        if let DepthBufferEvent::Fragment { fragment, .. } = event {
            look(fragment);
        }
        Told::<Infallible>::Continue(())
    });
    let mut held = DepthBuffer::<L>::begin(&input);
    let Told::Continue(()) = DepthBuffer::<L>::run::<f64, _>(&input, &mut held, &mut listening);
}

impl Surfaces {
    /// The brightness of every pixel, row by row, where at each of them all surfaces are sorted by their depths there and painted from far
    /// to near: right also where no order serves all pixels. Of equal depths the lower id is nearer.
    #[must_use]
    pub fn sorted_brightness(&self) -> Vec<f64> {
        let mut picture = self.paper();
        let mut met = vec![Vec::new(); picture.len()];
        let [width, _] = self.size();
        if self.is_tinted() {
            each_fragment::<Right>(&DepthBufferInput::new(self.clone()), None, |it| {
                let [column, row] = it.pixel;
                met[(row * width + column) as usize].push((it.depth, it.id));
            });
        }
        for (there, mut met) in picture.iter_mut().zip(met) {
            met.sort_by(|(a, id_a), (b, id_b)| b.total_cmp(a).then(id_b.cmp(id_a)));
            for tint in met.iter().filter_map(|(_, id)| self.tint(*id)) {
                *there = tint.over::<f64>(*there);
            }
        }
        picture
    }
}
