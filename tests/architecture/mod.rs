//! Holds the house to its plan: who may know whom, and how long a file may grow.

mod imports;
mod windowless;

use std::{
    fs,
    path::{Path, PathBuf},
};

use clipscope::labs::LABS;

/// Modules in reading order: each may use only those before it. The second half needs the `gui` feature.
const PURE: [&str; 10] = [
    "geom", "trace", "algo", "text", "figure", "labs", "input", "lesson", "case", "grade",
];
const GUI: [&str; 6] = ["paint", "widgets", "panels", "export", "app", "cli"];
/// Past this a file usually holds two things.
const MAX_LINES: usize = 400;

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files
}

fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The code of a file without its comments and its tests.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = text.lines().map(|line| match line.trim_start() {
        comment if comment.starts_with("//") => "",
        _ => line,
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn files_of(module: &str) -> Vec<PathBuf> {
    let folder = src().join(module);
    let file = src().join(format!("{module}.rs"));
    if folder.is_dir() {
        let is_test = |file: &PathBuf| {
            file.iter()
                .any(|part| part == "tests" || part == "tests.rs")
        };
        let mut files = rust_files(&folder);
        files.retain(|file| !is_test(file));
        files
    } else if file.is_file() {
        vec![file]
    } else {
        panic!("src/{module} is gone: mend the order in tests/architecture/mod.rs");
    }
}

/// Every module that `code` names as `crate::module` or inside `use crate::{…}`.
fn modules_used(code: &str) -> Vec<&'static str> {
    let all = PURE.iter().chain(&GUI).copied();
    let trees: Vec<&str> = code
        .match_indices("crate::{")
        .map(|(at, open)| {
            let rest = &code[at + open.len()..];
            let mut depth = 1;
            let end = rest.find(|c| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            });
            &rest[..end.unwrap()]
        })
        .collect();
    all.filter(|module| {
        let named = |tree: &str| {
            let mut depth = 0;
            let top: String = tree
                .chars()
                .filter(|&c| {
                    depth += i32::from(c == '{') - i32::from(c == '}');
                    depth == 0
                })
                .collect();
            top.split(',').any(|item| {
                let item = item.trim();
                item == *module || item.starts_with(&format!("{module}::"))
            })
        };
        let path = format!("crate::{module}");
        let direct = code.match_indices(&path).any(|(at, found)| {
            let next = code[at + found.len()..].chars().next();
            !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
        });
        direct || trees.iter().any(|tree| named(tree))
    })
    .collect()
}

#[test]
fn dependencies_run_one_way() {
    let order: Vec<&str> = PURE.iter().chain(&GUI).copied().collect();
    for (i, module) in order.iter().enumerate() {
        for file in files_of(module) {
            for used in modules_used(&code(&file)) {
                let at = order.iter().position(|m| *m == used).unwrap();
                assert!(
                    at <= i,
                    "{} uses crate::{used}, which comes after {module} in the reading order",
                    file.display()
                );
            }
        }
    }
}

#[test]
fn every_module_has_a_place_in_the_order() {
    let lib = fs::read_to_string(src().join("lib.rs")).unwrap();
    let declared: Vec<&str> = lib
        .lines()
        .filter_map(|line| line.trim().strip_prefix("pub mod ")?.strip_suffix(';'))
        .collect();
    let order: Vec<&str> = PURE.iter().chain(&GUI).copied().collect();
    assert_eq!(
        declared, order,
        "src/lib.rs declares the modules in reading order"
    );
}

#[test]
fn the_pure_half_knows_no_window_no_clock_and_no_files() {
    // `lesson::folder` is the one seam to the file system: the command line and the app hand it in.
    let seam = src().join("lesson").join("folder.rs");
    for file in PURE.iter().flat_map(|module| files_of(module)) {
        let code = code(&file);
        let banned = [
            "egui",
            "eframe",
            "std::time",
            "std::thread",
            "std::fs",
            "println!",
        ];
        for word in banned {
            let allowed = file == seam && word == "std::fs";
            assert!(
                allowed || !code.contains(word),
                "{} says `{word}`: that belongs to the half with the window",
                file.display()
            );
        }
    }
}

