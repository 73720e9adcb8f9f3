//! Which file takes what from which: `use` trees and paths, followed through re-exports to the file that holds the item.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
};

use super::{code, rust_files, src};

/// A file as a module: `["labs", "lines", "scene"]`.
type Module = Vec<String>;

/// Every module of `src`, and how its names lead on.
pub struct House {
    files: BTreeMap<Module, PathBuf>,
    /// In a module, a name that is another module's: the path that it stands for.
    reexports: BTreeMap<(Module, String), Module>,
}

/// A path of a `use` statement, and whether it is passed on (`pub use`).
struct Use {
    path: Vec<String>,
    is_passed_on: bool,
}

impl House {
    pub fn read() -> Self {
        let mut files = BTreeMap::new();
        for file in rust_files(&src()) {
            files.insert(module_of(&file), file);
        }
        let mut house = Self {
            files,
            reexports: BTreeMap::new(),
        };
        for (module, file) in house.files.clone() {
            if file.ends_with("mod.rs") || has_children(&house, &module) {
                for Use { path, .. } in uses(&code(&file)) {
                    let Some(target) = house.absolute(&module, &path) else {
                        continue;
                    };
                    let name = path.last().cloned().unwrap_or_default();
                    house.reexports.insert((module.clone(), name), target);
                }
            }
        }
        house
    }

    /// The files that a file takes something from, itself left out.
    pub fn taken_from(&self, module: &Module) -> BTreeSet<Module> {
        let file = &self.files[module];
        let text = code(file);
        let own = uses(&text).into_iter();
        let passes_on = |item: &Use| item.is_passed_on && file.ends_with("mod.rs");
        let mut paths: Vec<Vec<String>> = own
            .filter(|item| !passes_on(item))
            .map(|item| item.path)
            .collect();
        paths.extend(inline_paths(&text));
        let found = paths
            .iter()
            .filter_map(|path| self.absolute(module, path))
            .map(|path| self.holder(&path));
        found.filter(|holder| holder != module).collect()
    }

    pub fn modules(&self) -> impl Iterator<Item = &Module> {
        self.files.keys()
    }

    /// A path from the crate's root, where it is one of this crate.
    fn absolute(&self, from: &Module, path: &[String]) -> Option<Module> {
        let mut base = match path.first()?.as_str() {
            "crate" => Module::new(),
            "super" => from[..from.len().saturating_sub(1)].to_vec(),
            "self" => from.clone(),
            name => {
                let mut child = from.clone();
                child.push(name.to_owned());
                if !self.files.contains_key(&child) {
                    return None;
                }
                child
            }
        };
        for segment in &path[1..] {
            if segment == "super" {
                base.pop();
            } else if segment != "self" {
                base.push(segment.clone());
            }
        }
        Some(base)
    }

    /// The file that holds what a path names, re-exports followed.
    fn holder(&self, path: &Module) -> Module {
        let mut path = path.clone();
        // A chain of re-exports is no longer than the house is deep.
        for _ in 0..8 {
            let known = (0..=path.len())
                .rev()
                .find(|&n| self.files.contains_key(&path[..n]));
            let n = known.unwrap_or(0);
            let Some(name) = path.get(n) else {
                break;
            };
            let Some(target) = self.reexports.get(&(path[..n].to_vec(), name.clone())) else {
                path.truncate(n);
                break;
            };
            let mut next = target.clone();
            next.extend(path[n + 1..].iter().cloned());
            if next == path {
                break;
            }
            path = next;
        }
        let n = (0..=path.len())
            .rev()
            .find(|&n| self.files.contains_key(&path[..n]));
        path[..n.unwrap_or(0)].to_vec()
    }
}

fn has_children(house: &House, module: &Module) -> bool {
    let is_child = |other: &&Module| other.len() > module.len() && other.starts_with(module);
    house.files.keys().any(|other| is_child(&other))
}

