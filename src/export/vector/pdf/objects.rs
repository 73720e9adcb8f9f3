//! Numbers and bytes of a file's objects.

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::Ref;

/// As streams are written.
pub fn deflated(bytes: &[u8]) -> Vec<u8> {
    const LEVEL: u8 = 6;
    compress_to_vec_zlib(bytes, LEVEL)
}

/// Numbers of the file's objects.
pub struct Ids(Ref);

impl Ids {
    pub const fn new() -> Self {
        Self(Ref::new(1))
    }

    pub fn next(&mut self) -> Ref {
        self.0.bump()
    }
}
