//! A handle's place, as it is typed.

use crate::text::{Diagnostic, Lang, Message, read_numbers};

use super::{Document, Edit, Handle, Motion};

/// How the place of a handle is written: as `write` writes numbers, where [`read_numbers`] reads those, and as this language
/// parts them.
pub fn written(
    handle: Handle,
    document: &dyn Document,
    is_flat: bool,
    (lang, write): (Lang, impl Fn(f64) -> String),
) -> Option<String> {
    let numbers = numbers(handle, document, is_flat)?;
    let between = lang.list_separator();
    let parted = if numbers.len() > 1 { between } else { "" };
    let written = numbers.into_iter().map(|x| {
        let short = write(x);
        let read = read_numbers(&format!("{short}{parted}"));
        let is_read = read.is_some_and(|read| read.len() == 1);
        if is_read {
            short
        } else {
            x.to_string().replace('-', "−")
        }
    });
    Some(written.collect::<Vec<_>>().join(between))
}

/// The change that was typed for a handle, whose place had been written so. What has not been typed anew stays exactly as it
/// is. It is refused where it is not as many numbers as the handle has.
pub fn typed_change(
    handle: Handle,
    document: &dyn Document,
    is_flat: bool,
    [shown, typed]: [&str; 2],
) -> Result<Edit, Diagnostic> {
    let now = numbers(handle, document, is_flat).unwrap_or_default();
    let Some(mut read) = read_numbers(typed).filter(|read| read.len() == now.len()) else {
        return Err(not_read(now.len(), typed));
    };
    let shown = read_numbers(shown).unwrap_or_default();
    for ((number, now), shown) in read.iter_mut().zip(&now).zip(shown) {
        if *number == shown {
            *number = *now;
        }
    }
    if document.measure(handle).is_some() {
        return Ok(Edit::Measure(handle, read[0]));
    }
    let mut to = document.position(handle).unwrap_or_default();
    for (&i, number) in coordinates(handle, is_flat).iter().zip(read) {
        to[i] = number;
    }
    Ok(Edit::Drag(handle, to))
}

/// What was typed is not as many numbers.
pub fn not_read(n_numbers: usize, typed: &str) -> Diagnostic {
    let message = Message::new("error-typed-place").with("count", n_numbers);
    Diagnostic::new(message.with("typed", typed.to_owned()))
}

/// What can be typed of a handle: its measure, where one number is what it stands for, else its coordinates.
fn numbers(handle: Handle, document: &dyn Document, is_flat: bool) -> Option<Vec<f64>> {
    let place = document.position(handle)?;
    let coordinates = || coordinates(handle, is_flat).into_iter().map(|i| place[i]);
    let measure = document.measure(handle);
    Some(measure.map_or_else(|| coordinates().collect(), |measure| vec![measure]))
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
    use crate::labs::{frustum, lines};

    /// As many digits as fit.
    fn short(x: f64) -> String {
        format!("{x:.3}")
    }

    fn place(document: &dyn Document, edit: &Edit) -> [f64; 3] {
        match edit {
            Edit::Drag(_, to) => *to,
            other => panic!("{:?}: {other:?}", document.lab().id),
        }
    }

    #[test]
    fn what_is_not_typed_anew_stays_exactly_as_it_is() {
        let mut scene = (lines::LAB.first_scene)();
        let handle = scene.document().handles()[0];
        let exact = [0.1 + 0.2, 1.0 / 3.0, 0.0];
        let document = scene.document_mut();
        document.drag(handle, exact).expect("it can lie there");
        let shown = written(handle, document, true, (Lang::En, short)).expect("it has a place");
        assert_eq!(shown, "0.300, 0.333");
        let with_comma = |x: f64| short(x).replace('.', ",");
        let spanish = written(handle, document, true, (Lang::Es, with_comma));
        assert_eq!(spanish.as_deref(), Some("0,300; 0,333"));
        for (typed, expected) in [
            ("0.3, 1/3", [exact[0], 1.0 / 3.0, 0.0]),
            ("0.300, 2", [exact[0], 2.0, 0.0]),
            ("(−1, 0,333)", [0.0; 3]),
        ] {
            let read = typed_change(handle, document, true, [&shown, typed]);
            match read {
                Ok(edit) => assert_eq!(place(document, &edit), expected, "{typed}"),
                Err(refused) => assert_eq!(refused.code, "typed-place", "{typed}"),
            }
        }
    }

    #[test]
    fn what_no_one_reads_is_written_in_full() {
        let scene = (lines::LAB.first_scene)();
        let document = scene.document();
        let handle = document.handles()[0];
        let [x, y, _] = document.position(handle).expect("it has a place");
        let shown = written(
            handle,
            document,
            true,
            (Lang::En, |_| "1.2×10⁻⁵".to_owned()),
        );
        let in_full = format!("{x}, {y}").replace('-', "−");
        assert_eq!(shown, Some(in_full));
    }

    #[test]
    fn a_plane_has_one_number_and_too_many_are_refused() {
        let mut scene = (frustum::LAB.first_scene)();
        let document = scene.document();
        let handles = document.handles();
        let near = handles.iter().find(|handle| handle.kind().id == "near");
        let near = *near.expect("a camera has one");
        let shown = written(near, document, false, (Lang::En, short)).expect("it has a distance");
        for typed in ["1, 2, 3", "", "near"] {
            let refused = typed_change(near, document, false, [&shown, typed]);
            assert_eq!(refused.expect_err("not one number").code, "typed-place");
        }
        let edit = typed_change(near, document, false, [&shown, "2/3"]).expect("one number");
        edit.apply(&mut scene).expect("before the far plane");
        assert_eq!(scene.document().measure(near), Some(2.0 / 3.0));
    }
}
