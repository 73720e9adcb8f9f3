//! SVG: strokes as strokes, text as text or as outlines, colours as classes, what is drawn together as groups.

mod attributes;
mod shapes;
mod words;

use std::fmt::Write;

use base64::{Engine, engine::general_purpose::STANDARD as BASE64};

use crate::lesson::link_element;

use super::{
    about::About,
    ink::{Ink, roles},
    number::number,
    page::{Drawn, Item, VectorPage, What},
};

use attributes::escaped;
pub use words::Letters;
use words::Words;

pub fn svg(page: &VectorPage, letters: Letters, about: About<'_>) -> String {
    let mut writer = Writer {
        page,
        out: String::new(),
        clips: Vec::new(),
        open: 0,
        words: Words::new(letters),
    };
    writer.items();
    let Writer {
        out, clips, words, ..
    } = writer;
    let mut file = String::new();
    head(&mut file, page, about);
    style(&mut file, page, &words);
    if !clips.is_empty() || !words.outlines().is_empty() {
        file.push_str("<defs>\n");
        for (i, [x, y, width, height]) in clips.iter().enumerate() {
            let rect = format!("<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>");
            let _ = writeln!(file, "<clipPath id=\"clip{i}\">{rect}</clipPath>");
        }
        file.push_str(words.outlines());
        file.push_str("</defs>\n");
    }
    file.push_str("<rect class=\"background\" width=\"100%\" height=\"100%\"/>\n");
    file.push_str(&out);
    file.push_str("</svg>\n");
    file
}

fn head(file: &mut String, page: &VectorPage, about: About<'_>) {
    let [width, height] = [page.size.x, page.size.y];
    let [px_width, px_height] = [width, height].map(|side| (side * page.pixels_per_point).round());
    let [w, h] = [width, height].map(number);
    let _ = writeln!(
        file,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{px_width}\" \
         height=\"{px_height}\" viewBox=\"0 0 {w} {h}\" xml:lang=\"{}\" role=\"img\" aria-labelledby=\"title desc\">",
        about.lang
    );
    let _ = writeln!(file, "<title id=\"title\">{}</title>", escaped(about.title));
    let words = escaped(about.alternative.trim_end());
    let _ = writeln!(file, "<desc id=\"desc\">{words}</desc>");
    if let Some(link) = about.link {
        let _ = writeln!(file, "<metadata>{}</metadata>", link_element(link));
    }
}

/// The theme's colours as fills (`.ink`) and strokes (`.s-ink`), and the fonts.
fn style(file: &mut String, page: &VectorPage, words: &Words) {
    file.push_str("<style>\n");
    file.push_str(&words.style());
    file.push_str("text { white-space: pre; }\n");
    for (role, colour) in roles(page.theme) {
        let hex = Ink::of(page.theme, colour).hex();
        let _ = writeln!(
            file,
            ".{role} {{ fill: {hex}; }} .s-{role} {{ stroke: {hex}; }}"
        );
    }
    file.push_str("</style>\n");
}

struct Writer<'a> {
    page: &'a VectorPage,
    out: String,
    clips: Vec<[String; 4]>,
    /// Groups that are not closed yet.
    open: usize,
    words: Words,
}

impl Writer<'_> {
    fn items(&mut self) {
        let mut rest = &self.page.items[..];
        while let Some((first, after)) = rest.split_first() {
            rest = match first {
                Item::Begin(name) => {
                    let _ = writeln!(self.out, "<g class=\"{name}\">");
                    self.open += 1;
                    after
                }
                Item::End => {
                    if self.open > 0 {
                        self.open -= 1;
                        self.out.push_str("</g>\n");
                    }
                    after
                }
                Item::Drawn(drawn) => {
                    let is_alike =
                        |item: &&Item| matches!(item, Item::Drawn(it) if it.clip == drawn.clip);
                    let n = rest.iter().take_while(is_alike).count();
                    self.clipped(drawn, &rest[..n]);
                    &rest[n..]
                }
            };
        }
        for _ in 0..self.open {
            self.out.push_str("</g>\n");
        }
    }

    fn clipped(&mut self, first: &Drawn, items: &[Item]) {
        if let Some(clip) = first.clip {
            let [min, size] = [clip.min.to_vec2(), clip.size()];
            let rect = [min.x, min.y, size.x, size.y].map(number);
            let known = self.clips.iter().position(|it| *it == rect);
            let nth = known.unwrap_or_else(|| {
                self.clips.push(rect);
                self.clips.len() - 1
            });
            let _ = writeln!(self.out, "<g clip-path=\"url(#clip{nth})\">");
        }
        let mut drawn = items.iter().filter_map(|item| match item {
            Item::Drawn(drawn) => Some(&drawn.what),
            Item::Begin(_) | Item::End => None,
        });
        let mut next = drawn.next();
        while let Some(what) = next {
            next = drawn.next();
            match what {
                What::Path(path) => {
                    let mut paths = vec![path];
                    while let Some(What::Path(other)) = next {
                        if !path.joins(other) {
                            break;
                        }
                        paths.push(other);
                        next = drawn.next();
                    }
                    shapes::write(&mut self.out, self.page.theme, &paths);
                }
                What::Text(text) => {
                    self.words.write(&mut self.out, self.page.theme, text);
                    for bar in &text.bars {
                        shapes::write(&mut self.out, self.page.theme, &[bar]);
                    }
                }
                What::Picture(picture) => {
                    let [min, size] = [picture.rect.min.to_vec2(), picture.rect.size()];
                    // Exact: it stands on whole pixels.
                    let [x, y, width, height] = [min.x, min.y, size.x, size.y];
                    let png = BASE64.encode(picture.image.to_glass_png());
                    let _ = writeln!(
                        self.out,
                        "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
                         xlink:href=\"data:image/png;base64,{png}\"/>"
                    );
                }
            }
        }
        if first.clip.is_some() {
            self.out.push_str("</g>\n");
        }
    }
}
