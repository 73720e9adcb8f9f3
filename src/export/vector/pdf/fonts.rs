//! Each font once for the whole file, with the characters that are used in it.

use std::collections::{BTreeMap, BTreeSet};

use pdf_writer::{
    Finish, Name, Pdf, Ref, Str,
    types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap},
    writers::Resources,
};
use skrifa::{MetadataProvider, instance::LocationRef, instance::Size};

use crate::export::vector::{
    face::Face,
    page::{Item, Letter, VectorPage, What},
    web_font::tables,
};

use super::objects::{Ids, deflated};

const IDENTITY: SystemInfo<'static> = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};
/// What a font's widths are measured in: thousandths of its size.
const EM: f32 = 1000.0;

pub struct Fonts(BTreeMap<&'static str, Font>);

pub struct Font {
    face: &'static Face,
    /// Names it in all pages.
    pub name: String,
    numbers: BTreeMap<char, u16>,
    file: Vec<u8>,
    /// Font, descendant, descriptor, file, characters.
    ids: [Ref; 5],
}

impl Fonts {
    pub fn of<'a>(drawings: impl Iterator<Item = &'a VectorPage>, ids: &mut Ids) -> Self {
        let mut chars: BTreeMap<&'static str, (&'static Face, BTreeSet<char>)> = BTreeMap::new();
        for letter in drawings.flat_map(letters) {
            let face = letter.face();
            let (_, chars) = chars.entry(face.name).or_insert((face, BTreeSet::new()));
            chars.insert(letter.c);
        }
        let fonts = chars.into_iter().enumerate();
        let fonts = fonts.map(|(nth, (key, (face, chars)))| {
            let (file, numbers) = face.cut(chars);
            let font = Font {
                face,
                name: format!("F{nth}"),
                numbers,
                file,
                ids: [(); 5].map(|()| ids.next()),
            };
            (key, font)
        });
        Self(fonts.collect())
    }

    pub fn of_letter(&self, letter: &Letter) -> Option<&Font> {
        self.0.get(letter.face().name)
    }

    pub fn name(&self, resources: &mut Resources<'_>) {
        let mut names = resources.fonts();
        for font in self.0.values() {
            names.pair(Name(font.name.as_bytes()), font.ids[0]);
        }
    }

    pub fn write(&self, pdf: &mut Pdf) {
        for font in self.0.values() {
            font.write(pdf);
        }
    }
}

impl Font {
    /// As it stands in a line of text: two bytes.
    pub fn glyph(&self, c: char) -> u16 {
        self.numbers.get(&c).copied().unwrap_or_default()
    }

    /// In thousandths of the font's size.
    pub fn width(&self, c: char) -> f32 {
        let glyph = self.face.glyph(c).unwrap_or_default();
        EM * self.face.advance(glyph) / self.face.units
    }

    fn write(&self, pdf: &mut Pdf) {
        let [font, descendant, descriptor, file, characters] = self.ids;
        // Six letters say that it is a part of a font; which part, says the file.
        let base = format!(
            "CLIPSC+{}",
            self.face.name.split('.').next().unwrap_or_default()
        );
        let base = Name(base.as_bytes());
        let mut written = pdf.type0_font(font);
        written
            .base_font(base)
            .encoding_predefined(Name(b"Identity-H"));
        written.descendant_font(descendant).to_unicode(characters);
        written.finish();

        let outlines = tables(&self.file).find(|(tag, _)| tag == b"CFF ");
        let mut written = pdf.cid_font(descendant);
        let kind = if outlines.is_some() {
            CidFontType::Type0
        } else {
            CidFontType::Type2
        };
        written.subtype(kind).base_font(base).system_info(IDENTITY);
        written.font_descriptor(descriptor).default_width(0.0);
        if outlines.is_none() {
            written.cid_to_gid_map_predefined(Name(b"Identity"));
        }
        let mut widths = written.widths();
        for (&c, &glyph) in &self.numbers {
            widths.consecutive(glyph, [self.width(c)]);
        }
        widths.finish();
        written.finish();

        self.describe(pdf, descriptor, base, (file, outlines.is_some()));
        let bytes = outlines.map_or_else(|| self.file.clone(), |(_, table)| table);
        let bytes = deflated(&bytes);
        let mut stream = pdf.stream(file, &bytes);
        stream.filter(pdf_writer::Filter::FlateDecode);
        if kind == CidFontType::Type0 {
            stream.pair(Name(b"Subtype"), Name(b"CIDFontType0C"));
        }
        stream.finish();

        let mut map = UnicodeCmap::new(Name(b"Clipscope"), IDENTITY);
        for (&c, &glyph) in &self.numbers {
            map.pair(glyph, c);
        }
        let map = map.finish();
        pdf.cmap(characters, &map);
    }

    fn describe(&self, pdf: &mut Pdf, id: Ref, base: Name<'_>, (file, is_cff): (Ref, bool)) {
        let metrics = self
            .face
            .font
            .metrics(Size::new(EM), LocationRef::default());
        let bounds = metrics.bounds.unwrap_or_default();
        let mut written = pdf.font_descriptor(id);
        written
            .name(base)
            .flags(FontFlags::SYMBOLIC)
            .italic_angle(0.0);
        written.bbox(pdf_writer::Rect::new(
            bounds.x_min,
            bounds.y_min,
            bounds.x_max,
            bounds.y_max,
        ));
        written.ascent(metrics.ascent).descent(metrics.descent);
        written.cap_height(metrics.cap_height.unwrap_or(metrics.ascent));
        written.stem_v(80.0);
        if is_cff {
            written.font_file3(file);
        } else {
            written.font_file2(file);
        }
    }
}

fn letters(drawing: &VectorPage) -> impl Iterator<Item = &Letter> {
    drawing.items.iter().flat_map(|item| match item {
        Item::Drawn(drawn) => match &drawn.what {
            What::Text(text) => text.letters.iter(),
            What::Path(_) | What::Picture(_) => [].iter(),
        },
        Item::Begin(_) | Item::End => [].iter(),
    })
}
