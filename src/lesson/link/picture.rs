//! The link that a picture carries: in an iTXt chunk of a PNG file, among the metadata of an SVG file, where viewers and editors leave it.

use std::io::Cursor;

use png::text_metadata::ITXtChunk;

/// The keyword of the chunk.
const KEYWORD: &str = "clipscope";
const SIGNATURE: [u8; 8] = *b"\x89PNG\r\n\x1a\n";
/// More of a link is not unpacked.
const MOST_LINK_BYTES: usize = 1 << 20;

/// May these bytes be a picture that carries a link: a PNG or SVG file?
pub fn is_picture(bytes: &[u8]) -> bool {
    bytes.starts_with(&SIGNATURE) || bytes.starts_with(b"<svg ")
}

/// The link as an SVG file carries it, among what describes the file.
pub fn link_element(link: &str) -> String {
    let link = link.replace('&', "&amp;").replace('<', "&lt;");
    format!("{OPEN}{link}{CLOSE}")
}

const OPEN: &str = "<clipscope xmlns=\"clipscope:link\">";
const CLOSE: &str = "</clipscope>";

fn link_in_svg(text: &str) -> Option<String> {
    let (_, rest) = text.split_once(OPEN)?;
    let (link, _) = rest.split_once(CLOSE)?;
    let is_small = link.len() <= MOST_LINK_BYTES;
    is_small.then(|| link.replace("&lt;", "<").replace("&amp;", "&"))
}

/// Has this encoder put the link before the picture.
pub fn with_link<W: std::io::Write>(
    encoder: &mut png::Encoder<'_, W>,
    link: &str,
) -> Result<(), png::EncodingError> {
    encoder.add_itxt_chunk(KEYWORD.to_owned(), link.to_owned())
}

/// The link in a PNG or SVG file, where it has one.
pub fn link_in(bytes: &[u8]) -> Option<String> {
    if !bytes.starts_with(&SIGNATURE) {
        return link_in_svg(str::from_utf8(bytes).ok()?);
    }
    let decoder = png::Decoder::new(Cursor::new(bytes));
    let mut reader = decoder.read_info().ok()?;
    let text = |reader: &png::Reader<_>| link_of(&reader.info().utf8_text);
    // An editor may have put it behind the picture.
    text(&reader).or_else(|| {
        reader.finish().ok()?;
        text(&reader)
    })
}

fn link_of(chunks: &[ITXtChunk]) -> Option<String> {
    let chunk = chunks.iter().find(|chunk| chunk.keyword == KEYWORD)?;
    let mut chunk = chunk.clone();
    chunk.decompress_text_with_limit(MOST_LINK_BYTES).ok()?;
    chunk.get_text().ok()
}
