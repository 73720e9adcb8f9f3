//! What each of the lab's line clippers reads, and how its answer is told.

use crate::{
    algo::volume::{
        ClipSpace, CohenSutherland3d, CohenSutherland3dInput, HomogeneousLine, LiangBarsky3d,
        LineInput, PlaneLine, VisibleLine,
    },
    case::{Field, Fields, Refusal, SolveTold, Told},
    text::{Formula, Message, Value},
};

use super::reader::Reader;

const BOX: [Field; 2] = [Field::required("box"), Field::required("segment")];

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

impl SolveTold for CohenSutherland3d {
    const FIELDS: &'static [Field] = &BOX;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (bounds, ends) = (reader.solid_box()?, reader.segment()?);
        let input = CohenSutherland3dInput { bounds, ends };
        Ok((input, reader.told()))
    }

    fn verdict(output: &VisibleLine<3>) -> Message {
        visible(output)
    }
}

impl SolveTold for LiangBarsky3d {
    const FIELDS: &'static [Field] = &BOX;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (bounds, ends) = (reader.solid_box()?, reader.segment()?);
        Ok((LineInput { bounds, ends }, reader.told()))
    }

    fn verdict(output: &VisibleLine<3>) -> Message {
        visible(output)
    }
}

impl SolveTold for PlaneLine {
    const FIELDS: &'static [Field] = &[Field::required("planes"), Field::required("segment")];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (bounds, ends) = (reader.planes()?, reader.segment()?);
        Ok((LineInput { bounds, ends }, reader.told()))
    }

    fn verdict(output: &VisibleLine<3>) -> Message {
        visible(output)
    }
}

impl SolveTold for HomogeneousLine {
    const FIELDS: &'static [Field] = &[Field::required("segment")];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let (bounds, ends) = (ClipSpace, reader.clip_segment()?);
        Ok((LineInput { bounds, ends }, reader.told()))
    }

    fn verdict(output: &VisibleLine<4>) -> Message {
        visible(output)
    }
}
