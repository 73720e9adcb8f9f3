//! Who blocks a candidate: the leftmost of all that lie in it, whatever boxes they are looked for in.

use std::convert::Infallible;

use clipscope::{
    algo::polygon::{Corner, EarClipping, EarClippingEvent as Event, EarClippingHeld, Triangle},
    geom::{Point, SimplePolygon, orientation},
    trace::{Listening, Method, Told},
};

use super::outlines::{comb, spiral, star};

/// By definition: every vertex that is left and not convex, by x, then in the order of the outline.
fn blocking(held: &EarClippingHeld, vertices: &[Point], triangle: Triangle) -> Option<usize> {
    let corners = triangle.map(|i| vertices[i]);
    let is_inside = |&i: &usize| {
        (0..3).all(|side| {
            let [a, b] = [side, (side + 1) % 3].map(|k| corners[k]);
            orientation(a, b, vertices[i]).is_ge()
        })
    };
    let others = (0..vertices.len()).filter(|i| {
        let is_rival = held.corners[*i] != Some(Corner::Convex);
        is_rival && held.ring.contains(*i) && !triangle.contains(i)
    });
    let x = |i: &usize| vertices[*i].x();
    others
        .filter(is_inside)
        .min_by(|i, j| x(i).total_cmp(&x(j)))
}

/// Around the origin, so that it is simple, with teeth of any length.
fn burr(n: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| {
        let mixed = (i * i) as u64 ^ 0x5bd1;
        let length = mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 44;
        let radius = 1.0 + length as f64 / f64::from(1 << 20);
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / n as f64);
        [radius * cos, radius * sin]
    };
    (0..n).map(at).collect()
}

#[test]
fn the_leftmost_of_all_that_lie_in_a_candidate_blocks_it() {
    let whole = |outline: Vec<[i64; 2]>| outline.iter().map(|p| p.map(|x| x as f64)).collect();
    let outlines: [(&str, Vec<[f64; 2]>); 6] = [
        ("a comb", whole(comb(120))),
        (
            "a comb on its side",
            whole(comb(120))
                .iter()
                .map(|&[x, y]: &[f64; 2]| [y, -x])
                .collect(),
        ),
        (
            "a comb aslant",
            whole(comb(120))
                .iter()
                .map(|&[x, y]: &[f64; 2]| [x - y, x + y])
                .collect(),
        ),
        ("a spiral", whole(spiral(50))),
        ("a star", whole(star(200))),
        ("a burr", burr(600)),
    ];
    let mut n_blocked = 0;
    for (name, outline) in outlines {
        let polygon = SimplePolygon::new(&outline).expect("simple");
        let vertices = polygon.vertices();
        let mut candidate = None;
        let mut listening = Listening(|held: &EarClippingHeld, event| {
            match event {
                Event::Candidate { triangle } => candidate = blocking(held, vertices, triangle),
                Event::Blocked { by_idx, .. } => {
                    assert_eq!(Some(by_idx), candidate, "{name}");
                    n_blocked += 1;
                }
                Event::Ear { vertex_idx } => assert_eq!(candidate, None, "{name}: {vertex_idx}"),
                _ => {}
            }
            Told::<Infallible>::Continue(())
        });
        let mut held = EarClipping::begin(&polygon);
        let Told::Continue(()) = EarClipping::run::<f64, _>(&polygon, &mut held, &mut listening);
    }
    assert!(n_blocked > 100, "{n_blocked} were blocked");
}
