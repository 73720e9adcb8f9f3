//! Where a handle goes that was moved on the drawing.

use glam::{DVec2, DVec3};

use crate::{figure::Lens, labs::Motion};

/// The world point of a handle at `from` that was moved to a place on the drawing, as its kind may move; where no
/// movement on the drawing could mean one along its axis, it stays.
pub fn moved_to(lens: &Lens, motion: Motion, from: [f64; 3], to: [f64; 2]) -> [f64; 3] {
    match motion {
        Motion::Plane | Motion::FacingEye => lens.world_from_drawing(to, from),
        // On the plane an axis of it is followed without rounding.
        Motion::Axis(axis) if *lens == Lens::Plane => {
            let to = lens.world_from_drawing(to, from);
            std::array::from_fn(|i| if axis[i] == 0.0 { from[i] } else { to[i] })
        }
        Motion::Axis(axis) => {
            let mut at = from;
            // Depth changes on the way, and scale with it: from there again.
            for _ in 0..MOST_ROUNDS {
                at = along(lens, axis, at, to).unwrap_or(at);
            }
            at
        }
    }
}

/// What is left of the way after each is a small part of it, as the axis is of the distance from the eye.
const MOST_ROUNDS: usize = 16;

fn along(lens: &Lens, axis: [f64; 3], from: [f64; 3], to: [f64; 2]) -> Option<[f64; 3]> {
    let at = DVec2::from(lens.drawing_from_world(from)?);
    let step = (DVec3::from(from) + DVec3::from(axis)).into();
    let along = DVec2::from(lens.drawing_from_world(step)?) - at;
    let by = (DVec2::from(to) - at).dot(along) / along.length_squared();
    let moved = DVec3::from(from) + DVec3::from(axis) * by;
    moved.is_finite().then(|| moved.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::Orbit;

    #[test]
    fn a_handle_follows_the_pointer_as_its_kind_may() {
        let eye = Lens::Eye(Orbit::new([0.0; 3], [30.0, 20.0], 12.0, 24.0));
        let from = [1.0, 0.5, -0.5];
        let place = eye.drawing_from_world([1.5, 0.5, -0.5]).expect("in sight");
        let x = moved_to(&eye, Motion::Axis([1.0, 0.0, 0.0]), from, place);
        assert!((x[0] - 1.5).abs() < 1e-9, "{x:?}");
        assert_eq!([x[1], x[2]], [0.5, -0.5]);
        let free = moved_to(&eye, Motion::FacingEye, from, place);
        let again = eye.drawing_from_world(free).expect("in sight");
        assert!((again[0] - place[0]).abs() < 1e-12 && (again[1] - place[1]).abs() < 1e-12);
        let flat = moved_to(&Lens::Plane, Motion::Plane, [1.0, 2.0, 0.0], [3.0, 4.0]);
        assert_eq!(flat, [3.0, 4.0, 0.0]);
    }

    #[test]
    fn an_axis_that_points_at_the_eye_cannot_be_followed() {
        let lens = Lens::Eye(Orbit::new([0.0; 3], [0.0, 0.0], 12.0, 24.0));
        let from = [0.0; 3];
        let to = moved_to(&lens, Motion::Axis([0.0, 0.0, 1.0]), from, [0.3, 0.1]);
        assert_eq!(to, from);
    }
}
