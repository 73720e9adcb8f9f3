//! Segments against a box, against planes and in clip space.

use crate::{
    algo::volume::{
        ClipSpace, CohenSutherland3d, CohenSutherland3dInput, HomogeneousLine, LiangBarsky3d,
        LineInput, PlaneLine, VisibleLine,
    },
    case::{Fields, Refusal, Solve},
    input::{Field, Shape},
    text::{Formula, Message, Value},
};

use super::parts::{CLIP_SEGMENT, PLANES, SEGMENT, SOLID_BOX};

const IN_BOX: [Field; 2] = [SOLID_BOX.required(), SEGMENT.required()];

const IS_VISIBLE: Field = Field::required("visible", &Shape::Bool);
const VISIBLE: [Field; 2] = [
    IS_VISIBLE,
    Field::required("segment", &Shape::OrNull(SEGMENT.optional.shape)),
];

fn visible<const N: usize>(output: &VisibleLine<N>) -> Message {
    let place = |at: &[f64; N]| {
        let formula = Formula::default().sym("(").list(at).sym(")");
        Value::Formula(formula)
    };
    match output {
        None => Message::new("case-invisible"),
        Some([p1, p2]) if p1 == p2 => Message::new("case-touch").with("at", place(p1)),
        Some([p1, p2]) => Message::new("case-visible")
            .with("p1", place(p1))
            .with("p2", place(p2)),
    }
}

impl Solve for CohenSutherland3d {
    const FIELDS: &'static [Field] = &IN_BOX;
    const OUTPUT: &'static [Field] = &VISIBLE;

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (bounds, ends) = (fields.need(&SOLID_BOX)?, fields.need(&SEGMENT)?);
        Ok(CohenSutherland3dInput { bounds, ends })
    }

    fn verdict(output: &VisibleLine<3>) -> Message {
        visible(output)
    }
}

impl Solve for LiangBarsky3d {
    const FIELDS: &'static [Field] = &IN_BOX;
    const OUTPUT: &'static [Field] = &VISIBLE;

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (bounds, ends) = (fields.need(&SOLID_BOX)?, fields.need(&SEGMENT)?);
        Ok(LineInput { bounds, ends })
    }

    fn verdict(output: &VisibleLine<3>) -> Message {
        visible(output)
    }
}

impl Solve for PlaneLine {
    const FIELDS: &'static [Field] = &[PLANES.required(), SEGMENT.required()];
    const OUTPUT: &'static [Field] = &VISIBLE;

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (bounds, ends) = (fields.need(&PLANES)?, fields.need(&SEGMENT)?);
        Ok(LineInput { bounds, ends })
    }

    fn verdict(output: &VisibleLine<3>) -> Message {
        visible(output)
    }
}

impl Solve for HomogeneousLine {
    const FIELDS: &'static [Field] = &[CLIP_SEGMENT.required()];
    const OUTPUT: &'static [Field] = &[
        IS_VISIBLE,
        Field::required("segment", &Shape::OrNull(CLIP_SEGMENT.optional.shape)),
    ];

    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal> {
        let (bounds, ends) = (ClipSpace, fields.need(&CLIP_SEGMENT)?);
        Ok(LineInput { bounds, ends })
    }

    fn verdict(output: &VisibleLine<4>) -> Message {
        visible(output)
    }
}
