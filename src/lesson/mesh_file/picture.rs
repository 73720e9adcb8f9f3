//! Reading the picture that a mesh is painted with: PNG or JPEG.

use std::io::Cursor;

use zune_jpeg::{
    JpegDecoder,
    zune_core::{colorspace::ColorSpace, options::DecoderOptions},
};

use crate::{
    geom::Texture,
    labs::space::Picture,
    lesson::{FileError, prelude::*},
};

use super::read_mtl;

/// The picture in the bytes of a PNG or a JPEG file. `None` where they are neither, broken, or more than 8192 texels wide or high.
pub fn read_picture(bytes: &[u8]) -> Option<Picture> {
    Some(Picture::new(read_texture(bytes)?, bytes))
}

/// Its texture: the two kinds are told apart by how they begin.
pub fn read_texture(bytes: &[u8]) -> Option<Texture> {
    let read = if bytes.starts_with(b"\x89PNG") {
        read_png
    } else {
        read_jpeg
    };
    read(bytes)
}

/// Why a mesh that names a material is drawn without its picture.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum PictureFault {
    Elsewhere(String),
    Unread(String, FileError),
    NoMaterial { library: String, name: String },
    Broken(String),
}

impl From<PictureFault> for Diagnostic {
    fn from(fault: PictureFault) -> Self {
        let named = |key, name: &str| Message::new(key).with("name", clipped(name));
        Self::new(match fault {
            PictureFault::Elsewhere(name) => named("picture-elsewhere", &name),
            PictureFault::Unread(name, error) => {
                named("picture-unread", &name).with("reason", Self::from(error))
            }
            PictureFault::NoMaterial { library, name } => {
                named("picture-no-material", &name).with("library", clipped(&library))
            }
            PictureFault::Broken(name) => {
                named("picture-broken", &name).with("most", Texture::MAX_SIDE)
            }
        })
    }
}

/// The picture of a material with its file's name, from the files beside its mesh: `material` is the MTL file's name and its own,
/// `read` reads a file of a name there, and what is `known` already is not read again. `None` where the material has none.
pub fn picture_of(
    material: &[String; 2],
    read: &dyn Fn(&str) -> Result<Vec<u8>, FileError>,
    known: &dyn Fn(&str) -> Option<Picture>,
) -> Result<Option<(String, Picture)>, PictureFault> {
    let beside = |name: &str| {
        if name.contains(['/', '\\']) {
            return Err(PictureFault::Elsewhere(name.to_owned()));
        }
        read(name).map_err(|error| PictureFault::Unread(name.to_owned(), error))
    };
    let [library, name] = material;
    let Some(picture) = read_mtl(&beside(library)?, name) else {
        let (library, name) = (library.clone(), name.clone());
        return Err(PictureFault::NoMaterial { library, name });
    };
    let Some(name) = picture else {
        return Ok(None);
    };
    let picture = match known(&name) {
        Some(picture) => Some(picture),
        None => read_picture(&beside(&name)?),
    };
    match picture {
        Some(picture) => Ok(Some((name, picture))),
        None => Err(PictureFault::Broken(name)),
    }
}

fn read_png(bytes: &[u8]) -> Option<Texture> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().ok()?;
    let header = reader.info();
    let size = [header.width, header.height].map(|side| side as usize);
    if size.iter().any(|&side| side > Texture::MAX_SIDE) {
        return None;
    }
    let mut samples = vec![0; reader.output_buffer_size()?];
    let frame = reader.next_frame(&mut samples).ok()?;
    let texels: Vec<[u8; 3]> = match frame.color_type {
        png::ColorType::Grayscale => samples.iter().map(|&grey| [grey; 3]).collect(),
        png::ColorType::GrayscaleAlpha => samples.chunks_exact(2).map(|it| [it[0]; 3]).collect(),
        png::ColorType::Rgb => samples.as_chunks().0.to_vec(),
        png::ColorType::Rgba => {
            let texels = samples.chunks_exact(4);
            texels.map(|it| [it[0], it[1], it[2]]).collect()
        }
        // Normalized away.
        png::ColorType::Indexed => return None,
    };
    Texture::new(size, texels)
}

fn read_jpeg(bytes: &[u8]) -> Option<Texture> {
    let options = DecoderOptions::default()
        .jpeg_set_out_colorspace(ColorSpace::RGB)
        .set_max_width(Texture::MAX_SIDE)
        .set_max_height(Texture::MAX_SIDE);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    let samples = decoder.decode().ok()?;
    let (width, height) = decoder.dimensions()?;
    Texture::new([width, height], samples.as_chunks().0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_read_and_what_is_none_is_not() {
        let spot = include_bytes!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/assets/meshes/spot/spot_texture.png"
        ));
        let picture = read_picture(spot).unwrap();
        assert_eq!(picture.texture().size(), [1024, 1024]);
        assert_eq!(read_picture(&spot[..5000]), None);
        assert_eq!(read_picture(b"\xff\xd8\xff\xe0 no picture"), None);
        assert_eq!(read_picture(b""), None);
        // A grey one.
        let jpeg = include_bytes!("grey.jpg");
        assert_eq!(read_picture(jpeg).unwrap().texture().size(), [16, 8]);
    }

    #[test]
    fn pngs_of_all_kinds_are_read() {
        for (kind, samples) in [
            (png::ColorType::Grayscale, vec![7]),
            (png::ColorType::GrayscaleAlpha, vec![7, 255]),
            (png::ColorType::Rgb, vec![7, 8, 9]),
            (png::ColorType::Rgba, vec![7, 8, 9, 255]),
        ] {
            let mut bytes = Vec::new();
            let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
            encoder.set_color(kind);
            let mut writer = encoder.write_header().unwrap();
            writer.write_image_data(&samples).unwrap();
            writer.finish().unwrap();
            let texel = read_texture(&bytes).unwrap().at([0.5; 2]);
            assert_eq!(texel[0], 7);
            assert_eq!(texel, if samples.len() < 3 { [7; 3] } else { [7, 8, 9] });
        }
    }
}
