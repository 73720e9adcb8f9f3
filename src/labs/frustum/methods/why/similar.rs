//! Why t = d₁ / (d₁ − d₂), shown: the section through the segment and the plane's normal, at true lengths.
//!
//! ```text
//!   3 ┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄ P₂   ┬ 3
//!   2 ┄┄┄┄┄┄┄┄┄┄┄┄┄┄╱───┤      ┼     each triangle changes d by 1,
//!   1 ┄┄┄┄┄┄┄┄╱────┤            ┼     and takes the same piece
//!   ──────C╱──────────────── d = 0
//!      P₁╱                      ┴ −1
//! ```

use crate::{
    algo::{
        volume::{plane_distances, signed_distance},
        why::{Shown, Similar, SimilarFact as Fact, SimilarInput, Why},
    },
    geom::planes_from_matrix,
    labs::{
        frustum::prelude::*,
        why::{Picture, fact, mark, segment},
    },
};

use super::super::asked::{perpendicular, sum_formula};

/// Copies of the triangle beyond these would be too small.
const MOST_COPIES: f64 = 8.0;

impl SpaceTelling for Why<Similar> {
    const SUBJECT: Subject = Subject::Segment;

    fn input(scene: &Scene) -> SimilarInput {
        let ends = scene.places().segment;
        let planes = planes(scene);
        let plane = planes[side(scene) as usize];
        SimilarInput { plane, ends }
    }
}

/// With normals as they stand in the matrix.
fn planes(scene: &Scene) -> [Plane; 6] {
    let from_matrix = planes_from_matrix(&scene.culler().clip_from_world());
    from_matrix.unwrap_or_else(|_| scene.culler().planes_in_world())
}

/// The plane by which the segment comes in last; else that by which it goes out first; else the nearest to P₁.
fn side(scene: &Scene) -> VolumeSide {
    let ends = scene.places().segment;
    let rank = |side: VolumeSide| {
        let [d1, d2] = plane_distances::<f64>(&planes(scene)[side as usize], &ends);
        let t = d1 / (d1 - d2);
        match (d1 < 0.0, d2 < 0.0) {
            (true, false) => (0, -t),
            (false, true) => (1, t),
            (true, true) | (false, false) => (2, d1.abs()),
        }
    };
    let less = |a: &VolumeSide, b: &VolumeSide| {
        let [(a, x), (b, y)] = [rank(*a), rank(*b)];
        a.cmp(&b).then(x.total_cmp(&y))
    };
    VolumeSide::ALL
        .into_iter()
        .min_by(less)
        .unwrap_or(VolumeSide::Near)
}

const NAMES: [(&str, Fact); 5] = [
    ("d₁", Fact::D1),
    ("d₂", Fact::D2),
    ("levels", Fact::Levels),
    ("piece", Fact::Piece),
    ("t", Fact::T),
];

impl Telling for Why<Similar> {
    type Scenery = Scenery;

