//! The tests and items that the documents name exist: tests in docs/paper.md, docs/clebsch.md, docs/collective.md and
//! docs/audit.md, items in docs/notation.md and in the ledgers.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::Path;
use workspace_tests::architecture::sources;

/// The folders of the tests that the ledgers name. Files of one name in two folders count as one.
const FOLDERS: [&str; 5] = [
    "tests/it",
    "crates/momentum-map/tests/it",
    "crates/integrators/tests/it",
    "crates/isospectral/tests/it",
    "crates/systems/tests/it",
];

/// The ledgers, with a number of tests and of items that each of them surpasses.
const LEDGERS: [(&str, usize, usize); 3] =
    [("docs/paper.md", 80, 60), ("docs/clebsch.md", 15, 12), ("docs/collective.md", 20, 12)];

/// Returns the text of each file of tests, by its name.
fn functions() -> Result<BTreeMap<String, String>, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = BTreeMap::<String, String>::new();
    for folder in FOLDERS {
        for (file, text) in sources(&root.join(folder))? {
            let stem = Path::new(&file).file_stem().unwrap_or_default().to_string_lossy();
            files.entry(stem.into_owned()).or_default().push_str(&text);
        }
    }
    Ok(files)
}

/// Returns whether the text defines the function, also through a macro that is given `name:`.
fn defines(text: &str, name: &str) -> bool {
    text.contains(&format!("fn {name}(")) || text.contains(&format!("    {name}: "))
}

/// Returns whether `cargo test` leaves the function out unless it is asked for.
fn is_left_out(text: &str, name: &str) -> bool {
    let before = text.split_once(&format!("fn {name}(")).map_or("", |(before, _)| before);
    // The attributes of a test stand between it and the item before.
    before.rsplit("\n\n").next().is_some_and(|attributes| attributes.contains("#[ignore"))
}

/// Finds the `file::name` in backquotes of a text, where both are lower case: an item has capitals.
fn named(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let lower = |s: &str| !s.is_empty() && !s.chars().any(|c| c.is_uppercase() || c == ' ');
    let quoted = text.split('`').skip(1).step_by(2);
    quoted.filter_map(|s| s.split_once("::")).filter(move |(file, name)| lower(file) && lower(name))
}

#[test]
fn every_test_named_in_the_ledger_exists() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let files = functions()?;
    let ledgers = LEDGERS.map(|(page, tests, _)| (page, tests));
    for (page, least) in ledgers.into_iter().chain([("docs/audit.md", 4)]) {
        let ledger = fs::read_to_string(root.join(page))?;
        let mut count = 0;
        for (file, name) in named(&ledger).filter(|pair| *pair != ("file", "name")) {
            let found = files.get(file).is_some_and(|text| defines(text, name));
            assert!(found, "{file}::{name} is named in {page} and does not exist");
            count += 1;
        }
        assert!(count > least, "only {count} tests were found in {page}");
    }
    // Negative control: a name that no file defines.
    assert!(!files.values().any(|text| defines(text, concat!("no_such", "_test"))));
    Ok(())
}

/// A newcomer who runs `cargo test` sees each statement of the paper hold.
#[test]
fn no_statement_of_the_paper_is_left_out() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (files, ledger) = (functions()?, fs::read_to_string(root.join("docs/paper.md"))?);
    for (file, name) in named(&ledger) {
        let left_out = files.get(file).is_some_and(|text| is_left_out(text, name));
        assert!(!left_out, "{file}::{name} is a test of the paper and ignored");
    }
    // Negative control: a test that takes minutes is left out.
    let long = files.get("clebsch_runs").ok_or("no tests of long runs")?;
    assert!(is_left_out(long, "long_runs_on_every_algebra_are_right_or_stop"));
    Ok(())
}

/// Every numbered equation and statement has a row.
#[test]
fn every_numbered_statement_has_a_row() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let ledger = fs::read_to_string(root.join("docs/paper.md"))?;
    let equations = [
        "(1.1)", "(1.2)", "(1.3)", "(2.1)", "(2.2)", "(2.3)", "(2.4)", "(2.5)", "(3.1a)", "(3.1b)",
        "(3.2)", "(3.3)", "(4.1)", "(4.2)", "(4.3)", "(4.4a)", "(4.4b)", "(4.5)", "(A.1)", "(A.2)",
        "(B.1)", "(B.2)",
    ];
    let statements = [
        "Remark 2.1",
        "Proposition 2.2",
        "Remark 2.3",
        "Proposition 3.1",
        "Corollary 3.2",
        "Theorem 4.1(i)",
        "Theorem 4.1(ii)",
        "Remark 4.2",
        "Remark 4.3",
        "Figure 1",
        "Figure 2",
    ];
    for number in equations.iter().chain(&statements) {
        assert!(ledger.contains(&format!("\n| {number} |")), "{number} has no row");
    }
    for erratum in 1..=6 {
        assert!(ledger.contains(&format!("\n| {erratum} |")), "erratum {erratum} has no row");
    }
    Ok(())
}

/// Returns the names of all types, traits, constants, functions, and variants without fields.
fn items(text: &str) -> BTreeSet<&str> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let keywords = ["struct", "enum", "trait", "type", "const", "fn"];
    let mut items = BTreeSet::new();
    for line in text.lines() {
        let mut words = line.split(|c| !is_part(c)).filter(|word| !word.is_empty()).peekable();
        while let Some(word) = words.next() {
            items.extend(words.peek().filter(|_| keywords.contains(&word)));
        }
        let variant = line.strip_prefix("    ").and_then(|line| line.strip_suffix(','));
        items.extend(variant.filter(|variant| variant.chars().all(is_part)));
    }
    items
}

#[test]
fn every_item_named_in_the_notation_and_the_ledger_exists() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut text = String::new();
    for layer in [
        "scalars",
        "lie-poisson",
        "formulas",
        "momentum-map",
        "integrators",
        "isospectral",
        "systems",
        "heavytop",
        "formula-systems",
    ] {
        text.extend(sources(&root.join("crates").join(layer).join("src"))?.into_values());
    }
    text.extend(sources(&root.join("tests/src"))?.into_values());
    let items_of_code = items(&text);
    let foreign = ["Complex", "SMatrix", "Vector2", "Vector3", "f64", "for"];
    let ledgers = LEDGERS.map(|(page, _, items)| (page, items));
    for (page, least) in ledgers.into_iter().chain([("docs/notation.md", 150)]) {
        let page_text = fs::read_to_string(root.join(page))?;
        let quoted = page_text.split('`').skip(1).step_by(2);
        // In the ledgers only names with a capital are items: the others are tests and commands.
        let notation = page == "docs/notation.md";
        let items = quoted.filter(|s| notation || s.contains(char::is_uppercase));
        let words = items.flat_map(|s| s.split(|c: char| !c.is_alphanumeric() && c != '_'));
        // One letter is a parameter, and a digit the value of one.
        let names = words.filter(|w| w.len() > 1 && w.is_ascii() && !foreign.contains(w));
        let mut count = 0;
        for name in names {
            assert!(items_of_code.contains(name), "{name} is named in {page} and does not exist");
            count += 1;
        }
        assert!(count > least, "only {count} items were found in {page}");
    }
    // Negative control: a name of which another is the beginning, in both directions.
    assert!(items_of_code.contains("SpinorMotions") && !items_of_code.contains("SpinorMotion"));
    assert!(!items_of_code.contains("SpinorMotionsOfC2"));
    Ok(())
}
