//! A lesson's figures as one page that is paged through: it opens without a network, and prints a figure a sheet.

use base64::{Engine, prelude::BASE64_STANDARD as BASE64};

use crate::paint::Theme;

use super::figure::Options;

const PAGE: &str = include_str!("slides.html");

#[derive(Clone, Debug)]
pub struct Slide {
    pub png: Vec<u8>,
    /// What it shows, in words.
    pub alternative: String,
}

/// An HTML file of its own: arrow keys, a clicker and clicks page, `#3` in its address is the third slide.
pub fn slides(title: &str, slides: &[Slide], options: Options) -> String {
    let image = |slide: &Slide| {
        let (alternative, png) = (
            escaped(slide.alternative.trim_end()),
            BASE64.encode(&slide.png),
        );
        format!("<img class=\"slide\" alt=\"{alternative}\" src=\"data:image/png;base64,{png}\">")
    };
    let images: Vec<String> = slides.iter().map(image).collect();
    let [r, g, b, _] = Theme::of(options.theme).background.to_array();
    let [width, height] = options.size_px;
    let mut page = PAGE.to_owned();
    for (hole, content) in [
        ("@lang@", options.lang.id().to_owned()),
        ("@title@", escaped(title)),
        ("@background@", format!("#{r:02x}{g:02x}{b:02x}")),
        ("@width@", width.to_string()),
        ("@height@", height.to_string()),
        // The last: what is in it is no hole.
        ("@slides@", images.join("\n")),
    ] {
        page = page.replacen(hole, &content, 1);
    }
    page
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('"', "&quot;").replace('@', "&#64;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{export::Steps, paint::ThemeKind, text::Lang};

    #[test]
    fn each_slide_is_there_with_its_words_and_nothing_comes_from_elsewhere() {
        let options = Options {
            size_px: [640, 360],
            theme: ThemeKind::Dark,
            lang: Lang::PtBr,
            steps: Steps::Figures,
            asks: false,
        };
        let slide = |alternative: &str| Slide {
            png: vec![1, 2, 3],
            alternative: alternative.to_owned(),
        };
        let page = slides(
            "A \"B\" @slides@",
            &[slide("x < 1 & y"), slide("@lang@\n")],
            options,
        );
        assert!(page.contains("<html lang=\"pt-BR\">"), "{page}");
        assert!(page.contains("<title>A &quot;B&quot; &#64;slides&#64;</title>"));
        assert!(page.contains("alt=\"x &lt; 1 &amp; y\" src=\"data:image/png;base64,AQID\""));
        assert!(page.contains("alt=\"&#64;lang&#64;\""));
        assert!(page.contains("background: #14171b"));
        assert!(page.contains("size: 640px 360px"));
        assert_eq!(page.matches("<img").count(), 2);
        assert!(!page.contains("http"), "it needs no network");
    }
}
