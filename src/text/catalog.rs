//! One language's messages, compiled in from `assets/messages`, over Project Fluent.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::{Arc, LazyLock, OnceLock};

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::resolver::ResolverError;
use fluent_bundle::resolver::errors::ReferenceKind;
use fluent_bundle::{FluentArgs, FluentError, FluentResource, FluentValue};

use super::fetched::Part;
use super::lang::Lang;
use super::message::{Message, Value};
use super::number::{self, Notation};
use super::piece::Piece;

macro_rules! ftl {
    ($lang:literal, $area:tt) => {
        include_str!(concat!("../../assets/messages/", $lang, "/", $area, ".ftl"))
    };
}

/// The page has no command line.
#[cfg(feature = "slim")]
macro_rules! page_ftl {
    ("cli") => {
        ""
    };
    ($area:tt) => {
        ftl!("en", $area)
    };
}

macro_rules! catalogues {
    ($($area:tt),*) => {
        /// The catalogues' areas: each is one file, `<area>.ftl`, in every language's folder.
        pub const AREAS: [&str; [$($area),*].len()] = [$($area),*];

        /// The Fluent source of one language's catalogue: a text for each of [`AREAS`], in order.
        #[cfg(not(feature = "slim"))]
        pub const fn sources(lang: Lang) -> [&'static str; AREAS.len()] {
            match lang {
                Lang::En => [$(ftl!("en", $area)),*],
                Lang::ZhCn => [$(ftl!("zh-CN", $area)),*],
                Lang::Es => [$(ftl!("es", $area)),*],
                Lang::PtBr => [$(ftl!("pt-BR", $area)),*],
            }
        }

        #[cfg(feature = "slim")]
        pub fn sources(lang: Lang) -> [&'static str; AREAS.len()] {
            let of = |name| Part::Texts(lang).get(name).and_then(|it| str::from_utf8(it).ok());
            match lang {
                Lang::En => [$(page_ftl!($area)),*],
                Lang::ZhCn | Lang::Es | Lang::PtBr => [$(of(concat!($area, ".ftl")).unwrap_or_default()),*],
            }
        }
    };
}

catalogues!(
    "app",
    "geometry",
    "lines",
    "polygons",
    "frustum",
    "space-lines",
    "space-triangles",
    "pipeline",
    "surfaces",
    "why",
    "lesson",
    "cli",
    "errors"
);

/// One language's messages, parsed once; English for a missing key.
pub struct Catalog {
    lang: Lang,
    bundle: Arc<FluentBundle<FluentResource>>,
    /// How all numbers are written; those of each message among themselves where it is [`Notation::Own`].
    notation: Notation,
}

