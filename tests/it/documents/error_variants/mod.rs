//! Every variant of every public error of the libraries is what some call returns.
//!
//! The variants are read from the sources, and the errors come from calls of the public interface. A variant that is
//! added without such a call fails the test, and so does a variant that nothing can return any more.

mod errors_of_formula_systems;
mod errors_of_formulas;
mod errors_of_integrators;
mod errors_of_lie_poisson;
mod errors_of_open_systems;
mod errors_of_pictures;
mod errors_of_systems;
mod errors_of_tops;

use std::any::type_name;
use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::path::Path;

/// The folders of the library crates.
const LIBRARIES: [&str; 10] = [
    "pictures",
    "scalars",
    "lie-poisson",
    "momentum-map",
    "integrators",
    "isospectral",
    "systems",
    "heavytop",
    "formulas",
    "formula-systems",
];

/// The variants that no call returns, with the reason why they are there.
const UNREACHED: [(&str, &str); 1] = [(
    "StructureTableError::Entries",
    "the reader of tables has refused every other fault of the entries before, but `EntryError`, of another crate, may \
     get more variants",
)];

/// Returns a word of a message that is a Rust path or the name of a type. Users of the program do not read Rust.
fn rust_name(message: &str) -> Option<&str> {
    let words = message.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    let is_type = |word: &str| {
        let letters: Vec<char> = word.chars().collect();
        let humps =
            letters.windows(2).filter(|pair| pair[0].is_lowercase() && pair[1].is_uppercase());
        let plain = ["NumPy", "NaN", "MiB", "GiB", "KiB", "TiB"].contains(&word);
        humps.count() > 0 && !plain && letters.first().is_some_and(|first| first.is_uppercase())
    };
    // A colon may also end a part of a sentence.
    words.map(|word| word.trim_matches(':')).find(|word| word.contains("::") || is_type(word))
}

/// Returns the type and the variant of the error of a call, such as `StepError::NotFinite`.
#[track_caller]
fn refused<T, E: Error>(outcome: Result<T, E>) -> String {
    let kind = type_name::<E>().rsplit("::").next().unwrap_or_default();
    let Err(error) = outcome else { panic!("{kind}: the call succeeded") };
    // A message that panics or is empty helps nobody.
    assert!(!error.to_string().is_empty(), "{error:?}");
    assert_eq!(rust_name(&error.to_string()), None, "{error}");
    let text = format!("{error:?}");
    let end = text.find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len());
    format!("{kind}::{}", &text[..end])
}

/// Returns the variants of the public enums in a Rust source that derive `Error`.
fn variants(text: &str) -> BTreeSet<String> {
    let (mut found, mut derives, mut within) = (BTreeSet::new(), false, None);
    for line in text.lines() {
        if line.starts_with("#[derive(") {
            derives = line.split(|c: char| !c.is_alphanumeric()).any(|name| name == "Error");
        } else if let Some(rest) = line.strip_prefix("pub enum ") {
            within = derives.then(|| identifier(rest));
        } else if line.starts_with("pub ") || line.starts_with('}') {
            (derives, within) = (false, None);
        } else if let (Some(name), Some(variant)) = (within, line.strip_prefix("    ")) {
            // The fields of a variant and long attributes are indented further.
            if variant.starts_with(|c: char| c.is_ascii_uppercase()) {
                found.insert(format!("{name}::{}", identifier(variant)));
            }
        }
    }
    found
}

/// Returns the identifier with which a text begins.
fn identifier(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    &text[..end]
}

/// Adds the variants of all sources below a folder.
fn read(folder: &Path, found: &mut BTreeSet<String>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            read(&path, found)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.extend(variants(&fs::read_to_string(path)?));
        }
    }
    Ok(())
}

#[test]
#[ignore = "long"]
fn every_variant_of_every_error_is_returned() -> Result<(), Box<dyn Error>> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates");
    let mut declared = BTreeSet::new();
    for library in LIBRARIES {
        read(&crates.join(library).join("src"), &mut declared)?;
    }
    let mut returned = BTreeSet::new();
    for errors in [
        errors_of_pictures::errors(),
        errors_of_lie_poisson::errors(),
        errors_of_integrators::steps_and_schemes(),
        errors_of_integrators::runs_and_measurements(),
        errors_of_systems::errors(),
        errors_of_tops::errors(),
        errors_of_formulas::names_and_tables(),
        errors_of_formulas::problems(),
        errors_of_formula_systems::algebras(),
        errors_of_formula_systems::systems_and_states(),
        errors_of_open_systems::errors(),
    ] {
        returned.extend(errors);
    }
    let unreached = BTreeSet::from(UNREACHED.map(|(variant, _)| variant.to_owned()));
    let missing: Vec<_> = declared.difference(&returned).collect();
    assert_eq!(missing, unreached.iter().collect::<Vec<_>>(), "no call returns these");
    // What a call returns is declared: the reader of the sources overlooks none.
    let unknown: Vec<_> = returned.difference(&declared).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    assert!(declared.len() > 130, "{}", declared.len());
    Ok(())
}

/// Negative control: a variant of any form is read from a source, and missed among those that are returned.
#[test]
fn a_planted_variant_is_found() {
    let planted = "/// An error.\n#[derive(Clone, Debug, Error)]\n#[non_exhaustive]\npub enum PlantedError {\n    \
                   /// Text.\n    #[error(\n        \"Long {text}\"\n    )]\n    Fields {\n        /// A field.\n        \
                   text: String,\n    },\n    #[error(transparent)]\n    Tuple(#[from] Other),\n    #[error(\"a\")]\n    \
                   Unit,\n}\n";
    let expected = ["Fields", "Tuple", "Unit"].map(|name| format!("PlantedError::{name}"));
    assert_eq!(variants(planted), BTreeSet::from(expected));
    // Enums that are no errors, or that are private, do not count.
    assert!(variants(&planted.replace(", Error)", ")")).is_empty());
    assert!(variants(&planted.replace("pub enum", "enum")).is_empty());
    assert!(variants(&format!("#[derive(Error)]\npub struct A;\n{}", &planted[45..])).is_empty());
}

/// Negative control: what is returned has the name of its own variant.
#[test]
fn a_variant_has_its_name() {
    use collective_integrators::SchemeError;
    assert_eq!(refused::<(), _>(Err(SchemeError::NoStages)), "SchemeError::NoStages");
    let sum = SchemeError::SubstepSum { sum: 0.5 };
    assert_eq!(refused::<(), _>(Err(sum)), "SchemeError::SubstepSum");
}
