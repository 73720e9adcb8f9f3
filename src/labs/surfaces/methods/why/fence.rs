//! Why 1/depth is linear, shown: a fence of equal posts along an edge of the scene, in the camera's picture and from above.

use crate::{
    algo::why::{Fence, FenceFact as Fact, FenceInput, Shown, Why},
    figure::Weight,
    geom::Sight,
    labs::{
        space::{prelude::*, soup::surfaces_on_raster},
        why::{Picture, fact, mark, segment},
    },
};

/// How large the drawing is.
const SIZE: [f64; 2] = [1.6, 1.2];
const BOUNDS: [[f64; 2]; 2] = [[-0.25, -0.3], [SIZE[0] + 0.3, SIZE[1] + 0.2]];

impl SpaceTelling for Why<Fence> {
    const SUBJECT: Subject = Subject::Surfaces;

    fn input(scene: &Scene) -> FenceInput {
        edge(scene).map_or(FenceInput::NONE, |edge| fence(&edge))
    }
}

/// Across and ahead.
fn fence(edge: &[[f64; 3]; 2]) -> FenceInput {
    FenceInput::new(edge.map(|[x, _, z]| [x, -z]))
}

/// In view space: of all edges that can be seen from aside the one along which the depth changes most.
fn edge(scene: &Scene) -> Option<[[f64; 3]; 2]> {
    if scene.camera.camera().volume().sight() == Sight::Parallel {
        return None;
    }
    let surfaces = surfaces_on_raster(scene);
    let edges = surfaces
        .triangles()
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let seen = edges.filter(|edge| fence(edge).ends().is_some());
    let change = |[from, to]: &[[f64; 3]; 2]| (from[2] - to[2]).abs();
    seen.max_by(|a, b| change(a).total_cmp(&change(b)))
}

const NAMES: [(&str, Fact); 5] = [
    ("first", Fact::First),
    ("last", Fact::Last),
    ("height", Fact::Height),
    ("drop", Fact::Drop),
    ("step", Fact::Step),
];

impl Telling for Why<Fence> {
    type Scenery = Scenery;

