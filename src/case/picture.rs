//! The picture of a case: `size`, its columns and rows.

use crate::{
    algo::surface::Viewport,
    text::{Formula, Message, Value},
};

use super::{Code, Given, Node, Path, Refusal};

/// Columns and rows.
pub(super) fn read_picture(node: &Node<'_>) -> Result<(Viewport, Given), Refusal> {
    let sides: [i64; 2] = node.wholes()?;
    let mut size = [0_u32; 2];
    for (i, (side, given)) in size.iter_mut().zip(sides).enumerate() {
        let path = Path::Index(&node.path, i);
        let problem = Message::new("case-picture-side")
            .with("max", Viewport::MAX_SIDE as usize)
            .with("found", given.to_string());
        if given < 1 {
            return Err(Refusal::at(Code::Degenerate, &path, problem));
        }
        *side = u32::try_from(given).unwrap_or(u32::MAX);
        if *side > Viewport::MAX_SIDE {
            return Err(Refusal::at(Code::TooLarge, &path, problem));
        }
    }
    let viewport = Viewport::new(size, Viewport::ANSWER_BITS);
    let viewport = viewport.ok_or_else(|| {
        let problem = Message::new("case-picture-side").with("max", Viewport::MAX_SIDE as usize);
        Refusal::at(
            Code::TooLarge,
            &node.path,
            problem.with("found", String::new()),
        )
    })?;
    let pixels = Formula::default().num(f64::from(size[0])).sym(" × ");
    let pixels = pixels.num(f64::from(size[1]));
    let told = [Value::Formula(pixels)].into_iter();
    Ok((viewport, Given::new("object-picture", told)))
}
