//! The three kinds of bounds: a box, the planes of the camera's volume, clip space.

use crate::{
    algo::{
        parameter::End,
        volume::{ClipSpace, LineInput, LineRow, LineState, plane_distances, side_distances},
    },
    figure::{Link, Table, View},
    geom::{AlignedBox, Camera, Plane, VolumeSide, planes_from_matrix},
    labs::{crossing_formulas::upright_in_space, words::name},
    text::{Formula, Message, Value},
};

use super::{
    super::{
        super::{
            Scene, Subject,
            stage::{Fate, Scenery, cube_view, face_at_work, plane_at_work, side_link, side_name},
        },
        planes::{plane_link, plane_name, sum_formula},
    },
    look::{LineLook, PlaneLook, ShownLine},
    marks::{interval_marks, shadow},
    points::points_table,
    w_lens,
};

const AXES: [&str; 3] = ["x", "y", "z"];
const SUBSCRIPTS: [&str; 2] = ["₁", "₂"];

/// The box from −1 to 1.
pub fn unit_box() -> AlignedBox {
    AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]).expect("ordered")
}

/// `x = −1`
pub fn face_equation(bounds: &AlignedBox, side: VolumeSide) -> Formula {
    let formula = Formula::default().sym(AXES[side.axis()]).sym(" = ");
    formula.num(bounds.border(side))
}

impl PlaneLook for VolumeSide {
    fn idx(self) -> usize {
        self as usize
    }

    fn name(self, _: Option<&Scenery>) -> Value {
        side_name(self)
    }

    fn link(self) -> Link {
        side_link(self)
    }
}

impl PlaneLook for usize {
    fn idx(self) -> usize {
        self
    }

    fn name(self, scenery: Option<&Scenery>) -> Value {
        plane_name(scenery, self)
    }

    fn link(self) -> Link {
        plane_link(self)
    }
}

