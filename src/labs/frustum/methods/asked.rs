//! What all methods tell that ask planes: how a plane is called and measured, and what each says of a point, a sphere or a box.

use crate::labs::{frustum::prelude::*, plane_symbol};

use super::super::Object;

/// A plane's name: its side's in a scene, a symbol where a case gives planes alone.
pub fn plane_name(scenery: Option<&Scenery>, plane_idx: usize) -> Value {
    match scenery.and(VolumeSide::ALL.get(plane_idx)) {
        Some(&side) => side_name(side),
        None => Value::Name(plane_symbol(plane_idx)),
    }
}

pub fn plane_link(plane_idx: usize) -> Link {
    let side = VolumeSide::ALL.get(plane_idx);
    side.map_or(Link::nth("plane", plane_idx), |&side| side_link(side))
}

/// `d = n·c + D = 0.9 · (−5.5) + … = −3.4`, divided by |n| where that is not 1.
pub fn distance_formula(symbol: [&str; 2], plane: &Plane, at: [f64; 3], d: f64) -> Formula {
    if plane.length() == 1.0 {
        return sum_formula(symbol, plane, at, d);
    }
    let symbol = format!("{} = (n·{} + D) / |n| = ", symbol[0], symbol[1]);
    let quotient = sym(symbol);
    let length = Formula::default().num(plane.length());
    let sum = terms(Formula::default(), plane, at);
    quotient.over(sum, length).equals(d)
}

/// `d₁ = n·P₁ + D = 1 · (−2) + 3 = 1`, not divided by |n|.
pub fn sum_formula([d, p]: [&str; 2], plane: &Plane, at: [f64; 3], sum: f64) -> Formula {
    let formula = sym(format!("{d} = n·{p} + D = "));
    terms(formula, plane, at).equals(sum)
}

fn terms(formula: Formula, plane: &Plane, at: [f64; 3]) -> Formula {
    let terms = plane.normal().into_iter().zip(at);
    let formula = sum_of(formula, terms.filter(|&(n, _)| n != 0.0), times);
    formula.sym(" + ").operand(plane.d())
}

pub fn place(at: [f64; 3]) -> Value {
    Value::Formula(Formula::default().place(at))
}

pub fn perpendicular(label: Formula, plane: &Plane, at: [f64; 3], d: f64) -> Vec<Mark3> {
    if d == 0.0 {
        let on = Mark3::new(Role::Signal, Shape3::Dot(at));
        return vec![on.labelled(Value::Formula(label)).strong()];
    }
    let from = DVec3::from(at);
    let unit = DVec3::from(plane.unit_normal());
    let foot = from - unit * d;
    let aside = unit.any_orthonormal_vector();
    let square = [foot, from, foot + aside].map(Into::into);
    vec![
        Mark3::new(Role::Signal, Shape3::Segment([at, foot.into()]))
            .labelled(Value::Formula(label))
            .strong(),
        Mark3::new(Role::Signal, Shape3::RightAngle(square)),
        Mark3::new(Role::Signal, Shape3::Dot(foot.into())),
    ]
}

pub const fn says(class: Containment, line: usize, key: &'static str) -> Row {
    match class {
        Inside => Row::new(Test, line, key).keeps("plane"),
        Straddles => Row::new(Cut, line, key).cuts("plane"),
        Outside => Row::new(Cut, line, key).drops("plane"),
    }
}

/// A row that names the plane beyond which all of something lies: the tests of the planes before it tell that.
pub const fn beyond(row: Row) -> Row {
    let row = row.picks_as("plane", "planes", "option-beyond");
    row.before_its_phase()
}

/// The other answers: all of it lies inside every plane, or some of it.
pub const fn within(row: Row) -> Row {
    row.answers_as("plane", "option-within").before_its_phase()
}

pub const fn across(row: Row) -> Row {
    row.answers_as("plane", "option-across").before_its_phase()
}

