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

pseudocode! {
    KEY: 0, "code-paint-key", "words-paint-key";
    SORT: 0, "code-paint-sort", "words-paint-sort";
    ASK: 0, "code-paint-ask", "words-paint-ask";
    OBJECT: 1, "code-paint-object", "words-paint-object";
    CYCLE: 1, "code-paint-cycle", "words-paint-cycle";
    PLACE: 1, "code-paint-place", "words-paint-place";
    PAINT: 0, "code-paint-paint", "words-paint-paint";
}

pub trait Variant: SurfaceRules {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const CODE: &'static [CodeLine];
    const DIFFERS_KEY: Option<&'static str> = None;
}

impl Variant for Right {
    const ID: &'static str = "painter";
    const NAME_KEY: &'static str = "alg-painter";
    const CODE: &'static [CodeLine] = &LINES;
}

mistakes! { Variant:
    NearestKeys {
        "faulty-painter-nearest", "alg-faulty-painter-nearest", "faulty-painter-nearest-differs";
        CODE = LINES but KEY: "code-faulty-painter-nearest" "words-faulty-painter-nearest";
    }
    KeysOnly {
        "faulty-painter-keys", "alg-faulty-painter-keys", "faulty-painter-keys-differs";
        CODE = LINES but ASK: "code-faulty-painter-keys" "words-faulty-painter-keys";
    }
}
