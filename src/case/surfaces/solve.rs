//! What each of the lab's algorithms reads, and how its answer is told.

use crate::{
    algo::surface::{
        Bsp, BspChoice, BspInput, BspOutput, BspTooLarge, DepthBuffer, DepthBufferInput,
        DepthBufferOutput, Painter, PainterAnswer, PainterOutput, Picture, RayCasting,
        RayCastingInput, RayCastingOutput,
    },
    case::{Code, Field, Fields, Path, Refusal, SolveTold, Told},
    text::Message,
};

use super::reader::{FIELDS, check_steps, read_surfaces};

impl SolveTold for DepthBuffer {
    const FIELDS: &'static [Field] = FIELDS;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let (surfaces, told) = read_surfaces(fields)?;
        let input = DepthBufferInput::new(surfaces);
        check_steps::<DepthBuffer>(&input, fields.detail())?;
        Ok((input, told))
    }

    fn verdict(output: &DepthBufferOutput) -> Message {
        seen(&output.picture)
    }
}

impl SolveTold for RayCasting {
    const FIELDS: &'static [Field] = FIELDS;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let (surfaces, told) = read_surfaces(fields)?;
        let input = RayCastingInput {
            surfaces,
            pixel: None,
        };
        check_steps::<RayCasting>(&input, fields.detail())?;
        Ok((input, told))
    }

    fn verdict(output: &RayCastingOutput) -> Message {
        seen(&output.picture)
    }
}

impl SolveTold for Painter {
    const FIELDS: &'static [Field] = FIELDS;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let (surfaces, told) = read_surfaces(fields)?;
        check_steps::<Painter>(&surfaces, fields.detail())?;
        Ok((surfaces, told))
    }

    fn verdict(output: &PainterOutput) -> Message {
        match &output.answer {
            PainterAnswer::Order { order, .. } => {
                Message::new("case-painted").with("ids", listed(order))
            }
            PainterAnswer::Cycle { cycle } => {
                Message::new("case-painter-cycle").with("ids", listed(cycle))
            }
        }
    }
}

impl SolveTold for Bsp {
    const FIELDS: &'static [Field] = FIELDS;

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let (surfaces, told) = read_surfaces(fields)?;
        let input = BspInput::new(surfaces, BspChoice::First).map_err(|BspTooLarge| {
            let problem = Message::new("case-bsp-too-large")
                .with("pieces", BspTooLarge::MOST_PIECES)
                .with("questions", BspTooLarge::MOST_QUESTIONS);
            Refusal::at(Code::TooLarge, &Path::Field("triangles"), problem)
        })?;
        check_steps::<Bsp>(&input, fields.detail())?;
        Ok((input, told))
    }

    fn verdict(output: &BspOutput) -> Message {
        with_seen(Message::new("case-bsp-pieces"), &output.picture).with("pieces", output.n_pieces)
    }
}

fn seen(picture: &Picture) -> Message {
    with_seen(Message::new("case-surfaces-seen"), picture)
}

/// How many pixels show a surface.
fn with_seen(message: Message, picture: &Picture) -> Message {
    let ids = picture.ids();
    let n_seen = ids.iter().filter(|id| **id != Picture::BACKGROUND);
    message
        .with("seen", n_seen.count())
        .with("pixels", ids.len())
}

fn listed(ids: &[u32]) -> String {
    let ids: Vec<String> = ids.iter().map(u32::to_string).collect();
    ids.join(", ")
}
