//! The funnel by one set of rules, the right ones or those of [`crate::algo::cull::faulty`]: how it is called, and its pseudocode.

use crate::{
    algo::cull::{
        CullRules,
        faulty::{AroundOrigin, Clockwise, ConstantView, OneAngle, TurnsSign},
    },
    labs::frustum::prelude::*,
};

pseudocode! {
    EACH: 0, "code-funnel-each", "words-funnel-each";
    SPHERE: 1, "code-funnel-sphere", "words-funnel-sphere";
    PLANE: 1, "code-funnel-plane", "words-funnel-plane";
    CULL: 2, "code-funnel-cull", "words-funnel-cull";
    STRADDLES: 1, "code-funnel-straddles", "words-funnel-straddles";
    TRIANGLE: 2, "code-funnel-triangle", "words-funnel-triangle";
    FACE: 1, "code-funnel-face", "words-funnel-face";
    DRAW: 0, "code-funnel-draw", "words-funnel-draw";
}

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
    const CODE: &'static [CodeLine] = &LINES;
}

mistakes! { Variant:
    OneAngle {
        "faulty-one-angle", "alg-faulty-one-angle", "faulty-one-angle-differs";
        CODE = LINES but PLANE: "code-faulty-one-angle" "words-faulty-one-angle";
    }
    TurnsSign {
        "faulty-turned-sign", "alg-faulty-turned-sign", "faulty-turned-sign-differs";
        CODE = LINES but CULL: "code-faulty-turned-sign" "words-faulty-turned-sign";
    }
    AroundOrigin {
        "faulty-around-origin", "alg-faulty-around-origin", "faulty-around-origin-differs";
        CODE = LINES but SPHERE: "code-faulty-around-origin" "words-faulty-around-origin";
    }
    Clockwise {
        "faulty-winding", "alg-faulty-winding", "faulty-winding-differs";
        CODE = LINES but FACE: "code-faulty-winding" "words-faulty-winding";
    }
    ConstantView {
        "faulty-constant-view", "alg-faulty-constant-view", "faulty-constant-view-differs";
        CODE = LINES but FACE: "code-faulty-constant-view" "words-faulty-constant-view";
    }
}