#[test]
fn algorithms_say_nothing_and_draw_nothing() {
    for file in files_of("algo") {
        let code = code(&file);
        for word in ["format!", "String", "Color", "Message"] {
            assert!(
                !code.contains(word),
                "{} says `{word}`: algorithms only emit events",
                file.display()
            );
        }
    }
}

#[test]
fn what_is_wrong_on_purpose_stays_in_its_room() {
    let words = |file: &Path| -> Vec<String> {
        let code = code(file);
        let parts = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
        parts.map(str::to_owned).collect()
    };
    // Only the lab that shows the mistakes may know them, and the cases that name them in answers.
    let cases = src().join("case");
    for (room, lab) in [
        ("algo/line/faulty.rs", "labs/lines"),
        ("algo/polygon/faulty", "labs/polygons"),
        ("algo/volume/faulty.rs", "labs/frustum"),
        ("algo/cull/faulty.rs", "labs/frustum"),
        ("algo/surface/faulty.rs", "labs/surfaces"),
    ] {
        let [room, lab] = [room, lab].map(|path| src().join(path));
        let is_at_home = |file: &PathBuf| file.starts_with(&room);
        let (own, others): (Vec<_>, Vec<_>) = rust_files(&src()).into_iter().partition(is_at_home);
        let mut mistakes: Vec<String> = Vec::new();
        for file in own {
            let words = words(&file);
            let structs = words
                .windows(3)
                .filter(|w| w[0] == "pub" && w[1] == "struct");
            mistakes.extend(structs.map(|w| w[2].clone()));
        }
        assert!(!mistakes.is_empty(), "{} is empty", room.display());
        for file in others
            .iter()
            .filter(|file| !file.starts_with(&lab) && !file.starts_with(&cases))
        {
            // Nobody reaches them but through that word: they are not passed on.
            let words = words(file);
            let named = words.iter().find(|word| mistakes.contains(word));
            if let Some(word) = named.filter(|_| words.iter().any(|word| word == "faulty")) {
                panic!("{} names {word}, which is wrong on purpose", file.display());
            }
        }
    }
}

#[test]
fn files_are_about_one_thing() {
    for file in rust_files(&src()) {
        let lines = fs::read_to_string(&file).unwrap().lines().count();
        assert!(
            lines <= MAX_LINES,
            "{} has {lines} lines: past {MAX_LINES} a file usually holds two things",
            file.display()
        );
    }
    let main = fs::read_to_string(src().join("main.rs")).unwrap();
    assert!(main.lines().count() < 80, "main.rs only hands over to cli");
}

/// Where a shape, a part or an event that is new must not slip through.
#[test]
fn what_is_shown_of_a_step_names_every_variant() {
    let painters = ["pen", "parts", "layers", "stage", "labels/anchor"];
    let painters = painters.map(|name| src().join(format!("paint/{name}.rs")));
    let is_method = |file: &PathBuf| file.iter().any(|part| part == "methods");
    let methods = files_of("labs").into_iter().filter(is_method);
    for file in methods.chain(painters) {
        assert!(
            !catches_all(&code(&file)),
            "{} has an arm that catches all: a variant added later would be forgotten there",
            file.display()
        );
    }
}

/// Has a `match` an arm that catches all? One over names has to have it: of what is no name nothing is said, and the tests of
/// captions and questions find a name that is missing. Beside a single arm it is an `if let`: the question whether something
/// is of that one kind forgets none.
fn catches_all(code: &str) -> bool {
    let all = code.lines();
    let lines: Vec<&str> = all.filter(|line| !line.trim().is_empty()).collect();
    let depth = |line: &str| line.len() - line.trim_start().len();
    let forgets = |at: usize| {
        let before = lines[..at].iter().rev();
        let within = before.take_while(|line| depth(line) >= depth(lines[at]));
        let arms: Vec<&str> = within
            .filter(|line| depth(line) == depth(lines[at]))
            .map(|line| line.trim_start())
            .filter(|line| !line.starts_with(['}', ']', ')']))
            .collect();
        let is_name = |arm: &&str| arm.trim_start_matches('(').starts_with(['"', '[']);
        arms.len() > 1 && !arms.iter().any(is_name)
    };
    (0..lines.len()).any(|at| lines[at].trim_start().starts_with("_ =>") && forgets(at))
}

