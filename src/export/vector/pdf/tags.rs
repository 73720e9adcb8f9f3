//! What each part is: the tree that a screen reader goes through.

use pdf_writer::{Finish, Pdf, Ref, TextStr, types::StructRole, writers::StructTreeRoot};

use super::{objects::Ids, parts::Tag};

struct Element {
    id: Ref,
    page: Ref,
    tag: Tag,
    /// Of its content on that page.
    mark: i32,
    link: Option<Ref>,
}

pub struct Tags {
    root: Ref,
    document: Ref,
    elements: Vec<Element>,
    /// Of each page the elements of its marks.
    of_pages: Vec<Vec<Ref>>,
    of_links: Vec<Ref>,
}

impl Tags {
    pub fn new(n_pages: usize, ids: &mut Ids) -> Self {
        Self {
            root: ids.next(),
            document: ids.next(),
            elements: Vec::new(),
            of_pages: vec![Vec::new(); n_pages],
            of_links: Vec::new(),
        }
    }

    /// The mark that the content of a part on page `nth` is written with; nothing of what is not read.
    pub fn part(&mut self, nth: usize, page: Ref, tag: &Tag, ids: &mut Ids) -> Option<i32> {
        if *tag == Tag::Furniture {
            return None;
        }
        let marks = self.of_pages.get_mut(nth)?;
        let (id, mark) = (ids.next(), marks.len() as i32);
        marks.push(id);
        self.elements.push(Element {
            id,
            page,
            tag: tag.clone(),
            mark,
            link: None,
        });
        Some(mark)
    }

    /// A press on the part that was told last leads somewhere: the key that its annotation is found by.
    pub fn link(&mut self, annotation: Ref) -> i32 {
        if let Some(last) = self.elements.last_mut() {
            last.link = Some(annotation);
            self.of_links.push(last.id);
        }
        (self.of_pages.len() + self.of_links.len()) as i32 - 1
    }

    /// The root's number.
    pub fn write(self, pdf: &mut Pdf, lang: &str, ids: &mut Ids) -> Ref {
        for element in &self.elements {
            let mut written = pdf.struct_element(element.id);
            written.kind(role(&element.tag, element.link.is_some()));
            written.parent(self.document).page(element.page);
            if let Tag::Figure(words) = &element.tag {
                written.alt(TextStr(words));
            }
            let mut children = written.children();
            children.marked_content_id(element.mark);
            if let Some(annotation) = element.link {
                children.object_ref().page(element.page).object(annotation);
            }
        }
        let mut document = pdf.struct_element(self.document);
        document.kind(StructRole::Document).parent(self.root);
        document.lang(TextStr(lang));
        let mut children = document.children();
        for element in &self.elements {
            children.struct_element(element.id);
        }
        children.finish();
        document.finish();
        let mut parents = Vec::new();
        for marks in &self.of_pages {
            let id = ids.next();
            pdf.indirect(id).array().items(marks);
            parents.push(id);
        }
        parents.extend(self.of_links);
        let mut root = pdf.indirect(self.root).start::<StructTreeRoot<'_>>();
        root.child(self.document);
        let mut tree = root.parent_tree();
        let mut numbers = tree.nums();
        for (key, parent) in parents.into_iter().enumerate() {
            numbers.insert(key as i32, parent);
        }
        numbers.finish();
        tree.finish();
        root.finish();
        self.root
    }
}

/// The name that a mark has in the content.
pub fn name(tag: &Tag) -> pdf_writer::Name<'static> {
    role(tag, false).to_name()
}

fn role(tag: &Tag, is_link: bool) -> StructRole {
    match tag {
        _ if is_link => StructRole::Link,
        Tag::Title => StructRole::H1,
        Tag::Heading => StructRole::H2,
        Tag::Paragraph | Tag::Furniture => StructRole::P,
        Tag::Code => StructRole::Code,
        Tag::Figure(_) => StructRole::Figure,
    }
}
