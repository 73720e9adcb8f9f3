//! How a link spells what it holds: text in signs that an address takes.

use base64::{
    Engine,
    alphabet::URL_SAFE,
    engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig},
};
use miniz_oxide::{
    deflate::compress_to_vec,
    inflate::{TINFLStatus, decompress_to_vec_with_limit},
};

use super::error::LinkError;

/// A scene's text may be so long, some four times what a link of ours holds of a scene drawn by lot: of a link that unpacks to more,
/// reading and recording would take longer than one waits for an answer.
pub const MOST_TEXT: usize = 1 << 18;
/// What is packed of it.
const MOST_PACKED: usize = 1 << 18;
/// The smallest that deflate makes.
const LEVEL: u8 = 10;

/// Written without padding; read with it, too.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &URL_SAFE,
    GeneralPurposeConfig::new()
        .with_encode_padding(false)
        .with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

pub fn packed(text: &str) -> String {
    BASE64.encode(compress_to_vec(text.as_bytes(), LEVEL))
}

pub fn unpacked(packed: &str) -> Result<String, LinkError> {
    if packed.len() > MOST_PACKED {
        return Err(LinkError::TooLarge);
    }
    let packed = unescaped(packed).ok_or(LinkError::Damaged)?;
    let bytes = BASE64.decode(packed).map_err(|_| LinkError::Damaged)?;
    let inflated = decompress_to_vec_with_limit(&bytes, MOST_TEXT);
    let text = inflated.map_err(|error| match error.status {
        TINFLStatus::HasMoreOutput => LinkError::TooLarge,
        _ => LinkError::Damaged,
    })?;
    String::from_utf8(text).map_err(|_| LinkError::Damaged)
}

/// Signs that stand for themselves in the part of an address behind `#`, and for nothing else in a link.
const fn is_plain(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'.' | b'_' | b'~' | b'/' | b',' | b':')
}

pub fn escaped(text: &str) -> String {
    let escape = |byte: u8| match byte {
        b' ' => "+".to_owned(),
        byte if is_plain(byte) => char::from(byte).to_string(),
        byte => format!("%{byte:02X}"),
    };
    text.bytes().map(escape).collect()
}

/// None where what follows a `%` is no byte, or the bytes are no text.
pub fn unescaped(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'+' => b' ',
            b'%' => {
                let mut digit = || char::from(rest.next()?).to_digit(16);
                (digit()? * 16 + digit()?) as u8
            }
            byte => byte,
        });
    }
    String::from_utf8(bytes).ok()
}