    const ID: &'static str = "why-similar";
    const NAME_KEY: &'static str = "why-similar";
    const SOURCE: &'static str = "Euclid, Elements VI, 2";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-d1", "why-words-d1"),
        code_line(0, "why-code-levels", "why-words-levels"),
        code_line(0, "why-code-piece", "why-words-piece"),
        code_line(0, "why-code-t", "why-words-t"),
    ];
    const WATCH: &'static [Watched] = &[Watched::Names(&["d₁", "d₂", "d₂ − d₁", "t"])];
    const OPENING: Row = Row::new(Phase, 0, "why-similar-opening");

    table! { |event, step|
        d1: Shown { fact: Fact::D1, .. } =>
            Row::new(Test, 0, "why-similar-d1").so(&["{d₁ = n·P₁ + D}"]);
        d2: Shown { fact: Fact::D2, .. } =>
            Row::new(Test, 0, "why-similar-d2").so(&["{d₂ = n·P₂ + D}"]);
        levels: Shown { fact: Fact::Levels, .. } =>
            Row::new(Test, 1, "why-similar-levels").so(&["d₂ − d₁ = {d₂} − {(d₁)}{=levels}"]);
        parallel: Shown { fact: Fact::Parallel, .. } =>
            Row::new(Reject, 1, "why-similar-parallel").so(&["d₁ = d₂{=d₁}"]);
        piece: Shown { fact: Fact::Piece, .. } =>
            Row::new(Test, 2, "why-similar-piece").so(&["1 / (d₂ − d₁){=piece}"]);
        t: Shown { fact: Fact::T, .. } => Row::new(Accept, 3, "why-similar-t")
            .so(&["t = d₁ / (d₁ − d₂) = {d₁ / d₁ − d₂}{=t}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let SimilarInput { plane, ends } = at.step.input;
        let number = |name: &str| fact(&at.step, &NAMES, name);
        let sum = |i: usize, symbols: [&str; 2], d: &str| {
            let formula = sum_formula(symbols, plane, ends[i], number(d)?);
            Some(Named::from(formula))
        };
        Some(match name {
            "d₁ = n·P₁ + D" => return sum(0, ["d₁", "P₁"], "d₁"),
            "d₂ = n·P₂ + D" => return sum(1, ["d₂", "P₂"], "d₂"),
            "d₁" | "d₂" => {
                Named::from(number(name)?).linked(["p1", "p2"][usize::from(name == "d₂")])
            }
            "levels" | "d₂ − d₁" => number("levels")?.into(),
            "d₁ − d₂" => {
                let formula = Formula::default().num(number("d₁")?).sym(" − ");
                formula.operand(number("d₂")?).into()
            }
            "piece" => ratio(number("piece").and(Some(1.0))?, number("levels")?),
            "t" => ratio(number("t").and(number("d₁"))?, -number("levels")?),
            "plane" => Named::from(side_name(side(at.scenery?.scene()))),
            _ => return None,
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            views.push(scenery.observer(|_| Fate::ToCome, in_space(at, scenery)));
        }
        views.push(section(at));
        views
    }
}

fn ratio(num: f64, den: f64) -> Named {
    Named::from(Value::Ratio { num, den })
}

fn in_space(at: &At<'_, Why<Similar>>, scenery: &Scenery) -> Vec<Mark3> {
    let SimilarInput { plane, ends } = at.step.input;
    let scene = scenery.scene();
    let mut marks = plane_at_work(scene.culler(), side(scene));
    marks.push(Mark3::new(Role::Accent, Shape3::Segment(*ends)).linked("segment"));
    for (end, (d, of_end)) in End::BOTH.into_iter().zip(NAMES) {
        let place = ends[end.idx()];
        let ring = Mark3::new(Role::Accent, Shape3::Ring(place));
        marks.push(ring.labelled(end_name(end)).strong().linked(end_link(end)));
        if at.step.held.get(of_end).is_some() {
            let is_now = at.step.event().is_some_and(|shown| shown.fact == of_end);
            let role = if is_now { Role::Signal } else { Role::Accent };
            let height = signed_distance(plane, place);
            let drawn = perpendicular(sym(d), plane, place, height).into_iter();
            marks.extend(drawn.map(|mark| Mark3 { role, ..mark }));
        }
    }
    if let Some(t) = fact(&at.step, &NAMES, "t").filter(|t| (0.0..=1.0).contains(t)) {
        let cut = std::array::from_fn(|i| ends[0][i] + t * (ends[1][i] - ends[0][i]));
        marks.push(Mark3::new(Role::Signal, Shape3::Ring(cut)).labelled(name("C")));
    }
    marks
}

/// The section: along the plane to the right, away from it upwards.
struct Section {
    /// From the foot of P₁ to that of P₂.
    width: f64,
    /// Of both ends, over the plane.
    heights: [f64; 2],
    /// The height of one level.
    level: f64,
    size: f64,
}

impl Section {
    fn new(SimilarInput { plane, ends }: &SimilarInput) -> Self {
        let heights = ends.map(|at| signed_distance::<f64>(plane, at));
        let long = DVec3::from(ends[0]).distance(ends[1].into());
        let rise = heights[1] - heights[0];
        Self {
            width: (long * long - rise * rise).max(0.0).sqrt(),
            heights,
            level: 1.0 / plane.length(),
            size: long.max(heights[0].abs()).max(f64::MIN_POSITIVE),
        }
    }

    fn foot(&self, end: End) -> [f64; 2] {
        [self.width * end.idx() as f64, 0.0]
    }

    fn place(&self, end: End) -> [f64; 2] {
        [self.foot(end)[0], self.heights[end.idx()]]
    }

    /// After a part of the way.
    fn on_line(&self, t: f64) -> [f64; 2] {
        let [h1, h2] = self.heights;
        [t * self.width, h1 + t * (h2 - h1)]
    }

    fn ruler(&self) -> f64 {
        self.width + 0.16 * self.size
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        let [h1, h2] = self.heights;
        let around = 0.14 * self.size;
        let low = h1.min(h2).min(0.0) - around;
        let high = h1.max(h2).max(0.0) + around;
        [[-1.6 * around, low], [self.ruler() + 1.6 * around, high]]
    }

    fn given(&self) -> Vec<Mark> {
        let [[left, _], [right, _]] = self.bounds();
        let plane = segment(Role::Accent, [left, 0.0], [right, 0.0]);
        let ends = End::BOTH.map(|end| {
            let toward = if end == End::P1 {
                [-1.0, 0.0]
            } else {
                [0.0, 1.0]
            };
            let dot = mark(Role::Ink, Shape::Dot(self.place(end))).labelled(end_name(end));
            dot.strong().toward(toward).linked(end_link(end))
        });
        let [from, to] = End::BOTH.map(|end| self.place(end));
        let zero = mark(Role::Accent, Shape::Label([0.65 * self.width, 0.0]));
        let wash = mark(Role::Ink, Shape::Wash([[left, 0.0], [right, 0.0]]));
        let mut marks = vec![wash, plane];
        marks.push(zero.labelled(name("d = 0")).toward([0.0, -1.0]));
        marks.push(segment(Role::Ink, from, to).linked("segment"));
        marks.extend(ends);
        marks
    }

    fn distance(&self, end: End, symbol: &'static str, role: Role, d: f64) -> [Mark; 2] {
        let (foot, at) = (self.foot(end), self.place(end));
        let aside = self.foot(if end == End::P1 { End::P2 } else { End::P1 });
        let toward = if end == End::P1 {
            [-1.0, 0.0]
        } else {
            [1.0, 0.0]
        };
        let line = segment(role, foot, at).labelled(sym(symbol).equals(d));
        [
            line.strong().toward(toward).linked(end_link(end)),
            mark(role, Shape::RightAngle([foot, at, aside])),
        ]
    }

    /// The levels that are whole numbers, where both ends lie on such and there are few of them; else the ends' and the plane's.
    fn ticks([d1, d2]: [f64; 2]) -> Vec<f64> {
        let is_whole = d1.fract() == 0.0 && d2.fract() == 0.0 && (d2 - d1).abs() <= MOST_COPIES;
        if !is_whole {
            return vec![d1, 0.0, d2];
        }
        let (low, high) = (d1.min(d2) as i64, d1.max(d2) as i64);
        (low..=high).map(|level| level as f64).collect()
    }

    fn levels(&self, ticks: &[f64], role: Role, levels: f64) -> Vec<Mark> {
        let [[left, _], _] = self.bounds();
        let ruler = self.ruler();
        let ends = self.heights.map(|height| [ruler, height]);
        let low = if self.heights[0] < self.heights[1] {
            ends[0]
        } else {
            ends[1]
        };
        let named = mark(role, Shape::Label(low)).labelled(sym("d₂ − d₁").equals(levels));
        let mut marks = vec![
            segment(role, ends[0], ends[1]),
            named.strong().toward([0.0, -1.0]),
        ];
        for &tick in ticks {
            let height = tick * self.level;
            let line = segment(Role::Faint, [left, height], [ruler, height]);
            let label = mark(Role::Soft, Shape::Vertex([ruler, height])).labelled(tick);
            marks.extend([line, label.toward([1.0, 0.0])]);
        }
        marks
    }

    /// The triangles between neighbouring levels, all alike; or those on both sides of the plane.
    fn pieces(&self, ticks: &[f64], role: Role, piece: Value) -> Vec<Mark> {
        let [h1, h2] = self.heights;
        let part = |height: f64| (height * self.level - h1) / (h2 - h1);
        let triangle = |pair: &[f64]| {
            let [from, to] = [pair[0], pair[1]].map(|tick| self.on_line(part(tick)));
            // Below the plane it is turned half round: d₁ is a side of it.
            let below = pair[0] < 0.0;
            let corner = if below {
                [from[0], to[1]]
            } else {
                [to[0], from[1]]
            };
            vec![from, corner, to]
        };
        let triangles: Vec<_> = ticks.windows(2).map(triangle).collect();
        let named = triangles
            .first()
            .map(|it| [0, 1].map(|i| it[0][i].midpoint(it[2][i])));
        let label = named.map(|at| {
            mark(role, Shape::Label(at))
                .labelled(piece)
                .toward([-1.0, 1.0])
        });
        let fill = mark(role, Shape::Fill(triangles.clone()));
        let outlines = triangles
            .into_iter()
            .map(|it| mark(role, Shape::Outline(it)));
        [fill]
            .into_iter()
            .chain(outlines)
            .chain(label.filter(|_| ticks.len() > 3))
            .collect()
    }
}

fn section(at: &At<'_, Why<Similar>>) -> View {
    let section = Section::new(at.step.input);
    let mut picture = Picture::new(&at.step, section.given());
    let values = plane_distances::<f64>(&at.step.input.plane, &at.step.input.ends);
    let ticks = Section::ticks(values);
    let value = |name| at.value(name).unwrap_or(Value::Count(0));
    picture.once(Fact::Levels, Role::Soft, |role, it| {
        section.levels(&ticks, role, it)
    });
    picture.once(Fact::Piece, Role::Accent, |role, _| {
        section.pieces(&ticks, role, value("piece"))
    });
    picture.once(Fact::D1, Role::Accent, |role, d| {
        section.distance(End::P1, "d₁", role, d)
    });
    picture.once(Fact::D2, Role::Accent, |role, d| {
        section.distance(End::P2, "d₂", role, d)
    });
    picture.once(Fact::T, Role::Accent, |role, t| {
        let (cut, ruler) = (section.on_line(t), section.ruler());
        let label = sym("C: t = ").ratio(values[0], values[0] - values[1]);
        let ring = mark(role, Shape::Ring(cut)).labelled(label).strong();
        let part = segment(role, [ruler, section.heights[0]], [ruler, 0.0]);
        let beyond = segment(Role::Faint, section.on_line(t.clamp(0.0, 1.0)), cut);
        [beyond, part, ring.toward([1.0, -1.0])]
    });
    picture.view("why-view-section", section.bounds())
}
