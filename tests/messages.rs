//! The message catalogues: whole, alike in all languages, and in step with the code that uses them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use clipscope::text::{AREAS, Catalog, Lang, Message, sources};
use fluent_syntax::ast::{Entry, Resource};
use fluent_syntax::{parser, serializer};

/// How a literal key is handed to the catalogues in `src`.
const CALLS: [&str; 4] = ["Message::new(", "Value::Term(", "Token::Term(", ".term("];

/// A message's variables, by key.
type Keys = BTreeMap<String, BTreeSet<String>>;

#[test]
fn every_catalogue_parses() {
    for (lang, area, source) in texts() {
        if let Err((_, errors)) = parser::parse(source) {
            let places: Vec<_> = errors
                .iter()
                .map(|e| {
                    format!(
                        "line {}: {e}",
                        source[..e.pos.start].matches('\n').count() + 1
                    )
                })
                .collect();
            panic!("assets/messages/{lang}/{area}.ftl: {}", places.join("; "));
        }
    }
}

#[test]
fn no_key_is_defined_twice() {
    for lang in Lang::ALL {
        let mut seen = BTreeMap::new();
        for (area, source) in AREAS.iter().zip(sources(lang)) {
            for (key, _) in messages(source) {
                if let Some(first) = seen.insert(key.clone(), area) {
                    panic!("{lang}: {key} is defined in {first}.ftl and again in {area}.ftl");
                }
            }
        }
    }
}

