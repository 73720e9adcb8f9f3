//! A method by one set of rules: how it is called, and its pseudocode.

use crate::{
    algo::{
        ring::{Right, Rules},
        volume::{SpaceVertex, TrianglePlanes, VolumeRules},
    },
    labs::{CodeLine, but_for},
};

use super::{
    super::super::Scene,
    code::{HOMOGENEOUS, ONE_BY_ONE, ONE_POLYGON, polygon},
};

/// Triangle by triangle.
pub struct OneByOne;
/// One polygon, fanned at the end.
pub struct OnePolygon;
/// Before the divide.
pub struct Homogeneous;

/// Rules by which the method `M` can be shown: the right ones, or some with a mistake.
pub trait Variant<M>: VolumeRules {
    /// As lesson files spell the method.
    const ID: &'static str;
    /// Catalogue key of its name.
    const NAME_KEY: &'static str;
    /// The right pseudocode, but for the line with the mistake.
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
    /// Have its corners a place in a texture?
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

/// The right rules, on a triangle with a texture.
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

/// The scene's triangle, and the planes of its volume in the world.
pub fn input(scene: &Scene, is_textured: bool) -> TrianglePlanes {
    let corners = scene.places.triangle();
    TrianglePlanes {
        planes: scene.culler().planes_in_world().to_vec(),
        triangle: std::array::from_fn(|i| SpaceVertex {
            at: corners[i],
            uv: is_textured.then_some(UV[i]),
        }),
    }
}
