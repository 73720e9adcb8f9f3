//! "What is wrong here?": the mistakes of [`crate::algo::volume::faulty`] that triangles know, shown on the reader's own scene.

use crate::{
    algo::volume::faulty::{
        AllSides, DividesFirst, DropsOnPlane, EdgeByEdge, KeepsPlaceInTexture, MissesEdge,
    },
    labs::{CodeLine, but_for},
};

use super::variant::{
    HOMOGENEOUS, Homogeneous, ONE_BY_ONE, ONE_POLYGON, OneByOne, OnePolygon, Variant, homogeneous,
    one_by_one, polygon,
};

impl Variant<OneByOne> for MissesEdge {
    const ID: &'static str = "faulty-missed-edge";
    const NAME_KEY: &'static str = "alg-faulty-missed-edge";
    const CODE: &'static [CodeLine] = &but_for(
        ONE_BY_ONE,
        [(
            one_by_one::ONE,
            "code-faulty-missed-edge",
            "words-faulty-missed-edge",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-missed-edge-differs");
}

impl Variant<OnePolygon> for DropsOnPlane {
    const ID: &'static str = "faulty-on-plane";
    const NAME_KEY: &'static str = "alg-faulty-on-plane";
    const CODE: &'static [CodeLine] = &but_for(
        ONE_POLYGON,
        [(
            polygon::INSIDE,
            "code-faulty-on-plane",
            "words-faulty-on-plane",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-on-plane-differs");
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

impl Variant<OnePolygon> for EdgeByEdge {
    const ID: &'static str = "faulty-edge-by-edge";
    const NAME_KEY: &'static str = "alg-faulty-edge-by-edge";
    const CODE: &'static [CodeLine] = &but_for(
        ONE_POLYGON,
        [(
            polygon::EACH,
            "code-faulty-edge-by-edge",
            "words-faulty-edge-by-edge",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-edge-by-edge-differs");
}

impl Variant<Homogeneous> for AllSides {
    const ID: &'static str = "faulty-all-sides";
    const NAME_KEY: &'static str = "alg-faulty-all-sides";
    const CODE: &'static [CodeLine] = &but_for(
        HOMOGENEOUS,
        [(
            homogeneous::EACH,
            "code-faulty-all-sides",
            "words-faulty-all-sides",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-all-sides-differs");
}

impl Variant<Homogeneous> for DividesFirst {
    const ID: &'static str = "faulty-divided-triangle";
    const NAME_KEY: &'static str = "alg-faulty-divided-triangle";
    const CODE: &'static [CodeLine] = &but_for(
        HOMOGENEOUS,
        [(
            homogeneous::CODES,
            "code-faulty-divided-triangle",
            "words-faulty-divided-triangle",
        )],
    );
    const DIFFERS_KEY: Option<&'static str> = Some("faulty-divided-triangle-differs");
}
