//! Ear clipping, shown.

mod marks;
mod ring;
#[cfg(test)]
mod tests;

use crate::{
    algo::polygon::{
        Corner::{self, Convex, Reflex, Straight},
        EarClipping, EarClippingEvent as Event, EarClippingHeld as Held, Triangle, Triangulation,
    },
    geom::SimplePolygon,
};

use super::{
    prelude::*,
    triangles::{named_triangles, part_of, triangle_link, triangle_name},
};

pub use self::marks::marks;

pseudocode! {
    CLASSIFY: 0, "code-ear-classify", "words-ear-classify";
    ROUND: 0, "code-ear-round", "words-ear-round";
    EACH: 1, "code-ear-each", "words-ear-each";
    CONVEX: 2, "code-ear-convex", "words-ear-convex";
    EMPTY: 3, "code-ear-empty", "words-ear-empty";
    CUT: 4, "code-ear-cut", "words-ear-cut";
    RECLASSIFY: 4, "code-ear-again", "words-ear-again";
    LAST: 0, "code-ear-last", "words-ear-last";
}

const MAX_ROWS: usize = 12;

const TURN: &[&str] = &[
    "{turn} = ({xb} − {(xa)}) · ({yc} − {(yb)}) − ({yb} − {(ya)}) · ({xc} − {(xb)}){=area}{sign}",
];
const SIDES: &[&str] = &["{by} = {at}", "{side 1}", "{side 2}", "{side 3}"];
const COUNT: &[&str] = &["{all} − 2{=all − 2}"];

impl PolygonTelling for EarClipping {
    const CLIPS: bool = false;

    fn input(scene: &Scene) -> Result<SimplePolygon, UnfitScene> {
        ScenePart::Subject.simple(&scene.subject)
    }

    fn piece(step: &Step<'_, Self>) -> Option<Vec<Point>> {
        cuts(step.event()).then(|| {
            let triangle = step.held.cut_off.triangles().last();
            let corners = triangle.map(|&triangle| step.held.cut_off.corners(triangle));
            corners.into_iter().flatten().collect()
        })
    }
}

impl Answer for Triangulation {
    fn told(&self) -> impl Serialize {
        #[derive(Serialize)]
        struct Told<'a, T> {
            triangles: T,
            vertices: &'a [Triangle],
        }
        let vertices = self.triangles();
        let triangles = Each(move || vertices.iter().map(|&triangle| self.corners(triangle)));
        Told {
            triangles,
            vertices,
        }
    }
}

impl Telling for EarClipping {
    type Scenery = ();

    const ID: &'static str = "ear-clipping";
    const NAME_KEY: &'static str = "alg-ear-clipping";
    const SOURCE: &'static str = "G. H. Meisters, 1975; ElGindy, Everett & Toussaint, 1993";
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[
        Watched::Seen(&["left"], ring::VIEW),
        Watched::Names(&["n left", "n triangles"]),
        Watched::ListSeen("vertices", ring::VIEW),
        Watched::ListSeen("triangles", ring::VIEW),
    ];

    table! { |event, step|
        again: Event::Classify { .. } if step.held.ring.len() < step.input.vertices().len() =>
            Row::new(Test, RECLASSIFY, "ear-classify-again").so(TURN).picks_as("corner", "corners", "option-corner");
        classify: Event::Classify { .. } =>
            Row::new(Test, CLASSIFY, "ear-classify").so(TURN).picks_as("corner", "corners", "option-corner");
        round: Event::Round { .. } => Row::new(Phase, ROUND, "ear-round");
        pass: Event::Pass { .. } =>
            Row::new(Test, CONVEX, "ear-pass").answers_as("convex", "ear-not-convex").keeps("vertex");
        candidate: Event::Candidate { .. } =>
            Row::new(Test, CONVEX, "ear-candidate").answers_as("convex", "ear-is-convex");
        blocked: Event::Blocked { .. } =>
            Row::new(Test, EMPTY, "ear-blocked").so(SIDES).answers_as("ear", "ear-not-empty").keeps("vertex");
        ear: Event::Ear { .. } => Row::new(Test, EMPTY, "ear-ear").answers("ear").drops("vertex");
        cut: Event::Cut { .. } => Row::new(Cut, CUT, "ear-cut").about("triangle");
        last: Event::Last { .. } => Row::new(Cut, LAST, "ear-last").about("triangle");
        done: Event::Done { .. } => Row::new(Accept, LAST, "ear-done").so(COUNT);
    }