#[test]
fn every_language_says_what_english_says() {
    let mut faults = Vec::new();
    for (area, english) in AREAS.iter().zip(sources(Lang::En)) {
        let english: Keys = messages(english).into_iter().collect();
        for lang in Lang::ALL {
            let index = AREAS
                .iter()
                .position(|a| a == area)
                .expect("an area of the list");
            let other: Keys = messages(sources(lang)[index]).into_iter().collect();
            let file = format!("{lang}/{area}.ftl");
            for (key, variables) in &english {
                match other.get(key) {
                    None => faults.push(format!("{file} lacks {key}")),
                    Some(found) if found != variables => faults.push(format!(
                        "{file}: {key} uses {found:?}, English {variables:?}"
                    )),
                    Some(_) => {}
                }
            }
            for key in other.keys().filter(|key| !english.contains_key(*key)) {
                faults.push(format!("{file} has {key}, which English lacks"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// In Portuguese `[one]` is said of 0, too: where it spells the number it is `[1]`.
#[test]
fn nothing_is_not_one_in_portuguese() {
    let brazilian = texts().filter(|(lang, ..)| *lang == Lang::PtBr);
    let lines =
        brazilian.flat_map(|(_, area, source)| source.lines().map(move |line| (area, line)));
    let is_spelt = |line: &str| {
        line.split(' ')
            .any(|word| matches!(word, "um" | "uma" | "Um" | "Uma"))
    };
    let wrong: Vec<_> = lines
        .filter(|(_, line)| line.trim_start().starts_with("[one]") && is_spelt(line))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_message_can_be_said() {
    for lang in Lang::ALL {
        for (key, variables) in english() {
            let mut message = Message::new(String::leak(key));
            for name in variables {
                message = message.with(String::leak(name), 2_usize);
            }
            let said = Catalog::of(lang).message(&message);
            assert!(!said.contains('⟦'), "{lang}: {} says {said}", message.key);
            assert_eq!(
                said,
                said.trim(),
                "{lang}: {} has stray spaces",
                message.key
            );
        }
    }
}

#[test]
fn every_file_is_embedded() {
    for lang in Lang::ALL {
        let folder = root().join("assets/messages").join(lang.id());
        let mut files: Vec<String> = fs::read_dir(&folder)
            .expect("each language has a folder")
            .map(|entry| entry.expect("a readable entry").path())
            .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
            .collect();
        files.sort();
        let mut areas = AREAS.map(str::to_owned);
        areas.sort();
        assert_eq!(
            files,
            areas,
            "AREAS lists the files of {}",
            folder.display()
        );
    }
}

#[test]
fn every_key_in_the_code_is_in_the_catalogue() {
    let english = english();
    let mut faults = Vec::new();
    for (path, source) in rust_sources() {
        for key in CALLS.iter().flat_map(|call| literals_after(&source, call)) {
            if !english.contains_key(key) {
                faults.push(format!("{}: no message {key:?}", path.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_checked_key_is_used() {
    let code: String = rust_sources()
        .into_iter()
        .map(|(_, source)| source)
        .collect();
    // Whatever stands between one quotation mark and the next.
    let quoted: BTreeSet<&str> = code.split('"').collect();
    let unused: Vec<_> = english()
        .into_keys()
        .filter(|key| !quoted.contains(&**key))
        .collect();
    assert!(unused.is_empty(), "no code says {}", unused.join(", "));
}

/// The page, which has none of these rooms, leaves `cli.ftl` out.
#[test]
fn the_command_lines_messages_are_said_by_nothing_else() {
    let place = AREAS.iter().position(|area| *area == "cli");
    let keys = messages(sources(Lang::En)[place.expect("an area")]);
    let has_a_page = |path: &Path| {
        let path = path.strip_prefix(root().join("src")).unwrap_or(path);
        !["cli", "case", "grade", "export/graded.rs"]
            .iter()
            .any(|room| path.starts_with(room))
    };
    for (path, source) in rust_sources().iter().filter(|(path, _)| has_a_page(path)) {
        let quoted: BTreeSet<&str> = source.split('"').collect();
        for (key, _) in &keys {
            assert!(!quoted.contains(&**key), "{}: {key}", path.display());
        }
    }
}

#[test]
fn literals_are_found_across_lines_and_not_in_comments() {
    let source = "// f(\"no\")\nf(\n    \"one\",\n);\nf(name); f(\"two\")";
    let code = without_comments(source);
    let found: Vec<_> = literals_after(&code, "f(").collect();
    assert_eq!(found, ["one", "two"]);
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every catalogue file: its language, its area and its text.
fn texts() -> impl Iterator<Item = (Lang, &'static str, &'static str)> {
    Lang::ALL.into_iter().flat_map(|lang| {
        AREAS
            .iter()
            .zip(sources(lang))
            .map(move |(a, s)| (lang, *a, s))
    })
}

fn english() -> Keys {
    sources(Lang::En).into_iter().flat_map(messages).collect()
}

/// The messages of one file with their variables, in order and with repetitions.
pub fn messages(source: &'static str) -> Vec<(String, BTreeSet<String>)> {
    let (Ok(resource) | Err((resource, _))) = parser::parse(source);
    resource
        .body
        .into_iter()
        .filter_map(|entry| {
            let Entry::Message(message) = &entry else {
                return None;
            };
            let key = message.id.name.to_owned();
            let text = serializer::serialize(&Resource { body: vec![entry] });
            Some((key, variables(&text)))
        })
        .collect()
}

/// The names after each `$` of a message.
fn variables(text: &str) -> BTreeSet<String> {
    text.split('$')
        .skip(1)
        .map(|rest| {
            let is_name = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
            rest.chars().take_while(|c| is_name(*c)).collect()
        })
        .collect()
}

/// Every file under `src`, without the lines that are comments.
fn rust_sources() -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    let mut folders = vec![root().join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("src can be read") {
            let path = entry.expect("a readable entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let source = fs::read_to_string(&path).expect("a source file is UTF-8");
                files.push((path, without_comments(&source)));
            }
        }
    }
    files.sort();
    files
}

fn without_comments(source: &str) -> String {
    source
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .flat_map(|line| [line, "\n"])
        .collect()
}

/// The string literals that stand as the first argument of `call`.
fn literals_after<'a>(source: &'a str, call: &'a str) -> impl Iterator<Item = &'a str> {
    source.split(call).skip(1).filter_map(|rest| {
        let literal = rest.trim_start().strip_prefix('"')?;
        literal.split_once('"').map(|(key, _)| key)
    })
}
