//! Why a side's normal is (±cos α, 0, −sin α), shown: the right plane from above, one unit of it, and that unit turned by 90°.
//!
//! ```text
//!      n        │0.5032 ╱ right plane
//!       ╲       ├──────╱
//!  0.5032│╲     │     ╱
//!        └──╲───┘eye ╱     the legs have changed places
//!         0.8641
//! ```

use crate::{
    algo::why::{QuarterTurn, QuarterTurnFact as Fact, QuarterTurnInput, Shown, Why},
    figure::Weight,
    labs::{
        frustum::prelude::*,
        why::{Picture, fact, mark, segment},
    },
};

use super::super::asked::place;

const BOUNDS: [[f64; 2]; 2] = [[-1.12, -0.2], [1.12, 1.25]];

impl SpaceTelling for Why<QuarterTurn> {
    const SUBJECT: Subject = Subject::Point;

    fn input(scene: &Scene) -> QuarterTurnInput {
        let camera = scene.culler();
        let point = camera.view_from_world().point(scene.places().point);
        QuarterTurnInput {
            volume: *camera.volume(),
            point,
        }
    }
}

const NAMES: [(&str, Fact); 6] = [
    ("tan α", Fact::Tangent),
    ("sin α", Fact::Across),
    ("cos α", Fact::Ahead),
    ("across", Fact::TurnedAcross),
    ("ahead", Fact::TurnedAhead),
    ("d", Fact::Distance),
];

impl Telling for Why<QuarterTurn> {
    type Scenery = Scenery;