impl Catalog {
    pub fn of(lang: Lang) -> &'static Self {
        &Self::in_all_notations(lang)[Notation::Own as usize]
    }

    /// The same messages, with all their numbers written in this way.
    pub fn alike(&self, notation: Notation) -> &'static Self {
        &Self::in_all_notations(self.lang)[notation as usize]
    }

    fn in_all_notations(lang: Lang) -> &'static [Self; Notation::ALL.len()] {
        static CATALOGS: [OnceLock<[Catalog; Notation::ALL.len()]>; Lang::ALL.len()] =
            [const { OnceLock::new() }; Lang::ALL.len()];
        let lang = if Part::Texts(lang).is_here() {
            lang
        } else {
            Lang::En
        };
        CATALOGS[lang as usize].get_or_init(|| {
            let bundle = Arc::new(parsed(lang));
            Notation::ALL.map(|notation| Self {
                lang,
                bundle: Arc::clone(&bundle),
                notation,
            })
        })
    }

    pub fn lang(&self) -> Lang {
        self.lang
    }

    pub(super) const fn notation(&self) -> Notation {
        self.notation
    }

    /// A missing key is shown as `⟦key⟧` and a missing value as `⟦$name⟧`: no reason to stop a lecture.
    pub fn message(&self, message: &Message) -> String {
        Piece::plain(&self.message_pieces(message))
    }

    pub(super) fn message_pieces_as(&self, message: &Message, notation: Notation) -> Vec<Piece> {
        let text = self.resolve(message.key, &message.args);
        let mut pieces = Vec::new();
        let mut rest = &text[..];
        let value_at = |(at, c): (usize, char)| Some((at, c, place(c)?));
        while let Some((at, c, i)) = rest.char_indices().find_map(value_at) {
            let (before, after) = (&rest[..at], &rest[at + c.len_utf8()..]);
            pieces.extend(Piece::words(before));
            let value = match message.args.get(i) {
                Some((_, Value::Message(inner))) => self.message_pieces_as(inner, notation),
                Some((_, value)) => vec![Piece::Kept(self.value_pieces_as(value, notation))],
                None => Vec::new(),
            };
            let [start, end] = self.spaces_around(&value, (before, after));
            pieces.extend(start);
            pieces.extend(value);
            pieces.extend(end);
            rest = after;
        }
        pieces.extend(Piece::words(rest));
        pieces
    }

    /// Chinese keeps Latin letters and digits apart from its characters, also where a value stands beside them.
    fn spaces_around(&self, value: &[Piece], (before, after): (&str, &str)) -> [Option<Piece>; 2] {
        if self.lang != Lang::ZhCn {
            return [None, None];
        }
        let is_han = |c: char| ('\u{4e00}'..='\u{9fff}').contains(&c);
        let value = Piece::plain(value);
        let joints = [
            before.chars().next_back().zip(value.chars().next()),
            value.chars().next_back().zip(after.chars().next()),
        ];
        joints.map(|joint| {
            let (left, right) = joint?;
            let are_words = left.is_alphanumeric() && right.is_alphanumeric();
            (are_words && is_han(left) != is_han(right)).then(|| Piece::Text(" ".to_owned()))
        })
    }

    pub fn term(&self, key: &str) -> String {
        self.resolve(key, &[])
    }

    /// The variables of a message, each once: the same ones in every language, as a test sees to.
    pub fn variables(key: &str) -> &'static [&'static str] {
        static KNOWN: LazyLock<HashMap<&'static str, Vec<&'static str>>> =
            LazyLock::new(|| sources(Lang::En).into_iter().flat_map(variables).collect());
        KNOWN.get(key).map_or(&[], Vec::as_slice)
    }

    fn resolve(&self, key: &str, args: &[(&'static str, Value)]) -> String {
        let args: FluentArgs<'_> = args
            .iter()
            .enumerate()
            .map(|(i, (name, value))| (*name, argument(i, value)))
            .collect();
        self.format(key, &args)
            .or_else(|| Self::of(Lang::En).format(key, &args))
            .unwrap_or_else(|| format!("⟦{key}⟧"))
    }

    fn format(&self, key: &str, args: &FluentArgs<'_>) -> Option<String> {
        let pattern = self.bundle.get_message(key)?.value()?;
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(args), &mut errors);
        Some(errors.iter().fold(text.into_owned(), show_error))
    }
}

fn parsed(lang: Lang) -> FluentBundle<FluentResource> {
    let locale = lang.id().parse().unwrap_or_default();
    let mut bundle = FluentBundle::new_concurrent(vec![locale]);
    bundle.set_use_isolating(false);
    // A function for each language: what it is given tells none.
    bundle.set_formatter(Some(match lang {
        Lang::En => |value, _| large_count(Lang::En, value),
        Lang::ZhCn => |value, _| large_count(Lang::ZhCn, value),
        Lang::Es => |value, _| large_count(Lang::Es, value),
        Lang::PtBr => |value, _| large_count(Lang::PtBr, value),
    }));
    for source in sources(lang) {
        // What does not parse, or is defined twice, is left out here and named by the tests.
        let resource = match FluentResource::try_new(source.to_owned()) {
            Ok(resource) | Err((resource, _)) => resource,
        };
        let _ = bundle.add_resource(resource);
    }
    bundle
}

fn large_count(lang: Lang, value: &FluentValue<'_>) -> Option<String> {
    match value {
        FluentValue::Number(n) if n.value >= number::LARGE_COUNT => {
            Some(number::grouped(lang, n.value))
        }
        _ => None,
    }
}

