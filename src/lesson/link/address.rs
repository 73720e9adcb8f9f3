//! A link as text.

use std::{fmt, str::FromStr};

use crate::{figure::Moment, geom::Orbit, lesson::exact, text::Lang};

use super::{code, error::LinkError};

/// A longer link is cut by some of the programs that people send it with.
pub const LONG_LINK: usize = 2_000;
/// A longer one is not made.
pub const MOST_LINK: usize = 32_000;
/// The scenes of this version: their format is that of scene files, which only grows.
const VERSION: &str = "v1";

/// What a link opens.
#[derive(Clone, PartialEq, Debug)]
pub enum Opens {
    /// A step of the course as it is.
    Step(StepName),
    /// A scene as a scene file spells it, on the page of a step of the course or on that of a free scene.
    Scene(String, Option<StepName>),
}

/// The ids of a lesson and of one of its steps; without the latter its first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StepName {
    pub lesson: String,
    pub step: Option<String>,
}

impl FromStr for StepName {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let (lesson, step) = match text.split_once('/') {
            Some((lesson, step)) => (lesson, Some(step.to_owned())),
            None => (text, None),
        };
        let is_name = |name: &str| {
            let mut chars = name.chars();
            !name.is_empty() && chars.all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '.'))
        };
        if is_name(lesson) && step.as_deref().is_none_or(is_name) {
            let lesson = lesson.to_owned();
            return Ok(Self { lesson, step });
        }
        Err(())
    }
}

impl fmt::Display for StepName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.lesson)?;
        self.step.iter().try_for_each(|step| write!(f, "/{step}"))
    }
}

/// A link, with what differs from how that opens by itself.
#[derive(Clone, PartialEq, Debug)]
pub struct Link {
    pub opens: Opens,
    /// Where its run stands.
    pub at: Option<Moment>,
    /// The method beside the first, by its id; empty for none.
    pub beside: Option<String>,
    /// From where space is seen.
    pub eye: Option<Orbit>,
    pub lang: Option<Lang>,
    /// The theme, by its id.
    pub theme: Option<String>,
}

impl Link {
    /// One that changes nothing of how this opens by itself.
    pub const fn to(opens: Opens) -> Self {
        Self {
            opens,
            at: None,
            beside: None,
            eye: None,
            lang: None,
            theme: None,
        }
    }

    pub fn to_step(lesson: &str, step: &str) -> Self {
        Self::to(Opens::Step(StepName {
            lesson: lesson.to_owned(),
            step: Some(step.to_owned()),
        }))
    }

    /// As text that is not too long, and can be read again: where a scene's is not, the link to its step of the course.
    pub fn fitting(&self) -> Option<String> {
        let is_read = !matches!(&self.opens, Opens::Scene(text, _) if text.len() > code::MOST_TEXT);
        let text = is_read.then(|| self.to_string());
        if let Some(text) = text.filter(|text| text.len() <= MOST_LINK) {
            return Some(text);
        }
        match &self.opens {
            Opens::Scene(_, Some(step)) => Some(Self::to(Opens::Step(step.clone())).to_string()),
            Opens::Scene(_, None) | Opens::Step(_) => None,
        }
    }

    /// Is this, perhaps with an address before it, written as a link?
    pub fn is_one(text: &str) -> bool {
        let text = text.trim();
        let is_long = text.len() > MOST_LINK && !text.contains(&format!("#{VERSION}="));
        let is_word = !text.contains(char::is_whitespace) && !is_long;
        is_word && !matches!(text.parse::<Self>(), Err(LinkError::Nothing))
    }
}

impl FromStr for Link {
    type Err = LinkError;

    fn from_str(text: &str) -> Result<Self, LinkError> {
        let (_, text) = text.trim().split_once('#').ok_or(LinkError::Nothing)?;
        let mut parts = text.split('&');
        let mut link = Self::to(opened(parts.next().unwrap_or_default())?);
        for part in parts {
            // What a later version says besides means nothing here.
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            let value = code::unescaped(value).ok_or(LinkError::Damaged)?;
            link.take(key, &value)?;
        }
        Ok(link)
    }
}

