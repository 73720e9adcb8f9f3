//! Sutherland–Hodgman by one set of rules: how it is called, and its pseudocode. "What is wrong here?": the mistakes of
//! [`crate::algo::polygon::faulty`] are stepped like the right rules, and say what they do and not that it is wrong, up to the
//! first step at which they differ.

use crate::{
    algo::polygon::{
        Right, Rules,
        faulty::{CutsTwice, DropsOnBorder, EndFirst, LeavesOpen, WalksClockwise},
    },
    labs::prelude::*,
};

pub const EACH: usize = 0;
pub const FIRST: usize = 1;
pub const EDGES: usize = 2;
pub const IN_IN: usize = 3;
pub const IN_OUT: usize = 4;
pub const OUT_IN: usize = 5;
pub const OUT_OUT: usize = 6;
pub const PASS: usize = 7;

const RIGHT: [CodeLine; PASS + 1] = [
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
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}

impl Variant for Right {
    const ID: &'static str = "sutherland-hodgman";
    const NAME_KEY: &'static str = "alg-sutherland-hodgman";
    const CODE: &'static [CodeLine] = &RIGHT;
}

mistakes! { Variant:
    DropsOnBorder {
        "faulty-on-border", "alg-faulty-on-border", "faulty-on-border-differs";
        CODE = RIGHT but EACH: "code-faulty-on-border" "words-faulty-on-border";
    }
    LeavesOpen {
        "faulty-open", "alg-faulty-open", "faulty-open-differs";
        CODE = RIGHT but EDGES: "code-faulty-open" "words-faulty-open";
    }
    WalksClockwise {
        "faulty-clockwise", "alg-faulty-clockwise", "faulty-clockwise-differs";
        CODE = RIGHT but EACH: "code-faulty-clockwise" "words-faulty-clockwise";
    }
    CutsTwice {
        "faulty-twice", "alg-faulty-twice", "faulty-twice-differs";
        CODE = RIGHT but
            IN_OUT: "code-faulty-twice-out" "words-faulty-twice-out",
            OUT_IN: "code-faulty-twice-in" "words-faulty-twice-in";
    }
    EndFirst {
        "faulty-end-first", "alg-faulty-end-first", "faulty-end-first-differs";
        CODE = RIGHT but OUT_IN: "code-faulty-end-first" "words-faulty-end-first";
    }
}
