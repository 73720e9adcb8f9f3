//! The third lab in its layers: scene, spelling in files, panel.

use std::cell::Cell;

use egui::Ui;

use crate::{
    case::{self, Refusal, Solve, Solver},
    figure::{Link, Mark, Run},
    input::{Field, Part, Shape},
    labs::{
        Answers, Backdrop, Click, Document, Draggable, Edit, Handle, HandleKind, Lab, MethodCard,
        Motion, Own, Scene, recorded::Recorded,
    },
    lesson::{SceneFormat, Sink, TomlFields, number},
    panels::{LabPanel, PanelAsk},
    text::{Diagnostic, Message},
    widgets::Look,
};

use super::corners::{Corners, Input, NInside};

/// A box around the origin, and the plane x = c.
pub static LAB: &dyn Lab = &Boxes;

struct Boxes;

impl Lab for Boxes {
    fn id(&self) -> &'static str {
        "boxes"
    }

    fn name_key(&self) -> &'static str {
        "object-window"
    }

    fn about_key(&self) -> &'static str {
        "object-window"
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        vec![&CARD]
    }

    fn first_scene(&self) -> Scene {
        BoxScene { half: 1.0, c: 0.5 }.into()
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        &["box"]
    }
}

static CARD: MethodCard = MethodCard::of::<Corners>();

/// The face at x = half moves along x.
static FACE: HandleKind = HandleKind {
    motion: Motion::Axis([1.0, 0.0, 0.0]),
    ..HandleKind::new("face", "box", |_| Message::new("handle-window"))
};

/// The handle of the face at x = half.
pub fn face() -> Handle {
    FACE.at([0, 0])
}

thread_local! {
    /// How often this thread has recorded a box.
    pub static N_RECORDED: Cell<usize> = const { Cell::new(0) };
    /// What was clicked last on this thread.
    pub static CLICKED: Cell<Option<Link>> = const { Cell::new(None) };
}

#[derive(Clone, PartialEq, Debug)]
pub struct BoxScene {
    pub half: f64,
    pub c: f64,
}

impl Backdrop for BoxScene {
    fn backdrop(&self, _: usize, _: bool) -> Vec<Mark> {
        Vec::new()
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        [[-1.0; 2], [1.0; 2]]
    }
}

impl Draggable for BoxScene {
    fn handles(&self) -> Vec<Handle> {
        vec![face()]
    }

    fn position(&self, handle: Handle) -> Option<[f64; 3]> {
        handle.is(&FACE).then_some([self.half, 0.0, 0.0])
    }

    fn drag(&mut self, _: Handle, [x, ..]: [f64; 3]) -> Result<(), Diagnostic> {
        if !x.is_finite() || x <= 0.0 {
            return Err(Message::new("error-not-finite").into());
        }
        self.half = x;
        Ok(())
    }
}

impl Answers for BoxScene {}

impl Document for BoxScene {
    fn lab(&self) -> &'static dyn Lab {
        LAB
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        vec![&CARD]
    }

    fn set_method(&mut self, _: &str) {}

    fn set_compare(&mut self, _: Option<&str>) {}

    fn record(&self) -> Vec<Box<dyn Run>> {
        N_RECORDED.set(N_RECORDED.get() + 1);
        let &Self { half, c } = self;
        vec![Box::new(Recorded::<Corners>::new(Input { half, c }, None))]
    }

    fn add(&mut self, _: Option<Handle>) -> Result<Option<Handle>, Diagnostic> {
        Ok(None)
    }

    fn remove(&mut self, _: Option<Handle>) -> Result<(), Diagnostic> {
        Ok(())
    }

    fn click(&self, click: &Click<'_>) -> Option<Own> {
        CLICKED.set(click.link);
        None
    }

    fn size(&self) -> usize {
        8
    }
}

/// How it is spelt: `method`, `half`, `c`.
pub struct BoxFormat;

impl SceneFormat for BoxFormat {
    fn lab(&self) -> &'static dyn Lab {
        LAB
    }

    fn fields(&self) -> &'static [&'static str] {
        &["method", "half", "c"]
    }

    fn own_field(&self) -> &'static str {
        "half"
    }

    fn room(&self) -> usize {
        100
    }

    fn read(
        &self,
        fields: &TomlFields<'_>,
        room: &mut usize,
        sink: &mut Sink<'_>,
    ) -> Option<Scene> {
        *room -= 8;
        let mut read = |name| {
            let item = fields.require(name, sink)?;
            number(item, "expect-point", sink)
        };
        let (half, c) = (read("half")?, read("c")?);
        Some(BoxScene { half, c }.into())
    }

    fn write(&self, scene: &Scene) -> Option<String> {
        let BoxScene { half, c } = scene.get()?;
        Some(format!("half = {half:?}\nc = {c:?}\n"))
    }
}

pub struct BoxPanel;

impl LabPanel for BoxPanel {
    fn lab(&self) -> &'static dyn Lab {
        LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, _: &Scene) -> Option<PanelAsk> {
        let pressed = ui.button(look.say("object-window")).clicked();
        pressed.then(|| PanelAsk::Edit(Edit::Drag(face(), [2.0, 0.0, 0.0])))
    }
}

/// How a case gives it: `half`, `c`.
pub static SOLVERS: [Solver; 1] = [Solver::of::<Corners>()];

const HALF: Part<f64> = Part::new("half", &Shape::Number, |got| Ok(got.number()));
const C: Part<f64> = Part::new("c", &Shape::Number, |got| Ok(got.number()));

impl Solve for Corners {
    const FIELDS: &'static [Field] = &[HALF.required(), C.required()];
    const OUTPUT: &'static [Field] = &[Field::required("n_inside", &Shape::COUNT)];

    fn read(fields: &case::Fields<'_>) -> Result<Input, Refusal> {
        let (half, c) = (fields.need(&HALF)?, fields.need(&C)?);
        Ok(Input { half, c })
    }

    fn verdict(_: &NInside) -> Message {
        Message::new("sh-inside")
    }
}
