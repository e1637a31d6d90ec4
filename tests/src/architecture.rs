//! The imports of a crate, read from its sources.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::{fs, io};

/// The sources of a crate: paths relative to `src`, such as `stages/newton.rs`, and their text.
pub type Sources = BTreeMap<String, String>;

/// Reads all Rust files below a folder.
///
/// # Errors
/// If a folder or a file cannot be read.
pub fn sources(folder: &Path) -> io::Result<Sources> {
    let (mut found, mut folders) = (Sources::new(), vec![folder.to_path_buf()]);
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let name = path.strip_prefix(folder).unwrap_or(&path);
                let name = name.to_string_lossy().replace('\\', "/");
                found.insert(name, fs::read_to_string(&path)?);
            }
        }
    }
    Ok(found)
}

/// Returns for each file the files that it imports.
///
/// Imports are `use` lines and paths that begin with `crate::` or a module of the file, without tests and documentation.
/// An item that a `lib.rs` or `mod.rs` re-exports counts as one of the file that defines it.
pub fn imports(sources: &Sources) -> BTreeMap<&str, BTreeSet<&str>> {
    let crate_of = Crate::new(sources);
    let of = |(file, text): (&'_ String, &String)| -> BTreeSet<&str> {
        let paths = paths(&code(text)).into_iter();
        let targets = paths.filter_map(|path| crate_of.file_of(file, &path));
        targets.filter(|target| target != file && *target != "lib.rs").collect()
    };
    sources.iter().map(|entry| (entry.0.as_str(), of(entry))).collect()
}

/// Returns the imports of items from the root of the crate, which re-exports them: they do not show where the item is.
pub fn imports_from_the_root(sources: &Sources) -> Vec<String> {
    let crate_of = Crate::new(sources);
    let is_exported = |path: &[String]| match path {
        [root, name] => root == "crate" && crate_of.exports.contains_key(&(vec![], name.clone())),
        _ => false,
    };
    let mut found = Vec::new();
    for (file, text) in sources.iter().filter(|(file, _)| *file != "lib.rs") {
        let paths = uses(&code(text), false).into_iter().flat_map(|tree| expand(&tree));
        let from_root = paths.filter(|path| is_exported(path));
        found.extend(from_root.map(|path| format!("{file} imports {}", path.join("::"))));
    }
    found
}

/// Returns the modules that `lib.rs` declares, in its order.
pub fn declared_order(sources: &Sources) -> Vec<&str> {
    let lines = sources.get("lib.rs").map(String::as_str).unwrap_or_default().lines();
    lines.filter_map(declared_module).collect()
}

/// Returns the name in `mod name;` or `pub mod name;`.
fn declared_module(line: &str) -> Option<&str> {
    line.strip_prefix("pub ").unwrap_or(line).strip_prefix("mod ")?.strip_suffix(';')
}

/// Returns the folder of a file, or the name of a file that stands beside `lib.rs`.
pub fn room(file: &str) -> &str {
    file.split_once('/').map_or_else(|| file.trim_end_matches(".rs"), |(room, _)| room)
}

/// Returns a file of each ring of files that import each other, directly or by way of others.
pub fn cycles<'a>(imports: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> Vec<&'a str> {
    let reachable = |from: &'a str| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(file) = open.pop() {
            let next = imports.get(file).into_iter().flatten();
            open.extend(next.filter(|next| seen.insert(**next)));
        }
        seen
    };
    imports.keys().copied().filter(|file| reachable(file).contains(file)).collect()
}

/// The modules and re-exports of a crate, by which a path is followed to a file.
struct Crate<'a> {
    /// The file of each module, by its path such as `["stages", "newton"]`.
    modules: BTreeMap<Vec<String>, &'a str>,
    /// The path that each `pub use` of a module stands for, by module and name.
    exports: BTreeMap<(Vec<String>, String), Vec<String>>,
}

/// Returns the path of a file's module: `stages/newton.rs` is `["stages", "newton"]`, `stages/mod.rs` is
/// `["stages"]`, `lib.rs` is `[]`.
fn module_of(file: &str) -> Vec<String> {
    let name = file.trim_end_matches(".rs");
    let name = name.strip_suffix("/mod").unwrap_or(name);
    if name == "lib" { Vec::new() } else { name.split('/').map(String::from).collect() }
}

impl<'a> Crate<'a> {
    fn new(sources: &'a Sources) -> Self {
        let modules: BTreeMap<_, _> =
            sources.keys().map(|file| (module_of(file), file.as_str())).collect();
        let mut exports = BTreeMap::new();
        for (file, text) in sources {
            let module = module_of(file);
            for path in uses(&code(text), true).into_iter().flat_map(|tree| expand(&tree)) {
                if let Some(name) = path.last() {
                    exports.insert((module.clone(), name.clone()), path.clone());
                }
            }
        }
        Self { modules, exports }
    }

