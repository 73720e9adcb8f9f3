//! PDF: pages of drawings that are tagged, so that a screen reader finds its way, with text that is found and copied. No date is written:
//! the bytes are the same on every day.

mod content;
mod fonts;
mod objects;
mod parts;
mod pictures;
mod tags;

use egui::{Pos2, Rect};
use pdf_writer::{Finish, Name, Pdf, Ref, Str, TextStr, types::ActionType};

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
    let mut n_pictures = 0;
    for (nth, (page, &id)) in pages.iter().zip(&page_ids).enumerate() {
        let mut contents = Contents::new(page.size, &fonts, n_pictures);
        let mut links = Vec::new();
        for part in &page.parts {
            let marked = tags.part(nth, id, &part.tag, &mut ids);
            contents.part(part, marked);
            if let Some(link) = &part.link {
                let annotation = ids.next();
                links.push((annotation, part.rect(), link, tags.link(annotation)));
            }
        }
        let used = n_pictures..contents.n_pictures();
        n_pictures = used.end;
        let content_id = ids.next();
        pdf.stream(content_id, &deflated(&contents.finish()))
            .filter(pdf_writer::Filter::FlateDecode);
        for (annotation, rect, link, key) in &links {
            annotate(&mut pdf, *annotation, (page, *rect), link, *key);
        }
        let mut written = pdf.page(id);
        written.parent(tree).contents(content_id);
        written.media_box(pdf_writer::Rect::new(0.0, 0.0, page.size.x, page.size.y));
        written.struct_parents(nth as i32);
        if !links.is_empty() {
            written.annotations(links.iter().map(|(annotation, ..)| *annotation));
            written.tab_order(pdf_writer::types::TabOrder::StructureOrder);
        }
        let mut resources = written.resources();
        fonts.name(&mut resources);
        pictures.name(&mut resources, used);
        content::name_alphas(&mut resources, &alphas);
    }
    fonts.write(&mut pdf);
    pictures.write(&mut pdf);
    let root = tags.write(&mut pdf, about.lang, &mut ids);
    pdf.pages(tree)
        .kids(page_ids.iter().copied())
        .count(page_ids.len() as i32);
    let mut written = pdf.document_info(info);
    written
        .title(TextStr(about.title))
        .creator(TextStr("Clipscope"));
    if let Some(link) = about.link {
        written.subject(TextStr(link));
    }
    written.finish();
    let mut written = pdf.catalog(catalog);
    written.pages(tree).lang(TextStr(about.lang));
    written.viewer_preferences().display_doc_title(true);
    written.mark_info().marked(true);
    written.pair(Name(b"StructTreeRoot"), root);
    written.finish();
    pdf.finish()
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
    written.subtype(pdf_writer::types::AnnotationType::Link);
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
