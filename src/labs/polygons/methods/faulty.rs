//! "What is wrong here?": the mistakes of [`crate::algo::polygon::faulty`], shown on the reader's own input. Each is stepped like the right
//! one, says what it does and not that it is wrong, up to the first step at which it differs.

use serde_json::Value as Json;

use crate::{
    algo::{
        line::Ratio,
        polygon::{
            ClippedRing, SutherlandHodgman, SutherlandHodgmanEvent as Event,
            SutherlandHodgmanInput as Input, SutherlandHodgmanState as State,
            faulty::{
                CutsTwice, DropsOnBorder, EndFirst, Faulty, KeepsUv, LeavesOpen, WalksClockwise,
            },
        },
    },
    figure::{Caption, Frame, Run, Tick, View, Watch},
    geom::Point,
    labs::{
        self, CodeLine, Demo, Step, code_line,
        polygons::{PolygonDemo, Refusal, Scene},
    },
    text::{Formula, Message},
    trace::{Algorithm, Counts},
};

use super::{
    clip_edge::Look,
    skin::{Corner, Named},
    sutherland_hodgman::{
        CODE, EACH, EDGES, IN_OUT, OUT_IN, SOURCE, caption, input, line_of, opening, textured,
        tick, views, watch,
    },
};

/// Takes a vertex on the border for outside.
pub type OnBorder = Faulty<DropsOnBorder>;
/// Leaves the closing edge out.
pub type Open = Faulty<LeavesOpen>;
/// Walks the clip edges the wrong way.
pub type Clockwise = Faulty<WalksClockwise>;
/// Puts crossings out twice.
pub type Twice = Faulty<CutsTwice>;
/// Puts the end of an edge out before its crossing.
pub type EndBeforeCrossing = Faulty<EndFirst>;

impl Corner for KeepsUv {
    fn uv(&self) -> Option<[f64; 2]> {
        Some(self.uv)
    }

    fn uv_formula(&self, ends: [&Named<Self>; 2], _: Ratio) -> Option<Formula> {
        let owner = ends.into_iter().find(|end| end.vertex.uv == self.uv)?;
        let formula = Formula::default().sym(format!("uv(I) = uv({}) = ", owner.symbol));
        Some(formula.point(self.uv))
    }
}

/// The right algorithm on vertices that keep their place in the texture when they are moved.
pub fn with_kept_texture(scene: &Scene) -> Result<Box<dyn Run>, Refusal> {
    let input = textured(scene, |at, uv| KeepsUv { at, uv })?;
    Ok(labs::record::<SutherlandHodgman<KeepsUv>>(input))
}

/// How a mistake is called, and what gives it away.
trait Mistake: 'static {
    const ID: &'static str;
    const NAME_KEY: &'static str;
    const LOOK: Look = Look {
        is_flipped: false,
        is_strict: false,
    };
    /// Said at the first step that differs.
    const DIFFERS_KEY: &'static str;
    /// The right pseudocode, but for the lines with the mistake.
    const CODE: [CodeLine; CODE.len()];
}

/// The right pseudocode with other lines in some places.
const fn but_for<const N: usize>(wrong: [(usize, CodeLine); N]) -> [CodeLine; CODE.len()] {
    let mut lines = [CODE[0]; CODE.len()];
    let mut i = 0;
    while i < CODE.len() {
        lines[i] = CODE[i];
        i += 1;
    }
    let mut i = 0;
    while i < N {
        lines[wrong[i].0] = wrong[i].1;
        i += 1;
    }
    lines
}

impl Mistake for DropsOnBorder {
    const ID: &'static str = "faulty-on-border";
    const NAME_KEY: &'static str = "alg-faulty-on-border";
    const LOOK: Look = Look {
        is_flipped: false,
        is_strict: true,
    };
    const DIFFERS_KEY: &'static str = "faulty-on-border-differs";
    const CODE: [CodeLine; CODE.len()] = but_for([(
        EACH,
        code_line(0, "code-faulty-on-border", "words-faulty-on-border"),
    )]);
}

impl Mistake for LeavesOpen {
    const ID: &'static str = "faulty-open";
    const NAME_KEY: &'static str = "alg-faulty-open";
    const DIFFERS_KEY: &'static str = "faulty-open-differs";
    const CODE: [CodeLine; CODE.len()] =
        but_for([(EDGES, code_line(1, "code-faulty-open", "words-faulty-open"))]);
}

