//! A figure as a file of shapes.

use super::{
    figure::{Picture, Studio},
    vector::{About, Letters, pdf_of_one, svg, tikz},
};

/// The kinds of such files.
#[derive(Clone, Copy, Debug)]
pub enum Shapes<'a> {
    Svg(Letters),
    Pdf,
    /// Of this name, without its ending: what it takes in is named after it.
    Tikz(&'a str),
}

/// A file, and what belongs to it.
pub struct Made {
    pub bytes: Vec<u8>,
    /// Files beside it: what their names have behind its own, and what is in them.
    pub beside: Vec<(String, Vec<u8>)>,
}

/// With the link to what it shows.
pub fn shapes(
    studio: &mut Studio,
    picture: &Picture<'_>,
    shapes: Shapes<'_>,
    link: Option<&str>,
) -> Made {
    let about = About {
        title: picture.title.unwrap_or_default(),
        alternative: &studio.alternative(picture),
        lang: picture.options.lang.id(),
        link,
    };
    let drawing = studio.vector(picture);
    let (bytes, beside) = match shapes {
        Shapes::Svg(letters) => (svg(&drawing, letters, about).into_bytes(), Vec::new()),
        Shapes::Pdf => (pdf_of_one(&drawing, about), Vec::new()),
        Shapes::Tikz(name) => {
            let made = tikz(&drawing, name, about);
            (made.text.into_bytes(), made.images)
        }
    };
    Made { bytes, beside }
}