    const ID: &'static str = "why-quarter-turn";
    const NAME_KEY: &'static str = "why-quarter-turn";
    const SOURCE: &'static str = "Gribb & Hartmann, 2001";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-tangent", "why-words-tangent"),
        code_line(0, "why-code-unit", "why-words-unit"),
        code_line(0, "why-code-turn", "why-words-turn"),
        code_line(0, "why-code-check", "why-words-check"),
    ];
    const WATCH: &'static [Watched] =
        &[Watched::Names(&["tan α", "sin α", "cos α", "n", "P", "d"])];
    const OPENING: Row = Row::new(Phase, 0, "why-turn-opening").so(&["P = {P}"]);

    table! { |event, step|
        tangent: Shown { fact: Fact::Tangent, .. } =>
            Row::new(Test, 0, "why-turn-tangent").so(&["~ tan α{=tan α}"]);
        across: Shown { fact: Fact::Across, .. } =>
            Row::new(Test, 1, "why-turn-across").so(&["~ sin α{=sin α}"]);
        ahead: Shown { fact: Fact::Ahead, .. } =>
            Row::new(Test, 1, "why-turn-ahead").so(&["~ cos α{=cos α}"]);
        turned_across: Shown { fact: Fact::TurnedAcross, .. } =>
            Row::new(Test, 2, "why-turn-turned-across").so(&["~ −cos α{=across}"]);
        turned_ahead: Shown { fact: Fact::TurnedAhead, .. } =>
            Row::new(Accept, 2, "why-turn-turned-ahead").so(&["~ n = {n}"]);
        distance: Shown { fact: Fact::Distance, .. } =>
            Row::new(Accept, 3, "why-turn-distance").so(&["~ d = {products}{=d}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (input, number) = (at.step.input, |name: &str| fact(&at.step, &NAMES, name));
        Some(match name {
            "P" => place(input.point).into(),
            "n" => place([number("across")?, 0.0, -number("ahead")?]).into(),
            "products" => {
                let [x, _, z] = input.point;
                let terms = [(number("across")?, x), (number("ahead")?, -z)];
                let sum = sum_of(Formula::decimals(), terms, times);
                let aside = input.aside();
                if aside == 0.0 {
                    sum
                } else {
                    sum.sym(" + ").num(aside)
                }
                .into()
            }
            _ => number(name)?.into(),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let camera = scenery.scene().culler();
            let mut marks = plane_at_work(camera, VolumeSide::Right);
            if at.step.held.get(Fact::TurnedAhead).is_some() {
                marks.extend(normal_of(camera, VolumeSide::Right, false));
            }
            let point = Mark3::new(Role::Accent, Shape3::Dot(scenery.scene().places().point));
            marks.push(point.labelled(name("P")).strong());
            views.push(scenery.observer(|_| Fate::ToCome, marks));
        }
        views.push(plan(at));
        views
    }
}

/// From above, the eye at 0: across to the right, ahead upwards.
fn plan(at: &At<'_, Why<QuarterTurn>>) -> View {
    let facts = silent::<Why<QuarterTurn>>(at.step.input);
    let number = |fact| facts.get(fact).unwrap_or(0.0);
    let along = [number(Fact::Across), number(Fact::Ahead)];
    let normal = [number(Fact::TurnedAcross), number(Fact::TurnedAhead)];
    let eye = [0.0, 0.0];
    let decimal = |x: f64| Formula::decimals().num(x);
    let mut picture = Picture::new(&at.step, seen_from(eye, along));
    picture.once(Fact::Tangent, Role::Ink, |role, _| {
        let angle = mark(role, Shape::Angle([eye, along, [0.0, 1.0]]));
        [
            mark(role, Shape::Arrow([eye, along])),
            angle.labelled(name("α")),
        ]
    });
    let foot = [0.0, along[1]];
    picture.once(Fact::Across, Role::Accent, |role, across| {
        let leg = segment(role, foot, along)
            .labelled(decimal(across))
            .strong();
        [
            leg.toward([0.0, 1.0]),
            mark(Role::Soft, Shape::RightAngle([foot, along, eye])),
        ]
    });
    picture.once(Fact::Ahead, Role::Ink, |role, ahead| {
        let leg = segment(role, eye, foot).labelled(decimal(ahead)).strong();
        [leg.toward([-1.0, 0.0])]
    });
    let foot = [normal[0], 0.0];
    picture.once(Fact::TurnedAcross, Role::Ink, |role, across| {
        let leg = segment(role, eye, foot).labelled(decimal(across)).strong();
        let angle = mark(Role::Signal, Shape::RightAngle([eye, along, normal]));
        let arrow = mark(Role::Ink, Shape::Arrow([eye, normal]))
            .labelled(name("n"))
            .strong();
        [leg.toward([0.0, -1.0]), angle, arrow]
    });
    picture.once(Fact::TurnedAhead, Role::Accent, |role, ahead| {
        let leg = segment(role, foot, normal)
            .labelled(decimal(ahead))
            .strong();
        let other = [-normal[0], normal[1]];
        let other = mark(Role::Soft, Shape::Arrow([eye, other])).dashed();
        let other = other.labelled(Value::Term("why-mirrored"));
        [
            leg.toward([-1.0, 0.0]),
            mark(Role::Soft, Shape::RightAngle([foot, normal, eye])),
            other,
        ]
    });
    picture.view("why-view-above", BOUNDS)
}

/// The eye, its unit circle, and the volume between its side planes, of which the right one goes that way.
fn seen_from(eye: [f64; 2], along: [f64; 2]) -> Vec<Mark> {
    let arc = (0..=48).map(|i| {
        let angle = std::f64::consts::PI * f64::from(i) / 48.0;
        [libm::cos(angle), libm::sin(angle)]
    });
    let reach = |[x, y]: [f64; 2]| [1.25 * x, 1.25 * y];
    let [right, left] = [along, [-along[0], along[1]]].map(reach);
    let volume = vec![eye, right, left];
    vec![
        mark(Role::Ink, Shape::Fill(vec![volume])),
        mark(Role::Faint, Shape::Path(arc.collect())).dashed(),
        segment(Role::Faint, eye, [0.0, 1.25]),
        segment(Role::Accent, eye, left).weighing(Weight::of(1.0)),
        segment(Role::Accent, eye, right).labelled(Value::Term("plane-right")),
        mark(Role::Ink, Shape::Ring(eye))
            .labelled(Value::Term("w-lens-eye"))
            .toward([0.0, -1.0]),
    ]
}
