//! Wrong usage, said in the reader's language: what clap finds out, in our sentences.

use std::{error::Error, fmt};

use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::{
    app::Settings,
    text::{Catalog, Diagnostic, Lang, Message, printable},
};

use super::say::{Outcome, not_written, say_text};

/// What a value should have been, where clap does not know it.
#[derive(Clone, Debug)]
pub(super) struct Expected(pub Message);

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Catalog::of(Lang::En).message(&self.0))
    }
}

impl Error for Expected {}

/// Says what is wrong with these arguments: in the language that they ask for, else the system's. Help and the
/// version, which clap hands over in the same way, go to standard output.
pub(super) fn explain(error: &clap::Error, args: &[String]) -> Outcome {
    match diagnostic(error) {
        Some(diagnostic) => {
            let catalog = Catalog::of(lang_of(args).unwrap_or_else(|| Settings::of_system().lang));
            say_text(&rendered(&diagnostic, catalog));
            Outcome::Unusable
        }
        None => match (error.print(), error.exit_code()) {
            (Ok(()), 0) => Outcome::Done,
            (Ok(()), _) => Outcome::Unusable,
            (Err(error), _) => not_written(error, lang_of(args).unwrap_or_default()),
        },
    }
}

/// The value of `--lang`, whatever else is wrong.
fn lang_of(args: &[String]) -> Option<Lang> {
    let at = args.iter().position(|arg| arg.starts_with("--lang"))?;
    let joined = args[at].strip_prefix("--lang=");
    let id = joined.or_else(|| args.get(at + 1).map(String::as_str))?;
    Lang::from_id(id)
}

fn rendered(diagnostic: &Diagnostic, catalog: &Catalog) -> String {
    let mut text = catalog.message(&diagnostic.message);
    for note in &diagnostic.notes {
        text.push('\n');
        text.push_str(&catalog.message(note));
    }
    printable(&text)
}

/// None of what is no mistake, and of the few mistakes for which no command here has an argument.
fn diagnostic(error: &clap::Error) -> Option<Diagnostic> {
    let part = |kind| error.get(kind).map(listed);
    let named = |key, kind| Message::new(key).with("name", part(kind).unwrap_or_default());
    let of_arg = |key| named(key, ContextKind::InvalidArg);
    let value = part(ContextKind::InvalidValue).unwrap_or_default();
    let (message, meant) = match error.kind() {
        ErrorKind::InvalidSubcommand => (
            named("usage-no-such-command", ContextKind::InvalidSubcommand),
            ContextKind::SuggestedSubcommand,
        ),
        ErrorKind::UnknownArgument => (of_arg("usage-no-such-argument"), ContextKind::SuggestedArg),
        ErrorKind::InvalidValue if value.is_empty() => {
            (of_arg("usage-value-missing"), ContextKind::SuggestedValue)
        }
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => {
            let message = of_arg("usage-wrong-value").with("value", value);
            (message, ContextKind::SuggestedValue)
        }
        ErrorKind::MissingRequiredArgument => {
            (of_arg("usage-argument-missing"), ContextKind::SuggestedArg)
        }
        ErrorKind::ArgumentConflict => {
            let other = part(ContextKind::PriorArg).unwrap_or_default();
            let message = of_arg("usage-conflict").with("other", other);
            (message, ContextKind::SuggestedArg)
        }
        _ => return None,
    };
    let known = part(ContextKind::ValidValue).filter(|known| !known.is_empty());
    let expected = error.source().and_then(|source| source.downcast_ref());
    let meant = part(meant).map(|name| Message::new("expect-did-you-mean").with("name", name));
    let notes = known
        .map(|known| Message::new("usage-expected").with("expected", known))
        .into_iter()
        .chain(expected.map(|Expected(message)| message.clone()))
        .chain(meant)
        .chain([Message::new("usage-see-help")]);
    Some(notes.fold(Diagnostic::new(message), Diagnostic::noting))
}

fn listed(value: &ContextValue) -> String {
    match value {
        ContextValue::Strings(all) => all.join(", "),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::{super::Cli, *};

    fn said(lang: Lang, args: &[&str]) -> String {
        let error = Cli::try_parse_from([&["clipscope"], args].concat())
            .err()
            .expect("this is wrong usage");
        let diagnostic = diagnostic(&error).expect("it has a sentence");
        rendered(&diagnostic, Catalog::of(lang))
    }

    #[test]
    fn wrong_usage_is_a_sentence_in_every_language() {
        let export = ["export", "--out", "o"];
        for (args, quoted) in [
            (vec!["exprot"], "exprot"),
            ([&export[..], &["--them", "dark"]].concat(), "--them"),
            ([&export[..], &["--theme", "drak"]].concat(), "drak"),
            ([&export[..], &["--scale", "9000"]].concat(), "9000"),
            ([&export[..], &["--size", "12"]].concat(), "16384"),
            (vec!["export", "--out"], "--out"),
            (vec!["export"], "--out"),
        ] {
            for lang in Lang::ALL {
                let text = said(lang, &args);
                assert!(text.contains(quoted), "{args:?}: {text}");
                let is_foreign = lang != Lang::En && text.contains("Expected");
                assert!(!is_foreign, "{lang:?}, {args:?}: {text}");
            }
        }
        assert!(said(Lang::Es, &["exprot"]).contains("«export»"));
    }

    #[test]
    fn the_language_asked_for_is_spoken_whatever_else_is_wrong() {
        let args = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(lang_of(&args("list --lang es --frmat")), Some(Lang::Es));
        assert_eq!(lang_of(&args("list --lang=zh-CN")), Some(Lang::ZhCn));
        assert_eq!(lang_of(&args("list --lang")), None);
        assert_eq!(lang_of(&args("list")), None);
    }
}
