//! What all of the lab's cases give.

use std::{convert::Infallible, ops::ControlFlow};

use crate::{
    algo::surface::Surfaces,
    case::{
        Code, Detail, Field, Fields, Given, Node, Path, Refusal, Told, picture::read_picture,
        volume::read_volume,
    },
    text::{Formula, Message, Value},
    trace::told::{Listening, Method},
};

/// In the order in which they are checked.
pub const FIELDS: &[Field] = &[
    Field::required("size"),
    Field::required("frustum"),
    Field::required("triangles"),
    Field::optional("cull"),
];

/// A report of more pixels, or of more steps, is refused: each step is told with the picture so far.
const MOST_IN_REPORT: usize = 65_536;

/// What is seen, by whom, and with how many pixels.
pub fn read_surfaces(fields: &Fields<'_>) -> Result<(Surfaces, Told), Refusal> {
    let size = fields.need("size")?;
    let (viewport, picture) = read_picture(&size)?;
    let n_pixels = viewport.size().map(|side| side as usize).iter().product();
    if n_pixels > fields.detail().limit(MOST_IN_REPORT) {
        let problem = too_many("case-too-many-raster-pixels", n_pixels);
        return Err(Refusal::at(Code::TooLarge, &size.path, problem));
    }
    let frustum = fields.need("frustum")?;
    let (volume, seen) = read_volume(&frustum, fields.detail())?;
    let list = fields.need("triangles")?;
    let triangles: Vec<[[f64; 3]; 3]> = list.list(|node: &Node<'_>| node.rows())?;
    let mut given = vec![picture, seen, told(&triangles)];
    let culls_backs = match fields.get("cull") {
        Some(node) => {
            node.choice(&[("back", ())])?;
            let backs = [Value::Term("case-backs")].into_iter();
            given.push(Given::new("object-culled", backs));
            true
        }
        None => false,
    };
    // Sides and numbers have been looked at: it can only be too many triangles, more than a line holds.
    let surfaces =
        Surfaces::new(viewport.size(), volume, triangles, culls_backs).ok_or_else(|| {
            let problem = too_many("case-too-many-steps", Surfaces::MOST_TRIANGLES);
            Refusal::at(Code::TooLarge, &list.path, problem)
        })?;
    Ok((surfaces, Box::new(move || given.clone())))
}

/// Refuses a report of too many steps.
pub fn check_steps<M: Method>(input: &M::Input, detail: Detail) -> Result<(), Refusal> {
    let most = detail.limit(MOST_IN_REPORT);
    // The bound may be far above what there will be.
    if M::max_events(input) <= most {
        return Ok(());
    }
    let mut n_steps = 0;
    let mut counting = Listening(|_: &M::Held, _| {
        n_steps += 1;
        ControlFlow::<Infallible>::Continue(())
    });
    let ControlFlow::Continue(()) = M::run::<f64, _>(input, &mut M::begin(input), &mut counting);
    if n_steps <= most {
        return Ok(());
    }
    let problem = too_many("case-too-many-steps", n_steps);
    Err(Refusal::at(
        Code::TooLarge,
        &Path::Field("triangles"),
        problem,
    ))
}

fn too_many(key: &'static str, found: usize) -> Message {
    Message::new(key)
        .with("found", found)
        .with("max", MOST_IN_REPORT)
}

/// Each with its id.
fn told(triangles: &[[[f64; 3]; 3]]) -> Given {
    let values: Vec<Value> = triangles
        .iter()
        .enumerate()
        .map(|(id, corners)| {
            let formula = Formula::default().sym(format!("{id}: "));
            let [a, b, c] = *corners;
            let formula = formula.place(a).sym(" ").place(b).sym(" ").place(c);
            Value::Formula(formula)
        })
        .collect();
    Given::new("object-triangles", values.into_iter())
}
