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

macro_rules! ftl {
    ($lang:literal, $area:literal) => {
        include_str!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/assets/messages/",
            $lang,
            "/",
            $area,
            ".ftl"
        ))
    };
}

macro_rules! catalogues {
    ($($area:literal),*) => {
        /// The catalogues' areas: each is one file, `<area>.ftl`, in every language's folder.
        pub const AREAS: [&str; [$($area),*].len()] = [$($area),*];

        /// The Fluent source of one language's catalogue: a text for each of [`AREAS`], in order.
        #[must_use]
        pub const fn sources(lang: Lang) -> [&'static str; AREAS.len()] {
            match lang {
                Lang::En => [$(ftl!("en", $area)),*],
                Lang::ZhCn => [$(ftl!("zh-CN", $area)),*],
                Lang::Es => [$(ftl!("es", $area)),*],
                Lang::PtBr => [$(ftl!("pt-BR", $area)),*],
            }
        }
    };
}

catalogues!(
    "app", "geometry", "lines", "polygons", "lesson", "cli", "errors"
);

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
            let equation = matches!(token, Token::Equals(_) | Token::EqualsRatio { .. });
            if equation && !text.is_empty() && !text.ends_with(' ') {
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

    fn argument(&self, value: &Value) -> FluentValue<'static> {
        match value {
            Value::Count(n) => FluentValue::from(*n),
            other => FluentValue::String(Cow::Owned(self.value(other))),
        }
    }

    /// A value as it stands alone: in a table, beside a mark.
    #[must_use]
    pub fn value(&self, value: &Value) -> String {
        match value {
            Value::Count(n) => n.to_string(),
            Value::Number(x) => self.number(*x),
            Value::Ratio { num, den } => self.ratio(*num, *den),
            Value::Point(p) => self.point(*p),
            Value::Name(name) => name.clone(),
            Value::Term(key) => self.term(key),
            Value::Message(message) => self.message(message),
            Value::Formula(formula) => self.formula(formula),
        }
    }

    /// Above or below the line of a quotient, as it stands in a line of text: in parentheses where it is more
    /// than one thing.
    fn part(&self, formula: &Formula, alone: fn(f64) -> Token) -> String {
        match formula.0[..] {
            [Token::Number(x)] => self.token(&alone(x)).into_owned(),
            [_] => self.formula(formula),
            _ => format!("({})", self.formula(formula)),
        }
    }

    fn token<'a>(&self, token: &'a Token) -> Cow<'a, str> {
        Cow::Owned(match token {
            Token::Sym(symbol) => return Cow::Borrowed(symbol),
            Token::Operand(x) if *x < 0.0 => format!("({})", self.number(*x)),
            Token::Number(x) | Token::Operand(x) => self.number(*x),
            Token::Dividend(x) | Token::Divisor(x) => {
                let shown = self.number(*x);
                let is_negative = matches!(token, Token::Divisor(_)) && *x < 0.0;
                if is_negative || shown.contains('/') {
                    format!("({shown})")
                } else {
                    shown
                }
            }
            Token::Ratio { num, den } => self.ratio(*num, *den),
            Token::Over { num, den } => format!(
                "{} / {}",
                self.part(num, Token::Dividend),
                self.part(den, Token::Divisor)
            ),
            Token::Point(p) => self.point(*p),
            Token::List(numbers) => {
                let shown: Vec<String> = numbers.iter().map(|&x| self.number(x)).collect();
                shown.join(self.lang.list_separator())
            }
            Token::Term(key) => self.term(key),
            Token::EqualsRatio { num, den } => {
                let sign = if number::is_exact_ratio(*num, *den) {
                    '='
                } else {
                    '≈'
                };
                format!("{sign} {}", self.ratio(*num, *den))
            }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Keys that no catalogue has; not literals in the calls, which `tests/messages.rs` checks.
    const MISSING: &str = "no-such-key";

    #[test]
    fn a_sentence_takes_its_values() {
        let step = Message::new("transport-step")
            .with("step", 4_usize)
            .with("total", 6_usize);
        for (lang, expected) in [
            (Lang::En, "step 4 of 6"),
            (Lang::ZhCn, "第 4 步，共 6 步"),
            (Lang::Es, "paso 4 de 6"),
            (Lang::PtBr, "passo 4 de 6"),
        ] {
            assert_eq!(Catalog::of(lang).message(&step), expected);
            assert_eq!(Catalog::of(lang).lang(), lang);
        }
    }

    #[test]
    fn counts_select_the_plural() {
        let steps = |n: usize| Message::new("transport-steps").with("count", n);
        for (lang, one, many) in [
            (Lang::En, "1 step", "2 steps"),
            (Lang::ZhCn, "共 1 步", "共 2 步"),
            (Lang::Es, "1 paso", "2 pasos"),
            (Lang::PtBr, "1 passo", "2 passos"),
        ] {
            assert_eq!(Catalog::of(lang).message(&steps(1)), one);
            assert_eq!(Catalog::of(lang).message(&steps(2)), many);
        }
    }

    #[test]
    fn points_and_words_are_the_reader_s() {
        let handle = Message::new("access-handle")
            .with("name", Value::Term("object-segment"))
            .with("point", [-1.0, 1.5]);
        let said = |lang| Catalog::of(lang).message(&handle);
        assert_eq!(said(Lang::En), "handle of segment at (−1, 1.5)");
        assert_eq!(
            said(Lang::PtBr),
            "ponto de controle de segmento em (−1; 1,5)"
        );
    }

    #[test]
    fn a_formula_shows_its_arithmetic() {
        let t = Formula::default()
            .sym("t = q/p = (")
            .num(-1.0)
            .sym(" − ")
            .operand(-2.0)
            .sym(") / ")
            .operand(4.0)
            .equals(0.25);
        let catalog = Catalog::of(Lang::En);
        assert_eq!(catalog.formula(&t), "t = q/p = (−1 − (−2)) / 4 = 1/4");
        for (num, den, expected) in [
            (0.75, 1.5, "(3/4) / 1.5"),
            (-0.5, 0.25, "(−1/2) / (1/4)"),
            (-1.0, -4.0, "−1 / (−4)"),
        ] {
            let formula = Formula::default().dividend(num).sym(" / ").divisor(den);
            assert_eq!(catalog.formula(&formula), expected);
        }
        let difference = |a, b| Formula::default().num(a).sym(" − ").operand(b);
        let stacked = Formula::default()
            .over(difference(-1.0, -2.0), Formula::default().num(-4.0))
            .sym(", ")
            .over(Formula::default().sym("q"), Formula::default().num(0.75));
        assert_eq!(catalog.formula(&stacked), "(−1 − (−2)) / (−4), q / (3/4)");
        let rounded = Formula::default().sym("sin 22,5° ").equals(0.382_683_432);
        assert_eq!(
            Catalog::of(Lang::Es).formula(&rounded),
            "sin 22,5° ≈ 0,3827"
        );
        let mixed = Formula::default()
            .term("edge-left")
            .sym(": ")
            .ratio(2.0, 8.0)
            .sym(" ")
            .point([1.5, -0.5]);
        assert_eq!(
            Catalog::of(Lang::Es).formula(&mixed),
            "borde izquierdo: 1/4 (1,5; −1/2)"
        );
    }

    #[test]
    fn what_is_missing_is_shown() {
        for lang in Lang::ALL {
            let catalog = Catalog::of(lang);
            assert_eq!(catalog.term(MISSING), "⟦no-such-key⟧");
            let no_total = Message::new("transport-step").with("step", 4_usize);
            assert!(catalog.message(&no_total).contains("⟦$total⟧"), "{lang}");
            // A selector without its value takes the default form, and says so.
            let no_count = Message::new("transport-steps");
            assert!(catalog.message(&no_count).contains("⟦$count⟧"), "{lang}");
        }
    }

    #[test]
    fn braces_in_a_value_are_left_alone() {
        let saved = Message::new("status-saved").with("path", "{odd}.toml".to_owned());
        let said = Catalog::of(Lang::En).message(&saved);
        assert_eq!(said, "Saved to {odd}.toml");
    }

    #[test]
    fn catalogues_are_shared_by_threads() {
        std::thread::scope(|scope| {
            for lang in Lang::ALL {
                scope.spawn(move || assert_eq!(Catalog::of(lang).term("app-title"), "Clipscope"));
            }
        });
    }
}