fn opened(head: &str) -> Result<Opens, LinkError> {
    match head.split_once('=') {
        Some((VERSION, packed)) => Ok(Opens::Scene(code::unpacked(packed)?, None)),
        Some((version, _)) if is_version(version) => Err(LinkError::Version(version.to_owned())),
        Some(_) => Err(LinkError::Nothing),
        None => {
            let name = code::unescaped(head).ok_or(LinkError::Damaged)?;
            name.parse()
                .map(Opens::Step)
                .map_err(|()| LinkError::Nothing)
        }
    }
}

fn is_version(name: &str) -> bool {
    let digits = name.strip_prefix('v').unwrap_or_default();
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

impl Link {
    fn take(&mut self, name: &str, value: &str) -> Result<(), LinkError> {
        let bad = |key| LinkError::Value {
            key,
            value: value.chars().take(80).collect(),
        };
        match name {
            "at" => self.at = Some(moment(value).ok_or_else(|| bad("at"))?),
            "beside" => self.beside = Some(value.to_owned()),
            "eye" => self.eye = Some(eye(value).ok_or_else(|| bad("eye"))?),
            "lang" => self.lang = Some(Lang::from_id(value).ok_or_else(|| bad("lang"))?),
            "theme" => self.theme = Some(value.to_owned()),
            "step" => {
                let of = value.parse().map_err(|()| bad("step"))?;
                if let Opens::Scene(_, step) = &mut self.opens {
                    *step = Some(of);
                }
            }
            _ => {}
        }
        Ok(())
    }
}

/// `interval:2` is what lesson files write as `interval #2`.
fn moment(value: &str) -> Option<Moment> {
    value.replacen(':', "#", 1).parse().ok()
}

fn spelt(moment: &Moment) -> String {
    moment.to_string().replace(" #", ":")
}

/// What an eye looks at, its angles, its distance and its field of view.
fn eye(value: &str) -> Option<Orbit> {
    let numbers = value.split(',').map(|x| x.parse::<f64>().ok());
    let numbers: Option<Vec<f64>> = numbers.map(|x| x.filter(|x| x.is_finite())).collect();
    let [x, y, z, yaw, pitch, distance, fov] = numbers?.try_into().ok()?;
    Some(Orbit::new([x, y, z], [yaw, pitch], distance, fov))
}

/// With as many digits as can be seen.
fn numbers_of(eye: &Orbit) -> String {
    let ([x, y, z], [yaw, pitch]) = (eye.target(), eye.angles_deg());
    let numbers = [x, y, z, yaw, pitch, eye.distance(), eye.fov_y_deg()];
    let rounded = |x: f64| format!("{x:.4e}").parse().unwrap_or(x);
    numbers.map(|x| exact(rounded(x))).join(",")
}

impl fmt::Display for Link {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let step = match &self.opens {
            Opens::Step(step) => {
                write!(f, "#{}", code::escaped(&step.to_string()))?;
                None
            }
            Opens::Scene(text, step) => {
                write!(f, "#{VERSION}={}", code::packed(text))?;
                step.as_ref()
            }
        };
        let values = [
            ("step", step.map(ToString::to_string)),
            ("at", self.at.as_ref().map(spelt)),
            ("beside", self.beside.clone()),
            ("eye", self.eye.as_ref().map(numbers_of)),
            ("lang", self.lang.map(|lang| lang.id().to_owned())),
            ("theme", self.theme.clone()),
        ];
        for (key, value) in values {
            let value = value.map(|value| code::escaped(&value));
            value
                .iter()
                .try_for_each(|value| write!(f, "&{key}={value}"))?;
        }
        Ok(())
    }
}
