//! Why row 3 of the projection is what it is, shown: z′ over depth, between the borders −w and w; and the ruler at far, where rays from 0
//! are read.

use crate::{
    algo::why::{ProjectionRow, ProjectionRowFact as Fact, ProjectionRowInput, Shown, Why},
    figure::Weight,
    labs::{
        frustum::prelude::*,
        why::{Picture, fact, mark, segment},
    },
};

/// How wide the depths from 0 to far are drawn, and how high −w to w at far.
const SIZE: [f64; 2] = [2.0, 1.8];
/// Equal steps of depth, from near to far.
const STEPS: u8 = 8;

impl SpaceTelling for Why<ProjectionRow> {
    const SUBJECT: Subject = Subject::Vertex;

    fn input(scene: &Scene) -> ProjectionRowInput {
        let object = scene.focused();
        let at = object.model().mesh().positions()[scene.vertex()].map(f64::from);
        let camera = scene.camera.camera();
        let [_, _, z] = camera
            .view_from_world()
            .point(object.world_from_model().point(at));
        ProjectionRowInput {
            volume: *camera.volume(),
            depth: -z,
        }
    }
}

const NAMES: [(&str, Fact); 7] = [
    ("z′ at near", Fact::Near),
    ("z′ at far", Fact::Far),
    ("slope", Fact::Slope),
    ("start", Fact::AtZero),
    ("z′", Fact::Point),
    ("divided", Fact::Divided),
    ("middle", Fact::Middle),
];

impl Telling for Why<ProjectionRow> {
    type Scenery = Scenery;

