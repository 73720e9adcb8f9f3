//! Asks runs and scenes for what references name.

use std::{cell::RefCell, collections::BTreeMap, fmt::Write as _, rc::Rc, sync::Arc};

use serde_json::Value as Json;

use crate::{
    figure::{Moment, Run, Words},
    labs::Scene,
    lesson::{SceneFormats, Stop, prelude::*, stop::never_comes},
    text::{Catalog, Formula, Lang, Token, Value},
};

use super::{Expression, Operator, Part, Reference, Root, expression::Function, parse::unreadable};

/// Of a formula what it comes to: a number alone.
const COMES_TO: &str = "value";

/// A lesson's scenes, by name.
pub type Scenes = BTreeMap<String, Arc<Scene>>;

/// The runs that the references of a lesson ask, each recorded once.
pub struct Runs<'a> {
    scenes: &'a Scenes,
    recorded: RefCell<Vec<Rc<Recorded>>>,
}

/// A scene with its runs, in the order of its methods.
struct Recorded {
    scene: Arc<Scene>,
    runs: Vec<(&'static str, Box<dyn Run>)>,
}

/// A place in a run, which names are asked at.
pub struct Place<'a> {
    run: &'a dyn Run,
    step: usize,
    scene: &'a Scene,
}

/// What a name or a path stands for.
enum Found {
    One(Value),
    Many(Vec<Value>),
    Json(Json),
}

impl<'a> Runs<'a> {
    pub const fn new(scenes: &'a Scenes) -> Self {
        let recorded = RefCell::new(Vec::new());
        Self { scenes, recorded }
    }

    /// What a reference in the text of `step` comes to.
    pub fn resolve(&self, reference: &Reference, step: &Stop) -> Result<Value, Diagnostic> {
        let scene = match &reference.scene {
            None => &step.scene,
            Some(name) => self.scenes.get(name).ok_or_else(|| {
                let known = self.scenes.keys().map(String::as_str);
                unknown("problem-unknown-scene", name, &known.collect::<Vec<_>>())
            })?,
        };
        let recorded = self.recorded(scene);
        let runs = recorded.runs.iter().map(|(id, run)| (*id, &**run));
        place(reference, &recorded.scene, runs, &step.moment)?.value(&reference.value)
    }

    /// What can be said at a step: each name with its value, and event, answer, cost and scene as they are.
    pub fn names(&self, step: &Stop, catalog: &Catalog) -> Vec<(String, String)> {
        let recorded = self.recorded(&step.scene);
        let Some((_, run)) = recorded.runs.first() else {
            return Vec::new();
        };
        let position = step.position().unwrap_or_default();
        let mut named = run.shown(position, |shown| {
            let value = |name: &str| Some((name.to_owned(), catalog.value(&shown.named(name)?)));
            let mut named: Vec<_> = shown.names().into_iter().filter_map(value).collect();
            for list in shown.lists() {
                let entries = shown.listed(list).into_iter().enumerate();
                let entries = entries.map(|(i, it)| (format!("{list}[{i}]"), catalog.value(&it)));
                named.extend(entries);
            }
            named
        });
        let roots = [
            ("event", run.event_json(position)),
            ("output", run.output_json()),
            ("cost", json(&run.counts_at(position))),
            ("steps", json(&run.n_steps())),
            ("scene", of_scene(&recorded.scene)),
        ];
        named.extend(roots.map(|(name, json)| (name.to_owned(), json.to_string())));
        named
    }

    fn recorded(&self, scene: &Arc<Scene>) -> Rc<Recorded> {
        let mut all = self.recorded.borrow_mut();
        if let Some(known) = all.iter().find(|known| Arc::ptr_eq(&known.scene, scene)) {
            return Rc::clone(known);
        }
        let recorded = Rc::new(Recorded {
            scene: Arc::clone(scene),
            runs: scene.by_method(scene.document().record()),
        });
        all.push(Rc::clone(&recorded));
        recorded
    }
}

/// Where a reference asks, of a scene and its runs: at its own moment, or else at this one.
pub fn place<'r>(
    reference: &Reference,
    scene: &'r Scene,
    mut runs: impl Iterator<Item = (&'static str, &'r dyn Run)> + Clone,
    moment: &Moment,
) -> Result<Place<'r>, Diagnostic> {
    let known = runs.clone();
    let run = match &reference.method {
        None => runs.next(),
        Some(id) => runs.find(|(known, _)| known == id),
    };
    let (_, run) = run.ok_or_else(|| {
        let known: Vec<&str> = known.map(|(id, _)| id).collect();
        let id = reference.method.as_deref().unwrap_or_default();
        unknown("problem-unknown-method", id, &known)
    })?;
    let moment = reference.at.as_ref().unwrap_or(moment);
    let step = place_of(moment, run)?;
    Ok(Place { run, step, scene })
}

