//! The samples of a picture of solids, averaged to pixels.

use std::{ops::Range, sync::Mutex, thread};

use egui::Color32;

use crate::figure::SolidPicture;

use super::solid_outlines::{Lined, NONE, Seen, outlines};

/// Fewer samples are drawn sooner by one thread.
const FEW: usize = 100_000;
const FEW_TRIANGLES: usize = 5_000;
const ROWS_AT_ONCE: u32 = 24;
/// More threads have too little to do.
const MOST_THREADS: usize = 4;

/// Pixels beside each other that are looked at together, if anything is seen in them.
const BLOCK: usize = 32;
pub const FINE: usize = 2;

/// Rows of pixels, and what is seen in their samples.
pub struct Band {
    rows: Range<u32>,
    seen: Seen,
}

pub struct Samples<'a> {
    pub tones: &'a [Color32],
    /// Of lines that are found between facets, where there are any.
    pub outline: Option<(Color32, Lined<'a>)>,
    pub size: [u32; 2],
    pub fine: u32,
}

impl Samples<'_> {
    /// On pixels that are clear; each thread takes the next few rows, so that none waits for one that is late. Gives back what
    /// is seen where that took long to find, and how facets look has no say in it.
    pub fn draw(&self, picture: &SolidPicture, pixels: &mut [Color32]) -> Vec<Band> {
        let [width, height] = self.size;
        let seen = picture.rows();
        // An outline reaches a sample further.
        let first = (seen.start.saturating_sub(1) / self.fine).min(height);
        let end = (seen.end + 1).div_ceil(self.fine).clamp(first, height);
        let height = end - first;
        let are_many = picture.n_triangles() > FEW_TRIANGLES;
        let n_threads = self.n_threads(height);
        let n_at_once = if are_many {
            height.div_ceil(n_threads as u32).max(1)
        } else {
            ROWS_AT_ONCE
        };
        let starts = (first..end).step_by(n_at_once as usize);
        let rows = starts.map(|start| start..(start + n_at_once).min(end));
        let pixels = &mut pixels[(first * width) as usize..(end * width) as usize];
        let bands = rows.zip(pixels.chunks_mut((n_at_once * width).max(1) as usize));
        let kept = Mutex::new(Vec::new());
        let is_worth_keeping = are_many && !picture.has_skin();
        share(n_threads, bands, |seen, (rows, pixels)| {
            self.find(picture, &rows, seen);
            self.tone(&rows, seen, pixels);
            if is_worth_keeping && let Ok(mut kept) = kept.lock() {
                let seen = std::mem::take(seen);
                kept.push(Band { rows, seen });
            }
        });
        kept.into_inner().unwrap_or_default()
    }

    /// As [`Self::draw`] the last time, but in other tones.
    pub fn draw_again(&self, known: &[Band], pixels: &mut [Color32]) {
        let width = self.size[0];
        let mut bands: Vec<&Band> = known.iter().collect();
        bands.sort_unstable_by_key(|band| band.rows.start);
        let mut rest = pixels;
        let mut row = 0;
        let parts = bands.into_iter().map(|band| {
            let [above, own] = [band.rows.start - row, band.rows.len() as u32];
            let below = std::mem::take(&mut rest).split_at_mut((above * width) as usize);
            let pixels;
            (pixels, rest) = below.1.split_at_mut((own * width) as usize);
            row = band.rows.end;
            (band, pixels)
        });
        let n_rows = known.iter().map(|band| band.rows.len() as u32).sum();
        share(self.n_threads(n_rows), parts, |_, (band, pixels)| {
            self.tone(&band.rows, &band.seen, pixels);
        });
    }

    fn n_threads(&self, n_rows: u32) -> usize {
        let n_samples = (self.size[0] * self.fine) as usize * (n_rows * self.fine) as usize;
        let n_threads = thread::available_parallelism().map_or(1, usize::from);
        if n_samples < FEW { 1 } else { n_threads }.min(MOST_THREADS)
    }

    fn find(&self, picture: &SolidPicture, rows: &Range<u32>, seen: &mut Seen) {
        let first = (rows.start * self.fine).saturating_sub(1);
        let end = (rows.end * self.fine + 1).min(self.size[1] * self.fine);
        seen.n_columns = (self.size[0] * self.fine) as usize;
        seen.first_row = first as usize;
        let n_samples = (end - first) as usize * seen.n_columns;
        seen.depths.clear();
        seen.depths.resize(n_samples, 1.0);
        seen.facets.clear();
        seen.facets.resize(n_samples, NONE);
        if picture.has_skin() {
            seen.texels.clear();
            seen.texels.resize(n_samples, None);
        }
        let (depths, facets) = (&mut seen.depths, &mut seen.facets);
        picture.draw_rows(first..end, depths, facets, &mut seen.texels);
    }

    fn tone(&self, rows: &Range<u32>, seen: &Seen, pixels: &mut [Color32]) {
        let n_columns = seen.n_columns;
        let is_dark = match self.outline {
            Some((_, lined)) => outlines(seen, lined),
            None => vec![false; seen.facets.len()],
        };
        let fine = self.fine as usize;
        let above = rows.start as usize * fine - seen.first_row;
        for (row, pixels) in pixels.chunks_mut(self.size[0] as usize).enumerate() {
            let top = (above + row * fine) * n_columns;
            for (block, pixels) in pixels.chunks_mut(BLOCK).enumerate() {
                let left = top + block * BLOCK * fine;
                if !is_empty(seen, &is_dark, left, [pixels.len() * fine, fine]) {
                    match fine {
                        1 => self.block::<1>(seen, &is_dark, left, pixels),
                        _ => self.block::<FINE>(seen, &is_dark, left, pixels),
                    }
                }
            }
        }
    }

    /// Pixels beside each other, from this sample on. Most have only one colour.
    fn block<const N: usize>(
        &self,
        seen: &Seen,
        is_dark: &[bool],
        left: usize,
        pixels: &mut [Color32],
    ) {
        let rows: [Range<usize>; N] = std::array::from_fn(|i| {
            let start = left + i * seen.n_columns;
            start..start + N * pixels.len()
        });
        let rows_of = rows.each_ref();
        let facets = rows_of.map(|row| chunks::<_, N>(&seen.facets[row.clone()]));
        let dark = rows.map(|row| chunks::<_, N>(&is_dark[row]));
        let has_texels = !seen.texels.is_empty();
        for (column, pixel) in pixels.iter_mut().enumerate() {
            let facet = facets[0][column][0];
            let is_whole = facets.iter().all(|row| row[column] == [facet; N])
                && dark.iter().all(|row| row[column] == [false; N]);
            let left = left + column * N;
            *pixel = if is_whole && !(has_texels && seen.texels[left].is_some()) {
                let tone = self.tones.get(facet as usize);
                tone.copied().unwrap_or(Color32::TRANSPARENT)
            } else {
                let samples = (0..N).flat_map(|i| {
                    let start = left + i * seen.n_columns;
                    start..start + N
                });
                self.pixel(seen, is_dark, samples)
            };
        }
    }

    fn pixel(
        &self,
        seen: &Seen,
        is_dark: &[bool],
        samples: impl Iterator<Item = usize>,
    ) -> Color32 {
        let mut sum = [0; 4];
        let mut n = 0;
        for at in samples {
            n += 1;
            let facet = seen.facets[at];
            let tone = match self.outline {
                Some((ink, _)) if is_dark[at] => ink,
                _ if facet == NONE => continue,
                _ => match seen.texels.get(at).copied().flatten() {
                    Some(texel) => painted(texel, self.tones[facet as usize]),
                    None => self.tones[facet as usize],
                },
            };
            for (sum, channel) in sum.iter_mut().zip(tone.to_array()) {
                *sum += u32::from(channel);
            }
        }
        let [r, g, b, a] = sum.map(|sum: u32| ((sum + n / 2) / n) as u8);
        Color32::from_rgba_premultiplied(r, g, b, a)
    }
}