impl Mistake for WalksClockwise {
    const ID: &'static str = "faulty-clockwise";
    const NAME_KEY: &'static str = "alg-faulty-clockwise";
    const LOOK: Look = Look {
        is_flipped: true,
        is_strict: false,
    };
    const DIFFERS_KEY: &'static str = "faulty-clockwise-differs";
    const CODE: [CodeLine; CODE.len()] = but_for([(
        EACH,
        code_line(0, "code-faulty-clockwise", "words-faulty-clockwise"),
    )]);
}

impl Mistake for CutsTwice {
    const ID: &'static str = "faulty-twice";
    const NAME_KEY: &'static str = "alg-faulty-twice";
    const DIFFERS_KEY: &'static str = "faulty-twice-differs";
    const CODE: [CodeLine; CODE.len()] = but_for([
        (
            IN_OUT,
            code_line(2, "code-faulty-twice-out", "words-faulty-twice-out"),
        ),
        (
            OUT_IN,
            code_line(2, "code-faulty-twice-in", "words-faulty-twice-in"),
        ),
    ]);
}

impl Mistake for EndFirst {
    const ID: &'static str = "faulty-end-first";
    const NAME_KEY: &'static str = "alg-faulty-end-first";
    const DIFFERS_KEY: &'static str = "faulty-end-first-differs";
    const CODE: [CodeLine; CODE.len()] = but_for([(
        OUT_IN,
        code_line(2, "code-faulty-end-first", "words-faulty-end-first"),
    )]);
}

/// The right one's types.
trait LikeTheRightOne:
    Algorithm<Input = Input, Output = ClippedRing<Point>, Event = Event<Point>, State = State<Point>>
{
}

impl<A> LikeTheRightOne for A where
    A: Algorithm<
            Input = Input,
            Output = ClippedRing<Point>,
            Event = Event<Point>,
            State = State<Point>,
        >
{
}

impl<L: Mistake> Demo for Faulty<L>
where
    Self: LikeTheRightOne,
{
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = SOURCE;
    const CODE: &'static [CodeLine] = &L::CODE;
    const IS_FAULTY: bool = true;

    fn tick(event: &Event<Point>) -> Tick {
        tick(event)
    }

    fn code_line(event: &Event<Point>, before: &State<Point>) -> usize {
        line_of(event, before)
    }

    fn opening(input: &Input) -> Caption {
        opening(input)
    }

    fn caption(event: &Event<Point>, before: &State<Point>, input: &Input) -> Caption {
        caption(event, before, &input.region, L::LOOK)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        views(step.input, step.state, step.event, L::LOOK)
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        watch(step.state)
    }
}

impl<L: Mistake> PolygonDemo for Faulty<L>
where
    Self: LikeTheRightOne,
{
    fn input(scene: &Scene) -> Result<Input, Refusal> {
        input(scene)
    }

    fn record(scene: &Scene) -> Result<Box<dyn Run>, Refusal> {
        let input = input(scene)?;
        let (wrong, right) = (events::<Self>(&input), events::<SutherlandHodgman>(&input));
        let differs = wrong.iter().zip(&right).position(|(w, r)| w != r);
        Ok(Box::new(Marked {
            run: labs::record::<Self>(input),
            differs_at: differs.map(|event_idx| event_idx + 1),
            key: L::DIFFERS_KEY,
        }))
    }
}

fn events<A: Algorithm>(input: &A::Input) -> Vec<A::Event> {
    let mut events = Vec::new();
    A::run::<f64>(input, |event| events.push(event));
    events
}

/// A run whose first step that differs from the right one's says so.
struct Marked {
    run: Box<dyn Run>,
    /// None where the mistake does not show on this input.
    differs_at: Option<usize>,
    key: &'static str,
}

impl Run for Marked {
    fn n_steps(&self) -> usize {
        self.run.n_steps()
    }

    fn tick(&self, step: usize) -> Tick {
        if self.differs_at == Some(step) {
            Tick::Reject
        } else {
            self.run.tick(step)
        }
    }

    fn event_json(&self, step: usize) -> Json {
        self.run.event_json(step)
    }

    fn counts_at(&self, step: usize) -> Counts {
        self.run.counts_at(step)
    }

    fn frame(&self, step: usize) -> Frame {
        let mut frame = self.run.frame(step);
        if self.differs_at == Some(step) {
            let caption = &mut frame.caption;
            caption.decision = Message::new(self.key).with("step", step);
        }
        frame
    }

    fn output_json(&self) -> Json {
        self.run.output_json()
    }
}
