//! Why 1/depth is linear, shown: a fence of equal posts along an edge of the scene, in the camera's picture and from above.

use crate::{
    algo::why::{Fence, FenceFact as Fact, FenceInput, Shown, Why},
    figure::Weight,
    geom::Sight,
    labs::{
        space::{prelude::*, soup::surfaces_on_raster},
        why::{Picture, fact, mark, segment, tiles},
    },
};

/// How large each of the two drawings is.
const SIZE: [f64; 2] = [1.6, 1.2];
const BOUNDS: [[f64; 2]; 2] = [[-0.25, -0.3], [SIZE[0] + 0.3, SIZE[1] + 0.2]];

impl SpaceTelling for Why<Fence> {
    const SUBJECT: Subject = Subject::Surfaces;

    /// Of all edges in front of the eye the one along which the depth changes most.
    fn input(scene: &Scene) -> FenceInput {
        if scene.camera.camera().volume().sight() == Sight::Parallel {
            return FenceInput::NONE;
        }
        let surfaces = surfaces_on_raster(scene);
        let edges = surfaces
            .triangles()
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let fences = edges.map(|edge| FenceInput::new(edge.map(|[x, _, z]| [x, -z])));
        let change = |fence: &FenceInput| {
            fence
                .ends()
                .map_or(-1.0, |[from, to]| (from[1] - to[1]).abs())
        };
        let longest = fences.max_by(|a, b| change(a).total_cmp(&change(b)));
        longest.unwrap_or(FenceInput::NONE)
    }
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
            views.push(scenery.observer(|_| Fate::ToCome, Vec::new()));
        }
        let drawings = at.step.input.ends().map(|ends| {
            let drawn = Drawn { ends };
            let on_screen = drawn.on_screen(at).drawing("why-view-screen");
            vec![on_screen, drawn.plan(at).drawing("why-view-above")]
        });
        views.extend(drawings.map(|drawings| tiles(drawings, BOUNDS)));
        views
    }
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
    fn on_screen<'a>(&self, at: &At<'a, Why<Fence>>) -> Picture<'a, Fence> {
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
        picture
    }

    /// In the box of the drawing: the eye at its foot.
    fn place(&self, [across, ahead]: [f64; 2]) -> [f64; 2] {
        let [[x1, d1], [x2, d2]] = self.ends;
        let (low, high) = (x1.min(x2).min(0.0), x1.max(x2).max(0.0));
        let scale = (SIZE[0] / (high - low)).min(SIZE[1] / d1.max(d2));
        let middle = 0.5 * (low + high);
        [0.5 * SIZE[0] + scale * (across - middle), scale * ahead]
    }

    /// The same fence from above, and the sight lines of equal steps on the screen.
    fn plan<'a>(&self, at: &At<'a, Why<Fence>>) -> Picture<'a, Fence> {
        let [from, to] = self.ends;
        let eye = self.place([0.0, 0.0]);
        let slopes = self.ends.map(|[across, ahead]| across / ahead);
        let nearest = from[1].min(to[1]);
        let screen = slopes.map(|slope| self.place([0.6 * nearest * slope, 0.6 * nearest]));
        let named = mark(Role::Ink, Shape::Ring(eye)).labelled(Value::Term("w-lens-eye"));
        let fence = segment(Role::Accent, self.place(from), self.place(to));
        let given = vec![
            segment(Role::Soft, screen[0], screen[1]),
            fence.weighing(Weight::of(4.0)),
            named.toward([0.0, -1.0]),
        ];
        let mut picture = Picture::new(&at.step, given);
        for post in 0..=FenceInput::STEPS {
            picture.once(fact_of(post), Role::Ink, |role, depth| {
                let slope = slopes[0] + Self::part(post) * (slopes[1] - slopes[0]);
                let (post, tick) = (self.place([slope * depth, depth]), 0.6 * nearest);
                let label = mark(role, Shape::Dot(post)).labelled(Formula::decimals().num(depth));
                let sight = segment(Role::Faint, eye, post);
                [
                    sight,
                    mark(role, Shape::Vertex(self.place([slope * tick, tick]))),
                    label,
                ]
            });
        }
        picture
    }
}
