//! The funnel by one set of rules: how it is called, and its pseudocode.

use crate::{
    algo::{cull::CullRules, ring::Right},
    labs::{CodeLine, code_line},
};

/// Lines of the pseudocode.
pub const EACH: usize = 0;
pub const SPHERE: usize = 1;
pub const PLANE: usize = 2;
pub const CULL: usize = 3;
pub const STRADDLES: usize = 4;
pub const TRIANGLE: usize = 5;
pub const FACE: usize = 6;
pub const DRAW: usize = 7;

/// The pseudocode of any variant.
pub type Pseudocode = [CodeLine; DRAW + 1];

/// By the right rules.
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
    /// As lesson files spell the method.
    const ID: &'static str;
    /// Catalogue key of its name.
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
