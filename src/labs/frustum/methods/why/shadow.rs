//! Why n·(P − p₀) is a distance, shown: the plane from its edge, the way from p₀ to P in steps along the axes, and their shadows on n.
//!
//! ```text
//!   plane ╲      ╱┐ shadow on n, 2.121 + 0.7071
//!          ╲   ╱   ╲
//!        p₀ ╲╱──3───┐ P        the light runs along the plane
//!            ╲      │ 1
//! ```

use crate::{
    algo::{
        volume::signed_distance,
        why::{Shadow, ShadowFact as Fact, ShadowInput, Shown, Why},
    },
    figure::Weight,
    labs::{
        frustum::prelude::*,
        why::{Picture, around, fact, mark, segment},
    },
};

use super::super::asked::{distance_formula, perpendicular, place};

/// The first p₀ lies so far along the plane, from where the other one is to the far edge.
const ALONG: f64 = 0.4;
const AXES: [&str; 3] = ["x", "y", "z"];

impl SpaceTelling for Why<Shadow> {
    const SUBJECT: Subject = Subject::Point;

    fn input(scene: &Scene) -> ShadowInput {
        let (camera, side) = (scene.culler(), side(scene));
        let corners = camera.corners_in_world().map(DVec3::from);
        // Of the edges of the side on near and on far.
        let middle = |is_far: bool| {
            let has = |i: &usize| {
                (i >> side.axis() & 1 == 1) == side.is_high() && (i >> 2 == 1) == is_far
            };
            (0..8).filter(has).map(|i| corners[i]).sum::<DVec3>() / 2.0
        };
        let start = match camera.volume().sight() {
            Sight::Perspective => camera.position().into(),
            Sight::Parallel => middle(false),
        };
        ShadowInput {
            plane: camera.planes_in_world()[side as usize],
            point: scene.places().point,
            from: [start.lerp(middle(true), ALONG), start].map(Into::into),
        }
    }
}

/// Of left, right, bottom and top the farthest from P: there the lengths are large.
fn side(scene: &Scene) -> VolumeSide {
    let planes = scene.culler().planes_in_world();
    let far = |side: &VolumeSide| {
        signed_distance::<f64>(&planes[*side as usize], scene.places().point).abs()
    };
    let sides = VolumeSide::ALL
        .into_iter()
        .filter(|side| side.axis() < 2)
        .rev();
    sides
        .max_by(|a, b| far(a).total_cmp(&far(b)))
        .unwrap_or(VolumeSide::Left)
}

const NAMES: [(&str, Fact); 3] = [
    ("n·(P − p₀)", Fact::Sum),
    ("d", Fact::Distance),
    ("elsewhere", Fact::Elsewhere),
];

impl Telling for Why<Shadow> {
    type Scenery = Scenery;

    const ID: &'static str = "why-shadow";
    const NAME_KEY: &'static str = "why-shadow";
    const SOURCE: &'static str = "Gibbs & Wilson, 1901";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-steps", "why-words-steps"),
        code_line(1, "why-code-shadow", "why-words-shadow"),
        code_line(0, "why-code-sum", "why-words-sum"),
        code_line(0, "why-code-rectangle", "why-words-rectangle"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["P", "p₀", "n", "D"]),
        Watched::Names(&["n·(P − p₀)", "d"]),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-shadow-opening").so(&["P − p₀ = {P} − {p₀}"]);

