//! The colours of a theme's loops: its roles, what stands between them at soft edges, and some of all others.

use egui::Color32;
use rustc_hash::FxHashMap;

use crate::paint::{Image, Theme};

/// The colour that is none: what was there stays.
pub const CLEAR: u8 = 255;

/// A picture by numbers in a palette.
pub struct Plane {
    pub size: [usize; 2],
    pub indices: Vec<u8>,
}

/// Of each channel, in the cube of all colours.
const LEVELS: usize = 4;

pub struct Palette {
    colours: Vec<[u8; 3]>,
    /// The nearest of every colour that has been asked for.
    known: FxHashMap<[u8; 3], u8>,
}

impl Palette {
    /// The same for all pictures of a theme.
    pub fn of(theme: &Theme) -> Self {
        let ground = theme.background;
        let mut colours = Vec::new();
        let mut ramp = |from: Color32, to: Color32, n: usize| {
            for i in 0..=n {
                let [r, g, b, _] = from.lerp_to_gamma(to, i as f32 / n as f32).to_array();
                if !colours.contains(&[r, g, b]) {
                    colours.push([r, g, b]);
                }
            }
        };
        ramp(ground, theme.ink, 20);
        for (role, n) in [
            (theme.accent, 14),
            (theme.signal, 14),
            (theme.soft, 10),
            (theme.accepted, 10),
            (theme.discarded, 8),
            (theme.signal_text, 8),
            (theme.faint, 4),
            (theme.hairline, 2),
            (theme.panel, 1),
            (theme.hover, 1),
        ] {
            ramp(ground, role, n);
        }
        // What is drawn over the washes of windows and of what happens.
        let wash = ground.lerp_to_gamma(theme.signal, 0.1);
        for (over, to, n) in [
            (theme.accent_wash, theme.ink, 10),
            (theme.accent_wash, theme.accent, 8),
            (theme.accent_wash, theme.soft, 5),
            (wash, theme.ink, 6),
            (wash, theme.signal_text, 6),
            (theme.ink, theme.accent, 6),
        ] {
            ramp(over, to, n);
        }
        // And a coarse cube of all colours, as far as there is room.
        let level = |i: usize| (255 * i / (LEVELS - 1)) as u8;
        for i in 0..LEVELS * LEVELS * LEVELS {
            let [r, g, b] = [i % LEVELS, i / LEVELS % LEVELS, i / LEVELS / LEVELS].map(level);
            if !colours.contains(&[r, g, b]) {
                colours.push([r, g, b]);
            }
        }
        colours.truncate(usize::from(CLEAR));
        Self {
            colours,
            known: FxHashMap::default(),
        }
    }

    pub fn plane(&mut self, image: &Image) -> Plane {
        let mut last = ([0; 3], self.nearest([0; 3]));
        let indices = image.pixels().iter().map(|&[r, g, b, _]| {
            if last.0 != [r, g, b] {
                last = ([r, g, b], self.nearest([r, g, b]));
            }
            last.1
        });
        Plane {
            size: image.size,
            indices: indices.collect(),
        }
    }

    fn nearest(&mut self, colour: [u8; 3]) -> u8 {
        let colours = &self.colours;
        *self.known.entry(colour).or_insert_with(|| {
            let distance = |known: &[u8; 3]| -> u32 {
                // The eye tells greens apart best, and blues least.
                const WEIGHTS: [u32; 3] = [3, 6, 2];
                let parts =
                    (0..3).map(|i| u32::from(known[i].abs_diff(colour[i])).pow(2) * WEIGHTS[i]);
                parts.sum()
            };
            let nearest = (0..colours.len()).min_by_key(|&i| distance(&colours[i]));
            nearest.unwrap_or_default() as u8
        })
    }

    /// Three of each colour, of 256.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colours.as_flattened().to_vec();
        bytes.resize(3 * (usize::from(CLEAR) + 1), 0);
        bytes
    }

    pub fn alphas() -> Vec<u8> {
        let mut alphas = vec![255; usize::from(CLEAR)];
        alphas.push(0);
        alphas
    }
}
