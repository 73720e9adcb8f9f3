//! One language's messages, compiled in from `assets/messages`, over Project Fluent.

use std::borrow::Cow;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::resolver::ResolverError;
use fluent_bundle::resolver::errors::ReferenceKind;
use fluent_bundle::{FluentArgs, FluentError, FluentResource, FluentValue};

use super::lang::Lang;
use super::message::{Formula, Message, Token, Value};
use super::number;

/// The catalogues' areas: each is one file, `<area>.ftl`, in every language's folder.
pub const AREAS: [&str; 8] = [
    "app", "geometry", "lines", "polygons", "frustum", "surfaces", "lesson", "cli",
];

macro_rules! embedded {
    ($lang:literal: $($area:literal)*) => {
        [$(include_str!(concat!(
            env!("CARGO_MANIFEST_DIR"), "/assets/messages/", $lang, "/", $area, ".ftl"
        ))),*]
    };
    ($lang:literal) => {
        embedded!($lang: "app" "geometry" "lines" "polygons" "frustum" "surfaces" "lesson" "cli")
    };
}

/// The Fluent source of one language's catalogue, a text for each of [`AREAS`], in their order.
#[must_use]
pub const fn sources(lang: Lang) -> [&'static str; AREAS.len()] {
    match lang {
        Lang::En => embedded!("en"),
        Lang::ZhCn => embedded!("zh-CN"),
        Lang::Es => embedded!("es"),
        Lang::PtBr => embedded!("pt-BR"),
    }
}

/// One language's messages, falling back to English for a missing key.
///
/// Shared by all threads; each language is parsed once, when it is first asked for.
pub struct Catalog {
    lang: Lang,
    bundle: FluentBundle<FluentResource>,
}