/// Some parts after the other, as long as there are any: a thread's samples stay near its processor.
fn share<T: Send>(
    n_threads: usize,
    parts: impl Iterator<Item = T> + Send,
    work: impl Fn(&mut Seen, T) + Sync,
) {
    let parts = Mutex::new(parts);
    let work_on = || {
        let mut seen = Seen::default();
        let next = || parts.lock().ok()?.next();
        while let Some(part) = next() {
            work(&mut seen, part);
        }
    };
    thread::scope(|scope| {
        for _ in 1..n_threads {
            scope.spawn(work_on);
        }
        work_on();
    });
}

fn chunks<T, const N: usize>(samples: &[T]) -> &[[T; N]] {
    samples.as_chunks().0
}

/// A texel under a facet's tone: as if the tone's light fell on it.
fn painted(texel: [u8; 3], tone: Color32) -> Color32 {
    let [r, g, b, a] = tone.to_array();
    let [r, g, b] = std::array::from_fn(|i| {
        let product = u16::from(texel[i]) * u16::from([r, g, b][i]);
        (product / 255) as u8
    });
    Color32::from_rgba_premultiplied(r, g, b, a)
}

fn is_empty(seen: &Seen, is_dark: &[bool], left: usize, [width, n_rows]: [usize; 2]) -> bool {
    (0..n_rows).all(|row| {
        let start = left + row * seen.n_columns;
        let samples = start..start + width;
        // All of them are looked at, several at once.
        let n_seen = seen.facets[samples.clone()].iter();
        let n_seen: usize = n_seen.map(|facet| usize::from(*facet != NONE)).sum();
        n_seen == 0 && !is_dark[samples].contains(&true)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        figure::{Edging, Facet, Facets, Lens, Role, SolidScreen},
        geom::Orbit,
    };

    /// A wavy ground of very many facets, seen from above.
    fn ground() -> Facets {
        const N: i32 = 60;
        let at = |i: i32, j: i32| {
            let [x, z] = [i, j].map(|i| 4.0 * f64::from(i) / f64::from(N) - 2.0);
            [x, 0.2 * libm::sin(3.0 * x + z), z]
        };
        let facet = |corners: [[f64; 3]; 3]| Facet {
            corners: corners.to_vec(),
            role: Role::Soft,
            link: None,
            skin: None,
            edging: Edging::Samples { is_open: true },
            opacity: 1.0,
        };
        let places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
        let both = places.flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
            [facet([a, b, c]), facet([a, c, d])]
        });
        both.collect::<Vec<_>>().into()
    }

    #[test]
    fn what_was_seen_is_toned_again_as_if_it_were_drawn_anew() {
        let facets = ground();
        let lens = Lens::Eye(Orbit::new([0.0; 3], [25.0, 35.0], 9.0, 30.0));
        let part = [[-1.5, -1.0], [1.5, 1.0]];
        let (size, fine) = ([240, 160], 2);
        let screen = SolidScreen::new(facets.mesh(), &lens, part, size.map(|side| side * fine));
        let screen = screen.expect("the ground is seen");
        let picture = SolidPicture::new(facets.mesh(), &screen);
        let found = vec![true; facets.len()];
        let tones_of = |shift: usize| -> Vec<Color32> {
            let tone = |i: usize| Color32::from_gray(((i + shift) * 37 % 200) as u8);
            (0..facets.len()).map(tone).collect()
        };
        let mut drawn = Vec::new();
        for (shift, is_dashed) in [(0, false), (11, true)] {
            let (tones, dashed) = (tones_of(shift), vec![is_dashed; facets.len()]);
            let lined = Lined {
                normals: &facets.mesh().normals,
                are_found: &found,
                are_dashed: &dashed,
            };
            let samples = Samples {
                tones: &tones,
                outline: Some((Color32::BLACK, lined)),
                size,
                fine,
            };
            let mut pixels = vec![Color32::TRANSPARENT; (size[0] * size[1]) as usize];
            let bands = samples.draw(&picture, &mut pixels);
            assert!(!bands.is_empty(), "so many facets are worth keeping");
            drawn.push(bands);
            for bands in &drawn {
                let mut again = vec![Color32::TRANSPARENT; pixels.len()];
                samples.draw_again(bands, &mut again);
                assert!(again == pixels, "shift {shift}");
            }
            let n_seen = pixels.iter().filter(|pixel| pixel.a() > 0).count();
            assert!(n_seen > pixels.len() / 10, "{n_seen} pixels");
        }
    }
}
