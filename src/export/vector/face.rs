//! The shipped fonts by character: which one has it, its outline, and a file with no more characters than are used.

use std::{collections::BTreeMap, sync::LazyLock};

use egui::FontFamily;
use skrifa::{
    FontRef, GlyphId, MetadataProvider,
    instance::LocationRef,
    instance::Size,
    outline::{DrawSettings, OutlinePen},
};
use subsetter::GlyphRemapper;

use crate::paint::fonts;

/// One font file.
pub struct Face {
    /// Its file's: `Inter-Regular.otf`.
    pub name: &'static str,
    pub bytes: &'static [u8],
    pub font: FontRef<'static>,
    /// To those of an em.
    pub units: f32,
}

/// Of each family its fonts.
static FAMILIES: LazyLock<[Vec<Face>; 3]> = LazyLock::new(|| {
    let families = [
        FontFamily::Proportional,
        FontFamily::Monospace,
        fonts::semibold(),
    ];
    let face = |(name, bytes)| {
        let font = FontRef::new(bytes).ok()?;
        let metrics = font.metrics(Size::unscaled(), LocationRef::default());
        let units = f32::from(metrics.units_per_em);
        Some(Face {
            name,
            bytes,
            font,
            units,
        })
    };
    families.map(|family| {
        fonts::of_family(&family)
            .into_iter()
            .filter_map(face)
            .collect()
    })
});

impl Face {
    /// The first of the family's that has the character, else its first.
    pub fn of(family: &FontFamily, c: char) -> Option<&'static Self> {
        let [proportional, monospace, semibold] = &*FAMILIES;
        let faces = match family {
            FontFamily::Proportional => proportional,
            FontFamily::Monospace => monospace,
            FontFamily::Name(_) => semibold,
        };
        let has = |face: &&Self| face.glyph(c).is_some();
        faces.iter().find(has).or_else(|| faces.first())
    }

    pub fn glyph(&self, c: char) -> Option<GlyphId> {
        self.font.charmap().map(c)
    }

    /// As style sheets name it: family and weight.
    pub fn family(&self) -> (String, u16) {
        let stem = self.name.split('.').next().unwrap_or(self.name);
        let (family, style) = stem.split_once('-').unwrap_or((stem, ""));
        let weight = match style {
            "SemiBold" => 600,
            "Bold" => 700,
            _ => 400,
        };
        (family.to_owned(), weight)
    }

    pub fn advance(&self, glyph: GlyphId) -> f32 {
        let metrics = self
            .font
            .glyph_metrics(Size::unscaled(), LocationRef::default());
        metrics.advance_width(glyph).unwrap_or_default()
    }

    /// The outline of a character in the font's units, y up.
    pub fn draw(&self, c: char, pen: &mut impl OutlinePen) {
        let glyph = self.glyph(c).unwrap_or_default();
        if let Some(outline) = self.font.outline_glyphs().get(glyph) {
            let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
            // An outline that cannot be read is left out.
            let _ = outline.draw(settings, pen);
        }
    }

    /// The font cut down to these characters, and the new number of each one's glyph.
    pub fn cut(&self, chars: impl IntoIterator<Item = char>) -> (Vec<u8>, BTreeMap<char, u16>) {
        let mut remapper = GlyphRemapper::new();
        let number = |c| {
            let glyph = self.glyph(c).unwrap_or_default();
            (c, remapper.remap(glyph.to_u32() as u16))
        };
        let numbers = chars.into_iter().map(number).collect();
        let cut = subsetter::subset(self.bytes, 0, &remapper);
        (cut.unwrap_or_else(|_| self.bytes.to_vec()), numbers)
    }
}