    const OPENING: Row = Row::new(Phase, CLASSIFY, "ear-opening").so(COUNT);

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (held, event) = (at.step.held, at.step.event());
        let whole = &held.cut_off;
        let n_vertices = at.step.input.vertices().len();
        if let Some(coordinate) = coordinate(&at.step, name) {
            return Some(coordinate.into());
        }
        Some(match (name, event) {
            ("n", None) => n_vertices.into(),
            ("n", Some(Event::Done { n_triangles })) => n_triangles.into(),
            ("n", _) => held.ring.len().into(),
            ("all", _) => (n_vertices as f64).into(),
            ("all − 2", _) => (n_vertices as f64 - 2.0).into(),
            ("round", Some(Event::Round { round_idx, .. })) => (round_idx + 1).into(),
            ("vertex", _) => named_vertex(corner(&at.step)?[1]),
            ("corner", _) => corner_name(held.corners[corner(&at.step)?[1]]?).into(),
            ("triangle", Some(_)) => {
                let cut_off = cuts(event).then(|| whole.triangles().len() - 1);
                let triangle = Named::from(triangle_name(corner(&at.step)?));
                cut_off.map_or(triangle.clone(), |idx| triangle.linked(triangle_link(idx)))
            }
            ("diagonal", Some(Event::Cut { triangle, .. })) => [triangle[0], triangle[2]]
                .map(vertex_symbol)
                .concat()
                .into(),
            ("turn", Some(Event::Classify { .. })) => turn_name(corner(&at.step)?).into(),
            ("area", Some(Event::Classify { double_area, .. })) => double_area.into(),
            ("sign", Some(Event::Classify { corner, .. })) => sign(corner).into(),
            ("by", Some(Event::Blocked { by_idx, .. })) => named_vertex(by_idx),
            ("at", Some(Event::Blocked { by_idx, .. })) => whole.at(by_idx).to_array().into(),
            ("side 1", _) => side(&at.step, 0)?.into(),
            ("side 2", _) => side(&at.step, 1)?.into(),
            ("side 3", _) => side(&at.step, 2)?.into(),
            ("left", _) => Named::from(ring_name(held)).labelled(Value::Term("ear-left")),
            ("n left", _) => Named::from(held.ring.len()).labelled(Value::Term("ear-n-left")),
            ("n triangles", _) => {
                Named::from(whole.triangles().len()).labelled(Value::Term("ear-n-triangles"))
            }
            _ => return None,
        })
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        let held = at.step.held;
        match list {
            "corners" => [Convex, Straight, Reflex]
                .map(|it| corner_name(it).into())
                .into(),
            "triangles" => named_triangles(&held.cut_off),
            _ => {
                let vertex = |i: usize| {
                    let at = Named::from(held.cut_off.at(i).to_array()).labelled(vertex_name(i));
                    let note = held.corners[i].map(corner_name);
                    Named { note, ..at }.linked(vertex_link(i))
                };
                around(&at.step).into_iter().map(vertex).collect()
            }
        }
    }

    fn part(at: &At<'_, Self>, list: &str) -> Option<[usize; 2]> {
        Some(match list {
            "triangles" => part_of(&at.step.held.cut_off),
            _ => [0, at.step.held.ring.len()],
        })
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        at.filled(Self::WATCH)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(&at.step)),
            View::new(ring::VIEW, Body::Lists(ring::lists(&at.step))),
        ]
    }
}

