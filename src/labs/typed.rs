//! A handle's place, as it is typed.

use crate::text::{Diagnostic, Message, read_numbers};

use super::{Handle, Motion};

/// How the place of a handle is written, so that [`place_of`] reads the very same one.
pub fn written(handle: Handle, at: [f64; 3], is_flat: bool) -> String {
    let numbers: Vec<String> = coordinates(handle, is_flat)
        .iter()
        .map(|&i| at[i].to_string().replace('-', "−"))
        .collect();
    numbers.join(", ")
}

/// The place that was typed for a handle at `from`: of what may not move there is nothing to type. It is
/// refused where it is not as many numbers as the handle has coordinates.
pub fn place_of(
    handle: Handle,
    from: [f64; 3],
    is_flat: bool,
    typed: &str,
) -> Result<[f64; 3], Diagnostic> {
    let indices = coordinates(handle, is_flat);
    let numbers = read_numbers(typed).filter(|numbers| numbers.len() == indices.len());
    let Some(numbers) = numbers else {
        let message = Message::new("error-typed-place")
            .with("count", indices.len())
            .with("typed", typed.to_owned());
        return Err(Diagnostic::new(message));
    };
    let mut to = from;
    for (&i, number) in indices.iter().zip(numbers) {
        to[i] = number;
    }
    Ok(to)
}

/// The coordinates that a handle can be given.
fn coordinates(handle: Handle, is_flat: bool) -> Vec<usize> {
    match handle.kind().motion {
        Motion::Plane if is_flat => vec![0, 1],
        Motion::Plane | Motion::FacingEye => vec![0, 1, 2],
        Motion::Axis(axis) => (0..3).filter(|&i| axis[i] != 0.0).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::HandleKind;

    static POINT: HandleKind = HandleKind::new("p", "p", |_| Message::new("handle-window"));
    static SIDE: HandleKind = HandleKind {
        motion: Motion::Axis([0.0, 1.0, 0.0]),
        ..HandleKind::new("s", "s", |_| Message::new("handle-window"))
    };

    #[test]
    fn what_is_written_is_read_again() {
        for at in [[-1.5, 0.1 + 0.2, 0.0], [5e-324, -1e300, 0.0]] {
            let text = written(POINT.at([0; 2]), at, true);
            assert_eq!(
                place_of(POINT.at([0; 2]), [9.0, 9.0, 0.0], true, &text),
                Ok(at)
            );
        }
    }

    #[test]
    fn a_side_has_one_number_and_too_many_are_refused() {
        let side = SIDE.at([0; 2]);
        assert_eq!(
            place_of(side, [1.0, 2.0, 0.0], true, "1/4"),
            Ok([1.0, 0.25, 0.0])
        );
        for typed in ["1, 2", "", "top"] {
            let refused = place_of(side, [1.0, 2.0, 0.0], true, typed);
            assert_eq!(refused.expect_err("not one number").code, "typed-place");
        }
    }
}
