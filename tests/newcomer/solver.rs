//! The codes of a bounding box's corners, as a case: a view volume and a box in view space.

use clipscope::{
    algo::cull::Containment,
    case::{Reading, Solve, Verdict},
    geom::AlignedBox,
    input::{Dim, FRUSTUM, Field, Part, Shape},
    text::Message,
};

use super::corner_codes::{CornerCodes, CornerCodesInput};

const BOX: Part<AlignedBox> = Part::new("box", &Shape::Numbers(&[Dim::Exactly(6)]), |got| {
    Ok(AlignedBox::new(got.array())?)
});

impl Solve for CornerCodes {
    const FIELDS: &'static [Field] = &[FRUSTUM.required(), BOX.required()];
    const OUTPUT: &'static [Field] = &[
        Field::required("class", &Shape::Word(&["inside", "outside", "straddles"])),
        Field::required("codes", &Shape::List(&Shape::Text)),
    ];
    const READ: Reading<Self> = |fields| {
        let (volume, bounds) = (fields.need(&FRUSTUM)?, fields.need(&BOX)?);
        let clip_from_box = volume.clip_from_view();
        Ok(CornerCodesInput {
            clip_from_box,
            bounds,
        })
    };
    const VERDICT: Verdict<Self> = |output| {
        Message::new(match output.class {
            Containment::Inside => "case-cull-inside",
            Containment::Outside => "case-box-outside",
            Containment::Straddles => "case-corners-straddles",
        })
    };
}