impl Catalog {
    /// The catalogue of one language.
    #[must_use]
    pub fn of(lang: Lang) -> &'static Self {
        static CATALOGS: [OnceLock<Catalog>; Lang::ALL.len()] =
            [const { OnceLock::new() }; Lang::ALL.len()];
        CATALOGS[lang as usize].get_or_init(|| Self::parse(lang))
    }

    /// Whether [`number`](Self::number) shows this very number, so that `=` is true of it; where
    /// it shows a rounded one, only `≈` is.
    #[must_use]
    pub fn is_exact(x: f64) -> bool {
        number::is_exact(x)
    }

    /// Which language this is.
    #[must_use]
    pub fn lang(&self) -> Lang {
        self.lang
    }

    /// The sentence, with its values filled in.
    ///
    /// A missing key is shown as `⟦key⟧` and a missing value as `⟦$name⟧`: a fault to see, never a
    /// reason to stop a lecture.
    #[must_use]
    pub fn message(&self, message: &Message) -> String {
        self.resolve(message.key, &message.args)
    }

    /// The sentence or word of a key that takes no values.
    #[must_use]
    pub fn term(&self, key: &str) -> String {
        self.resolve(key, &[])
    }

    /// Arithmetic, with this language's decimal separator and words.
    #[must_use]
    pub fn formula(&self, formula: &Formula) -> String {
        let mut text = String::new();
        for token in &formula.0 {
            if matches!(token, Token::Equals(_)) && !text.is_empty() && !text.ends_with(' ') {
                text.push(' ');
            }
            text.push_str(&self.token(token));
        }
        text
    }

    /// A number as people write it.
    ///
    /// An integer plainly; a fraction where that is exact and short, `3/8` or `5/3`; an exact short
    /// decimal, `1.5`; else four significant digits, `0.3827`, never cutting into the integer part.
    /// Below 10⁻⁴ and from 10⁹ on, `1.234×10⁹`. The minus is U+2212 and zero has no sign.
    #[must_use]
    pub fn number(&self, x: f64) -> String {
        number::number(self.lang, x)
    }

    /// A point in the plane: `(−1, 3/8)`, or `(−1; 1,5)` where the comma is the decimal separator.
    #[must_use]
    pub fn point(&self, [x, y]: [f64; 2]) -> String {
        let separator = self.lang.list_separator();
        format!("({}{separator}{})", self.number(x), self.number(y))
    }

    /// The quotient `num/den`: a reduced fraction where that is exact and short, else a number.
    /// A quotient by zero stays as it is written: `3/0`.
    #[must_use]
    pub fn ratio(&self, num: f64, den: f64) -> String {
        number::ratio(self.lang, num, den)
    }

    fn parse(lang: Lang) -> Self {
        let locale = lang.id().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        bundle.set_use_isolating(false);
        for source in sources(lang) {
            // What does not parse, or is defined twice, is left out here and named by the tests.
            let resource = match FluentResource::try_new(source.to_owned()) {
                Ok(resource) | Err((resource, _)) => resource,
            };
            let _ = bundle.add_resource(resource);
        }
        Self { lang, bundle }
    }

    fn resolve(&self, key: &str, args: &[(&'static str, Value)]) -> String {
        let args: FluentArgs<'_> = args
            .iter()
            .map(|(name, value)| (*name, self.argument(value)))
            .collect();
        self.format(key, &args)
            .or_else(|| Self::of(Lang::En).format(key, &args))
            .unwrap_or_else(|| format!("⟦{key}⟧"))
    }

    /// The message of this language alone; `None` where it has no such key.
    fn format(&self, key: &str, args: &FluentArgs<'_>) -> Option<String> {
        let pattern = self.bundle.get_message(key)?.value()?;
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(args), &mut errors);
        Some(errors.iter().fold(text.into_owned(), show_error))
    }

    /// A value as it stands alone, or in a table.
    #[must_use]
    pub fn value(&self, value: &Value) -> String {
        match value {
            Value::Count(n) => n.to_string(),
            Value::Number(x) => self.number(*x),
            Value::Ratio { num, den } => self.ratio(*num, *den),
            Value::Point(p) => self.point(*p),
            Value::Name(name) => name.clone(),
            Value::Term(key) => self.term(key),
            Value::Formula(formula) => self.formula(formula),
        }
    }

    /// A value inside a sentence: a count keeps its number, which selects the plural.
    fn argument(&self, value: &Value) -> FluentValue<'static> {
        match value {
            Value::Count(n) => FluentValue::from(*n),
            other => FluentValue::String(Cow::Owned(self.value(other))),
        }
    }

    fn token<'a>(&self, token: &'a Token) -> Cow<'a, str> {
        Cow::Owned(match token {
            Token::Sym(symbol) => return Cow::Borrowed(symbol),
            Token::Number(x) => self.number(*x),
            Token::Operand(x) if *x < 0.0 => format!("({})", self.number(*x)),
            Token::Operand(x) => self.number(*x),
            Token::Ratio { num, den } => self.ratio(*num, *den),
            Token::Point(p) => self.point(*p),
            Token::Term(key) => self.term(key),
            Token::Equals(x) if Self::is_exact(*x) => format!("= {}", self.number(*x)),
            Token::Equals(x) => format!("≈ {}", self.number(*x)),
        })
    }
}

/// Makes what Fluent could not resolve visible: in its place where it left one, else at the end.
fn show_error(text: String, error: &FluentError) -> String {
    let what = match error {
        FluentError::ResolverError(ResolverError::Reference(kind)) => match kind {
            ReferenceKind::Variable { id } => format!("${id}"),
            ReferenceKind::Message { id, .. } => id.clone(),
            ReferenceKind::Term { id, .. } => format!("-{id}"),
            ReferenceKind::Function { id } => format!("{id}()"),
        },
        other => other.to_string(),
    };
    let (left, shown) = (format!("{{{what}}}"), format!("⟦{what}⟧"));
    if text.contains(&left) {
        text.replace(&left, &shown)
    } else if text.contains(&shown) {
        text
    } else {
        text + &shown
    }
}