/// One character of the private use area stands for each value that Fluent need not read: it keeps its parts.
const PLACES: std::ops::Range<u32> = 0xE000..0xE100;

fn variables(source: &'static str) -> Vec<(&'static str, Vec<&'static str>)> {
    let mut messages: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in source.lines().filter(|line| !line.starts_with('#')) {
        if line.starts_with(|c: char| c.is_ascii_lowercase()) {
            messages.push((line.split(' ').next().unwrap_or_default(), Vec::new()));
        }
        let Some((_, names)) = messages.last_mut() else {
            continue;
        };
        for after in line.split('$').skip(1) {
            let end = after.find(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_'));
            let name = &after[..end.unwrap_or(after.len())];
            if !names.contains(&name) {
                names.push(name);
            }
        }
    }
    messages
}

fn argument(i: usize, value: &Value) -> FluentValue<'static> {
    match value {
        Value::Count(n) => FluentValue::from(*n),
        _ => {
            let place = PLACES.clone().nth(i).and_then(char::from_u32);
            FluentValue::String(place.map_or(Cow::Borrowed("⟦…⟧"), |c| Cow::Owned(c.to_string())))
        }
    }
}

fn place(c: char) -> Option<usize> {
    let i = u32::from(c).checked_sub(PLACES.start)?;
    PLACES.contains(&u32::from(c)).then_some(i as usize)
}

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
    fn a_sentence_takes_its_values_and_a_count_selects_the_plural() {
        let step = Message::new("transport-step").with("step", 4_usize);
        let steps = |n: usize| Message::new("transport-steps").with("count", n);
        let step = step.with("total", 6_usize);
        for (lang, expected) in [
            (Lang::En, ["step 4 of 6", "1 step", "2 steps"]),
            (Lang::ZhCn, ["第 4 步，共 6 步", "共 1 步", "共 2 步"]),
            (Lang::Es, ["paso 4 de 6", "1 paso", "2 pasos"]),
            (Lang::PtBr, ["passo 4 de 6", "1 passo", "2 passos"]),
        ] {
            let catalog = Catalog::of(lang);
            let said = [&step, &steps(1), &steps(2)].map(|message| catalog.message(message));
            assert_eq!((said, catalog.lang()), (expected.map(str::to_owned), lang));
        }
    }

    #[test]
    fn the_thousands_of_a_large_count_stand_apart() {
        let step = Message::new("transport-step").with("step", 9_999_usize);
        let step = step.with("total", 200_101_usize);
        for (lang, expected) in [
            (Lang::En, "step 9999 of 200,101"),
            (Lang::ZhCn, "第 9999 步，共 200,101 步"),
            (Lang::Es, "paso 9999 de 200\u{a0}101"),
            (Lang::PtBr, "passo 9999 de 200.101"),
        ] {
            let catalog = Catalog::of(lang);
            assert_eq!(catalog.message(&step), expected);
            let count = catalog.value(&Value::Count(200_101));
            assert!(expected.contains(&count), "{count}");
        }
    }

    #[test]
    fn points_and_words_are_the_reader_s() {
        let handle = Message::new("access-handle")
            .with("name", Value::Term("object-segment"))
            .with("point", [-1.0, 1.5]);
        for (lang, expected) in [
            (Lang::En, "handle of segment at (−1, 1.5)"),
            (Lang::PtBr, "ponto de controle de segmento em (−1; 1,5)"),
        ] {
            assert_eq!(Catalog::of(lang).message(&handle), expected);
        }
    }

    #[test]
    fn chinese_keeps_a_latin_name_apart_and_no_other() {
        let apart = |lang: Lang, name: &str| {
            let spaces = Catalog::of(lang).spaces_around(&Piece::words(name), ("在", "平面，"));
            spaces.map(|space| space.is_some())
        };
        assert_eq!(apart(Lang::ZhCn, "H₁"), [true, true]);
        assert_eq!(apart(Lang::ZhCn, "左"), [false, false]);
        assert_eq!(apart(Lang::En, "H₁"), [false, false]);
        let ends = Catalog::of(Lang::ZhCn).spaces_around(&Piece::words("P"), ("", "。"));
        assert!(ends.iter().all(Option::is_none));
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
