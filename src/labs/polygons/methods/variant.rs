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

pseudocode! {
    EACH: 0, "code-sh-each", "words-sh-each";
    FIRST: 1, "code-sh-first", "words-sh-first";
    EDGES: 1, "code-sh-edges", "words-sh-edges";
    IN_IN: 2, "code-sh-in-in", "words-sh-in-in";
    IN_OUT: 2, "code-sh-in-out", "words-sh-in-out";
    OUT_IN: 2, "code-sh-out-in", "words-sh-out-in";
    OUT_OUT: 2, "code-sh-out-out", "words-sh-out-out";
    PASS: 1, "code-sh-pass", "words-sh-pass";
}

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
    const CODE: &'static [CodeLine] = &LINES;
}

mistakes! { Variant:
    DropsOnBorder {
        "faulty-on-border", "alg-faulty-on-border", "faulty-on-border-differs";
        CODE = LINES but EACH: "code-faulty-on-border" "words-faulty-on-border";
    }
    LeavesOpen {
        "faulty-open", "alg-faulty-open", "faulty-open-differs";
        CODE = LINES but EDGES: "code-faulty-open" "words-faulty-open";
    }
    WalksClockwise {
        "faulty-clockwise", "alg-faulty-clockwise", "faulty-clockwise-differs";
        CODE = LINES but EACH: "code-faulty-clockwise" "words-faulty-clockwise";
    }
    CutsTwice {
        "faulty-twice", "alg-faulty-twice", "faulty-twice-differs";
        CODE = LINES but
            IN_OUT: "code-faulty-twice-out" "words-faulty-twice-out",
            OUT_IN: "code-faulty-twice-in" "words-faulty-twice-in";
    }
    EndFirst {
        "faulty-end-first", "alg-faulty-end-first", "faulty-end-first-differs";
        CODE = LINES but OUT_IN: "code-faulty-end-first" "words-faulty-end-first";
    }
}
