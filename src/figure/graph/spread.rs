//! Places of a picture, moved apart so that what stands there can be read: stretched to the room, then each two that are too
//! close pushed apart along the line between them (of one place, in directions that their numbers give).

const ROUNDS: usize = 200;
/// Angle between the directions of two that follow each other, in radians: no two of few are alike.
const TURN: f64 = 2.4;

/// The places in a room of this width and height, `apart` from each other where there is room for that.
pub fn spread(places: &[[f64; 2]], room: [f64; 2], apart: f64) -> Vec<[f64; 2]> {
    let mut spread: Vec<[f64; 2]> = places.to_vec();
    for (i, side) in room.into_iter().enumerate() {
        let all = places.iter().map(|at| at[i]);
        let low = all.clone().fold(f64::INFINITY, f64::min);
        let high = all.fold(f64::NEG_INFINITY, f64::max);
        for at in &mut spread {
            let part = (at[i] - low) / (high - low);
            at[i] = if high > low { part } else { 0.5 } * side;
        }
    }
    for _ in 0..ROUNDS {
        let mut has_moved = false;
        for b in 1..spread.len() {
            for a in 0..b {
                has_moved |= part(&mut spread, [a, b], room, apart);
            }
        }
        if !has_moved {
            break;
        }
    }
    spread
}

/// Moves two apart that are too close, each half of the way; were they?
fn part(places: &mut [[f64; 2]], [a, b]: [usize; 2], room: [f64; 2], apart: f64) -> bool {
    let along = [0, 1].map(|i| places[b][i] - places[a][i]);
    let length = libm::hypot(along[0], along[1]);
    // What is left is too little to be seen.
    if length >= 0.99 * apart {
        return false;
    }
    let along = if length > 1e-9 * apart {
        along.map(|x| x / length)
    } else {
        let (sin, cos) = libm::sincos(TURN * b as f64);
        [cos, sin]
    };
    for (i, (along, side)) in along.into_iter().zip(room).enumerate() {
        let push = 0.5 * (apart - length) * along;
        places[a][i] = (places[a][i] - push).clamp(0.0, side);
        places[b][i] = (places[b][i] + push).clamp(0.0, side);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(places: &[[f64; 2]]) -> f64 {
        let pairs = (1..places.len()).flat_map(|b| (0..b).map(move |a| [a, b]));
        let distance = |[a, b]: [usize; 2]| {
            libm::hypot(places[a][0] - places[b][0], places[a][1] - places[b][1])
        };
        pairs.map(distance).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn what_is_far_apart_is_only_stretched() {
        let places = spread(&[[2.0, 5.0], [4.0, 6.0], [3.0, 7.0]], [100.0, 50.0], 30.0);
        assert_eq!(places, [[0.0, 0.0], [100.0, 25.0], [50.0, 50.0]]);
    }

    #[test]
    fn what_is_close_is_moved_apart_and_stays_in_the_room() {
        let room = [200.0, 120.0];
        for n in 2..=12 {
            let on_a_heap: Vec<[f64; 2]> = (0..n).map(|i| [f64::from(i % 3) * 0.01, 0.0]).collect();
            let places = spread(&on_a_heap, room, 30.0);
            let inside = |at: &[f64; 2]| (0..2).all(|i| (0.0..=room[i]).contains(&at[i]));
            assert!(places.iter().all(inside), "{n}: {places:?}");
            assert!(nearest(&places) > 25.0, "{n}: {places:?}");
            assert_eq!(places, spread(&on_a_heap, room, 30.0), "the same again");
        }
    }
}
