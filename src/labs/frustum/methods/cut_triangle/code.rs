//! Pseudocode of the methods, and the lines in it.

use crate::labs::{CodeLine, code_line};

/// Lines of the pseudocode of one polygon.
pub mod polygon {
    pub const EACH: usize = 0;
    pub const DISTANCE: usize = 1;
    pub const INSIDE: usize = 2;
    pub const CROSS: usize = 3;
    pub const PASS: usize = 4;
    pub const FAN: usize = 5;
}

/// As one polygon.
pub const ONE_POLYGON: [CodeLine; 6] = [
    code_line(0, "code-ip-each", "words-ip-each"),
    code_line(1, "code-ip-distance", "words-ip-distance"),
    code_line(1, "code-ip-inside", "words-ip-inside"),
    code_line(1, "code-ip-cross", "words-ip-cross"),
    code_line(1, "code-ip-pass", "words-ip-pass"),
    code_line(0, "code-ip-fan", "words-ip-fan"),
];

/// Lines of the pseudocode of triangle by triangle.
pub mod one_by_one {
    pub const EACH: usize = 0;
    pub const THREE: usize = 2;
    pub const TWO: usize = 3;
    pub const ONE: usize = 4;
    pub const NONE: usize = 5;
    pub const PASS: usize = 6;
}

/// Triangle by triangle.
pub const ONE_BY_ONE: [CodeLine; 7] = [
    code_line(0, "code-pat-each", "words-pat-each"),
    code_line(1, "code-pat-triangle", "words-pat-triangle"),
    code_line(2, "code-pat-three", "words-pat-three"),
    code_line(2, "code-pat-two", "words-pat-two"),
    code_line(2, "code-pat-one", "words-pat-one"),
    code_line(2, "code-pat-none", "words-pat-none"),
    code_line(1, "code-pat-pass", "words-pat-pass"),
];

/// Lines of the pseudocode before the divide.
pub mod homogeneous {
    pub const CODES: usize = 0;
    pub const DECIDE: usize = 1;
    pub const EACH: usize = 2;
    pub const BOUND: usize = 3;
    pub const CROSS: usize = 4;
    pub const FAN: usize = 5;
}

/// Before the divide.
pub const HOMOGENEOUS: [CodeLine; 6] = [
    code_line(0, "code-ht-codes", "words-ht-codes"),
    code_line(0, "code-ht-decide", "words-ht-decide"),
    code_line(0, "code-ht-each", "words-ht-each"),
    code_line(1, "code-ht-bound", "words-ht-bound"),
    code_line(1, "code-ht-cross", "words-ht-cross"),
    code_line(0, "code-ht-fan", "words-ht-fan"),
];
