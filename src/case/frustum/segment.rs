//! The segments of cases, and the boxes that they are clipped against.

use crate::{
    case::{Code, Node, Refusal},
    geom::AlignedBox,
    text::Message,
};

/// Both ends, from one list of numbers.
fn halves<const N: usize, const M: usize>(numbers: [f64; M]) -> [[f64; N]; 2] {
    [0, N].map(|from| std::array::from_fn(|i| numbers[from + i]))
}

/// `[x1, y1, z1, x2, y2, z2]`
pub fn read_segment(node: &Node<'_>) -> Result<[[f64; 3]; 2], Refusal> {
    Ok(halves(node.numbers::<6>()?))
}

/// `[x1, y1, z1, w1, x2, y2, z2, w2]` in clip space, neither end being (0, 0, 0, 0).
pub fn read_clip_segment(node: &Node<'_>) -> Result<[[f64; 4]; 2], Refusal> {
    let ends = halves(node.numbers::<8>()?);
    if ends.contains(&[0.0; 4]) {
        let problem = Message::new("case-no-point");
        return Err(Refusal::at(Code::Degenerate, &node.path, problem));
    }
    Ok(ends)
}

/// A box with an inside: a minimum below its maximum along every axis.
pub fn read_solid_box(node: &Node<'_>) -> Result<AlignedBox, Refusal> {
    let bounds = AlignedBox::new(node.numbers()?);
    let bounds = bounds.map_err(|error| Refusal::space(&node.path, error))?;
    let flat = (0..3).find(|&axis| bounds.min()[axis] == bounds.max()[axis]);
    let Some(axis) = flat else {
        return Ok(bounds);
    };
    let axis_name = ["x", "y", "z"][axis];
    let problem = Message::new("case-flat-box")
        .with("low", format!("{axis_name}min"))
        .with("high", format!("{axis_name}max"))
        .with("at", bounds.min()[axis]);
    Err(Refusal::at(Code::EmptyWindow, &node.path, problem))
}