    table! { |event, step|
        piece: Shown { fact: Fact::X | Fact::Y | Fact::Z, .. } =>
            Row::new(Test, 1, "why-shadow-piece").so(&["{piece}"]);
        sum: Shown { fact: Fact::Sum, .. } =>
            Row::new(Test, 2, "why-shadow-sum").so(&["n·(P − p₀) = {sum}"]);
        distance: Shown { fact: Fact::Distance, .. } =>
            Row::new(Accept, 3, "why-shadow-distance").so(&["{d = n·P + D}"]);
        elsewhere: Shown { fact: Fact::Elsewhere, .. } =>
            Row::new(Accept, 2, "why-shadow-elsewhere").so(&["n·(P − p₀) = {sum}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let input = at.step.input;
        let (plane, event) = (&input.plane, at.step.event());
        let from = usize::from(matches!(
            event,
            Some(Shown {
                fact: Fact::Elsewhere,
                ..
            })
        ));
        let axis = event.and_then(|it| Fact::STEPS.iter().position(|step| *step == it.fact));
        Some(match name {
            "P" => place(input.point).into(),
            "p₀" => place(input.from[from]).into(),
            "other" => place(input.from[1]).into(),
            "n" => place(plane.normal()).into(),
            "D" => plane.d().into(),
            "plane" => side_name(side(at.scenery?.scene())).into(),
            "axis" => Value::Name(AXES[axis?].to_owned()).into(),
            "piece" => {
                let step = input.point[axis?] - input.from[0][axis?];
                let formula = Formula::decimals().operand(step);
                let formula = times(formula, plane.normal()[axis?]);
                formula.equals(event?.number).into()
            }
            "sum" => {
                let pieces = input
                    .axes()
                    .map(|axis| (input.piece::<f64>(from, axis), ()));
                sum_of(Formula::decimals(), pieces, |it, ()| it)
                    .equals(event?.number)
                    .into()
            }
            "d = n·P + D" => {
                let d = fact(&at.step, &NAMES, "d")?;
                distance_formula(["d", "P"], plane, input.point, d).into()
            }
            _ => fact(&at.step, &NAMES, name)?.into(),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            views.push(scenery.observer(|_| Fate::ToCome, in_space(at, scenery)));
        }
        let plan = Plan::new(at.step.input);
        views.push(plan.view(at));
        views
    }
}

fn in_space(at: &At<'_, Why<Shadow>>, scenery: &Scenery) -> Vec<Mark3> {
    let ShadowInput { plane, point, from } = at.step.input;
    let camera = scenery.scene().culler();
    let mut marks = plane_at_work(camera, side(scenery.scene()));
    let mut corner = from[0];
    for axis in 0..3 {
        let before = corner;
        corner[axis] = point[axis];
        if corner != before {
            marks.push(Mark3::new(Role::Ink, Shape3::Arrow([before, corner])));
        }
    }
    let start = Mark3::new(Role::Ink, Shape3::Dot(from[0])).labelled(name("p₀"));
    marks.push(start);
    if let Some(d) = fact(&at.step, &NAMES, "d") {
        let drawn = perpendicular(sym("d"), plane, *point, d).into_iter();
        marks.extend(drawn.map(|mark| Mark3 {
            role: Role::Accent,
            ..mark
        }));
    }
    let dot = Mark3::new(Role::Accent, Shape3::Dot(*point));
    marks.push(dot.labelled(name("P")).strong());
    marks
}

/// The plane is a line here, and n lies in the picture.
struct Plan<'a> {
    input: &'a ShadowInput,
    axes: [DVec3; 2],
    title: &'static str,
}

impl<'a> Plan<'a> {
    fn new(input: &'a ShadowInput) -> Self {
        let n = DVec3::from(input.plane.normal());
        let (axes, title) = match n.to_array().map(|x| x != 0.0) {
            [_, false, _] => ([DVec3::X, DVec3::NEG_Z], "why-view-above"),
            [false, ..] => ([DVec3::NEG_Z, DVec3::Y], "why-view-side"),
            [.., false] => ([DVec3::X, DVec3::Y], "why-view-front"),
            [true, true, true] => {
                let way = DVec3::from(input.point) - DVec3::from(input.from[0]);
                let along = (way - way.dot(n) * n).normalize_or(n.any_orthonormal_vector());
                ([along, n], "why-view-section")
            }
        };
        Self { input, axes, title }
    }

    fn place(&self, at: DVec3) -> [f64; 2] {
        self.axes.map(|axis| axis.dot(at))
    }

    fn from(&self, i: usize) -> DVec3 {
        self.input.from[i].into()
    }

    /// On the axis of n through p₀, so far from it.
    fn on_axis(&self, from: usize, far: f64) -> [f64; 2] {
        self.place(self.from(from) + far * DVec3::from(self.input.plane.normal()))
    }

    fn foot(&self) -> [f64; 2] {
        let (at, plane) = (DVec3::from(self.input.point), &self.input.plane);
        let d = signed_distance::<f64>(plane, self.input.point);
        self.place(at - d * DVec3::from(plane.normal()))
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        let d = signed_distance::<f64>(&self.input.plane, self.input.point);
        let tips = [0, 1].map(|i| self.on_axis(i, d));
        let corners = self.corners().map(|at| self.place(at));
        let all = tips
            .into_iter()
            .chain(corners)
            .chain([self.foot(), self.place(self.from(1))]);
        around(all)
    }

    /// From p₀ along x, then y, then z.
    fn corners(&self) -> [DVec3; 4] {
        let (mut at, to) = (self.from(0), self.input.point);
        [0, 1, 2, 3].map(|i| {
            if i > 0 {
                at[i - 1] = to[i - 1];
            }
            at
        })
    }

    fn given(&self) -> Vec<Mark> {
        let [from, to] = [self.from(0), self.input.point.into()].map(|at| self.place(at));
        let [x, y] = self.place(self.input.plane.normal().into());
        // n is on the left of this way along the plane.
        let line = [from, [from[0] + y, from[1] - x]];
        let start = mark(Role::Ink, Shape::Dot(from)).labelled(name("p₀"));
        let end = mark(Role::Accent, Shape::Dot(to)).labelled(name("P"));
        let way = segment(Role::Soft, from, to).dashed();
        let wash = mark(Role::Ink, Shape::Wash(line));
        let plane = mark(Role::Accent, Shape::Line(line));
        vec![wash, plane, way, start.toward([-x, -y]), end.strong()]
    }

    /// The step along an axis, the ray past its end, and its shadow.
    fn piece(&self, axis: usize, role: Role, (from, piece): (f64, f64)) -> Vec<Mark> {
        let corners = self.corners();
        let ends = [corners[axis], corners[axis + 1]].map(|at| self.place(at));
        let shadow = [from, from + piece].map(|far| self.on_axis(0, far));
        let step = self.input.point[axis] - self.input.from[0][axis];
        let [x, y] = self.place(self.input.plane.normal().into());
        let arrow = mark(Role::Ink, Shape::Arrow(ends));
        let named = Formula::decimals()
            .sym(format!("Δ{} = ", AXES[axis]))
            .num(step);
        let bar = segment(role, shadow[0], shadow[1]).weighing(Weight::of(5.0));
        let mut bar = bar
            .labelled(Formula::decimals().num(piece))
            .strong()
            .toward([-y, x]);
        bar.is_dashed = piece < 0.0;
        let foot = mark(role, Shape::Vertex(shadow[1]));
        let ray = segment(Role::Faint, ends[1], shadow[1]);
        vec![arrow.labelled(named), ray, bar, foot]
    }

    fn view(&self, at: &At<'_, Why<Shadow>>) -> View {
        let mut picture = Picture::new(&at.step, self.given());
        let mut so_far = 0.0;
        for axis in self.input.axes() {
            let part = (so_far, self.input.piece(0, axis));
            picture.once(Fact::STEPS[axis], Role::Accent, |role, _| {
                self.piece(axis, role, part)
            });
            so_far += part.1;
        }
        let to = self.place(self.input.point.into());
        let corners = |sum: f64| {
            [
                self.place(self.from(0)),
                self.foot(),
                to,
                self.on_axis(0, sum),
            ]
        };
        picture.once(Fact::Sum, Role::Accent, |role, sum| {
            let tip = mark(role, Shape::Ring(self.on_axis(0, sum)));
            [tip.labelled(sym("n·(P − p₀)").equals(sum)).strong()]
        });
        picture.once(Fact::Distance, Role::Accent, |role, d| {
            let [start, foot, to, tip] = corners(d);
            let perpendicular = segment(role, foot, to)
                .labelled(sym("d").equals(d))
                .strong();
            let angles = [[start, foot, tip], [foot, to, start], [tip, start, to]];
            let angles = angles.map(|at| mark(Role::Soft, Shape::RightAngle(at)));
            let area = mark(role, Shape::Fill(vec![vec![start, foot, to, tip]]));
            [area, perpendicular].into_iter().chain(angles)
        });
        picture.once(Fact::Elsewhere, Role::Accent, |role, sum| {
            let [start, tip] = [0.0, sum].map(|far| self.on_axis(1, far));
            let dot = mark(role, Shape::Dot(start)).labelled(name("p₀"));
            let bar = segment(role, start, tip).weighing(Weight::of(5.0));
            let ray = segment(Role::Faint, to, tip);
            [
                dot,
                bar.labelled(Formula::decimals().num(sum)).strong(),
                ray,
            ]
        });
        picture.view(self.title, self.bounds())
    }
}
