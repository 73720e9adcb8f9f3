//! How each line clipper is called, and its pseudocode: seven lines each, of the same sense.

use crate::{
    algo::volume::faulty::DividesFirst,
    labs::{
        frustum::prelude::*,
        segments::inequalities::{ACCEPT, N_LINES, START},
    },
};

pub type Pseudocode = [CodeLine; N_LINES];

pub const HOMOGENEOUS: Pseudocode = [
    code_line(0, "code-hl-start", "words-hl-start"),
    code_line(0, "code-hl-each", "words-hl-each"),
    code_line(1, "code-pl-parallel", "words-lb-parallel"),
    code_line(1, "code-hl-enter", "words-hl-enter"),
    code_line(1, "code-hl-leave", "words-hl-leave"),
    code_line(1, "code-hl-empty", "words-lb-empty"),
    code_line(0, "code-hl-accept", "words-hl-accept"),
];

impl LineVariant<3, AlignedBox> for Right {
    const ID: &'static str = "liang-barsky-3d";
    const NAME_KEY: &'static str = "alg-liang-barsky-3d";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-lb-start", "words-lb-start"),
        code_line(0, "code-lb3-each", "words-lb3-each"),
        code_line(1, "code-lb-parallel", "words-lb-parallel"),
        code_line(1, "code-lb-enter", "words-lb-enter"),
        code_line(1, "code-lb-leave", "words-lb-leave"),
        code_line(1, "code-lb-empty", "words-lb-empty"),
        code_line(0, "code-lb-accept", "words-lb-accept"),
    ];
}

impl LineVariant<3, Vec<Plane>> for Right {
    const ID: &'static str = "plane-line";
    const NAME_KEY: &'static str = "alg-plane-line";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-pl-start", "words-pl-start"),
        code_line(0, "code-pl-each", "words-pl-each"),
        code_line(1, "code-pl-parallel", "words-lb-parallel"),
        code_line(1, "code-pl-enter", "words-pl-enter"),
        code_line(1, "code-pl-leave", "words-pl-leave"),
        code_line(1, "code-pl-empty", "words-lb-empty"),
        code_line(0, "code-pl-accept", "words-lb-accept"),
    ];
}

impl LineVariant<4, ClipSpace> for Right {
    const ID: &'static str = "homogeneous-line";
    const NAME_KEY: &'static str = "alg-homogeneous-line";
    const CODE: &'static [CodeLine] = &HOMOGENEOUS;
}

mistakes! { LineVariant<4, ClipSpace>:
    DividesFirst {
        "faulty-divide-first", "alg-faulty-divide-first", "faulty-divide-first-differs";
        CODE = HOMOGENEOUS but START: "code-faulty-divide" "words-faulty-divide", ACCEPT: "code-faulty-divide-accept" "words-faulty-divide-accept";
    }
}
