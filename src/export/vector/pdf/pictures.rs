//! Pixels within drawings, each with its alpha where it has any.

use std::ops::Range;

use egui::Color32;
use pdf_writer::{Filter, Finish, Name, Pdf, Ref, writers::Resources};

use crate::paint::Image;

use super::objects::{Ids, deflated};

pub struct Pictures<'a>(Vec<(&'a Image, [Ref; 2])>);

/// In a page's content.
pub fn name(nth: usize) -> String {
    format!("I{nth}")
}

impl<'a> Pictures<'a> {
    pub fn of(images: impl Iterator<Item = &'a Image>, ids: &mut Ids) -> Self {
        let numbered = images.map(|image| (image, [ids.next(), ids.next()]));
        Self(numbered.collect())
    }

    pub fn name(&self, resources: &mut Resources<'_>, used: Range<usize>) {
        let mut names = resources.x_objects();
        for nth in used {
            if let Some((_, [id, _])) = self.0.get(nth) {
                names.pair(Name(name(nth).as_bytes()), *id);
            }
        }
    }

    pub fn write(&self, pdf: &mut Pdf) {
        for (image, [id, mask]) in &self.0 {
            let [width, height] = image.size.map(|side| side as i32);
            let plain = |&[r, g, b, a]: &[u8; 4]| {
                let [r, g, b, _] =
                    Color32::from_rgba_premultiplied(r, g, b, a).to_srgba_unmultiplied();
                [r, g, b]
            };
            let colours = deflated(
                image
                    .pixels()
                    .iter()
                    .flat_map(plain)
                    .collect::<Vec<_>>()
                    .as_slice(),
            );
            let is_solid = image.pixels().iter().all(|[.., a]| *a == 255);
            let mut written = pdf.image_xobject(*id, &colours);
            written.filter(Filter::FlateDecode);
            written.width(width).height(height);
            written.color_space().device_rgb();
            written.bits_per_component(8);
            if !is_solid {
                written.s_mask(*mask);
            }
            written.finish();
            if !is_solid {
                let alphas = image.pixels().iter().map(|[.., a]| *a);
                let alphas = deflated(&alphas.collect::<Vec<_>>());
                let mut written = pdf.image_xobject(*mask, &alphas);
                written.filter(Filter::FlateDecode);
                written.width(width).height(height);
                written.color_space().device_gray();
                written.bits_per_component(8);
            }
        }
    }
}
