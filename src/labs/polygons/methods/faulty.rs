//! "What is wrong here?": the mistakes of [`crate::algo::polygon::faulty`], shown on the reader's own input. Each is
//! stepped like the right one, says what it does and not that it is wrong, up to the first step at which it differs.

use crate::{
    algo::polygon::faulty::{
        CutsTwice, DropsOnBorder, EndFirst, Faulty, KeepsUv, LeavesOpen, WalksClockwise,
    },
    labs::{but_for, crossing_formulas::Weights},
};

use super::{
    clip_edge::EdgeLook,
    prelude::*,
    skin::{LabVertex, NamedVertex},
    variant::{CODE, EACH, EDGES, IN_OUT, OUT_IN, Pseudocode, Variant},
};

pub type OnBorder = Faulty<DropsOnBorder>;
pub type Open = Faulty<LeavesOpen>;
pub type Clockwise = Faulty<WalksClockwise>;
pub type Twice = Faulty<CutsTwice>;
pub type EndBeforeCrossing = Faulty<EndFirst>;
pub type Kept = KeepsUv;

impl Variant for DropsOnBorder {
    const ID: &'static str = "faulty-on-border";
    const NAME_KEY: &'static str = "alg-faulty-on-border";
    const LOOK: EdgeLook = EdgeLook {
        is_strict: true,
        ..EdgeLook::RIGHT
    };
    const CODE: Pseudocode = but_for(
        CODE,
        [(EACH, "code-faulty-on-border", "words-faulty-on-border")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-on-border-differs");
}

impl Variant for LeavesOpen {
    const ID: &'static str = "faulty-open";
    const NAME_KEY: &'static str = "alg-faulty-open";
    const CODE: Pseudocode = but_for(CODE, [(EDGES, "code-faulty-open", "words-faulty-open")]);
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-open-differs");
}

impl Variant for WalksClockwise {
    const ID: &'static str = "faulty-clockwise";
    const NAME_KEY: &'static str = "alg-faulty-clockwise";
    const LOOK: EdgeLook = EdgeLook {
        is_flipped: true,
        ..EdgeLook::RIGHT
    };
    const CODE: Pseudocode = but_for(
        CODE,
        [(EACH, "code-faulty-clockwise", "words-faulty-clockwise")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-clockwise-differs");
}

impl Variant for CutsTwice {
    const ID: &'static str = "faulty-twice";
    const NAME_KEY: &'static str = "alg-faulty-twice";
    const CODE: Pseudocode = but_for(
        CODE,
        [
            (IN_OUT, "code-faulty-twice-out", "words-faulty-twice-out"),
            (OUT_IN, "code-faulty-twice-in", "words-faulty-twice-in"),
        ],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-twice-differs");
}

impl Variant for EndFirst {
    const ID: &'static str = "faulty-end-first";
    const NAME_KEY: &'static str = "alg-faulty-end-first";
    const CODE: Pseudocode = but_for(
        CODE,
        [(OUT_IN, "code-faulty-end-first", "words-faulty-end-first")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-end-first-differs");
}

impl LabVertex for KeepsUv {
    fn with_uv(at: Point, uv: [f64; 2]) -> Self {
        Self { at, uv }
    }

    fn uv(&self) -> Option<[f64; 2]> {
        Some(self.uv)
    }

    fn uv_formula(&self, ends: [&NamedVertex<Self>; 2], _: &Weights) -> Option<Formula> {
        let owner = ends.into_iter().find(|end| end.vertex.uv == self.uv)?;
        let formula = Formula::default().sym(format!("uv(I) = uv({}) = ", owner.symbol));
        Some(formula.point(self.uv))
    }
}