#[derive(Default)]
pub struct Asked<'a> {
    pub scenery: Option<&'a Scenery>,
    pub n_planes: usize,
    pub current: Option<Plane>,
    /// What each plane that has been asked says: in the watch table, and of the thing as a whole.
    pub answers: Vec<(Value, Containment)>,
    pub class: Option<Containment>,
    /// In the end the planes are lit that have rejected it.
    pub is_done: bool,
    /// Is the outside taken for the inside?
    pub turns_sign: bool,
}

impl Asked<'_> {
    pub fn current_idx(&self) -> Option<usize> {
        self.current.and(self.answers.len().checked_sub(1))
    }

    fn is_lit(&self, plane_idx: usize) -> bool {
        let class = self.answers.get(plane_idx).map(|(_, class)| *class);
        self.current_idx() == Some(plane_idx) || (self.is_done && class == Some(Outside))
    }

    /// The plane that is lit, if it is one.
    pub fn lit(&self) -> Option<VolumeSide> {
        let mut lit = (0..self.n_planes).filter(|&i| self.is_lit(i));
        let only = lit.next().filter(|_| lit.next().is_none())?;
        VolumeSide::ALL.get(only).copied()
    }

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
            let named = |i| Named::from(plane_name(self.scenery, i)).linked(plane_link(i));
            return planes.map(named).collect();
        }
        let answers = self.answers.iter().enumerate();
        let named = |(i, (answer, _)): (usize, &(Value, Containment))| {
            let answer = Named::from(answer.clone()).labelled(plane_name(self.scenery, i));
            answer.linked(plane_link(i))
        };
        answers.map(named).collect()
    }

    pub fn marks(&self, camera: &Camera, at: [f64; 3], distances: &[f64]) -> Vec<Mark3> {
        let sides = VolumeSide::ALL.into_iter();
        let lit = sides.filter(|&side| self.is_lit(side as usize));
        let mut marks: Vec<Mark3> = lit.flat_map(|side| plane_at_work(camera, side)).collect();
        if let Some(side) = self.lit() {
            let plane = camera.planes_in_world()[side as usize];
            marks.extend(normal_of(camera, side, self.turns_sign));
            let distance = distances[side as usize];
            let label = sym("d").equals(distance);
            marks.extend(perpendicular(label, &plane, at, distance));
        }
        marks
    }

    /// How what a plane says is drawn; none where it has not been asked.
    fn role(&self, plane_idx: usize) -> Option<Role> {
        let (_, class) = self.answers.get(plane_idx)?;
        Some(match class {
            _ if self.is_lit(plane_idx) => Role::Signal,
            Inside | Straddles => Role::Accent,
            Outside => Role::Discarded,
        })
    }

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

    pub fn table(&self, header: Vec<Formula>, cells: impl Fn(usize, Role) -> Vec<Cell>) -> Table {
        let row = |plane_idx: usize| TableRow {
            name: plane_name(self.scenery, plane_idx),
            cells: cells(plane_idx, self.role(plane_idx).unwrap_or(Role::Ink)),
            is_current: self.is_lit(plane_idx),
            link: Some(plane_link(plane_idx)),
        };
        Table {
            header,
            rows: (0..self.n_planes).map(row).collect(),
            notes: Vec::new(),
        }
    }
}

pub const fn fate_of(class: Option<Containment>) -> Fate {
    match class {
        None => Fate::ToCome,
        Some(Inside) => Fate::Kept,
        Some(Straddles) => Fate::Cut,
        Some(Outside) => Fate::Culled,
    }
}

pub fn both(
    scenery: &Scenery,
    fate: Fate,
    of_others: impl Fn(&Object) -> Fate,
    marks: Vec<Mark3>,
) -> [View; 2] {
    let (focus, objects) = (scenery.scene().focus(), scenery.scene().objects());
    let fate = |i: usize| {
        if i == focus {
            fate
        } else {
            of_others(&objects[i])
        }
    };
    [
        scenery.observer(fate, marks),
        scenery.camera(fate, |_, _| FaceLook::Whole, Vec::new()),
    ]
}