    const ID: &'static str = "why-projection-row";
    const NAME_KEY: &'static str = "why-projection-row";
    const SOURCE: &'static str = "Blinn & Newell, 1978";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-near-far", "why-words-near-far"),
        code_line(0, "why-code-slope", "why-words-slope"),
        code_line(0, "why-code-start", "why-words-start"),
        code_line(0, "why-code-row", "why-words-row"),
        code_line(0, "why-code-divide", "why-words-divide"),
    ];
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "z′ at near",
        "z′ at far",
        "slope",
        "start",
        "depth",
        "z′",
        "divided",
    ])];
    const OPENING: Row = Row::new(Phase, 0, "why-row-opening");

    table! { |event, step|
        near: Shown { fact: Fact::Near, .. } => Row::new(Test, 0, "why-row-near").so(&["z′ = −w{=z′ at near}"]);
        far: Shown { fact: Fact::Far, .. } => Row::new(Test, 0, "why-row-far").so(&["z′ = w{=z′ at far}"]);
        slope: Shown { fact: Fact::Slope, .. } =>
            Row::new(Test, 1, "why-row-slope").so(&["~ {climb / way}{=slope}"]);
        start: Shown { fact: Fact::AtZero, .. } =>
            Row::new(Accept, 2, "why-row-start").so(&["~ {z′ at near} − {(slope)} · {near}{=start}"]);
        point: Shown { fact: Fact::Point, .. } =>
            Row::new(Test, 3, "why-row-point").so(&["~ z′ = {slope} · {(depth)} + {(start)}{=z′}"]);
        divided: Shown { fact: Fact::Divided, .. } =>
            Row::new(Test, 4, "why-row-divided").so(&["~ z′ / w = {z′ / w of it}{=divided}"]);
        middle: Shown { fact: Fact::Middle, .. } =>
            Row::new(Accept, 4, "why-row-middle").so(&["~ 0 = {slope} · {middle} + {(start)}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let ProjectionRowInput { volume, depth } = at.step.input;
        let number = |name: &str| fact(&at.step, &NAMES, name);
        Some(match name {
            "steps" => Value::Count(STEPS.into()).into(),
            "near" => volume.near().into(),
            "far" => volume.far().into(),
            "depth" => (*depth).into(),
            "w of it" => at.step.input.w(*depth).into(),
            "divided" => Named::from(number("divided")?).labelled(sym("z′ / w")),
            "climb" => (number("z′ at far")? - number("z′ at near")?).into(),
            "way" => (volume.far() - volume.near()).into(),
            _ => number(name)?.into(),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let scene = scenery.scene();
            let object = scene.focused();
            let vertex = object.model().mesh().positions()[scene.vertex()].map(f64::from);
            let point = object.world_from_model().point(vertex);
            let dot = Mark3::new(Role::Accent, Shape3::Dot(point)).labelled(name("P"));
            views.push(scenery.observer(|_| Fate::ToCome, vec![dot.strong()]));
        }
        views.push(
            Plot {
                input: at.step.input,
            }
            .view(at),
        );
        views
    }
}

/// Depth to the right, z′ upwards.
struct Plot<'a> {
    input: &'a ProjectionRowInput,
}

impl Plot<'_> {
    fn place(&self, depth: f64, z: f64) -> [f64; 2] {
        let far = self.input.volume.far();
        [SIZE[0] * depth / far, 0.5 * SIZE[1] * z / self.input.w(far)]
    }

    fn line(&self, role: Role, from: (f64, f64), to: (f64, f64)) -> Mark {
        segment(role, self.place(from.0, from.1), self.place(to.0, to.1))
    }

    fn given(&self) -> Vec<Mark> {
        let (w, far) = (|depth| self.input.w(depth), self.input.volume.far());
        let corners = [(0.0, w(0.0)), (far, w(far)), (far, -w(far)), (0.0, -w(0.0))];
        let wedge = corners.map(|(depth, z)| self.place(depth, z)).to_vec();
        let mut marks = vec![mark(Role::Ink, Shape::Fill(vec![wedge]))];
        for (sign, equation) in [(1.0, "z′ = w"), (-1.0, "z′ = −w")] {
            let border = self.line(Role::Accent, (0.0, sign * w(0.0)), (far, sign * w(far)));
            let at = mark(
                Role::Accent,
                Shape::Label(self.place(0.45 * far, sign * w(0.45 * far))),
            );
            marks.extend([border, at.labelled(name(equation)).toward([-1.0, sign])]);
        }
        for (depth, key) in [(self.input.volume.near(), "plane-near"), (far, "plane-far")] {
            marks.push(self.line(Role::Faint, (depth, -w(far)), (depth, w(far))));
            let at = mark(Role::Soft, Shape::Label(self.place(depth, -w(far))));
            marks.push(at.labelled(Value::Term(key)).toward([0.0, -1.0]));
        }
        let [right, up] = [[SIZE[0] + 0.25, 0.0], [0.0, 0.5 * SIZE[1] + 0.1]];
        let down = [0.0, -up[1]];
        marks.push(mark(Role::Soft, Shape::Arrow([[0.0, 0.0], right])));
        marks.push(mark(Role::Soft, Shape::Arrow([down, up])));
        let depth = mark(Role::Soft, Shape::Label(right)).labelled(Value::Term("why-depth"));
        let height = mark(Role::Soft, Shape::Label(up)).labelled(name("z′"));
        marks.extend([depth.toward([0.0, 1.0]), height.toward([-1.0, 0.0])]);
        marks
    }

    /// Two points of the line.
    fn end(&self, depth: f64, role: Role, z: f64) -> [Mark; 1] {
        let toward = if z < 0.0 { [0.3, -1.0] } else { [-1.0, 0.5] };
        let dot = mark(role, Shape::Dot(self.place(depth, z)));
        [dot.labelled(Value::Point([depth, z]))
            .strong()
            .toward(toward)]
    }

    /// The line through two of its points, and the triangle under it.
    fn climb(&self, [from, to]: [(f64, f64); 2], role: Role) -> Vec<Mark> {
        let corner = (to.0, from.1);
        let [a, b, c] = [from, corner, to].map(|(depth, z)| self.place(depth, z));
        let legs = [[a, b], [b, c]].map(|[from, to]| segment(Role::Ink, from, to));
        let [across, up] = legs;
        let across = across
            .labelled(Formula::decimals().num(to.0 - from.0))
            .toward([0.0, -1.0]);
        let up = up
            .labelled(Formula::decimals().num(to.1 - from.1))
            .toward([1.0, 0.0]);
        vec![
            mark(role, Shape::Fill(vec![vec![a, b, c]])),
            across.weighing(Weight::of(1.5)),
            up.weighing(Weight::of(1.5)),
            mark(Role::Soft, Shape::RightAngle([b, a, c])),
            segment(role, a, c),
        ]
    }

    /// From 0 through a point of the line to the ruler at far, and what is read there.
    fn ray(&self, depth: f64, z: f64, role: Role) -> [Mark; 2] {
        let (far, divided) = (self.input.volume.far(), z / self.input.w(depth));
        let tick = (far, divided * self.input.w(far));
        let from = match self.input.volume.sight() {
            Sight::Perspective => (0.0, 0.0),
            Sight::Parallel => (depth, z),
        };
        let foot = mark(role, Shape::Vertex(self.place(tick.0, tick.1)));
        [self.line(role, from, tick).weighing(Weight::of(1.0)), foot]
    }

    fn view(&self, at: &At<'_, Why<ProjectionRow>>) -> View {
        let [near, far] = [self.input.volume.near(), self.input.volume.far()];
        let ends = [(near, -self.input.w(near)), (far, self.input.w(far))];
        let [slope, start] = ["slope", "start"].map(|name| fact(&at.step, &NAMES, name));
        let on_line = |depth: f64| slope.unwrap_or(0.0) * depth + start.unwrap_or(0.0);
        let mut picture = Picture::new(&at.step, self.given());
        if at.step.held.get(Fact::Point).is_none() {
            picture.once(Fact::Slope, Role::Accent, |role, _| self.climb(ends, role));
            let back = |start: f64| [(0.0, start), ends[0]];
            picture.once(Fact::AtZero, Role::Accent, |role, start| {
                self.climb(back(start), role)
            });
        }
        picture.once(Fact::AtZero, Role::Ink, |role, start| {
            let line = self.line(role, (0.0, start), ends[1]);
            let ring = mark(role, Shape::Ring(self.place(0.0, start)));
            let ring = ring.labelled(Formula::decimals().num(start)).strong();
            [line, ring.toward([-1.0, 0.0])]
        });
        picture.once(Fact::Near, Role::Accent, |role, z| self.end(near, role, z));
        picture.once(Fact::Far, Role::Accent, |role, z| self.end(far, role, z));
        let depth = self.input.depth;
        picture.once(Fact::Point, Role::Accent, |role, z| {
            let dot = mark(role, Shape::Dot(self.place(depth, z))).labelled(name("P"));
            [dot.strong().toward([1.0, -1.0])]
        });
        picture.once(Fact::Divided, Role::Accent, |role, divided| {
            let [ray, tick] = self.ray(depth, on_line(depth), role);
            let label = Formula::decimals().num(divided);
            [ray, tick.labelled(label).strong().toward([1.0, 0.0])]
        });
        picture.once(Fact::Middle, Role::Accent, |role, middle| {
            let steps = (0..=STEPS).map(|i| near + (far - near) * f64::from(i) / f64::from(STEPS));
            let rays = steps.flat_map(|depth| self.ray(depth, on_line(depth), Role::Soft));
            let ring = mark(role, Shape::Ring(self.place(middle, 0.0)));
            let label = Formula::decimals().num(middle);
            let ring = ring.labelled(label).strong().toward([0.0, -1.0]);
            rays.chain([ring]).collect::<Vec<_>>()
        });
        let low = self.place(0.0, start_of(self.input))[1].min(-0.5 * SIZE[1]);
        picture.view(
            "why-view-depth",
            [[-0.35, low - 0.2], [SIZE[0] + 0.45, 0.5 * SIZE[1] + 0.2]],
        )
    }
}

/// Where the line will begin: the picture has room for it from the first step.
fn start_of(input: &ProjectionRowInput) -> f64 {
    silent::<Why<ProjectionRow>>(input)
        .get(Fact::AtZero)
        .unwrap_or(0.0)
}
