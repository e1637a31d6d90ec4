//! Every system of the gallery has its suites: the sources of the crate, the tests of this folder and the table of
//! `docs/testing.md` name the same ones.
//!
//! The tests of a system begin with its name, as `kida_vortex_laws` for `KidaVortex`, and call the suites.

use super::gallery_sources::{code_below, items, snake_case, systems, with_uses, words};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The suites, in the order of the table.
const SUITES: [&str; 13] = [
    "lie_algebra",
    "casimirs",
    "poisson_space",
    "hamiltonian",
    "sites_hamiltonian",
    "differences",
    "sites_field",
    "generator",
    "poisson_map",
    "lift",
    "start",
    "integrator",
    "invariants",
];

/// Returns whether code calls a suite, by its name or as `laws::name`, and not a method or function of that name.
fn calls(code: &str, suite: &str) -> bool {
    code.match_indices(suite).any(|(at, _)| {
        let (before, after) = (&code[..at], &code[at + suite.len()..]);
        let called = after.starts_with('(') || after.starts_with("::<");
        let inside = |c: char| c.is_alphanumeric() || c == '_' || c == '.' || c == ':';
        called && (before.ends_with("laws::") || !before.ends_with(inside))
    })
}

/// The code of the tests of each system, with all that they use.
type Tests = BTreeMap<String, String>;

/// Returns the tests of each system in the files of this folder.
fn tests(systems: &BTreeSet<String>, files: &BTreeMap<String, String>) -> Tests {
    let mut found = Tests::new();
    for code in files.iter().filter(|(file, _)| file.ends_with("_laws.rs")).map(|(_, code)| code) {
        let items = items(code);
        for test in code.split("#[test]\nfn ").skip(1).filter_map(|rest| words(rest).next()) {
            let named = systems.iter().filter(|name| test.starts_with(&(snake_case(name) + "_")));
            let Some(system) = named.max_by_key(|name| name.len()) else { continue };
            found.entry(system.clone()).or_default().push_str(&with_uses(&items, test));
        }
    }
    found
}

/// Returns the systems without a test, or whose tests do not name them, call no suite or have no control.
fn without_suites(systems: &BTreeSet<String>, tests: &Tests) -> Vec<String> {
    let covered = |code: &String, name: &str| {
        let named = words(code).any(|word| word == name);
        named && calls(code, "obeys") && SUITES.iter().any(|suite| calls(code, suite))
    };
    let missing = |name: &&String| !tests.get(*name).is_some_and(|code| covered(code, name));
    systems.iter().filter(missing).cloned().collect()
}

fn gallery() -> (BTreeSet<String>, Tests) {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let systems = systems(&code_below(&package.join("src")));
    let tests = tests(&systems, &code_below(&package.join("tests/it/laws")));
    (systems, tests)
}

#[test]
fn every_public_system_has_its_law_suites() {
    let (systems, tests) = gallery();
    assert_eq!(without_suites(&systems, &tests), [""; 0]);
    // Control: the sources have been read.
    assert!(systems.contains("Gyrostat") && systems.contains("SpinSpace"), "{systems:?}");
    // Control: a private type and a type without laws are not systems.
    assert!(!systems.contains("SlabSweep") && !systems.contains("SystemError"), "{systems:?}");
}

/// Negative control: systems that the crate might get are found, whatever their traits.
#[test]
fn new_systems_without_suites_are_found() {
    let new = [
        ("lib.rs", "pub use a::{Pendulum, Pair, Box, Space, Plain};\npub use b::Tops;\n"),
        (
            "a.rs",
            "\nimpl<T: Real, V: Vector<Scalar = T>> SitesHamiltonian<V> for Pendulum<T>\n{\n}\n\
             \nimpl collective_integrators::Integrator for Pair {\n}\n\
             \nimpl<H: Hamiltonian<P>, P> Display for Plain<H> {\n}\n\
             \nimpl LieAlgebra for Hidden {\n}\n\
             \npub type Space<const N: usize> = LiePoisson<PowerAlgebra<So3, N>>;\n",
        ),
        ("b.rs", "\nenergy!(pub Tops {} on LiePoisson<So3>: |top, mu| mu.x);\n"),
    ];
    let new = new.map(|(file, code)| (file.to_owned(), code.to_owned())).into();
    let systems = systems(&new);
    assert_eq!(Vec::from_iter(&systems), ["Pair", "Pendulum", "Space", "Tops"]);
    let file = "\n#[test]\nfn pair_laws() {\n    helper(Pair);\n}\n\
        \nfn helper(pair: Pair) {\n    obeys(pair, 0, 1.0, |i| laws::integrator(i, &[], 1.0));\n}\n\
        \n#[test]\nfn pendulum_laws() {\n    obeys(Pendulum, 0, 1.0, |_| x.start());\n}\n\
        \n#[test]\nfn tops_laws() {\n    holds(Tops, 1.0, |h| hamiltonian(h, &[]));\n}\n";
    let tests = tests(&systems, &[("a_laws.rs".to_owned(), file.to_owned())].into());
    assert_eq!(without_suites(&systems, &tests), ["Pendulum", "Space", "Tops"]);
}

/// Returns the rows of the table, each with the system, its suites and its sizes.
fn table(page: &str) -> Vec<[&str; 3]> {
    let (_, rest) = page.split_once("<!-- law suites: begin -->\n").unwrap();
    let (rows, _) = rest.split_once("<!-- law suites: end -->").unwrap();
    rows.lines()
        .skip(2)
        .map(|row| {
            let cells: Vec<_> = row.trim_matches('|').split('|').map(str::trim).collect();
            cells.try_into().unwrap()
        })
        .collect()
}

/// Returns what a table of suites states otherwise than the tests.
fn wrong_rows(page: &str, tests: &Tests) -> Vec<String> {
    let suites = |code: &str| -> Vec<_> {
        SUITES.iter().filter(|suite| calls(code, suite)).map(|suite| format!("`{suite}`")).collect()
    };
    let expected = tests.iter().map(|(name, code)| (format!("`{name}`"), suites(code).join(", ")));
    let mut expected: BTreeMap<_, _> = expected.collect();
    let mut wrong = Vec::new();
    for [name, suites, sizes] in table(page) {
        if expected.remove(name).is_none_or(|expected| expected != suites) {
            wrong.push(format!("| {name} | {suites} |"));
        }
        let code = tests.get(name.trim_matches('`')).map(String::as_str).unwrap_or_default();
        let numbers = words(sizes).filter(|word| word.chars().all(|c| c.is_ascii_digit()));
        let unknown = numbers.filter(|number| !words(code).any(|word| word == *number));
        wrong.extend(unknown.map(|number| format!("{name}: {number}")));
    }
    wrong.extend(expected.iter().map(|(name, suites)| format!("missing: | {name} | {suites} |")));
    wrong
}

#[test]
fn the_table_of_law_suites_is_that_of_the_tests() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/testing.md");
    let (page, (_, tests)) = (std::fs::read_to_string(path).unwrap(), gallery());
    assert_eq!(wrong_rows(&page, &tests), [""; 0]);
    // Controls: a suite that is not called, a number that is none of the sizes, and a row that is missing.
    let changes = [
        ("| `KidaVortex` | `hamiltonian`", "| `KidaVortex` | `lift`"),
        ("1, 2, 3, 40", "1, 2, 3, 41"),
        ("| `Zeitlin`", "| `Euler`"),
    ];
    for (from, to) in changes {
        assert!(page.contains(from), "{from}");
        assert!(!wrong_rows(&page.replace(from, to), &tests).is_empty(), "{to}");
    }
}