#[test]
fn no_files_take_from_each_other() {
    let circles = imports::circles(&imports::House::read());
    assert!(
        circles.is_empty(),
        "these take from each other: {circles:#?}"
    );
}

/// Where a lab is at home: its folder or file in each layer.
fn is_home_of(lab: &str, file: &Path) -> bool {
    ["labs", "lesson/scene_file", "panels", "case"]
        .iter()
        .any(|layer| {
            let home = src().join(layer).join(lab);
            file.starts_with(&home) || file == home.with_extension("rs")
        })
}

/// The tables that a lab joins with one line each.
const TABLES: [&str; 5] = [
    "text/catalog.rs",
    "labs/mod.rs",
    "lesson/scene_file/mod.rs",
    "case/mod.rs",
    "panels/mod.rs",
];

#[test]
fn nothing_but_the_tables_names_a_lab() {
    let tables = TABLES.map(|table| src().join(table));
    for file in rust_files(&src()) {
        let is_test = file
            .iter()
            .any(|part| part == "tests" || part == "tests.rs");
        if tables.contains(&file) || is_test {
            continue;
        }
        let text = code(&file);
        for lab in LABS {
            let id = lab.id;
            if is_home_of(id, &file) {
                continue;
            }
            let is_word = |at: usize| {
                let before = text[..at].chars().next_back();
                !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '.')
            };
            let as_path = text
                .match_indices(&format!("{id}::"))
                .any(|(at, _)| is_word(at));
            // A case may have a field of that name.
            let is_case = ["case", "grade", "input"]
                .iter()
                .any(|room| file.starts_with(src().join(room)));
            let as_word = text.contains(&format!("::{id}"))
                || (!is_case && text.contains(&format!("\"{id}\"")));
            assert!(
                !as_path && !as_word,
                "{} names the lab `{id}`: only its own rooms and the tables may",
                file.display()
            );
        }
    }
}

#[test]
fn every_lab_is_in_every_table() {
    for lab in LABS {
        let id = lab.id;
        // Labs that share a kind of scene share its spelling.
        for layer in ["labs", "panels", "case"] {
            let home = src().join(layer).join(id);
            assert!(
                home.is_dir() || home.with_extension("rs").is_file(),
                "the lab `{id}` has nothing in src/{layer}"
            );
        }
        for table in TABLES {
            let text = code(&src().join(table));
            assert!(
                text.contains(id),
                "src/{table} has no line for the lab `{id}`"
            );
        }
        assert!(!(lab.methods)().is_empty(), "{id} has no methods");
        assert_eq!((lab.first_scene)().document().lab().id, id);
    }
}

/// The packages beside the program are built with `--locked`: their lock files know what the program is made of.
#[test]
fn every_lock_file_knows_what_the_program_needs() {
    let read = |path: &str| {
        let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
        text.parse::<toml::Table>().unwrap()
    };
    let manifest = read("Cargo.toml");
    let targets = manifest["target"].as_table().unwrap().values();
    let of_targets = targets.filter_map(|target| target.get("dependencies"));
    let all = std::iter::once(&manifest["dependencies"]).chain(of_targets);
    let all: Vec<_> = all.flat_map(|table| table.as_table().unwrap()).collect();
    let is_optional = |needed: &toml::Value| needed.get("optional").is_some();
    for (lock, has_window) in [
        ("web", true),
        ("benches", true),
        ("fuzz", false),
        ("tests/wasm", false),
    ] {
        // A registry's copy of the program has not all of them.
        if !src().with_file_name(lock).is_dir() {
            println!("{lock}: not here, not read");
            continue;
        }
        let locked = read(&format!("{lock}/Cargo.lock"));
        let packages = locked["package"].as_array().unwrap();
        let ours = packages
            .iter()
            .find(|it| it["name"].as_str() == Some("clipscope"));
        let known = ours.unwrap()["dependencies"].as_array().unwrap();
        for (name, needed) in &all {
            // Where two versions of one are used, its own follows its name.
            let is_it = |it: &toml::Value| it.as_str().unwrap().split(' ').next() == Some(name);
            assert!(
                is_optional(needed) && !has_window || known.iter().any(is_it),
                "{lock}/Cargo.lock does not know {name}: run `cargo update --workspace` there"
            );
        }
    }
}