/// The corner that this step is about, its tip in the middle.
fn corner(step: &Step<'_, EarClipping>) -> Option<Triangle> {
    match step.event()? {
        Event::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            ..
        } => Some([prev_idx, vertex_idx, next_idx]),
        Event::Candidate { triangle } | Event::Cut { triangle, .. } | Event::Last { triangle } => {
            Some(triangle)
        }
        Event::Blocked { vertex_idx, .. }
        | Event::Ear { vertex_idx }
        | Event::Pass { vertex_idx, .. } => Some(step.held.ring.corner(vertex_idx)),
        Event::Round { .. } | Event::Done { .. } => None,
    }
}

const fn cuts(event: Option<Event>) -> bool {
    matches!(event, Some(Event::Cut { .. } | Event::Last { .. }))
}

const fn is_done(event: Option<Event>) -> bool {
    matches!(event, Some(Event::Done { .. }))
}

fn asked(step: &Step<'_, EarClipping>) -> Option<usize> {
    step.held.asked().filter(|_| !is_done(step.event()))
}

/// `xa` … `yc`: of the three vertices of a corner that is classified.
fn coordinate(step: &Step<'_, EarClipping>, name: &str) -> Option<f64> {
    let &[axis @ (b'x' | b'y'), vertex @ b'a'..=b'c'] = name.as_bytes() else {
        return None;
    };
    let vertex_idx = corner(step)?[usize::from(vertex - b'a')];
    Some(step.held.cut_off.at(vertex_idx).to_array()[usize::from(axis - b'x')])
}

/// `turn(V₁, V₂, V₄) = 12 ≥ 0`: the vertex that blocks an ear, by one of the ear's sides.
fn side(step: &Step<'_, EarClipping>, side: usize) -> Option<Formula> {
    let Event::Blocked {
        by_idx,
        double_areas: areas,
        ..
    } = step.event()?
    else {
        return None;
    };
    let triangle = corner(step)?;
    let turn = turn_name([triangle[side], triangle[(side + 1) % 3], by_idx]);
    let formula = Formula::default().sym(turn).equals(areas[side]);
    Some(formula.sym(" ≥ 0"))
}

/// `turn(V₁, V₂, V₃)`.
fn turn_name(corner: Triangle) -> String {
    let [a, b, c] = corner.map(vertex_symbol);
    format!("turn({a}, {b}, {c})")
}

fn sign(corner: Corner) -> Formula {
    match corner {
        Convex => Formula::default().sym(" > 0"),
        Straight => Formula::default(),
        Reflex => Formula::default().sym(" < 0"),
    }
}

const fn corner_name(corner: Corner) -> Value {
    Value::Term(match corner {
        Convex => "ear-convex",
        Straight => "ear-straight",
        Reflex => "ear-reflex",
    })
}

fn named_vertex(vertex_idx: usize) -> Named {
    Named::from(vertex_name(vertex_idx)).linked(vertex_link(vertex_idx))
}

const fn vertex_link(vertex_idx: usize) -> Link {
    Link::nth("vertex", vertex_idx)
}

/// Up to [`MAX_ROWS`] vertices of what is left, those about the one that is asked.
fn around(step: &Step<'_, EarClipping>) -> Vec<usize> {
    let ring = &step.held.ring;
    if ring.len() <= MAX_ROWS {
        return ring.iter().collect();
    }
    let asked = asked(step).filter(|&i| ring.contains(i));
    let mut from = asked.unwrap_or(ring.first());
    if asked.is_some() {
        for _ in 0..MAX_ROWS / 2 {
            from = ring.prev(from);
        }
    }
    let after = |&i: &usize| Some(ring.next(i));
    std::iter::successors(Some(from), after)
        .take(MAX_ROWS)
        .collect()
}

/// `V₁V₂V₄V₅`, with dots where there are too many: it says the same until one of those that it names is cut off.
fn ring_name(held: &Held) -> String {
    let is_long = held.ring.len() > MAX_ROWS;
    let symbols = held.ring.iter().take(MAX_ROWS).map(vertex_symbol);
    let dots = is_long.then(|| "…".to_owned());
    symbols.chain(dots).collect()
}
