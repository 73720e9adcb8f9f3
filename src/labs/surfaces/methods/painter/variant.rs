//! What tells painter's algorithm from itself with a mistake: its names and its pseudocode.

use crate::{
    algo::{
        ring::Right,
        surface::{
            SurfaceRules,
            faulty::{KeysOnly, NearestKeys},
        },
    },
    labs::space::prelude::*,
};

pub const KEY: usize = 0;
pub const SORT: usize = 1;
pub const ASK: usize = 2;
pub const OBJECT: usize = 3;
pub const CYCLE: usize = 4;
pub const PLACE: usize = 5;
pub const PAINT: usize = 6;

type Pseudocode = [CodeLine; PAINT + 1];

const RIGHT: Pseudocode = [
    code_line(0, "code-paint-key", "words-paint-key"),
    code_line(0, "code-paint-sort", "words-paint-sort"),
    code_line(0, "code-paint-ask", "words-paint-ask"),
    code_line(1, "code-paint-object", "words-paint-object"),
    code_line(1, "code-paint-cycle", "words-paint-cycle"),
    code_line(1, "code-paint-place", "words-paint-place"),
    code_line(0, "code-paint-paint", "words-paint-paint"),
];

pub trait Variant: SurfaceRules {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const CODE: &'static [CodeLine];
    const DIFFERS_KEY: Option<&'static str> = None;
}

impl Variant for Right {
    const ID: &'static str = "painter";
    const NAME_KEY: &'static str = "alg-painter";
    const CODE: &'static [CodeLine] = &RIGHT;
}

mistakes! { Variant:
    NearestKeys {
        "faulty-painter-nearest", "alg-faulty-painter-nearest", "faulty-painter-nearest-differs";
        CODE = RIGHT but KEY: "code-faulty-painter-nearest" "words-faulty-painter-nearest";
    }
    KeysOnly {
        "faulty-painter-keys", "alg-faulty-painter-keys", "faulty-painter-keys-differs";
        CODE = RIGHT but ASK: "code-faulty-painter-keys" "words-faulty-painter-keys";
    }
}
