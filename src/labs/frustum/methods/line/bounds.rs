//! The three kinds of bounds: a box, the planes of the camera's volume, clip space.

use crate::{
    algo::{
        segment::{Given, LineEvent},
        volume::{LineInput, plane_distances, signed_distance},
    },
    geom::planes_from_matrix,
    labs::{
        crossing_formulas::upright_in_space,
        frustum::prelude::*,
        segments::{LineKeys, SeenRow},
    },
};

use super::{
    super::{
        super::stage::{axis_equation, cube_view, face_at_work},
        asked::{perpendicular, plane_link, plane_name, sum_formula},
    },
    marks::{interval_marks, points_table, shadow},
    w_lens,
};

const AXES: [&str; 3] = ["x", "y", "z"];
const SUBSCRIPTS: [&str; 2] = ["₁", "₂"];

const fn keys(opening: &'static str) -> LineKeys {
    LineKeys {
        opening,
        delta: "space-line-delta",
        row: ["space-line-row"; 3],
        parallel: ["space-line-parallel-inside", "space-line-parallel-outside"],
        enter: ["space-line-enter", "space-line-enter-idle"],
        leave: ["space-line-leave", "space-line-leave-idle"],
        put: "space-line-put",
        one_point: ["space-line-touch", "space-line-point"],
        reject: "space-line-reject",
    }
}

impl SpaceLine<3> for AlignedBox {
    const SUBJECT: Subject = Subject::BoxedSegment;

    fn input(scene: &Scene) -> LineInput<3, Self> {
        LineInput {
            bounds: Self::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]).expect("ordered"),
            ends: scene.places().segment,
        }
    }
}

impl LineLook<3> for AlignedBox {
    type Scenery = Scenery;