fn module_of(file: &Path) -> Module {
    let relative = file.strip_prefix(src()).unwrap().with_extension("");
    let mut module: Module = relative
        .iter()
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    if matches!(module.last().map(String::as_str), Some("mod" | "lib")) {
        module.pop();
    }
    module
}

/// Every path of every `use` statement.
fn uses(code: &str) -> Vec<Use> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("use ") {
        let before = code[..at].rsplit('\n').next().unwrap_or_default().trim();
        if !(before.is_empty() || before.starts_with("pub")) {
            continue;
        }
        let tree = code[at + 4..].split(';').next().unwrap_or_default();
        let mut paths = Vec::new();
        walk(tree, &[], &mut paths);
        found.extend(paths.into_iter().map(|path| Use {
            path,
            is_passed_on: before.starts_with("pub"),
        }));
    }
    found
}

/// The leaves of a `use` tree; of `a as b` the `a`.
fn walk(tree: &str, before: &[String], out: &mut Vec<Vec<String>>) {
    let tree = tree.trim();
    let (head, rest) = match tree.find('{') {
        Some(open) if tree.ends_with('}') => (&tree[..open], Some(&tree[open + 1..tree.len() - 1])),
        _ => (tree, None),
    };
    let head = head.split(" as ").next().unwrap_or_default();
    let mut path = before.to_vec();
    path.extend(
        head.split("::")
            .map(str::trim)
            .filter(|part| !part.is_empty())
            .map(str::to_owned),
    );
    let Some(rest) = rest else {
        out.push(path);
        return;
    };
    let (mut depth, mut start) = (0, 0);
    for (i, c) in rest.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !rest[start..i].trim().is_empty() {
                    walk(&rest[start..i], &path, out);
                }
                start = i + 1;
            }
            _ => {}
        }
    }
    if !rest[start..].trim().is_empty() {
        walk(&rest[start..], &path, out);
    }
}

/// Paths in the code itself that begin at the root or one room up.
fn inline_paths(code: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    for root in ["crate::", "super::"] {
        for (at, _) in code.match_indices(root) {
            let is_part = code[..at].ends_with(|c: char| c.is_alphanumeric() || "_:".contains(c));
            let line = code[..at].rsplit('\n').next().unwrap_or_default();
            if is_part || line.trim_start().starts_with("use ") || line.contains("pub(in") {
                continue;
            }
            let end = code[at..].find(|c: char| !(c.is_alphanumeric() || "_:".contains(c)));
            let path = &code[at..at + end.unwrap_or(code.len() - at)];
            let parts = path.split("::").filter(|part| !part.is_empty());
            found.push(parts.map(str::to_owned).collect());
        }
    }
    found
}

/// Files that take from each other, directly or in a ring: each ring once.
pub fn circles(house: &House) -> Vec<Vec<String>> {
    let arrows: BTreeMap<&Module, BTreeSet<Module>> = house
        .modules()
        .map(|module| (module, house.taken_from(module)))
        .collect();
    let reaches = |from: &Module| {
        let mut seen = BTreeSet::new();
        let mut waiting = vec![from.clone()];
        while let Some(module) = waiting.pop() {
            for next in arrows.get(&module).into_iter().flatten() {
                if seen.insert(next.clone()) {
                    waiting.push(next.clone());
                }
            }
        }
        seen
    };
    let reach: BTreeMap<&Module, BTreeSet<Module>> = arrows
        .keys()
        .map(|&module| (module, reaches(module)))
        .collect();
    let mut rings: BTreeSet<Vec<String>> = BTreeSet::new();
    for (&module, reached) in &reach {
        if reached.contains(module) {
            let ring = reached
                .iter()
                .filter(|&other| reach.get(other).is_some_and(|back| back.contains(module)));
            rings.insert(ring.map(|module| module.join("/")).collect());
        }
    }
    rings.into_iter().collect()
}
