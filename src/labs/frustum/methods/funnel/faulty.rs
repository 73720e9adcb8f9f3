//! "What is wrong here?": the mistakes of [`crate::algo::cull::faulty`], shown on the reader's own scene.

use crate::{
    algo::cull::faulty::{AroundOrigin, Clockwise, ConstantView, OneAngle, TurnsSign},
    labs::but_for,
};

use super::variant::{CODE, CULL, FACE, PLANE, Pseudocode, SPHERE, Variant};

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
