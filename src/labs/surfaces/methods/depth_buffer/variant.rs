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

pub const CLEAR: usize = 0;
pub const TRIANGLE: usize = 1;
pub const FRAGMENT: usize = 2;
pub const COMPARE: usize = 3;
pub const WRITE: usize = 4;

type Pseudocode = [CodeLine; WRITE + 1];

const RIGHT: Pseudocode = [
    code_line(0, "code-depth-clear", "words-depth-clear"),
    code_line(0, "code-depth-triangle", "words-depth-triangle"),
    code_line(1, "code-depth-fragment", "words-depth-fragment"),
    code_line(2, "code-depth-compare", "words-depth-compare"),
    code_line(3, "code-depth-write", "words-depth-write"),
];

/// Where 1 is near, what is nearer has the greater depth.
const REVERSED: Pseudocode = but_for(
    RIGHT,
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

const ALWAYS: [(usize, &str, &str); 1] = [(
    COMPARE,
    "code-faulty-depth-always",
    "words-faulty-depth-always",
)];
const STRAIGHT: [(usize, &str, &str); 1] = [(
    FRAGMENT,
    "code-faulty-depth-straight",
    "words-faulty-depth-straight",
)];

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
    const CODE: &'static [CodeLine] = &RIGHT;
    const REVERSED: &'static [CodeLine] = &REVERSED;
}

impl Variant for ClearsToNear {
    const ID: &'static str = "faulty-depth-clear";
    const NAME_KEY: &'static str = "alg-faulty-depth-clear";
    const CODE: &'static [CodeLine] = &but_for(
        RIGHT,
        [(CLEAR, "code-faulty-depth-clear", "words-faulty-depth-clear")],
    );
    const REVERSED: &'static [CodeLine] = &but_for(
        REVERSED,
        [(
            CLEAR,
            "code-faulty-depth-clear-reversed",
            "words-faulty-depth-clear-reversed",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-depth-clear-differs");
}

impl Variant for TurnsComparison {
    const ID: &'static str = "faulty-depth-compare";
    const NAME_KEY: &'static str = "alg-faulty-depth-compare";
    const CODE: &'static [CodeLine] = &but_for(
        RIGHT,
        [(
            COMPARE,
            "code-faulty-depth-compare",
            "words-faulty-depth-compare",
        )],
    );
    const REVERSED: &'static [CodeLine] = &but_for(
        REVERSED,
        [(
            COMPARE,
            "code-depth-compare",
            "words-faulty-depth-compare-reversed",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-depth-compare-differs");
}

impl Variant for WritesAlways {
    const ID: &'static str = "faulty-depth-always";
    const NAME_KEY: &'static str = "alg-faulty-depth-always";
    const CODE: &'static [CodeLine] = &but_for(RIGHT, ALWAYS);
    const REVERSED: &'static [CodeLine] = &but_for(REVERSED, ALWAYS);
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-depth-always-differs");
}

impl Variant for StraightDistance {
    const ID: &'static str = "faulty-depth-straight";
    const NAME_KEY: &'static str = "alg-faulty-depth-straight";
    const CODE: &'static [CodeLine] = &but_for(RIGHT, STRAIGHT);
    const REVERSED: &'static [CodeLine] = &but_for(REVERSED, STRAIGHT);
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-depth-straight-differs");
}