fn place_of(moment: &Moment, run: &dyn Run) -> Result<usize, Diagnostic> {
    run.find(moment).ok_or_else(|| never_comes(moment, run))
}

fn unknown(key: &'static str, name: &str, known: &[&str]) -> Diagnostic {
    let message = Message::new(key).with("name", clipped(name));
    let notes = suggestion(nearest(name, known.iter().copied()), known);
    notes
        .into_iter()
        .fold(Diagnostic::new(message), Diagnostic::noting)
}

fn no_value(name: &str) -> Diagnostic {
    Diagnostic::new(Message::new("problem-no-value").with("name", clipped(name)))
}

impl Place<'_> {
    /// `true` and `false` of an answer, and its null, are words.
    pub fn word(&self, expression: &Expression) -> Option<String> {
        let Expression::Path { root, parts } = expression else {
            return None;
        };
        match self.path(root, parts).ok()? {
            Found::Json(Json::String(word)) => Some(word),
            Found::Json(json @ (Json::Bool(_) | Json::Null)) => Some(json.to_string()),
            Found::One(value) => Some(Catalog::of(Lang::En).value(&value)),
            Found::Json(_) | Found::Many(_) => None,
        }
    }

    pub fn value(&self, expression: &Expression) -> Result<Value, Diagnostic> {
        if let Expression::Path { root, parts } = expression {
            let name = spelt(root, parts);
            return self
                .path(root, parts)?
                .value()
                .ok_or_else(|| no_value(&name));
        }
        let number = self.number(expression)?;
        if number.is_finite() {
            Ok(number.into())
        } else {
            Err(no_value("∞"))
        }
    }

    pub fn number(&self, expression: &Expression) -> Result<f64, Diagnostic> {
        Ok(match expression {
            Expression::Number(x) => *x,
            Expression::Path { root, parts } => {
                let found = self.path(root, parts)?;
                found
                    .number()
                    .ok_or_else(|| no_value(&spelt(root, parts)))?
            }
            Expression::Negated(inner) => 0.0 - self.number(inner)?,
            Expression::Joined(operator, both) => {
                let [a, b] = [self.number(&both[0])?, self.number(&both[1])?];
                match operator {
                    Operator::Plus => a + b,
                    Operator::Minus => a - b,
                    Operator::Times => a * b,
                    Operator::Over => a / b,
                }
            }
            Expression::Call(function, of) => self.call(*function, of)?,
            Expression::Events(wanted) => self.events(wanted) as f64,
        })
    }

    fn events(&self, wanted: &Words) -> usize {
        let mut words = Words::default();
        let fits = |step: &usize| {
            self.run.read_words(*step, &mut words);
            words.include(wanted)
        };
        (1..=self.run.n_steps()).filter(fits).count()
    }

    fn call(&self, function: Function, of: &[Expression]) -> Result<f64, Diagnostic> {
        let number = |i: usize| self.number(of.get(i).ok_or_else(unreadable)?);
        Ok(match function {
            Function::Len => self.list(of)?.len() as f64,
            Function::Count => {
                let wanted = number(1)?;
                let entries = self.list(of)?.into_iter();
                entries.filter(|entry| *entry == Some(wanted)).count() as f64
            }
            Function::Sum => self.list(of)?.into_iter().flatten().sum(),
            Function::Min => self.of_all(of, f64::min)?,
            Function::Max => self.of_all(of, f64::max)?,
            Function::Abs => number(0)?.abs(),
            Function::Sqrt => number(0)?.sqrt(),
            Function::Sin => libm::sin(number(0)?.to_radians()),
            Function::Cos => libm::cos(number(0)?.to_radians()),
            Function::Tan => libm::tan(number(0)?.to_radians()),
            Function::Acos => libm::acos(number(0)?).to_degrees(),
            Function::Atan => libm::atan(number(0)?).to_degrees(),
        })
    }

    fn of_all(&self, of: &[Expression], choose: fn(f64, f64) -> f64) -> Result<f64, Diagnostic> {
        let [first, second, others @ ..] = of else {
            return Err(unreadable());
        };
        let others = [second].into_iter().chain(others).map(|of| self.number(of));
        others.fold(self.number(first), |best, next| Ok(choose(best?, next?)))
    }

    /// The entries of the list that is named first; `None` for those that are no numbers.
    fn list(&self, of: &[Expression]) -> Result<Vec<Option<f64>>, Diagnostic> {
        let [Expression::Path { root, parts }, ..] = of else {
            return Err(unreadable());
        };
        match self.path(root, parts)? {
            Found::Many(entries) => Ok(entries.iter().map(number).collect()),
            Found::Json(Json::Array(entries)) => Ok(entries.iter().map(Json::as_f64).collect()),
            _ => Err(no_value(&spelt(root, parts))),
        }
    }

    fn path(&self, root: &Root, parts: &[Part]) -> Result<Found, Diagnostic> {
        let mut found = match root {
            Root::Event => Found::Json(self.run.event_json(self.step)),
            Root::Output => Found::Json(self.run.output_json()),
            Root::Cost => Found::Json(json(&self.run.counts_at(self.step))),
            Root::Scene => Found::Json(of_scene(self.scene)),
            Root::Steps => Found::One(Value::Count(self.run.n_steps())),
            Root::Differs => {
                let first = self.run.differs_at();
                Found::One(Value::Count(first.ok_or_else(|| no_value("differs"))?))
            }
            Root::Name(name) => self.run.shown(self.step, |shown| {
                if let Some(value) = shown.named(name) {
                    return Ok(Found::One(value));
                }
                if shown.lists().contains(&&**name) {
                    return Ok(Found::Many(shown.listed(name)));
                }
                let names = shown
                    .names()
                    .into_iter()
                    .filter(|name| shown.named(name).is_some());
                let known: Vec<&str> = names.chain(shown.lists()).collect();
                Err(unknown("problem-unknown-name", name, &known))
            })?,
        };
        for (i, part) in parts.iter().enumerate() {
            found = found
                .part(part)
                .ok_or_else(|| no_value(&spelt(root, &parts[..=i])))?;
        }
        Ok(found)
    }
}