    const ID: &'static str = "why-fence";
    const NAME_KEY: &'static str = "why-fence";
    const SOURCE: &'static str = "Blinn, 1992";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-ends", "why-words-ends"),
        code_line(0, "why-code-posts", "why-words-posts"),
        code_line(0, "why-code-post", "why-words-post"),
        code_line(0, "why-code-top", "why-words-top"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::List("depths"),
        Watched::Names(&["height", "drop", "step"]),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-fence-opening");

    table! { |event, step|
        nothing: Shown { fact: Fact::Nothing, .. } => Row::new(Reject, 0, "why-fence-nothing");
        first: Shown { fact: Fact::First, .. } => Row::new(Test, 0, "why-fence-first");
        last: Shown { fact: Fact::Last, .. } => Row::new(Test, 0, "why-fence-last");
        post: Shown { fact: Fact::Post { .. }, .. } => Row::new(Test, 1, "why-fence-post");
        height: Shown { fact: Fact::Height, .. } =>
            Row::new(Test, 2, "why-fence-height").so(&["~ {1 / first}{=height}"]);
        drop: Shown { fact: Fact::Drop, .. } =>
            Row::new(Test, 3, "why-fence-drop").so(&["~ {1 / first} − {1 / last}{=drop}"]);
        each: Shown { fact: Fact::Step, .. } =>
            Row::new(Accept, 3, "why-fence-step").so(&["~ {drop / steps}{=step}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        Some(match (name, at.step.event()?) {
            ("1", _) => 1.0.into(),
            ("steps", _) => (FenceInput::STEPS as f64).into(),
            ("depth", shown) => shown.number.into(),
            (
                "post",
                Shown {
                    fact: Fact::Post { nth },
                    ..
                },
            ) => nth.into(),
            (
                "before",
                Shown {
                    fact: Fact::Post { nth },
                    ..
                },
            ) => depth_of(at, nth - 1)?.into(),
            _ => fact(&at.step, &NAMES, name)?.into(),
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let posts = 0..=FenceInput::STEPS;
        let named = |nth: usize| {
            let depth = Formula::decimals().num(depth_of(at, nth)?);
            Some(Named::from(depth).labelled(Value::Count(nth)))
        };
        posts.filter_map(named).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            views.push(scenery.observer(|_| Fate::ToCome, in_space(at, scenery)));
        }
        let ends = at.step.input.ends();
        views.extend(ends.map(|ends| Drawn { ends }.on_screen(at)));
        views
    }
}

/// The fence, and its posts as far as they have been found.
fn in_space(at: &At<'_, Why<Fence>>, scenery: &Scenery) -> Vec<Mark3> {
    let camera = scenery.scene().camera.camera();
    let Some([from, to]) = edge(scenery.scene()) else {
        return Vec::new();
    };
    let [world, far] = [from, to].map(|at| camera.world_from_view(at));
    let mut marks = vec![Mark3::new(Role::Accent, Shape3::Segment([world, far]))];
    for post in 0..=FenceInput::STEPS {
        let Some(depth) = depth_of(at, post) else {
            continue;
        };
        let along = match to[2] - from[2] {
            0.0 => Drawn::part(post),
            whole => (-depth - from[2]) / whole,
        };
        let foot: [f64; 3] = std::array::from_fn(|i| from[i] + along * (to[i] - from[i]));
        let ends = [foot, [foot[0], foot[1] + 1.0, foot[2]]].map(|at| camera.world_from_view(at));
        let is_now = at
            .step
            .event()
            .is_some_and(|shown| shown.fact == fact_of(post));
        let role = if is_now { Role::Signal } else { Role::Ink };
        let sight = Shape3::Segment([camera.position(), ends[0]]);
        let drawn = Mark3::new(role, Shape3::Segment(ends));
        // All of them would cover each other: the others are read on the screen.
        let is_said = is_now || [0, FenceInput::STEPS].contains(&post);
        let label = Value::Formula(Formula::decimals().num(depth));
        marks.push(Mark3::new(Role::Soft, sight).fine());
        marks.push(if is_said {
            drawn.labelled(label)
        } else {
            drawn
        });
    }
    marks
}

const fn fact_of(post: usize) -> Fact {
    match post {
        0 => Fact::First,
        FenceInput::STEPS => Fact::Last,
        nth => Fact::Post { nth },
    }
}

/// How deep the fence is at a post, both ends included, as far as that has been shown.
fn depth_of(at: &At<'_, Why<Fence>>, post: usize) -> Option<f64> {
    at.step.held.get(fact_of(post))
}

struct Drawn {
    ends: [[f64; 2]; 2],
}

impl Drawn {
    /// Of a post, from the first to the last.
    fn part(post: usize) -> f64 {
        post as f64 / FenceInput::STEPS as f64
    }

    /// On the screen: from the left, and a height as a part of the highest.
    fn screen(&self, post: usize, height: f64) -> [f64; 2] {
        let [[_, d1], [_, d2]] = self.ends;
        [SIZE[0] * Self::part(post), SIZE[1] * height * d1.min(d2)]
    }

    /// Posts at equal steps, each 1/depth high, and what each step takes.
    fn on_screen(&self, at: &At<'_, Why<Fence>>) -> View {
        let [[_, d1], [_, d2]] = self.ends;
        let posts = [0, FenceInput::STEPS];
        let [from, to] = posts.map(|post| self.screen(post, 0.0));
        let mut picture = Picture::new(&at.step, vec![segment(Role::Accent, from, to)]);
        let top = |post: usize| {
            let part = Self::part(post);
            (1.0 - part) / d1 + part / d2
        };
        picture.once(Fact::Drop, Role::Accent, |role, _| {
            let [from, to] = posts.map(|post| self.screen(post, top(post)));
            [segment(role, from, to)]
        });
        for post in 0..=FenceInput::STEPS {
            picture.once(fact_of(post), Role::Ink, |role, depth| {
                let [foot, tip] = [0.0, 1.0 / depth].map(|height| self.screen(post, height));
                let bar = segment(role, foot, tip).weighing(Weight::of(2.5));
                let label =
                    mark(role, Shape::Vertex(foot)).labelled(Formula::decimals().num(depth));
                [bar, label.toward([0.0, -1.0])]
            });
        }
        picture.once(Fact::Height, Role::Accent, |role, height| {
            let tip = mark(role, Shape::Dot(self.screen(0, height)));
            [tip.labelled(Formula::decimals().num(height))
                .strong()
                .toward([0.0, 1.0])]
        });
        picture.once(Fact::Step, Role::Accent, |role, step| {
            let steps = (0..FenceInput::STEPS).flat_map(|post| {
                let [before, after] = [top(post), top(post + 1)];
                let corner = self.screen(post + 1, before);
                let level = segment(Role::Faint, self.screen(post, before), corner);
                let taken = segment(role, corner, self.screen(post + 1, after));
                let taken = taken.labelled(Formula::decimals().num(step.abs()));
                [level, taken.weighing(Weight::of(4.0)).toward([1.0, 0.0])]
            });
            steps.collect::<Vec<_>>()
        });
        picture.view("why-view-screen", BOUNDS)
    }
}
