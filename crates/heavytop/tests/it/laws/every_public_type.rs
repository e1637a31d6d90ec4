//! Every public Hamiltonian, map, integrator, splitting and batch of the crate has its suites: the sources of the crate and
//! the tests of this folder name the same ones.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The traits with laws, each with the calls of which a test of a type that implements it must have one.
///
/// The helper `obeys_as_integrator` calls the suites `start` and `invariants`.
const SUITES: [(&str, &[&str]); 8] = [
    ("Hamiltonian", &["hamiltonian::<"]),
    ("PoissonMap", &["poisson_map("]),
    ("Lift", &["lift("]),
    ("FibreSymmetry", &["fibre_symmetry("]),
    ("Integrator", &["laws::start(", "laws::integrator(", "obeys_as_integrator("]),
    ("Start", &["laws::start(", "obeys_as_integrator("]),
    ("ExactFlows", &["obeys_as_flows("]),
    ("BatchIntegrator", &["laws::batch("]),
];

/// Returns the texts of the Rust files below a folder, without comments and without `mod tests`.
fn code_below(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let read = |path: std::path::PathBuf| {
        if path.is_dir() {
            return code_below(&path);
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let text = text.split("#[cfg(test)]").next().unwrap();
        vec![
            text.lines()
                .map(|line| line.split("//").next().unwrap())
                .collect::<Vec<_>>()
                .join("\n"),
        ]
    };
    entries.flat_map(read).collect()
}

/// Returns the words of code.
fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// Returns the trait and the type in the rest of `impl<…> Trait<…> for Type<…> {`.
fn implementation(rest: &str) -> Option<(&str, &str)> {
    let (before, after) = rest.split('{').next()?.split_once(" for ")?;
    // The parameters of the implementation come before the trait, and those of the trait after it.
    let mut depth = 0;
    let end = before.find(|c| {
        depth += i32::from(c == '<') - i32::from(c == '>');
        depth == 0
    })?;
    let name = words(before[end + 1..].split('<').next()?).last()?;
    Some((name, words(after).next()?))
}

/// The traits with laws that each public type implements.
type Types<'a> = BTreeMap<&'a str, BTreeSet<&'a str>>;

/// Returns the types that are named in `exports` and implement a trait with laws.
fn public_types<'a>(exports: &'a str, sources: &'a [String]) -> Types<'a> {
    let public: BTreeSet<&str> = words(exports).collect();
    let mut found = Types::new();
    for code in sources {
        for (name, of) in code.split("\nimpl").skip(1).filter_map(implementation) {
            if public.contains(of) && SUITES.iter().any(|(with_laws, _)| *with_laws == name) {
                found.entry(of).or_default().insert(name);
            }
        }
    }
    found
}

/// Returns the functions of a file, each with the text of the functions that it calls.
fn tests(code: &str) -> Vec<String> {
    let functions: Vec<&str> = code.split("\nfn ").skip(1).collect();
    let name = |text: &'_ str| words(text).next().map(str::len).unwrap_or_default();
    let called = |text: &str, other: &str| words(text).any(|word| word == &other[..name(other)]);
    let with_called = |text: &&str| {
        let others = functions.iter().filter(|other| called(text, other));
        others.copied().collect::<String>() + text
    };
    functions.iter().map(with_called).collect()
}

/// Returns the types and traits for which no test names the type and calls a suite of the trait.
fn without_suite(types: &Types, files: &[String]) -> Vec<String> {
    let tests: Vec<String> = files.iter().flat_map(|code| tests(code)).collect();
    let calls = |of: &str| SUITES.iter().find(|(name, _)| *name == of).unwrap().1;
    let covered = |name: &str, of: &str| {
        tests.iter().any(|code| {
            words(code).any(|word| word == name) && calls(of).iter().any(|call| code.contains(call))
        })
    };
    let pairs = types.iter().flat_map(|(name, traits)| traits.iter().map(move |of| (*name, *of)));
    let missing = pairs.filter(|(name, of)| !covered(name, of));
    missing.map(|(name, of)| format!("{of} for {name}")).collect()
}

#[test]
fn every_public_type_has_the_suites_of_its_traits() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let sources = code_below(&package.join("src"));
    let exports = std::fs::read_to_string(package.join("src/lib.rs")).unwrap();
    let types = public_types(&exports, &sources);
    let folder = std::fs::read_dir(package.join("tests/it/laws")).unwrap();
    let files = folder
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.file_name().unwrap().to_string_lossy().starts_with("laws_of_"));
    let files: Vec<_> = files.map(|path| std::fs::read_to_string(path).unwrap()).collect();
    assert_eq!(without_suite(&types, &files), [""; 0]);
    // Controls: the sources have been read, each trait is found, and without the tests each pair is missing.
    let traits: BTreeSet<&str> = types.values().flatten().copied().collect();
    assert_eq!(traits, SUITES.iter().map(|(name, _)| *name).collect(), "{types:?}");
    let pairs = types.values().map(BTreeSet::len).sum::<usize>();
    assert!(without_suite(&types, &[]).len() == pairs && pairs >= 18, "{types:?}");
}

/// Negative control: a type that the crate might get is found, whatever its parameters, and so is a suite that is called
/// for another type only.
#[test]
fn new_types_without_suites_are_found() {
    let sources = [
        "\nimpl<T: Real, V: Vector<Scalar = T>> Hamiltonian<P, T> for Pendulum<T>\n{\n}\n\
         \nimpl collective_integrators::Integrator for Pendulum {\n}\n\
         \nimpl<H: Hamiltonian<P>, P> Display for Plain<H> {\n}\n"
            .to_owned(),
        "\nimpl BatchIntegrator for Hidden {\n}\n\nimpl Lift for Chart {\n}\n".to_owned(),
    ];
    let types = public_types("pub use a::{Pendulum, Plain, Chart};", &sources);
    assert_eq!(Vec::from_iter(types.keys().copied()), ["Chart", "Pendulum"]);
    let file = "\nfn helper(p: P) {\n    laws::start(p);\n}\n\
        \n#[test]\nfn a() {\n    helper(Pendulum);\n}\n\
        \n#[test]\nfn b() {\n    let (chart, h) = (Chart, hamiltonian::<P>(&h));\n}\n";
    let missing = without_suite(&types, &[file.to_owned()]);
    assert_eq!(missing, ["Lift for Chart", "Hamiltonian for Pendulum"]);
}
