//! The funnel by one set of rules, the right ones or those of [`crate::algo::cull::faulty`]: how it is called, and its pseudocode.

use crate::{
    algo::{
        cull::{
            CullRules,
            faulty::{AroundOrigin, Clockwise, ConstantView, OneAngle, TurnsSign},
        },
        ring::Right,
    },
    labs::{but_for, frustum::prelude::*},
};

pub const EACH: usize = 0;
pub const SPHERE: usize = 1;
pub const PLANE: usize = 2;
pub const CULL: usize = 3;
pub const STRADDLES: usize = 4;
pub const TRIANGLE: usize = 5;
pub const FACE: usize = 6;
pub const DRAW: usize = 7;

pub type Pseudocode = [CodeLine; DRAW + 1];

pub const CODE: Pseudocode = [
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
    /// The right pseudocode, but for the line with the mistake.
    const CODE: Pseudocode = CODE;
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}

impl Variant for Right {
    const ID: &'static str = "funnel";
    const NAME_KEY: &'static str = "alg-funnel";
}

impl Variant for OneAngle {
    const ID: &'static str = "faulty-one-angle";
    const NAME_KEY: &'static str = "alg-faulty-one-angle";
    const CODE: Pseudocode = but_for(
        CODE,
        [(PLANE, "code-faulty-one-angle", "words-faulty-one-angle")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-one-angle-differs");
}

impl Variant for TurnsSign {
    const ID: &'static str = "faulty-turned-sign";
    const NAME_KEY: &'static str = "alg-faulty-turned-sign";
    const CODE: Pseudocode = but_for(
        CODE,
        [(CULL, "code-faulty-turned-sign", "words-faulty-turned-sign")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-turned-sign-differs");
}

impl Variant for AroundOrigin {
    const ID: &'static str = "faulty-around-origin";
    const NAME_KEY: &'static str = "alg-faulty-around-origin";
    const CODE: Pseudocode = but_for(
        CODE,
        [(
            SPHERE,
            "code-faulty-around-origin",
            "words-faulty-around-origin",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-around-origin-differs");
}

impl Variant for Clockwise {
    const ID: &'static str = "faulty-winding";
    const NAME_KEY: &'static str = "alg-faulty-winding";
    const CODE: Pseudocode = but_for(
        CODE,
        [(FACE, "code-faulty-winding", "words-faulty-winding")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-winding-differs");
}

impl Variant for ConstantView {
    const ID: &'static str = "faulty-constant-view";
    const NAME_KEY: &'static str = "alg-faulty-constant-view";
    const CODE: Pseudocode = but_for(
        CODE,
        [(
            FACE,
            "code-faulty-constant-view",
            "words-faulty-constant-view",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-constant-view-differs");
}