    /// Returns the file that defines the item of a path; `None` outside of the crate.
    fn file_of(&self, from: &str, path: &[String]) -> Option<&'a str> {
        let mut here = module_of(from);
        let mut rest = path;
        match rest.first().map(String::as_str) {
            Some("crate") => here.clear(),
            Some("self") => {}
            Some("super") => {
                here.pop();
            }
            _ if self.modules.contains_key(&extended(&here, rest.first()?)) => {
                return self.follow(here, rest, 0);
            }
            _ => return None,
        }
        rest = &rest[1..];
        while rest.first().is_some_and(|part| part == "super") {
            here.pop();
            rest = &rest[1..];
        }
        self.follow(here, rest, 0)
    }

    fn follow(&self, mut here: Vec<String>, mut rest: &[String], depth: usize) -> Option<&'a str> {
        while let Some(part) = rest.first() {
            let inner = extended(&here, part);
            if !self.modules.contains_key(&inner) {
                break;
            }
            (here, rest) = (inner, &rest[1..]);
        }
        let export = rest.first().and_then(|name| self.exports.get(&(here.clone(), name.clone())));
        match export {
            Some(path) if depth < 8 => {
                let local = path.first().is_some_and(|part| part != "crate");
                let (start, path) =
                    if local { (here, &path[..]) } else { (Vec::new(), &path[1..]) };
                self.follow(start, path, depth + 1)
            }
            _ => self.modules.get(&here).copied(),
        }
    }
}

fn extended(module: &[String], part: &str) -> Vec<String> {
    module.iter().cloned().chain([part.to_owned()]).collect()
}

/// Returns the text without comments, and without the tests at its end.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\n#[allow").next().unwrap_or_default();
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let without = |line: &str| line.split("//").next().unwrap_or_default().to_owned();
    text.lines().map(without).collect::<Vec<_>>().join("\n")
}

/// Returns the trees of `use` lines: of those with `pub`, or of those without.
fn uses(code: &str, public: bool) -> Vec<String> {
    let lines = code.split(';').filter_map(|statement| {
        let (before, tree) = statement.rsplit_once("use ")?;
        let visible = before.trim_end().rsplit('\n').next().unwrap_or_default().trim();
        let exported = visible == "pub" || visible == "pub(crate)";
        let plain = visible.is_empty() || visible.ends_with(']') || visible.ends_with('}');
        (if public { exported } else { plain }).then(|| tree.split_whitespace().collect::<String>())
    });
    lines.collect()
}

/// Returns all paths of a tree such as `crate::{a::B, c}`.
fn expand(tree: &str) -> Vec<Vec<String>> {
    let parts = |path: &str| path.split("::").filter(|p| !p.is_empty()).map(String::from).collect();
    let Some((before, inner)) = tree.split_once('{') else { return vec![parts(tree)] };
    let inner = inner.strip_suffix('}').unwrap_or(inner);
    let (mut branches, mut depth) = (vec![String::new()], 0);
    for character in inner.chars() {
        match character {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                branches.push(String::new());
                continue;
            }
            _ => {}
        }
        branches.last_mut().into_iter().for_each(|branch| branch.push(character));
    }
    let branches = branches.into_iter().filter(|branch| !branch.is_empty());
    branches.flat_map(|branch| expand(&format!("{before}{branch}"))).collect()
}

/// Returns the names of the modules that a file declares.
fn children(code: &str) -> impl Iterator<Item = &str> {
    let names = code.lines().filter_map(|line| line.trim().strip_suffix(';')?.split_once("mod "));
    names.map(|(_, name)| name).filter(|name| name.chars().all(is_of_a_name))
}

fn is_of_a_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Returns the paths of private imports, and those in the code that begin with `crate::` or with a module of the file.
fn paths(code: &str) -> Vec<Vec<String>> {
    let mut found: Vec<_> = uses(code, false).iter().flat_map(|tree| expand(tree)).collect();
    // Re-exports are no imports.
    let statements = code.split(';').filter(|statement| !statement.contains("use "));
    let without_uses: String = statements.collect::<Vec<_>>().join(";");
    let inline = children(code).map(|name| (name, &*without_uses)).chain([("crate", code)]);
    for (root, code) in inline {
        let start = format!("{root}::");
        for (at, _) in code.match_indices(&start) {
            let before = code[..at].chars().next_back();
            if before.is_some_and(|c| is_of_a_name(c) || c == ':') {
                continue;
            }
            let rest = &code[at..];
            let end = rest.find(|c: char| !(is_of_a_name(c) || c == ':'));
            found.extend(expand(&rest[..end.unwrap_or(rest.len())]));
        }
    }
    found
}
