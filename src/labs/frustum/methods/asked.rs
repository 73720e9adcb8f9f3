//! What every method tells that asks planes one after the other: what each of them says of a point, a sphere or a box.

use crate::{
    algo::cull::Containment::{self, Inside, Outside, Straddles},
    figure::{
        Cell, Gauge, Gauges, Mark3, Role, Table, TableRow,
        Tick::{Cut, Test},
        View,
    },
    geom::{Camera, Plane, VolumeSide},
    labs::telling::{Named, Row},
    text::{Formula, Message, Value},
};

use super::{
    super::stage::{FaceLook, Fate, Scenery, plane_at_work},
    planes::{perpendicular, place, plane_link, plane_name},
};

/// The row of what one plane says, at this line of the pseudocode.
pub const fn says(class: Containment, line: usize, key: &'static str) -> Row {
    match class {
        Inside => Row::new(Test, line, key).keeps("plane"),
        Straddles => Row::new(Cut, line, key).cuts("plane"),
        Outside => Row::new(Cut, line, key).drops("plane"),
    }
}

/// The planes at a step, as far as they have been asked.
#[derive(Default)]
pub struct Asked<'a> {
    /// What is drawn around the run.
    pub scenery: Option<&'a Scenery>,
    /// How many planes there are.
    pub n_planes: usize,
    /// The plane that is asked at this step.
    pub current: Option<Plane>,
    /// What each plane that has been asked says: in the watch table, and of the thing as a whole.
    pub answers: Vec<(Value, Containment)>,
    /// What all planes say, once it is told.
    pub class: Option<Containment>,
}

impl Asked<'_> {
    /// The plane that is asked at this step.
    pub fn current_idx(&self) -> Option<usize> {
        self.current.and(self.answers.len().checked_sub(1))
    }

    /// The values of names that all these methods have.
    pub fn named(&self, name: &str) -> Option<Named> {
        let n_asked = self.answers.len();
        let count = |class| self.answers.iter().filter(|(_, it)| *it == class).count();
        Some(match name {
            "n" => place(self.current?.normal()).into(),
            "D" => self.current?.d().into(),
            "plane" => {
                let last = n_asked.checked_sub(1)?;
                Named::from(plane_name(self.scenery, last)).linked(plane_link(last))
            }
            "planes" if n_asked == 0 => self.n_planes.into(),
            "planes" => n_asked.into(),
            "cut" => count(Straddles).into(),
            "outside" => count(Outside).into(),
            "watch-class" => {
                let word = match self.class? {
                    Inside => "class-inside",
                    Straddles => "class-straddles",
                    Outside => "class-outside",
                };
                Value::Term(word).into()
            }
            _ => return None,
        })
    }

    /// The names of all `planes`; else the answers of those that have been asked.
    pub fn listed(&self, list: &str) -> Vec<Named> {
        if list == "planes" {
            let planes = 0..self.n_planes;
            return planes.map(|i| plane_name(self.scenery, i).into()).collect();
        }
        let answers = self.answers.iter().enumerate();
        let named = |(i, (answer, _)): (usize, &(Value, Containment))| {
            let answer = Named::from(answer.clone()).labelled(plane_name(self.scenery, i));
            answer.linked(plane_link(i))
        };
        answers.map(named).collect()
    }

    /// What becomes of the object in focus, as far as it is told.
    pub const fn fate(&self) -> Fate {
        fate_of(self.class)
    }

    /// The plane that is asked, and the perpendicular from a place at this distance.
    pub fn marks(&self, camera: &Camera, at: [f64; 3], distance: f64) -> Vec<Mark3> {
        let Some((plane_idx, plane)) = self.current_idx().zip(self.current) else {
            return Vec::new();
        };
        let mut marks = plane_at_work(camera, VolumeSide::ALL[plane_idx]);
        let label = Formula::default().sym("d").equals(distance);
        marks.extend(perpendicular(&plane, at, distance, label));
        marks
    }

    /// How what a plane says is drawn; none where it has not been asked.
    fn role(&self, plane_idx: usize) -> Option<Role> {
        let (_, class) = self.answers.get(plane_idx)?;
        Some(match class {
            _ if self.current_idx() == Some(plane_idx) => Role::Signal,
            Inside | Straddles => Role::Accent,
            Outside => Role::Discarded,
        })
    }

    /// Axes for the distances from all planes, those known so far filled in.
    pub fn gauges(&self, title: Message, band: f64, distances: &[f64]) -> Gauges {
        let row = |plane_idx: usize| Gauge {
            name: plane_name(self.scenery, plane_idx),
            value: distances.get(plane_idx).copied(),
            verdict: None,
            role: self.role(plane_idx).unwrap_or(Role::Soft),
            is_bar: false,
            link: Some(plane_link(plane_idx)),
        };
        Gauges {
            title,
            sides: [Message::new("gauge-outside"), Message::new("gauge-inside")],
            band: Some(band),
            rows: (0..self.n_planes).map(row).collect(),
        }
    }

    /// A table with a row a plane; `cells` are drawn as what the plane says.
    pub fn table(&self, header: Vec<Formula>, cells: impl Fn(usize, Role) -> Vec<Cell>) -> Table {
        let row = |plane_idx: usize| TableRow {
            name: plane_name(self.scenery, plane_idx),
            cells: cells(plane_idx, self.role(plane_idx).unwrap_or(Role::Ink)),
            is_current: self.current_idx() == Some(plane_idx),
            link: Some(plane_link(plane_idx)),
        };
        Table {
            header,
            rows: (0..self.n_planes).map(row).collect(),
            notes: Vec::new(),
        }
    }
}

/// What a test says of an object, as it is drawn.
pub const fn fate_of(class: Option<Containment>) -> Fate {
    match class {
        None => Fate::ToCome,
        Some(Inside) => Fate::Kept,
        Some(Straddles) => Fate::Cut,
        Some(Outside) => Fate::Culled,
    }
}

/// The observer's view and the camera's; `fate` is that of the object in focus.
pub fn both(scenery: &Scenery, fate: Fate, marks: Vec<Mark3>) -> [View; 2] {
    let focus = scenery.scene().focus();
    let fate = |i: usize| if i == focus { fate } else { Fate::ToCome };
    [
        scenery.observer(fate, marks),
        scenery.camera(fate, |_, _| FaceLook::Whole, Vec::new()),
    ]
}
