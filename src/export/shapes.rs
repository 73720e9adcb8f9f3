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

impl From<Vec<u8>> for Made {
    /// Of a file that nothing belongs to.
    fn from(bytes: Vec<u8>) -> Self {
        Self {
            bytes,
            beside: Vec::new(),
        }
    }
}

/// With the link to what it shows.
pub fn shapes(
    studio: &mut Studio,
    picture: &Picture<'_>,
    shapes: Shapes<'_>,
    link: Option<&str>,
) -> Made {
    let (drawing, alternative) = studio.vector(picture);
    let about = About {
        title: picture.title.unwrap_or_default(),
        alternative: &alternative,
        lang: picture.options.lang.id(),
        link,
    };
    match shapes {
        Shapes::Svg(letters) => svg(&drawing, letters, about).into_bytes().into(),
        Shapes::Pdf => pdf_of_one(&drawing, about).into(),
        Shapes::Tikz(name) => {
            let made = tikz(&drawing, name, about);
            Made {
                bytes: made.text.into_bytes(),
                beside: made.images,
            }
        }
    }
}
