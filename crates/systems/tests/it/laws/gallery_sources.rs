//! The systems of the gallery and their law suites, as the sources and the tests of the crate name them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The traits with laws. A public type that implements one of them needs a test.
const TRAITS: [&str; 19] = [
    "BatchIntegrator",
    "Casimirs",
    "Energy",
    "ExactFlows",
    "FibreSymmetry",
    "GroupAction",
    "Hamiltonian",
    "Integrator",
    "IsospectralField",
    "LieAlgebra",
    "LieGroup",
    "Lift",
    "Multipliers",
    "PoissonMap",
    "PoissonSpace",
    "Representation",
    "Scheme",
    "SitesHamiltonian",
    "VectorField",
];

/// Returns the Rust files below a folder, by their paths from there, without comments and without `mod tests`.
pub fn code_below(folder: &Path) -> BTreeMap<String, String> {
    let (mut found, mut folders) = (BTreeMap::new(), vec![folder.to_path_buf()]);
    while let Some(next) = folders.pop() {
        for path in std::fs::read_dir(next).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let name = path.strip_prefix(folder).unwrap().to_string_lossy().replace('\\', "/");
                found.insert(name, without_comments(&std::fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found
}

fn without_comments(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().unwrap();
    text.lines().map(|line| line.split("//").next().unwrap()).collect::<Vec<_>>().join("\n")
}

/// Returns the words of code.
pub fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// Returns the types that `lib.rs` exports and that implement a trait with laws, and the names of such types.
pub fn systems(sources: &BTreeMap<String, String>) -> BTreeSet<String> {
    let public: BTreeSet<&str> = words(&sources["lib.rs"]).collect();
    let found = sources.values().flat_map(|code| {
        let implementors = code.split("\nimpl").skip(1).filter_map(implementor);
        let energies = code
            .split("energy!(")
            .skip(1)
            .filter_map(|rest| words(rest).find(|word| *word != "pub"));
        implementors.chain(code.split("\npub type ").skip(1).filter_map(space)).chain(energies)
    });
    found.filter(|name| public.contains(name)).map(String::from).collect()
}

/// Returns the type in the rest of `impl<…> Trait<…> for Type<…> {`, if the trait has laws.
fn implementor(rest: &str) -> Option<&str> {
    let header = rest.split('{').next()?;
    let (before, after) = header.split_once(" for ")?;
    let mut depth = 0;
    let generics = before.find(|c| {
        depth += i32::from(c == '<') - i32::from(c == '>');
        depth == 0
    })?;
    // The name of the trait is the last word before its own parameters.
    let path = before[generics + 1..].split('<').next()?;
    let of_laws = words(path).last().is_some_and(|name| TRAITS.contains(&name));
    words(after).next().filter(|_| of_laws)
}

/// Returns the name in the rest of `pub type Name<…> = Target<…>;`, if the target is an algebra or a space.
fn space(rest: &str) -> Option<&str> {
    let (name, target) = rest.split_once('=')?;
    let target = words(target).next()?;
    let is_space = ["Algebra", "Space", "Poisson"].iter().any(|ending| target.ends_with(ending));
    words(name).next().filter(|_| is_space)
}

/// Returns the functions and constants at the top level of a file, with their text.
pub fn items(code: &str) -> BTreeMap<&str, &str> {
    let starts = ["\nfn ", "\npub fn ", "\nconst ", "\npub const "];
    let mut found = BTreeMap::new();
    for start in starts {
        for (at, _) in code.match_indices(start) {
            let rest = &code[at + start.len()..];
            let end = if start.contains("fn ") { "\n}" } else { ";\n" };
            let text = &rest[..rest.find(end).unwrap_or(rest.len())];
            found.insert(words(text).next().unwrap(), text);
        }
    }
    found
}

/// Returns the text of an item, with that of all items which it uses.
pub fn with_uses(items: &BTreeMap<&str, &str>, item: &str) -> String {
    let (mut seen, mut open) = (BTreeSet::new(), vec![item]);
    while let Some((&name, text)) = open.pop().and_then(|name| items.get_key_value(name)) {
        if seen.insert(name) {
            open.extend(words(text).filter(|word| items.contains_key(word)));
        }
    }
    seen.iter().map(|name| format!("{}\n", items[name])).collect()
}

/// Returns the name of a type as a function has it: `so21` for `So21`, and `kida_vortex` for `KidaVortex`.
pub fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}
