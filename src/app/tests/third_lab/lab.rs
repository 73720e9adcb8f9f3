//! The third lab in its layers: scene, spelling in files, panel.

use std::cell::Cell;

use egui::Ui;

use crate::{
    case::{Reading, Solve, Solver, Verdict},
    figure::{Link, Mark, Run},
    input::{Field, Part, Shape},
    labs::{
        Answers, Backdrop, Click, Document, Draggable, Edit, Handle, HandleKind, Lab, MethodCard,
        Motion, Own, Scene, recorded::Recorded,
    },
    lesson::SceneFormat,
    panels::{LabPanel, PanelAsk},
    text::{Diagnostic, Message},
    widgets::Look,
};

use super::corners::{Corners, Input};

pub static LAB: &Lab = &Lab {
    id: "boxes",
    name_key: "object-window",
    about_key: "object-window",
    recording_key: "recording-vertices",
    methods: || vec![&CARD],
    first_scene: || BoxScene { half: 1.0, c: 0.5 }.into(),
    smallest_scene: || BoxScene { half: 1.0, c: 0.5 }.into(),
    lock_groups: &["box"],
    controls: Vec::new,
    adopt: |_| None,
    outlines: &[],
};

static CARD: MethodCard = MethodCard::of::<Corners>();

static FACE: HandleKind = HandleKind {
    motion: Motion::Axis([1.0, 0.0, 0.0]),
    ..HandleKind::new("face", "box", |_| Message::new("handle-window"))
};

pub fn face() -> Handle {
    FACE.at([0, 0])
}

thread_local! {
    pub static N_RECORDED: Cell<usize> = const { Cell::new(0) };
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
    fn lab(&self) -> &'static Lab {
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

pub static FORMAT: SceneFormat = SceneFormat {
    lab: LAB,
    fields: &["method", "half", "c"],
    own_field: "half",
    room: 100,
    read: |fields, room| {
        *room -= 8;
        let read = |name| fields.require(name)?.number("expect-point");
        let (half, c) = (read("half")?, read("c")?);
        Some(BoxScene { half, c }.into())
    },
    write: |scene| {
        let BoxScene { half, c } = scene.get()?;
        Some(format!("half = {half:?}\nc = {c:?}\n"))
    },
};

pub struct BoxPanel;

impl LabPanel for BoxPanel {
    fn lab(&self) -> &'static Lab {
        LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, _: &Scene) -> Option<PanelAsk> {
        let pressed = ui.button(look.say("object-window")).clicked();
        pressed.then(|| PanelAsk::Edit(Edit::Drag(face(), [2.0, 0.0, 0.0])))
    }
}

pub static SOLVERS: [Solver; 1] = [Solver::of::<Corners>()];

const HALF: Part<f64> = Part::new("half", &Shape::Number, |got| Ok(got.number()));
const C: Part<f64> = Part::new("c", &Shape::Number, |got| Ok(got.number()));

impl Solve for Corners {
    const FIELDS: &'static [Field] = &[HALF.required(), C.required()];
    const OUTPUT: &'static [Field] = &[Field::required("n_inside", &Shape::COUNT)];
    const READ: Reading<Self> = |fields| {
        let (half, c) = (fields.need(&HALF)?, fields.need(&C)?);
        Ok(Input { half, c })
    };
    const VERDICT: Verdict<Self> = |_| Message::new("sh-inside");
}
