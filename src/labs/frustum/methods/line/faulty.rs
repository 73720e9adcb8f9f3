//! "What is wrong here?": the mistake of [`crate::algo::volume::faulty`], shown on the reader's own scene.

use crate::{
    algo::volume::{ClipSpace, faulty::DividesFirst},
    labs::{
        CodeLine, but_for,
        segments::{LineVariant, inequalities::START},
    },
};

use super::variants::HOMOGENEOUS;

impl LineVariant<4, ClipSpace> for DividesFirst {
    const ID: &'static str = "faulty-divide-first";
    const NAME_KEY: &'static str = "alg-faulty-divide-first";
    const CODE: &'static [CodeLine] = &but_for(
        HOMOGENEOUS,
        [(START, "code-faulty-divide", "words-faulty-divide")],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-divide-first-differs");
}
