//! What tells the depth buffer from itself with a mistake: its names and its pseudocode.

use crate::{
    algo::{
        ring::Right,
        surface::{
            SurfaceRules,
            faulty::{ClearsToNear, StraightDistance, TurnsComparison, WritesAlways},
        },
    },
    labs::space::prelude::*,
};

pseudocode! {
    CLEAR: 0, "code-depth-clear", "words-depth-clear";
    TRIANGLE: 0, "code-depth-triangle", "words-depth-triangle";
    FRAGMENT: 1, "code-depth-fragment", "words-depth-fragment";
    COMPARE: 2, "code-depth-compare", "words-depth-compare";
    WRITE: 3, "code-depth-write", "words-depth-write";
}

/// Where 1 is near, what is nearer has the greater depth.
const REVERSED: [CodeLine; LINES.len()] = but_for(
    LINES,
    [
        (
            CLEAR,
            "code-depth-clear-reversed",
            "words-depth-clear-reversed",
        ),
        (
            COMPARE,
            "code-depth-compare-reversed",
            "words-depth-compare",
        ),
        (WRITE, "code-depth-write", "words-depth-write-reversed"),
    ],
);

pub trait Variant: SurfaceRules {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const CODE: &'static [CodeLine];
    /// The same where depth is reversed.
    const REVERSED: &'static [CodeLine];
    const DIFFERS_KEY: Option<&'static str> = None;
}

impl Variant for Right {
    const ID: &'static str = "depth-buffer";
    const NAME_KEY: &'static str = "alg-depth-buffer";
    const CODE: &'static [CodeLine] = &LINES;
    const REVERSED: &'static [CodeLine] = &REVERSED;
}

mistakes! { Variant:
    ClearsToNear {
        "faulty-depth-clear", "alg-faulty-depth-clear", "faulty-depth-clear-differs";
        CODE = LINES but CLEAR: "code-faulty-depth-clear" "words-faulty-depth-clear";
        REVERSED = REVERSED but
            CLEAR: "code-faulty-depth-clear-reversed" "words-faulty-depth-clear-reversed";
    }
    TurnsComparison {
        "faulty-depth-compare", "alg-faulty-depth-compare", "faulty-depth-compare-differs";
        CODE = LINES but COMPARE: "code-faulty-depth-compare" "words-faulty-depth-compare";
        REVERSED = REVERSED but
            COMPARE: "code-depth-compare" "words-faulty-depth-compare-reversed";
    }
    WritesAlways {
        "faulty-depth-always", "alg-faulty-depth-always", "faulty-depth-always-differs";
        CODE = LINES but COMPARE: "code-faulty-depth-always" "words-faulty-depth-always";
        REVERSED = REVERSED but COMPARE: "code-faulty-depth-always" "words-faulty-depth-always";
    }
    StraightDistance {
        "faulty-depth-straight", "alg-faulty-depth-straight", "faulty-depth-straight-differs";
        CODE = LINES but FRAGMENT: "code-faulty-depth-straight" "words-faulty-depth-straight";
        REVERSED = REVERSED but
            FRAGMENT: "code-faulty-depth-straight" "words-faulty-depth-straight";
    }
}
