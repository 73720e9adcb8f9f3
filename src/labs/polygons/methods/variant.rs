//! Sutherland–Hodgman by one set of rules: how it is called, how it looks at its clip edges, and its pseudocode.

use crate::{
    algo::polygon::Rules,
    labs::{CodeLine, code_line},
};

use super::clip_edge::EdgeLook;

pub const EACH: usize = 0;
pub const FIRST: usize = 1;
pub const EDGES: usize = 2;
pub const IN_IN: usize = 3;
pub const IN_OUT: usize = 4;
pub const OUT_IN: usize = 5;
pub const OUT_OUT: usize = 6;
pub const PASS: usize = 7;

pub type Pseudocode = [CodeLine; PASS + 1];

pub const CODE: Pseudocode = [
    code_line(0, "code-sh-each", "words-sh-each"),
    code_line(1, "code-sh-first", "words-sh-first"),
    code_line(1, "code-sh-edges", "words-sh-edges"),
    code_line(2, "code-sh-in-in", "words-sh-in-in"),
    code_line(2, "code-sh-in-out", "words-sh-in-out"),
    code_line(2, "code-sh-out-in", "words-sh-out-in"),
    code_line(2, "code-sh-out-out", "words-sh-out-out"),
    code_line(1, "code-sh-pass", "words-sh-pass"),
];

pub trait Variant: Rules + 'static {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const LOOK: EdgeLook = EdgeLook::RIGHT;
    const CODE: Pseudocode = CODE;
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}
