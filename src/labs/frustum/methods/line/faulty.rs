//! "What is wrong here?": the mistake of [`crate::algo::volume::faulty`], shown on the reader's own scene.

use crate::{
    algo::volume::{ClipSpace, faulty::DividesFirst},
    labs::{CodeLine, code_line},
};

use super::{
    look::Variant,
    variants::{HOMOGENEOUS, Pseudocode, START},
};

const CODE: Pseudocode = {
    let mut lines = HOMOGENEOUS;
    lines[START] = code_line(0, "code-faulty-divide", "words-faulty-divide");
    lines
};

impl Variant<4, ClipSpace> for DividesFirst {
    const ID: &'static str = "faulty-divide-first";
    const NAME_KEY: &'static str = "alg-faulty-divide-first";
    const CODE: &'static [CodeLine] = &CODE;
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-divide-first-differs");
}
