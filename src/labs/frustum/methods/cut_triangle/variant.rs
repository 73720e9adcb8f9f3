//! A method by one set of rules: how it is called, its pseudocode, and the lines in that. With the mistakes of
//! [`crate::algo::volume::faulty`] that triangles know.

use crate::{
    algo::{
        ring::Rules,
        volume::faulty::{
            AllSides, DividesFirst, DropsOnPlane, EdgeByEdge, KeepsPlaceInTexture, MissesEdge,
        },
    },
    labs::frustum::prelude::*,
};

use homogeneous::LINES as HOMOGENEOUS;
use one_by_one::LINES as ONE_BY_ONE;
use polygon::LINES as ONE_POLYGON;

pub mod polygon {
    use crate::labs::prelude::*;

    pseudocode! {
        EACH: 0, "code-ip-each", "words-ip-each";
        FIRST: 1, "code-ip-first", "words-ip-first";
        DISTANCE: 1, "code-ip-distance", "words-ip-distance";
        CROSS: 2, "code-ip-cross", "words-ip-cross";
        INSIDE: 2, "code-ip-inside", "words-ip-inside";
        PASS: 1, "code-ip-pass", "words-ip-pass";
        FAN: 0, "code-ip-fan", "words-ip-fan";
    }
}

pub mod one_by_one {
    use crate::labs::prelude::*;

    pseudocode! {
        EACH: 0, "code-pat-each", "words-pat-each";
        TRIANGLE: 1, "code-pat-triangle", "words-pat-triangle";
        THREE: 2, "code-pat-three", "words-pat-three";
        TWO: 2, "code-pat-two", "words-pat-two";
        ONE: 2, "code-pat-one", "words-pat-one";
        NONE: 2, "code-pat-none", "words-pat-none";
        PASS: 1, "code-pat-pass", "words-pat-pass";
    }
}

pub mod homogeneous {
    use crate::labs::prelude::*;

    pseudocode! {
        CODES: 0, "code-ht-codes", "words-ht-codes";
        DECIDE: 0, "code-ht-decide", "words-ht-decide";
        EACH: 0, "code-ht-each", "words-ht-each";
        FIRST: 1, "code-ht-first", "words-ip-first";
        BOUND: 1, "code-ht-bound", "words-ht-bound";
        CROSS: 2, "code-ht-cross", "words-ht-cross";
        INSIDE: 2, "code-ht-inside", "words-ip-inside";
        FAN: 0, "code-ht-fan", "words-ht-fan";
    }
}

pub struct OneByOne;
pub struct OnePolygon;
pub struct Homogeneous;

/// Rules by which the method `M` can be shown: the right ones, or some with a mistake.
pub trait Variant<M>: VolumeRules {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
    const IS_TEXTURED: bool = false;
    /// Does the texture's place go evenly over the screen, and not over the triangle?
    const IS_EVEN_ON_SCREEN: bool = false;
}

impl Variant<OneByOne> for Right {
    const ID: &'static str = "plane-at-a-time";
    const NAME_KEY: &'static str = "alg-plane-at-a-time";
    const CODE: &'static [CodeLine] = &ONE_BY_ONE;
}

impl Variant<OnePolygon> for Right {
    const ID: &'static str = "intersection-polygon";
    const NAME_KEY: &'static str = "alg-intersection-polygon";
    const CODE: &'static [CodeLine] = &ONE_POLYGON;
}

impl Variant<Homogeneous> for Right {
    const ID: &'static str = "homogeneous-triangle";
    const NAME_KEY: &'static str = "alg-homogeneous-triangle";
    const CODE: &'static [CodeLine] = &HOMOGENEOUS;
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WithTexture;

impl Rules for WithTexture {}

impl VolumeRules for WithTexture {}

impl Variant<OnePolygon> for WithTexture {
    const ID: &'static str = "textured-triangle";
    const NAME_KEY: &'static str = "alg-textured-triangle";
    const CODE: &'static [CodeLine] = &ONE_POLYGON;
    const IS_TEXTURED: bool = true;
}

/// The right rules, and then a screen that is filled without a divide: the texture's place goes evenly over it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EvenOnScreen;

impl Rules for EvenOnScreen {}

impl VolumeRules for EvenOnScreen {}

impl Variant<OnePolygon> for EvenOnScreen {
    const ID: &'static str = "undivided-texture";
    const NAME_KEY: &'static str = "alg-undivided-texture";
    const CODE: &'static [CodeLine] = &but_for(
        ONE_POLYGON,
        [(
            polygon::FAN,
            "code-undivided-texture",
            "words-undivided-texture",
        )],
    );
    const IS_TEXTURED: bool = true;
    const IS_EVEN_ON_SCREEN: bool = true;
}

/// Where in the texture the corners are: a half of a square.
pub const UV: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

pub fn input(scene: &Scene, is_textured: bool) -> TrianglePlanes {
    let corners = scene.places().triangle;
    TrianglePlanes {
        planes: scene.culler().planes_in_world().to_vec(),
        triangle: std::array::from_fn(|i| SpaceVertex {
            at: corners[i],
            uv: is_textured.then_some(UV[i]),
        }),
    }
}

impl Variant<OnePolygon> for KeepsPlaceInTexture {
    const ID: &'static str = "faulty-kept-uv";
    const NAME_KEY: &'static str = "alg-faulty-kept-uv";
    const CODE: &'static [CodeLine] = &but_for(
        ONE_POLYGON,
        [(
            polygon::CROSS,
            "code-faulty-kept-uv",
            "words-faulty-kept-uv",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-kept-uv-differs");
    const IS_TEXTURED: bool = true;
}

mistakes! { Variant<OneByOne>:
    MissesEdge {
        "faulty-missed-edge", "alg-faulty-missed-edge", "faulty-missed-edge-differs";
        CODE = ONE_BY_ONE but one_by_one::ONE: "code-faulty-missed-edge" "words-faulty-missed-edge";
    }
}

mistakes! { Variant<OnePolygon>:
    DropsOnPlane {
        "faulty-on-plane", "alg-faulty-on-plane", "faulty-on-plane-differs";
        CODE = ONE_POLYGON but
            polygon::FIRST: "code-faulty-on-plane-first" "words-faulty-on-plane-first",
            polygon::INSIDE: "code-faulty-on-plane" "words-faulty-on-plane";
    }
    EdgeByEdge {
        "faulty-edge-by-edge", "alg-faulty-edge-by-edge", "faulty-edge-by-edge-differs";
        CODE = ONE_POLYGON but polygon::EACH: "code-faulty-edge-by-edge" "words-faulty-edge-by-edge";
    }
}

mistakes! { Variant<Homogeneous>:
    AllSides {
        "faulty-all-sides", "alg-faulty-all-sides", "faulty-all-sides-differs";
        CODE = HOMOGENEOUS but homogeneous::EACH: "code-faulty-all-sides" "words-faulty-all-sides";
    }
    DividesFirst {
        "faulty-divided-triangle", "alg-faulty-divided-triangle", "faulty-divided-triangle-differs";
        CODE = HOMOGENEOUS but
            homogeneous::CODES: "code-faulty-divided-triangle" "words-faulty-divided-triangle";
    }
}