    const SOURCE: &'static str = "Liang & Barsky, 1984";
    const SYMBOLS: [&'static str; 2] = ["u", "r"];
    const HEADER: [&'static str; 2] = ["p", "q"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["q"], &["p"]];
    const KEYS: LineKeys = keys("space-line-opening-box");
    const PARALLEL: &'static str = "q = ";
    const NOTES: [&'static str; 2] = ["lb-note-enter", "lb-note-leave"];
    const SIGN: f64 = 1.0;

    fn plane(plane: VolumeSide, _: Option<&Scenery>) -> Named {
        side_named(plane)
    }

    fn numbers(&self, _: &[[f64; 3]; 2], row: &SeenRow<3, Self>) -> [f64; 2] {
        [row.numbers.p, row.numbers.q]
    }

    fn meaning(side: VolumeSide) -> Option<[String; 2]> {
        let axis = AXES[side.axis()];
        Some(if side.is_high() {
            [format!("Δ{axis}"), format!("{axis}_max − {axis}₁")]
        } else {
            [format!("−Δ{axis}"), format!("{axis}₁ − {axis}_min")]
        })
    }

    fn row_formulas(&self, ends: &[[f64; 3]; 2], row: &SeenRow<3, Self>) -> Vec<Formula> {
        let side = row.plane;
        let [p, q] = Self::meaning(side).unwrap_or_default();
        let (from, border) = (ends[0][side.axis()], self.border(side));
        let [a, b] = if side.is_high() {
            [border, from]
        } else {
            [from, border]
        };
        let of_q = sym(format!("q = {q} = ")).num(a);
        vec![
            sym(format!("p = {p}")).equals(row.numbers.p),
            of_q.sym(" − ").operand(b).equals(row.numbers.q),
        ]
    }

    fn put_formulas(
        shown: &LineStep<'_, 3, Self>,
        _: End,
        side: VolumeSide,
        at: [f64; 3],
    ) -> Vec<Formula> {
        let border = shown.input.bounds.border(side);
        upright_in_space(&shown.ends, side.axis(), border, at)
    }

    fn border(&self, side: VolumeSide, _: Option<&Scenery>) -> Value {
        Value::Formula(axis_equation(side, self.border(side)))
    }

    fn drawing(shown: &LineStep<'_, 3, Self>, scenery: Option<&Scenery>) -> Vec<View> {
        let side = shown.in_hand().into_iter();
        let draw = |scenery: &Scenery| {
            let side = side.flat_map(face_at_work).collect();
            cube_view(scenery.scene(), marks(shown, scenery, (side, -1.0)))
        };
        scenery.map(draw).into_iter().collect()
    }
}

/// The plane in hand, the segment's shadow at this level, and what is left of it.
fn marks<B: LineLook<3, Scenery = Scenery>>(
    shown: &LineStep<'_, 3, B>,
    scenery: &Scenery,
    (mut marks, level): (Vec<Mark3>, f64),
) -> Vec<Mark3> {
    let ends = shown.input.ends();
    marks.extend(shadow(&ends, level));
    let (interval, visible) = (shown.interval(Some(scenery)), shown.verdict.flatten());
    marks.extend(interval_marks(&ends, &interval, B::SYMBOLS[1], visible));
    marks
}

impl SpaceLine<3> for Vec<Plane> {
    const SUBJECT: Subject = Subject::Segment;

    /// The sums and differences of the matrix's rows: normals of any length, and numbers as they stand in the matrix.
    fn input(scene: &Scene) -> LineInput<3, Self> {
        let from_matrix = planes_from_matrix(&scene.culler().clip_from_world());
        let planes = from_matrix.unwrap_or_else(|_| scene.culler().planes_in_world());
        LineInput {
            bounds: planes.to_vec(),
            ends: scene.places().segment,
        }
    }
}

impl LineLook<3> for Vec<Plane> {
    type Scenery = Scenery;

    const SOURCE: &'static str = "Cyrus & Beck, 1978";
    const SYMBOLS: [&'static str; 2] = ["a", "a"];
    const HEADER: [&'static str; 2] = ["d₁", "d₂"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["d₁"], &["d₁", "d₂"]];
    const KEYS: LineKeys = keys("space-line-opening-planes");
    const PARALLEL: &'static str = "d₁ = ";
    const NOTES: [&'static str; 2] = ["space-line-note-enter", "space-line-note-leave"];
    const SIGN: f64 = -1.0;

    fn plane(plane: usize, scenery: Option<&Scenery>) -> Named {
        Named::from(plane_name(scenery, plane)).linked(plane_link(plane))
    }

    fn numbers(&self, ends: &[[f64; 3]; 2], row: &SeenRow<3, Self>) -> [f64; 2] {
        plane_distances(&self[row.plane], ends)
    }

    fn meaning(_: usize) -> Option<[String; 2]> {
        Some(["n·P₁ + D", "n·P₂ + D"].map(str::to_owned))
    }

    fn row_formulas(&self, ends: &[[f64; 3]; 2], row: &SeenRow<3, Self>) -> Vec<Formula> {
        let plane = &self[row.plane];
        let [d1, d2] = plane_distances::<f64>(plane, ends);
        vec![
            sum_formula(["d₁", "P₁"], plane, ends[0], d1),
            sum_formula(["d₂", "P₂"], plane, ends[1], d2),
        ]
    }

    fn border(&self, plane: usize, scenery: Option<&Scenery>) -> Value {
        let named = Message::new("space-line-the-plane");
        Value::Message(named.with("plane", plane_name(scenery, plane)))
    }

    fn drawing(shown: &LineStep<'_, 3, Self>, scenery: Option<&Scenery>) -> Vec<View> {
        let plane = shown.in_hand();
        let side = plane.and_then(|i| VolumeSide::ALL.get(i));
        let draw = |scenery: &Scenery| {
            let side = side.map(|&side| plane_at_work(scenery.scene().culler(), side));
            let mut marks = marks(shown, scenery, (side.unwrap_or_default(), 0.0));
            // Both ends are asked, before it is known what the plane does.
            if let (Some(plane), Some(LineEvent::Row { .. })) = (plane, shown.event) {
                let (plane, ends) = (&shown.input.bounds()[plane], shown.input.ends());
                for (symbol, at) in ["d₁", "d₂"].into_iter().zip(ends) {
                    let distance = signed_distance(plane, at);
                    marks.extend(perpendicular(sym(symbol), plane, at, distance));
                }
            }
            scenery.observer(|_| Fate::ToCome, marks)
        };
        scenery.map(draw).into_iter().collect()
    }
}

impl SpaceLine<4> for ClipSpace {
    const SUBJECT: Subject = Subject::Segment;

    fn input(scene: &Scene) -> LineInput<4, Self> {
        let clip_from_world = scene.culler().clip_from_world();
        let ends = scene.places().segment;
        LineInput {
            bounds: Self,
            ends: ends.map(|[x, y, z]| clip_from_world.times([x, y, z, 1.0])),
        }
    }

    fn drawn(scene: &Scene, at: [f64; 3]) -> [f64; 3] {
        w_lens::foot(scene.culler(), at)
    }
}

impl LineLook<4> for ClipSpace {
    type Scenery = Scenery;

    const SOURCE: &'static str = "Blinn & Newell, 1978";
    const SYMBOLS: [&'static str; 2] = ["t", "t"];
    const HEADER: [&'static str; 2] = ["d₁", "d₂"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["d₁"], &["d₁", "d₂"]];
    const KEYS: LineKeys = keys("space-line-opening-clip");
    const PARALLEL: &'static str = "d₁ = ";
    const NOTES: [&'static str; 2] = ["space-line-note-enter", "space-line-note-leave"];
    const SIGN: f64 = 1.0;
    const SHOWS_PLANES: bool = false;

    fn plane(plane: VolumeSide, _: Option<&Scenery>) -> Named {
        side_named(plane)
    }

    fn numbers(&self, ends: &[[f64; 4]; 2], row: &SeenRow<4, Self>) -> [f64; 2] {
        side_distances(row.plane, ends)
    }

    fn meaning(side: VolumeSide) -> Option<[String; 2]> {
        let (axis, sign) = (AXES[side.axis()], if side.is_high() { "−" } else { "+" });
        Some(SUBSCRIPTS.map(|i| format!("w{i} {sign} {axis}{i}")))
    }

    fn row_formulas(&self, ends: &[[f64; 4]; 2], row: &SeenRow<4, Self>) -> Vec<Formula> {
        let side = row.plane;
        let distances = side_distances::<f64>(side, ends);
        let meanings = Self::meaning(side).unwrap_or_default();
        let sign = if side.is_high() { " − " } else { " + " };
        let formula = |i: usize| {
            let symbol = format!("d{} = {} = ", SUBSCRIPTS[i], meanings[i]);
            let sum = sym(symbol).num(ends[i][3]).sym(sign);
            sum.operand(ends[i][side.axis()]).equals(distances[i])
        };
        vec![formula(0), formula(1)]
    }

    fn border(&self, side: VolumeSide, _: Option<&Scenery>) -> Value {
        let sign = if side.is_high() { "" } else { "−" };
        name(format!("{} = {sign}w", AXES[side.axis()]))
    }

    fn rows(shown: &LineStep<'_, 4, Self>) -> Option<Body> {
        Some(Body::Table(points_table(shown)))
    }

    fn drawing(shown: &LineStep<'_, 4, Self>, scenery: Option<&Scenery>) -> Vec<View> {
        scenery.map_or_else(Vec::new, |scenery| w_lens::views(shown, scenery))
    }
}

pub trait SpaceLine<const N: usize>: LineLook<N, Scenery = Scenery> {
    const SUBJECT: Subject;

    fn input(scene: &Scene) -> Self::Input;

    /// Where an end of the segment is drawn that lies at `at`.
    fn drawn(_: &Scene, at: [f64; 3]) -> [f64; 3] {
        at
    }
}
