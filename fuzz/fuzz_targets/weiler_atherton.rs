//! Two polygons out of bytes, on a small grid or with any coordinates, and what must hold of what they have in
//! common. A walk that does not end stops at its bound, with an assertion.
//!
//! Bytes: how coordinates are read and the number of vertices of each ring, then the coordinates.
#![no_main]

use clipscope::{
    algo::polygon::weiler_atherton::{
        Relation, WeilerAtherton, WeilerAthertonInput, WeilerAthertonOutput,
    },
    geom::{GeomError, Location, Point, Region, SimplePolygon, locate},
    trace::{laws, silent},
};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((&[how, n_subject, n_clip, n_hole], rest)) = bytes.split_first_chunk() else {
        return;
    };
    let mut numbers = Numbers {
        rest,
        on_grid: how & 1 == 0,
        size: 4 + (how >> 4),
    };
    let subject = numbers.outline(n_subject);
    let clip = numbers.outline(n_clip);
    let hole = numbers.outline(n_hole % 8);
    let (Some(subject), Some(clip)) = (untangled(subject), untangled(clip)) else {
        return;
    };
    let holed = untangled(hole).and_then(|hole| Region::new(subject.clone(), vec![hole]).ok());
    let region = holed.unwrap_or_else(|| subject.clone().into());
    let input = WeilerAthertonInput {
        subject: region,
        clip,
    };
    if subject.vertices().len() + input.clip.vertices().len() < 60 {
        laws::check::<WeilerAtherton>(&input);
    }
    let answer = silent::<WeilerAtherton>(&input);
    check_rings(&answer, &input);
    if numbers.on_grid {
        check_points(&answer, &input);
    }
    if input.subject.holes().is_empty() {
        let swapped = silent::<WeilerAtherton>(&WeilerAthertonInput {
            subject: input.clip.clone().into(),
            clip: subject,
        });
        assert_eq!(
            rings(&answer),
            rings(&swapped),
            "the same the other way round: {input:?}"
        );
    }
});

struct Numbers<'a> {
    rest: &'a [u8],
    on_grid: bool,
    size: u8,
}

impl Numbers<'_> {
    fn outline(&mut self, n: u8) -> Vec<[f64; 2]> {
        (0..n)
            .map_while(|_| Some([self.next()?, self.next()?]))
            .collect()
    }

    fn next(&mut self) -> Option<f64> {
        if self.on_grid {
            let (&byte, rest) = self.rest.split_first()?;
            self.rest = rest;
            Some(f64::from(byte % self.size))
        } else {
            let (&bytes, rest) = self.rest.split_first_chunk::<8>()?;
            self.rest = rest;
            Some(f64::from_le_bytes(bytes))
        }
    }
}

/// Two edges that meet are exchanged for two that join their ends, until none do.
fn untangled(mut outline: Vec<[f64; 2]>) -> Option<SimplePolygon> {
    for _ in 0..60 {
        match SimplePolygon::new(&outline) {
            Ok(polygon) => return Some(polygon),
            Err(GeomError::EdgesMeet { edges: [i, j] }) => outline[i + 1..=j].reverse(),
            Err(_) => return None,
        }
    }
    None
}

fn check_rings(answer: &WeilerAthertonOutput, input: &WeilerAthertonInput) {
    let common_area = !matches!(answer.relation, Relation::Disjoint | Relation::Touching);
    assert!(
        common_area || answer.pieces.is_empty(),
        "{answer:?} of {input:?}"
    );
    for piece in &answer.pieces {
        for ring in std::iter::once(&piece.outer).chain(&piece.holes) {
            assert!(ring.len() >= 3, "{answer:?} of {input:?}");
        }
    }
    let n_holes: usize = answer.pieces.iter().map(|piece| piece.holes.len()).sum();
    assert!(
        n_holes <= input.subject.holes().len(),
        "{answer:?} of {input:?}"
    );
}

/// Point by point: in one piece where it is in both, in none elsewhere. On the grid, crossings are exact to far
/// less than the distance of these points from any edge.
fn check_points(answer: &WeilerAthertonOutput, input: &WeilerAthertonInput) {
    for i in 0..20 {
        for j in 0..20 {
            let p = Point::new(f64::from(i) + 0.370_241, f64::from(j) + 0.618_033).expect("finite");
            let in_both = input.subject.locate(p) == Location::Inside
                && input.clip.locate(p) == Location::Inside;
            let is_in = |ring: &Vec<Point>| locate(ring, p) == Location::Inside;
            let pieces = answer.pieces.iter();
            let n = pieces
                .filter(|piece| is_in(&piece.outer) && !piece.holes.iter().any(is_in))
                .count();
            assert_eq!(n, usize::from(in_both), "{p:?} in {answer:?} of {input:?}");
        }
    }
}

/// Every ring, from its lowest vertex, in order.
fn rings(answer: &WeilerAthertonOutput) -> Vec<Vec<[u64; 2]>> {
    let all = answer
        .pieces
        .iter()
        .flat_map(|piece| std::iter::once(&piece.outer).chain(&piece.holes));
    let mut rings: Vec<Vec<[u64; 2]>> = all
        .map(|ring| {
            // −0 and 0 are the same coordinate.
            let mut ring: Vec<[u64; 2]> = ring
                .iter()
                .map(|p| p.to_array().map(|x| (x + 0.0).to_bits()))
                .collect();
            // A crossing may be rounded to where another corner is: of all turns of the ring the least one.
            let n = ring.len();
            let turn = |from: usize| ring.iter().cycle().skip(from).take(n);
            let lowest =
                (0..n).min_by(|&i, &j| ring[i].cmp(&ring[j]).then_with(|| turn(i).cmp(turn(j))));
            ring.rotate_left(lowest.unwrap_or(0));
            ring
        })
        .collect();
    rings.sort();
    rings
}