fn json(of: &impl serde::Serialize) -> Json {
    serde_json::to_value(of).unwrap_or_default()
}

/// The scene's fields, as files spell them.
fn of_scene(scene: &Scene) -> Json {
    let text = SceneFormats::standard().write(scene, &Moment::Start);
    let table = toml::from_str::<toml::Table>(&text);
    table.map_or(Json::Null, |table| json(&table))
}

/// A path as it was written, for messages.
fn spelt(root: &Root, parts: &[Part]) -> String {
    let mut text = match root {
        Root::Name(name) => name.clone(),
        Root::Event => "event".to_owned(),
        Root::Output => "output".to_owned(),
        Root::Cost => "cost".to_owned(),
        Root::Scene => "scene".to_owned(),
        Root::Steps => "steps".to_owned(),
        Root::Differs => "differs".to_owned(),
    };
    for part in parts {
        let _ = match part {
            Part::Field(name) => write!(text, ".{name}"),
            Part::Entry(i) => write!(text, "[{i}]"),
        };
    }
    text
}

impl Found {
    fn part(self, part: &Part) -> Option<Self> {
        match (self, part) {
            (Self::Many(entries), Part::Entry(i)) => entries.into_iter().nth(*i).map(Self::One),
            (Self::Json(Json::Object(mut fields)), Part::Field(name)) => {
                fields.swap_remove(name).map(Self::Json)
            }
            (Self::Json(Json::Array(entries)), part) => {
                entries.into_iter().nth(index(part)?).map(Self::Json)
            }
            (Self::One(value), Part::Field(name)) if name == COMES_TO => {
                Some(Self::One(number(&value)?.into()))
            }
            (Self::One(value), part) => {
                let coordinates = coordinates(&value)?;
                Some(Self::One(Value::Number(*coordinates.get(index(part)?)?)))
            }
            _ => None,
        }
    }

    fn number(&self) -> Option<f64> {
        match self {
            Self::One(value) => number(value),
            Self::Json(json) => json.as_f64(),
            Self::Many(_) => None,
        }
    }

    /// What can be said in a sentence: a number, a place, a word, a code.
    fn value(self) -> Option<Value> {
        match self {
            Self::One(value) => Some(value),
            Self::Many(_) => None,
            Self::Json(Json::Number(number)) => number.as_f64().map(Value::Number),
            Self::Json(Json::String(word)) => Some(Value::Name(word)),
            Self::Json(Json::Array(entries)) => {
                let numbers: Option<Vec<f64>> = entries.iter().map(Json::as_f64).collect();
                let place = Formula::default().sym("(").list(&numbers?).sym(")");
                Some(Value::Formula(place))
            }
            Self::Json(_) => None,
        }
    }
}

/// Which entry a coordinate or an index is.
fn index(part: &Part) -> Option<usize> {
    match part {
        Part::Entry(i) => Some(*i),
        Part::Field(name) => ["x", "y", "z", "w"].iter().position(|axis| axis == name),
    }
}

fn coordinates(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Point(at) => Some(at.to_vec()),
        Value::Formula(formula) => formula.0.iter().find_map(|token| match token {
            Token::List(numbers) => Some(numbers.clone()),
            Token::Point(at) => Some(at.to_vec()),
            _ => None,
        }),
        _ => None,
    }
}

/// Of a formula what it comes to.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Ratio { num, den } => Some(num / den),
        Value::Count(n) => Some(*n as f64),
        Value::Formula(formula) => formula.0.iter().rev().find_map(|token| match token {
            Token::Number(x) | Token::Operand(x) | Token::Divisor(x) | Token::Equals(x) => Some(*x),
            Token::Ratio { num, den } | Token::EqualsRatio { num, den } => Some(num / den),
            _ => None,
        }),
        _ => None,
    }
}
