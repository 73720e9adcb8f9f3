//! The funnel by one set of rules, the right ones or those of [`crate::algo::cull::faulty`]: how it is called, and its pseudocode.

use crate::{
    algo::cull::{
        CullRules,
        faulty::{AroundOrigin, Clockwise, ConstantView, OneAngle, TurnsSign},
    },
    labs::frustum::prelude::*,
};

pub const EACH: usize = 0;
pub const SPHERE: usize = 1;
pub const PLANE: usize = 2;
pub const CULL: usize = 3;
pub const STRADDLES: usize = 4;
pub const TRIANGLE: usize = 5;
pub const FACE: usize = 6;
pub const DRAW: usize = 7;

const RIGHT: [CodeLine; DRAW + 1] = [
    code_line(0, "code-funnel-each", "words-funnel-each"),
    code_line(1, "code-funnel-sphere", "words-funnel-sphere"),
    code_line(1, "code-funnel-plane", "words-funnel-plane"),
    code_line(2, "code-funnel-cull", "words-funnel-cull"),
    code_line(1, "code-funnel-straddles", "words-funnel-straddles"),
    code_line(2, "code-funnel-triangle", "words-funnel-triangle"),
    code_line(1, "code-funnel-face", "words-funnel-face"),
    code_line(0, "code-funnel-draw", "words-funnel-draw"),
];

/// Rules that can be shown: the right ones, or some with a mistake.
pub trait Variant: CullRules {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}

impl Variant for Right {
    const ID: &'static str = "funnel";
    const NAME_KEY: &'static str = "alg-funnel";
    const CODE: &'static [CodeLine] = &RIGHT;
}

mistakes! { Variant:
    OneAngle {
        "faulty-one-angle", "alg-faulty-one-angle", "faulty-one-angle-differs";
        CODE = RIGHT but PLANE: "code-faulty-one-angle" "words-faulty-one-angle";
    }
    TurnsSign {
        "faulty-turned-sign", "alg-faulty-turned-sign", "faulty-turned-sign-differs";
        CODE = RIGHT but CULL: "code-faulty-turned-sign" "words-faulty-turned-sign";
    }
    AroundOrigin {
        "faulty-around-origin", "alg-faulty-around-origin", "faulty-around-origin-differs";
        CODE = RIGHT but SPHERE: "code-faulty-around-origin" "words-faulty-around-origin";
    }
    Clockwise {
        "faulty-winding", "alg-faulty-winding", "faulty-winding-differs";
        CODE = RIGHT but FACE: "code-faulty-winding" "words-faulty-winding";
    }
    ConstantView {
        "faulty-constant-view", "alg-faulty-constant-view", "faulty-constant-view-differs";
        CODE = RIGHT but FACE: "code-faulty-constant-view" "words-faulty-constant-view";
    }
}
