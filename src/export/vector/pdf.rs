//! PDF: pages of drawings that are tagged, so that a screen reader finds its way, with text that is found and copied. No date is written:
//! the bytes are the same on every day.

mod content;
mod fonts;
mod objects;
mod parts;
mod pictures;
mod tags;

use std::collections::BTreeSet;

use egui::{Pos2, Rect};
use pdf_writer::{
    Filter, Finish, Name, Pdf, Ref, Str, TextStr,
    types::{ActionType, AnnotationType, TabOrder},
};

use super::{
    about::About,
    page::{Item, VectorPage, What},
};

use content::Contents;
use fonts::Fonts;
use objects::{Ids, deflated};
use pictures::Pictures;
use tags::Tags;

pub use parts::{PdfPage, PdfPart, Tag};

/// A drawing on a page of its size.
pub fn pdf_of_one(drawing: &VectorPage, about: About<'_>) -> Vec<u8> {
    let part = PdfPart {
        tag: Tag::Figure(about.alternative.trim_end().to_owned()),
        drawing,
        at: Pos2::ZERO,
        scale: 1.0,
        link: None,
    };
    let page = PdfPage {
        size: drawing.size,
        parts: vec![part],
    };
    pdf(&[page], about)
}

/// The file's bytes.
pub fn pdf(pages: &[PdfPage<'_>], about: About<'_>) -> Vec<u8> {
    let mut ids = Ids::new();
    let mut pdf = Pdf::new();
    let [catalog, tree, info] = [(); 3].map(|()| ids.next());
    let drawings = || {
        pages
            .iter()
            .flat_map(|page| &page.parts)
            .map(|part| part.drawing)
    };
    let fonts = Fonts::of(drawings(), &mut ids);
    let pictures = Pictures::of(drawings().flat_map(pictures_of), &mut ids);
    let alphas = content::alphas(drawings());
    let mut tags = Tags::new(pages.len(), &mut ids);
    let page_ids: Vec<Ref> = pages.iter().map(|_| ids.next()).collect();
    let mut whole = Whole {
        pdf: &mut pdf,
        ids: &mut ids,
        tags: &mut tags,
        tree,
        fonts: &fonts,
        pictures: &pictures,
        alphas: &alphas,
        n_pictures: 0,
    };
    for (nth, (page, &id)) in pages.iter().zip(&page_ids).enumerate() {
        whole.page(nth, id, page);
    }
    fonts.write(&mut pdf);
    pictures.write(&mut pdf);
    let root = tags.write(&mut pdf, about.lang, &mut ids);
    pdf.pages(tree)
        .kids(page_ids.iter().copied())
        .count(page_ids.len() as i32);
    inform(&mut pdf, info, about);
    let mut written = pdf.catalog(catalog);
    written.pages(tree).lang(TextStr(about.lang));
    written.viewer_preferences().display_doc_title(true);
    written.mark_info().marked(true);
    written.pair(Name(b"StructTreeRoot"), root);
    written.finish();
    pdf.finish()
}

fn inform(pdf: &mut Pdf, id: Ref, about: About<'_>) {
    let mut written = pdf.document_info(id);
    written
        .title(TextStr(about.title))
        .creator(TextStr("Clipscope"));
    if let Some(link) = about.link {
        written.subject(TextStr(link));
    }
}

/// What all pages have in common.
struct Whole<'a> {
    pdf: &'a mut Pdf,
    ids: &'a mut Ids,
    tags: &'a mut Tags,
    tree: Ref,
    fonts: &'a Fonts,
    pictures: &'a Pictures<'a>,
    alphas: &'a BTreeSet<u8>,
    /// Those of the pages before.
    n_pictures: usize,
}

impl Whole<'_> {
    fn page(&mut self, nth: usize, id: Ref, page: &PdfPage<'_>) {
        let mut contents = Contents::new(page.size, self.fonts, self.n_pictures);
        let mut links = Vec::new();
        for part in &page.parts {
            let marked = self.tags.part(nth, id, &part.tag, self.ids);
            contents.part(part, marked);
            if let Some(link) = &part.link {
                let annotation = self.ids.next();
                let key = self.tags.link(annotation);
                annotate(self.pdf, annotation, (page, part.rect()), link, key);
                links.push(annotation);
            }
        }
        let used = self.n_pictures..contents.n_pictures();
        self.n_pictures = used.end;
        let content_id = self.ids.next();
        let content = deflated(&contents.finish());
        let mut stream = self.pdf.stream(content_id, &content);
        stream.filter(Filter::FlateDecode);
        stream.finish();
        let mut written = self.pdf.page(id);
        written.parent(self.tree).contents(content_id);
        written.media_box(pdf_writer::Rect::new(0.0, 0.0, page.size.x, page.size.y));
        written.struct_parents(nth as i32);
        if !links.is_empty() {
            written.annotations(links);
            written.tab_order(TabOrder::StructureOrder);
        }
        let mut resources = written.resources();
        self.fonts.name(&mut resources);
        self.pictures.name(&mut resources, used);
        content::name_alphas(&mut resources, self.alphas);
    }
}

fn pictures_of(drawing: &VectorPage) -> impl Iterator<Item = &crate::paint::Image> {
    drawing.items.iter().filter_map(|item| match item {
        Item::Drawn(drawn) => match &drawn.what {
            What::Picture(picture) => Some(&picture.image),
            What::Path(_) | What::Text(_) => None,
        },
        Item::Begin(_) | Item::End => None,
    })
}

fn annotate(pdf: &mut Pdf, id: Ref, (page, rect): (&PdfPage<'_>, Rect), link: &str, key: i32) {
    let mut written = pdf.annotation(id);
    written.subtype(AnnotationType::Link);
    let height = page.size.y;
    let [top, bottom] = [rect.min.y, rect.max.y].map(|y| height - y);
    written.rect(pdf_writer::Rect::new(rect.min.x, bottom, rect.max.x, top));
    written.border(0.0, 0.0, 0.0, None);
    written.contents(TextStr(link)).struct_parent(key);
    written
        .action()
        .action_type(ActionType::Uri)
        .uri(Str(link.as_bytes()));
}