impl LineLook<3> for AlignedBox {
    const SUBJECT: Subject = Subject::BoxedSegment;
    const SOURCE: &'static str = "Liang & Barsky, 1984";
    const SYMBOLS: [&'static str; 2] = ["u", "r"];
    const HEADER: [&'static str; 2] = ["p", "q"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["q"], &["p"]];
    const SIGN: f64 = 1.0;
    const SHOWS_PLANES: bool = true;

    fn input(scene: &Scene) -> LineInput<3, Self> {
        LineInput {
            bounds: unit_box(),
            ends: scene.places.segment(),
        }
    }

    fn opening(&self) -> Message {
        Message::new("space-line-opening-box")
    }

    fn numbers(&self, _: &[[f64; 3]; 2], row: &LineRow<VolumeSide>) -> [f64; 2] {
        [row.p, row.q]
    }

    fn meaning(side: VolumeSide) -> Option<[String; 2]> {
        let axis = AXES[side.axis()];
        Some(if side.is_high() {
            [format!("Δ{axis}"), format!("{axis}_max − {axis}₁")]
        } else {
            [format!("−Δ{axis}"), format!("{axis}₁ − {axis}_min")]
        })
    }

    fn row_formulas(
        &self,
        ends: &[[f64; 3]; 2],
        _: &LineState<VolumeSide, 3>,
        row: &LineRow<VolumeSide>,
    ) -> Vec<Formula> {
        let side = row.plane;
        let [p, q] = Self::meaning(side).unwrap_or_default();
        let (from, border) = (ends[0][side.axis()], self.border(side));
        let [a, b] = if side.is_high() {
            [border, from]
        } else {
            [from, border]
        };
        let of_q = Formula::default().sym(format!("q = {q} = ")).num(a);
        vec![
            Formula::default().sym(format!("p = {p}")).equals(row.p),
            of_q.sym(" − ").operand(b).equals(row.q),
        ]
    }

    fn put_formulas(
        &self,
        _: End,
        side: VolumeSide,
        ends: &[[f64; 3]; 2],
        at: [f64; 3],
    ) -> Vec<Formula> {
        upright_in_space(ends, side.axis(), self.border(side), at)
    }

    fn border(&self, _: Option<&Scenery>, side: VolumeSide) -> Value {
        Value::Formula(face_equation(self, side))
    }

    fn drawing(shown: &ShownLine<'_, 3, Self>, scenery: &Scenery) -> Vec<View> {
        let ends = &shown.input.ends;
        let mut marks: Vec<_> = shown.in_hand.into_iter().flat_map(face_at_work).collect();
        marks.extend(shadow(ends, -1.0));
        let visible = shown.state.verdict.flatten();
        marks.extend(interval_marks(
            ends,
            &shown.interval,
            Self::SYMBOLS[1],
            visible,
        ));
        vec![cube_view(scenery.scene(), marks)]
    }
}

/// The sums and differences of the matrix's rows: normals of any length, and numbers as they stand in the matrix.
fn planes_of(camera: &Camera) -> [Plane; 6] {
    let from_matrix = planes_from_matrix(&camera.clip_from_world());
    from_matrix.unwrap_or_else(|_| camera.planes_in_world())
}

impl LineLook<3> for Vec<Plane> {
    const SUBJECT: Subject = Subject::Segment;
    const SOURCE: &'static str = "Cyrus & Beck, 1978";
    const SYMBOLS: [&'static str; 2] = ["a", "a"];
    const HEADER: [&'static str; 2] = ["d₁", "d₂"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["n·(p₀ − P₁)"], &["n·(P₂ − P₁)"]];
    const SIGN: f64 = -1.0;
    const SHOWS_PLANES: bool = true;

    fn input(scene: &Scene) -> LineInput<3, Self> {
        LineInput {
            bounds: planes_of(scene.culler()).to_vec(),
            ends: scene.places.segment(),
        }
    }

    fn opening(&self) -> Message {
        Message::new("space-line-opening-planes").with("planes", self.len())
    }

    fn numbers(&self, ends: &[[f64; 3]; 2], row: &LineRow<usize>) -> [f64; 2] {
        plane_distances(&self[row.plane], ends)
    }

    fn meaning(_: usize) -> Option<[String; 2]> {
        Some(["n·P₁ + D", "n·P₂ + D"].map(str::to_owned))
    }

    fn row_formulas(
        &self,
        ends: &[[f64; 3]; 2],
        _: &LineState<usize, 3>,
        row: &LineRow<usize>,
    ) -> Vec<Formula> {
        let plane = &self[row.plane];
        let [d1, d2] = plane_distances::<f64>(plane, ends);
        vec![
            sum_formula(["d₁", "P₁"], plane, ends[0], d1),
            sum_formula(["d₂", "P₂"], plane, ends[1], d2),
        ]
    }

    fn border(&self, scenery: Option<&Scenery>, plane: usize) -> Value {
        let named = Message::new("space-line-the-plane");
        Value::Message(named.with("plane", plane_name(scenery, plane)))
    }

    fn drawing(shown: &ShownLine<'_, 3, Self>, scenery: &Scenery) -> Vec<View> {
        let ends = &shown.input.ends;
        let camera = scenery.scene().culler();
        let side = shown.in_hand.and_then(|i| VolumeSide::ALL.get(i).copied());
        let mut marks: Vec<_> = side
            .into_iter()
            .flat_map(|side| plane_at_work(camera, side))
            .collect();
        marks.extend(shadow(ends, 0.0));
        let visible = shown.state.verdict.flatten();
        marks.extend(interval_marks(
            ends,
            &shown.interval,
            Self::SYMBOLS[1],
            visible,
        ));
        vec![scenery.observer(|_| Fate::ToCome, marks)]
    }
}

impl LineLook<4> for ClipSpace {
    const SUBJECT: Subject = Subject::Segment;
    const SOURCE: &'static str = "Blinn & Newell, 1978";
    const SYMBOLS: [&'static str; 2] = ["t", "t"];
    const HEADER: [&'static str; 2] = ["d₁", "d₂"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["d₁"], &["d₁", "d₂"]];
    const SIGN: f64 = 1.0;
    const SHOWS_PLANES: bool = false;

    fn input(scene: &Scene) -> LineInput<4, Self> {
        let clip_from_world = scene.culler().clip_from_world();
        let ends = scene.places.segment();
        LineInput {
            bounds: Self,
            ends: ends.map(|[x, y, z]| clip_from_world.times([x, y, z, 1.0])),
        }
    }

    fn opening(&self) -> Message {
        Message::new("space-line-opening-clip")
    }

    fn numbers(&self, ends: &[[f64; 4]; 2], row: &LineRow<VolumeSide>) -> [f64; 2] {
        side_distances(row.plane, ends)
    }

    fn meaning(side: VolumeSide) -> Option<[String; 2]> {
        let (axis, sign) = (AXES[side.axis()], if side.is_high() { "−" } else { "+" });
        Some(SUBSCRIPTS.map(|i| format!("w{i} {sign} {axis}{i}")))
    }

    fn row_formulas(
        &self,
        ends: &[[f64; 4]; 2],
        _: &LineState<VolumeSide, 4>,
        row: &LineRow<VolumeSide>,
    ) -> Vec<Formula> {
        let side = row.plane;
        let distances = side_distances::<f64>(side, ends);
        let meanings = Self::meaning(side).unwrap_or_default();
        let sign = if side.is_high() { " − " } else { " + " };
        let formula = |i: usize| {
            let symbol = format!("d{} = {} = ", SUBSCRIPTS[i], meanings[i]);
            let sum = Formula::default().sym(symbol).num(ends[i][3]).sym(sign);
            sum.operand(ends[i][side.axis()]).equals(distances[i])
        };
        vec![formula(0), formula(1)]
    }

    fn border(&self, _: Option<&Scenery>, side: VolumeSide) -> Value {
        let sign = if side.is_high() { "" } else { "−" };
        name(format!("{} = {sign}w", AXES[side.axis()]))
    }

    fn points(shown: &ShownLine<'_, 4, Self>) -> Option<Table> {
        Some(points_table(shown))
    }

    fn drawing(shown: &ShownLine<'_, 4, Self>, scenery: &Scenery) -> Vec<View> {
        w_lens::views(shown, scenery)
    }
}
